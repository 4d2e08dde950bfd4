r"""From reflectance spectra to linear sRGB: CIE observers, illuminants, adaptation, gamut, transfer.

A spectrum is an array whose last axis runs over `WAVELENGTH_NM`, 360 to 830 nm in steps of 1 nm.
With the observer's functions x, y, z and the illuminant's power S,

.. math::
    X = \frac{\sum R S \bar x}{\sum S \bar y}, \quad
    Y = \frac{\sum R S \bar y}{\sum S \bar y}, \quad
    Z = \frac{\sum R S \bar z}{\sum S \bar y}

so a perfect reflector has the illuminant's white, with Y = 1. Linear sRGB takes the primaries of
IEC 61966-2-1 and, as its white, D65 integrated from the same tables: R = 1 is (1, 1, 1) to the last
digits, where the standard's four-digit matrix is 2e-4 off. Another illuminant's white is first
brought to D65 by Bradford adaptation.

References
----------
.. [1] CIE 015:2018, Colorimetry, 4th edition.
.. [2] IEC 61966-2-1:1999, sections 4.2 and 5.
.. [5] S-2014-004, ACEScg: A Working Space for CGI Render and Compositing, Academy of Motion Picture
   Arts and Sciences.
.. [4] G. Sharma, W. Wu and E. N. Dalal, The CIEDE2000 color-difference formula, Color Res. Appl. 30
   (2005) 21-30.
.. [3] K. M. Lam, Metamerism and Colour Constancy, thesis, University of Bradford, 1985.
"""

from functools import cache
from pathlib import Path
from typing import Literal, get_args

import numpy as np
from numpy.typing import ArrayLike

from app.optics.errors import NotAllowed, OutOfRange, UnknownName
from app.optics.parameters import Array

Illuminant = Literal["D65", "E"]
Observer = Literal["cie1931_2deg", "cie1964_10deg"]
Adaptation = Literal["bradford", "none"]
Gamut = Literal["unclamped", "clamped", "scaled"]
Space = Literal["srgb", "acescg"]

ILLUMINANTS: tuple[Illuminant, ...] = get_args(Illuminant)
OBSERVERS: tuple[Observer, ...] = get_args(Observer)
ADAPTATIONS: tuple[Adaptation, ...] = get_args(Adaptation)
GAMUTS: tuple[Gamut, ...] = get_args(Gamut)

WAVELENGTH_NM: Array = np.arange(360.0, 831.0)
WAVELENGTH_NM.flags.writeable = False

PRIMARIES_XY = ((0.64, 0.33), (0.30, 0.60), (0.15, 0.06))
"""Chromaticities of the sRGB primaries [2]_."""

AP1_XY = ((0.713, 0.293), (0.165, 0.830), (0.128, 0.044))
"""Chromaticities of the primaries of ACEScg, AP1 [5]_."""

ACES_WHITE_XY = (0.32168, 0.33767)
"""Chromaticity of the ACES white [5]_."""

TRANSFER = "sRGB transfer curve of IEC 61966-2-1"
"""What `encode_srgb` applies, for whoever reads a hexadecimal code."""

BRADFORD: Array = np.array(
    [[0.8951, 0.2664, -0.1614], [-0.7502, 1.7135, 0.0367], [0.0389, -0.0685, 1.0296]]
)
BRADFORD.flags.writeable = False

_TABLE = Path(__file__).parent / "tables" / "cie_360_830_1nm.csv"
_FIRST_COLUMN = {"cie1931_2deg": 1, "cie1964_10deg": 4}
_D65_COLUMN = 7


def _check(parameter: str, value: str, known: tuple[str, ...]) -> None:
    if value not in known:
        raise UnknownName(parameter, value, known)


@cache
def _table() -> Array:
    table: Array = np.loadtxt(_TABLE, delimiter=",", comments="#", dtype=np.float64)
    if not np.array_equal(table[:, 0], WAVELENGTH_NM):
        raise NotAllowed("table", _TABLE.name, "360 to 830 nm in steps of 1 nm")
    table.flags.writeable = False
    return table


def color_matching(observer: Observer = "cie1931_2deg") -> Array:
    """Color-matching functions of an observer, shape (471, 3), columns x, y, z."""
    _check("observer", observer, OBSERVERS)
    column = _FIRST_COLUMN[observer]
    return _table()[:, column : column + 3]


