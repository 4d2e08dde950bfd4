"""Films between the media: the stack that an answer was computed for."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

from app.answers.answer import answer
from app.answers.interface import REST, PresetInterface, ResolvedPreset
from app.materials.films import Film, layer_of, read_layers, resolve_film
from app.materials.media import Resolved
from app.optics import films
from app.optics.amplitudes import Amplitudes, Power
from app.optics.ellipsometry import CORE, Convention
from app.optics.errors import NotAllowed
from app.optics.incidence import Incidence
from app.optics.stack import D_LINE_NM, Stack

_REST_OF_FILMS = (
    "angles from the surface normal; T is the power that enters the second medium, A what the layers "
    "absorb, R + T + A = 1"
)
_REST_OF_EITHER = (
    "angles from the surface normal; T is the power that enters the second medium, A what layers "
    "absorb, R + T + A = 1, and T = 1 - R without layers"
)
CONVENTION_OF_ROWS = f"{CORE.text}; {_REST_OF_EITHER}"
"""Where some have layers and some have none."""

_REST_OF_ABSORBING = (
    "the incident medium is n_i + i k_i in exp(-i w t); R and T are parts of the power that the "
    "incident wave would carry without the reflected one, and R + T + A is not 1, since the two "
    "interfere"
)


def convention_text(
    convention: Convention = CORE, *, layers: bool = False, k_i: float = 0.0
) -> str:
    """The convention of an answer in words."""
    rest = _REST_OF_ABSORBING if k_i > 0.0 else _REST_OF_FILMS if layers else REST
    return f"{convention.text}; {rest}"


@answer
class LayerFacts:
    """A layer that an answer was computed with."""

    medium: str
    """As it was asked for: a preset or an index."""
    n: float
    k: float
    """n + i k; k however small counts, and is 0 where the source does not give it."""
    thickness_nm: float
    incoherent: bool
    """Whether the waves that are reflected at its two faces add as powers."""
    material: ResolvedPreset | None
    """The preset that n and k come from; null if they were given as numbers."""

    @classmethod
    def of(cls, film: Film, index: complex, resolved: Resolved | None) -> LayerFacts:
        """Describe a layer."""
        return cls(
            medium=film.medium,
            n=index.real,
            k=index.imag,
            thickness_nm=film.thickness_nm or 0.0,
            incoherent=film.incoherent,
            material=ResolvedPreset.of(resolved),
        )


@dataclass(frozen=True, slots=True)
class Coated:
    """A boundary with films on it, at one wavelength."""

    interface: PresetInterface
    """The boundary that there would be without them."""
    layers: list[LayerFacts]
    wavelength_nm: float
    stack: Stack

    @classmethod
    def of(
        cls,
        interface: PresetInterface,
        layers: str | None,
        wavelength_nm: float | None,
        k_i: float = 0.0,
    ) -> Coated:
        """Put layers on a boundary.

        Parameters
        ----------
        interface
            The boundary.
        layers
            As `app.materials.films.SPELLING` says; None for none.
        wavelength_nm
            Where phases and materials are evaluated, 587.6 nm unless given; the materials then at
            their own reference wavelength.

        Raises
        ------
        OpticsError
            If the layers cannot be read, or are not known at the wavelength.
        """
        asked = () if layers is None else read_layers(layers)
        resolved = [(film, *resolve_film(film, wavelength_nm)) for film in asked]
        at = D_LINE_NM if wavelength_nm is None else wavelength_nm
        made = [
            layer_of(film, index.real, index.imag, film.thickness_nm or 0.0)
            for film, index, _ in resolved
        ]
        n_i, n_t, k_t = (float(part) for part in interface.indices)
        stack = Stack(n_i, made, n_t, k_t, wavelength_nm=at, k_i=k_i)
        return cls(interface, [LayerFacts.of(*each) for each in resolved], at, stack)


class Response(NamedTuple):
    """What a stack does to light at some directions."""

    power: Power
    amplitudes: Amplitudes | None
    """None where a layer is incoherent."""
    absorption: films.Absorption


def response(stack: Stack, incidence: Incidence) -> Response:
    """Evaluate all that is known of a stack."""
    coherent = films.amplitudes(stack, incidence) if stack.is_coherent else None
    return Response(films.power(stack, incidence), coherent, films.absorption(stack, incidence))


def exact_alone(models: Sequence[str], parameter: str = "models") -> None:
    """Refuse models that know no films.

    Raises
    ------
    NotAllowed
        If there is one.
    """
    for model in models:
        if model != "exact":
            raise NotAllowed(parameter, model, "exact where there are layers, which no other knows")
