"""A pane over the angle of incidence, and incidence-angle modifiers measured against it."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from app.answers.answer import Table, Values, answer
from app.answers.film_spectrum import FilmCurve
from app.optics.incidence import Incidence
from app.optics.pane import MODIFIERS, KnownModifier, Pane
from app.optics.parameters import Array

_FINE = np.linspace(0.0, 90.0, 1801)
_QUANTITIES = ("R", "Rs", "Rp", "T", "Ts", "Tp", "A", "As", "Ap")


@answer
class MeasuredModifier:
    """An incidence-angle modifier in use, and how far it is from the exact pane."""

    id: str
    title: str
    latex: str
    reference: str
    parameters: dict[str, float]
    values: Values
    error: Values
    """Modifier less the exact one."""
    max_abs: float
    """Largest error at angles from 0 to 90 degrees in steps of 0.05."""
    max_abs_at_deg: float
    max_abs_to_60: float
    """Largest error up to 60 degrees."""
    diffuse: float
    """Mean over the hemisphere of diffuse light, 2 times the integral of the modifier times
    sin cos."""


@answer
class PaneCurves:
    """What a pane reflects, transmits and absorbs over the angle, both faces counted."""

    n: float
    thickness_mm: float
    absorption_per_m: float
    n_behind: float
    theta_i_deg: Values
    curves: list[FilmCurve]
    modifier: Values
    """T over T along the normal, exact."""
    diffuse: float
    """Its mean over the hemisphere of diffuse light."""
    modifiers: list[MeasuredModifier]

    def table(self) -> Table:
        """Lay out a column each curve."""
        columns = {"theta_i_deg": self.theta_i_deg}
        columns |= {curve.quantity: curve.values for curve in self.curves}
        columns["modifier"] = self.modifier
        columns |= {f"modifier.{each.id}": each.values for each in self.modifiers}
        return Table(columns, "pane.csv")


def pane_curves(pane: Pane, samples: int, given: Mapping[str, float]) -> PaneCurves:
    """Evaluate a pane, and the modifiers in use beside the exact one.

    Parameters
    ----------
    pane
        The pane.
    samples
        Equally spaced angles from 0 to 90 degrees.
    given
        The modifiers' own parameters by name.
    """
    incidence = Incidence.from_degrees(np.linspace(0.0, 90.0, samples))
    fine = Incidence.from_degrees(_FINE)
    energy, lost = pane.parts(incidence)
    exact, exact_fine = pane.modifier(incidence), pane.modifier(fine)
    own = {name: getattr(pane, name) for name in ("n", "thickness_mm", "absorption_per_m")}
    return PaneCurves(
        n=pane.n,
        thickness_mm=pane.thickness_mm,
        absorption_per_m=pane.absorption_per_m,
        n_behind=pane.n_behind,
        theta_i_deg=incidence.theta_i_deg,
        curves=[
            FilmCurve(quantity=name, values=getattr(lost if name[0] == "A" else energy, name))
            for name in _QUANTITIES
        ],
        modifier=exact,
        diffuse=_diffuse(exact_fine),
        modifiers=[
            _measured(each, own | dict(given), incidence, fine, exact, exact_fine)
            for each in MODIFIERS
        ],
    )


def _measured(
    known: KnownModifier,
    given: Mapping[str, float],
    incidence: Incidence,
    fine: Incidence,
    exact: Array,
    exact_fine: Array,
) -> MeasuredModifier:
    values, values_fine = known.function(incidence, given), known.function(fine, given)
    errors = np.abs(values_fine - exact_fine)
    worst = int(np.argmax(errors))
    names = [parameter.name for parameter in known.parameters]
    names += ["n", "thickness_mm", "absorption_per_m"] if known.id == "physical" else []
    return MeasuredModifier(
        id=known.id,
        title=known.title,
        latex=known.latex,
        reference=known.reference,
        parameters={name: float(given[name]) for name in names},
        values=values,
        error=values - exact,
        max_abs=float(errors[worst]),
        max_abs_at_deg=float(_FINE[worst]),
        max_abs_to_60=float(errors[_FINE <= 60.0].max()),
        diffuse=_diffuse(values_fine),
    )


def _diffuse(values: Array) -> float:
    """Mean over the hemisphere, by Simpson's rule in the angle."""
    theta = np.radians(_FINE)
    weight = np.full(theta.size, 2.0)
    weight[1::2], weight[0], weight[-1] = 4.0, 1.0, 1.0
    return float(np.sum(weight * values * np.sin(2.0 * theta)) * (theta[1] - theta[0]) / 3.0)
