"""What a run leaves on disk: the only room of the report that knows case files.

>>> write_files(outcome, directory)               # doctest: +SKIP

Puts each file in place whole.
"""
