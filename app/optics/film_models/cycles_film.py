"""The thin film of Blender's Cycles."""

from functools import cache

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline

from app.optics.color import WAVELENGTH_NM, color_matching, srgb_from_xyz
from app.optics.film_models import (
    CoatedSurface,
    Deviation,
    FilmModel,
    Sensitivity,
    airy,
    faded,
    inside,
)
from app.optics.parameters import Array

_ROWS = 512
_LONGEST_NM = 60000.0 / (2.0 * np.pi)
_WHOLE_AT_NM = 1.0


@cache
def _table() -> NDArray[np.complex128]:
    """Fourier transform of the sensitivities of linear sRGB, as Cycles computes it: by the frequency."""
    count = 2 * (_ROWS - 1)
    frequency = np.maximum(np.linspace(0.0, np.pi * (count - 1) / 60.0, count), 1e-40)
    nm = np.concatenate([WAVELENGTH_NM[:1] - 1.0, WAVELENGTH_NM, WAVELENGTH_NM[-1:] + 1.0])
    xyz = np.pad(color_matching(), ((1, 1), (0, 0)))
    spline = CubicSpline(nm, xyz, extrapolate=False)
    sampled = np.nan_to_num(spline(1000.0 / frequency)) / (frequency * frequency)[:, np.newaxis]
    rgb = np.fft.rfft(sampled, axis=0) @ srgb_from_xyz().T
    return np.asarray(rgb / rgb[0].real)


def looked_up(difference: Array, phase: Array) -> Array:
    """S of linear sRGB, between the entries of the table, and beyond it its last one."""
    table = _table()
    place = np.clip(difference / _LONGEST_NM, 0.0, 1.0) * (_ROWS - 1)
    low = np.minimum(place.astype(np.int64), _ROWS - 2)
    share = place - low
    channels = np.arange(3)
    value = (1.0 - share) * table[low, channels] + share * table[low + 1, channels]
    return np.asarray((np.exp(1j * phase) * value.conj()).real)


def _amplitudes(cos: Array, cos2: Array, n: Array) -> tuple[Array, Array]:
    """r of s and p at a boundary of real index, p with the sign of s at normal incidence."""
    return (
        np.asarray((cos - n * cos2) / (cos + n * cos2)),
        np.asarray((n * cos - cos2) / (n * cos + cos2)),
    )


def coated(surface: CoatedSurface, sensitivity: Sensitivity) -> Array:
    """Each polarization by itself with its phase, three orders."""
    film_n = faded(surface, _WHOLE_AT_NM)
    cos2, kept_out = inside(surface, film_n)
    difference = 2.0 * film_n * surface.thickness_nm * cos2
    N = surface.n + 1j * surface.k
    eta = N / film_n
    cos3 = np.sqrt(1.0 - (1.0 - cos2 * cos2) / (eta * eta))
    lower = (cos2 - eta * cos3) / (cos2 + eta * cos3), (eta * cos2 - cos3) / (eta * cos2 + cos3)
    upper = _amplitudes(surface.cos, cos2, film_n)
    total = sum(
        airy(
            r12 * r12,
            np.abs(r23) ** 2,
            np.where(r12 < 0.0, 0.0, np.pi) + np.angle(r23),
            difference,
            sensitivity,
            3,
        )
        for r12, r23 in zip(upper, lower, strict=True)
    )
    return np.asarray(np.where(kept_out, 1.0, 0.5 * total))


MODEL = FilmModel(
    id="cycles_film",
    title="Cycles thin film",
    reference="Blender 5.2, intern/cycles/kernel/closure/bsdf_util.h, fresnel_iridescence, after "
    "L. Belcour and P. Barla (2017), doi:10.1145/3072959.3073620",
    validity="Each polarization by itself with its phase, three orders: exact at single wavelengths "
    "but for the orders left out, which count at grazing angles of strong reflectors. The color is "
    "that of equal energy, each channel scaled so that white stays white. Below 1 nm the film's index "
    "fades to 1.",
    function=coated,
    sensitivity=looked_up,
    floor=0.0,
    ceiling=1.0,
    measured=(
        Deviation(
            film_n=1.33, n_t=1.5, k_t=0.0, max_abs=0.0001, max_delta_e=2.27, mean_delta_e=0.733
        ),
        Deviation(
            film_n=2.4, n_t=1.5, k_t=0.0, max_abs=0.0020, max_delta_e=5.00, mean_delta_e=1.099
        ),
        Deviation(
            film_n=1.38, n_t=4.0, k_t=0.03, max_abs=0.0351, max_delta_e=5.82, mean_delta_e=1.036
        ),
        Deviation(
            film_n=1.5, n_t=1.0, k_t=6.6, max_abs=0.1837, max_delta_e=13.72, mean_delta_e=0.395
        ),
    ),
)
