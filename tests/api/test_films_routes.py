"""`/films`: spectra, colors, and thicknesses that reach something."""

import math
from typing import Any

import numpy as np
import pytest

from app.optics.color import delta_e_2000, encode_srgb, linear_srgb
from app.optics.film_models import film_models
from tests.api.shape import Ask, error_of, json_of, rows_of

SOAP = {"layers": "1.33", "n_t": 1}


def curves(told: Any) -> dict[str, Any]:
    return {curve["quantity"]: np.array(curve["values"]) for curve in told["curves"]}


def test_a_spectrum_is_made_of_rays(ask: Ask) -> None:
    query = {"layers": "MgF2:99.6,Ag:10", "material": "BK7", "theta_i_deg": 40}
    told = json_of(ask("/films/spectrum", minimum_nm=400, maximum_nm=700, step_nm=50, **query))
    assert told["wavelength_nm"] == [400.0, 450.0, 500.0, 550.0, 600.0, 650.0, 700.0]
    values = curves(told)
    np.testing.assert_allclose(values["R"] + values["T"] + values["A"], 1.0, atol=1e-12)
    for i, wavelength_nm in enumerate(told["wavelength_nm"]):
        ray = json_of(ask("/snell", wavelength_nm=wavelength_nm, **query))
        for name in ("R", "Rs", "Rp", "T", "A", "As"):
            assert values[name][i] == pytest.approx(ray[name], rel=1e-12)
    assert [layer["material"]["id"] for layer in told["media"]["layers"]] == ["MgF2-o", "Ag"]
    assert told["media"]["material"]["id"] == "BK7"


@pytest.mark.parametrize(
    ("given", "named", "value"),
    [
        ({"minimum_nm": 0.4}, "minimum_nm", "0.4"),
        ({"maximum_nm": 9000, "step_nm": 10}, "maximum_nm", "9000"),
        ({"minimum_nm": 150, "maximum_nm": 9000, "step_nm": 10}, "minimum_nm", "150"),
    ],
)
def test_an_end_beyond_what_is_known_is_named(
    ask: Ask, given: dict[str, float], named: str, value: str
) -> None:
    error = error_of(ask("/films/spectrum", layers="MgF2:99.6", **given))
    assert (error["parameter"], error["value"]) == (named, value)
    assert "200 to 7000 nm" in error["message"]


def test_a_spectrum_as_a_table(ask: Ask) -> None:
    rows = rows_of(ask("/films/spectrum", layers="1.38:100", step_nm=200, format="csv"))
    assert list(rows[0]) == [
        "wavelength_nm", "R", "Rs", "Rp", "T", "Ts", "Tp", "A", "As", "Ap",
    ]  # fmt: skip
    assert len(rows) == 3


def test_colors_lie_on_a_grid(ask: Ask) -> None:
    told = json_of(ask("/films/color", thickness_nm="0..400:5", theta_i_deg="0,60", **SOAP))
    assert told["thickness_nm"] == [0.0, 100.0, 200.0, 300.0, 400.0]
    assert told["theta_i_deg"] == [0.0, 60.0]
    (exact,) = told["colors"]
    assert exact["model"] == "exact"
    assert np.shape(exact["linear_srgb"]) == np.shape(exact["lab"]) == (5, 2, 3)
    assert exact["hex"][0] == ["#000000", "#000000"], "a film without thickness reflects nothing"
    for row, written in zip(exact["linear_srgb"], exact["hex"], strict=True):
        for linear, text in zip(row, written, strict=True):
            steps = np.rint(255.0 * encode_srgb(np.clip(linear, 0.0, 1.0)))
            assert text == "#" + "".join(f"{int(step):02x}" for step in steps)


def test_colors_at_angles_in_radians(ask: Ask) -> None:
    query = {"thickness_nm": "250", **SOAP}
    told = json_of(ask("/films/color", theta_i_rad=f"0,1,{math.pi / 2}", **query))
    np.testing.assert_allclose(told["theta_i_deg"], [0.0, math.degrees(1.0), 90.0], rtol=1e-15)
    expected = ask("/films/color", theta_i_deg=f"0,{math.degrees(1.0)},90", **query).json()
    found, wanted = (answer["colors"][0]["linear_srgb"] for answer in (told, expected))
    np.testing.assert_allclose(found, wanted, rtol=1e-12)


