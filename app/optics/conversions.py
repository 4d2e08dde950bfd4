"""One interface in the words of optics, of artists and of engines, and what is lost in between.

Each result carries a status. `exact`: the same information, converting back returns what was given.
`dielectric only`: a right value if the second medium does not absorb and is denser than the one in
front, which F0 alone does not tell; of a metal it is wrong. `lossy`: a right value from which what was
given cannot be got back. `infeasible`: there is no such value, or what was given does not determine it.
The engines' specular and reflectance are words for dielectrics, which they determine.

All F0 are linear and seen from the incident medium n_i unless a name says otherwise.

References
----------
.. [1] O. Gulbrandsen, Artist Friendly Metallic Fresnel, Journal of Computer Graphics Techniques
   3(4), 64-72 (2014).
.. [2] E. d'Eon, Fresnel Boundaries, notebook to A Hitchhiker's Guide to Multiple Scattering (2019).
.. [3] B. Burley, Physically Based Shading at Disney, SIGGRAPH 2012 course notes: F0 = 0.08 specular.
.. [4] R. Guy and M. Agopian, Physically Based Rendering in Filament: F0 = 0.16 reflectance^2.
.. [5] S. Lagarde, Memo on Fresnel equations (2013): F0 is another under water.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Literal

import numpy as np

from app.optics.color import decode_srgb, encode_srgb
from app.optics.edge_tint import (
    EDGE_TINT,
    REFLECTANCE,
    TINT_ANGLE,
    deon_G,
    deon_index,
    eta_max,
    gulbrandsen_g,
    gulbrandsen_index,
    relative_interface,
)
from app.optics.errors import NotAllowed
from app.optics.interface import Interface, normal_reflectance
from app.optics.knobs.knob import Knob, KnobId, Seen, Setting, Status
from app.optics.knobs.reflectance import KNOBS, LARGEST_ETA, REFLECTANCE_F0, SPECULAR_F0
from app.optics.parameters import K_T, N_I, N_T, Array, Parameter, share
from app.optics.specular import F82, tint_at_82

Form = Literal[
    "ior",
    "f0",
    "f0_srgb",
    "nk",
    "rg",
    "dg",
    KnobId,
]
Value = float | str | None

_LARGEST_CLEAR_INDEX = 6.4  # tellurium's in the infrared: nothing that is transparent has more


F0_LINEAR = share("F0", "F_0", "Reflectance at normal incidence, linear.", triple=True)
F0_SRGB = share("F0_srgb", r"F_0^\text{sRGB}", "F0 as an sRGB value, 0 to 1.", triple=True)
SEEN_FROM = Parameter(
    "seen_from",
    "n_i'",
    1.333,
    N_I.minimum,
    N_I.maximum,
    "",
    "Index of another medium in front, from which the same material is looked at; water by default.",
)

TAKES: dict[Form, tuple[Parameter, ...]] = {
    "ior": (N_T,),
    "nk": (N_T, K_T),
    "f0": (F0_LINEAR,),
    "f0_srgb": (F0_SRGB,),
    "rg": (REFLECTANCE, EDGE_TINT),
    "dg": (REFLECTANCE, TINT_ANGLE),
    **{knob.id: tuple(given.parameter for given in knob.inputs) for knob in KNOBS},
}
"""What each form takes besides n_i."""

TITLES = {
    "ior": "Index of refraction",
    "nk": "Complex index",
    "f0": "F0, linear",
    "f0_srgb": "F0, sRGB",
    "f0_hex": "F0, 8-bit sRGB",
    "specular": "Specular level",
    "reflectance": "Filament reflectance",
    "rg": "Gulbrandsen's r, g",
    "dg": "d'Eon's r, G",
    "f82": "F0 and F82",
    "f82_tint": "F0 and F82-tint",
    "f0_seen_from": "F0 from another medium",
}


@dataclass(frozen=True, slots=True)
class Conversion:
    """One form of what was given."""

    form: str
    """Key of `TITLES`."""
    values: Mapping[str, Value]
    """Its numbers by name; None for those that do not exist."""
    status: Status
    why: str
    """See the module; `why` is a sentence for people."""

    @property
    def title(self) -> str:
        """Name for people."""
        return TITLES[self.form]


@dataclass(frozen=True, slots=True)
class Known:
    """What a form says of the interface."""

    n_i: float
    """Index of the medium in front."""
    F0: float
    """Reflectance at normal incidence."""
    eta: float | None = None
    kappa: float | None = None
    """Relative index; None where F0 is all that is known."""
    is_dielectric: bool = False
    """Whether the form is a word for dielectrics alone."""
    lost: str = ""
    """What an engine's knob says besides, which no other form has."""

    @property
    def has_index(self) -> bool:
        """Whether more than F0 is known."""
        return self.eta is not None

    @property
    def absorbs(self) -> bool:
        """Whether the second medium is known to absorb."""
        return self.kappa is not None and self.kappa > 0.0

    @property
    def dielectric_eta(self) -> float:
        """Relative index of the denser dielectric of that F0; infinite at F0 = 1."""
        return math.inf if self.F0 >= 1.0 else float(eta_max(np.asarray(self.F0)))

    @property
    def index(self) -> tuple[float, float]:
        """Relative index, that of the denser dielectric where F0 is all that is known."""
        if self.eta is None or self.kappa is None:
            return self.dielectric_eta, 0.0
        return self.eta, self.kappa

    @property
    def seen(self) -> Seen:
        """The same for the knobs of engines, to which a metal is the dielectric of its F0."""
        eta = self.dielectric_eta if self.absorbs else self.index[0]
        return Seen(self.F0, eta, self.has_index, self.absorbs, self.is_dielectric, self.lost)

    def interface(self) -> Interface:
        """The boundary with the relative index, at some n_i that keeps the indices in bounds."""
        eta, kappa = self.index
        return relative_interface(np.asarray(eta), np.asarray(kappa))


