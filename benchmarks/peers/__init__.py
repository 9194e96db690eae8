"""The same run-down, written by hand."""
