"""How long does the bearing live?

>>> damage_increment(load, speed, time_step, bearing, grease, 0.99)  # doctest: +SKIP

Knows loads and speeds, not the line that makes them.
"""
