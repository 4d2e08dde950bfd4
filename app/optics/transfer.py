r"""How a wave passes coherent layers, without losing digits anywhere.

With q = sqrt(N^2 - sin^2 theta_i) of each medium, all relative to n_i, the admittance y is q for s and
q / N^2 for p polarization, E is the tangential electric field for s and the magnetic one for p, and H
is the other. Through a layer of phase delta = 2 pi n_i q d / wavelength, from its back to its front,

.. math::
    E' = \cos\delta\, E - \frac{i \sin\delta}{y} H, \qquad
    H' = -i y \sin\delta\, E + \cos\delta\, H.

In place of H the difference D = y_0 E - H to a wave that only comes in is carried along, y_0 being the
admittance in front: with S = sin(delta) / q, and Y = sin(delta) / y, which is S or N^2 S,

.. math::
    D' = (\cos\delta + i y_0 Y) D - i Y (y_0^2 - y^2) E, \qquad
    E' = (\cos\delta - i y_0 Y) E + i Y D,

and r = D / (2 y_0 E - D). Three things are gained over Airy's sums and over plain matrices. All
coefficients are even in q, so nothing happens at the critical angle of an inner layer, where q is 0
and the reflection at either face total. Where indices nearly match, D is small, but as exact as its
factors. And every matrix is divided by exp(Im delta), which is kept apart, so that no thickness
overflows and what passes a thick absorber keeps its digits.

Convention: time factor exp(-i w t), k >= 0, r_p = -r_s at normal incidence.

References
----------
.. [1] M. Born and E. Wolf, Principles of Optics, 7th ed., section 1.6.
.. [2] H. A. Macleod, Thin-Film Optical Filters, 4th ed., section 2.4.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from app.optics.amplitudes import brewster_null, wave
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.numerics.choice import anywhere, everywhere, maximum, select, sqrt
from app.optics.numerics.pairs import (
    ONE,
    Pair,
    conjugate,
    is_zero,
    minus,
    minus_i,
    over,
    plus,
    plus_i,
    product,
    scaled,
    square_of,
    times,
)
from app.optics.parameters import Condition, Number
from app.optics.stack import Sheet

# In place of 0 below a fraction whose numerator is 0 too: the square of each is a double.
_SMALLEST_Q, _SMALLEST_START = 1e-150, 1e-100

NOTHING = 1e-300
"""The square of an incident wave that is 0, as that of a grazing ray which meets no boundary."""

# Layers after which a field is scaled back, which each may multiply by the 1e16 of a tangent.
_SCALED_AFTER = 4


class Medium(NamedTuple):
    """A medium as the wave in it is described, relative to n_i."""

    excess: Pair
    """N - 1, with the digits that the difference would lose."""
    square: Pair
    """N^2."""
    q: Pair
    """Normal component of the wave vector."""
    q2: Number
    """|q|^2."""
    strong: bool
    """Whether it absorbs so much at all values that plain differences keep their digits."""
    dense: bool
    """Whether n > n_i at all values, so that q is not 0."""


class Group(NamedTuple):
    """Layers that interfere with one another, and the two media that they lie between."""

    front: Medium
    sheets: Sequence[Sheet]
    back: Medium
    boundary: Interface | None
    """From the incident medium to the back, where the front is the incident medium: then the zero
    at Brewster's angle is known to all digits."""


class Passage(NamedTuple):
    """What a group does to a wave that comes from its front, in one polarization."""

    D: Pair
    """Amplitude of the reflected wave times 2 y_0."""
    E: Pair
    """The field at the front, and"""
    S: Pair
    """2 y_0 E - D, the amplitude of the incident wave times 2 y_0; left out where `summed`."""
    D2: Number
    S2: Number
    """Their squares."""
    summed: bool
    """Whether S2 is the sum of D2 and of what passes, so that no part of it rounds above 1."""
    start: Pair
    """Amplitude at the back, before it was scaled by `shrunk`."""
    shrunk: Number
    """Of use where fields were asked for."""
    shrunk2: Number
    """Its square, and that of what else all was divided by."""
    flux: Number
    """Power at the back, Re(E* H)."""
    passed: Number
    """That times 4 Re y_0, which makes it a part of `S2` where y_0 is real."""
    y: Pair
    """y_0."""
    lost: tuple[Number, ...]
    """Power that each sheet absorbs, in the units of `S2`, where it was asked for."""


