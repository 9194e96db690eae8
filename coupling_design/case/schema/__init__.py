"""What may stand in a file, and what is said of what may not."""
