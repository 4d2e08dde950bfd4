#!/usr/bin/env bash
# One would guess: a function that answers r of a stack of films at an angle of incidence agrees with Fresnel's
# equations where film and substrate are one glass; and R_s is at least R_p at every angle there.
# What happens: multilayer_stack_rt (with vacuum in front, its default) takes the angle of incidence itself as
# the angle within the first layer, and Snell's angle of the first layer as that of the second. It is right at
# normal incidence alone. Bare glass of 1.52 at 30 degrees: R_s 0.027, R_p 0.061 where 0.061 and 0.027 are true
# (as if swapped), at 60 degrees 0.087 and 0.116 for 0.183 and 0.0015. A quarter wave of 1.38 on it, at 60
# degrees: R_p 0.0548, nine times the true 0.0060.
# Measured 2026-11-30 with prysm 0.21.1, against tmm 0.2.0 and, for bare glass, Fresnel's equations.
# Touches: that s is never reflected less than p, in tests/optics/test_properties.py; films at oblique incidence
# are compared with tmm and with 25-digit references in tests/optics/test_films.py.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3}" -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet --disable-pip-version-check prysm==0.21.1 tmm==0.2.0 numpy==2.2.6 scipy==1.15.3
"$folder/venv/bin/python" - <<'PYTHON'
from importlib.metadata import version
from math import cos, inf, radians, sin, sqrt

from prysm.thinfilm import multilayer_stack_rt
from tmm import coh_tmm

print("prysm", version("prysm"), "tmm", version("tmm"))


def fresnel(polarization, n, degrees):
    c, g = cos(radians(degrees)), sqrt(n * n - sin(radians(degrees)) ** 2)
    return ((c - g) / (c + g)) ** 2 if polarization == "s" else ((n * n * c - g) / (n * n * c + g)) ** 2


cases = {
    "bare glass of 1.52": ((1.52, 0.1), (1.52, 1.0)),
    "99.6 nm of 1.38 on 1.52": ((1.38, 0.0996), (1.52, 1.0)),
}
expected = {
    ("bare glass of 1.52", 0): (0.042580, 0.042580),
    ("bare glass of 1.52", 30): (0.027237, 0.061061),
    ("bare glass of 1.52", 60): (0.086502, 0.116204),
    ("99.6 nm of 1.38 on 1.52", 0): (0.012602, 0.012602),
    ("99.6 nm of 1.38 on 1.52", 60): (0.094741, 0.054800),
}
same = True
for (name, degrees), wanted in expected.items():
    layers = cases[name]
    indices, thicknesses = zip((1.0, inf), *layers)
    for polarization, value in zip("sp", wanted):
        found = abs(complex(multilayer_stack_rt(layers, 0.55, polarization, degrees)[0])) ** 2
        true = float(coh_tmm(polarization, indices, (*thicknesses[:-1], inf), radians(degrees), 0.55)["R"])
        print(f"{name}, {degrees} degrees: R_{polarization} {found:.6f} (tmm {true:.6f})")
        same &= abs(found - value) < 2e-6
        same &= abs(found - true) < 1e-9 if degrees == 0 else abs(found - true) > 5e-3
        if name.startswith("bare"):
            same &= abs(true - fresnel(polarization, 1.52, degrees)) < 1e-9
print("unchanged" if same else "CHANGED")
raise SystemExit(0 if same else 1)
PYTHON
