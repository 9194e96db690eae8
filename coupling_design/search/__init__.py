"""Which stiffness and gap wear it least?

>>> optimise(program, scanned, starts)            # doctest: +SKIP

Read `program` (variables, objective, limits), `scan`, `ipopt`, then `plane`, `valleys`
and `workbench`. Knows nothing of the steps that ask, and no file.
"""
