#!/usr/bin/env bash
# One would guess: a rewrite of tmm in C++ gives tmm's R and T, also for an absorbing last medium;
# at a boundary without layers the light that is not reflected is what enters: R + T = 1.
# What happens: R agrees and T_s agrees, but T_p into an absorbing last medium is too small:
# air onto 2+1i at 60 degrees gives R_p + T_p = 0.9394. tmm gives 1. At 0 degrees both agree, so a
# check at normal incidence or of s alone does not show it.
# Measured 2026-11-29 with tmm-faster 0.1.3 against tmm 0.2.0.
# Touches: T_p of a film on an absorbing substrate; compare with tmm, not with this package.
# (The layer in the stack is 100 nm of air in air: it changes no R and no T.)
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3}" -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet --disable-pip-version-check tmm-faster==0.1.3 tmm==0.2.0 numpy==2.2.6
"$folder/venv/bin/python" - <<'PYTHON'
from importlib.metadata import version

import numpy as np
import tmm
from tmm_faster import calc_coherent

print("tmm-faster", version("tmm-faster"), "tmm", version("tmm"))
stack = np.array([[1.0, 1.0, 2.0 + 1.0j]])
fast = calc_coherent(stack, np.array([0.0, 100.0, 0.0]), np.array([0.0, 60.0]), np.array([550.0]))
found = {}
for column, degrees in enumerate((0.0, 60.0)):
    for pol in "sp":
        slow = tmm.coh_tmm(pol, list(stack[0]), [np.inf, 100.0, np.inf],
                           np.radians(degrees), 550.0)
        r, t = (float(fast[f"{q}_{pol}"][0, column]) for q in "RT")
        found[pol, degrees] = r, t, float(slow["R"]), float(slow["T"])
        print(f"{degrees:g} degrees, {pol}: R {r:.6f} (tmm {slow['R']:.6f}), "
              f"T {t:.6f} (tmm {slow['T']:.6f}), R + T {r + t:.6f}")
same = (
    abs(sum(found["p", 60.0][:2]) - 0.9394) < 1e-4
    and abs(sum(found["p", 60.0][2:]) - 1) < 1e-12
    and all(abs(found[key][1] - found[key][3]) < 1e-12 for key in found if key != ("p", 60.0))
)
print("unchanged" if same else "CHANGED")
raise SystemExit(0 if same else 1)
PYTHON
