#!/usr/bin/env bash
# One would guess: the Mathar model of the refractive index of air, documented as used above
# 2.5 um, answers in the windows that it was published for: 2.8 to 4.2, 4.35 to 5.2, 7.5 to 14.1
# and 16 to 24 um.
# What happens: at 3.5 and 4.2 um it answers; at 4.8, 10 and 20 um, in the M, N and Q bands of
# ground-based astronomy, it raises UnboundLocalError (a local variable without a value), not an
# error that speaks of a range.
# Measured 2026-11-29 with AstroAtmosphere 1.6.
# Touches: none of our tables. n of air is 1 in them; whoever wants the index of air in the
# thermal infrared needs another source.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3}" -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet --disable-pip-version-check AstroAtmosphere==1.6 numpy==2.2.6
"$folder/venv/bin/python" - <<'PYTHON'
import warnings
from importlib.metadata import version

warnings.simplefilter("ignore")
import AstroAtmosphere

print("AstroAtmosphere", version("AstroAtmosphere"))
found = {}
for um in (0.55, 2.4, 3.5, 4.2, 4.8, 10.0, 20.0):
    try:
        found[um] = f"{float(AstroAtmosphere.quick_refractive_index(um)):.7f}"
    except Exception as error:
        found[um] = type(error).__name__
    print(f"{um:g} um: {found[um]}")
same = (
    all(found[um].startswith("1.0002") for um in (0.55, 2.4, 3.5, 4.2))
    and all(found[um] == "UnboundLocalError" for um in (4.8, 10.0, 20.0))
)
print("unchanged" if same else "CHANGED")
raise SystemExit(0 if same else 1)
PYTHON