def incident_medium(incidence: Incidence, kappa_i: Number) -> Medium:
    """The medium in front; where it absorbs, the angle is 0."""
    if not anywhere(kappa_i > 0.0):
        c = incidence.numbers[0]
        return Medium((0.0, 0.0), ONE, (c, 0.0), c * c, False, False)
    square = 1.0 - kappa_i * kappa_i, 2.0 * kappa_i
    return Medium((0.0, kappa_i), square, (1.0, kappa_i), square_of((1.0, kappa_i)), False, False)


def medium(interface: Interface, incidence: Incidence) -> Medium:
    """A layer or the second medium."""
    q = wave(interface, incidence)
    eta, kappa, eta_minus_1 = interface.relative
    strong = everywhere(interface.absorbs_strongly)
    dense = everywhere(eta_minus_1 > 0.0)
    excess: Pair = eta_minus_1, 0.0
    square: Pair = eta * eta, 0.0
    if not interface.is_lossless:
        excess = eta_minus_1, kappa
        square = eta * eta - kappa * kappa, 2.0 * eta * kappa
    return Medium(excess, square, (q.a, q.b), q.abs2, strong, dense)


def passages(
    group: Group, incidence: Incidence, *, fields: bool = False, losses: bool = False
) -> tuple[Passage, Passage]:
    """Follow a wave from the back of a group to its front, in s and in p polarization.

    Parameters
    ----------
    group
        The layers and what is in front of and behind them.
    incidence
        The directions.
    fields
        Whether amplitudes are wanted with their phases, not powers alone.
    losses
        Whether it is wanted what each layer absorbs.
    """
    front, sheets, _, _ = group
    s2 = incidence.numbers[1] * incidence.numbers[1]
    quiet = front.square is ONE and not fields and not losses
    quiet = quiet and all(sheet.medium.is_lossless for sheet in sheets)
    tracks = _starts(group, incidence)
    for place, sheet in enumerate(reversed(sheets), start=1):
        layer = medium(sheet.medium, incidence)
        turn = _turn(layer, sheet.phase, fields or losses)
        if losses:
            lost: Pair = 0.0, 0.0
            if not sheet.medium.is_lossless:
                lost = _lost(layer, sheet.phase, turn, s2, tracks)
            for track, power in zip(tracks, lost, strict=True):
                track.lost.append(power)
        only_D = quiet and place == len(sheets)
        scale = place % _SCALED_AFTER == 0 and not only_D
        of_layer = _coefficients(front, layer, turn.S, s2)
        for track, coefficients in zip(tracks, of_layer, strict=True):
            track.step(turn, coefficients, only_D=only_D, scale=scale)
    first, second = (track.arrived(quiet) for track in tracks)
    return first, second


class Pencil(NamedTuple):
    """D and S at the front as functions of the phase of one layer, in one polarization.

    D = cos(delta) D_cos + sin(delta)/q D_sin, and S likewise.
    """

    D_cos: Pair
    D_sin: Pair
    S_cos: Pair
    S_sin: Pair


