"""Mitsuba 3: a dictionary for `mitsuba.load_dict`, as JSON."""

from __future__ import annotations

import json
from typing import Any

from app.export.surface import Surface, Typed
from app.export.target import (
    ABSORPTION,
    DISPERSION,
    PAIRS,
    Basis,
    File,
    Mode,
    Target,
    by_ior,
    by_pairs,
    by_spectrum,
)


def _write(surface: Surface, bsdf: dict[str, Any]) -> File:
    return File(f"{surface.name}_mitsuba.json", json.dumps(bsdf, indent=1))


def _spectral(surface: Surface) -> dict[str, Typed]:
    values: dict[str, Typed] = {"type": "conductor"}
    for name, quantity in (("eta", "n"), ("k", "k")):
        rows = surface.spectrum.rows(quantity)
        values[f"{name}.wavelengths"] = ", ".join(f"{at:g}" for at, _ in rows)
        values[f"{name}.values"] = ", ".join(repr(v) for _, v in rows)
    return values


def _write_spectra(surface: Surface, typed: dict[str, Typed]) -> File:
    spectra = {
        name: {"type": "irregular"}
        | {part: typed[f"{name}.{part}"] for part in ("wavelengths", "values")}
        for name in ("eta", "k")
    }
    return _write(surface, {"type": typed["type"]} | spectra)


def _rgb(surface: Surface) -> dict[str, Typed]:
    return {"type": "conductor", "eta": surface.n, "k": surface.k}


def _write_rgb(surface: Surface, typed: dict[str, Typed]) -> File:
    bsdf = {
        name: {"type": "rgb", "value": value} if isinstance(value, list) else value
        for name, value in typed.items()
    }
    return _write(surface, bsdf)


def _clear(surface: Surface) -> dict[str, Typed]:
    return {"type": "dielectric", "int_ior": surface.ior, "ext_ior": 1.0}


MITSUBA = Target(
    id="mitsuba",
    title="Mitsuba 3",
    modes=(
        Mode(
            "spectral",
            "conductor",
            "conductor, spectra",
            _spectral,
            _write_spectra,
            by_spectrum,
            Basis("exact", "mitsuba", "conductor"),
            (
                "For spectral variants alone: those of RGB end in an error, and take mode=nk instead",
                "n and k are sampled every 5 nm from 360 to 830 nm",
            ),
        ),
        Mode(
            "nk",
            "conductor",
            "conductor, RGB",
            _rgb,
            _write_rgb,
            by_pairs,
            Basis("exact", "mitsuba", "conductor"),
            (
                PAIRS,
                "For RGB variants alone: spectral ones take the numbers for reflectances",
            ),
        ),
        Mode(
            "ior",
            "dielectric",
            "dielectric",
            _clear,
            _write,
            by_ior,
            Basis("exact", "mitsuba", "dielectric"),
            (DISPERSION, ABSORPTION),
        ),
    ),
    spaces={"srgb": ""},
)
