"""A file of YAML as data, with the line of every key and value."""
