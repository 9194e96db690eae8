"""How does a chain of inertias move?

>>> rate = motion(driveline, state).state_rate    # doctest: +SKIP

Knows neither events nor bearings, and no file.
"""
