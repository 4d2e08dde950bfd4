#!/usr/bin/env bash
# One would guess: the dominant wavelength of light of 560 nm is 560 nm; that of the mixture with white too; and
# a yellow has one near 575 nm.
# What happens: it looks for the point of the spectral locus whose vector from white has the largest *product*
# with the color's, not the same direction, so far points of the locus win: 560 nm is told as 525, 480 as 460, 580 and 600
# as 775, the yellow of sRGB as 530. Only around 520 nm, where the locus is farthest away, is it right.
# Measured 2026-11-30 with build-color 1.0.2, against the wavelengths themselves (by its own table of the CIE 1931
# observer) and against colour-science 0.4.7.
# Touches: nothing of ours.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3}" -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet --disable-pip-version-check build-color==1.0.2 colour-science==0.4.7 numpy==2.2.6 scipy==1.15.3
"$folder/venv/bin/python" - <<'PYTHON'
import warnings
from importlib.metadata import version

warnings.simplefilter("ignore")
import colour
import numpy as np
from build_color import spectral

print("build-color", version("build-color"), "colour-science", version("colour-science"))
WHITE = np.array([0.3127, 0.3290])
same = True


def told(xy):
    other = float(colour.dominant_wavelength(xy, WHITE)[0])
    return float(spectral.dominant_wavelength(*(float(value) for value in xy))), other


for nm, wanted in ((480, 460), (520, 520), (560, 525), (580, 775), (600, 775)):
    at = list(spectral.CMF_WAVELENGTHS).index(nm)
    XYZ = np.array([spectral.CMF_X[at], spectral.CMF_Y[at], spectral.CMF_Z[at]])
    pure = XYZ[:2] / XYZ.sum()
    mine, other = zip(told(pure), told((pure + WHITE) / 2))
    print(f"light of {nm} nm: {mine[0]:.0f}, half with white: {mine[1]:.0f} (colour-science {other[0]:.0f}, {other[1]:.0f})")
    same &= set(mine) == {wanted} and all(abs(value - nm) <= 2 for value in other)
for name, xy, wanted in (("yellow", (0.4193, 0.5053), 530), ("red", (0.64, 0.33), 775), ("green", (0.3, 0.6), 520)):
    mine, other = told(np.array(xy))
    print(f"{name} of sRGB: {mine:.0f} (colour-science {other:.0f})")
    same &= mine == wanted and abs(mine - other) > 20
print("unchanged" if same else "CHANGED")
raise SystemExit(0 if same else 1)
PYTHON
