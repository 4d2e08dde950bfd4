#!/usr/bin/env bash
# One would guess: T_per and T_par, "transmitted fraction of perpendicular- (parallel-) polarized optical power",
# are 0 beyond the critical angle, and 1 - R for any boundary.
# What happens: they take the magnitude of the transmitted wave's complex cosine where its real part belongs.
# From glass of 1.5 to air at 45 degrees R is 1 and T is 1.20 (s) and 1.92 (p): R + T = 2.56 for unpolarized
# light. Silver (0.055 - 3.32i, its sign of k) along the normal: R 0.982, T 1.094. Between clear media below the
# critical angle, all is right.
# Measured 2026-11-30 with pypolar 1.2.0, against tmm 0.2.0 (interface_R, interface_T).
# Touches: R + T = 1 at any boundary, T = 0 in total reflection: tests/optics/test_properties.py.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3}" -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet --disable-pip-version-check pypolar==1.2.0 tmm==0.2.0 numpy==2.2.6 scipy==1.15.3 sympy==1.14.0 matplotlib==3.10.3
"$folder/venv/bin/python" - <<'PYTHON'
from importlib.metadata import version
from math import radians

from pypolar import fresnel
from tmm import interface_R, interface_T, snell

print("pypolar", version("pypolar"), "tmm", version("tmm"))
cases = [
    ("air to 1.5, 60 degrees", 1.0, 1.5, 60, 0.823429, 0.998198),
    ("1.5 to air, 45 degrees", 1.5, 1.0, 45, 1.2, 1.92),
    ("1.5 to air, 60 degrees", 1.5, 1.0, 60, 1.989975, 1.384330),
    ("air to silver, 0 degrees", 1.0, 0.055 - 3.32j, 0, 1.094467, 1.094467),
]
same = True
for name, n_i, n_t, degrees, *wanted in cases:
    theta, medium = radians(degrees), complex(n_t).conjugate()  # tmm has the other sign of k
    angles = theta, snell(n_i, medium, theta)
    for polarization, suffix, value in zip("sp", ("per", "par"), wanted):
        R, T = (float(getattr(fresnel, f"{power}_{suffix}")(n_t, theta, n_i)) for power in "RT")
        true_R, true_T = (
            float(of(polarization, n_i, medium, *angles).real) for of in (interface_R, interface_T)
        )
        print(f"{name}, {polarization}: R {R:.4f}, T {T:.4f}, R + T {R + T:.4f} (tmm {true_R:.4f}, {true_T:.4f})")
        same &= abs(T - value) < 1e-5 and abs(R - true_R) < 1e-9 and abs(true_R + true_T - 1) < 1e-9
        same &= (abs(T - true_T) < 1e-9) == (name == "air to 1.5, 60 degrees")
print("unchanged" if same else "CHANGED")
raise SystemExit(0 if same else 1)
PYTHON