def know(form: Form, n_i: float = 1.0, **values: float) -> Known:
    """Read a form.

    Parameters
    ----------
    form
        Which words.
    n_i
        Index of the medium in front.
    values
        One number for every parameter of `TAKES[form]`.

    Raises
    ------
    NotAllowed
        If the values are not those that the form takes.
    OutOfRange
        If one is out of its bounds.

    Examples
    --------
    >>> round(know("specular", specular=0.5).dielectric_eta, 6)
    1.5
    """
    names = [parameter.name for parameter in TAKES[form]]
    if sorted(values) != sorted(names):
        raise NotAllowed("from", form, f"with {' and '.join(names)}, and nothing else")
    front = float(N_I.check(n_i))
    numbers = [parameter.check(values[parameter.name]) for parameter in TAKES[form]]
    return _READERS[form](front, *numbers)


def _of_index(n_i: float, n_t: Array, k_t: Array) -> Known:
    interface = Interface(n_i, n_t, k_t)
    return Known(n_i, float(interface.F0), float(interface.eta), float(interface.kappa))


def _of_tint(n_i: float, r: Array, index: tuple[Array, Array]) -> Known:
    return Known(n_i, float(r), float(index[0]), float(index[1]))


def _of_knob(knob: Knob, n_i: float, *values: Array) -> Known:
    read = knob.read(*map(float, values))
    kappa = None if read.eta is None else 0.0
    return Known(n_i, read.F0, read.eta, kappa, read.eta is None, read.lost)


_READERS: dict[Form, Callable[..., Known]] = {
    "ior": lambda n_i, n_t: _of_index(n_i, n_t, np.zeros(())),
    "nk": _of_index,
    "f0": lambda n_i, F0: Known(n_i, float(F0)),
    "f0_srgb": lambda n_i, F0_srgb: Known(n_i, float(decode_srgb(F0_srgb))),
    "rg": lambda n_i, r, g: _of_tint(n_i, r, gulbrandsen_index(r, g)),
    "dg": lambda n_i, r, G: _of_tint(n_i, r, deon_index(r, G)),
    **{knob.id: partial(_of_knob, knob) for knob in KNOBS},
}