def pencils(group: Group, place: int, incidence: Incidence) -> tuple[Medium, Pencil, Pencil]:
    """Leave the thickness of one layer open: the layer's medium, and a pencil each of s and p.

    Parameters
    ----------
    group
        The layers and what is in front of and behind them.
    place
        Of the layer whose thickness varies, from 0 at the front.
    incidence
        The directions.
    """
    front, sheets = group.front, group.sheets
    s2 = incidence.numbers[1] * incidence.numbers[1]

    def passed(tracks: Sequence[_Track], between: Sequence[Sheet]) -> None:
        for sheet in reversed(between):
            layer = medium(sheet.medium, incidence)
            turn = _turn(layer, sheet.phase, signed=True)
            of_layer = _coefficients(front, layer, turn.S, s2)
            for i, track in enumerate(tracks):
                track.step(turn, of_layer[i % 2], only_D=False, scale=False)

    behind = _starts(group, incidence)
    passed(behind, sheets[place + 1 :])
    open_layer = medium(sheets[place].medium, incidence)
    sines = []
    for track, of_layer in zip(
        behind, _coefficients(front, open_layer, (1.0, 0.0), s2), strict=True
    ):
        D = plus(times(of_layer.advance, track.D), times(of_layer.back, track.E))
        E = minus(times(of_layer.Y, track.D), times(of_layer.advance, track.E))
        none: Pair = 0.0, 0.0
        sines.append(_Track(plus_i(none, D), plus_i(none, E), 0.0, track.y))
    tracks = (*behind, *sines)
    passed(tracks, sheets[:place])
    ends = [(track.D, minus(scaled(times(track.y, track.E), 2.0), track.D)) for track in tracks]
    of_s, of_p = (Pencil(ends[i][0], ends[i + 2][0], ends[i][1], ends[i + 2][1]) for i in (0, 1))
    return open_layer, of_s, of_p


def _starts(group: Group, incidence: Incidence) -> tuple[_Track, _Track]:
    """The waves that leave at the back, in s and in p polarization."""
    front, _, back, boundary = group
    c, s = incidence.numbers
    s2 = s * s
    contrast, squares = _contrast(front, back), times(front.square, back.square)
    together, den = times(front.q, back.q), plus(front.q, back.q)
    difference: Pair = together[0] - s2, together[1]
    if boundary is not None and not back.strong:
        null = brewster_null(boundary, incidence)
        careful = over(null, plus(together, (s2, 0.0)))
        plain = boundary.absorbs_strongly
        difference = _either(plain, difference, careful) if anywhere(plain) else careful
    if not back.dense and anywhere(c == 0.0):
        den = maximum(den[0], _SMALLEST_START), den[1]
    # Re y = Re q (|q|^2 + s^2) / |N|^4 for p
    flux_s = product(back.q[0], square_of(den))
    flux_p = flux_s * ((back.q2 + s2) * (1.0 / square_of(back.square)))
    end_p = times(over(contrast, squares), difference)
    y_p = front.q if front.square is ONE else over(front.q, front.square)
    return (
        _Track(scaled(contrast, -1.0), den, flux_s, front.q),
        _Track(end_p, den, flux_p, y_p),
    )


class _Turn(NamedTuple):
    """What the phase of a layer does, all divided by exp(Im delta), or by cos(Re delta) as well."""

    cos: Pair
    S: Pair
    """sin(delta) / q."""
    shrunk: Number
    """exp(-Im delta), where fields are wanted."""
    shrunk2: Number
    """Square of what all is divided by."""
    fall: Number
    """exp(-2 Im delta) - 1."""


def _turn(layer: Medium, phase: Number, signed: bool) -> _Turn:
    a, b = layer.q
    cosine: Number = 1.0
    shrunk2: Number = 1.0
    if not layer.dense:
        a = maximum(a, _SMALLEST_Q)
    angle = a * phase
    sine: Number
    if isinstance(angle, float):
        cosine, sine = math.cos(angle), math.sin(angle)
    elif signed:
        cosine, sine = np.cos(angle), np.sin(angle)
    else:
        # NumPy has a vectorised tangent alone; a factor that all coefficients share changes no
        # power, and that of a product of a few 1e16 is still a double.
        sine = np.tan(angle)
        shrunk2 = sine * sine
        shrunk2 += 1.0
    if is_zero(b):
        return _Turn((cosine, 0.0), (sine / a, 0.0), 1.0, shrunk2, 0.0)
    depth = 2.0 * b * phase
    one = isinstance(depth, float)
    fall = math.expm1(-depth) if one else np.expm1(-depth)
    shrunk = (math.exp(-0.5 * depth) if one else np.exp(-0.5 * depth)) if signed else 1.0
    # Not 1 + fall, of which no digit is left where the layer is thick.
    stays = math.exp(-depth) if one else np.exp(-depth)
    mean, half = 1.0 + 0.5 * fall, -0.5 * fall
    S = over((sine * mean, product(cosine, half)), (a, b))
    cos = product(cosine, mean), -(sine * half)
    return _Turn(cos, S, shrunk, product(shrunk2, stays), fall)