def test_a_color_is_the_integral_of_the_spectrum(ask: Ask) -> None:
    query = {"layers": "1.46:60,fused-silica:250", "material": "Al", "theta_i_deg": "35"}
    told = json_of(ask("/films/color", thickness_nm="250", layer=2, **query))
    R = curves(json_of(ask("/films/spectrum", minimum_nm=360, maximum_nm=830, **query)))["R"]
    assert told["warnings"] == ["fused-silica: k is not known and counts as 0"]
    color = told["colors"][0]["linear_srgb"][0][0]
    np.testing.assert_allclose(color, linear_srgb(R), atol=1e-4)


def test_a_transmitted_color_is_the_integral_of_what_is_transmitted(ask: Ask) -> None:
    query = {"layers": "Au:50", "n_t": 1.5, "theta_i_deg": "40"}
    told = json_of(ask("/films/color", thickness_nm="50", quantity="T", **query))
    T = curves(json_of(ask("/films/spectrum", minimum_nm=360, maximum_nm=830, **query)))["T"]
    color = told["colors"][0]["linear_srgb"][0][0]
    np.testing.assert_allclose(color, linear_srgb(T), atol=1e-4)
    assert color[1] > max(color[0], color[2])  # gold leaf is green from behind


def test_shortcuts_stand_beside_the_exact_colors_with_their_difference(ask: Ask) -> None:
    query = {"layers": "1.3", "thickness_nm": "0,100", "theta_i_deg": "0,60", "illuminant": "E"}
    told = json_of(ask("/films/color", models="exact,gltf_iridescence,cycles_film", **query))
    exact, gltf, cycles = told["colors"]
    assert [each["model"] for each in told["colors"]] == [
        "exact",
        "gltf_iridescence",
        "cycles_film",
    ]
    assert exact["delta_e"] is None
    np.testing.assert_allclose(cycles["linear_srgb"][1][1], [0.0498, 0.0402, 0.0292], atol=1e-4)
    np.testing.assert_allclose(gltf["linear_srgb"][1][0], [0.0031, 0.0044, 0.0076], atol=1e-4)
    assert np.max(cycles["delta_e"]) < 1.0 < np.max(gltf["delta_e"])
    # the difference is that of the colors sent
    found = delta_e_2000(gltf["lab"], exact["lab"])
    np.testing.assert_allclose(gltf["delta_e"], found, rtol=1e-12)


def test_a_measured_metal_is_typed_in_as_renderers_take_it(ask: Ask) -> None:
    query = {"layers": "1.0", "material": "Al", "thickness_nm": "0.001", "theta_i_deg": "0"}
    told = json_of(ask("/films/color", models="cycles_film,materialx_schlick_airy", **query))
    exact, cycles, half = (np.array(each["linear_srgb"][0][0]) for each in told["colors"])
    np.testing.assert_allclose(cycles, exact, atol=0.01)
    assert half[1] == pytest.approx(0.5 * exact[1], rel=0.05)


def test_shortcuts_are_listed_with_their_errors(ask: Ask) -> None:
    listed = json_of(ask("/films/models"))["models"]
    assert [model["id"] for model in listed] == sorted(film_models())
    for model in listed:
        assert len(model["measured"]) >= 4
        assert model["validity"].endswith(".")


def test_colors_as_a_table(ask: Ask) -> None:
    rows = rows_of(ask("/films/color", thickness_nm="0,100", samples=3, format="csv", **SOAP))
    assert [(row["thickness_nm"], row["theta_i_deg"]) for row in rows[:4]] == [
        ("0.0", "0.0"), ("0.0", "45.0"), ("0.0", "90.0"), ("100.0", "0.0"),
    ]  # fmt: skip
    assert rows[3]["exact.hex"].startswith("#")


def test_thin_films_of_least_reflectance(ask: Ask) -> None:
    """At normal incidence n d is a quarter of the wavelength, then three quarters."""
    told = json_of(ask("/films/solve", layers="1.38", n_t=1.52, thickness_nm="0..400:201"))
    thicknesses = [one["thickness_nm"][0] for one in told["solutions"]]
    quarter = 550.0 / (4.0 * 1.38)
    np.testing.assert_allclose(thicknesses, [quarter, 3.0 * quarter], rtol=1e-7)
    best = told["solutions"][0]
    y = 1.38**2
    assert best["R"] == pytest.approx(((y - 1.52) / (y + 1.52)) ** 2, rel=1e-10)
    again = json_of(ask("/snell", layers=best["layers"], n_t=1.52, wavelength_nm=550))
    assert again["R"] == pytest.approx(best["R"], rel=1e-9)


