"""The routes about materials: list, detail, and what is refused."""

from __future__ import annotations

import httpx
import numpy as np
import pytest
from fastapi import FastAPI
from pydantic import TypeAdapter

from app.answers.materials.listing import Material
from app.export.registry import TARGETS
from app.materials.appearance import Viewing, appearance
from app.materials.media import default_catalog
from app.optics.color import decode_srgb
from app.optics.interface import Interface
from tests.api.shape import Ask, error_of, json_of

IDS = [preset.id for preset in default_catalog().presets]


def ids(answer: httpx.Response) -> list[str]:
    return [material["id"] for material in answer.json()["materials"]]


# The list


def test_the_list_is_whole_and_as_declared(ask: Ask) -> None:
    answer = ask("/materials").json()
    for row in answer["materials"]:  # the list may hold rows of some fields as well
        TypeAdapter(Material).validate_python(row, extra="forbid")
    assert [m["id"] for m in answer["materials"]] == IDS
    assert answer["total"] == len(IDS) == sum(answer["categories"].values())
    assert (answer["offset"], answer["limit"], answer["suggestions"]) == (0, None, [])
    for material in answer["materials"]:
        assert material["source"]
        assert material["licence"]
        assert material["swatch"]["gamut"] == "scaled"
        assert material["swatch"]["hex"].startswith("#")


def test_pages_together_are_the_list(ask: Ask) -> None:
    pages = [ask("/materials", offset=at, limit=50) for at in range(0, len(IDS), 50)]
    assert [i for page in pages for i in ids(page)] == IDS
    assert {page.json()["total"] for page in pages} == {len(IDS)}
    assert ids(ask("/materials", offset=100_000)) == []


@pytest.mark.parametrize("query", ["au", "Gold", "aurum", "GOLD", " gold "])
def test_gold_is_found_first(ask: Ask, query: str) -> None:
    assert ids(ask("/materials", q=query))[0] == "Au"


@pytest.mark.parametrize("typo", ["aurun", "gould", "auruum"])
def test_gold_is_suggested(ask: Ask, typo: str) -> None:
    answer = ask("/materials", q=typo).json()
    assert answer["total"] == 0
    assert "Au" in answer["suggestions"]


def test_filters_meet(ask: Ask) -> None:
    answer = ask("/materials", category="liquid", kind="spectrum", q="water").json()
    assert answer["materials"][0]["id"] == "water"
    for material in answer["materials"]:
        assert (material["category"], material["kind"]) == ("liquid", "spectrum")
    assert ask("/materials", kind="single", category="metal").json()["total"] == 0


@pytest.mark.parametrize("encoding", ["br", "gzip", "zstd"])
def test_caches_and_compression(ask: Ask, encoding: str) -> None:
    answer = ask("/materials", headers={"Accept-Encoding": encoding})
    assert answer.headers["content-encoding"] == encoding
    assert answer.json() == ask("/materials", headers={"Accept-Encoding": "identity"}).json()
    held = {"If-None-Match": answer.headers["etag"]}
    assert ask("/materials", headers=held).status_code == 304


def test_digits(ask: Ask) -> None:
    row = ask("/materials", q="Au", limit=1, digits=3).json()["materials"][0]
    assert (row["n"], row["k"]) == (0.224, 2.98)


# One material


@pytest.mark.parametrize("id", IDS)
def test_every_preset_has_a_page(ask: Ask, id: str) -> None:  # noqa: A002
    answer = ask(f"/materials/{id}").json()
    listed = default_catalog().get(id)
    assert answer["constants"]["n"] == pytest.approx(listed.n, rel=1e-9)
    assert answer["constants"]["F0"] == pytest.approx(listed.F0, abs=1e-9)
    assert answer["color"]["F0"] == pytest.approx(listed.color.F0, abs=1e-6)
    assert answer["color"]["F82"] == pytest.approx(listed.color.F82, abs=1e-6)
    assert id in answer["spread"]["ids"]
    assert (answer["provenance"] is None) == (listed.kind == "single")


def test_provenance_goes_down_to_the_bytes(ask: Ask) -> None:
    provenance = ask("/materials/Ag").json()["provenance"]
    assert provenance["page"] == "main/Ag/Johnson"
    assert provenance["doi"] == ["10.1103/PhysRevB.6.4370"]
    assert len(provenance["sha256"]) == 64
    assert provenance["licence"] == "CC0-1.0"


def test_rivals_and_their_spread(ask: Ask) -> None:
    gold = ask("/materials/Au").json()
    names = {rival["id"] for rival in gold["rivals"]}
    assert {"Au-Johnson", "Au-McPeak", "Au-Babar"} <= names
    bright = [rival["luminance"] for rival in gold["rivals"]] + [gold["color"]["luminance"]]
    assert gold["spread"]["minimum"] == pytest.approx(min(bright), abs=1e-6)
    assert gold["spread"]["maximum"] == pytest.approx(max(bright), abs=1e-6)
    assert "Au" in {rival["id"] for rival in ask("/materials/Au-Johnson").json()["rivals"]}


