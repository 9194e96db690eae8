"""How long the bearing lives."""