def illuminant_power(illuminant: Illuminant = "D65") -> Array:
    """Relative spectral power of an illuminant, shape (471,); E is the same everywhere."""
    _check("illuminant", illuminant, ILLUMINANTS)
    if illuminant == "E":
        return np.full(WAVELENGTH_NM.size, 100.0)
    return np.asarray(_table()[:, _D65_COLUMN])


@cache
def xyz_weights(illuminant: Illuminant = "D65", observer: Observer = "cie1931_2deg") -> Array:
    """Weights w of shape (471, 3) such that R @ w is XYZ, with Y = 1 for R = 1."""
    weights: Array = color_matching(observer) * illuminant_power(illuminant)[:, np.newaxis]
    weights = np.asarray(weights / weights[:, 1].sum())
    weights.flags.writeable = False
    return weights


def white(illuminant: Illuminant = "D65", observer: Observer = "cie1931_2deg") -> Array:
    """XYZ of the perfect reflector, shape (3,), Y = 1."""
    return np.asarray(xyz_weights(illuminant, observer).sum(axis=0))


@cache
def srgb_from_xyz(observer: Observer = "cie1931_2deg") -> Array:
    """Return the 3 x 3 matrix that takes XYZ with D65's white to linear sRGB.

    The primaries are defined for the 2 degree observer; with the 10 degree one they keep their
    chromaticities, which makes a comparison of observers, not a standard.
    """
    return _from_xyz(PRIMARIES_XY, white("D65", observer))


def _from_xyz(primaries_xy: tuple[tuple[float, float], ...], white_xyz: Array) -> Array:
    """Matrix from XYZ to linear RGB of these primaries, whose white is (1, 1, 1)."""
    primaries = np.array([[x / y, 1.0, (1.0 - x - y) / y] for x, y in primaries_xy]).T
    scale = np.linalg.solve(primaries, white_xyz)
    matrix: Array = np.linalg.inv(primaries * scale)
    matrix.flags.writeable = False
    return matrix


@cache
def acescg_from_srgb(observer: Observer = "cie1931_2deg") -> Array:
    """Return the 3 x 3 matrix from linear sRGB to ACEScg; white stays (1, 1, 1).

    D65 is adapted to the white of ACES by Bradford [3]_, [5]_.
    """
    x, y = ACES_WHITE_XY
    target = np.array([x / y, 1.0, (1.0 - x - y) / y])
    adapt = bradford(white("D65", observer), target)
    matrix = np.asarray(_from_xyz(AP1_XY, target) @ adapt @ np.linalg.inv(srgb_from_xyz(observer)))
    matrix.flags.writeable = False
    return matrix


def in_space(rgb: ArrayLike, space: Space, observer: Observer = "cie1931_2deg") -> Array:
    """Linear sRGB, shape (..., 3), in another linear space, not clamped."""
    colors = np.asarray(rgb, dtype=np.float64)
    return colors if space == "srgb" else np.asarray(colors @ acescg_from_srgb(observer).T)


def bradford(source_white: ArrayLike, target_white: ArrayLike) -> Array:
    """Return the 3 x 3 matrix that adapts XYZ seen under one white to another."""
    source = BRADFORD @ np.asarray(source_white, dtype=np.float64)
    target = BRADFORD @ np.asarray(target_white, dtype=np.float64)
    return np.asarray(np.linalg.solve(BRADFORD, (target / source)[:, np.newaxis] * BRADFORD))


@cache
def srgb_weights(
    illuminant: Illuminant = "D65",
    observer: Observer = "cie1931_2deg",
    adaptation: Adaptation = "bradford",
) -> Array:
    """Weights w of shape (471, 3) such that R @ w is linear sRGB, unclamped.

    Parameters
    ----------
    illuminant, observer
        What lights the surface, and who looks.
    adaptation
        How the illuminant's white reaches D65's; "none" leaves its cast in the colors, up to 0.20
        in red under E.

    Raises
    ------
    UnknownName
        If a name is none of those that exist.
    """
    _check("adaptation", adaptation, ADAPTATIONS)
    weights = xyz_weights(illuminant, observer)
    if adaptation == "bradford" and illuminant != "D65":
        adapt = bradford(white(illuminant, observer), white("D65", observer))
        weights = weights @ adapt.T
    result = np.asarray(weights @ srgb_from_xyz(observer).T)
    result.flags.writeable = False
    return result


