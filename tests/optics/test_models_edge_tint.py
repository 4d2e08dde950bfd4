"""Reflectance and edge tint: the exact curve with other parameters, and the way back."""

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.optics.edge_tint import (
    deon_G,
    deon_index,
    gulbrandsen_g,
    gulbrandsen_index,
    relative_interface,
)
from app.optics.errors import OutOfRange
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.registry import default_registry
from tests.optics.test_models_approximations import METALS

ANGLES_DEG = np.linspace(0.0, 90.0, 19)
TOLERANCE = 1e-9
INTERFACES = [(1.0, 1.5, 0.0), *METALS]
BELOW_ONE = [(1.5, 1.0, 0.0), (1.0, 0.5, 0.3), (1.0, 0.05, 0.4)]


def printed_gulbrandsen(r: float, g: float) -> tuple[float, float]:
    """Formulas.md: n = g n_min + (1 - g) n_max, k^2 = (r (n + 1)^2 - (n - 1)^2)/(1 - r)."""
    with mp.workdps(30):
        R, G = mp.mpf(r), mp.mpf(g)
        n = G * (1 - R) / (1 + R) + (1 - G) * (1 + mp.sqrt(R)) / (1 - mp.sqrt(R))
        k2 = (R * (n + 1) ** 2 - (n - 1) ** 2) / (1 - R)
        return float(n), float(mp.sqrt(max(k2, mp.mpf(0))))


def printed_deon(r: float, G: float) -> tuple[float, float]:
    """The notebook's nmaprG, and k from the circle of equal reflectance."""
    with mp.workdps(30):
        R, half = mp.mpf(r), mp.pi * mp.mpf(G) / 2
        n = (-1 + (2 - 4 * (1 - mp.sin(half) ** 2)) * mp.sqrt(R) - R) / (-1 + R)
        k2 = (R * (n + 1) ** 2 - (n - 1) ** 2) / (1 - R)
        return float(n), float(mp.sqrt(max(k2, mp.mpf(0))))


def gmap(n: float, k: float) -> float:
    """The notebook's inverse: G = 2 arcsin(sqrt(gmap)) / pi."""
    with mp.workdps(40):
        N, K = mp.mpf(n), mp.mpf(k)
        root = mp.sqrt((1 + K**2) ** 2 + 2 * (-1 + K**2) * N**2 + N**4)
        g = 1 - (-1 - K**2 + N**2 + root) / (2 * root)
        return float(2 * mp.asin(mp.sqrt(min(max(g, mp.mpf(0)), mp.mpf(1)))) / mp.pi)


@pytest.mark.parametrize("media", INTERFACES + BELOW_ONE)
@pytest.mark.parametrize("model_id", ["gulbrandsen_rg", "deon_rg"])
def test_defaults_are_the_exact_curve(model_id: str, media: tuple[float, float, float]) -> None:
    registry, incidence = default_registry(), Incidence.from_degrees(ANGLES_DEG)
    interface = Interface(*media)
    values = registry[model_id](interface, incidence)
    # Without absorption and |N| < n_i Gulbrandsen's kappa is the root of a rounded 0.
    tolerance = 1e-6 if model_id == "gulbrandsen_rg" and media in BELOW_ONE else TOLERANCE
    np.testing.assert_allclose(values, registry["exact"](interface, incidence), atol=tolerance)


@pytest.mark.parametrize("r", [0.02, 0.3, 0.9])
@pytest.mark.parametrize("tint", [0.0, 0.25, 0.6, 1.0])
def test_given_parameters_mean_the_printed_index(r: float, tint: float) -> None:
    registry, incidence = default_registry(), Incidence.from_degrees(ANGLES_DEG)
    for model_id, name, printed in (
        ("gulbrandsen_rg", "g", printed_gulbrandsen),
        ("deon_rg", "G", printed_deon),
    ):
        n, k = printed(r, tint)
        expected = registry["complex_form"](Interface(1.0, n, k), incidence)
        values = registry[model_id](Interface(), incidence, **{"r": r, name: tint})
        np.testing.assert_allclose(values, expected, atol=TOLERANCE)


def test_gulbrandsen_says_where_its_tint_ends() -> None:
    model = default_registry()["gulbrandsen_rg"]
    for media in BELOW_ONE:
        assert "|N| < n_i" in (model.reason_outside(Interface(*media)) or "")
        assert float(model.arguments(Interface(*media))["g"]) > 1.0
    with pytest.raises(OutOfRange, match=r"gulbrandsen_rg\.g"):
        model(Interface(), Incidence.from_degrees(0.0), g=1.1)


reflectances = st.floats(1e-6, 0.999)
tints = st.floats(0.0, 1.0)


@given(reflectances, tints)
def test_gulbrandsen_there_and_back(r: float, g: float) -> None:
    eta, kappa = gulbrandsen_index(np.asarray(r), np.asarray(g))
    F0 = ((eta - 1.0) ** 2 + kappa**2) / ((eta + 1.0) ** 2 + kappa**2)
    assert float(F0) == pytest.approx(r, rel=1e-9)
    assert float(gulbrandsen_g(eta, np.asarray(r))) == pytest.approx(g, abs=1e-9)
    assert eta**2 + kappa**2 >= 1.0 - 1e-9


@given(reflectances, tints)
def test_deon_there_and_back(r: float, G: float) -> None:
    eta, kappa = deon_index(np.asarray(r), np.asarray(G))
    F0 = ((eta - 1.0) ** 2 + kappa**2) / ((eta + 1.0) ** 2 + kappa**2)
    assert float(F0) == pytest.approx(r, rel=1e-9)
    assert float(deon_G(eta, kappa, np.asarray(r))) == pytest.approx(G, abs=1e-7)
    assert float(deon_G(eta, kappa, np.asarray(r))) == pytest.approx(
        gmap(float(eta), float(kappa)), abs=1e-6
    )


@given(st.floats(0.01, 50.0), st.floats(0.0, 50.0))
def test_an_index_there_and_back_by_deon(n: float, k: float) -> None:
    interface = Interface(1.0, n, k)
    G = deon_G(interface.eta, interface.kappa, interface.F0)
    eta, kappa = deon_index(interface.F0, G)
    assert abs(complex(eta - n, kappa - k)) <= 1e-8 * max(n, k, 1.0) ** 2


def test_no_boundary_has_no_tint() -> None:
    one, nothing = np.asarray(1.0), np.asarray(0.0)
    assert float(gulbrandsen_g(one, nothing)) == 0.0
    assert float(deon_G(one, nothing, nothing)) == 0.0
    assert [float(x) for x in deon_index(nothing, nothing)] == [1.0, 0.0]


def test_indices_beyond_the_bounds_are_scaled() -> None:
    for eta, kappa in ((4e4, 1.0), (2e-5, 0.0), (0.5, 300.0)):
        scaled = relative_interface(np.asarray(eta), np.asarray(kappa))
        assert float(scaled.eta) == pytest.approx(eta, rel=1e-12)
        assert float(scaled.kappa) == pytest.approx(kappa, rel=1e-12)
