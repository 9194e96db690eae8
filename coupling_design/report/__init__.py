"""What happened? Renders and writes; computes nothing.

>>> render_outcome(outcome)                       # doctest: +SKIP

Read `words`, then `console` (panels), `page` (the same as HTML) and `files`, the only
one of the four that knows case files.
"""
