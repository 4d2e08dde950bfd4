"""Columns that are called otherwise: n, k, wavelengths and energies in units that files have."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import TYPE_CHECKING, NamedTuple

from app.materials.reading.columns import ABSCISSAE, role_of
from app.materials.reading.units import UNITS
from app.optics.parameters import K_T, N_T, WAVELENGTH_NM

if TYPE_CHECKING:
    import pyarrow as pa


class Meant(NamedTuple):
    """What a column is read as."""

    name: str
    """Of the known column."""
    unit: str | None
    """Of an abscissa, which is converted to wavelengths in nanometers."""

    def said(self, column: str) -> str:
        """Say it in a sentence."""
        if self.unit is None:
            return f"{column} is read as {self.name}"
        return (
            f"{column} is read as {UNITS[self.unit].kind} in {self.unit}, in place of {self.name}"
        )


READ_AS_WELL = (
    "in a file also n, k, and wavelengths or energies such as wavelength_um and energy_ev"
)
"""What is said beside the names of the columns that are known."""

_INDICES = {"n": N_T.name, "k": K_T.name}


def meant(columns: Collection[str], known: Collection[str]) -> Mapping[str, Meant]:
    """Find what columns mean that are not known, as tables of n and k call theirs.

    One that would stand for a column that is there already stays unknown.
    """
    found: dict[str, Meant] = {}
    taken = {name for name in columns if name in known}
    for column in columns:
        if column in known:
            continue
        role, unit = role_of(column)
        one = None
        if role in _INDICES:
            one = Meant(_INDICES[role], None)
        elif role in ABSCISSAE and unit is not None:
            one = Meant(WAVELENGTH_NM.name, unit)
        if one is not None and one.name not in taken:
            found[column] = one
            taken.add(one.name)
    return found


def renamed(batch: pa.RecordBatch, names: Mapping[str, Meant]) -> pa.RecordBatch:
    """Give columns the names and units of those that they mean."""
    import pyarrow as pa

    columns = []
    for name, column in zip(batch.schema.names, batch.columns, strict=True):
        unit = names[name].unit if name in names else None
        if unit is not None and pa.types.is_floating(column.type):
            numbers = column.to_numpy(zero_copy_only=False).astype(float)
            column = pa.array(UNITS[unit].nanometers(numbers), from_pandas=True)
        columns.append(column)
    schema = [names[name].name if name in names else name for name in batch.schema.names]
    return pa.RecordBatch.from_arrays(columns, names=schema)
