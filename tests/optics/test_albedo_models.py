"""Albedo of any registered model."""

import numpy as np
import pytest

from app.optics.albedo import FITS, albedo, model_albedo
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.registry import Model, default_registry


def test_dunkle_is_exact_for_pharr_and_humphreys() -> None:
    metals = Interface(1.0, np.geomspace(0.05, 10.0, 9)[:, np.newaxis], np.linspace(0.5, 9.0, 7))
    curve = model_albedo(default_registry()["pharr_humphreys"], metals)
    np.testing.assert_allclose(FITS["dunkle_1963"](metals), curve, rtol=1e-11)


@pytest.mark.parametrize(
    ("fit_id", "model_id"),
    [
        ("schlick", "schlick"),
        ("schlick_nk", "schlick_ior"),
        ("f82_tint", "f82_tint"),
        ("f82_tint", "hoffman_f82"),
    ],
)
@pytest.mark.parametrize("interface", [Interface(1.2, 0.2, 3.0), Interface(1.0, 3.9, 7.9)])
def test_averages_are_exact_for_their_own_curves(
    fit_id: str, model_id: str, interface: Interface
) -> None:
    curve = model_albedo(default_registry()[model_id], interface)
    assert float(FITS[fit_id](interface)) == pytest.approx(float(curve), rel=1e-11)


@pytest.mark.parametrize("model", default_registry().values(), ids=default_registry())
def test_albedo_of_every_model(model: Model) -> None:
    """Exact forms have the exact albedo where they are defined at every angle."""
    for interface in (Interface(1.0, 1.5), Interface(1.5, 1.0), Interface(1.0, 0.2, 3.0)):
        if model.reason_outside(interface) is not None:
            continue
        beyond_critical = model(interface, Incidence.from_degrees(80.0))
        found = float(model_albedo(model, interface))
        assert np.isnan(found) == np.isnan(beyond_critical)
        if model.kind == "exact" and np.isfinite(found):
            assert found == pytest.approx(float(albedo(interface).unpolarized), rel=1e-10)


def test_albedo_of_a_curve_that_is_cut_at_zero() -> None:
    model = default_registry()["f82_tint"]
    for interface in (Interface(), Interface(1.0, 0.2, 3.0)):
        # Both by mpmath in 30 digits, split where the curve meets 0.
        cut = model_albedo(model, interface, F0=[0.1, 0.9, 0.3], tint=[0.0, 1.0, 0.0])
        expected = [0.0782547322684958, 0.9 + 0.1 / 21.0, 0.247641533084732]
        np.testing.assert_allclose(cut, expected, rtol=0.0, atol=1e-13)
    faint = Interface(1.0, np.array([1.02, 1.5, 1.05]))
    together = model_albedo(model, faint)
    alone = [float(model_albedo(model, Interface(1.0, n))) for n in (1.02, 1.5, 1.05)]
    np.testing.assert_allclose(together, alone, rtol=0.0, atol=1e-13)


def test_a_model_takes_its_parameters() -> None:
    table = default_registry()["lut_1d"]
    glass = Interface(n_t=1.5)
    exact = float(albedo(glass).unpolarized)
    coarse, fine = (float(model_albedo(table, glass, size=size)) - exact for size in (8, 1024))
    assert 0.0 < fine < 1e-5 < coarse
