"""The report on a terminal: a panel per question.

>>> render_outcome(outcome)                       # doctest: +SKIP

Knows neither page nor files.
"""
