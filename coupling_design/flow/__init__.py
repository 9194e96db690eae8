"""What comes out of the five steps: choice, real sizes, maps, what to be wary of.

>>> outcome = run_design(case)                    # doctest: +SKIP

Read `design` (the steps in order), `outcome` (what a report needs), then the rest.
Knows no file and prints nothing.
"""
