"""A march as machine code: written in C from the step's graph, compiled, kept."""
