"""The route that converts: forms, triples, colors and materials, and refusals."""

from typing import Any

import httpx
import pytest

from app.optics.color import decode_srgb
from tests.api.shape import Ask, json_of, rows_of


@pytest.fixture
def get(ask: Ask) -> Ask:
    def get(**parameters: Any) -> httpx.Response:
        return ask("/convert", **{name.rstrip("_"): value for name, value in parameters.items()})

    return get


def results(answer: httpx.Response) -> dict[str, dict[str, Any]]:
    return {result["form"]: result for result in json_of(answer)["results"]}


@pytest.mark.parametrize(
    "given",
    [
        {},
        {"from_": "ior", "n_t": 1.5},
        {"from_": "nk", "n_t": 1.5, "k_t": 0.0},
        {"from_": "f0", "F0": 0.04},
        {"from_": "f0_srgb", "F0_srgb": 0.22091636254849623},
        {"from_": "rg", "r": 0.04, "g": 0.0},
        {"from_": "dg", "r": 0.04, "G": 0.0},
        {"from_": "specular", "specular": 0.5},
        {"from_": "reflectance", "reflectance": 0.5},
    ],
    ids=str,
)
def test_one_glass_in_every_form(get: Ask, given: dict[str, Any]) -> None:
    found = results(get(**given))
    assert found["ior"]["values"]["n_t"] == pytest.approx(1.5, rel=1e-12)
    alone = given.get("from_") in ("f0", "f0_srgb")  # metals have an F0 as well
    assert found["ior"]["status"] == ("dielectric only" if alone else "exact")
    assert found["f0"]["values"]["F0"] == pytest.approx(0.04, rel=1e-12)
    assert found["f0_seen_from"]["values"]["F0"] == pytest.approx((0.167 / 2.833) ** 2, rel=1e-9)
    assert found["f0_hex"]["values"]["hex"] == "#383838"
    assert found["f0"]["channels"] is None


def test_another_medium_in_front(get: Ask) -> None:
    answer = get(from_="f0", F0=0.04, n_i=1.333, seen_from=1.0)
    assert results(answer)["ior"]["values"]["n_t"] == pytest.approx(1.333 * 1.5, rel=1e-12)
    assert answer.json()["n_i"] == 1.333
    assert answer.json()["seen_from"] == 1.0


def test_a_color_of_a_picture(get: Ask) -> None:
    answer = get(from_="f0_srgb", hex="#ffd700")
    found = results(answer)
    expected = decode_srgb([1.0, 215 / 255, 0.0])
    assert found["f0"]["values"]["F0"] == pytest.approx(list(expected))
    assert found["f0_hex"]["values"]["hex"] == "#ffd700"
    assert found["f0_hex"]["status"] == "exact"
    assert found["ior"]["status"] == "infeasible"  # red is a perfect mirror
    channels = [channel["status"] for channel in found["ior"]["channels"]]
    assert channels == ["infeasible", "dielectric only", "dielectric only"]
    assert found["ior"]["values"]["n_t"][0] is None
    assert found["ior"]["why"].startswith("red: F0 = 1")
    assert answer.json()["given"]["hex"] == "#ffd700"


def test_what_gold_does_not_share_with_a_dielectric(get: Ask) -> None:
    found = results(get(from_="f0", F0="0.947,0.776,0.371"))
    for form in ("ior", "f82", "f82_tint", "f0_seen_from"):
        assert found[form]["status"] == "dielectric only"
    assert found["f82_tint"]["values"]["tint"] == pytest.approx([0.862, 0.633, 0.700], abs=5e-4)
    assert found["f82_tint"]["why"] == (
        "if the second medium does not absorb and is the denser one; of a metal F0 alone does not "
        "tell it; red: no medium without absorption has F0 = 0.947: it would need n_t = 73.5; "
        "green: no medium without absorption has F0 = 0.776: it would need n_t = 15.8"
    )
    assert found["f0_hex"]["why"].startswith(
        "red: rounded to one of 256 codes, +3.1e-04 off; green:"
    )


def test_three_channels_of_gulbrandsen(get: Ask) -> None:
    found = results(get(from_="rg", r="0.98,0.77,0.34", g=0.5))
    assert len(found["nk"]["values"]["n_t"]) == 3
    assert found["rg"]["values"]["g"] == pytest.approx([0.5, 0.5, 0.5], abs=1e-9)
    alone = results(get(from_="rg", r=0.77, g=0.5))
    assert found["nk"]["values"]["k_t"][1] == alone["nk"]["values"]["k_t"]


def test_a_material(get: Ask) -> None:
    answer = get(from_="nk", material="Au")
    found = results(answer)
    assert answer.json()["material"]["id"] == "Au"
    assert found["ior"]["status"] == "lossy"
    assert found["dg"]["status"] == "exact"


