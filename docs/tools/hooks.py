"""What the site is built with: formulas as MathML, and the pages of the project's root.

Formulas are written as GitHub shows them: a ```math``` block, or $`...`$ in a line.
They become MathML while the site is built, so that it needs no script, no font and no
network; every current browser draws MathML by itself.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

from latex2mathml.converter import convert
from mkdocs.structure.files import File, Files

ROOT = Path(__file__).resolve().parent.parent.parent
# Pages of the root that are part of the site, under their name in it.
FROM_ROOT = {
    "VALIDATION.md": "validation-tables.md",
    "PERFORMANCE.md": "performance-tables.md",
    "NOMENCLATURE.md": "nomenclature.md",
    "ARCHITECTURE.md": "architecture.md",
}
_BLOCK = re.compile(r"^```math\n(.*?)^```$", re.MULTILINE | re.DOTALL)
_INLINE = re.compile(r"\$`([^`]+)`\$")
_ALIGNED = re.compile(r"\\begin\{aligned\}(.*?)\\end\{aligned\}")
_LINK = re.compile(r"\]\((?:\.\./)*(" + "|".join(map(re.escape, FROM_ROOT)) + r")\)")
_IMAGE = re.compile(r"!\[[^\]]*\]\((studies/[^)]+|benchmarks/[^)]+)\)")
# Links of the root's pages to files that are no page of the site keep their text only.
_ELSEWHERE = re.compile(r"(?<!!)\[([^\]]+)\]\((?!https?:|#)([^)]+)\)")


def on_files(files: Files, config: Any) -> Files:
    """Add the root's pages and the figures they show."""
    for source, name in FROM_ROOT.items():
        text = (ROOT / source).read_text(encoding="utf-8")
        for figure in set(_IMAGE.findall(text)):
            files.append(
                File.generated(config, figure, abs_src_path=str(ROOT / figure))
            )
        files.append(File.generated(config, name, content=_own_links_only(text)))
    return files


def on_page_markdown(markdown: str, **_: Any) -> str:
    """Turn formulas into MathML, and links to the root's pages into the site's."""
    linked = _LINK.sub(lambda match: f"]({_to_root_page(match[1], _)})", markdown)
    blocks = _BLOCK.sub(lambda match: f"\n{mathml(match[1], 'block')}\n", linked)
    return _INLINE.sub(lambda match: mathml(match[1], "inline"), blocks)


def mathml(tex: str, display: str) -> str:
    """Return a formula as MathML on one line, within an element that Markdown keeps."""
    drawn = convert(_as_array(" ".join(tex.split())), display=display)
    drawn = drawn.replace("\n", "").replace("<mtable", '<mtable displaystyle="true"')
    element = "div" if display == "block" else "span"
    return f'<{element} class="formula">{drawn}</{element}>'


def _as_array(tex: str) -> str:
    """Return aligned equations as an array, the form of them the converter knows."""
    return _ALIGNED.sub(
        lambda match: f"\\begin{{array}}{{rlrl}}{match[1]}\\end{{array}}", tex
    )


def _to_root_page(source: str, context: dict[str, Any]) -> str:
    depth = context["page"].file.src_uri.count("/")
    return "../" * depth + FROM_ROOT[source]


def _own_links_only(text: str) -> str:
    def keep(match: re.Match[str]) -> str:
        return match[0] if match[2] in FROM_ROOT else match[1]

    return _ELSEWHERE.sub(keep, text)
