"""A material to guess: its curve, and of what would give it away no more than was asked for."""

from __future__ import annotations

import re

from app.answers.answer import Values, answer
from app.answers.curves import sampled_incidence
from app.answers.interface import InterfaceFacts
from app.optics.amplitudes import power
from app.optics.errors import NotAllowed
from app.optics.interface import Interface, Kind

CLUES = 4
"""How many there are."""

_SAMPLES = 181

# As in static/js/theory/mystery-code.js, which writes the codes: thousandths of n and k, as one
# number, times a factor modulo a prime.
_PRIME, _FACTOR, _STEPS = 2**31 - 1, 48271, 1000
_LEAST_N, _MOST_N, _MOST_K = 0.01, 10, 20
_ROOM = _MOST_K * _STEPS + 1


@answer
class Mystery:
    """What may be known of a material that is to be guessed, in air."""

    code: str
    theta_i_deg: Values
    R: Values
    Rs: Values | None
    """The first clue, with Rp."""
    Rp: Values | None
    F0: float | None
    """The second."""
    kind: Kind | None
    """The third."""
    pseudo_brewster_deg: float | None
    """The fourth: angle of least Rp."""


def mystery(code: str, clues: int = 0) -> Mystery:
    """Answer the curve of a material to guess, with its first clues.

    Raises
    ------
    NotAllowed
        If no material has such a code.
    """
    interface = Interface(1.0, *decoded(code))
    incidence = sampled_incidence(interface, _SAMPLES, landmarks=False)
    energy, facts = power(interface, incidence), InterfaceFacts.of(interface)
    return Mystery(
        code=code,
        theta_i_deg=incidence.theta_i_deg,
        R=energy.R,
        Rs=energy.Rs if clues >= 1 else None,
        Rp=energy.Rp if clues >= 1 else None,
        F0=facts.F0 if clues >= 2 else None,
        kind=facts.kind if clues >= 3 else None,
        pseudo_brewster_deg=facts.pseudo_brewster_deg if clues >= CLUES else None,
    )


def decoded(code: str) -> tuple[float, float]:
    """Read n and k from a code.

    Raises
    ------
    NotAllowed
        If it is none.
    """
    number = int(code, 36) if re.fullmatch("[1-9a-z][0-9a-z]{0,5}", code) else _PRIME
    packed = number * pow(_FACTOR, -1, _PRIME) % _PRIME
    n, k = (thousandths / _STEPS for thousandths in divmod(packed, _ROOM))
    if number >= _PRIME or not _LEAST_N <= n <= _MOST_N:
        raise NotAllowed("code", code, "the code of a mystery material, as a link to it says it")
    return n, k