def test_aliases_name_the_same(ask: Ask) -> None:
    assert ask("/materials/gold").json() == ask("/materials/Au").json()


def test_a_wavelength_of_choice(ask: Ask) -> None:
    constants = ask("/materials/Cu", wavelength_nm=700).json()["constants"]
    boundary = Interface(1.0, constants["n"], constants["k"])
    assert constants["wavelength_nm"] == 700.0
    assert constants["F0"] == pytest.approx(float(boundary.F0), rel=1e-15)
    assert constants["F0"] > 0.95
    answer = ask("/materials/Cu", wavelength_nm=2000)
    assert answer.status_code == 422
    assert "187.9 to 1937 nm" in answer.json()["detail"]


@pytest.mark.parametrize("gamut", ["unclamped", "clamped", "scaled"])
def test_gamut_policies_of_gold(ask: Ask, gamut: str) -> None:
    answer = ask("/materials/Au", gamut=gamut).json()
    raw, shown = np.array(answer["color"]["F0"]), answer["display"]
    expected = {"unclamped": raw, "clamped": np.clip(raw, 0, 1), "scaled": raw / raw.max()}[gamut]
    assert shown["F0"] == pytest.approx(expected.tolist(), abs=1e-15)
    assert shown["in_gamut"] is False
    assert (shown["hex"] is None) == (gamut == "unclamped")
    assert answer["swatch"] == {"gamut": gamut, "hex": shown["hex"]}
    if shown["hex"]:
        encoded = np.array(list(bytes.fromhex(shown["hex"][1:]))) / 255.0
        assert np.allclose(decode_srgb(encoded), expected, atol=5e-3)


@pytest.mark.parametrize("gamut", ["clamped", "scaled"])
@pytest.mark.parametrize("light", [{}, {"illuminant": "E", "adaptation": "none"}])
def test_displayed_colors_can_be_typed_everywhere(
    ask: Ask, gamut: str, light: dict[str, str]
) -> None:
    for id in ("Au", "red-brass", "diamond", "Cu-Babar"):  # noqa: A001
        shown = ask(f"/materials/{id}", gamut=gamut, **light).json()["display"]
        for look in (shown, shown["acescg"]):
            numbers = [look[name] for name in ("F0", "F82", "F82_tint")]
            assert np.min(numbers) >= 0.0
            assert np.max(numbers) <= 1.0
        for name, code in shown["codes"].items():
            typed = decode_srgb(np.array(list(bytes.fromhex(code[1:]))) / 255.0)
            assert np.allclose(typed, shown[name], atol=5e-3)
        assert "IEC 61966-2-1" in shown["transfer"]


def test_colors_that_cannot_be_typed_say_so(ask: Ask) -> None:
    assert ask("/materials/Au").json()["color"]["outside_0_to_1"] == ["F0", "F82_tint"]
    assert ask("/materials/Cr").json()["color"]["outside_0_to_1"] == []
    shown = ask("/materials/Au", gamut="unclamped").json()["display"]
    assert shown["codes"]["F0"] is None


@pytest.mark.parametrize("id", ["Cu", "default-shirley"])
def test_light_and_observer(ask: Ask, id: str) -> None:  # noqa: A002
    daylight = np.array(ask(f"/materials/{id}").json()["color"]["F0"])
    adapted = np.array(ask(f"/materials/{id}", illuminant="E").json()["color"]["F0"])
    cast = np.array(
        ask(f"/materials/{id}", illuminant="E", adaptation="none").json()["color"]["F0"]
    )
    assert np.allclose(adapted, daylight, atol=0.03)
    assert abs(cast[0] / daylight[0] - 1.0) > 0.1
    wide = ask(f"/materials/{id}", observer="cie1964_10deg").json()["color"]
    assert wide["observer"] == "cie1964_10deg"
    assert np.allclose(wide["F0"], daylight, atol=0.03)


def test_colors_are_those_of_the_core(ask: Ask) -> None:
    how = Viewing("E", "cie1964_10deg", "none")
    color = appearance(default_catalog().spectrum("Cu"), 1.0, how)
    answer = ask("/materials/Cu", **how._asdict()).json()["color"]
    assert answer["F82_tint"] == color.F82_tint.tolist()
    assert answer["luminance"] == color.luminance


def test_pairs_of_n_and_k_stand_beside_other_ways(ask: Ask) -> None:
    answer = ask("/materials/Cr/rgb_nk").json()
    ways = {way["way"]: way for way in answer["ways"]}
    assert list(ways) == ["fitted", "three_wavelengths", "averaged", "f82_tint"]
    assert ways["fitted"]["inputs"] == {"n": answer["n"], "k": answer["k"]}
    errors = {name: way["error"]["max_abs"] for name, way in ways.items()}
    assert errors["fitted"] < 1e-3 < errors["averaged"] < errors["three_wavelengths"]
    assert errors["f82_tint"] > 0.01
    # At the angle that is said, the channel that is said is as far off as is said, by another route.
    tint = ways["f82_tint"]["error"]
    curves = ask("/materials/Cr/curves", models="f82_tint", samples=361, gamut="clamped").json()[
        "rgb"
    ]["curves"]
    truth, model = (np.array(curve[f"R_{tint['channel']}"]) for curve in curves)
    row = round(4 * tint["at_deg"])
    assert abs(model - truth)[row] == pytest.approx(tint["max_abs"], abs=1e-12)
    assert abs(model - truth).max() == pytest.approx(tint["max_abs"], abs=1e-12)


