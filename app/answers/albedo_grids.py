"""Albedos along a line and over a rectangle of interfaces."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from functools import lru_cache
from typing import Literal

import numpy as np

from app.answers.albedo import CHANNELS, QUANTITIES
from app.answers.answer import Gaps, Rows, Table, Values, answer
from app.answers.axes import Axis, Grid, held
from app.answers.curves import Chosen
from app.answers.interface import CONVENTION, PresetInterface, ResolvedPreset
from app.optics.albedo import Albedo, Domain, Fit, Quantity, albedo, flatland_albedo, model_albedo
from app.optics.errors import NotAllowed
from app.optics.interface import Interface
from app.optics.numerics.peaks import summit
from app.optics.parameters import Array

Shown = Literal["exact", "value", "error"]
Ends = tuple[float, float, int]
"""First and last value, and how many."""


@answer
class AlbedoCurve:
    """One albedo along a sweep."""

    kind: Literal["exact", "fit", "model"]
    id: str
    quantity: str
    values: Gaps
    error: Gaps | None = None
    """values - exact; null for the exact ones."""
    in_domain: tuple[float, float] | None = None
    """Part of the sweep within the fit's domain, null if none; of models null."""

    @property
    def column(self) -> str:
        """Header in CSV."""
        prefix = "model." if self.kind == "model" else ""
        return f"{prefix}{self.id}.{self.quantity}"


@answer
class AlbedoSweep:
    """Albedos along a sweep."""

    convention: str = CONVENTION
    n_i: float
    incident: ResolvedPreset | None
    """The preset that n_i comes from."""
    n_t: float | None
    """Null where it is swept."""
    k_t: float | None
    """Null where it is swept."""
    over: str
    values: Values
    curves: list[AlbedoCurve]

    def table(self) -> Table:
        """Lay out a row each interface."""
        columns: dict[str, Array] = {self.over: self.values}
        for curve in self.curves:
            columns[curve.column] = curve.values
            if curve.error is not None:
                columns[f"{curve.column}.error"] = curve.error
        return Table(columns, "albedo_sweep.csv")


@answer
class Box:
    """A domain in a map's own coordinates."""

    n_t: tuple[float, float]
    k_t: tuple[float, float]

    @classmethod
    def of(cls, domain: Domain, n_i: float) -> Box:
        """Scale a domain by the index of the incident medium."""
        (low, high), (least, most) = domain.eta, domain.kappa
        return cls(n_t=(low * n_i, high * n_i), k_t=(least * n_i, most * n_i))

    def shared_with(self, other: Box) -> Box | None:
        """The part that lies in both, or None."""
        n_t, k_t = (
            (max(mine[0], its[0]), min(mine[1], its[1]))
            for mine, its in ((self.n_t, other.n_t), (self.k_t, other.k_t))
        )
        return Box(n_t=n_t, k_t=k_t) if n_t[0] <= n_t[1] and k_t[0] <= k_t[1] else None


@answer
class Largest:
    """Where a map's modulus is largest, found by a search that its grid does not bound."""

    value: float
    n_t: float
    k_t: float

    @classmethod
    def within(cls, function: Callable[[Array, Array], Array], box: Box) -> Largest | None:
        """Search a box; None where the function has no value or grows without bound."""
        found = summit(function, box.n_t, box.k_t)
        return found and cls(value=found.value, n_t=found.x, k_t=found.y)


@answer
class AlbedoMap:
    """A grid of albedos or of a fit's errors over n_t and k_t."""

    convention: str = CONVENTION
    n_i: float
    n_t: Values
    k_t: Values
    fit: str | None
    quantity: Quantity
    show: Shown
    values: Rows
    """A row for each k_t."""
    largest: Largest | None
    """Over the whole map, between its points too; null where it grows without bound."""
    largest_in_domain: Largest | None
    """Within the fit's domains; null outside them."""
    domains: list[Box]
    """The fit's domains, to be outlined."""

    def table(self) -> Table:
        """Lay out a row each point."""
        n_t, k_t = (values.ravel() for values in np.meshgrid(self.n_t, self.k_t))
        return Table({"n_t": n_t, "k_t": k_t, self.show: self.values.ravel()}, "albedo_map.csv")


