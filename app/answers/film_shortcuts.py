"""Renderers' shortcuts for a film, beside the exact colors."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from app.answers.answer import answer, filled
from app.materials.appearance import Viewing
from app.optics.color import WAVELENGTH_NM, srgb_weights
from app.optics.errors import NotAllowed
from app.optics.film_models import CoatedSurface, Deviation, FilmModel, film_models
from app.optics.films import reflectances
from app.optics.incidence import Incidence
from app.optics.parameters import Array
from app.optics.specular import MU_BAR
from app.optics.stack import D_LINE_NM, Stack

CHANNELS_NM = (650.0, 550.0, 450.0)
"""Where a metal's n and k are taken for red, green and blue."""
AIR = 0.001
"""How far n_i may be from 1: all these shortcuts assume air."""


@answer
class FilmModelFacts:
    """A shortcut of a renderer for one film."""

    id: str
    title: str
    reference: str
    validity: str
    measured: tuple[Deviation, ...]

    @classmethod
    def of(cls, model: FilmModel) -> FilmModelFacts:
        """Describe a shortcut."""
        return filled(cls, model)


@answer
class FilmModelList:
    """All shortcuts."""

    models: list[FilmModelFacts]


def film_model_list() -> FilmModelList:
    """Describe all shortcuts."""
    return FilmModelList(models=[FilmModelFacts.of(model) for model in film_models().values()])


def chosen_shortcuts(models: Sequence[str], stack: Stack, quantity: str) -> list[FilmModel]:
    """Look shortcuts up, `exact` left out.

    Raises
    ------
    UnknownModel
        If there is no such shortcut.
    NotAllowed
        If they cannot say anything of these films.
    """
    ids = [model for model in models if model != "exact"]
    found = [film_models().find(model) for model in ids]
    if found and (len(stack.layers) != 1 or not stack.is_coherent):
        raise NotAllowed("models", ids[0], "exact but for one film, with interference")
    if found and np.abs(np.asarray(stack.n_i) - 1.0).max() > AIR:
        raise NotAllowed("models", ids[0], "exact but in air, n_i = 1")
    if found and quantity != "R":
        raise NotAllowed("models", ids[0], "exact but for reflected light")
    return found


def coated_surface(
    stack: Stack, thickness_nm: Array, incidence: Incidence, viewing: Viewing
) -> CoatedSurface:
    """What is typed into a renderer for one film, its arrays of shape (thickness, angle, channel).

    Parameters
    ----------
    stack
        Over `WAVELENGTH_NM`. Of the film n at 587.6 nm counts; of the surface n and k at 650, 550
        and 450 nm, and the color of its reflectance at normal incidence and at 82 degrees.
    thickness_nm, incidence
        Thicknesses and directions.
    viewing
        Under which light, by which observer the color is seen.
    """
    layer, substrate = stack.layers[0], stack.substrate
    shape = WAVELENGTH_NM.shape

    def at(values: Array, nm: tuple[float, ...]) -> Array:
        return np.interp(nm, WAVELENGTH_NM, np.broadcast_to(values, shape))

    bare = Stack(stack.n_i, [], substrate.n_t, substrate.k_t, wavelength_nm=WAVELENGTH_NM)
    mu = np.array([[1.0], [MU_BAR]])
    Rs, Rp = reflectances(bare, Incidence.from_cosine(mu))
    R = np.broadcast_to(0.5 * (Rs + Rp), (2, *shape))
    F0, F82 = np.clip(R @ srgb_weights(*viewing), 0.0, 1.0)
    return CoatedSurface(
        thickness_nm=thickness_nm.reshape(-1, 1, 1),
        cos=incidence.cos.reshape(1, -1, 1),
        film_n=at(layer.n, (D_LINE_NM,)),
        n=at(substrate.n_t, CHANNELS_NM),
        k=at(substrate.k_t, CHANNELS_NM),
        F0=F0,
        F82=F82,
    )
