"""What does one coupling do to the machine: loads, damage, and their slopes?

>>> Evaluator(case, candidate).performance(k, gap)  # doctest: +SKIP

Read `quantities` (what an event leaves behind), `step` (line and bearings in one step),
`variables` and `chance` (what differs between run-downs), `run_downs`, `totals`, then
`evaluator`. Knows neither search nor steps, and no file.
"""
