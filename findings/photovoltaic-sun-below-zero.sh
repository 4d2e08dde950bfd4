#!/usr/bin/env bash
# One would guess: etr_earth(day), "extraterrestrial radiation at earth (W/m**2)", is the solar constant times
# 1 + 0.033 cos(360 (day - 2)/365): 1398 W/m2 in January, 1308 in July.
# What happens: a bracket closes one factor late, so the constant multiplies the cosine alone: 45.6 W/m2 in
# January, 1.2 in April, -43.6 in July. pvlib's get_extra_radiation gives 1414 and 1320 (constant 1366.1).
# Two neighbors have the wrong unit in their docstrings: am_intensity answers kilowatts ("W/m**2"), and
# blackbody_integrated sigma T^4, which is not per steradian ("W/m2/steradian").
# Measured 2026-11-30 with photovoltaic 0.1.9 against pvlib 0.16.1, Stefan-Boltzmann's law, and the formula.
# Touches: nothing of ours.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3}" -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet --disable-pip-version-check photovoltaic==0.1.9 pvlib==0.16.1 numpy==2.2.6 scipy==1.15.3 pandas==2.2.3
"$folder/venv/bin/python" - <<'PYTHON'
from importlib.metadata import version
from math import cos, radians

from photovoltaic import sun
from pvlib.irradiance import get_extra_radiation

print("photovoltaic", version("photovoltaic"), "pvlib", version("pvlib"))
same = True
for day, wanted in ((2, 45.649), (93, 1.192), (184, -43.647)):
    found, other = float(sun.etr_earth(day)), float(get_extra_radiation(day))
    formula = 1353 * (1 + 0.033 * cos(radians((day - 2) * 360 / 365)))
    print(f"day {day}: {found:.1f} W/m2 (formula {formula:.0f}, pvlib {other:.0f})")
    same &= abs(found - wanted) < 1e-3 and abs(formula - other) < 20
direct = float(sun.am_intensity(1.5)[0])
print(f"am_intensity(1.5): {direct:.3f} (about 846 W/m2 by its formula)")
same &= abs(direct - 1.353 * 0.7 ** (1.5**0.678)) < 1e-9
black = float(sun.blackbody_integrated(5772))
print(f"blackbody_integrated(5772): {black:.3e} (sigma T^4 {5.670374e-8 * 5772**4:.3e}, per steradian 1/pi of it)")
same &= abs(black / (5.670374e-8 * 5772**4) - 1) < 1e-4
print("unchanged" if same else "CHANGED")
raise SystemExit(0 if same else 1)
PYTHON
