#!/usr/bin/env bash
# One would guess: the keys R and T of a scattering-matrix package are power fractions, so that a
# lossless boundary or coating has R + T = 1.
# What happens: T is the squared amplitude |t|^2, without the factor n_t cos(t) / (n_i cos(i)).
# Air onto glass of 1.5 gives R = 0.04, T = 0.64; a perfect quarter-wave coating on that glass
# gives R = 0 and T = 0.6667. With n_t / n_i the sums are 1.
# Measured 2026-11-29 with smmo 0.0.4 (thickness in cm, wave numbers in 1/cm).
# Touches: T of any stack whose last medium is not the first one.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3}" -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet --disable-pip-version-check smmo==0.0.4 numpy==2.2.6
"$folder/venv/bin/python" - <<'PYTHON'
from importlib.metadata import version

import numpy as np
import smmo

print("smmo", version("smmo"))
wavelength = 550e-7  # cm
quarter = wavelength / 4 / 1.5**0.5
found = []
for name, indices in (("glass", (1.0, 1.5)), ("coated glass", (1.0, 1.5**0.5, 1.5))):
    layers = [smmo.make_layer(np.array([n]), np.array([0.0]),
                              quarter if 0 < i < len(indices) - 1 else 0.0, True)
              for i, n in enumerate(indices)]
    answer = smmo.SMMO(layers, smmo.make_config(np.array([1 / wavelength]), 0.0, "s"))()
    r, t = float(answer["R"][0]), float(answer["T"][0])
    found += [r + t, r + 1.5 * t]
    print(f"{name}: R {r:.6f}, T {t:.6f}, R + T {r + t:.6f}, R + 1.5 T {r + 1.5 * t:.6f}")
same = np.allclose(found, [0.68, 1, 2 / 3, 1], atol=1e-6)
print("unchanged" if same else "CHANGED")
raise SystemExit(0 if same else 1)
PYTHON
