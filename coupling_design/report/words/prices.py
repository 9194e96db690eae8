"""The price of taking a real size, in words."""

from __future__ import annotations

from coupling_design.flow.size_choice import CatalogueChoice
from coupling_design.report.words.numbers import significant
from coupling_design.report.words.units import quantity

_DIGITS_OF_PRICE = 3


def describe_price(choice: CatalogueChoice) -> str:
    """Return the best real size and what it costs against the ideal, in words."""
    selected = choice.selected
    if selected is None or choice.price is None or choice.price_of_stiffness is None:
        tail = "the design is the ideal stiffness, which no size has."
        return f"No catalogue size keeps every limit: {tail}"
    ideal = quantity(choice.ideal.torsional_stiffness, "N*m/rad")
    return (
        f"Best real size: {selected.size.name}, {_against(choice.price)} damage than "
        f"the ideal {ideal} MN*m/rad; its stiffness alone makes "
        f"{_against(choice.price_of_stiffness)}, its own inertias and damping the rest."
    )


def _against(price: float) -> str:
    share = f"{significant(abs(price) * 100, _DIGITS_OF_PRICE)} %"
    return f"{share} less" if price < 0 else f"{share} more"
