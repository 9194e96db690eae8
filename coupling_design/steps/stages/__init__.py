"""The five steps of the design flow, one file each."""
