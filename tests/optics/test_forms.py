"""All exact forms are one function: they agree wherever they claim to be defined."""

from functools import cache
from typing import NamedTuple

import numpy as np
import pytest
from numpy.typing import NDArray

from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.registry import Model, default_registry

Array = NDArray[np.float64]

# Where no quotient nears 0/0 and no root its branch point, textbook forms keep all but 3 digits.
WELL_CONDITIONED = 1e-12
# Elsewhere - matched indices, the critical angle, grazing incidence, faint absorption - a root of a
# rounded difference is left, and with it half of a double's digits.
ANYWHERE = 1e-7
# A form that is off by more than this, relative to a small R, has to say so.
ADMITTED = 1e-6

EXACT = default_registry()["exact"]
FORMS = [
    model for model in default_registry().values() if model.kind == "exact" and model is not EXACT
]


def identify(model: Model) -> str:
    return model.id


class Rays(NamedTuple):
    interface: Interface
    incidence: Incidence

    @property
    def beyond_critical(self) -> NDArray[np.bool_]:
        beyond = self.incidence.sin > self.interface.eta
        return np.asarray(beyond & (self.interface.k_t == 0.0))


@cache
def rays(kind: str) -> Rays:
    """400 interfaces by 60 angles, a quarter of them with nearly matched indices."""
    rng = np.random.default_rng(7)
    n_i = np.exp(rng.uniform(np.log(0.1), np.log(10.0), (400, 1)))
    eta = np.exp(rng.uniform(np.log(1e-3), np.log(100.0), n_i.shape))
    eta[:100] = 1.0 + rng.choice([-1.0, 1.0], (100, 1)) * 10.0 ** rng.uniform(-9.0, -1.0, (100, 1))
    k_t = np.exp(rng.uniform(np.log(1e-9), np.log(100.0), n_i.shape))
    theta = np.concatenate(
        [[0.0, 1e-9, 1e-3, 45.0, 89.999, 90.0 - 1e-9, 90.0], rng.uniform(0.0, 90.0, 53)]
    )
    n_t = np.clip(eta * n_i, 1e-3, 100.0)
    interface = Interface(n_i, n_t, k_t if kind == "conductor" else 0.0)
    return Rays(interface, Incidence.from_degrees(theta))


@cache
def expected(kind: str) -> Array:
    return EXACT(*rays(kind))


@cache
def is_well_conditioned(kind: str) -> NDArray[np.bool_]:
    interface, incidence = rays(kind)
    eta, kappa = interface.eta, interface.kappa
    critical = np.arcsin(np.minimum(eta, 1.0))
    contrast = (eta > 0.2) & (eta < 5.0) & ((eta < 0.9) | (eta > 1.1))
    angle = (incidence.theta_i_deg < 89.9) & (np.abs(incidence.theta_i - critical) > 1e-3)
    return np.asarray(contrast & angle & ((kappa == 0.0) | (kappa > 1e-2)))


@cache
def inside(model: Model, kind: str) -> NDArray[np.bool_]:
    """Which interfaces the model says it is made for, one by one, shape (400, 1)."""
    interface = rays(kind).interface
    n_i, n_t, k_t = np.broadcast_arrays(interface.n_i, interface.n_t, interface.k_t)
    indices = zip(n_i.flat, n_t.flat, k_t.flat, strict=True)
    reasons = [model.reason_outside(Interface(*index)) for index in indices]
    return np.array([[reason is None] for reason in reasons])


CASES = [(model, kind) for model in FORMS for kind in model.applies_to]
over_forms = pytest.mark.parametrize(
    ("model", "kind"), CASES, ids=[f"{model.id}-{kind}" for model, kind in CASES]
)


@over_forms
def test_forms_agree_within_their_domain(model: Model, kind: str) -> None:
    error = np.where(inside(model, kind), np.abs(model(*rays(kind)) - expected(kind)), 0.0)
    assert np.nanmax(error) < ANYWHERE
    assert np.nanmax(error[is_well_conditioned(kind)]) < WELL_CONDITIONED


