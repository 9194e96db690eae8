"""A case file with other values in it."""
