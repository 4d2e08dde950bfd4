"""`/atlas`: which formula for which material, counted again from the Parquet by other means."""

import io
from typing import Any

import numpy as np
import pyarrow.compute
import pyarrow.parquet
import pytest

from app.atlas.published import atlas_path
from tests.api.shape import Ask, error_of, json_of, rows_of


@pytest.fixture(scope="module")
def table() -> pyarrow.Table:
    return pyarrow.parquet.read_table(atlas_path())


def worst(table: pyarrow.Table, model: str, metric: str, band: str = "visible") -> dict[str, Any]:
    """The largest error of each material over its wavelengths, as rows in Python."""
    wavelengths: dict[str, set[str]] = {}
    found: dict[str, list[tuple[float, str]]] = {}
    names = ("material", "kind", "band", "wavelength_nm", "model", metric)
    columns = (table[name].to_pylist() for name in names)
    for material, kind, where, at, name, error in zip(*columns, strict=True):
        wavelengths.setdefault(material, set()).add(repr(at))
        if name == model and where == band:
            found.setdefault(material, []).append((abs(error), kind))
    return {
        material: (max((np.inf if np.isnan(e) else e) for e, _ in errors), errors[0][1])
        for material, errors in found.items()
        if len(errors) == len(wavelengths[material])
    }


@pytest.mark.parametrize(
    ("model", "metric", "within"),
    [
        ("schlick", "max_abs", 0.01),
        ("schlick", "max_abs", 0.05),
        ("f82_tint", "rms", 0.002),
        ("lazanyi2005", "albedo_error", 0.01),
        ("pharr_humphreys", "max_abs", 0.03),
    ],
)
def test_counts_are_those_of_the_file(
    ask: Ask, table: pyarrow.Table, model: str, metric: str, within: float
) -> None:
    told = json_of(ask("/atlas", model=model, metric=metric, within=within))
    by_hand = worst(table, model, metric)
    words = {"clear": "clear materials", "absorbing": "absorbing ", "metal": "metals"}
    for share in told["kinds"]:
        own = [error for error, kind in by_hand.values() if kind == share["kind"]]
        assert share["materials"] == len(own)
        small = sum(float(f"{error:.4g}") <= within for error in own)
        assert share["within"] == small
        assert f"{small:,} of {len(own):,} {words[share['kind']]}" in told["sentence"]
        assert share["undefined"] == sum(np.isinf(own))
        assert share["median"] == pytest.approx(
            float(np.median([e for e in own if np.isfinite(e)])), rel=1e-4
        )
    assert {s["kind"] for s in told["kinds"]} == {kind for _, kind in by_hand.values()}
    assert told["total"] == len(by_hand) == len(told["points"]["material"])
    assert f"{within * 100:g} %" in told["sentence"]
    (own,) = (share for share in told["models"] if share["model"] == model)
    assert (own["kinds"], own["sentence"]) == (told["kinds"], told["sentence"])


def test_color_differences_are_counted_where_there_is_a_color(
    ask: Ask, table: pyarrow.Table
) -> None:
    told = json_of(ask("/atlas", model="f82_tint", metric="delta_e"))
    assert told["within"] == 1.0
    rows = table.filter(pyarrow.compute.equal(table["model"], "f82_tint"))
    colors = dict(zip(rows["material"].to_pylist(), rows["delta_e"].to_pylist(), strict=True))
    metals = set(worst(table, "f82_tint", "rms"))
    known = {name: value for name, value in colors.items() if value == value and name in metals}
    assert told["total"] == len(known)
    assert sum(share["within"] for share in told["kinds"]) == sum(v <= 1.0 for v in known.values())
    assert "ΔE 1 " in told["sentence"]
    assert set(told["points"]["error_at_nm"]) == {None}


def test_points_come_with_the_largest_error_first(ask: Ask) -> None:
    points = json_of(ask("/atlas", model="schlick", kind="metal"))["points"]
    assert set(points["kind"]) == {"metal"}
    assert points["error"] == sorted(points["error"], reverse=True)
    n, k = np.array(points["n"]), np.array(points["k"], float)
    F0 = ((n - 1) ** 2 + k**2) / ((n + 1) ** 2 + k**2)
    np.testing.assert_allclose(points["F0"], F0, rtol=1e-9)
    gold = points["material"].index("Au")
    assert points["name"][gold] == "Gold"
    assert points["wavelength_nm"][gold] == 550.0
    told = json_of(ask("/errors", n_t=n[gold], k_t=points["k"][gold], models="schlick"))
    assert points["error"][gold] >= told["errors"][0]["max_abs"] * (1 - 1e-4)


