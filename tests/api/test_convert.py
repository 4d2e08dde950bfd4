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
