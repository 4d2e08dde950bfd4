"""pbrt-v4: a named material with its spectra inside."""

from __future__ import annotations

from functools import partial

from app.export.surface import Surface, Typed
from app.export.target import ABSORPTION, Basis, File, Mode, Target, by_spectrum


def _parameters(surface: Surface, *quantities: str) -> dict[str, Typed]:
    return {
        name: [number for row in surface.spectrum.rows(quantity) for number in row]
        for name, quantity in zip(("eta", "k"), quantities, strict=False)
    }


def _write(kind: str, surface: Surface, typed: dict[str, Typed]) -> File:
    spectra = [
        f'    "spectrum {name}" [ {" ".join(f"{number:g}" for number in values)} ]'
        for name, values in typed.items()
        if isinstance(values, list)
    ]
    lines = [
        f'MakeNamedMaterial "{surface.name}"',
        f'    "string type" "{kind}"',
        *spectra,
        '    "float roughness" 0',
    ]
    return File(f"{surface.name}.pbrt", "\n".join(lines) + "\n")


_BASIS = Basis("exact", note="pbrt-v4 evaluates Fresnel's equations by its documentation; not run")

PBRT = Target(
    id="pbrt",
    title="pbrt-v4",
    modes=(
        Mode(
            "spectral",
            "conductor",
            "conductor, spectra",
            lambda s: _parameters(s, "n", "k"),
            partial(_write, "conductor"),
            by_spectrum,
            _BASIS,
            ("n and k are sampled every 5 nm from 360 to 830 nm",),
        ),
        Mode(
            "spectral",
            "dielectric",
            "dielectric, spectrum",
            lambda s: _parameters(s, "n"),
            partial(_write, "dielectric"),
            by_spectrum,
            _BASIS,
            ("n is sampled every 5 nm from 360 to 830 nm", ABSORPTION),
        ),
    ),
    spaces={"srgb": ""},
)
