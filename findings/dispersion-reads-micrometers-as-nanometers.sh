#!/usr/bin/env bash
# One would guess: dispersion reads refractiveindex.info's files, whose wavelengths are always
# micrometers, so a table opened without further arguments is a table in micrometers.
# What happens: the constructor's default unit is nanometer, also for these files. A table from
# 0.4 to 0.7 (um) is taken as 0.4 to 0.7 nm: asking for 0.55 micrometer is refused as out of
# range, and 0.55 NANOmeter answers with the visible's index. get_nk_data then counts in METERS
# unless told otherwise, so the two defaults do not even agree with each other.
# Material(file_path=..., unit="micrometer") is right.
# Measured 2026-11-29 with dispersion 1.0.6.
# Touches: none of our tables; whoever checks our material files with it states the unit twice.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3}" -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet --disable-pip-version-check dispersion==1.0.6 numpy==2.2.6
"$folder/venv/bin/python" - <<'PYTHON'
import tempfile
from importlib.metadata import version
from pathlib import Path

from dispersion import Material

print("dispersion", version("dispersion"))
rows = "".join(f"        {um} {n}\n" for um, n in
               ((0.4, 1.47), (0.5, 1.462), (0.55, 1.46), (0.6, 1.458), (0.7, 1.455)))
found = []
with tempfile.TemporaryDirectory() as folder:
    table = Path(folder) / "glass.yml"
    table.write_text("DATA:\n  - type: tabulated n\n    data: |\n" + rows)
    for kwargs in ({}, {"unit": "micrometer"}):
        for unit in ("micrometer", "nanometer"):
            try:
                answer = complex(Material(file_path=str(table), **kwargs).get_nk_data(0.55, unit=unit))
            except ValueError as error:
                answer = None
                print("  ", error)
            found.append(answer)
            print(f"Material(..., {kwargs}).get_nk_data(0.55, unit={unit!r}): {answer}")
    bare = complex(Material(file_path=str(table), unit="micrometer").get_nk_data(0.55e-6))
    print("query of 0.55e-6 without a unit:", bare)
same = found == [None, 1.46, 1.46, None] and bare == 1.46
print("unchanged" if same else "CHANGED")
raise SystemExit(0 if same else 1)
PYTHON
