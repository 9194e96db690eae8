"""The report to hand over: one HTML file with tables and interactive figures.

>>> html = html_report(outcome)                   # doctest: +SKIP

Knows no file but its own templates.
"""
