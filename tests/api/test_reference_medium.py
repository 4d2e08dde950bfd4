"""Glass in air and glass in vacuum, and what answers say of what n was measured against."""

import csv
import io

import numpy as np
import pytest

from tests.api.shape import Ask, json_of

D_LINE = 587.5618
N_BK7 = 1.5168000  # Schott's data sheet
AIR = 1.00027717  # Ciddor's standard air at this wavelength


def normal(eta: float) -> float:
    return ((eta - 1.0) / (eta + 1.0)) ** 2


def test_glass_in_air_is_the_glass_of_the_catalog(ask: Ask) -> None:
    into = json_of(ask("/snell", material="BK7", incident="air", wavelength_nm=D_LINE))["interface"]
    assert into["F0"] == pytest.approx(0.0421646, abs=5e-8)
    back = json_of(ask("/snell", material="air", incident="BK7", wavelength_nm=D_LINE))["interface"]
    assert back["F0"] == pytest.approx(0.0421646, abs=5e-8)
    assert back["critical_deg"] == pytest.approx(41.2452, abs=5e-5)


def test_glass_in_vacuum_is_denser_than_in_air(ask: Ask) -> None:
    told = json_of(ask("/snell", material="BK7", wavelength_nm=D_LINE))["interface"]
    assert told["n_t"] == pytest.approx(N_BK7 * AIR, abs=5e-8)
    assert told["F0"] == pytest.approx(normal(N_BK7 * AIR), abs=5e-8)
    # With the thinner air of a warm laboratory, 1.000271 at 21.5 °C, it is 0.0422179.
    assert told["F0"] == pytest.approx(0.0422179, abs=1.3e-6)


@pytest.mark.parametrize(
    ("id", "relative_to", "wavelength_in"),
    [
        ("BK7", "air", "air"),
        ("water", "vacuum", "vacuum"),
        ("He", "vacuum", None),
        ("Au", None, None),
        ("water-shirley", None, None),
        ("air-wloka", "vacuum", None),
    ],
)
def test_answers_say_what_n_is_relative_to(
    ask: Ask,
    id: str,  # noqa: A002
    relative_to: str | None,
    wavelength_in: str | None,
) -> None:
    told = json_of(ask("/snell", material=id))["interface"]
    detail = json_of(ask(f"/materials/{id}"))
    listed = next(m for m in json_of(ask("/materials"))["materials"] if m["id"] == id)
    for one in (told["material"], detail, listed):
        assert (one["relative_to"], one["wavelength_in"]) == (relative_to, wavelength_in)
        factor = AIR if relative_to == "air" else 1.0
        assert one["n_absolute"] == pytest.approx(one["n"] * factor, rel=1e-7)
    assert told["n_t"] == told["material"]["n_absolute"]
    assert told["F0"] == pytest.approx(listed["F0"], rel=1e-9)
    constants = detail["constants"]
    if not constants["k"]:
        assert constants["F0"] == pytest.approx(normal(constants["n_absolute"]), rel=1e-9)


def test_a_spectrum_has_both(ask: Ask) -> None:
    path = "/materials/BK7/spectrum"
    query = {"minimum_nm": 400, "maximum_nm": 700, "step_nm": 100}
    told = json_of(ask(path, **query))
    assert told["material"]["relative_to"] == "air"
    n, absolute = np.array(told["n"]), np.array(told["n_absolute"])
    assert n[1] == pytest.approx(1.52141, abs=5e-6)  # the data sheet at 500 nm
    np.testing.assert_allclose(absolute / n, 1.000278, rtol=0, atol=6e-6)
    np.testing.assert_allclose(told["F0"], [normal(one) for one in absolute], rtol=1e-6)
    rows = list(csv.DictReader(io.StringIO(ask(path, **query, format="csv").text)))
    assert list(rows[0]) == ["wavelength_nm", "n", "n_absolute", "k", "F0"]
    assert [float(row["n_absolute"]) for row in rows] == told["n_absolute"]
    assert json_of(ask("/materials/water/spectrum"))["n_absolute"] is None


def test_curves_and_maps_in_air_take_the_catalog_index(ask: Ask) -> None:
    query = {"incident": "air", "wavelengths_nm": D_LINE, "samples": 2, "models": "exact"}
    told = json_of(ask("/materials/BK7/curves", **query))
    single = told["wavelengths"][0]
    assert single["F0"] == pytest.approx(0.0421646, abs=5e-8)
    assert single["n"] / single["n_i"] == pytest.approx(N_BK7, abs=5e-8)
    exact = told["rgb"]["curves"][1]["inputs"]
    mean = np.divide(exact["n"], exact["n_i"])  # red, green and blue lie around the d line
    assert mean[0] < N_BK7 < mean[1] < mean[2]
    query = {"incident": "air", "minimum_nm": D_LINE, "maximum_nm": D_LINE, "steps": 2}
    grid = json_of(ask("/materials/BK7/map", **query, samples=2))
    assert grid["values"][0][0] == pytest.approx(0.0421646, abs=5e-8)


def test_steel_says_which_steel(ask: Ask) -> None:
    told = json_of(ask("/snell", material="steel"))["interface"]["material"]
    assert (told["id"], told["name"]) == ("stainless", "Stainless steel, austenitic")
    assert (
        "Carbon steel is not in the catalog; it is mostly iron: see Fe."
        in json_of(ask("/materials/steel"))["note"]
    )


def test_a_film_of_the_glass_it_lies_on_is_not_seen(ask: Ask) -> None:
    query = {"incident": "air", "wavelength_nm": D_LINE, "layers": "BK7:123"}
    told = json_of(ask("/snell", material="BK7", theta_i_deg=0, **query))
    assert told["R"] == pytest.approx(0.0421646, abs=5e-8)
    # A quarter wave of 1.5168 in air before a glass of n, by the closed form of a quarter wave.
    thickness = D_LINE / (4.0 * N_BK7 * AIR)
    query |= {"layers": f"BK7:{thickness!r}"}
    told = json_of(ask("/snell", n_t=2.0 * AIR, theta_i_deg=0, **query))
    assert told["R"] == pytest.approx(normal(N_BK7**2 / 2.0), abs=1e-7)
