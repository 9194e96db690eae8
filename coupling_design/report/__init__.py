"""What happened? Renders and writes; computes nothing."""
