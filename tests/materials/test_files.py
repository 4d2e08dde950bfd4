"""Every data file: its schema, its provenance, and that it is the one that was made."""

import json
from hashlib import sha256
from pathlib import Path
from typing import Any

import pytest
import yaml
from pydantic import BaseModel, ValidationError

from app.materials.location import data_directory
from app.materials.schema import Formula, Index, Points, SpectrumFile, Table
from tools.build_materials.selection import Material, choices, read_selection, read_tables

DIRECTORY = data_directory()
ROOT = Path(__file__).parents[2]
SPECTRA = sorted((DIRECTORY / "spectra").glob("*.json"))
TABLES = sorted((DIRECTORY / "tables").glob("*.yaml"))


def _lock() -> dict[str, Any]:
    lock: dict[str, Any] = json.loads((DIRECTORY / "lock.json").read_text(encoding="utf-8"))
    return lock


@pytest.mark.parametrize("path", SPECTRA, ids=lambda path: path.stem)
def test_spectrum_follows_the_schema_and_names_its_source(path: Path) -> None:
    spectrum = SpectrumFile.model_validate_json(path.read_bytes())
    assert path.stem == spectrum.id
    source = spectrum.provenance
    assert source.tag == "v2026-05-24"
    assert len(source.reference) > 20
    assert source.licence == "CC0-1.0"
    assert _lock()["pages"][source.file] == source.sha256
    assert spectrum.conditions.get("direction", "isotropic") == spectrum.axis
    for quantity in (spectrum.n, spectrum.k):
        assert quantity is None or _range(quantity)[0] < _range(quantity)[1]
    assert "Werner" not in source.page or spectrum.sample == "calculated"
    thickness = spectrum.conditions.get("film_thickness_nm")
    assert thickness is None or (spectrum.sample == "film" and spectrum.note)


def _range(quantity: Points | Formula) -> tuple[float, float]:
    if isinstance(quantity, Formula):
        return quantity.range_nm
    return quantity.wavelength_nm[0], quantity.wavelength_nm[-1]


@pytest.mark.parametrize("path", TABLES, ids=lambda path: path.stem)
def test_table_follows_the_schema_and_every_row_names_its_source(path: Path) -> None:
    table = Table.model_validate(yaml.safe_load(path.read_text(encoding="utf-8")))
    assert path.stem == table.id
    assert all(row.source == table.source for row in table.rows)
    assert all(row.id.endswith(f"-{table.id}") for row in table.rows)


def test_tables_are_whole() -> None:
    rows = {table.id: len(table.rows) for table in read_tables(DIRECTORY)}
    # 18 printed rows and the advice "when in doubt"; 23 printed rows.
    assert rows == {"shirley": 19, "wloka": 23}


def test_index_lists_every_file_and_row_once() -> None:
    index = Index.model_validate_json((DIRECTORY / "index.json").read_bytes())
    ids = [preset.id for preset in index.presets]
    rows = [row.id for table in read_tables(DIRECTORY) for row in table.rows]
    made = [choice.id for choice in choices(read_selection(DIRECTORY))]
    assert ids == made + rows
    assert len(ids) == len({id.casefold() for id in ids}) >= 75  # noqa: A001
    assert sorted(made) == sorted(path.stem for path in SPECTRA)
    for preset in index.presets:
        assert preset.source
        assert preset.licence
        assert preset.sample
        assert preset.confidence
        assert preset.n_range_nm is not None or "the source names no wavelength" in preset.warnings


def test_lock_has_the_hash_of_every_generated_file() -> None:
    lock = _lock()
    assert lock["database"]["tag"] == "v2026-05-24"
    listed = {entry["file"]: entry["sha256"] for entry in lock["files"]}
    assert {f"materials/spectra/{path.name}" for path in SPECTRA} < listed.keys()
    for name, digest in listed.items():
        assert sha256((ROOT / name).read_bytes()).hexdigest() == digest, name


def _fields(path: Path) -> dict[str, Any]:
    fields: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    return fields


COPPER = _fields(DIRECTORY / "spectra" / "Cu.json")
SEVERAL = {"kind": "points", "wavelength_nm": [400.0, 500.0], "values": [1.0, 2.0]}


@pytest.mark.parametrize(
    "changed",
    [
        {"unit": "nm"},
        {"confidence": "certain"},
        {"sample": "powder"},
        {"axis": "x"},
        {"id": "../passwd"},
        {"provenance": {**COPPER["provenance"], "sha256": "0"}},
        {"provenance": {k: v for k, v in COPPER["provenance"].items() if k != "reference"}},
        {"n": {**SEVERAL, "unit": "nm"}},
        {"n": {**SEVERAL, "wavelength_nm": [500.0, 400.0]}},
        {"n": {**SEVERAL, "wavelength_nm": [400.0, 400.0]}},
        {"n": {**SEVERAL, "values": [1.0]}},
        {"n": {"kind": "points", "wavelength_nm": [], "values": []}},
        {"n": {"kind": "formula", "number": 10, "coefficients": [1.0], "range_nm": [1.0, 2.0]}},
        {"n": None},
    ],
    ids=lambda changed: json.dumps(changed)[:40],
)
def test_anything_else_is_refused(changed: dict[str, Any]) -> None:
    SpectrumFile.model_validate_json(json.dumps(COPPER))
    with pytest.raises(ValidationError):
        SpectrumFile.model_validate_json(json.dumps({**COPPER, **changed}))


@pytest.mark.parametrize(
    ("model", "fields"),
    [
        (Index, {"database": {}, "presets": [], "version": 1}),
        (Table, {"id": "x", "title": "x", "source": "x", "rows": [], "unit": "nm"}),
        (Material, {"id": "x", "name": "x", "category": "metal", "page": "x/y/z", "colour": "red"}),
    ],
    ids=lambda value: getattr(value, "__name__", ""),
)
def test_unknown_keys_are_refused(model: type[BaseModel], fields: dict[str, Any]) -> None:
    with pytest.raises(ValidationError, match="Extra inputs are not permitted"):
        model.model_validate(fields)


@pytest.mark.parametrize(
    "changed",
    [{"n_min": 1.7}, {"n_min": 1.7, "n_max": 1.7}, {"n_min": 1.0, "n_max": 2.0}, {"n": 0.0}],
    ids=str,
)
def test_ranges_of_rows_hold_their_middle(changed: dict[str, Any]) -> None:
    row = {"id": "x", "name": "x", "category": "glass", "wavelength_nm": None, "source": "x"}
    table = {"id": "x", "title": "x", "source": "x", "confidence": "low", "licence": "x"}
    with pytest.raises(ValidationError):
        Table.model_validate({**table, "rows": [{**row, "n": 1.6, **changed}]})
