"""What would happen if? Run-downs and sweeps of a case as labelled arrays.

>>> grid = run_sweep(plan)                        # doctest: +SKIP

Knows nothing of the report.
"""
