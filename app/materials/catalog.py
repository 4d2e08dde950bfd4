"""The presets by id and alias, loaded once."""

from __future__ import annotations

import difflib
from collections.abc import Iterable
from pathlib import Path

import yaml

from app.materials.errors import UnknownMaterial
from app.materials.location import data_directory
from app.materials.schema import Preset, Table


class Catalog:
    """All presets, found by id or alias without regard to case."""

    def __init__(self, presets: Iterable[Preset]) -> None:
        self.presets = tuple(presets)
        self._by_id = {preset.id: preset for preset in self.presets}
        self._by_name: dict[str, Preset] = {}
        for preset in self.presets:
            for name in (preset.id, preset.name, *preset.aliases):
                self._by_name.setdefault(name.casefold(), preset)

    def get(self, id: str) -> Preset:  # noqa: A002
        """Return the preset of an id, else of an alias or name.

        Raises
        ------
        UnknownMaterial
            With the nearest ids.
        """
        found = self._by_id.get(id) or self._by_name.get(id.casefold())
        if found is None:
            close = difflib.get_close_matches(id.casefold(), self._by_name, n=5, cutoff=0.5)
            raise UnknownMaterial(id, tuple(dict.fromkeys(self._by_name[c].id for c in close)))
        return found


def load_catalog(path: Path | None = None) -> Catalog:
    """Load the catalog of a data directory, by default the one that comes with the program."""
    directory = data_directory() if path is None else path
    presets: list[Preset] = []
    for file in sorted((directory / "tables").glob("*.yaml")):
        table = Table.model_validate(yaml.safe_load(file.read_text(encoding="utf-8")))
        presets.extend(table.rows)
    return Catalog(presets)
