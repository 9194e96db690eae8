"""From checked sections to SI values.

>>> case = build_case(section, file, sha256, provenance, catalogues)  # doctest: +SKIP

Takes what is checked; knows no rule.
"""
