"""One value of a case file: a number with its unit, its kind, its source.

>>> from_si(0.1, "m")                             # doctest: +SKIP

Knows no file and no section.
"""