class _Coefficients(NamedTuple):
    """Of one layer in one polarization: y_0 Y, Y (y^2 - y_0^2) and Y."""

    advance: Pair
    back: Pair
    Y: Pair


def _coefficients(
    front: Medium, layer: Medium, S: Pair, s2: Number
) -> tuple[_Coefficients, _Coefficients]:
    contrast = _contrast(front, layer)
    of_s = _Coefficients(times(front.q, S), times(contrast, S), S)
    Y, q02 = times(layer.square, S), times(front.q, front.q)
    # y^2 - y_0^2 = (N^2 - N_0^2) (s^2 N_0^2 - q_0^2 N^2) / (N_0^2 N^2)^2
    null = minus(scaled(front.square, s2), times(q02, layer.square))
    ratio, advance = over(contrast, layer.square), times(front.q, Y)
    if front.square is not ONE:
        ratio = over(ratio, times(front.square, front.square))
        advance = over(advance, front.square)
    return of_s, _Coefficients(advance, times(times(ratio, null), S), Y)


class _Track:
    """A wave of one polarization on its way from the back to the front."""

    def __init__(self, D: Pair, start: Pair, flux: Number, y: Pair) -> None:
        self.D, self.E = D, start
        self.start, self.flux, self.y = start, flux, y
        self.shrunk: Number = 1.0
        self.shrunk2: Number = 1.0
        self.lost: list[Number] = []
        self._steps: list[Number] = []

    @property
    def H(self) -> Pair:
        """The other field, y_0 E - D."""
        return minus(times(self.y, self.E), self.D)

    def step(self, turn: _Turn, of_layer: _Coefficients, *, only_D: bool, scale: bool) -> None:
        """Pass a layer; at the last one E may not be needed."""
        D, E, advance = self.D, self.E, of_layer.advance
        self.D = plus_i(times(plus_i(turn.cos, advance), D), times(of_layer.back, E))
        if not only_D:
            self.E = plus_i(times(minus_i(turn.cos, advance), E), times(of_layer.Y, D))
        shrunk, shrunk2 = turn.shrunk, turn.shrunk2
        if scale:
            down = 1.0 / sqrt(maximum(square_of(self.D) + square_of(self.E), NOTHING))
            self.D, self.E = scaled(self.D, down), scaled(self.E, down)
            down2 = down * down
            shrunk, shrunk2 = product(shrunk, down), product(shrunk2, down2)
            self.lost[-1:] = [power * down2 for power in self.lost[-1:]]
        self.shrunk, self.shrunk2 = product(self.shrunk, shrunk), product(self.shrunk2, shrunk2)
        self._steps.append(shrunk2)

    def arrived(self, quiet: bool) -> Passage:
        """What came out at the front."""
        lost: list[Number] = []
        since: Number = 1.0
        for power, shrunk2 in zip(reversed(self.lost), reversed(self._steps), strict=False):
            lost.append(power * since)
            since = since * shrunk2
        D2, flux = square_of(self.D), product(self.flux, self.shrunk2)
        passed = 4.0 * self.y[0] * flux
        if quiet:
            # |2 y_0 E - D|^2 = |D|^2 + 4 y_0 Re(E* H), and the power is what it was at the back.
            S: Pair = 0.0, 0.0
            S2 = D2 + passed
        else:
            S = minus(scaled(times(self.y, self.E), 2.0), self.D)
            S2 = square_of(S)
        shrunk = self.shrunk, self.shrunk2
        squares = D2, S2, quiet
        return Passage(
            self.D, self.E, S, *squares, self.start, *shrunk, flux, passed, self.y, tuple(lost)
        )


