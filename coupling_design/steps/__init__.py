"""What should the coupling be? Five steps, each with its question and its limits.

>>> so_far = check_vibration_isolation(so_far)    # doctest: +SKIP

Read `so_far` (what passes from step to step), `limits`, `step_result`, then the five in
the paper's order: `coupling_types`, `vibration_isolation`, `bearing_load`,
`high_stiffness_plan`, `key_gap`. Knows no file and prints nothing.
"""
