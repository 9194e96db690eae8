"""Labelled arrays to files: CSV, Parquet, netCDF, by the file's ending."""

from __future__ import annotations

import csv
import io
import secrets
from collections.abc import Callable
from importlib import import_module
from pathlib import Path
from typing import Any

from coupling_design.errors import OutputError
from coupling_design.explore.grid import Grid


def check_file(path: Path) -> None:
    """Raise OutputError, before the long work, if a file of this kind cannot be."""
    if path.suffix not in _WRITERS:
        raise OutputError(
            f"{path}: ends in '{path.suffix}', allowed are {', '.join(_WRITERS)}"
        )
    for module in _NEEDED[path.suffix]:
        needed(module)
    if not path.absolute().parent.is_dir():
        raise OutputError(f"{path}: there is no such directory; make it first")


def write_grid(grid: Grid, path: Path) -> None:
    """Write a grid in one go: if that fails, what was there before stays."""
    temporary = path.with_name(f".{path.stem}.{secrets.token_hex(4)}{path.suffix}")
    try:
        try:
            _WRITERS[path.suffix](grid, temporary)
            temporary.replace(path)
        finally:
            temporary.unlink(missing_ok=True)
    except OSError as error:
        reason = error.strerror or error
        raise OutputError(f"{path}: cannot be written: {reason}") from None


def to_dataset(grid: Grid) -> Any:
    """Return a grid as an xarray.Dataset, its units as attributes."""
    xarray = needed("xarray")
    axes = [axis.name for axis in grid.axes]
    return xarray.Dataset(
        {q.name: (axes, q.values, _attributes(q.unit, q.meaning))
         for q in grid.quantities},
        {a.name: ([a.name], a.values, _attributes(a.unit, a.meaning))
         for a in grid.axes},
        dict(grid.facts),
    )  # fmt: skip


def needed(module: str) -> Any:
    """Return an optional library, or say how it is installed."""
    try:
        return import_module(module)
    except ImportError:
        raise OutputError(
            f"this needs {module}, which is not installed; install the extra named "
            'data: pip install "coupling-design[data]"'
        ) from None


def csv_text(grid: Grid) -> str:
    """Return a grid as CSV, a line per point; the header names the units."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    columns = list(grid.columns())
    writer.writerow([column.heading for column in columns])
    writer.writerows(zip(*(c.values.tolist() for c in columns), strict=True))
    return text.getvalue()


def _attributes(unit: str, meaning: str) -> dict[str, str]:
    return {"units": unit, "long_name": meaning} if unit else {"long_name": meaning}


def _write_csv(grid: Grid, path: Path) -> None:
    path.write_text(csv_text(grid), encoding="utf-8", newline="")


def _write_parquet(grid: Grid, path: Path) -> None:
    arrow, parquet = needed("pyarrow"), needed("pyarrow.parquet")
    columns = list(grid.columns())
    arrays = [arrow.array(column.values) for column in columns]
    fields = [
        arrow.field(
            column.name, array.type, metadata=_attributes(column.unit, column.meaning)
        )
        for column, array in zip(columns, arrays, strict=True)
    ]
    schema = arrow.schema(fields, metadata=dict(grid.facts))
    parquet.write_table(arrow.Table.from_arrays(arrays, schema=schema), path)


def _write_netcdf(grid: Grid, path: Path) -> None:
    to_dataset(grid).to_netcdf(path, engine="netcdf4")


_WRITERS: dict[str, Callable[[Grid, Path], None]] = {
    ".csv": _write_csv,
    ".parquet": _write_parquet,
    ".nc": _write_netcdf,
}
_NEEDED = {
    ".csv": (),
    ".parquet": ("pyarrow",),
    ".nc": ("xarray", "netCDF4"),
}