def test_as_csv(get: Ask) -> None:
    rows = rows_of(get(from_="f0", F0=1.0, format="csv", digits=5))
    named = {(row["form"], row["name"]): row for row in rows}
    assert named["ior", "n_t"]["value"] == ""
    assert named["ior", "n_t"]["status"] == "infeasible"
    assert named["f0", "F0"]["value"] == "1.0"
    triple = rows_of(get(from_="f0", F0="1,0.5,0", format="csv"))
    (row,) = [row for row in triple if row["form"] == "f0"]
    assert [row["red"], row["green"], row["blue"]] == ["1.0", "0.5", "0.0"]
    (code,) = [row for row in triple if row["name"] == "hex"]
    assert code["value"] == "#ffbc00"


def knobs(answer: httpx.Response) -> dict[str, dict[str, Any]]:
    return {knob["knob"]: knob for knob in json_of(answer)["knobs"]}


def typed(knob: dict[str, Any]) -> dict[str, Any]:
    return {given["name"]: given["value"] for given in knob["inputs"]}


def test_knobs_are_forms_that_come_back(get: Ask) -> None:
    """Each setting of a clear medium, given again, is the same medium."""
    found = knobs(get(n_t=1.45))
    assert len(found) == 8
    for form, knob in found.items():
        assert knob["status"] == "exact", form
        again = results(get(from_=form, **typed(knob)))
        assert again["ior"]["values"]["n_t"] == pytest.approx(1.45, rel=1e-9), form
    level = found["blender"]["inputs"][1]
    assert (level["label"], level["value"], level["default"]) == ("Specular IOR Level", 0.5, 0.5)
    assert (level["minimum"], level["maximum"]) == (0.0, 1.0)
    assert found["blender"]["measured"] == ["Blender Cycles 5.2.3"]
    assert found["unreal"]["measured"] == []


def test_defaults_of_a_knob_of_several_numbers(get: Ask) -> None:
    glass = results(get(from_="gltf"))
    assert glass["f0"]["values"]["F0"] == pytest.approx(0.04, rel=1e-12)
    half = get(from_="openpbr", specular_weight=0.5)
    assert results(half)["f0"]["values"]["F0"] == pytest.approx(0.02, rel=1e-12)
    assert half.json()["given"] == {"specular_ior": 1.5, "specular_weight": 0.5}
    assert results(half)["f0"]["status"] == "lossy"
    refused = get(from_="three").json()["errors"]
    assert [error["parameter"] for error in refused] == ["reflectivity"]
    foreign = get(from_="three", reflectivity=0.5, specular_weight=1).json()["errors"]
    assert foreign[0]["message"] == "not beside from=three, which takes reflectivity"
    (below,) = get(from_="gltf", ior=0.5).json()["errors"]
    assert (below["parameter"], below["value"]) == ("ior", "0.5")


def test_a_colored_specular(get: Ask) -> None:
    found = get(from_="gltf", ior=1.5, specularColorFactor="1,0.5,0.25")
    assert results(found)["f0"]["values"]["F0"] == pytest.approx([0.04, 0.02, 0.01])
    assert typed(knobs(found)["gltf"])["specularColorFactor"] == pytest.approx([1.0, 0.5, 0.25])
    assert typed(knobs(found)["specular"])["specular"] is None
    rows = rows_of(get(from_="gltf", specularColorFactor="1,0.5,0.25", format="csv"))
    (row,) = [row for row in rows if row["name"] == "specularColorFactor"]
    assert [row["form"], row["red"], row["blue"]] == ["gltf", "1.0", "0.25"]


def test_dispersion_of_a_glass(get: Ask) -> None:
    """Schott prints V_d = 64.17 for N-BK7."""
    found = json_of(get(material="N-BK7"))["dispersion"]
    assert found["abbe"] == pytest.approx(64.17, abs=0.005)
    gltf, openpbr = found["knobs"]
    assert typed(gltf)["dispersion"] == pytest.approx(20.0 / 64.17, abs=5e-5)
    assert typed(openpbr)["transmission_dispersion_abbe_number"] == found["abbe"]
    assert typed(openpbr)["transmission_dispersion_scale"] == 1.0
    # Schott's catalog: n_F = 1.52238, n_C = 1.51432, of which half their difference is 0.00403.
    off = max(abs(1.51680 + 0.00403 - 1.52238), abs(1.51680 - 0.00403 - 1.51432))
    assert gltf["why"].startswith("V_d comes back; n is off by at most ")
    assert float(gltf["why"].split()[9]) == pytest.approx(off, abs=1e-4)
    assert json_of(get(n_t=1.7, dispersion_of="N-BK7"))["dispersion"] == found
    given = json_of(get(n_t=1.5, abbe=40))["dispersion"]
    assert typed(given["knobs"][0]) == {"dispersion": 0.5}
    assert given["knobs"][0]["status"] == "exact"
    none = json_of(get(n_t=1.5, dispersion_of="Au"))["dispersion"]
    assert none["abbe"] is None
    assert none["knobs"] == []
    assert "dispersion" not in json_of(get(from_="nk", material="Au"))
    (both,) = get(abbe=40, dispersion_of="N-BK7").json()["errors"]
    assert both["parameter"] == "abbe"
