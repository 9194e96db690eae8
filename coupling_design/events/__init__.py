"""What happens to the machine: what torques act, how it starts, how long it lasts?

>>> history = simulate(driveline, shutdown)       # doctest: +SKIP

Knows neither bearings nor damage, and no file.
"""
