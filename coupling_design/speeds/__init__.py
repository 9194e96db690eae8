"""What happens at each speed, once the line turns steadily?

>>> lines = campbell(driveline, speeds)           # doctest: +SKIP

Knows no event and no design.
"""
