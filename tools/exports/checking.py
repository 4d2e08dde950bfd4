"""All files of a library's targets, and what the library says of them."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from app.answers.materials.export import SHOWN_DEG, export
from app.export.registry import TARGETS
from app.export.surface import Surface
from app.export.target import ModeId, TargetId
from app.materials.films import Film, read_layers
from app.materials.media import default_catalog
from app.materials.schema import Preset
from app.optics.amplitudes import reflectance
from app.optics.color import WAVELENGTH_NM
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.parameters import Array
from tools.exports.libraries import Library

EVALUATED_NM = WAVELENGTH_NM[::10]

FILMED = ("Cu", "Si", "N-BK7", "water")
FILM = "1.46:300"
"""What is written with a film as well, where the target has one."""


def written(target: TargetId, folder: Path) -> list[dict[str, Any]]:
    """Write every material in every mode, some with a film, and return what is said of each file."""
    told = []
    for preset in default_catalog().presets:
        films = (None, *read_layers(FILM)) if preset.id in FILMED else (None,)
        for film in films:
            known = TARGETS[target].of(Surface(preset, "clamped", "srgb").kind)
            modes = [mode.id for mode in known if film is None or mode.film is not None]
            told += [_entry(preset, target, mode, film, folder) for mode in modes]
    return told


def _entry(
    preset: Preset, target: TargetId, mode: ModeId, film: Film | None, folder: Path
) -> dict[str, Any]:
    answer = export(preset, target, mode, film=film)
    (file,) = answer.files
    path = folder / target / mode / ("bare" if film is None else "film") / file.name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(file.text, encoding="utf-8")
    entry: dict[str, Any] = {"file": str(path), "material": preset.id, "mode": mode}
    entry |= {"theta_i_deg": list(SHOWN_DEG), "parameters": answer.parameters}
    if mode == "spectral":
        entry["wavelength_nm"] = EVALUATED_NM.tolist()
        entry["reflectance"] = _by_wavelength(Surface(preset, "clamped", "srgb")).tolist()
    else:
        entry["reflectance"] = answer.reflectance.tolist()
    return entry


def _by_wavelength(surface: Surface) -> Array:
    """Exact reflectance, an angle a row and a wavelength a column."""
    at = np.searchsorted(WAVELENGTH_NM, EVALUATED_NM)
    boundary = Interface(1.0, surface.visible.n[at], surface.visible.k[at])
    return reflectance(boundary, Incidence.from_degrees(np.array(SHOWN_DEG)[:, np.newaxis]))


def checked(library: Library, run: Sequence[str]) -> dict[str, Any]:
    """Let a library read all files of its targets.

    Parameters
    ----------
    library
        Which targets.
    run
        What runs its script, which answers on the last line.

    Raises
    ------
    RuntimeError
        With what the script says where it ends in an error.
    """
    with TemporaryDirectory() as folder:
        entries = [e for target in library.targets for e in written(target, Path(folder))]
        done = subprocess.run(run, input=json.dumps(entries), capture_output=True, text=True)
        if done.returncode:
            raise RuntimeError(done.stderr)
        answer: dict[str, Any] = json.loads(done.stdout.splitlines()[-1])
        return answer