@pytest.mark.parametrize("to", list(TARGETS))
def test_an_export_is_a_file_and_json_about_it(ask: Ask, to: str) -> None:
    file = ask("/materials/gold/export", to=to)
    told = ask("/materials/gold/export", to=to, format="json").json()
    (only,) = told["files"]
    assert file.text == only["text"]
    assert file.headers["content-disposition"] == f'inline; filename="{only["name"]}"'
    assert file.headers["content-type"].startswith(TARGETS[told["to"]].media_type)
    engine = told["error"]["measured_with"]["engine"]
    assert engine is None or ask(f"/engines/{engine}").status_code == 200


def test_what_is_no_export_is_refused_by_name(ask: Ask) -> None:
    for query, name in (
        ({}, "to"),
        ({"to": "unreal"}, "to"),
        ({"to": "gltf", "mode": "nk"}, "mode"),
        ({"to": "gltf", "policy": "unclamped"}, "policy"),
        ({"to": "usd", "space": "acescg"}, "space"),
    ):
        answer = ask("/materials/Au/export", **query)
        assert answer.status_code == 422
        assert [e["parameter"] for e in answer.json()["errors"]] == [name]


def test_convert_has_the_pairs_where_asked(ask: Ask) -> None:
    pairs = ask("/convert", **{"from": "nk"}, material="Au", to="rgb_nk").json()["rgb_nk"]
    assert pairs == ask("/materials/gold/rgb_nk").json()
    assert "rgb_nk" not in ask("/convert", **{"from": "nk"}, material="Au").json()
    for query, name in (
        ({"n_t": "1.5"}, "material"),
        ({"material": "water", "n_i": "1.2"}, "n_i"),
        ({"material": "water", "format": "csv"}, "format"),
    ):
        answer = ask("/convert", to="rgb_nk", **query)
        assert answer.status_code == 422
        assert [e["parameter"] for e in answer.json()["errors"]] == [name]


# What is refused


def test_a_wavelength_is_refused_as_it_was_given(ask: Ask) -> None:
    for query in ({}, {"incident": "glycerol"}):
        (error,) = ask("/materials/Au/curves", wavelengths_nm="299", **query).json()["errors"]
        assert (error["parameter"], error["value"]) == ("wavelengths_nm", "299")


def test_an_unknown_id_names_the_nearest(ask: Ask) -> None:
    for tail in ("", "/spectrum", "/curves", "/map", "/rgb_nk"):
        answer = ask(f"/materials/goldd{tail}")
        assert answer.status_code == 404
        assert "nearest: Au" in answer.json()["errors"][0]["message"]


def test_answers_have_names_and_wavelengths_a_unit(app: FastAPI) -> None:
    paths = {
        path: of
        for path, of in app.openapi()["paths"].items()
        if "/materials" in path and "get" in of
    }
    assert len(paths) == 8
    for path, methods in paths.items():
        answer = methods["get"]["responses"]["200"]["content"]["application/json"]
        assert "$ref" in answer["schema"], path
        for parameter in methods["get"]["parameters"]:
            if parameter["name"].endswith("_nm") and parameter["name"] != "wavelengths_nm":
                assert "nm" in parameter["description"], (path, parameter["name"])


@pytest.mark.parametrize("cover", ["medium", "coat", "pane"])
def test_a_material_under_something(ask: Ask, cover: str) -> None:
    told = json_of(ask("/materials/Au/covered", cover=cover, of="water", illuminant="E"))
    assert told["medium"]["incident"]["id"] == "water"
    assert len(told["theta_i_deg"]) == len(told["reflectance"]) == 90
    assert told["reflectance"][0] == pytest.approx(
        json_of(
            ask("/materials/Au/covered", cover=cover, of="water", gamut="unclamped", illuminant="E")
        )["whole"]["F0"],
        abs=1e-12,
    )
    assert bool(told["shortcuts"]) == (cover == "coat")
    below = {"medium": told["whole"], "coat": told["below"], "pane": told["air"]}
    assert told["below"]["F0"] == pytest.approx(below[cover]["F0"], abs=1e-12)


def test_a_cover_that_is_none(ask: Ask) -> None:
    both = error_of(ask("/materials/Au/covered", n=1.4, of="water"))
    assert both["parameter"] == "n"
    dark = error_of(ask("/materials/Au/covered", of="Cu"))
    assert (dark["parameter"], "transparent" in dark["message"]) == ("of", True)
    thin = error_of(ask("/materials/Au/covered", n=0.5))
    assert thin["parameter"] == "n"