def hex_channels(code: str) -> tuple[float, float, float]:
    """The sRGB values, 0 to 1, of a color written as `#rrggbb`; the hash may be left out.

    Raises
    ------
    NotAllowed
        If it is not six hexadecimal digits.

    Examples
    --------
    >>> hex_channels("#ff8000")[0]
    1.0
    """
    digits = code.removeprefix("#")
    if len(digits) != 6 or not set(digits.lower()) <= set("0123456789abcdef"):
        raise NotAllowed("hex", code, "six hexadecimal digits, as #c8a050")
    red, green, blue = (int(digits[i : i + 2], 16) / 255.0 for i in (0, 2, 4))
    return red, green, blue


def convert(known: Known, seen_from: float = 1.333) -> list[Conversion]:
    """Every form of what is known, in the order of `TITLES`.

    Raises
    ------
    OutOfRange
        If `seen_from` is out of its bounds.
    """
    other = float(SEEN_FROM.check(seen_from))
    found = [
        _ior(known),
        _nk(known),
        *_f0(known),
        _scaled(known, "specular", known.F0 / SPECULAR_F0, SPECULAR_F0),
        _scaled(known, "reflectance", math.sqrt(known.F0 / REFLECTANCE_F0), REFLECTANCE_F0),
        _rg(known),
        _dg(known),
        *_f82(known),
        _seen_from(known, other),
    ]
    if not known.lost:
        return found
    return [
        replace(one, status="lossy", why=known.lost)
        if one.status in ("exact", "dielectric only")
        else one
        for one in found
    ]


def settings(channels: Sequence[Known]) -> list[tuple[Knob, Setting]]:
    """Say what to type into every engine's knob for an interface of one channel or of three."""
    return [(knob, knob.write([known.seen for known in channels])) for knob in KNOBS]


_ONE_OF_MANY = "F0 is one number and n, k are two: every index on a circle has this F0"
_IF_CLEAR = "if the second medium does not absorb and is the denser one"


def _of_F0_alone(known: Known) -> tuple[Status, str]:
    """What is said of a value that holds for the denser dielectric of an F0."""
    if known.is_dielectric:
        return "exact", _IF_CLEAR
    return "dielectric only", _IF_CLEAR + "; of a metal F0 alone does not tell it" + _warning(known)


def _warning(known: Known) -> str:
    """Say where no dielectric has such an F0."""
    n_t = known.dielectric_eta * known.n_i
    if n_t <= _LARGEST_CLEAR_INDEX:
        return ""
    return f"; no medium without absorption has F0 = {known.F0:.4g}: it would need n_t = {n_t:.3g}"


def _reflectance_status(known: Known) -> tuple[Status, str]:
    """Whether F0, and what is made of it alone, can be turned back."""
    if not known.has_index:
        return "exact", "the same number in another scale"
    if known.absorbs:
        return "lossy", "right at normal incidence; n and k cannot be recovered from it"
    if known.index[0] < 1.0:
        return "lossy", "right, but the denser medium of n_i^2 / n_t has the same F0"
    return "exact", "n follows from F0 where nothing absorbs"


def _ior(known: Known) -> Conversion:
    eta = known.dielectric_eta
    if known.has_index and not known.absorbs:
        return Conversion("ior", {"n_t": known.index[0] * known.n_i}, "exact", "as it is")
    if math.isinf(eta):
        return Conversion("ior", {"n_t": None}, "infeasible", "F0 = 1: n_t would be infinite")
    values = {"n_t": eta * known.n_i}
    if known.absorbs:
        why = "a dielectric of the same F0; k is lost, and with it every other angle"
        return Conversion("ior", values, "lossy", why)
    return Conversion("ior", values, *_of_F0_alone(known))


def _nk(known: Known) -> Conversion:
    if not known.has_index:
        return Conversion("nk", {"n_t": None, "k_t": None}, "infeasible", _ONE_OF_MANY)
    eta, kappa = known.index
    values = {"n_t": eta * known.n_i, "k_t": kappa * known.n_i}
    return Conversion("nk", values, "exact", "as it is")


