"""What can one ask of it? One module per command of the command line.

>>> run(["design", "cases/16v280.yaml"])          # doctest: +SKIP

Each module has `run` and `EXAMPLES`, and `app` lists them. Nothing imports it but
`__main__`.
"""
