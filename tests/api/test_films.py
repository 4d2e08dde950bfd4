"""Films in the API: `layers`, psi and delta, and the convention that every answer states."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from fastapi import FastAPI

from app.answers.films import convention_text
from app.answers.interface import CONVENTION
from app.materials.films import read_layers
from app.materials.own.token import OwnData, write
from app.materials.schema import Points
from tests.api.raw import send
from tests.api.shape import Ask, error_of, json_of

GOLDEN: list[dict[str, Any]] = json.loads(
    (Path(__file__).parents[1] / "optics" / "reference" / "films.json").read_text("utf-8")
)["cases"]
RELATIVE = 1e-12
COATED = [case for case in GOLDEN if case["layers"]]


def written(case: dict[str, Any]) -> dict[str, Any]:
    """The query of a reference stack."""
    layers = ",".join(
        f"{layer['n']!r}+{layer['k']!r}i:{layer['thickness_nm']!r}"
        if layer["k"]
        else f"{layer['n']!r}:{layer['thickness_nm']!r}"
        for layer in case["layers"]
    )
    names = ("n_i", "n_t", "k_t", "theta_i_deg", "wavelength_nm")
    return {name: case[name] for name in names} | {"layers": layers}


@pytest.mark.parametrize("case", COATED, ids=[str(i) for i in range(len(COATED))])
def test_one_ray_has_the_reference_values(ask: Ask, case: dict[str, Any]) -> None:
    told = json_of(ask("/snell", **written(case)))
    for name in ("Rs", "Rp", "Ts", "Tp", "As", "Ap", "psi_deg"):
        assert told[name] == pytest.approx(float(case[name]), rel=RELATIVE, abs=1e-25), name
    assert sum(told["absorbed"]) == pytest.approx(told["A"], rel=RELATIVE)
    assert len(told["layers"]) == len(told["absorbed"]) == len(case["layers"])
    assert told["wavelength_nm"] == case["wavelength_nm"]
    off = (told["delta_deg"] - float(case["delta_deg"]) + 180.0) % 360.0 - 180.0
    assert off == pytest.approx(0.0, abs=RELATIVE * 180.0)


def test_the_convention_is_that_of_always() -> None:
    assert convention_text() == CONVENTION


def test_bare_silicon_as_ellipsometers_print_it(ask: Ask) -> None:
    """psi 10.57788; delta -179.20608 in exp(-iwt), +179.20608 as ellipsometers print it."""
    silicon = {"n_t": 3.8827, "k_t": 0.0196, "theta_i_deg": 70.0}
    for convention, sign, delta in (("exp(-iwt)", "+", -179.20608), ("exp(+iwt)", "-", 179.20608)):
        told = json_of(ask("/snell", convention=convention, **silicon))
        assert round(told["psi_deg"], 5) == 10.57788
        assert round(told["delta_deg"], 5) == delta
        assert f"N = n_t {sign} i k_t" in told["convention"]
        assert told["r_s"]["phase_deg"] * np.sign(delta) > 0.0
    told = json_of(ask("/snell", r_p_at_normal="r_s", **silicon))
    assert round(told["delta_deg"], 5) == 0.79392
    assert "r_p = r_s at normal incidence" in told["convention"]


def test_a_plus_may_be_spelled_as_it_is(app: FastAPI, ask: Ask) -> None:
    target = b"/api/v1/snell?layers=0.055+3.32i:30&convention=exp(+iwt)&theta_i_deg=40"
    plain = send(app, target).json()
    encoded = ask("/snell", layers="0.055+3.32i:30", convention="exp(+iwt)", theta_i_deg=40)
    assert plain == json_of(encoded)
    assert plain["layers"][0]["medium"] == "0.055+3.32i"


def test_curves_have_what_is_absorbed(ask: Ask) -> None:
    told = json_of(ask("/curves", layers="Ag:30", material="BK7", samples=31, ellipsometry="true"))
    values = {curve["quantity"]: np.array(curve["values"]) for curve in told["curves"]}
    assert list(values) == ["R", "Rs", "Rp", "T", "A", "psi_deg", "delta_deg"]
    np.testing.assert_allclose(values["R"] + values["T"] + values["A"], 1.0, atol=1e-13)
    (layer,) = told["layers"]
    assert (layer["material"]["id"], layer["thickness_nm"], layer["incoherent"]) == (
        "Ag",
        30,
        False,
    )
    ray = json_of(ask("/snell", layers="Ag:30", material="BK7", theta_i_deg=60))
    for name in ("R", "Rs", "Rp", "T", "A", "psi_deg", "delta_deg"):
        assert values[name][20] == pytest.approx(ray[name], rel=RELATIVE), name


def test_a_pane_has_powers_but_no_phases(ask: Ask) -> None:
    pane = {"layers": "1.5:3000000:incoherent", "n_t": 1}
    told = json_of(ask("/snell", **pane))
    assert told["R"] == pytest.approx(2 * 0.04 / 1.04, rel=RELATIVE)
    assert [told[name] for name in ("r_s", "t_p", "psi_deg", "delta_deg")] == [None] * 4
    error = error_of(ask("/curves", phase="true", **pane))
    assert error["parameter"] == "phase"
    assert "no amplitudes and no phases" in error["message"]


def test_a_weakly_absorbing_preset_absorbs_in_a_thick_layer(ask: Ask) -> None:
    """N-BK7 with k = 9.75e-9 absorbs 4 pi k d / wavelength of what passes 3 mm."""
    told = json_of(ask("/snell", layers="BK7:3000000:incoherent", n_t=1))
    k = told["layers"][0]["k"]
    assert told["A"] == pytest.approx(4 * np.pi * k * 3e6 / 587.6, rel=0.01)


@pytest.mark.parametrize(
    ("layers", "told"),
    [
        ("1.38", "MEDIUM:NM"),
        ("1.38:", "MEDIUM:NM"),
        (":100", "MEDIUM:NM"),
        ("1.38:100,,2.35:50", "MEDIUM:NM"),
        ("1.38:100:thick", "MEDIUM:NM"),
        ("1.38:-5", "a thickness that is a finite number from 0"),
        ("1.5-0.1i:30", "for n - i k give 1.5+0.1i"),
        ("0:100", "an index whose n is"),
        ("Mgf2:100,goldd:5", "nearest: Au"),
        ("vacuum-wloka2005-air:3", "nearest"),
        ("1.5+0.5i:1000:incoherent", "at most 0.01 n"),
        ("1.5:1e9nm", "MEDIUM:NM"),
    ],
)
def test_what_is_no_layer_is_refused_by_its_name(ask: Ask, layers: str, told: str) -> None:
    error = error_of(ask("/snell", layers=layers))
    assert error["parameter"] == "layers"
    assert told in error["message"]


def test_too_many_layers_are_refused(ask: Ask) -> None:
    error = error_of(ask("/snell", layers=",".join(["1.5:1"] * 1001)))
    assert (error["parameter"], error["message"]) == ("layers", "at most 1000")


def test_no_other_model_knows_films(ask: Ask) -> None:
    error = error_of(ask("/curves", layers="1.38:100", models="exact,schlick"))
    assert (error["parameter"], error["value"]) == ("models", "schlick")


def test_a_layer_is_spelled_as_it_can_be_read() -> None:
    text = "MgF2:99.6,0.055+3.32i:30,BK7:3e6:incoherent,rii:main/Ag/Johnson:20,own:abc:5"
    films = read_layers(text)
    assert [film.medium for film in films] == [
        "MgF2", "0.055+3.32i", "BK7", "rii:main/Ag/Johnson", "own:abc",
    ]  # fmt: skip
    assert read_layers(",".join(film.spelled for film in films)) == films


def test_a_table_of_a_coated_surface(ask: Ask) -> None:
    told = json_of(ask("/lut", layers="MgF2:99.6", material="BK7", size=64, wavelength_nm=550))
    assert told["layers"][0]["material"]["id"] == "MgF2-o"
    mu = np.linspace(0.0, 1.0, 64)
    for j in (0, 20, 63):
        ray = ask(
            "/snell",
            layers="MgF2:99.6",
            material="BK7",
            wavelength_nm=550,
            theta_i_deg=np.degrees(np.arccos(mu[j])),
        )
        assert told["texels"][j] == pytest.approx(json_of(ray)["R"], rel=1e-7)
    assert 0.0 < told["error"]["max_abs"] < 0.01
    assert error_of(ask("/lut", layers="1.38:100", over="mu,n_t"))["parameter"] == "over"
    assert error_of(ask("/lut", layers="1.38:100", model="schlick"))["parameter"] == "model"


@pytest.mark.parametrize("layers", ["MgF2:99.6", "MgF2:99.6,Ag:12", "BK7:1000000:incoherent"])
def test_a_table_of_colors_is_that_of_the_films(ask: Ask, layers: str) -> None:
    """Between its texels too, to the error that it states: what /films/color has is the referee."""
    query = {"material": "Al", "layers": layers}
    told = json_of(ask("/lut", channels=3, size=33, **query))
    assert told["channels"] == ["red", "green", "blue"]
    assert told["media"]["layers"][0]["medium"] in layers
    mu = np.linspace(0.0, 1.0, 12)
    nm = layers.split(",")[0].split(":")[1]
    angles = ",".join(f"{angle:.17g}" for angle in np.degrees(np.arccos(mu)))
    colors = json_of(ask("/films/color", thickness_nm=nm, theta_i_deg=angles, **query))["colors"]
    at = np.linspace(0.0, 1.0, 33)
    texels = np.array(told["texels"])
    read = np.stack([np.interp(mu, at, channel) for channel in texels.T], axis=-1)
    off = np.abs(read - np.array(colors[0]["linear_srgb"][0]))
    assert off.max() <= told["error"]["max_abs"] < 0.2
    assert off[[0, -1]].max() < 1e-6


def test_what_a_table_of_colors_cannot_be_is_refused(ask: Ask) -> None:
    for name, value in (("wavelength_nm", 550), ("model", "schlick"), ("over", "mu,n_t")):
        query = {"layers": "1.38:100", "channels": 3, name: value}
        assert error_of(ask("/lut", **query))["parameter"] == name
    assert error_of(ask("/lut", channels=3))["parameter"] == "channels"


@pytest.mark.parametrize(
    ("path", "query"),
    [
        ("/lut", {"channels": 3, "layers": ",".join(["1.38:100"] * 51)}),
        ("/lut", {"channels": 3, "size": 4096, "layers": ",".join(["1.38:100"] * 4)}),
        (
            "/films/color",
            {"samples": 2000, "thickness_nm": 5, "layers": ",".join(["1.5"] + ["2:60"] * 100)},
        ),
        (
            "/films/color",
            {
                "samples": 61,
                "thickness_nm": "0..100:64",
                "quantity": "T",
                "layers": ",".join(["1.5"] + ["2:60"] * 60),
            },
        ),
    ],
)
def test_more_layers_than_there_is_time_for_are_refused(
    ask: Ask, path: str, query: dict[str, object]
) -> None:
    assert error_of(ask(path, **query))["parameter"] == "layers"


def test_mueller_and_jones_of_one_surface(ask: Ask) -> None:
    """Light polarized at 45 degrees, reflected by a coated mirror, in both conventions."""
    query = {"layers": "SiO2:100", "material": "Al", "theta_i_deg": 60, "stokes": "1,0,1,0"}
    minus, plus = (
        json_of(ask("/polarization", convention=c, **query)) for c in ("exp(-iwt)", "exp(+iwt)")
    )
    ray = json_of(ask("/snell", layers="SiO2:100", material="Al", theta_i_deg=60))
    np.testing.assert_allclose(
        minus["reflection"]["mueller"], plus["reflection"]["mueller"], atol=1e-15
    )
    assert minus["reflection"]["mueller"][0][0] == pytest.approx(ray["R"], rel=1e-12)
    assert minus["transmission"]["mueller"][0][0] == pytest.approx(ray["T"], rel=1e-12)
    r_p = minus["reflection"]["jones"][0][0]
    assert (r_p["re"], r_p["im"]) == (ray["r_p"]["re"], ray["r_p"]["im"])
    assert plus["reflection"]["jones"][0][0]["im"] == -r_p["im"]
    beam = minus["reflection"]["beam"]
    assert beam["degree_of_polarization"] == pytest.approx(1.0)
    # S3 / S2 is the tangent of delta, with the hand that E_p E_s* has in exp(-iwt).
    assert np.degrees(np.arctan2(*beam["stokes"][:1:-1])) == pytest.approx(ray["delta_deg"])


def test_unpolarized_light_is_polarized_at_brewsters_angle(ask: Ask) -> None:
    told = json_of(ask("/polarization", n_t=1.5, theta_i_deg=56.309932474020215))
    assert told["reflection"]["beam"]["degree_of_polarization"] == pytest.approx(1.0, abs=1e-12)
    assert told["reflection"]["beam"]["stokes"][1] < 0.0, "s alone"
    assert told["incident"]["degree_of_polarization"] == 0.0
    for stokes, message in (("1,1", "4 numbers"), ("1,1,1,0", "at most S0^2")):
        error = error_of(ask("/polarization", stokes=stokes))
        assert error["parameter"] == "stokes"
        assert message in error["message"]
    error = error_of(ask("/polarization", layers="1.5:1e6:incoherent"))
    assert "no amplitudes and no phases" in error["message"]


def test_an_absorbing_incident_medium(ask: Ask) -> None:
    query = {"n_i": 1.5, "k_i": 0.1, "n_t": 1.52, "layers": "1.38:100", "wavelength_nm": 550}
    told = json_of(ask("/snell", **query))
    assert round(told["R"], 8) == 0.00940097
    assert round(told["T"], 8) == 0.99507503
    assert "R + T + A is not 1" in told["convention"]
    bare = json_of(ask("/snell", n_i=1.5, k_i=0.1, n_t=1.52))
    assert bare["R"] == pytest.approx(
        abs((1.52 - 1.5 - 0.1j) / (1.52 + 1.5 + 0.1j)) ** 2, rel=1e-12
    )
    assert (bare["layers"], bare["A"], bare["k_i"]) == ([], 0.0, 0.1)
    error = error_of(ask("/snell", theta_i_deg=30, **query))
    assert error["parameter"] == "theta_i_deg"
    assert "the incident wave is not uniform along the surface" in error["message"]


def test_an_own_material_can_be_a_layer(ask: Ask) -> None:
    points = np.linspace(400.0, 700.0, 31)
    wavy = 1.4 + 0.1 * np.sin(points / 50.0)
    columns = Points(kind="points", wavelength_nm=tuple(points), values=tuple(wavy))
    own = write(OwnData(name="wavy", relative_to=None, n=columns, k=None)).token
    told = json_of(ask("/snell", layers=f"{own}:120", wavelength_nm=500, n_t=1.5))
    assert told["layers"][0]["n"] == pytest.approx(1.4 + 0.1 * np.sin(10.0), abs=1e-4)
    color = json_of(ask("/films/color", layers=f"{own}:120", thickness_nm="0,120", n_t=1.5))
    assert color["media"]["layers"][0]["medium"] == own
    said = [warning for warning in color["warnings"] if "k is not known" in warning]
    assert said == ["own-wavy: k is not known and counts as 0"]  # and not all its data
