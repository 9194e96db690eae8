"""How does the shaft line move? Knows nothing of bearings or files."""
