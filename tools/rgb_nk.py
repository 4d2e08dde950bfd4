"""Writes `materials/rgb_nk.json`: fitted n and k of three channels of every material of the catalog."""

from __future__ import annotations

from pathlib import Path

from app.materials.media import default_catalog
from app.materials.rgb_index import PAIRS_FILE, fit
from app.optics.parameters import Array
from tools.build_materials.writing import list_text

ROOT = Path(__file__).resolve().parents[1]
HEAD = {"space": "srgb", "gamut": "clamped", "illuminant": "D65", "observer": "cie1931_2deg"}


def _digits(values: Array) -> list[float]:
    return [float(f"{value:.10g}") for value in values.ravel()]


def main() -> None:
    """Fit all."""
    pairs = []
    for preset in default_catalog().presets:
        found = fit(preset.id)
        pairs.append({"id": preset.id, "n": _digits(found.n_t), "k": _digits(found.k_t)})
    (ROOT / "materials" / PAIRS_FILE).write_text(list_text(HEAD, "pairs", pairs), encoding="utf-8")


if __name__ == "__main__":
    main()
