"""Which values of the inputs that the paper does not print give its results?

`python -m studies.identification` prints a fitted set, its residuals, how well each
value is determined, and the named sets side by side; `search` looks for another set.
"""
