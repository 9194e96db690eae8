"""Design of the coupling between a diesel engine and its generator."""

__version__ = "0.1.0"
