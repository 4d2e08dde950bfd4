"""`material`, `incident` and `wavelength_nm` in place of numbers, on every route with two media."""

import math
import re
from typing import Any

import pytest
from fastapi import FastAPI

from app.materials.media import NEGLIGIBLE_K, default_catalog
from app.settings import Settings
from tests.api.shape import Ask, error_of

PRESETS = ("material", "incident", "wavelength_nm")


@pytest.mark.parametrize("id", ["Au", "Cu-McPeak", "BK7", "fused-silica", "water-shirley"])
@pytest.mark.parametrize("path", ["/snell", "/curves", "/albedo"])
def test_a_material_stands_for_its_numbers(ask: Ask, path: str, id: str) -> None:  # noqa: A002
    known = default_catalog().constants(id)
    named = ask(path, material=id).json()
    k_t = 0.0 if known.k is None or known.k < NEGLIGIBLE_K else known.k
    told = ask(path, n_t=known.n_absolute, k_t=k_t).json()
    preset = named["interface"].pop("material")
    assert (preset["id"], preset["n"], preset["k"]) == (id, known.n, known.k)
    assert preset["wavelength_nm"] == known.wavelength_nm
    assert preset["source"] == default_catalog().get(id).source
    assert told["interface"].pop("material") is None
    assert named == told


@pytest.mark.parametrize("path", ["/snell", "/curves", "/albedo"])
def test_both_media_at_a_wavelength(ask: Ask, path: str) -> None:
    catalog = default_catalog()
    water, gold = catalog.constants("water", 500.0), catalog.constants("Au", 500.0)
    interface = ask(path, incident="water", material="gold", wavelength_nm=500).json()["interface"]
    assert (interface["n_i"], interface["n_t"], interface["k_t"]) == (water.n, gold.n, gold.k)
    assert interface["incident"]["id"] == "water"
    assert interface["material"]["id"] == "Au"
    assert interface["incident"]["wavelength_nm"] == interface["material"]["wavelength_nm"] == 500


def test_only_the_named_side_is_replaced(ask: Ask) -> None:
    interface = ask("/snell", incident="water-shirley", n_t=2.0, k_t=0.5).json()["interface"]
    assert (interface["n_i"], interface["n_t"], interface["k_t"]) == (1.333, 2.0, 0.5)
    assert interface["material"] is None
    interface = ask("/snell", material="Au", n_i=1.5).json()["interface"]
    assert interface["n_i"] == 1.5
    assert interface["incident"] is None


def test_the_default_wavelength_is_587_6_nm(ask: Ask) -> None:
    assert ask("/snell", material="Cu").json()["interface"]["material"]["wavelength_nm"] == 587.6


@pytest.mark.parametrize(
    ("query", "parameter", "message"),
    [
        ({"material": "Au", "n_t": 1.5}, "n_t", "material = Au"),
        ({"material": "Au", "k_t": 0}, "k_t", "material = Au"),
        ({"incident": "water", "n_i": 1}, "n_i", "incident = water"),
        ({"material": "aurun"}, "material", "nearest: Au"),
        ({"incident": "watr"}, "incident", "nearest: water"),
        ({"incident": "Au"}, "incident", "transparent"),
        ({"wavelength_nm": 500}, "wavelength_nm", "no material or incident"),
        ({"material": "Au", "wavelength_nm": 299.9}, "wavelength_nm", "300 to 24930 nm"),
        ({"material": "Au", "wavelength_nm": 1e6}, "wavelength_nm", "300 to 24930 nm"),
        ({"material": "Au", "wavelength_nm": 24930}, "wavelength_nm", "0 to 100"),
        ({"material": "Au", "wavelength_nm": "nan"}, "wavelength_nm", ""),
        ({"material": "Au", "wavelength_nm": 0}, "wavelength_nm", "greater than 0"),
        ({"incident": "water-shirley", "wavelength_nm": 500}, "wavelength_nm", "589 nm"),
        ({"material": "ice-wloka", "wavelength_nm": 500}, "wavelength_nm", "names none"),
        ({"material": ""}, "material", ""),
        ({"material": "x" * 101}, "material", ""),
    ],
    ids=str,
)
@pytest.mark.parametrize("path", ["/snell", "/curves", "/albedo"])
def test_refusals(ask: Ask, path: str, query: dict[str, Any], parameter: str, message: str) -> None:
    error = error_of(ask(path, **query))
    assert error["parameter"] == parameter
    assert message in error["message"]


def test_a_k_that_is_not_known_is_said_to_count_as_0(ask: Ask) -> None:
    interface = ask("/snell", material="diamond").json()["interface"]
    assert interface["k_t"] == 0.0
    assert interface["material"]["k"] is None
    assert interface["material"]["warnings"] == ["k is not known and counts as 0"]


def test_a_trace_of_absorption_counts_as_0_on_both_sides_and_is_said(ask: Ask) -> None:
    k = default_catalog().constants("BK7").k
    assert k is not None
    assert 0.0 < k < NEGLIGIBLE_K
    incident = ask("/snell", incident="BK7").json()["interface"]["incident"]
    assert incident["k"] == k
    assert any("left out" in warning for warning in incident["warnings"])
    material = ask("/snell", material="BK7").json()["interface"]
    assert material["k_t"] == 0.0
    assert material["kind"] == "dielectric"
    assert material["brewster_deg"] == pytest.approx(math.degrees(math.atan(material["n_t"])))
    assert material["material"]["k"] == k
    (warning,) = material["material"]["warnings"]
    # Taking the advice keeps the measured k.
    n_t, k_t = re.findall(r"[nk]_t = (\S+)", warning)
    kept = ask("/snell", n_t=n_t, k_t=k_t).json()["interface"]
    assert (kept["n_t"], kept["k_t"], kept["kind"]) == (material["n_t"], k, "conductor")


def test_the_page_has_the_same_rule_for_a_trace_of_absorption() -> None:
    scripts = "".join(path.read_text("utf-8") for path in Settings().static_dir.glob("js/**/*.js"))
    (found,) = re.findall(r"const NEGLIGIBLE = (\S+);", scripts)
    assert float(found) == NEGLIGIBLE_K


def test_the_middle_of_a_range_is_said(ask: Ask) -> None:
    warnings = ask("/snell", material="garnet-wloka").json()["interface"]["material"]["warnings"]
    assert "the source gives n from 1.73 to 1.89; this is the middle" in warnings


def test_vacuum_is_1_at_every_wavelength(ask: Ask) -> None:
    answer = ask("/snell", incident="vacuum-shirley", material="Cu", wavelength_nm=400).json()
    assert answer["interface"]["n_i"] == 1.0
    assert answer["interface"]["incident"]["wavelength_nm"] == 400.0


def test_every_route_with_two_media_takes_presets(app: FastAPI) -> None:
    asked = 0
    for path, methods in app.openapi()["paths"].items():
        names = {p["name"] for p in methods.get("get", {}).get("parameters", [])}
        # Formulas are about the letters, and what engines take is the material's, from vacuum.
        of_media = not path.startswith(("/api/v1/formulas/", "/api/v1/export"))
        if "n_t" in names and of_media:
            # What runs over the wavelength takes a range, or a light, in its place.
            over_wavelength = names & {"minimum_nm", "illuminant"}
            wanted = PRESETS[:2] if over_wavelength else PRESETS
            assert names.issuperset(wanted), path
            asked += 1
    assert asked >= 3
