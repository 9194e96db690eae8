"""From checked sections to SI values."""
