"""`/snell`: one ray, against 30-digit values and in every corner."""

import cmath
from math import hypot, isclose
from typing import Any

import numpy as np
import pytest
from fastapi import FastAPI
from hypothesis import given
from hypothesis import strategies as st

from app.answers.interface import CONVENTION
from tests.api.raw import send
from tests.api.shape import Ask, check_shape, error_of, json_of
from tests.optics.reference.fresnel import fresnel

RELATIVE = 1e-12


def ray(ask: Ask, **query: Any) -> Any:
    return json_of(ask("/snell", **query))


@pytest.mark.parametrize(
    ("n_i", "n_t", "k_t", "theta_i_deg"),
    [
        (1.0, 1.5, 0.0, 64.0),
        (1.33, 1.5, 0.0, 30.0),
        (1.5, 1.0, 0.0, 41.0),
        (1.0, 0.2, 3.0, 70.0),
        (1.5, 3.0, 4.0, 15.0),
        (1.0, 1.0 + 1e-9, 0.0, 89.9),
        (1.0, 1e-3, 0.0, 0.05729577),
        (1e-3, 0.1, 0.1, 60.0),
    ],
)
def test_every_number_has_twelve_digits(
    ask: Ask, n_i: float, n_t: float, k_t: float, theta_i_deg: float
) -> None:
    told = ray(ask, n_i=n_i, n_t=n_t, k_t=k_t, theta_i_deg=theta_i_deg)
    expected = fresnel(n_i, n_t, k_t, theta_i_deg)
    for name in ("Rs", "Rp", "R", "Ts", "Tp", "T", "theta_t_deg"):
        assert isclose(told[name], getattr(expected, name), rel_tol=RELATIVE), name
    for name in ("r_s", "r_p", "t_s", "t_p"):
        value, amplitude = told[name], getattr(expected, name)
        assert cmath.isclose(complex(value["re"], value["im"]), amplitude, rel_tol=RELATIVE)
        assert isclose(value["abs"], abs(amplitude), rel_tol=RELATIVE)
        assert isclose(value["phase_deg"], np.degrees(cmath.phase(amplitude)), rel_tol=RELATIVE)
    if k_t > 0.0:
        assert isclose(told["penetration_depth_wavelengths"], expected.depth, rel_tol=RELATIVE)
        field = told["field_penetration_depth_wavelengths"]
        assert isclose(field, expected.field_depth, rel_tol=RELATIVE)


def test_nothing_given_is_air_to_glass_at_normal_incidence(ask: Ask) -> None:
    told = ray(ask)
    interface = told["interface"]
    assert (interface["n_i"], interface["n_t"], interface["k_t"]) == (1.0, 1.5, 0.0)
    assert told["theta_i_deg"] == 0.0
    assert told["theta_t_deg"] == 0.0
    assert (told["reflected"], told["refracted"]) == ([0.0, 1.0], [0.0, -1.0])
    assert told["R"] == pytest.approx(0.04, abs=1e-16)
    assert told["convention"] == CONVENTION
    assert told["penetration_depth_wavelengths"] is None
    assert told["field_penetration_depth_wavelengths"] is None
    assert told["total_internal_reflection"] is False


def test_the_ray_comes_from_the_upper_left(ask: Ask) -> None:
    told = ray(ask, n_t=1.5, theta_i_deg=30)
    x, y = told["reflected"]
    assert (x, y) == (pytest.approx(0.5), pytest.approx(np.sqrt(0.75)))
    x, y = told["refracted"]
    assert (x, y) == (pytest.approx(1 / 3), pytest.approx(-np.sqrt(8) / 3))


def test_the_interface_is_described(ask: Ask) -> None:
    interface = ray(ask, n_i=1.5, n_t=1.0)["interface"]
    assert interface["kind"] == "dielectric"
    assert interface["eta"] == 1.0 / 1.5
    assert interface["critical_deg"] == pytest.approx(41.810314895778596, abs=1e-13)
    assert interface["brewster_deg"] == pytest.approx(33.690067525979785, abs=1e-13)
    assert interface["pseudo_brewster_deg"] == interface["brewster_deg"]
    metal = ray(ask, n_i=1.0, n_t=1.5, k_t=5.0)["interface"]
    assert metal["kind"] == "conductor"
    assert (metal["brewster_deg"], metal["critical_deg"]) == (None, None)
    assert metal["pseudo_brewster_deg"] == pytest.approx(78.81728966778353, abs=1e-11)
    assert metal["F0"] == pytest.approx((0.25 + 25.0) / (6.25 + 25.0), abs=1e-15)


def test_at_the_principal_angle_the_phases_are_90_degrees_apart(ask: Ask) -> None:
    metal = {"n_i": 1.33, "n_t": 0.27, "k_t": 2.9}
    angle = ray(ask, **metal)["interface"]["principal_deg"]
    there = ray(ask, **metal, theta_i_deg=angle)
    apart = there["r_p"]["phase_deg"] - there["r_s"]["phase_deg"]
    assert apart % 180.0 == pytest.approx(90.0, abs=1e-9)
    assert there["interface"]["pseudo_brewster_deg"] != angle


