"""d'Eon's printed tables of R, cell by cell beside what a model answers."""

from __future__ import annotations

import numpy as np

from app.answers.answer import Gaps, Table, Values, answer
from app.answers.curves import Chosen
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.printed import DEON_HALF_UNIT, deon_2019

SOURCE = (
    "E. d'Eon, Fresnel Boundaries, notebook to A Hitchhiker's Guide to Multiple Scattering (2019), "
    "https://www.eugenedeon.com/hitchhikers"
)


@answer
class BenchmarkTable:
    """R of unpolarized light from vacuum as it is printed, and by a model."""

    source: str = SOURCE
    model: str
    half_unit: float = DEON_HALF_UNIT
    """Half a unit of the last decimal printed."""
    n_t: Values
    k_t: Values
    theta_i_rad: Values
    theta_i_deg: Values
    printed: Values
    """Eight decimals."""
    R: Gaps
    """By the model; null where it is undefined."""
    difference: Gaps
    """R less what is printed."""
    apart: int
    """Cells that differ by more than half a unit, undefined ones not counted."""

    def table(self) -> Table:
        """Lay out a cell a row."""
        names = ("n_t", "k_t", "theta_i_rad", "theta_i_deg", "printed", "R", "difference")
        return Table({name: getattr(self, name) for name in names}, f"deon2019_{self.model}.csv")


def deon_table(chosen: Chosen) -> BenchmarkTable:
    """Evaluate a model at all 108 cells.

    Parameters
    ----------
    chosen
        The model, with what is given for its own parameters.
    """
    n_t, k_t, theta_i_rad, printed = deon_2019()
    incidence = Incidence.from_radians(theta_i_rad)
    R = np.full(printed.shape, np.nan)
    # A model may be made for dielectrics or for conductors alone.
    for absorbs in (False, True):
        which = (k_t > 0.0) == absorbs
        interface = Interface(1.0, n_t[which], k_t[which])
        if chosen.model.reason_outside(interface) is None:
            at = Incidence.from_radians(theta_i_rad[which])
            arguments = chosen.of_one_color().arguments(interface)
            R[which] = chosen.model.evaluate(interface, at, arguments)
    difference = R - printed
    return BenchmarkTable(
        model=chosen.model.id,
        n_t=n_t,
        k_t=k_t,
        theta_i_rad=theta_i_rad,
        theta_i_deg=incidence.theta_i_deg,
        printed=printed,
        R=R,
        difference=difference,
        apart=int(np.sum(np.abs(difference) > DEON_HALF_UNIT + 1e-15)),
    )
