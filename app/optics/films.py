r"""What films between two media reflect, transmit and absorb.

Coherent layers are those of `app.optics.transfer`. A layer marked as incoherent adds the powers of the
waves that go to and fro in it. That is the mean over the phase of one passage: of the series

.. math::
    r = r_{01} + t_{01} r_{12} t_{10} e^{2 i \delta} \sum_m (r_{10} r_{12} e^{2 i \delta})^m

no two terms have the same phase, so the mean of its square is the sum of the squares, whatever the
layers in front of and behind it do, and whether the thick one absorbs or not.

Convention: time factor exp(-i w t), k >= 0, r_p = -r_s at normal incidence.

References
----------
.. [1] M. Born and E. Wolf, Principles of Optics, 7th ed., section 1.6.
.. [2] S. J. Byrnes, Multilayer optical calculations, arXiv:1603.02720, sections 5 and 6.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from app.optics.amplitudes import Amplitudes, Complex, Power
from app.optics.amplitudes import amplitudes as boundary_amplitudes
from app.optics.amplitudes import power as boundary_power
from app.optics.errors import NotAllowed
from app.optics.incidence import Incidence
from app.optics.numerics.blocks import in_blocks
from app.optics.numerics.choice import anywhere, maximum, select
from app.optics.numerics.pairs import (
    Pair,
    conjugate,
    is_zero,
    scaled,
    square_of,
    times,
)
from app.optics.parameters import Array, Number
from app.optics.stack import Sheet, Sheets, Stack
from app.optics.transfer import (
    NOTHING,
    Group,
    Medium,
    Passage,
    incident_medium,
    medium,
    passages,
)

NORMAL_ALONE = (
    "0 where the incident medium absorbs: at any other angle the incident wave is not uniform along "
    "the surface, so that no reflectance of the surface is defined"
)
NO_AMPLITUDES = "coherent: without interference a layer has powers, but no amplitudes and no phases"

VALUES = 12288
"""Values of a piece, so that the arrays in use stay in the cache and below the answer in size."""


_SMALLEST_Y = 1e-150
_MOST_FADING, _LEAST_LEAK = 0.1, 1e-15


@dataclass(frozen=True, slots=True, eq=False)
class Absorption:
    """Power that is absorbed, as a part of the incident power."""

    s: tuple[Array, ...]
    p: tuple[Array, ...]
    """In each layer, from the incident side, by polarization."""

    @property
    def layers(self) -> tuple[Array, ...]:
        """In each layer, of unpolarized light."""
        return tuple(np.asarray(0.5 * (s + p)) for s, p in zip(self.s, self.p, strict=True))

    @property
    def As(self) -> Array:
        """In all layers, of s polarized light."""
        return np.asarray(sum(self.s, np.zeros(())))

    @property
    def Ap(self) -> Array:
        """In all layers, of p polarized light."""
        return np.asarray(sum(self.p, np.zeros(())))

    @property
    def A(self) -> Array:
        """In all layers, of unpolarized light."""
        return np.asarray(0.5 * (self.As + self.Ap))


def power(stack: Stack, incidence: Incidence) -> Power:
    """Reflected and transmitted power for s and p polarization.

    Parameters
    ----------
    stack, incidence
        The films and the directions; they broadcast against each other.

    Returns
    -------
    Power
        Arrays of the broadcast shape. T is what passes the last boundary, so that R + T + A = 1
        with the A of `absorption`, but where the incident medium absorbs.

    Raises
    ------
    NotAllowed
        If the incident medium absorbs and the light does not come along the normal.
    """
    _refuse_oblique(stack, incidence)
    if _is_boundary(stack):
        return boundary_power(stack.substrate, incidence)
    return Power(*in_blocks(_powers, stack.sheets, incidence, size=VALUES))


def reflectances(stack: Stack, incidence: Incidence) -> tuple[Array, Array]:
    """Rs and Rp, the very ones of `power`, without the work for the rest."""
    _refuse_oblique(stack, incidence)
    if _is_boundary(stack):
        energy = boundary_power(stack.substrate, incidence)
        return energy.Rs, energy.Rp
    Rs, Rp = in_blocks(_reflectances, stack.sheets, incidence, size=VALUES)
    return Rs, Rp


def absorption(stack: Stack, incidence: Incidence) -> Absorption:
    """Power absorbed in each layer; parameters and errors as of `power`.

    It is not a difference of other powers, so a layer that absorbs a billionth keeps its digits.
    """
    _refuse_oblique(stack, incidence)
    found = in_blocks(_absorbed, stack.sheets, incidence, size=VALUES)
    count = len(stack.layers)
    return Absorption(tuple(found[:count]), tuple(found[count:]))


def amplitudes(stack: Stack, incidence: Incidence) -> Amplitudes:
    """Complex amplitude coefficients r_s, r_p, t_s, t_p; parameters as of `power`.

    They refer to the electric field, r at the first boundary and t at the last.

    Raises
    ------
    NotAllowed
        If a layer is incoherent, or the incident medium absorbs and the light does not come along
        the normal.
    """
    _refuse_oblique(stack, incidence)
    if not stack.is_coherent:
        raise NotAllowed("layers", "an incoherent layer", NO_AMPLITUDES)
    if _is_boundary(stack):
        return boundary_amplitudes(stack.substrate, incidence)
    return Amplitudes(*in_blocks(_amplitudes, stack.sheets, incidence, size=VALUES))


def _is_boundary(stack: Stack) -> bool:
    return not stack.layers and not stack.k_i.any()


def _refuse_oblique(stack: Stack, incidence: Incidence) -> None:
    if stack.k_i.any():
        oblique = (stack.k_i > 0.0) & (incidence.sin > 0.0)
        if oblique.any():
            degrees = np.broadcast_to(incidence.theta_i_deg, oblique.shape)[oblique]
            raise NotAllowed("theta_i_deg", float(degrees.flat[0]), NORMAL_ALONE)


def whole_group(sheets: Sheets, incidence: Incidence) -> Group:
    """All layers between the two media, none of which is incoherent."""
    kappa_i = sheets.kappa_i
    front = incident_medium(incidence, float(kappa_i) if kappa_i.ndim == 0 else kappa_i)
    back = medium(sheets.substrate, incidence)
    known = None if anywhere(kappa_i > 0.0) else sheets.substrate
    return Group(front, sheets.between, back, known)


def _powers(sheets: Sheets, incidence: Incidence) -> tuple[Array, ...]:
    if any(sheet.incoherent for sheet in sheets.between):
        s, p = _incoherent(sheets, incidence, losses=False)
        Rs, Rp, Ts, Tp = s.R, p.R, s.T, p.T
    else:
        group = whole_group(sheets, incidence)
        (Rs, Ts), (Rp, Tp) = (_parts(each, incidence) for each in passages(group, incidence))
    return tuple(np.asarray(part) for part in (0.5 * (Rs + Rp), Rs, Rp, Ts, Tp))


def _reflectances(sheets: Sheets, incidence: Incidence) -> tuple[Array, ...]:
    if any(sheet.incoherent for sheet in sheets.between):
        return tuple(np.asarray(each.R) for each in _incoherent(sheets, incidence, losses=False))
    found = passages(whole_group(sheets, incidence), incidence)
    return tuple(np.asarray(_reflected(each, _incident(each, incidence))) for each in found)


def _parts(passage: Passage, incidence: Incidence) -> tuple[Number, Number]:
    """R and T of coherent layers."""
    incident = _incident(passage, incidence)
    T = passage.passed / incident
    if not is_zero(passage.y[1]):
        T = T * (square_of(passage.y) / (passage.y[0] * passage.y[0]))
    elif not passage.summed:
        T = _below_1(T)
    none = incident == NOTHING if incident is not passage.S2 else False
    return _reflected(passage, incident), select(none, 1.0, T) if anywhere(none) else T


def _incident(passage: Passage, incidence: Incidence) -> Number:
    """S2, but for a grazing ray that meets no boundary, which would be 0/0."""
    grazes = anywhere(incidence.numbers[0] == 0.0)
    return maximum(passage.S2, NOTHING) if grazes else passage.S2


def _reflected(passage: Passage, incident: Number) -> Number:
    R = passage.D2 / incident
    # A part may round above 1 but where it is taken of a sum.
    return R if passage.summed or not is_zero(passage.y[1]) else _below_1(R)


def _below_1(part: Number) -> Number:
    return min(part, 1.0) if isinstance(part, float) else np.minimum(part, 1.0)


def _entry(passage: Passage) -> Number:
    """4 |y_0|^2 / Re y_0: from the square of a field over that of S to a part of the incident power."""
    y = passage.y
    return 4.0 * (y[0] if is_zero(y[1]) else square_of(y) / y[0])


def _absorbed(sheets: Sheets, incidence: Incidence) -> tuple[Array, ...]:
    if any(sheet.incoherent for sheet in sheets.between):
        found = _incoherent(sheets, incidence, losses=True)
        return tuple(np.asarray(A) for each in found for A in each.A)
    group = whole_group(sheets, incidence)
    return tuple(
        np.asarray(_entry(passage) * power / maximum(passage.S2, NOTHING))
        for passage in passages(group, incidence, losses=True)
        for power in passage.lost
    )


def _amplitudes(sheets: Sheets, incidence: Incidence) -> tuple[Complex, ...]:
    group = whole_group(sheets, incidence)
    found: list[Complex] = []
    for passage in passages(group, incidence, fields=True):
        back = scaled(conjugate(passage.S), 1.0 / maximum(passage.S2, NOTHING))
        r = _at_grazing(_complex(times(passage.D, back)), passage, incidence)
        entry = scaled(times(passage.y, passage.start), 2.0 * passage.shrunk)
        t = _complex(times(entry, back))
        # A grazing ray that meets no boundary goes on.
        found += [r, np.where(passage.S2 == 0.0, 1.0, t)]
    r_s, t_s, r_p, t_p = found
    # Along the normal both are the same wave, to the last bit of a phase of 180 degrees.
    r_p = np.where(incidence.sin == 0.0, -r_s, r_p)
    eta, kappa, _ = sheets.substrate.relative
    N_t = np.asarray(eta) + 1j * np.asarray(kappa)
    return r_s, r_p, t_s, t_p * (1.0 + 1j * sheets.kappa_i) / N_t


def _at_grazing(r: Complex, passage: Passage, incidence: Incidence) -> Complex:
    """Set -1 at 90 degrees; the sign of its imaginary zero is that of the limit, -1 - 2 y_0 E / D."""
    grazing = (incidence.cos == 0.0) & (np.asarray(passage.D2) > 0.0)
    if not grazing.any():
        return r
    kept = np.where(grazing, -1.0 + 0.0j, r)
    below = times(passage.E, conjugate(passage.D))[1] > 0.0
    kept.imag = np.where(grazing & below, -0.0, kept.imag)
    return np.asarray(kept)


def _complex(pair: Pair) -> Complex:
    return np.asarray(np.asarray(pair[0]) + 1j * np.asarray(pair[1]))


class _Powers(NamedTuple):
    """Of one polarization."""

    R: Number
    T: Number
    A: tuple[Number, ...]


class _Face(NamedTuple):
    """A group between two thick layers: squares of amplitudes, and powers that it absorbs.

    They are those of a wave whose amplitude in front is 1, and powers are parts of the incident power.
    """

    r2: Number
    r_im: Number
    """Imaginary part of the amplitude of reflection, where the wave in front fades."""
    t2: Number
    flux: Number
    """Power that it transmits."""
    lost: tuple[Number, ...]

    @classmethod
    def of(cls, passage: Passage, y: Number) -> _Face:
        """Describe a group from one side; y is the admittance of the incident medium."""
        S2 = maximum(passage.S2, NOTHING)
        weight = 4.0 * square_of(passage.y) / S2
        r_im: Number = 0.0
        if not is_zero(passage.y[1]):
            r_im = times(passage.D, conjugate(passage.S))[1] / S2
        t2 = weight * square_of(passage.start) * passage.shrunk2
        flux = weight * passage.flux / y
        # A grazing ray that meets no boundary goes on: 0/0 else.
        none = S2 == NOTHING
        if anywhere(none):
            t2, flux = select(none, 1.0, t2), select(none, 1.0, flux)
        return cls(
            passage.D2 / S2,
            r_im,
            t2,
            flux,
            tuple(weight * power / y for power in passage.lost),
        )


def _incoherent(sheets: Sheets, incidence: Incidence, *, losses: bool) -> list[_Powers]:
    """Powers where some layers are incoherent, in s and in p polarization."""
    whole = whole_group(sheets, incidence)
    between = sheets.between
    thick = [place for place, sheet in enumerate(between) if sheet.incoherent]
    media = [whole.front]
    media += [medium(between[place].medium, incidence) for place in thick]
    media += [whole.back]
    ends = [-1, *thick, len(between)]
    groups = [
        Group(front, between[first + 1 : last], back, None)
        for front, back, first, last in zip(media, media[1:], ends, ends[1:], strict=False)
    ]
    fading = [_Fading.of(media[1 + i], between[place]) for i, place in enumerate(thick)]
    onward = [passages(group, incidence, losses=losses) for group in groups]
    backward = [passages(_reversed(group), incidence, losses=losses) for group in groups[:-1]]
    found = []
    for polarization in (0, 1):
        y = onward[0][polarization].y[0]
        y = maximum(y, _SMALLEST_Y)
        faces = [_Face.of(each[polarization], y) for each in onward]
        backs = [_Face.of(each[polarization], y) for each in backward]
        admittances = [scaled(each[polarization].y, 1.0 / y) for each in onward[1:]]
        found.append(_to_and_fro(faces, backs, admittances, fading, thick, len(between)))
    return found


class _Fading(NamedTuple):
    """What becomes of a wave's power in one passage of a thick layer."""

    stays: Number
    goes: Number
    """1 - stays, with the digits that the difference would lose."""

    @classmethod
    def of(cls, layer: Medium, sheet: Sheet) -> _Fading:
        """Describe a layer.

        Beyond its critical angle nothing stays: there the wave has no phase to be averaged, and a
        layer that is thick lets nothing through.
        """
        a, b = layer.q
        depth = 2.0 * b * sheet.phase
        stays, goes = np.exp(-depth), -np.expm1(-depth)
        stands = b > _MOST_FADING * a
        if anywhere(stands):
            stays, goes = np.where(stands, 0.0, stays), np.where(stands, 1.0, goes)
        return cls(stays, goes)


