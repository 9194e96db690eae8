"""What should the coupling be? Five steps in order, and what comes out.

>>> outcome = run_design(case)                    # doctest: +SKIP

Knows no file and prints nothing.
"""
