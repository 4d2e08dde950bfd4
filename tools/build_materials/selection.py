"""`materials/selection.yaml`: which page of the database stands for which material."""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import yaml
from pydantic import Field, TypeAdapter

from app.materials.schema import (
    Axis,
    Category,
    Confidence,
    Id,
    Reference,
    Sample,
    Strict,
    Table,
    Text,
)

PagePath = Annotated[str, Field(pattern=r"^[^/]+/[^/]+/[^/]+$")]


class Rival(Strict):
    """Another measurement of the material that it stands under."""

    page: PagePath
    name: Text | None = None
    """Its own, where it is another product; the material's with the page unless given."""
    axis: Axis = "isotropic"
    sample: Sample
    confidence: Confidence
    relative_to: Reference | None = None
    wavelength_in: Reference | None = None
    note: Text | None = None


class Material(Strict):
    """A material and the page that stands for it."""

    id: Id
    name: Text
    aliases: tuple[Text, ...] = ()
    category: Category
    page: PagePath
    axis: Axis = "isotropic"
    sample: Sample
    confidence: Confidence
    relative_to: Reference | None = None
    wavelength_in: Reference | None = None
    note: Text | None = None
    rivals: tuple[Rival, ...] = ()


@dataclass(frozen=True)
class Choice:
    """One spectrum to make: a material's own, or a rival's."""

    id: str
    name: str
    aliases: tuple[str, ...]
    rival_of: str | None
    material: Material
    entry: Material | Rival


def read_selection(directory: Path) -> tuple[Material, ...]:
    """Read the selection of a data directory."""
    text = (directory / "selection.yaml").read_text(encoding="utf-8")
    return TypeAdapter(tuple[Material, ...]).validate_python(yaml.safe_load(text))


def read_tables(directory: Path) -> tuple[Table, ...]:
    """Read the single-index tables of a data directory, in the order of their names."""
    files = sorted((directory / "tables").glob("*.yaml"))
    return tuple(
        Table.model_validate(yaml.safe_load(file.read_text(encoding="utf-8"))) for file in files
    )


def choices(materials: tuple[Material, ...]) -> Iterator[Choice]:
    """Every spectrum of a selection: all materials, then all their rivals."""
    for material in materials:
        yield Choice(material.id, material.name, material.aliases, None, material, material)
    for material in materials:
        for rival in material.rivals:
            page = rival.page.rsplit("/", 1)[1]
            name = rival.name or f"{material.name} ({page})"
            yield Choice(f"{material.id}-{page}", name, (), material.id, material, rival)
