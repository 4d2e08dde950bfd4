"""Every fit of the albedo against its own claim, and against what it is exact for."""

from functools import cache

import numpy as np
import pytest

from app.optics.albedo import FITS, Albedo, Claim, Domain, Fit, UnknownFit, albedo, find_fit
from app.optics.albedo.fits.conductor import METALS
from app.optics.interface import Interface

CLAIMS = [(fit, claim) for fit in FITS.values() for claim in fit.claims]
STEPS = 301
ROUNDING = 1e-9

# Figures measured by others, to the digits they print: (fit, index of the claim, figure).
PUBLISHED = [
    ("deon_2019_log", 0, 0.0017),
    ("deon_2019_rational", 0, 0.0031),
    ("deon_2019_rg", 0, 1.6e-4),
    ("dunkle_1963", 0, 0.0030),
    ("schlick_nk", 0, 0.036),
    ("deon_irving_2011", 2, 7e-5),
    ("egan_hilgeman_1973", 0, 0.039),
    ("egan_hilgeman_1973", 3, 9e-4),
]


@cache
def exact_over(domain: Domain) -> Albedo:
    return albedo(domain.grid(STEPS))


@pytest.mark.parametrize(
    ("fit", "claim"), CLAIMS, ids=[f"{f.id}-{f.claims.index(c)}" for f, c in CLAIMS]
)
def test_measured_error_is_what_is_stated(fit: Fit, claim: Claim) -> None:
    """Stated figures are the largest error, rounded up to three digits, and where it is found."""
    interface = claim.measured_over.grid(STEPS)
    exact = getattr(exact_over(claim.measured_over), fit.quantity)
    error = np.abs(fit(interface) - exact) / (exact if claim.relative else 1.0)
    worst = np.unravel_index(np.argmax(error), error.shape)
    largest = float(error[worst])
    eta, kappa = (np.broadcast_to(x, error.shape)[worst] for x in (interface.eta, interface.kappa))
    assert 0.99 * claim.measured <= largest <= claim.measured * (1.0 + ROUNDING)
    assert eta == pytest.approx(claim.at[0], rel=0.03)
    assert kappa == pytest.approx(claim.at[1], rel=0.03)


@pytest.mark.parametrize("fit", FITS.values(), ids=FITS)
def test_a_fit_says_what_it_is(fit: Fit) -> None:
    assert fit.title
    assert fit.latex
    assert fit.reference
    assert fit.note
    assert fit.claims
    for claim in fit.claims:
        assert claim.source
        assert claim.measured > 0.0
        assert claim.domain.words
    for domain in fit.domains:
        assert fit.contains(domain.grid(5)).all()
        assert fit.reason_outside(domain.grid(5)) is None
    assert "eta" in (fit.reason_outside(Interface(1.0, 0.005, 90.0)) or "")


@pytest.mark.parametrize(("fit_id", "index", "figure"), PUBLISHED)
def test_figures_found_by_others(fit_id: str, index: int, figure: float) -> None:
    assert FITS[fit_id].claims[index].measured == pytest.approx(figure, rel=0.04)


def test_which_claims_hold() -> None:
    verdicts = {
        (fit.id, claim.domain.words): claim.holds
        for fit, claim in CLAIMS
        if claim.claimed is not None
    }
    assert verdicts == {
        ("deon_irving_2011", "1 <= eta <= 2, kappa = 0"): False,
        ("deon_irving_2011", "2 <= eta <= 10, kappa = 0"): False,
        ("egan_hilgeman_1973", "0.666667 <= eta <= 1, kappa = 0"): False,
        ("egan_hilgeman_1973", "0.5 <= eta <= 0.666667, kappa = 0"): True,
        ("egan_hilgeman_1973", "0.2 <= eta <= 0.5, kappa = 0"): True,
        ("deon_2019_rational", METALS.words): False,
        ("deon_2019_rg", METALS.words): False,
    }


def test_dunkle_has_its_limit_without_absorption() -> None:
    clear, dim = Interface(1.0, 1.5, 0.0), Interface(1.0, 1.5, 1e-7)
    for fit_id in ("dunkle_1963_s", "dunkle_1963_p"):
        assert float(FITS[fit_id](clear)) == pytest.approx(float(FITS[fit_id](dim)), rel=1e-12)


def test_egan_and_hilgeman_against_reciprocity() -> None:
    """Internal diffuse reflectance is 1 - (1 - A)/n^2 with A from outside."""
    n = np.linspace(1.05, 2.0, 20)
    internal = 1.0 - (1.0 - albedo(Interface(1.0, n)).unpolarized) / n**2
    fits = FITS["egan_hilgeman_1973"], FITS["deon_irving_2011_internal"]
    for fit in (*fits, FITS["kulla_conty_2017_internal"]):
        np.testing.assert_allclose(fit(Interface(n, 1.0)), internal, atol=0.005)


def test_outside_its_domain_a_fit_still_answers_without_a_warning() -> None:
    everywhere = Interface(
        1.0, np.geomspace(1e-3, 100.0, 30)[:, np.newaxis], np.array([0.0, 1e-9, 1.0, 100.0])
    )
    for fit in FITS.values():
        assert fit(everywhere).shape == (30, 4)


def test_an_unknown_fit_names_the_nearest() -> None:
    with pytest.raises(UnknownFit, match="deon_2019_log"):
        find_fit("deon_2019_lgo")