def _f0(known: Known) -> list[Conversion]:
    status, why = _reflectance_status(known)
    encoded = float(encode_srgb(known.F0))
    code = round(255.0 * encoded)
    decoded = float(decode_srgb(code / 255.0))
    rounded = abs(decoded - known.F0) > 1e-12
    in_8_bits = Conversion(
        "f0_hex",
        {"hex": "#" + f"{code:02x}" * 3, "code": float(code), "F0": decoded},
        "lossy" if rounded else status,
        f"rounded to one of 256 codes, {decoded - known.F0:+.1e} off" if rounded else why,
    )
    return [
        Conversion("f0", {"F0": known.F0}, status, why),
        Conversion("f0_srgb", {"F0_srgb": encoded}, status, why),
        in_8_bits,
    ]


def _scaled(known: Known, form: str, value: float, largest: float) -> Conversion:
    if value > 1.0 + 1e-12:
        why = f"F0 = {known.F0:.4g} is above {largest:g}: it would have to be {value:.3g}"
        return Conversion(form, {form: None}, "infeasible", why)
    return Conversion(form, {form: min(value, 1.0)}, *_reflectance_status(known))


def _rg(known: Known) -> Conversion:
    if known.F0 >= 1.0:
        return Conversion("rg", {"r": None, "g": None}, "infeasible", "r = 1 is no index at all")
    if not known.has_index:
        return Conversion("rg", {"r": known.F0, "g": None}, "infeasible", _ONE_OF_MANY)
    eta, kappa = known.index
    g = float(gulbrandsen_g(np.asarray(eta), np.asarray(known.F0)))
    # The edge |N| = 1 is g = 1 but for rounding.
    if g > 1.0 + 1e-9:
        why = f"|N| = {math.hypot(eta, kappa):.4g} n_i < n_i: g would have to be {g:.4g}"
        return Conversion("rg", {"r": known.F0, "g": None}, "infeasible", why)
    return Conversion("rg", {"r": known.F0, "g": min(g, 1.0)}, "exact", "|N| >= n_i")


def _dg(known: Known) -> Conversion:
    if known.F0 >= 1.0:
        return Conversion("dg", {"r": None, "G": None}, "infeasible", "r = 1 is no index at all")
    if not known.has_index:
        return Conversion("dg", {"r": known.F0, "G": None}, "infeasible", _ONE_OF_MANY)
    G = float(deon_G(*(np.asarray(x) for x in (*known.index, known.F0))))
    return Conversion("dg", {"r": known.F0, "G": G}, "exact", "holds for every index")


def _f82(known: Known) -> list[Conversion]:
    eta = known.index[0]
    if eta > LARGEST_ETA:
        why = f"F0 = {known.F0:.6g} alone asks for n_t/n_i = {eta:.3g}, which is a mirror"
        return [
            Conversion("f82", {"F0": known.F0, "F82": None}, "infeasible", why),
            Conversion("f82_tint", {"F0": known.F0, "tint": None}, "infeasible", why),
        ]
    at_82 = float(F82(known.interface()))
    tint = float(tint_at_82(known.F0, at_82))
    status: Status
    if not known.has_index:
        status, why = _of_F0_alone(known)
    elif known.absorbs:
        status, why = "lossy", "right at 0 and 82 degrees; n and k are not recovered from the two"
    else:
        status, why = "exact", "the two tell which side is the denser"
    pair = Conversion("f82", {"F0": known.F0, "F82": at_82}, status, why)
    if tint > 1.0 + 1e-12:
        why += "; R at 82 degrees exceeds Schlick's, and renderers that end at 1 cut the tint"
    return [pair, Conversion("f82_tint", {"F0": known.F0, "tint": tint}, status, why)]


def _seen_from(known: Known, other: float) -> Conversion:
    eta, kappa = known.index
    if math.isinf(eta):
        why = "F0 = 1 says nothing of the index"
        return Conversion("f0_seen_from", {"n_i": other, "F0": None}, "infeasible", why)
    n, k = eta * known.n_i, kappa * known.n_i
    F0 = float(normal_reflectance(other, n, k))
    status, why = _reflectance_status(known)
    if not known.has_index:
        status, why = _of_F0_alone(known)
        status = status if n >= other else "lossy"
    elif status == "exact" and n < other:
        status, why = "lossy", "right, but the denser medium has the same F0 from there"
    return Conversion("f0_seen_from", {"n_i": other, "F0": F0}, status, why)
