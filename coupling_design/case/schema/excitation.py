"""The shape of an excitation in a case file: orders, or an engine's data."""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import BaseModel, Discriminator, Field, Tag

from coupling_design.case.schema.engine import EngineExcitation
from coupling_design.case.values.kinds import Angle, Number, Torque
from coupling_design.case.values.stated import Section, Stated


class Harmonic(Section):
    """One order of the engine torque."""

    order: Stated[Number]
    amplitude: Stated[Torque]
    phase: Stated[Angle]


def form_of_excitation(written: Any) -> str:
    """Return which form an excitation is written in, engine or orders."""
    return "engine" if isinstance(written, dict | BaseModel) else "orders"


Orders = Annotated[tuple[Harmonic, ...], Field(min_length=1)]
Excitation = Annotated[
    Annotated[Orders, Tag("orders")] | Annotated[EngineExcitation, Tag("engine")],
    Discriminator(form_of_excitation),
]
