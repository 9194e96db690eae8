"""The notebook of the Python API runs from its first cell to its last."""

import importlib.util
import json
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
NOTEBOOK = ROOT / "notebooks" / "api.ipynb"
MISSING = [
    name
    for name in ("ipykernel", "nbclient", "nbformat", "xarray")
    if importlib.util.find_spec(name) is None
]


def cells():
    return json.loads(NOTEBOOK.read_text(encoding="utf-8"))["cells"]


def test_outputs_are_not_kept():
    assert all(not cell.get("outputs") for cell in cells())


def test_every_function_of_the_api_is_in_it():
    text = "".join("".join(cell["source"]) for cell in cells())
    for name in ("load", "simulate", "to_dataset", "sweep", "design", "save_chosen"):
        assert name in text


@pytest.mark.slow
@pytest.mark.skipif(bool(MISSING), reason=f"not installed: {', '.join(MISSING)}")
@pytest.mark.filterwarnings("default")  # of the notebook's machinery, not ours
def test_every_cell_runs(monkeypatch):
    import nbformat
    from nbclient import NotebookClient

    monkeypatch.setenv("PYTHONPATH", str(ROOT))
    notebook = nbformat.read(NOTEBOOK, as_version=4)
    resources = {"metadata": {"path": str(ROOT)}}
    NotebookClient(notebook, timeout=300, resources=resources).execute()
    last = notebook.cells[-1].outputs[0].data["text/plain"]
    assert last.startswith("('rubber', 'tight_fit', ")
    assert last.endswith(" less damage')")
