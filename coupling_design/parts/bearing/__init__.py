"""How long does the bearing live?

>>> L = rating_life(bearing, load, kappa, e_C)    # doctest: +SKIP

Knows loads and speeds, not the line that makes them.
"""
