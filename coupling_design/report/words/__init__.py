"""Numbers, units and verdicts in words."""
