"""What does a signal over time show? Arrays in, arrays out.

>>> largest_swing(history, angular_frequency)     # doctest: +SKIP

Knows nothing of drivelines or files.
"""
