"""A graph rewritten by identities, one module and one idea each.

>>> graph, outputs = gather_sums(graph, outputs)  # doctest: +SKIP

Knows nothing of C; what is rewritten keeps its value but for rounding.
"""