def albedo_sweep(
    fixed: Interface,
    axis: Axis,
    *,
    fits: Iterable[Fit] = (),
    models: Iterable[Chosen] = (),
    flatland: bool = False,
) -> AlbedoSweep:
    """Evaluate albedos along an axis: exact, by fits, of models, and in two dimensions if asked."""
    interface = Grid(fixed, axis).interface
    exact = albedo(interface)
    curves = [
        AlbedoCurve(kind="exact", id="exact", quantity=name, values=getattr(exact, name))
        for name in QUANTITIES
    ]
    if flatland:
        flat = flatland_albedo(interface)
        curves.append(AlbedoCurve(kind="exact", id="flatland", quantity="unpolarized", values=flat))
    curves += [_fitted(fit, interface, exact, axis.values) for fit in fits]
    curves += [curve for chosen in models for curve in _averaged(chosen, interface, exact)]
    named = fixed.incident if isinstance(fixed, PresetInterface) else None
    return AlbedoSweep(
        **held(fixed, axis.name),
        incident=ResolvedPreset.of(named),
        over=axis.name,
        values=axis.values,
        curves=curves,
    )


def _fitted(fit: Fit, interface: Interface, exact: Albedo, swept: Array) -> AlbedoCurve:
    values = np.ascontiguousarray(fit(interface))
    inside = swept[fit.contains(interface)]
    return AlbedoCurve(
        kind="fit",
        id=fit.id,
        quantity=fit.quantity,
        values=values,
        error=np.asarray(values - getattr(exact, fit.quantity)),
        in_domain=(float(inside[0]), float(inside[-1])) if inside.size else None,
    )


def _averaged(chosen: Chosen, interface: Interface, exact: Albedo) -> Iterator[AlbedoCurve]:
    averages = model_albedo(chosen.model, interface, **chosen.given)
    colors = ("",) if averages.ndim == 1 else CHANNELS
    for color, row in zip(colors, np.atleast_2d(averages), strict=True):
        yield AlbedoCurve(
            kind="model",
            id=chosen.model.id,
            quantity=f"unpolarized{color}",
            values=np.ascontiguousarray(row),
            error=np.asarray(row - exact.unpolarized),
        )


def albedo_map(
    n_i: float,
    n: Ends,
    k: Ends,
    *,
    fit: Fit | None = None,
    show: Shown | None = None,
    quantity: Quantity | None = None,
) -> AlbedoMap:
    """Evaluate albedos, or a fit's errors, over a rectangle of n_t and k_t.

    Raises
    ------
    NotAllowed
        If the ends are out of order, or `show` or `quantity` contradicts the fit.
    """
    if fit is None and show in ("value", "error"):
        raise NotAllowed("show", show, "exact, unless a fit is given")
    if fit is not None and quantity not in (None, fit.quantity):
        raise NotAllowed("quantity", quantity, f"{fit.id} approximates {fit.quantity}")
    show = show or ("error" if fit else "exact")
    quantity = fit.quantity if fit else quantity or "unpolarized"
    grid, exact = _exact_over_rectangle(n_i, n, k)

    def shown(interface: Interface, truth: Albedo) -> Array:
        if fit is None or show == "exact":
            return np.asarray(getattr(truth, quantity))
        return fit(interface) - getattr(truth, quantity) if show == "error" else fit(interface)

    def anywhere(n_t: Array, k_t: Array) -> Array:
        interface = Interface(n_i, n_t, k_t)
        return shown(interface, albedo(interface))

    whole = Box(n_t=n[:2], k_t=k[:2])
    domains = [Box.of(domain, n_i) for domain in fit.domains] if fit else []
    parts = [part for domain in domains if (part := whole.shared_with(domain))]
    inside = [found for part in parts if (found := Largest.within(anywhere, part))]
    return AlbedoMap(
        n_i=n_i,
        n_t=grid.varied["n_t"].ravel(),
        k_t=grid.varied["k_t"].ravel(),
        fit=fit.id if fit else None,
        quantity=quantity,
        show=show,
        values=np.ascontiguousarray(shown(grid.interface, exact)),
        largest=Largest.within(anywhere, whole),
        largest_in_domain=max(inside, key=lambda found: abs(found.value), default=None),
        domains=domains,
    )


@lru_cache(maxsize=8)
def _exact_over_rectangle(n_i: float, n: Ends, k: Ends) -> tuple[Grid, Albedo]:
    """Exact albedos over a rectangle; kept, since every fit is compared with the same ones."""
    x, y = Axis.between("n_t", *n, prefix="n_"), Axis.between("k_t", *k, prefix="k_")
    grid = Grid(Interface(n_i), x, y)
    return grid, albedo(grid.interface)
