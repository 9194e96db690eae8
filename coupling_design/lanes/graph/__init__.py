"""A step as a graph of elementary operations, read from CasADi and simplified.

>>> graph, outputs = read_step(step)              # doctest: +SKIP

Knows nothing of C, nor of what a step means.
"""
