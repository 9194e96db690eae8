"""Numbers, units and verdicts in words.

>>> significant(0.123456, 4)                      # doctest: +SKIP

Knows neither terminal nor page.
"""
