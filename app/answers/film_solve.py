"""Thicknesses of films that reach something: least R, a color, quarter waves."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Literal

import numpy as np

from app.answers.answer import answer
from app.answers.film_colors import hex_rows, optical_thickness
from app.answers.film_media import FilmMedia, MediaFacts, swept_place
from app.answers.materials.about import Rgb
from app.materials.appearance import DAYLIGHT
from app.materials.films import Film
from app.optics.color import decode_srgb, delta_e_2000, lab, srgb_weights
from app.optics.errors import NotAllowed
from app.optics.film_color import step_nm, swept_colors
from app.optics.films import absorption, power, reflectances
from app.optics.incidence import Incidence
from app.optics.parameters import Array
from app.optics.stack import MOST_LAYERS, Layer, Stack

Target = Literal["minimum_R", "quarter_wave", "color"]

MOST_SOLUTIONS = 20

_HEX = re.compile(r"#?([0-9a-fA-F]{6})")
_ZOOMS, _POINTS = 7, 33
_ROUNDING = 1e-9

NO_DIFFERENCE = "the thickness of this layer makes no difference here: the thinnest stands for all"


@answer
class FilmSolution:
    """Films that reach the target, and what they do."""

    layers: str
    """With their thicknesses, as `layers` takes them."""
    thickness_nm: list[float]
    """Of every layer, from the incident side on."""
    R: float
    T: float
    A: float
    """Of unpolarized light at `wavelength_nm` and the angle."""
    linear_srgb: Rgb
    """Color of the reflected light under D65, not clamped."""
    hex: str
    """sRGB, each channel cut to 0 and 1."""
    delta_e: float | None
    """CIEDE2000 to the wanted color; null where none is wanted."""


@answer
class FilmSolutions:
    """Thicknesses that reach a target, the best first."""

    media: MediaFacts
    target: Target
    layer: int | None
    """The layer whose thickness was looked for; null where all were."""
    wavelength_nm: float
    theta_i_deg: float
    wanted_lab: Rgb | None
    """The wanted color in CIELAB."""
    solutions: list[FilmSolution]
    """The best first, and of those that are as good the thinnest."""
    warnings: list[str]


def film_solutions(
    media: FilmMedia,
    target: Target,
    *,
    wavelength_nm: float,
    theta_i_deg: float = 0.0,
    layer: int = 1,
    thickness_nm: Array,
    repeat: int = 1,
    color: str | None = None,
) -> FilmSolutions:
    """Look for thicknesses.

    Parameters
    ----------
    media
        The two media and the layers.
    target
        `minimum_R`: R of unpolarized light at the wavelength is least. `color`: CIEDE2000 to a color
        is least. `quarter_wave`: every layer delays by a quarter of the wavelength.
    wavelength_nm, theta_i_deg
        Where.
    layer
        Which layer's thickness is looked for, from 1 at the incident side; all for quarter waves.
    thickness_nm
        Thicknesses that are looked at first; the best are between those beside the best of them.
    repeat
        How often the layers follow one another, of quarter waves.
    color
        The wanted color, sRGB as `#rrggbb`.

    Raises
    ------
    OpticsError
        If there is no such layer, no such color, or a medium is not known.
    """
    incidence = Incidence.from_degrees(theta_i_deg)
    wanted = _lab_of(color) if target == "color" else None
    warnings: list[str] = []
    if target == "quarter_wave":
        media = replace(media, layers=_quarter_waves(media, wavelength_nm, incidence, repeat))
        found = [media]
    else:
        place = swept_place(media.layers, layer)
        if any(film.incoherent for film in media.layers):
            raise NotAllowed("layers", "an incoherent layer", "coherent layers alone")
        measure = (
            _reflectance(media, place, wavelength_nm, incidence)
            if wanted is None
            else _color_difference(media, place, float(thickness_nm.max()), incidence, wanted)
        )
        found = [
            replace(media, layers=_with_thickness(media.layers, place, thickness))
            for thickness in least(measure, thickness_nm)
        ]
        if np.ptp(measure(thickness_nm)) < _ROUNDING < np.ptp(thickness_nm):
            warnings.append(NO_DIFFERENCE)
    solutions = []
    for one in found:
        solution, told = _solution(one, wavelength_nm, incidence, wanted)
        solutions.append(solution)
        warnings += [warning for warning in told if warning not in warnings]
    return FilmSolutions(
        media=media.facts(),
        target=target,
        layer=None if target == "quarter_wave" else layer,
        wavelength_nm=wavelength_nm,
        theta_i_deg=theta_i_deg,
        wanted_lab=wanted,
        solutions=solutions,
        warnings=warnings,
    )


def least(measure: Callable[[Array], Array], values: Array) -> list[float]:
    """Values where a measure is least within their surroundings, the best first.

    Where it is the same everywhere, the least value stands for all.

    Parameters
    ----------
    measure
        Of many values at a time.
    values
        Where to look, in ascending order; between them the measure has one minimum at most.
    """
    at = np.unique(values)
    height = measure(at)
    if np.ptp(height) < _ROUNDING:
        return [float(at[0])]
    if at.size < 3:
        return [float(x) for x in at[np.argsort(height, kind="stable")]]
    inside = (height[1:-1] <= height[:-2]) & (height[1:-1] < height[2:])
    lows = 1 + np.flatnonzero(inside)
    # An end counts where it is the foot of a slope, and better than all that lies between.
    ends = np.array([0, at.size - 1])
    feet = height[ends] < np.minimum(height[[1, -2]], height[lows].min(initial=np.inf))
    lows = np.append(lows, ends[feet])
    best = lows[np.argsort(height[lows], kind="stable")][:MOST_SOLUTIONS]
    found = []
    for index in best.tolist():
        low, high = at[max(index - 1, 0)], at[min(index + 1, at.size - 1)]
        for _ in range(_ZOOMS):
            fine = np.linspace(low, high, _POINTS)
            middle = int(np.argmin(measure(fine)))
            low, high = fine[max(middle - 1, 0)], fine[min(middle + 1, _POINTS - 1)]
        found.append(float(fine[middle]))
    if not found:
        return []
    reached = np.round(measure(np.array(found)), 9).tolist()
    # Minima that differ by rounding alone are as good as one another: then the thinnest is first.
    return [x for _, x in sorted(zip(reached, found, strict=True))]


def _reflectance(
    media: FilmMedia, place: int, wavelength_nm: float, incidence: Incidence
) -> Callable[[Array], Array]:
    stack, _ = media.stack(np.asarray(wavelength_nm))

    def measure(thickness_nm: Array) -> Array:
        Rs, Rp = reflectances(_swept(stack, place, thickness_nm), incidence)
        return np.broadcast_to(0.5 * (Rs + Rp), thickness_nm.shape)

    return measure


def _color_difference(
    media: FilmMedia, place: int, thickest_nm: float, incidence: Incidence, wanted: Array
) -> Callable[[Array], Array]:
    step = step_nm(optical_thickness(media.visible()[0], place, thickest_nm))
    stack, _ = media.visible(step)
    weights = srgb_weights(*DAYLIGHT)
    angle = Incidence(incidence.cos.reshape(1), incidence.sin.reshape(1))

    def measure(thickness_nm: Array) -> Array:
        colors = swept_colors(stack, place, thickness_nm, angle, weights, step)[:, 0]
        return delta_e_2000(lab(colors), wanted)

    return measure


def _swept(stack: Stack, place: int, thickness_nm: Array) -> Stack:
    layers = list(stack.layers)
    layers[place] = Layer(layers[place].n, layers[place].k, thickness_nm)
    substrate, at = stack.substrate, stack.wavelength_nm
    return Stack(stack.n_i, layers, substrate.n_t, substrate.k_t, wavelength_nm=at)


def _with_thickness(layers: Sequence[Film], place: int, nm: float) -> list[Film]:
    return [
        replace(film, thickness_nm=nm) if at == place else film for at, film in enumerate(layers)
    ]


def _quarter_waves(
    media: FilmMedia, wavelength_nm: float, incidence: Incidence, repeat: int
) -> list[Film]:
    """Layers whose n d cos(theta) is a quarter of the wavelength."""
    if repeat * len(media.layers) > MOST_LAYERS:
        raise NotAllowed("repeat", repeat, f"at most {MOST_LAYERS} layers in all")
    stack, _ = media.stack(np.asarray(wavelength_nm))
    beta = float(stack.n_i) * float(incidence.sin)
    films = []
    for film, layer in zip(media.layers, stack.layers, strict=True):
        q = np.sqrt(complex(layer.n, layer.k) ** 2 - beta**2).real
        if q <= 0.0 or film.incoherent:
            why = "layers that light passes at this angle, with interference"
            raise NotAllowed("layers", film.spelled, why)
        films.append(replace(film, thickness_nm=float(wavelength_nm / (4.0 * q))))
    return films * repeat


def _solution(
    media: FilmMedia, wavelength_nm: float, incidence: Incidence, wanted: Array | None
) -> tuple[FilmSolution, list[str]]:
    stack, _ = media.stack(np.asarray(wavelength_nm))
    energy, lost = power(stack, incidence), absorption(stack, incidence)
    whole, warnings = media.visible()
    Rs, Rp = reflectances(whole, incidence)
    linear = 0.5 * (Rs + Rp) @ srgb_weights(*DAYLIGHT)
    solution = FilmSolution(
        layers=",".join(film.spelled for film in media.layers),
        thickness_nm=[film.thickness_nm or 0.0 for film in media.layers],
        R=float(energy.R),
        T=float(energy.T),
        A=float(lost.A),
        linear_srgb=linear,
        hex=hex_rows(linear.reshape(1, 1, 3))[0][0],
        delta_e=None if wanted is None else float(delta_e_2000(lab(linear), wanted)),
    )
    return solution, warnings


def _lab_of(color: str | None) -> Array:
    found = _HEX.fullmatch(color or "")
    if found is None:
        raise NotAllowed("color", color, "an sRGB color such as #8040c0")
    channels = np.frombuffer(bytes.fromhex(found[1]), np.uint8) / 255.0
    return lab(decode_srgb(channels))
