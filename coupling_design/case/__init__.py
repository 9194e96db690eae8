"""What does a case file say? Read, checked and turned into SI values.

>>> case = load_case("cases/16v280.yaml")

Read `load`, which calls the rooms: `text` (a file as data), `values` (one value),
`schema` (its shape), `edit` (other values), `rules` (what must hold between values),
`build` (the machine). Knows nothing that runs.
"""

from coupling_design.case.load import load_case as load_case
