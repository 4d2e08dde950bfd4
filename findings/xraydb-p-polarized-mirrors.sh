#!/usr/bin/env bash
# One would guess: along the normal, where s and p are one, a mirror reflects both alike; at 45 degrees, near
# Brewster's angle, R_p = R_s^2; and the roughness of a coating's surface lowers its reflectivity.
# What happens: for p the package divides the inner wave's k_z by n where Fresnel's equations have n^2 (its
# comment says that the difference is tiny at small angles). Silicon at 92 eV: along the normal R_p is 1e-38
# where R_s is 3.94e-6; at 45 degrees 3.9e-6 instead of 2e-10; at 5 degrees grazing 0.0317 instead of 0.0310. s is
# right. The uppermost boundary of multilayers is treated alike: Mo/Si, along the normal, p and s differ. And
# surface_rough of multilayer_reflectivity does nothing without substrate_rough, whose value it then uses:
# platinum of 10 angstroms roughness reflects 0.334 at 0.6 degrees and 8 keV like smooth one.
# Measured 2026-11-30 with xraydb 4.5.8, against Fresnel's equations with its own delta and beta.
# Touches: nothing of ours; both polarizations meet along the normal in tests/optics/test_landmarks.py.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3}" -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet --disable-pip-version-check xraydb==4.5.8 numpy==2.2.6 scipy==1.15.3
"$folder/venv/bin/python" - <<'PYTHON'
from importlib.metadata import version

import numpy as np
from xraydb import mirror_reflectivity, multilayer_reflectivity, xray_delta_beta

print("xraydb", version("xraydb"))
EV = 92.0
delta, beta, _ = xray_delta_beta("Si", 2.33, EV)
n = 1 - delta + 1j * beta


def fresnel(polarization, theta):
    sine, q = np.sin(theta), np.sqrt(n**2 - np.cos(theta) ** 2)
    weight = 1 if polarization == "s" else n**2
    return abs((weight * sine - q) / (weight * sine + q)) ** 2


same = True
for degrees in (90, 45, 30, 5):
    theta = np.radians(degrees)
    found, true = (
        [float(np.squeeze(of(polarization))) for polarization in "sp"]
        for of in (
            lambda p: mirror_reflectivity("Si", theta, EV, 2.33, polarization=p),
            lambda p: fresnel(p, theta),
        )
    )
    print(f"silicon at {EV} eV, {degrees} degrees grazing: R_s {found[0]:.3e} (Fresnel {true[0]:.3e}),",
          f"R_p {found[1]:.3e} ({true[1]:.3e})")
    same &= abs(found[0] / true[0] - 1) < 1e-4 and abs(found[1] / true[1] - 1) > 0.02
    same &= (found[1] < 1e-30) == (degrees == 90)
stack = {"stackup": ["Si", "Mo"], "thickness": [41.0, 28.0], "substrate": "Si", "n_periods": 40}
s, p = (
    float(np.squeeze(multilayer_reflectivity(
        **{**stack, "stackup": list(stack["stackup"])}, theta=np.pi / 2, energy=EV, polarization=polarization
    )))
    for polarization in "sp"
)
print(f"40 periods of Mo/Si along the normal: R_s {s:.5f}, R_p {p:.5f}")
same &= abs(s - p) > 1e-4
rough = [
    float(np.squeeze(multilayer_reflectivity(
        ["Pt"], [300.0], "Si", np.radians(0.6), 8000.0, surface_rough=surface, substrate_rough=substrate
    )))
    for surface, substrate in ((0.0, 0.0), (10.0, 0.0), (10.0, 3.0), (3.0, 3.0))
]
plain = [float(np.squeeze(mirror_reflectivity("Pt", np.radians(0.6), 8000.0, roughness=a))) for a in (0.0, 10.0)]
print("300 A of Pt at 0.6 degrees, 8 keV: smooth {:.4f}, surface 10 A {:.4f}; 10 A and 3 A {:.4f}, 3 A and 3 A {:.4f}"
      .format(*rough))
print("mirror of Pt: smooth {:.4f}, roughness 10 A {:.4f}".format(*plain))
same &= rough[0] == rough[1] and rough[2] == rough[3] and plain[1] < 0.9 * plain[0]
print("unchanged" if same else "CHANGED")
raise SystemExit(0 if same else 1)
PYTHON