def rendered_white(
    illuminant: Illuminant = "D65",
    observer: Observer = "cie1931_2deg",
    adaptation: Adaptation = "bradford",
) -> Array:
    """Linear sRGB of the perfect reflector, shape (3,); arguments as for `srgb_weights`.

    Ones, but for the cast of an illuminant that is not adapted to D65. Divided by it, a color is
    what a surface reflects of each channel, whatever the light: what models of R take.
    """
    if illuminant == "D65" or adaptation == "bradford":
        return np.ones(3)
    return np.asarray(srgb_weights(illuminant, observer, adaptation).sum(axis=0))


def _spectrum(values: ArrayLike) -> Array:
    array = np.asarray(values, dtype=np.float64)
    if array.ndim == 0 or array.shape[-1] != WAVELENGTH_NM.size:
        raise NotAllowed("values", array.shape, "471 values, 360 to 830 nm by 1 nm")
    return array


def xyz(
    values: ArrayLike, illuminant: Illuminant = "D65", observer: Observer = "cie1931_2deg"
) -> Array:
    """Tristimulus values of reflectance spectra, shape (..., 471) to (..., 3); Y is luminance.

    Raises
    ------
    NotAllowed
        If the last axis does not have 471 values.
    UnknownName
        If there is no such illuminant or observer.
    """
    return np.asarray(_spectrum(values) @ xyz_weights(illuminant, observer))


def linear_srgb(
    values: ArrayLike,
    illuminant: Illuminant = "D65",
    observer: Observer = "cie1931_2deg",
    adaptation: Adaptation = "bradford",
) -> Array:
    """Linear sRGB of reflectance spectra, shape (..., 471) to (..., 3), not clamped.

    Channels outside 0 to 1 are colors that sRGB cannot show; `apply_gamut` has the ways out.

    Raises
    ------
    NotAllowed
        If the last axis does not have 471 values.
    UnknownName
        If there is no such illuminant, observer or adaptation.

    Examples
    --------
    What reflects everything is white under every illuminant:

    >>> import numpy as np
    >>> bool(np.allclose(linear_srgb(np.ones(471), "E"), 1.0, atol=1e-12))
    True
    """
    return np.asarray(_spectrum(values) @ srgb_weights(illuminant, observer, adaptation))


def luminance(
    values: ArrayLike, illuminant: Illuminant = "D65", observer: Observer = "cie1931_2deg"
) -> Array:
    """Luminous reflectance Y of reflectance spectra, shape (..., 471) to (...)."""
    return np.asarray(xyz(values, illuminant, observer)[..., 1])


def lab(rgb: ArrayLike, observer: Observer = "cie1931_2deg") -> Array:
    """CIELAB of linear sRGB, shape (..., 3), relative to its white; not clamped before.

    Tristimulus values below 0, of colors that no light has, continue the linear foot.
    """
    back = np.linalg.inv(srgb_from_xyz(observer)).T
    shares = np.asarray(rgb, dtype=np.float64) @ back / white("D65", observer)
    foot = (841.0 / 108.0) * shares + 4.0 / 29.0
    f = np.where(shares > (6.0 / 29.0) ** 3, np.cbrt(shares), foot)
    L = 116.0 * f[..., 1] - 16.0
    a, b = 500.0 * (f[..., 0] - f[..., 1]), 200.0 * (f[..., 1] - f[..., 2])
    return np.stack([L, a, b], axis=-1)