def test_total_internal_reflection(ask: Ask) -> None:
    told = ray(ask, n_i=1.5, n_t=1.0, theta_i_deg=60)
    assert told["total_internal_reflection"] is True
    assert (told["theta_t_deg"], told["refracted"]) == (None, None)
    assert (told["Rs"], told["Rp"], told["R"]) == (1.0, 1.0, 1.0)
    assert (told["Ts"], told["Tp"], told["T"]) == (0.0, 0.0, 0.0)
    assert told["r_s"]["abs"] == pytest.approx(1.0, abs=1e-15)
    depth = 1.0 / (4.0 * np.pi * np.sqrt(1.5**2 * 0.75 - 1.0))
    assert told["penetration_depth_wavelengths"] == pytest.approx(depth, rel=1e-12)


@pytest.mark.parametrize(("crystal", "depth_um"), [(2.4, 2.01), (4.0, 0.66)])
def test_the_depth_of_the_field_is_that_of_ATR(ask: Ask, crystal: float, depth_um: float) -> None:
    """Zinc selenide or diamond, and germanium: 10 µm at 45 degrees on a sample of n = 1.5.

    The values that makers of ATR accessories print.
    """
    told = ray(ask, n_i=crystal, n_t=1.5, theta_i_deg=45)
    assert 10.0 * told["field_penetration_depth_wavelengths"] == pytest.approx(depth_um, abs=0.006)


def test_grazing_incidence(ask: Ask) -> None:
    told = ray(ask, theta_i_deg=90)
    assert (told["R"], told["T"]) == (1.0, 0.0)
    assert told["reflected"] == [1.0, 0.0]
    matched = ray(ask, n_t=1, theta_i_deg=90)
    assert (matched["R"], matched["T"], matched["theta_t_deg"]) == (0.0, 1.0, 90.0)


@pytest.mark.parametrize("digits", [3, 6, 16])
def test_digits_are_those_asked_for(ask: Ask, digits: int) -> None:
    full = ray(ask, n_t=1.37, k_t=0.3, theta_i_deg=37)
    short = ray(ask, n_t=1.37, k_t=0.3, theta_i_deg=37, digits=digits)
    for name in ("Rs", "Rp", "R", "T", "theta_t_deg", "penetration_depth_wavelengths"):
        assert short[name] == float(f"{full[name]:.{digits}g}")
    assert short["r_p"]["im"] == float(f"{full['r_p']['im']:.{digits}g}")


def test_seventeen_digits_are_the_doubles_themselves(ask: Ask) -> None:
    assert ray(ask, theta_i_deg=37, digits=17) == ray(ask, theta_i_deg=37)


def logarithmic(minimum: float, maximum: float) -> st.SearchStrategy[float]:
    powers = st.floats(np.log10(minimum), np.log10(maximum)).map(lambda x: float(10.0**x))
    return powers.map(lambda n: min(max(n, minimum), maximum))


@given(
    n_i=logarithmic(1e-3, 100.0),
    n_t=logarithmic(1e-3, 100.0),
    k_t=st.just(0.0) | logarithmic(1e-300, 100.0),
    theta_i_deg=st.sampled_from([0.0, 90.0]) | st.floats(0.0, 90.0),
)
def test_every_legal_query_is_answered_in_finite_numbers(
    app: FastAPI, n_i: float, n_t: float, k_t: float, theta_i_deg: float
) -> None:
    query = f"n_i={n_i!r}&n_t={n_t!r}&k_t={k_t!r}&theta_i_deg={theta_i_deg!r}"
    answer = send(app, f"/api/v1/snell?{query}".encode())
    assert answer.status == 200, answer.body
    told = answer.json()
    check_shape(app, "/api/v1/snell", told)
    assert (told["interface"]["n_t"], told["theta_i_deg"]) == (n_t, theta_i_deg)
    assert 0.0 <= told["R"] <= 1.0
    assert isclose(told["R"] + told["T"], 1.0, rel_tol=1e-13)
    assert (told["refracted"] is None) == told["total_internal_reflection"]
    for direction in (told["reflected"], told["refracted"] or [0.0, 1.0]):
        assert hypot(*direction) == pytest.approx(1.0, abs=1e-14)


def test_an_angle_in_radians(ask: Ask) -> None:
    for degrees, radians in ((0.0, 0.0), (90.0, np.pi / 2), (57.29577951308232, 1.0)):
        told, expected = ray(ask, theta_i_rad=radians), ray(ask, theta_i_deg=degrees)
        assert told["theta_i_deg"] == pytest.approx(degrees, rel=1e-15)
        assert told["Rp"] == pytest.approx(expected["Rp"], rel=RELATIVE)
    error = error_of(ask("/snell", theta_i_rad=1.0, theta_i_deg=60))
    assert error["parameter"] == "theta_i_deg"
    assert error_of(ask("/snell", theta_i_rad=60))["parameter"] == "theta_i_rad"
