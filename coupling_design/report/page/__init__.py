"""The report to hand over: one HTML file with tables and interactive figures."""
