"""The paper's figures and results redone on a case, each by a command of its own.

Source: Advances in Mechanical Engineering 2023, doi 10.1177/16878132231190062.
`python -m studies.<name>` prints tables and writes figures; `studies.validation` runs
them all and writes VALIDATION.md.
"""
