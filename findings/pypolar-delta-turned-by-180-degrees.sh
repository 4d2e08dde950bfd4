#!/usr/bin/env bash
# One would guess: tan psi and Delta from rho = r_p/r_s, and rho from these, are inverse to one another: rho is
# tan(psi) exp(i Delta), as both docstrings say, and the index that comes back is the one that was put in.
# What happens: where Re rho < 0, which is so for nearly all samples below the principal angle, tanpsi_Delta_from_rho
# adds 180 degrees to a phase that arctan2 had whole. Bare silicon (3.8827 - 0.0196i at 632.8 nm) at 70 degrees:
# arg rho is 179.206, Delta 359.206. Fed back, rho has the other sign, and m_from_tanpsi_and_Delta makes of
# silicon 2.003 - 0.008i, and of gold (0.18 - 3.43i at 50 degrees) 0.729 - 0.004i. m_from_rho is right.
# Measured 2026-11-30 with pypolar 1.2.0, against the definition of psi and Delta.
# Touches: docs/conventions.md, which has its Delta; ours is in tests/optics/test_ellipsometry.py.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3}" -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet --disable-pip-version-check pypolar==1.2.0 numpy==2.2.6 scipy==1.15.3 sympy==1.14.0 matplotlib==3.10.3
"$folder/venv/bin/python" - <<'PYTHON'
from cmath import exp, phase
from importlib.metadata import version
from math import degrees, radians

from pypolar import ellipsometry

print("pypolar", version("pypolar"))
cases = [
    ("silicon", 3.8827 - 0.0196j, 70, 359.20608, 2.00335 - 0.00838j),
    ("silicon", 3.8827 - 0.0196j, 80, None, None),
    ("gold", 0.18 - 3.43j, 50, None, None),
]
same = True
for name, m, angle, told, index in cases:
    rho = complex(ellipsometry.rho_from_m(m, angle, deg=True))
    tan_psi, Delta = (float(value) for value in ellipsometry.tanpsi_Delta_from_rho(rho, deg=True))
    back = complex(ellipsometry.rho_from_tanpsi_Delta(tan_psi, Delta, deg=True))
    again = complex(ellipsometry.m_from_tanpsi_and_Delta(tan_psi, Delta, angle, deg=True))
    right = complex(ellipsometry.m_from_rho(rho, angle, deg=True))
    print(f"{name} {m} at {angle} degrees: rho {rho:.4f} of phase {degrees(phase(rho)):.3f}, Delta {Delta:.3f};",
          f"rho again {back:.4f}, index again {again:.4f} (from rho {right:.4f})")
    turned = rho.real < 0
    same &= abs(right - m) < 1e-6 and abs(tan_psi - abs(rho)) < 1e-12
    same &= abs(back - (-rho if turned else rho)) < 1e-9 and (abs(again - m) > 0.1) == turned
    same &= abs(exp(1j * radians(Delta)) * tan_psi - back) < 1e-12
    if told is not None:
        same &= abs(Delta - told) < 1e-4 and abs(again - index) < 1e-4
print("unchanged" if same else "CHANGED")
raise SystemExit(0 if same else 1)
PYTHON
