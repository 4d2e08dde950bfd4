"""Tables of R that the literature prints."""

from functools import cache
from pathlib import Path
from typing import NamedTuple

import numpy as np

from app.optics.parameters import Array

_TABLE = Path(__file__).parent / "tables" / "deon_2019_fresnel.csv"

DEON_HALF_UNIT = 0.5e-8
"""Half a unit of the last decimal that d'Eon prints."""


class PrintedR(NamedTuple):
    """R of unpolarized light from vacuum, a cell each."""

    n_t: Array
    k_t: Array
    theta_i: Array
    """Angle of incidence in radians."""
    R: Array


@cache
def deon_2019() -> PrintedR:
    """All 108 cells of both tables of E. d'Eon's notebook "Fresnel Boundaries" (2019)."""
    cells = np.loadtxt(_TABLE, delimiter=",", skiprows=3)
    columns = [np.ascontiguousarray(column) for column in cells.T]
    for column in columns:
        column.flags.writeable = False
    return PrintedR(*columns)