def test_filters_leave_what_they_say(ask: Ask) -> None:
    every = json_of(ask("/atlas"))
    assert sum(every["shelves"].values()) >= every["total"]
    found = json_of(ask("/atlas", q="GOLD"))
    assert "Au" in found["points"]["material"]
    words = zip(found["points"]["material"], found["points"]["name"], strict=True)
    assert all("gold" in f"{material} {name}".casefold() for material, name in words)
    dark = json_of(ask("/atlas", F0_maximum=0.05))
    assert 0 < dark["total"] < every["total"]
    assert max(dark["points"]["F0"]) <= 0.05
    curated = json_of(ask("/atlas", shelf="curated", limit=7))
    assert set(curated["points"]["shelf"]) == {"curated"}
    assert len(curated["points"]["material"]) == 7
    assert curated["total"] == every["shelves"]["curated"]
    none = json_of(ask("/atlas", q="unobtainium"))
    assert (none["total"], none["models"], none["kinds"]) == (0, [], [])
    assert none["sentence"] == "The atlas has no material of those asked for."


def test_csv_has_a_row_each_material(ask: Ask) -> None:
    told = json_of(ask("/atlas", model="spherical_gaussian", limit=9))
    rows = rows_of(ask("/atlas", model="spherical_gaussian", limit=9, format="csv"))
    assert [row["material"] for row in rows] == told["points"]["material"]
    assert [float(row["error"]) for row in rows] == told["points"]["error"]
    assert [float(row["F0"]) for row in rows] == told["points"]["F0"]


def test_one_material_has_all_its_models(ask: Ask, table: pyarrow.Table) -> None:
    told = json_of(ask("/atlas/material", material="gold"))
    assert (told["material"], told["kind"]) == ("Au", "metal")
    own = table.filter(pyarrow.compute.equal(table["material"], "Au"))
    assert sorted({*own["model"].to_pylist()}) == sorted(rows["model"] for rows in told["models"])
    largest = [max(np.inf if e is None else e for e in rows["max_abs"]) for rows in told["models"]]
    assert largest == sorted(largest)
    rows = rows_of(ask("/atlas/material", material="gold", format="csv"))
    assert len(rows) == own.num_rows


def test_the_file_is_handed_out(ask: Ask, table: pyarrow.Table) -> None:
    answer = ask("/atlas/errors.parquet")
    assert answer.status_code == 200
    assert answer.headers["content-type"] == "application/vnd.apache.parquet"
    assert "fresnel_atlas.parquet" in answer.headers["content-disposition"]
    assert pyarrow.parquet.read_table(io.BytesIO(answer.content)).num_rows == table.num_rows


@pytest.mark.parametrize(
    ("path", "query", "parameter", "told"),
    [
        ("/atlas", {"model": "schlik"}, "model", "schlick"),
        ("/atlas", {"metric": "largest"}, "metric", "max_abs"),
        ("/atlas", {"metric": "delta_e", "model": "wloka_gc"}, "metric", "max_abs"),
        ("/atlas", {"shelf": "curate"}, "shelf", "curated"),
        ("/atlas", {"within": 0}, "within", "greater than 0"),
        ("/atlas", {"F0_minimum": 0.5, "F0_maximum": 0.4}, "F0_minimum", "at most"),
        ("/atlas", {"limit": 0}, "limit", "allowed: 1 to 10000"),
        ("/atlas", {"kind": "shiny"}, "kind", "metal"),
        ("/atlas/material", {"material": "vacuum"}, "material", "a material of the atlas"),
        ("/atlas/material", {"material": "unobtainium"}, "material", "id or an alias"),
        ("/atlas/material", {}, "material", "required"),
    ],
)
def test_what_is_wrong_is_told(
    ask: Ask, path: str, query: dict[str, Any], parameter: str, told: str
) -> None:
    error = error_of(ask(path, **query))
    assert error["parameter"] == parameter
    assert told in error["message"]


def test_every_model_and_metric_is_answered_or_refused(ask: Ask) -> None:
    for model in json_of(ask("/models", fields="id"))["models"]:
        for metric in ("max_abs", "rms", "albedo_error", "delta_e"):
            for band in ("visible", "elsewhere"):
                answer = ask("/atlas", model=model["id"], metric=metric, band=band, limit=2)
                assert answer.status_code in {200, 422}, answer.text
