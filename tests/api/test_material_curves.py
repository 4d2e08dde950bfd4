"""Spectra, curves and maps of materials: agreement with the core, one another and the figures."""

from typing import Any

import httpx
import numpy as np
import pytest

from app.materials.appearance import appearance, averaged_interface, color_curve
from app.materials.media import default_catalog
from app.materials.schema import Points
from app.optics.amplitudes import power
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.specular import polynomial
from tests.api.shape import Ask, error_of, rows_of

CHANNELS = ("R_red", "R_green", "R_blue")
SPECTRA = [preset.id for preset in default_catalog().presets if preset.kind == "spectrum"]


def table(answer: httpx.Response) -> dict[str, list[str]]:
    rows = rows_of(answer)
    return {name: [row[name] for row in rows] for name in rows[0]}


def channels(curve: dict[str, Any]) -> np.ndarray[Any, np.dtype[np.float64]]:
    return np.array([curve[name] for name in CHANNELS])


# /spectrum


@pytest.mark.parametrize("id", SPECTRA)
def test_native_points_are_sent_as_they_are(ask: Ask, id: str) -> None:  # noqa: A002
    answer = ask(f"/materials/{id}/spectrum").json()
    file = default_catalog().spectrum(id).file
    if isinstance(file.n, Points):
        assert answer["native"]["n"]["wavelength_nm"] == list(file.n.wavelength_nm)
        assert answer["native"]["n"]["values"] == list(file.n.values)
        assert set(file.n.wavelength_nm) <= set(answer["wavelength_nm"])
    else:
        assert list(answer["native"]["n"]) == ["kind", "number", "coefficients", "range_nm"]
        assert answer["native"]["n"]["coefficients"] == list(file.n.coefficients)
    assert (answer["k"] is None) == (file.k is None)
    for value in (v for v in answer["F0"] if v is not None):
        assert 0.0 <= value <= 1.0


def test_a_step(ask: Ask) -> None:
    answer = ask("/materials/Au/spectrum", minimum_nm=400, maximum_nm=800, step_nm=50).json()
    assert answer["wavelength_nm"] == [400, 450, 500, 550, 600, 650, 700, 750, 800]
    gold = default_catalog().spectrum("Au")
    assert answer["n"] == gold.n(answer["wavelength_nm"]).tolist()
    assert answer["F0"] == pytest.approx(Interface(1.0, answer["n"], answer["k"]).F0.tolist())
    assert answer["native"] is None


def test_nothing_is_extrapolated(ask: Ask) -> None:
    error = error_of(ask("/materials/Au/spectrum", minimum_nm=200))
    assert error["parameter"] == "minimum_nm"
    assert "300 to 24930 nm" in error["message"]
    # n from 365 nm, k from 370 nm
    answer = ask("/materials/LASF9/spectrum", maximum_nm=375, step_nm=5).json()
    assert answer["wavelength_nm"] == [365, 370, 375]
    assert None not in answer["n"]
    assert answer["k"][0] is None
    assert answer["F0"][0] is None
    assert None not in answer["k"][1:]


def test_an_unknown_k_is_null_and_said(ask: Ask) -> None:
    answer = ask("/materials/diamond/spectrum").json()
    assert answer["k"] is None
    assert answer["native"]["k"] is None
    assert "k is not known and counts as 0" in answer["warnings"]
    columns = table(ask("/materials/diamond/spectrum", format="csv"))
    assert set(columns["k"]) == {""}
    assert [float(v) for v in columns["F0"]] == answer["F0"]


def test_constants_beyond_what_is_computed(ask: Ask) -> None:
    answer = ask("/materials/Fe/spectrum").json()
    assert answer["k"][-1] > 100.0
    assert answer["F0"][-1] is None
    assert any("F0 is not computed" in warning for warning in answer["warnings"])


# /curves


def test_a_wavelength_is_what_curves_say_of_it(ask: Ask) -> None:
    own = ask("/materials/Cu/curves", wavelengths_nm="500", samples=91, incident="water").json()
    query = {"material": "Cu", "incident": "water", "wavelength_nm": 500, "samples": 91}
    other = ask("/curves", **query).json()
    assert own["wavelengths"][0]["R"] == pytest.approx(other["curves"][0]["values"], abs=1e-15)
    assert own["wavelengths"][0]["n_i"] == other["interface"]["n_i"]
    assert own["wavelengths"][0]["F82"] == pytest.approx(other["interface"]["F82"], abs=1e-15)


@pytest.mark.parametrize("id", ["Au", "Cu", "fused-silica"])
def test_rgb_is_the_core_s(ask: Ask, id: str) -> None:  # noqa: A002
    answer = ask(f"/materials/{id}/curves", samples=31).json()
    spectrum = default_catalog().spectrum(id)
    incidence = Incidence.from_degrees(answer["theta_i_deg"])
    color = appearance(spectrum)
    truth, schlick, tint, exact = answer["rgb"]["curves"]
    models = [c["model"] for c in answer["rgb"]["curves"]]
    assert models == ["spectral", "schlick", "f82_tint", "exact"]
    assert np.allclose(channels(truth), color_curve(spectrum, incidence).T, atol=1e-14)
    assert np.allclose(channels(truth)[:, 0], color.F0, atol=1e-12)
    assert np.array_equal(channels(schlick), polynomial(color.F0[:, np.newaxis], incidence.cos))
    assert tint["inputs"]["tint"] == color.F82_tint.tolist()
    averaged = averaged_interface(spectrum)
    assert np.allclose(channels(exact), power(averaged, incidence).R, atol=1e-15)


