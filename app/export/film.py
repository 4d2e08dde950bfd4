"""One film on an exported surface, as an engine evaluates what is typed of it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from app.export.surface import Surface
from app.export.target import FilmMode
from app.materials.rgb_index import ANGLES_DEG
from app.optics.film_models import CoatedSurface, film_models
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.parameters import Array
from app.optics.specular import F82, MU_BAR, polynomial


@dataclass(frozen=True, slots=True)
class TypedFilm:
    """What is typed of a film."""

    n: float
    """At the d line."""
    thickness_nm: float


def film_curve(surface: Surface, mode: FilmMode, film: TypedFilm) -> Array:
    """Linear sRGB at `ANGLES_DEG`, an angle a row, by the engine's shortcut and what is typed."""
    clear = surface.kind == "dielectric"
    n = np.full(3, surface.ior) if clear else np.array(surface.n)
    k = np.zeros(3) if clear else np.array(surface.k)
    boundary = Interface(1.0, n)
    F0 = boundary.F0 if clear else np.clip(surface.F0, 0.0, 1.0)
    tint = np.array(surface.F82_tint)
    coated = CoatedSurface(
        thickness_nm=np.array([[[film.thickness_nm]]]),
        cos=Incidence.from_degrees(ANGLES_DEG).cos.reshape(1, -1, 1),
        film_n=np.array([film.n]),
        n=n,
        k=k,
        F0=np.asarray(F0),
        F82=F82(boundary) if clear else np.clip(tint * polynomial(F0, MU_BAR), 0.0, 1.0),
    )
    return np.asarray(film_models()[mode.model].color(coated)[0])
