"""Every generated file as a path and its text."""

from dataclasses import asdict
from hashlib import sha256
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np
from pydantic import TypeAdapter

from app.materials.published.index import FILE as PUBLISHED
from app.materials.schema import Database, Preset, Provenance, SpectrumFile
from app.materials.spectrum import Spectrum
from tools.build_materials.color_tables import color_tables
from tools.build_materials.database import read_page, release
from tools.build_materials.index import row_presets, spectrum_preset
from tools.build_materials.published import published_index
from tools.build_materials.samples import package_samples
from tools.build_materials.selection import Choice, choices, read_selection, read_tables
from tools.build_materials.writing import list_text, object_text

COLOR_TABLES = "app/optics/tables/cie_360_830_1nm.csv"
SAMPLES = "tests/materials/package_samples.json"
SCANNED = 20001
"""Wavelengths at which a formula has to make sense."""


def generated_files(root: Path) -> dict[str, str]:
    """Return the text of every generated file by its path below the project's root."""
    directory = root / "materials"
    database = release()
    files: dict[str, str] = {COLOR_TABLES: color_tables()}
    presets: list[Preset] = []
    pages: dict[str, str] = {}
    samples: list[dict[str, Any]] = []
    for choice in choices(read_selection(directory)):
        spectrum = spectrum_file(choice, database)
        pages[spectrum.provenance.file] = spectrum.provenance.sha256
        presets.append(spectrum_preset(choice, spectrum))
        samples.append(package_samples(spectrum))
        files[f"materials/spectra/{choice.id}.json"] = object_text(spectrum)
    for table in read_tables(directory):
        presets.extend(row_presets(table))
    _refuse_ambiguity(presets)
    listed = TypeAdapter(list[Preset]).dump_python(presets, mode="json", exclude_defaults=True)
    files[f"materials/{PUBLISHED}"] = published_index(
        root, list(choices(read_selection(directory)))
    )
    files["materials/index.json"] = list_text({"database": asdict(database)}, "presets", listed)
    files[SAMPLES] = list_text({"package": database.package}, "samples", samples)
    files["materials/lock.json"] = _lock(database, pages, files)
    return files


def spectrum_file(choice: Choice, database: Database) -> SpectrumFile:
    """Join what the selection says of a page to what the page holds."""
    entry = choice.entry
    page = read_page(entry.page)
    if page.told.conditions.get("direction", "isotropic") != entry.axis:
        raise ValueError(f"{entry.page} is of axis {page.told.conditions.get('direction')}")
    file = SpectrumFile(
        id=choice.id,
        name=choice.name,
        category=choice.material.category,
        axis=entry.axis,
        sample=entry.sample,
        confidence=entry.confidence,
        conditions=page.told.conditions,
        relative_to=entry.relative_to,
        wavelength_in=entry.wavelength_in,
        note=entry.note,
        warnings=page.warnings,
        provenance=Provenance(
            database=database.name,
            tag=database.tag,
            page=entry.page,
            file=page.file,
            sha256=page.told.sha256,
            reference=page.told.reference,
            doi=page.told.doi,
            links=page.told.links,
            licence=database.licence,
            comments=page.told.comments,
        ),
        n=page.n,
        k=page.k,
    )
    spectrum = Spectrum(file)
    _refuse_impossible(spectrum)
    return file.model_copy(update={"warnings": (*page.warnings, *spectrum.visible.warnings)})


def _refuse_impossible(spectrum: Spectrum) -> None:
    """Refuse a formula that has no positive n somewhere in the range it claims."""
    low, high = spectrum.n_range_nm
    with np.errstate(invalid="ignore", divide="ignore"):
        n = spectrum.n(np.clip(np.geomspace(low, high, SCANNED), low, high))
    if not bool(np.all(np.isfinite(n) & (n > 0.0))):
        raise ValueError(f"n of {spectrum.id} is no positive number throughout its range")


def _refuse_ambiguity(presets: list[Preset]) -> None:
    ids = [preset.id.casefold() for preset in presets]
    aliases = [
        alias.casefold()
        for preset in presets
        if preset.kind == "spectrum"
        for alias in preset.aliases
    ]
    for names in (ids, [*ids, *aliases]):
        twice = sorted({name for name in names if names.count(name) > 1})
        if twice:
            raise ValueError(f"names that two materials share: {', '.join(twice)}")


def _lock(database: Database, pages: dict[str, str], files: dict[str, str]) -> str:
    head = {
        "database": asdict(database),
        "color_tables": f"colour-science {version('colour-science')}",
        "pages": dict(sorted(pages.items())),
    }
    listed = [
        {"file": name, "sha256": sha256(text.encode()).hexdigest()}
        for name, text in sorted(files.items())
    ]
    return list_text(head, "files", listed)
