"""Run a command; print its wall and processor time [s] and its peak memory [MB].

A process of its own, small and loading nothing: the peak that a system counts for a
child is at least the memory of whoever starts it.
"""

from __future__ import annotations

import os
import subprocess
import sys
import time


def main() -> int:
    """Run the command given as arguments and print three numbers."""
    began = time.perf_counter()
    process = subprocess.Popen(sys.argv[1:], stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    seconds = time.perf_counter() - began
    unit = 1e-6 if sys.platform == "darwin" else 1024e-6  # bytes, or kilobytes
    busy = usage.ru_utime + usage.ru_stime
    sys.stdout.write(f"{seconds} {busy} {usage.ru_maxrss * unit}\n")
    return os.waitstatus_to_exitcode(status)


if __name__ == "__main__":
    sys.exit(main())
