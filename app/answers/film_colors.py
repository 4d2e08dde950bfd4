"""Colors of films over thickness and angle, from the whole spectrum."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Annotated, Any, Literal

import numpy as np

from app.answers.answer import Rows, SentAs, Table, Values, answer
from app.answers.film_media import FilmMedia, MediaFacts, swept_place
from app.answers.film_shortcuts import chosen_shortcuts, coated_surface
from app.answers.materials.about import refuse_more_than
from app.materials.appearance import DAYLIGHT, Viewing
from app.optics.color import delta_e_2000, encode_srgb, lab, srgb_weights
from app.optics.film_color import (
    UNRESOLVED,
    is_resolved,
    reflected_colors,
    sampled_weights,
    step_nm,
    swept_colors,
    transmitted_colors,
)
from app.optics.incidence import Incidence
from app.optics.parameters import Array
from app.optics.stack import Stack

MOST_INCOHERENT = 4096
"""Cells of transmitted light or with an incoherent layer, each of which is a whole spectrum."""

_ANGLES = 256
"""Angles at a time of colors over many of them."""

MOST_SPECTRA = 200_000
"""Layers times the directions, or the cells where each is a whole spectrum: seconds of work."""

Quantity = Literal["R", "T"]

Colors = Annotated[Array, SentAs(list[list[tuple[float, float, float]]])]
"""A row each thickness, a color each angle."""


@answer
class ModelColors:
    """Colors by one model, a row each thickness, an angle each column."""

    model: str
    linear_srgb: Colors
    """Not clamped: a channel below 0 or above 1 is a color that sRGB cannot show."""
    lab: Colors
    """CIELAB, of the colors as they are."""
    hex: list[list[str]]
    """sRGB, each channel cut to 0 and 1."""
    delta_e: Rows | None
    """CIEDE2000 against `exact`; null for exact itself."""


@answer
class FilmColors:
    """Colors of films over the thickness of one layer and the angle."""

    media: MediaFacts
    quantity: Quantity
    """Whether the colors are of reflected light or of what enters the second medium."""
    layer: int
    """The layer whose thickness varies, counted from the incident side."""
    thickness_nm: Values
    theta_i_deg: Values
    illuminant: str
    observer: str
    adaptation: str
    step_nm: int
    """Distance of the wavelengths at which R was evaluated; the integral is over every nanometer."""
    colors: list[ModelColors]
    warnings: list[str]

    def table(self) -> Table:
        """Lay out a row each cell."""
        thickness, angle = np.meshgrid(self.thickness_nm, self.theta_i_deg, indexing="ij")
        columns: dict[str, Any] = {
            "thickness_nm": thickness.ravel(),
            "theta_i_deg": angle.ravel(),
        }
        for found in self.colors:
            channels = (("red", "green", "blue"), found.linear_srgb), (("L", "a", "b"), found.lab)
            for names, values in channels:
                flat = values.reshape(-1, 3)
                columns |= {f"{found.model}.{n}": flat[:, i] for i, n in enumerate(names)}
            if found.delta_e is not None:
                columns[f"{found.model}.delta_e"] = found.delta_e.ravel()
            columns[f"{found.model}.hex"] = [cell for row in found.hex for cell in row]
        return Table(columns, "film_colors.csv")


def film_colors(
    media: FilmMedia,
    layer: int,
    thickness_nm: Array,
    incidence: Incidence,
    viewing: Viewing = DAYLIGHT,
    quantity: Quantity = "R",
    models: Sequence[str] = (),
) -> FilmColors:
    """Evaluate colors over the thickness of one layer and the angle.

    Parameters
    ----------
    media
        The two media and the layers.
    layer
        Which layer's thickness varies, from 1 at the incident side.
    thickness_nm, incidence
        Thicknesses of shape (T,) and directions of shape (A,).
    viewing
        Under which light, by which observer.
    quantity
        R for the light that is reflected, T for what enters the second medium.
    models
        Shortcuts of renderers beside the exact colors.

    Raises
    ------
    OpticsError
        If there is no such layer, or a medium has no spectrum.
    """
    place = swept_place(media.layers, layer)
    cells = thickness_nm.size * incidence.cos.size
    refuse_more_than("thickness_nm", thickness_nm.size, cells, "colors")
    incoherent = any(film.incoherent for film in media.layers)
    if incoherent or quantity == "T":
        what = "colors of films with an incoherent layer" if incoherent else "transmitted colors"
        refuse_more_than("thickness_nm", thickness_nm.size, cells, what, MOST_INCOHERENT)
    spectra = cells if incoherent or quantity == "T" else incidence.cos.size
    many = spectra * len(media.layers)
    what = "layers times spectra, one for each angle or cell,"
    refuse_more_than("layers", len(media.layers), many, what, MOST_SPECTRA)
    whole, stack, step, warnings = _sampled(media, place, float(thickness_nm.max()))
    colors_of = swept_colors if quantity == "R" else transmitted_colors
    shortcuts = chosen_shortcuts(models, whole, quantity)
    linear = colors_of(stack, place, thickness_nm, incidence, srgb_weights(*viewing), step)
    colors = [model_colors("exact", linear, viewing)]
    if shortcuts:
        surface = coated_surface(whole, thickness_nm, incidence, viewing)
        for shortcut in shortcuts:
            found = shortcut.color(surface)
            off = delta_e_2000(lab(found, viewing.observer), colors[0].lab)
            colors.append(model_colors(shortcut.id, found, viewing, off))
    return FilmColors(
        media=media.facts(),
        quantity=quantity,
        layer=layer,
        thickness_nm=thickness_nm,
        theta_i_deg=incidence.theta_i_deg,
        illuminant=viewing.illuminant,
        observer=viewing.observer,
        adaptation=viewing.adaptation,
        step_nm=step,
        colors=colors,
        warnings=warnings,
    )


def seen_over_angle(media: FilmMedia) -> tuple[Callable[[Incidence], Array], int, list[str]]:
    """What gives colors of films in daylight at directions of shape (A,), of how many wavelengths.

    Last is what has to be said of them.

    Raises
    ------
    OpticsError
        If a layer has no thickness, or a medium no spectrum.
    """
    nm = media.layers[0].thickness_nm or 0.0
    _, stack, step, warnings = _sampled(media, swept_place(media.layers, 1), nm)
    weights = sampled_weights(srgb_weights(*DAYLIGHT), step)

    def colors(incidence: Incidence) -> Array:
        # Each angle is a whole spectrum.
        found = np.empty((incidence.cos.size, 3))
        for first in range(0, len(found), _ANGLES):
            some = slice(first, first + _ANGLES)
            part = Incidence(incidence.cos[some], incidence.sin[some])
            found[some] = reflected_colors(stack, part, weights)
        return found

    return colors, len(weights), warnings


def _sampled(
    media: FilmMedia, place: int, thickest_nm: float
) -> tuple[Stack, Stack, int, list[str]]:
    """The stack at every wavelength, at as many as its fringes want, their distance, and warnings."""
    whole, warnings = media.visible()
    optical = optical_thickness(whole, place, thickest_nm)
    step = step_nm(optical)
    if not is_resolved(optical):
        warnings = [*warnings, UNRESOLVED]
    return whole, whole if step == 1 else media.visible(step)[0], step, warnings


def model_colors(
    model: str, linear: Array, viewing: Viewing, delta_e: Array | None = None
) -> ModelColors:
    """Describe colors of shape (thicknesses, angles, 3)."""
    return ModelColors(
        model=model,
        linear_srgb=linear,
        lab=lab(linear, viewing.observer),
        hex=hex_rows(linear),
        delta_e=delta_e,
    )


def hex_rows(linear: Array) -> list[list[str]]:
    """Write colors as `#rrggbb`, each channel cut to 0 and 1."""
    steps = np.rint(255.0 * encode_srgb(np.clip(linear, 0.0, 1.0))).astype(np.uint8)
    text = steps.tobytes().hex()
    cells = ["#" + text[at : at + 6] for at in range(0, len(text), 6)]
    columns = linear.shape[1]
    return [cells[at : at + columns] for at in range(0, len(cells), columns)]


def optical_thickness(stack: Stack, place: int, thickness_nm: float) -> float:
    """Sum of n d of the coherent layers, of which one has another thickness."""
    return float(
        sum(
            layer.n.max() * (thickness_nm if at == place else layer.thickness_nm.max())
            for at, layer in enumerate(stack.layers)
            if not layer.incoherent
        )
    )
