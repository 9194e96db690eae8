"""What is it, what may be chosen, what must it do? SI values, frozen.

>>> case.driveline, case.bearings, case.duty      # doctest: +SKIP

Knows no file, no event that runs and no search.
"""