def _contrast(front: Medium, other: Medium) -> Pair:
    """N^2 - N_0^2 as a product."""
    total = other.excess[0] + front.excess[0] + 2.0, other.excess[1]
    return times(minus(other.excess, front.excess), plus(total, (0.0, front.excess[1])))


def _either(condition: Condition, yes: Pair, no: Pair) -> Pair:
    """Choose value by value."""
    parts = [np.broadcast_arrays(*each) for each in zip(yes, no, strict=True)]
    real, imaginary = (select(condition, first, second) for first, second in parts)
    return real, imaginary


def _lost(
    layer: Medium, phase: Number, turn: _Turn, s2: Number, tracks: Sequence[_Track]
) -> tuple[Number, Number]:
    r"""Power that enters a layer at its front less what leaves it at its back.

    Written out, every term has the factor Im q or Im y, so that faint absorption keeps its digits:

    .. math::
        \tfrac12 (\Re y\, \mathrm{sh} + \Im y\, \mathrm{sn}) |E|^2
        + \tfrac12 (\Re y\, \mathrm{sh} - \Im y\, \mathrm{sn}) \frac{|H|^2}{|y|^2}
        + 2 \sinh^2(\Im\delta)\, \Re(E H^*)
        + 2 |\sin\delta|^2 \frac{\Im y}{|y|^2} \Im(y^* H E^*)

    with sh = sinh(2 Im delta) and sn = sin(2 Re delta), of which, with q = a + i b, the sums
    a sh + b sn and a sh - b sn are positive.
    """
    a, b = maximum(layer.q[0], _SMALLEST_Q), layer.q[1]
    abs2 = maximum(a * a + b * b, NOTHING)
    x, z = 2.0 * phase * a, 2.0 * phase * b
    shrunk2 = 1.0 + turn.fall
    sinh = -0.5 * np.expm1(-2.0 * z)
    # a 2 Im delta = b 2 Re delta: the difference loses nothing but what these have in common.
    less = a * _sinh_less(z, sinh, shrunk2) + b * shrunk2 * _less_sin(x)
    more = a * sinh + b * shrunk2 * np.sin(x)
    sinh2, S2 = 0.5 * turn.fall * turn.fall, 2.0 * square_of(turn.S)
    fourth = square_of(layer.square)
    of_s = (0.5 * more, 0.5 * less / abs2, S2 * b, layer.q)
    of_p = (
        0.5 * (s2 * more + abs2 * less) / fourth,
        0.5 * (s2 * less + abs2 * more) / abs2,
        S2 * b * (s2 - abs2),
        over(layer.q, layer.square),
    )
    lost = []
    for track, (of_E, of_H, of_cross, y) in zip(tracks, (of_s, of_p), strict=True):
        E, H = track.E, track.H
        cross = times(E, conjugate(H))
        turned = times(conjugate(y), conjugate(cross))
        lost.append(
            of_E * square_of(E) + of_H * square_of(H) + sinh2 * cross[0] + of_cross * turned[1]
        )
    return lost[0], lost[1]


def _sinh_less(z: Number, sinh: Number, shrunk2: Number) -> Number:
    """(sinh z - z) exp(-z), given sinh(z) exp(-z) and exp(-z)."""
    small = np.minimum(z, 1.0)
    return np.where(z < 1.0, shrunk2 * _cubic(small, small * small), sinh - z * shrunk2)


def _less_sin(x: Number) -> Number:
    """x - sin x."""
    small = np.minimum(x, 1.0)
    return np.where(x < 1.0, _cubic(small, -small * small), x - np.sin(x))


def _cubic(z: Number, z2: Number) -> Number:
    """z^3/3! + z^3 z2/5! + z^3 z2^2/7! + ..., for z <= 1."""
    total: Number = 1.0
    for even in (14.0, 12.0, 10.0, 8.0, 6.0, 4.0):
        total = 1.0 + total * z2 / (even * (even + 1.0))
    return z * z * z * total / 6.0