def delta_e_2000(first: ArrayLike, second: ArrayLike) -> Array:
    """CIEDE2000 between colors in CIELAB, shapes (..., 3) to (...), with k_L = k_C = k_H = 1 [4]_.

    Examples
    --------
    The first pair of the published test data:

    >>> round(float(delta_e_2000([50.0, 2.6772, -79.7751], [50.0, 0.0, -82.7485])), 4)
    2.0425
    """
    (L1, a1, b1), (L2, a2, b2) = (
        np.moveaxis(np.asarray(color, dtype=np.float64), -1, 0) for color in (first, second)
    )
    chroma7 = (0.5 * (np.hypot(a1, b1) + np.hypot(a2, b2))) ** 7
    stretch = 1.0 + 0.5 * (1.0 - np.sqrt(chroma7 / (chroma7 + 25.0**7)))
    a1, a2 = stretch * a1, stretch * a2
    C1, C2 = np.hypot(a1, b1), np.hypot(a2, b2)
    h1, h2 = (np.degrees(np.arctan2(b, a)) % 360.0 for a, b in ((a1, b1), (a2, b2)))
    gray = C1 * C2 == 0.0
    turn = (h2 - h1 + 180.0) % 360.0 - 180.0
    turn = np.where(gray, 0.0, np.where(turn == -180.0, 180.0, turn))
    dL, dC = L2 - L1, C2 - C1
    dH = 2.0 * np.sqrt(C1 * C2) * np.sin(np.radians(0.5 * turn))
    L, C = 0.5 * (L1 + L2), 0.5 * (C1 + C2)
    apart = np.abs(h1 - h2) > 180.0
    h = 0.5 * (h1 + h2 + np.where(apart, np.where(h1 + h2 < 360.0, 360.0, -360.0), 0.0))
    h = np.where(gray, h1 + h2, h)
    T = (
        1.0
        - 0.17 * np.cos(np.radians(h - 30.0))
        + 0.24 * np.cos(np.radians(2.0 * h))
        + 0.32 * np.cos(np.radians(3.0 * h + 6.0))
        - 0.20 * np.cos(np.radians(4.0 * h - 63.0))
    )
    S_L = 1.0 + 0.015 * (L - 50.0) ** 2 / np.sqrt(20.0 + (L - 50.0) ** 2)
    S_C, S_H = 1.0 + 0.045 * C, 1.0 + 0.015 * C * T
    R_C = 2.0 * np.sqrt(C**7 / (C**7 + 25.0**7))
    R_T = -R_C * np.sin(np.radians(60.0 * np.exp(-(((h - 275.0) / 25.0) ** 2))))
    L_, C_, H_ = dL / S_L, dC / S_C, dH / S_H
    return np.asarray(np.sqrt(L_ * L_ + C_ * C_ + H_ * H_ + R_T * C_ * H_))


def apply_gamut(rgb: ArrayLike, policy: Gamut) -> Array:
    """Bring linear sRGB, shape (..., 3), into the gamut by a named policy.

    Parameters
    ----------
    rgb
        Linear sRGB, any values.
    policy
        "unclamped" changes nothing. "clamped" cuts every channel to 0 and 1, which shifts the hue.
        "scaled" cuts negative channels to 0 and divides each color by its largest channel if that
        exceeds 1, which keeps the hue and loses brightness.

    Raises
    ------
    UnknownName
        If there is no such policy.

    Examples
    --------
    The gold that circulates in three versions:

    >>> [round(float(c), 3) for c in apply_gamut([1.022, 0.782, 0.344], "scaled")]
    [1.0, 0.765, 0.337]
    """
    _check("gamut", policy, GAMUTS)
    array = np.array(rgb, dtype=np.float64)
    if policy == "unclamped":
        return array
    if policy == "clamped":
        return np.clip(array, 0.0, 1.0)
    positive = np.maximum(array, 0.0)
    return np.asarray(positive / np.maximum(positive.max(axis=-1, keepdims=True), 1.0))


def encode_srgb(linear: ArrayLike) -> Array:
    """Linear sRGB to sRGB values by the transfer function of [2]_, any shape.

    Its linear foot continues below 0 and its power above 1, so unclamped values stay ordered.
    """
    array = np.asarray(linear, dtype=np.float64)
    power = 1.055 * np.maximum(array, 0.0031308) ** (1.0 / 2.4) - 0.055
    return np.where(array <= 0.0031308, 12.92 * array, power)


def decode_srgb(encoded: ArrayLike) -> Array:
    """Invert `encode_srgb`: sRGB values to linear sRGB, any shape."""
    array = np.asarray(encoded, dtype=np.float64)
    power = ((np.maximum(array, 0.04045) + 0.055) / 1.055) ** 2.4
    return np.where(array <= 0.04045, array / 12.92, power)


def srgb_hex(linear: ArrayLike) -> str:
    """Write one linear sRGB color, shape (3,), as `#rrggbb`.

    Raises
    ------
    OutOfRange
        If a channel is outside 0 to 1: choose a gamut policy first.

    Examples
    --------
    >>> srgb_hex([1.0, 0.5, 0.0])
    '#ffbc00'
    """
    array = np.asarray(linear, dtype=np.float64)
    # The rounding of a white computed from a spectrum is not a color outside the gamut.
    if array.shape != (3,) or not bool(np.all((array >= -1e-9) & (array <= 1.0 + 1e-9))):
        raise OutOfRange("rgb", array.tolist(), "three channels from 0 to 1; see apply_gamut")
    return "#" + "".join(f"{round(float(c) * 255):02x}" for c in encode_srgb(np.clip(array, 0, 1)))
