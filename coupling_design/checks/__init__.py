"""What can be said of a machine without rolling anything out?

>>> warnings_of(case)                             # doctest: +SKIP

Knows neither search nor steps.
"""
