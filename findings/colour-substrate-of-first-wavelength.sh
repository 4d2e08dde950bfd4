#!/usr/bin/env bash
# One would guess: multilayer_tmm takes an index for each medium and wavelength, so each
# wavelength's T is worked out with the substrate's index at that wavelength.
# What happens: T of every wavelength uses the substrate's index of the FIRST wavelength. R is
# right. For a lossless substrate of 1.5 at 550 nm and 2.0 at 650 nm, R + T is 1 at 550 nm and
# 0.7518 at 650 nm; the same two wavelengths in the other order give 1 at 650 nm and 1.3286 at
# 550 nm. No warning; a substrate without dispersion does not show it.
# Measured 2026-11-29 with colour-science 0.4.7.
# Touches: a spectrum of T on a dispersive substrate; call it one wavelength at a time instead.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3}" -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet --disable-pip-version-check colour-science==0.4.7 scipy==1.15.3 numpy==2.2.6
"$folder/venv/bin/python" - <<'PYTHON'
import warnings
from importlib.metadata import version

warnings.simplefilter("ignore")
import numpy as np
from colour.phenomena import multilayer_tmm

print("colour-science", version("colour-science"))
found = []
for wavelengths, substrate in (((550, 650), (1.5, 2.0)), ((650, 550), (2.0, 1.5))):
    media = np.array([(1.0, 1.0), (1.38, 1.38), substrate])
    r, t = multilayer_tmm(media, np.array([100.0]), np.array(wavelengths), 0)
    sums = (r + t)[:, 0, 0, 0]
    found += list(map(float, sums))
    print("wavelengths", wavelengths, "substrate", substrate, "R + T", sums.round(4))
r, t = multilayer_tmm(media[:, 1:], np.array([100.0]), np.array([550]), 0)
alone = float((r + t).ravel()[0])
print("550 nm alone: R + T", round(alone, 4))
same = (
    np.allclose(found, [1, 0.7518, 1, 1.3286], atol=1e-4) and abs(alone - 1) < 1e-9
)
print("unchanged" if same else "CHANGED")
raise SystemExit(0 if same else 1)
PYTHON
