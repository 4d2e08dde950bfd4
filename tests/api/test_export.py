"""`/export`: any boundary, and a film on it, for render engines."""

import json

import numpy as np
import pytest

from app.materials.rgb_index import ANGLES_DEG
from app.optics.amplitudes import reflectance
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from tests.api.shape import Ask, error_of, json_of

SHOWN = Incidence.from_degrees(np.array([0.0, 30.0, 60.0, 80.0, 85.0]))


def test_numbers_are_a_material(ask: Ask) -> None:
    glass = json_of(ask("/export", to="mitsuba", n_t=1.5, format="json"))
    assert glass["kind"] == "dielectric"
    assert glass["parameters"]["int_ior"] == 1.5
    assert glass["error"]["max_abs"] < 1e-6
    assert glass["film"] is None
    metal = json_of(ask("/export", to="blender", n_t=0.27, k_t=2.9, format="json"))
    assert metal["material"]["name"] == "n = 0.27, k = 2.9"
    exact = reflectance(Interface(1.0, 0.27, 2.9), SHOWN)
    for channel in range(3):
        found = [row[channel] for row in metal["reflectance"]]
        np.testing.assert_allclose(found, exact, atol=2e-5)
    text = ask("/export", to="blender", n_t=0.27, k_t=2.9)
    assert text.headers["content-type"].startswith("text/x-python")
    assert 'bpy.data.materials.new("own_n_0_27_k_2_9")' in text.text


def test_a_preset_is_the_same_as_among_materials(ask: Ask) -> None:
    one = ask("/export", to="gltf", material="Cu").text
    assert one == ask("/materials/Cu/export", to="gltf").text


@pytest.mark.parametrize(
    ("to", "material", "typed"),
    [
        (
            "gltf",
            "Si",
            {
                "KHR_materials_iridescence.iridescenceFactor": 1.0,
                "KHR_materials_iridescence.iridescenceIor": 1.46,
                "KHR_materials_iridescence.iridescenceThicknessMaximum": 250.0,
            },
        ),
        (
            "openpbr",
            "Si",
            {"thin_film_weight": 1.0, "thin_film_thickness": 0.25, "thin_film_ior": 1.46},
        ),
        ("materialx", "Si", {"thinfilm_thickness": 250.0, "thinfilm_ior": 1.46}),
        ("blender", "N-BK7", {"Thin Film Thickness": 250.0, "Thin Film IOR": 1.46}),
    ],
)
def test_a_film_is_typed(ask: Ask, to: str, material: str, typed: dict[str, float]) -> None:
    query = {"to": to, "material": material, "layers": "1.46:250"}
    found = json_of(ask("/export", **query, format="json"))
    assert typed.items() <= found["parameters"].items()
    film = found["film"]
    assert (film["n"], film["thickness_nm"]) == (1.46, 250.0)
    assert film["model"] in found["error"]["measured_with"]["note"]
    assert found["lost"][-1] == "The film has one index for all wavelengths, that at 587.6 nm."
    assert str(typed.popitem()[1]) in ask("/export", **query).text


@pytest.mark.parametrize("to", ["gltf", "openpbr", "materialx", "blender"])
def test_errors_of_a_film_are_those_of_its_shortcut(ask: Ask, to: str) -> None:
    """By the route that compares shortcuts over thickness and angle, in a metal of one index."""
    medium = {"n_t": 1.5, "layers": "1.3:300"}
    found = json_of(ask("/export", to=to, **medium, format="json"))
    colors = json_of(
        ask(
            "/films/color",
            n_t=1.5,
            layers="1.3",
            thickness_nm="300",
            theta_i_deg="0,30,60,80,85",
            models=f"exact,{found['film']['model']}",
        )
    )["colors"]
    exact, shortcut = (np.array(one["linear_srgb"][0]) for one in colors)
    np.testing.assert_allclose(found["spectrum"], exact, atol=1e-5)
    np.testing.assert_allclose(found["reflectance"], shortcut, atol=1e-9)
    assert found["error"]["max_abs"] >= np.abs(exact - shortcut).max() - 1e-5
    assert found["error"]["at_deg"] in ANGLES_DEG


def test_gltf_says_which_extension_the_file_uses(ask: Ask) -> None:
    document = json.loads(ask("/export", to="gltf", material="N-BK7", layers="MgF2-o:100").text)
    assert "KHR_materials_iridescence" in document["extensionsUsed"]
    film = document["materials"][0]["extensions"]["KHR_materials_iridescence"]
    # Dodge (1984): n_o of MgF2 at the d line, in air.
    assert film["iridescenceIor"] == pytest.approx(1.3777 * 1.000277, abs=2e-4)


def test_what_no_file_can_hold_is_refused(ask: Ask) -> None:
    refused = error_of(ask("/export", to="usd", n_t=1.5, layers="1.3:100"))
    assert refused["parameter"] == "layers"
    assert "materialx, openpbr, gltf, blender have one" in refused["message"]
    several = error_of(ask("/export", to="gltf", n_t=1.5, layers="1.3:100,2:50"))
    assert several["message"].startswith("one film")
    water = error_of(ask("/export", to="gltf", n_t=1.5, n_i=1.33))
    assert water["parameter"] == "n_i"
    tint = error_of(ask("/export", to="blender", material="Au", mode="f82", layers="1.3:100"))
    assert tint["parameter"] == "mode"
    beside = error_of(ask("/export", to="gltf", material="Au", n_t=1.5))
    assert beside["parameter"] == "n_t"
    bubble = error_of(ask("/export", to="gltf", n_t=0.75))  # an error to Khronos' validator
    assert (bubble["parameter"], bubble["value"]) == ("to", "gltf")
    assert "its ior is at least 1, and n 0.75" in bubble["message"]
    thin = error_of(ask("/export", to="gltf", n_t=1.5, layers="0.9:100"))
    assert "n of at least 1" in thin["message"]


def test_a_policy_is_told_of_what_has_colors(ask: Ask) -> None:
    """Gold's red is above 1; spectra and an index are written as they are."""
    for to, mode, told in (
        ("mitsuba", "spectral", False),
        ("mitsuba", "nk", True),
        ("gltf", "schlick", True),
    ):
        query = {"to": to, "mode": mode, "material": "Au", "format": "json"}
        assert (
            any("outside 0 to 1" in lost for lost in ask("/export", **query).json()["lost"]) is told
        )
    thin = ask("/export", to="blender", n_t=0.5, format="json").json()
    assert not any("outside 0 to 1" in lost for lost in thin["lost"])
