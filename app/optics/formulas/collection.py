"""The collection of formulas: models, exact albedos and their fits, angles and conversions."""

from app.optics.albedo import albedo
from app.optics.albedo.fit import Claim, Fit
from app.optics.albedo.fits import FITS
from app.optics.amplitudes import reflectance
from app.optics.collection import Collection
from app.optics.errors import UnknownName
from app.optics.formulas import albedo as exact_albedos
from app.optics.formulas import angles, conversions
from app.optics.formulas.formula import (
    ETA,
    THETA,
    Accuracy,
    Columns,
    Formula,
    FormulaKind,
    Plotted,
    Symbol,
    over,
    rounding,
)
from app.optics.formulas.symbols import explain
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.parameters import K_T, N_I, N_T, Array
from app.optics.registry import ROUNDED_AT, Measured, Model, Registry

CONVENTIONS: dict[FormulaKind, str] = {
    "model": "Angles from the surface normal, mu = cos(theta_i); N = n + i k, k of at least 0, time "
    "factor exp(-i w t); r_p = -r_s at normal incidence; R is the mean of R_s and R_p.",
    "albedo": "Light from the whole hemisphere, weighted by the cosine; n = eta and k = kappa are "
    "relative to the incident medium, so that eta below 1 is the view from the denser side.",
    "angle": "Angles from the surface normal; N = n + i k is relative to the incident medium, k of "
    "at least 0, time factor exp(-i w t).",
    "conversion": "F0 is linear, seen from the incident medium n_i, which is 1 unless a formula "
    "names it; n_t and k_t, of at least 0, belong to the second medium.",
}

_R = Plotted("R", "R", "reflectance")
_FIT_SYMBOLS = (
    Symbol("n", "relative index eta"),
    Symbol("k", "relative extinction kappa"),
)


class UnknownFormula(UnknownName):
    """An id that is no formula's."""


def of_model(model: Model) -> Formula:
    """Show a model: its curve beside the exact one over the angle."""
    measured = [_measured_at(stated) for stated in model.measured]
    rounded = [
        rounding(most, "R", f"{_words(*media)}, whole degrees below 90")
        for media, most in zip(ROUNDED_AT, model.rounding or (), strict=False)
    ]
    at = model.measured[0].media if model.measured else ROUNDED_AT[0]

    def columns(interface: Interface, theta: Array) -> Columns:
        incidence = Incidence.from_degrees(theta)
        yield "exact", "exact", reflectance(interface, incidence)
        if model.id != "exact":
            yield model.id, model.title, model(interface, incidence)

    return Formula(
        id=f"model.{model.id}",
        title=model.title,
        latex=model.latex,
        reference=model.reference,
        validity=model.validity,
        accuracy=(*measured, *rounded),
        at=Interface(*at),
        takes=(N_I, N_T, K_T),
        symbols=model.symbols,
        parameters=model.parameters,
        curve=over(THETA, 0.0, 90.0, _R, columns),
    )


def of_fit(fit: Fit) -> Formula:
    """Show a fit: its albedo beside the exact one over the relative index."""
    domain = fit.domains[0]
    conductor = domain.kind == "conductor"

    words = "albedo" if fit.quantity == "unpolarized" else f"albedo, {fit.quantity}"

    def columns(interface: Interface, eta: Array) -> Columns:
        media = Interface(1.0, eta, interface.kappa if conductor else 0.0)
        yield "exact", "exact", getattr(albedo(media), fit.quantity)
        yield fit.id, fit.title, fit(media)

    return Formula(
        id=f"albedo.{fit.id}",
        title=fit.title,
        latex=fit.latex,
        reference=fit.reference,
        printed=fit.printed,
        validity=f"{fit.note} Made for {' or '.join(d.words for d in fit.domains)}.",
        accuracy=tuple(_claimed(claim) for claim in fit.claims),
        at=Interface(1.0, 1.5, domain.kappa[0]),
        takes=(K_T,) if conductor else (),
        symbols=(*_FIT_SYMBOLS, *fit.symbols),
        curve=over(ETA, *domain.eta, Plotted("albedo", "A", words), columns),
    )


def _words(n_i: float, n_t: float, k_t: float) -> str:
    return f"n_i = {n_i:g}, n_t = {n_t:.7g}, k_t = {k_t:g}"


def _measured_at(stated: Measured) -> Accuracy:
    over = f"{_words(*stated.media)}, largest at {stated.at_deg:g} degrees"
    return Accuracy(value=stated.max_abs, of="R", over=over, against="exact")


def _claimed(claim: Claim) -> Accuracy:
    eta, kappa = claim.at
    at = f"largest at eta = {eta:g}" + (f", kappa = {kappa:g}" if kappa else "")
    over = f"{claim.measured_over.words}; {at}"
    return Accuracy(
        value=claim.measured, of="A", over=over, against="exact", relative=claim.relative
    )


class Formulas(Collection[Formula]):
    """Models, exact albedos, fits, angles, conversions, each in its registry's order."""

    def __init__(self, registry: Registry) -> None:
        every = (
            *(of_model(model) for model in registry.values()),
            *exact_albedos.FORMULAS,
            *(of_fit(fit) for fit in FITS.values()),
            *angles.FORMULAS,
            *conversions.FORMULAS,
        )
        super().__init__(every, UnknownFormula, "formula_id")


def symbols_of(formula: Formula) -> list[Symbol]:
    """What every letter of the formula means, in the order of appearance."""
    return explain(formula.latex, formula.symbols, formula.parameters)
