"""A graph as C over lanes: several designs, or several steps, side by side.

>>> kernel = write_kernel(graph, outputs)         # doctest: +SKIP

Knows nothing of compilers, nor of where a kernel is kept.
"""
