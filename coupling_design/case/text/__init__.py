"""A file of YAML as data, with the line of every key and value.

>>> document = parse_text(text)                   # doctest: +SKIP

Knows no schema.
"""
