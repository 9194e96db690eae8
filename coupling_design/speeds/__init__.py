"""What happens at each speed, once the line turns steadily?

>>> critical_speeds(driveline, working_speed)     # doctest: +SKIP

Knows no event and no design.
"""
