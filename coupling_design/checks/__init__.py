"""What is to be said of a machine and its coupling beside the damage?

>>> case_warnings(case)                           # doctest: +SKIP

Rolls nothing out: a performance is given to it. Knows neither search nor steps.
"""
