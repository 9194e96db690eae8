"""What may stand in a file, and what is said of what may not.

>>> section, problems = check_form(document, CaseSection, relations)  # doctest: +SKIP

Knows what a value is, not what must hold between two.
"""
