#!/usr/bin/env bash
# One would guess: a package that has a material's Sellmeier formula gives group index and group velocity
# dispersion that follow from it: 97.6 fs^2/mm for fused silica at 400 nm, 36.2 at 800 nm.
# What happens: the derivatives come from differences on a fixed grid of 47 nm from 300 to 5000 nm, made
# twice and interpolated linearly, whatever wavelength is asked for. At 350 nm GVD is 82.7 instead of 119.6, less
# than at 400 nm (112.2), although it falls with the wavelength; at 800 nm it is 37.6. The group index at 350 nm
# is off by 0.0032, some hundred times what a glass catalog leaves open. The index itself is exact.
# Measured 2026-11-30 with opticalmaterialspy 0.3.3, against the derivatives of Malitson's formula, which
# ndispers 0.20.0 confirms.
# Touches: nothing of ours.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3}" -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet --disable-pip-version-check opticalmaterialspy==0.3.3 ndispers==0.20.0 numpy==2.2.6 scipy==1.15.3 six==1.17.0
"$folder/venv/bin/python" - <<'PYTHON'
import warnings
from importlib.metadata import version
from math import pi, sqrt

warnings.simplefilter("ignore")
import opticalmaterialspy
from ndispers.media.glasses import FusedSilica

TERMS = ((0.6961663, 0.0684043), (0.4079426, 0.1162414), (0.8974794, 9.896161))
C_UM_PER_FS = 0.299792458


def malitson(um):
    """n, and its first and second derivative by the wavelength in um."""
    square = 1 + sum(b * um**2 / (um**2 - c**2) for b, c in TERMS)
    first = sum(-2 * b * c**2 * um / (um**2 - c**2) ** 2 for b, c in TERMS)
    second = sum(2 * b * c**2 * (3 * um**2 + c**2) / (um**2 - c**2) ** 3 for b, c in TERMS)
    n = sqrt(square)
    slope = first / (2 * n)
    return n, slope, (second / 2 - slope**2) / n


print("opticalmaterialspy", version("opticalmaterialspy"), "ndispers", version("ndispers"))
silica, other = opticalmaterialspy.SiO2(), FusedSilica()
same = True
expected = {0.35: (1.53882, 82.685), 0.4: (1.51566, 112.217), 0.5: (1.49082, 78.246), 0.8: (1.46727, 37.593)}
for um, (group, dispersion) in expected.items():
    n, slope, curvature = malitson(um)
    true_group, true_dispersion = n - um * slope, um**3 * curvature / (2 * pi * C_UM_PER_FS**2) * 1e3
    found_group, found_dispersion = float(silica.ng(um)), float(silica.gvd(um)) * 1e27
    third = float(other.GVD(um, 20))
    print(f"{um} um: n_g {found_group:.5f} (true {true_group:.5f}),",
          f"GVD {found_dispersion:.1f} fs^2/mm (true {true_dispersion:.1f}, ndispers {third:.1f})")
    same &= abs(found_group - group) < 1e-5 and abs(found_dispersion - dispersion) < 1e-2
    same &= abs(third / true_dispersion - 1) < 1e-2 and abs(float(silica.n(um)) - n) < 1e-12
    same &= abs(found_dispersion / true_dispersion - 1) > 0.03
print("unchanged" if same else "CHANGED")
raise SystemExit(0 if same else 1)
PYTHON
