"""What is the state after n steps, and its derivatives? Knows nothing of machines.

>>> ends = fastest_marcher(step, 120_000)(states, parameters)  # doctest: +SKIP
"""
