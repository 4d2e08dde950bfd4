#!/usr/bin/env bash
# One would guess: a transfer-matrix function that accepts complex indices takes the complex sine
# and cosine in absorbing layers, and gives numbers for total reflection and metals.
# What happens: off the normal it answers as if the angle in a layer followed from the real part of
# its index alone. 30 nm of silver (0.055+3.32i) on glass is right at 0 degrees and nan at 60 degrees; so is glass,
# 100 nm air, glass at 45 degrees (frustrated total reflection, true R_s 0.3236). For a layer of
# 2+1i at 60 degrees it answers, but 0.4175 instead of 0.4571 for s.
# Measured 2026-11-29 with colour-science 0.4.7, against tmm 0.2.0.
# Touches: metals and gaps of air in any table of films checked with this package off the normal.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3}" -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet --disable-pip-version-check colour-science==0.4.7 scipy==1.15.3 tmm==0.2.0 numpy==2.2.6
"$folder/venv/bin/python" - <<'PYTHON'
import warnings
from importlib.metadata import version

warnings.simplefilter("ignore")
import numpy as np
from colour.phenomena import multilayer_tmm
from tmm import coh_tmm

print("colour-science", version("colour-science"), "tmm", version("tmm"))
cases = [
    ("silver, 0 degrees", [1.0, 0.055 + 3.32j, 1.52], 30.0, 0),
    ("silver, 60 degrees", [1.0, 0.055 + 3.32j, 1.52], 30.0, 60),
    ("air gap, 45 degrees", [1.5, 1.0, 1.5], 100.0, 45),
    ("2+1i, 60 degrees", [1.0, 2.0 + 1.0j, 1.52], 100.0, 60),
]
found = []
for name, media, nm, degrees in cases:
    r = float(np.ravel(multilayer_tmm(np.array(media), np.array([nm]), 550, degrees)[0])[0])
    true = float(coh_tmm("s", media, [np.inf, nm, np.inf], np.radians(degrees), 550)["R"])
    found.append((r, true))
    print(f"{name}: R_s {r:.6f} (tmm {true:.6f})")
same = (
    abs(found[0][0] - found[0][1]) < 1e-9
    and np.isnan(found[1][0]) and np.isnan(found[2][0])
    and abs(found[3][0] - 0.41748) < 1e-4 and abs(found[3][1] - 0.4571) < 1e-3
)
print("unchanged" if same else "CHANGED")
raise SystemExit(0 if same else 1)
PYTHON