@pytest.mark.parametrize("id", ["Au", "Cr", "BK7"])
def test_errors_are_those_of_the_curves(ask: Ask, id: str) -> None:  # noqa: A002
    # The integrals again, by the trapezoidal rule over the angle.
    answer = ask(f"/materials/{id}/curves", samples=2001, wavelengths_nm="550").json()
    theta = np.radians(answer["theta_i_deg"])
    truth, *models = answer["rgb"]["curves"]
    assert truth["errors"] is None
    for model in models:
        error = channels(model) - channels(truth)
        for row, name in zip(error, ("red", "green", "blue"), strict=True):
            told = model["errors"][name]
            assert np.abs(row).max() - 1e-12 < told["max_abs"] < np.abs(row).max() + 2e-6
            assert abs(told["error_at_max"]) == told["max_abs"]
            square = np.trapezoid(row**2 * np.sin(theta), theta)
            assert told["rms"] == pytest.approx(np.sqrt(square), abs=1e-5)
            mean = np.trapezoid(row * np.sin(2.0 * theta), theta)
            assert told["cosine_weighted_mean"] == pytest.approx(mean, abs=1e-5)


def test_the_tint_beats_schlick_for_chromium(ask: Ask) -> None:
    _, schlick, tint, _ = ask("/materials/Cr/curves").json()["rgb"]["curves"]
    for channel in ("red", "green", "blue"):
        assert tint["errors"][channel]["rms"] < schlick["errors"][channel]["rms"]


def test_gamut_changes_what_models_are_given_and_not_the_truth(ask: Ask) -> None:
    raw, clamped = (
        ask("/materials/Au/curves", gamut=gamut).json()["rgb"]["curves"]
        for gamut in ("unclamped", "clamped")
    )
    assert raw[0] == clamped[0]
    assert raw[1]["inputs"]["F0"][0] > 1.0
    assert clamped[1]["inputs"]["F0"][0] == 1.0


def test_every_model_that_takes_a_color(ask: Ask) -> None:
    listed = ask("/materials/Au/curves", models="deon_rg").json()["errors"][0]["message"]
    models = listed.removeprefix("one of ").split(", ")
    assert {"exact", "schlick", "f82_tint", "hoffman_f82", "schlick_f0_srgb"} <= set(models)
    answer = ask("/materials/Cr/curves", models=",".join(models)).json()
    assert [c["model"] for c in answer["rgb"]["curves"]] == ["spectral", *models]


def test_without_rgb(ask: Ask) -> None:
    answer = ask("/materials/Cu/curves", rgb="false", wavelengths_nm="550").json()
    assert answer["rgb"] is None
    assert len(answer["wavelengths"]) == 1


def test_what_was_held_for_the_color_is_said(ask: Ask) -> None:
    warnings = ask("/materials/glycerol/curves").json()["warnings"]
    assert any("color holds the value" in warning for warning in warnings)
    assert any("k is not known" in warning for warning in warnings)
    assert ask("/materials/Cu/curves").json()["warnings"] == []


def test_curves_as_csv(ask: Ask) -> None:
    columns = table(ask("/materials/Cu/curves", format="csv", samples=3, wavelengths_nm="400.5"))
    answer = ask("/materials/Cu/curves", samples=3, wavelengths_nm="400.5").json()
    assert [float(v) for v in columns["R_400.5nm"]] == answer["wavelengths"][0]["R"]
    spectral = answer["rgb"]["curves"][0]
    assert [float(v) for v in columns["spectral.R_red"]] == spectral["R_red"]
    assert list(columns)[:2] == ["theta_i_deg", "R_400.5nm"]


def test_seen_from_glass_all_is_reflected_beyond_the_critical_angle(ask: Ask) -> None:
    answer = ask("/materials/water/curves", incident="diamond", samples=91).json()
    assert answer["front"]["incident"]["id"] == "diamond"
    assert answer["front"]["n_i"] is None
    for curve in (*answer["wavelengths"], {"R": answer["rgb"]["curves"][0]["R_green"]}):
        assert curve["R"][60] == pytest.approx(1.0, abs=1e-9)
        assert curve["R"][10] < 0.2


# /map


def test_a_row_of_the_map_is_a_curve(ask: Ask) -> None:
    answer = ask("/materials/Cu/map", steps=5, minimum_nm=400, maximum_nm=800, samples=31).json()
    curves = ask("/materials/Cu/curves", samples=31, rgb="false").json()["wavelengths"]
    assert answer["wavelength_nm"] == [curve["wavelength_nm"] for curve in curves]
    for row, curve in zip(answer["values"], curves, strict=True):
        assert row == pytest.approx(curve["R"], abs=1e-15)


def test_polarizations_of_the_map_average_to_R(ask: Ask) -> None:
    maps = {
        quantity: np.array(ask("/materials/Si/map", quantity=quantity).json()["values"])
        for quantity in ("R", "Rs", "Rp")
    }
    assert np.allclose(maps["R"], 0.5 * (maps["Rs"] + maps["Rp"]), atol=1e-15)


def test_the_map_keeps_within_both_media(ask: Ask) -> None:
    span = ask("/materials/Au/map", incident="glycerol").json()["wavelength_nm"]
    assert (span[0], span[-1]) == (400.0, 710.0)
    span = ask("/materials/Au/map").json()["wavelength_nm"]
    assert (span[0], span[-1]) == (380.0, 780.0)


def test_the_map_as_csv(ask: Ask) -> None:
    columns = table(ask("/materials/Cu/map", format="csv", steps=2, samples=3))
    values = ask("/materials/Cu/map", steps=2, samples=3).json()["values"]
    assert columns["wavelength_nm"] == ["380.0"] * 3 + ["780.0"] * 3
    assert [float(v) for v in columns["R"]] == [v for row in values for v in row]


def test_the_largest_map(ask: Ask) -> None:
    assert ask("/materials/Cu/map", steps=500, samples=500, digits=3).status_code == 200