def test_quarter_waves_mirror(ask: Ask) -> None:
    """R = ((1 - Y)/(1 + Y))^2 with Y = (n_H/n_L)^(2 N) n_s for N pairs."""
    query = {"layers": "2.35,1.38", "n_t": 1.52, "target": "quarter_wave"}
    told = json_of(ask("/films/solve", repeat=6, **query))
    (mirror,) = told["solutions"]
    Y = (2.35 / 1.38) ** 12 * 1.52
    assert mirror["R"] == pytest.approx(((1 - Y) / (1 + Y)) ** 2, rel=1e-12)
    assert len(mirror["thickness_nm"]) == len(told["media"]["layers"]) == 12
    tilted = json_of(ask("/films/solve", theta_i_deg=40, **query))["solutions"][0]
    q = np.sqrt(2.35**2 - np.sin(np.radians(40)) ** 2)
    assert tilted["thickness_nm"][0] == pytest.approx(550.0 / (4.0 * q), rel=1e-12)


def test_a_wanted_color_is_found_again(ask: Ask) -> None:
    oxide = {"layers": "rutile-o", "material": "Ti", "theta_i_deg": "0"}
    there = json_of(ask("/films/color", thickness_nm="52", **oxide))["colors"][0]["hex"][0][0]
    told = json_of(
        ask("/films/solve", target="color", color=there, thickness_nm="0..200:201", **oxide)
    )
    best = told["solutions"][0]
    assert best["delta_e"] < 1.0
    assert best["thickness_nm"][0] == pytest.approx(52.0, abs=1.0)
    assert [one["delta_e"] for one in told["solutions"]] == sorted(
        one["delta_e"] for one in told["solutions"]
    )


@pytest.mark.parametrize(
    ("path", "query", "name", "told"),
    [
        ("/films/spectrum", {}, "layers", "required"),
        ("/films/spectrum", {"layers": "1.38"}, "layers", "MEDIUM:NM"),
        ("/films/spectrum", {"layers": "water-shirley:5"}, "layers", "a single index"),
        ("/films/spectrum", {"layers": "1.38:9", "material": "BK7", "n_t": 1}, "n_t", "takes its"),
        ("/films/spectrum", {"layers": "BK7:9", "minimum_nm": 200}, "minimum_nm", "300 to 2500"),
        ("/films/spectrum", {"layers": "1.3:9", "step_nm": 0.001}, "step_nm", "at most"),
        ("/films/spectrum", {"layers": "1.3:9", "minimum_nm": 900}, "minimum_nm", "at most"),
        ("/films/color", {"layers": "1.33,1.5", "thickness_nm": "5"}, "layers", "only layer 1"),
        (
            "/films/color",
            {"layers": "1.33", "thickness_nm": "5..1:3"},
            "thickness_nm",
            "first..last",
        ),
        ("/films/color", {"layers": "1.33", "thickness_nm": "-1"}, "thickness_nm", "first..last"),
        ("/films/color", {"layers": "1.33", "thickness_nm": "1e10"}, "thickness_nm", "1e+09"),
        ("/films/color", {"layers": "1.33", "thickness_nm": "5", "layer": 2}, "layer", "1 to 1"),
        ("/films/color", {"layers": "1.33"}, "thickness_nm", "required"),
        (
            "/films/color",
            {"layers": "1.33", "thickness_nm": "0..9:1000", "samples": 1000},
            "thickness_nm",
            "at most 250000",
        ),
        (
            "/films/color",
            {"layers": "1.33", "thickness_nm": "1", "samples": 3, "theta_i_deg": "1"},
            "samples",
            "not beside theta_i_deg",
        ),
        ("/snell", {"layers": "1.5:1e9", "wavelength_nm": 0.01}, "layers", "1e+10 wavelengths"),
        (
            "/films/color",
            {"layers": "1.33", "thickness_nm": "1", "samples": 3, "theta_i_rad": "1"},
            "samples",
            "not beside theta_i_rad",
        ),
        (
            "/films/color",
            {"layers": "1.33", "thickness_nm": "1", "theta_i_deg": "60", "theta_i_rad": "1"},
            "theta_i_deg",
            "not beside theta_i_rad",
        ),
        (
            "/films/color",
            {"layers": "1.33", "thickness_nm": "1", "theta_i_rad": "60"},
            "theta_i_rad",
            "0 to 1.57",
        ),
        (
            "/films/color",
            {"layers": "1.33,1.5:9", "thickness_nm": "5", "models": "cycles_film"},
            "models",
            "one film",
        ),
        (
            "/films/color",
            {"layers": "1.33", "thickness_nm": "5", "models": "cycles_film", "n_i": 1.5},
            "models",
            "in air",
        ),
        (
            "/films/color",
            {"layers": "1.33", "thickness_nm": "5", "models": "cycles_film", "quantity": "T"},
            "models",
            "reflected light",
        ),
        (
            "/films/color",
            {"layers": "1.33", "thickness_nm": "5", "models": "cycles"},
            "models",
            "cycles_film",
        ),
        ("/films/solve", {"layers": "1.33", "target": "color"}, "color", "an sRGB color"),
        ("/films/solve", {"layers": "1.33", "color": "#000000"}, "color", "not with target"),
        ("/films/solve", {"layers": "1.33", "repeat": 2}, "repeat", "not with target"),
        (
            "/films/solve",
            {"layers": "1.0", "n_i": 1.5, "theta_i_deg": 60, "target": "quarter_wave"},
            "layers",
            "light passes",
        ),
    ],
)
def test_refusals(ask: Ask, path: str, query: dict[str, Any], name: str, told: str) -> None:
    error = error_of(ask(path, **query))
    assert error["parameter"] == name
    assert told in error["message"].lower() + error["message"]


