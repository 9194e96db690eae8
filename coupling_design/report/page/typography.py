"""Text of the console set as one expects it on a page: subscripts, signs, powers."""

from __future__ import annotations

import html
import re

_SYMBOL = re.compile(
    r"\b([A-Za-z])_(Tdyn|Kmax2?|KN|KW|KV|ISO|min|max|10|c|C|f|l|n|p|t|z|W)(?![A-Za-z0-9_])"
)
_POWER = re.compile(r"(?<![\w.])([-+]?\d+(?:\.\d+)?)e([-+]?\d+)(?!\w)")
_SIGNS = {
    "&lt;=": "≤",
    "&gt;=": "≥",
    "kN*m": "kN·m",
    "N*m": "N·m",
    "sqrt 2": "√2",
    " x 1e6": " × 10<sup>6</sup>",
}


def typeset(text: str) -> str:
    """Return text as HTML, escaped, with its symbols, signs and powers set.

    Plotly reads the same mark-up in labels.
    """
    escaped = html.escape(text)
    for plain, sign in _SIGNS.items():
        escaped = escaped.replace(plain, sign)
    escaped = _SYMBOL.sub(r"\1<sub>\2</sub>", escaped)
    return _POWER.sub(_power, escaped)


def _power(match: re.Match[str]) -> str:
    mantissa, exponent = match.groups()
    return f"{mantissa}·10<sup>{exponent.lstrip('+').replace('-', '−')}</sup>"
