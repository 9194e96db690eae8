"""What must hold between the values of a file.

>>> problems = check_relations(document)          # doctest: +SKIP

Finds, and builds nothing.
"""