def test_a_parameter_that_was_left_out_has_no_value(ask: Ask) -> None:
    answer = ask("/films/color", layers="1.33")
    assert error_of(answer)["value"] is None
    assert answer.json()["detail"] == "thickness_nm: Field required"


@pytest.mark.parametrize(
    "query",
    [{"layers": "1.38", "n_t": 1.38}, {"layers": "1.38", "theta_i_deg": 90}],
    ids=["of the medium's index", "grazing"],
)
def test_a_thickness_that_makes_no_difference(ask: Ask, query: dict[str, Any]) -> None:
    told = json_of(ask("/films/solve", **query))
    assert [each["thickness_nm"] for each in told["solutions"]] == [[0.0]]
    assert told["warnings"] == [
        "the thickness of this layer makes no difference here: the thinnest stands for all"
    ]


def test_the_foot_of_a_slope_is_the_one_solution(ask: Ask) -> None:
    told = json_of(ask("/films/solve", layers="1.38", thickness_nm="10..50:41"))
    assert [each["thickness_nm"] for each in told["solutions"]] == [[50.0]]
    assert told["warnings"] == []


def test_a_pane_and_its_modifiers(ask: Ask) -> None:
    told = json_of(ask("/films/pane", samples=91))
    values = curves(told)
    np.testing.assert_allclose(values["R"] + values["T"] + values["A"], 1.0, atol=1e-12)
    exact = np.array(told["modifier"])
    np.testing.assert_allclose(exact, values["T"] / values["T"][0], rtol=1e-12)
    assert [each["id"] for each in told["modifiers"]] == [
        "ashrae", "martin_ruiz", "physical", "schlick",
    ]  # fmt: skip
    for each in told["modifiers"]:
        error = np.array(each["values"]) - exact
        np.testing.assert_allclose(each["error"], error, atol=1e-15)
        assert each["max_abs"] >= np.abs(error).max() > 0.0
        assert each["max_abs"] >= each["max_abs_to_60"]
        assert 0.8 < each["diffuse"] < 1.0
    physical = json_of(ask("/films/pane", n_behind=1.526))["modifiers"][2]
    assert physical["max_abs"] < 1e-8


def test_a_modifier_takes_its_own_parameter(ask: Ask) -> None:
    query = {"martin_ruiz.a_r": "0.3", "ashrae.b": "0.1", "samples": "3", "format": "csv"}
    row = rows_of(ask("/films/pane", **query))[1]
    mu = np.sqrt(0.5)
    assert float(row["modifier.ashrae"]) == pytest.approx(1.0 - 0.1 * (1.0 / mu - 1.0))
    expected = (1.0 - np.exp(-mu / 0.3)) / (1.0 - np.exp(-1.0 / 0.3))
    assert float(row["modifier.martin_ruiz"]) == pytest.approx(expected)
