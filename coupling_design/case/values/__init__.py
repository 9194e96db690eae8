"""One value of a case file: a number with its unit, its kind, its source."""
