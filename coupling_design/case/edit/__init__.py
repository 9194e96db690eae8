"""A case file with other values in it: comments, order and units stay.

>>> override(document, assignments)               # doctest: +SKIP

Knows where a value stands, not what it means.
"""
