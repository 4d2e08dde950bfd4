"""Mitsuba 3: a dictionary for `mitsuba.load_dict`, as JSON."""

from __future__ import annotations

import json
from typing import Any

from app.export.surface import Surface, Typed
from app.export.target import (
    ABSORPTION,
    DISPERSION,
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


def _of_spectra(surface: Surface) -> dict[str, Any]:
    typed = _spectral(surface)
    return {"type": "conductor"} | {
        name: {
            "type": "irregular",
            "wavelengths": typed[f"{name}.wavelengths"],
            "values": typed[f"{name}.values"],
        }
        for name in ("eta", "k")
    }


def _rgb(surface: Surface) -> dict[str, Typed]:
    return {"type": "conductor", "eta": surface.n, "k": surface.k}


def _of_rgb(surface: Surface) -> dict[str, Any]:
    return {
        "type": "conductor",
        "eta": {"type": "rgb", "value": surface.n},
        "k": {"type": "rgb", "value": surface.k},
    }


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
            lambda s: _write(s, _of_spectra(s)),
            by_spectrum,
            Basis("exact", "mitsuba", "conductor"),
            (
                "For spectral variants; those of RGB average n and k, and take mode=nk instead",
                "n and k are sampled every 5 nm from 360 to 830 nm",
            ),
        ),
        Mode(
            "nk",
            "conductor",
            "conductor, RGB",
            _rgb,
            lambda s: _write(s, _of_rgb(s)),
            by_pairs,
            Basis("exact", "mitsuba", "conductor"),
            (
                "The spectrum becomes three fitted pairs of n and k",
                "For RGB variants alone: spectral ones take the numbers for reflectances",
            ),
        ),
        Mode(
            "ior",
            "dielectric",
            "dielectric",
            _clear,
            lambda s: _write(s, dict(_clear(s))),
            by_ior,
            Basis("exact", "mitsuba", "dielectric"),
            (DISPERSION, ABSORPTION),
        ),
    ),
    spaces={"srgb": ""},
)
