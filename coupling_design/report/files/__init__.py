"""What a run leaves on disk: the only room of the report that knows case files."""
