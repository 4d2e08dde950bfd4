#!/usr/bin/env bash
# One would guess: fresnel_rs(n0, n1, theta0, theta1) is (n0 cos0 - n1 cos1)/(n0 cos0 + n1 cos1), so -0.2 for
# air to glass of 1.5 at normal incidence, where s and p are one; and critical_angle(n0, n1), "index of
# refraction of the left material" first, is asin(n1/n0): 41.8 degrees from glass of 1.5 to air.
# What happens: fresnel_rs divides by n1 cos0 + n1 cos1. It says -0.1667 at normal incidence (R_s 0.0278 where
# R_p of the same package is 0.0400, and R_s + T_s = 0.9878).
# critical_angle is asin(n0/n1): nan from glass to air, and 41.8 degrees from air to glass, where there is none.
# tmm agrees with the textbook.
# Measured 2026-11-30 with prysm 0.21.1, against tmm 0.2.0.
# Touches: nothing of ours; r_s of one boundary is tested by identities and 30-digit references in tests/optics.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3}" -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet --disable-pip-version-check prysm==0.21.1 tmm==0.2.0 numpy==2.2.6 scipy==1.15.3
"$folder/venv/bin/python" - <<'PYTHON'
import warnings
from importlib.metadata import version
from math import cos, isnan, radians

warnings.simplefilter("ignore")
from prysm import thinfilm
from tmm import interface_r

print("prysm", version("prysm"), "tmm", version("tmm"))
same = True
for degrees, wanted in ((0, -1 / 6), (60, -0.367007)):
    theta = radians(degrees)
    inside = thinfilm.snell_aor(1.0, 1.5, theta, degrees=False)
    angles = (theta, inside)
    found = {name: float(getattr(thinfilm, f"fresnel_{name}")(1.0, 1.5, *angles)) for name in ("rs", "rp", "ts")}
    true = float(interface_r("s", 1.0, 1.5, *angles))
    sent = 1.5 * cos(inside) / cos(theta) * found["ts"] ** 2
    print(f"air to 1.5 at {degrees} degrees: r_s {found['rs']:.6f} (tmm {true:.6f}), r_p {found['rp']:.6f};",
          f"R_s + T_s = {found['rs'] ** 2 + sent:.4f}")
    same &= abs(found["rs"] - wanted) < 1e-6 and abs(true - wanted) > 0.01
out, into = (float(thinfilm.critical_angle(*indices)) for indices in ((1.5, 1.0), (1.0, 1.5)))
print(f"critical angle from 1.5 to air: {out}; from air to 1.5: {into:.2f} degrees")
same &= isnan(out) and abs(into - 41.81) < 0.01
print("unchanged" if same else "CHANGED")
raise SystemExit(0 if same else 1)
PYTHON
