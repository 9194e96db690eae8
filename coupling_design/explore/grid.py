"""Labelled arrays: what a simulation or a sweep leaves, whatever file it goes to."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

Values = NDArray[Any]


@dataclass(frozen=True)
class Quantity:
    """Values of one quantity, SI: its name, its unit, what it is in words."""

    name: str
    unit: str
    meaning: str
    values: Values

    @property
    def heading(self) -> str:
        """Name and unit, as a column is headed."""
        return f"{self.name} [{self.unit}]" if self.unit else self.name


@dataclass(frozen=True)
class Grid:
    """Quantities over axes.

    Attributes
    ----------
    axes : one-dimensional, the first varies slowest
    quantities : each shaped like the axes; NaN where nothing was simulated
    facts : on the whole, such as the case's file
    """

    axes: tuple[Quantity, ...]
    quantities: tuple[Quantity, ...]
    facts: Mapping[str, str] = field(default_factory=dict)

    @property
    def shape(self) -> tuple[int, ...]:
        """How many values each axis has."""
        return tuple(len(axis.values) for axis in self.axes)

    def columns(self) -> Iterator[Quantity]:
        """Yield axes and quantities as columns of equal length."""
        mesh = np.meshgrid(*(axis.values for axis in self.axes), indexing="ij")
        for axis, values in zip(self.axes, mesh, strict=True):
            yield Quantity(axis.name, axis.unit, axis.meaning, values.ravel())
        for each in self.quantities:
            yield Quantity(each.name, each.unit, each.meaning, each.values.ravel())

    def every(self, step: int) -> Grid:
        """Return every so many-th value of a grid with one axis."""

        def thinned(each: Quantity) -> Quantity:
            return Quantity(each.name, each.unit, each.meaning, each.values[::step])

        return Grid(
            tuple(map(thinned, self.axes)),
            tuple(map(thinned, self.quantities)),
            self.facts,
        )

    def values(self, name: str) -> Values:
        """Return the values of a quantity or axis."""
        return next(q.values for q in (*self.axes, *self.quantities) if q.name == name)
