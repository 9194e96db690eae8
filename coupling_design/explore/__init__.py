"""What would happen if? Run-downs and sweeps of a case as labelled arrays."""
