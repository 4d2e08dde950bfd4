"""`python -m tools.exports` checks all exports with all libraries; with names, those alone.

Each library's line tells how many files it read, how many it found wrong, what it warned of, and, where
it evaluates the material, how far its reflectance is from what the answer says. Packages are installed
below the folder that FRESNEL_LIBRARIES names, else below a temporary one.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from app.answers.materials.export import SHOWN_DEG, export
from app.export.registry import TARGETS
from app.export.surface import Surface
from app.export.target import TargetId
from app.materials.media import default_catalog
from app.optics.amplitudes import reflectance
from app.optics.color import WAVELENGTH_NM
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.parameters import Array
from tools.exports.libraries import LIBRARIES, Library, command

EVALUATED_NM = WAVELENGTH_NM[::10]


def written(target: TargetId, folder: Path) -> list[dict[str, Any]]:
    """Write every material in every mode, and return what is said of each file."""
    told = []
    for preset in default_catalog().presets:
        first = export(preset, target)
        for mode in first.modes:
            answer = export(preset, target, mode)
            (file,) = answer.files
            path = folder / target / mode / file.name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(file.text, encoding="utf-8")
            entry: dict[str, Any] = {"file": str(path), "material": preset.id, "mode": mode}
            entry |= {"theta_i_deg": list(SHOWN_DEG), "parameters": answer.parameters}
            if mode == "spectral":
                entry["wavelength_nm"] = EVALUATED_NM.tolist()
                entry["reflectance"] = _by_wavelength(Surface(preset, "clamped", "srgb")).tolist()
            else:
                entry["reflectance"] = answer.reflectance.tolist()
            told.append(entry)
    return told


def _by_wavelength(surface: Surface) -> Array:
    """Exact reflectance, an angle a row and a wavelength a column."""
    at = np.searchsorted(WAVELENGTH_NM, EVALUATED_NM)
    boundary = Interface(1.0, surface.visible.n[at], surface.visible.k[at])
    return reflectance(boundary, Incidence.from_degrees(np.array(SHOWN_DEG)[:, np.newaxis]))


def checked(library: Library, libraries: Path) -> dict[str, Any]:
    """Let a library read all files of its targets; its script answers on the last line."""
    with TemporaryDirectory() as folder:
        entries = [e for target in library.targets for e in written(target, Path(folder))]
        run = command(library, libraries)
        done = subprocess.run(run, input=json.dumps(entries), capture_output=True, text=True)
        if done.returncode:
            raise SystemExit(done.stderr)
        answer: dict[str, Any] = json.loads(done.stdout.splitlines()[-1])
        return answer


def main(names: list[str]) -> int:
    """Check, and print a line a library; 1 if a file is wrong."""
    known = [library.package for library in LIBRARIES]
    if unknown := set(names) - set(known):
        print(f"{', '.join(sorted(unknown))}: known are {', '.join(known)}", file=sys.stderr)
        return 2
    unread = set(TARGETS) - {target for library in LIBRARIES for target in library.targets}
    print(f"{', '.join(sorted(unread))}: no library of Python's index or npm reads these alone")
    wrong = False
    with TemporaryDirectory() as temporary:
        libraries = Path(os.environ.get("FRESNEL_LIBRARIES", temporary))
        for library in LIBRARIES:
            if names and library.package not in names:
                continue
            answer = checked(library, libraries)
            print(f"{library.package} {library.version}: {json.dumps(answer, ensure_ascii=False)}")
            wrong |= bool(answer["errors"])
    return int(wrong)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