@over_forms
def test_forms_are_undefined_only_where_they_say_so(model: Model, kind: str) -> None:
    R = model(*rays(kind))
    excused = np.zeros_like(R, dtype=bool)
    if "undefined beyond" in model.validity:
        assert np.isnan(R[rays(kind).beyond_critical]).all()
        excused |= rays(kind).beyond_critical
    if "undefined at 90 degrees" in model.validity:
        grazing = np.broadcast_to(rays(kind).incidence.cos == 0.0, R.shape)
        assert np.isnan(R[grazing]).all()
        excused |= grazing
    assert not np.isnan(R[~excused & inside(model, kind)]).any()


@pytest.mark.parametrize("model", FORMS, ids=identify)
def test_a_form_that_loses_digits_says_so(model: Model) -> None:
    nearly_matched = Interface(1.0, [[1.0 + 1e-7], [1.0 + 1e-4]])
    incidence = Incidence.from_degrees([0.0, 10.0, 40.0, 70.0])
    R, small = model(nearly_matched, incidence), EXACT(nearly_matched, incidence)
    if np.max(np.abs(R / small - 1.0)) > ADMITTED:
        assert "loses digits" in model.validity


@pytest.mark.parametrize("model_id", ["wloka_sin_tan", "wloka_eq6"])
def test_wlokas_limit_at_normal_incidence_is_what_the_formula_tends_to(model_id: str) -> None:
    model = default_registry()[model_id]
    R = model(Interface(1.0, [[1.33], [2.4]]), Incidence.from_degrees([0.0, 1e-3]))
    assert np.allclose(R[:, 0], [(0.33 / 2.33) ** 2, (1.4 / 3.4) ** 2], rtol=1e-12)
    assert np.allclose(R[:, 0], R[:, 1], rtol=1e-8)


def test_every_form_named_in_the_four_sources_is_registered() -> None:
    named = (
        "exact cos_form lagarde_dielectric lagarde_gc lagarde_conductor wloka_sin_tan wloka_eq6 "
        "wloka_gc deon_gc deon_pq shirley_ab complex_form"
    )
    assert set(default_registry()) >= set(named.split())


POLARIZED = [model for model in FORMS if model.polarized is not None]


def test_every_exact_form_tells_s_and_p_apart() -> None:
    assert [model.id for model in POLARIZED] == [model.id for model in FORMS]
    others = {model.id for model in default_registry().values() if model.polarized} - {
        model.id for model in [EXACT, *FORMS]
    }
    assert others == {"pharr_humphreys"}


@pytest.mark.parametrize("model", [EXACT, *POLARIZED], ids=identify)
def test_rs_and_rp_are_those_of_fresnel(model: Model) -> None:
    """At well conditioned rays, against the quotients in complex arithmetic written out here."""
    kind = "dielectric" if "conductor" not in model.applies_to else "conductor"
    interface, incidence = rays(kind)
    N, s = (interface.n_t + 1j * interface.k_t) / interface.n_i, incidence.sin
    q = np.sqrt(N**2 - s**2)
    Rs = np.abs((incidence.cos - q) / (incidence.cos + q)) ** 2
    Rp = np.abs((N**2 * incidence.cos - q) / (N**2 * incidence.cos + q)) ** 2
    arguments = model.arguments(interface)
    ours = model.evaluate_polarized(interface, incidence, arguments)
    fine = is_well_conditioned(kind) & np.isfinite(ours[0])
    assert fine.sum() > 1000
    for value, expected_ in zip(ours, (Rs, Rp), strict=True):
        np.testing.assert_allclose(value[fine], expected_[fine], rtol=1e-9, atol=1e-12)
    R = model.evaluate(interface, incidence, arguments)
    np.testing.assert_allclose(0.5 * (ours[0] + ours[1])[fine], R[fine], rtol=1e-13)
