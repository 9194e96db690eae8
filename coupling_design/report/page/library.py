"""Plotly's drawing library as text, taken from the Python package of that name.

The Python package is only looked into, never imported: the main job does not wait for
it, and a report costs one read of a file.
"""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path

HOW_TO_GET = (
    "No report.html: it needs Plotly and Jinja; pip install plotly jinja2 gets them."
)
_NEEDED = ("plotly", "jinja2")


def can_write_html() -> bool:
    """Return whether all is installed that an HTML report needs."""
    return all(find_spec(name) is not None for name in _NEEDED)


def plotly_script() -> str:
    """Return plotly.js, minified, to stand between <script> and </script>."""
    package = find_spec("plotly")
    if package is None or package.origin is None:
        raise ModuleNotFoundError(HOW_TO_GET)
    script = Path(package.origin).with_name("package_data") / "plotly.min.js"
    text = script.read_text(encoding="utf-8")
    # A browser ends a script at these letters, even inside a JavaScript string.
    return text.replace("</script", "<\\/script").replace("<!--", "<\\!--")