def _reversed(group: Group) -> Group:
    return Group(group.back, group.sheets[::-1], group.front, None)


def _to_and_fro(
    faces: Sequence[_Face],
    backs: Sequence[_Face],
    admittances: Sequence[Pair],
    fading: Sequence[_Fading],
    thick: Sequence[int],
    count: int,
) -> _Powers:
    """Add up the powers of the waves that go to and fro in thick layers.

    Parameters
    ----------
    faces, backs
        The groups, as the incident wave meets them and, but for the last, as one from behind does.
    admittances
        Of the thick layers, over that of the incident medium.
    fading
        What becomes of a wave in one passage of each thick layer.
    thick
        Their places among `count` layers.
    """
    # From the back: what all that lies beyond the first face of each thick layer sends back.
    beyond = [faces[-1].r2]
    rounds: list[Number] = []
    for face, back, once in zip(faces[-2::-1], backs[::-1], fading[::-1], strict=True):
        there_and_back = once.stays * once.stays * beyond[0]
        # Where as good as nothing leaks out nothing gets in either, and of 1 - 1 rounding is left.
        rounds.insert(0, 1.0 / maximum(1.0 - back.r2 * there_and_back, _LEAST_LEAK))
        beyond.insert(0, face.r2 + face.t2 * back.t2 * there_and_back * rounds[0])
    # From the front: the waves in each thick layer, at its first face and arriving at its second.
    A: dict[int, Number] = {}
    comes: Number = 1.0
    after = 0
    for face, back, further, y, once, place, returns, again in zip(
        faces, backs, faces[1:], admittances, fading, thick, beyond[1:], rounds, strict=False
    ):
        starts = comes * face.t2 * again
        arrives = starts * once.stays
        from_behind = arrives * once.stays * returns
        lost = zip(face.lost, reversed(back.lost), strict=True)
        for inner, (there, here) in enumerate(lost, start=after):
            A[inner] = comes * there + from_behind * here
        A[place] = y[0] * once.goes * (starts + arrives * returns)
        if not is_zero(y[1]):
            # At a face a wave does interfere with its reflection, which is in no other mean.
            A[place] -= 2.0 * y[1] * (arrives * further.r_im + from_behind * back.r_im)
        comes, after = arrives, place + 1
    for inner, power in enumerate(faces[-1].lost, start=after):
        A[inner] = comes * power
    R, T = beyond[0], comes * faces[-1].flux
    return _Powers(R, T, tuple(A[i] for i in range(count) if i in A))
