"""One number of ours beside one that does not come from this code.

Every module of this folder offers `comparisons()`, the list of what it compares, and
tests each of them: the numbers of a validation report are those of the tests.
"""

from dataclasses import dataclass


@dataclass(frozen=True)
class Comparison:
    """A quantity as its source has it and as we have it, both in `unit`.

    `tolerance` is the source's own precision, in `unit`; `published` is printed there
    or follows from it; `remark` says what a reader must know to compare the two.
    """

    quantity: str
    source: str
    published: float
    ours: float
    unit: str
    tolerance: float
    remark: str = ""

    @property
    def difference(self) -> float:
        """Ours less the published value."""
        return self.ours - self.published

    @property
    def agrees(self) -> bool:
        """Whether the two differ by no more than the tolerance; never if NaN."""
        return abs(self.difference) <= self.tolerance

    def __str__(self) -> str:
        """The comparison in a line."""
        return (
            f"{self.quantity}: {self.ours:.12g} {self.unit}, "
            f"{self.source}: {self.published:.12g} +- {self.tolerance:.3g}"
        )


def collect(groups):
    """Return the comparisons of several functions in one list."""
    return [comparison for group in groups for comparison in group()]


def disagreements(group):
    """Return what disagrees in the comparisons of a function, a line each."""
    found = group()
    assert found, "nothing was compared"
    return [str(comparison) for comparison in found if not comparison.agrees]
