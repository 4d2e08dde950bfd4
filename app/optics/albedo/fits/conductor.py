"""Fits of a conductor's albedo; n = eta and k = kappa, so they hold for every incident medium."""

from typing import Any

import numpy as np
from numpy.polynomial.polynomial import polyval, polyval2d

from app.optics.albedo.fit import Claim, Domain, Fit
from app.optics.edge_tint import deon_G, gulbrandsen_g
from app.optics.formulas.formula import Symbol
from app.optics.interface import Interface
from app.optics.parameters import Array

METALS = Domain(eta=(0.1, 4.0), kappa=(1.7, 8.0))
"""The box d'Eon fits metals in."""

_HITCHHIKER = "E. d'Eon, A Hitchhiker's Guide to Multiple Scattering, Fresnel Boundaries, 2019"
_DUNKLE = (
    "R. V. Dunkle 1963; M. N. Ozisik, Radiative Transfer, 1973, p. 60; E. d'Eon, A Hitchhiker's Guide "
    "to Multiple Scattering, 2019"
)
_EXACT_FOR = (
    "Exact for the approximate reflectance of Pharr and Humphreys (model pharr_humphreys), which "
    "is close to Fresnel's where n^2 + k^2 is large."
)
_UNNAMED = (
    "The notebook announces the parallel and then the perpendicular integral; the first expression is "
    "that of s, the second that of p."
)
_POWERS = (Symbol("i", "row, from 0"), Symbol("j", "column, from 0"))


_D_EON = "stated beside the formula, d'Eon 2019"


def _metals(measured: float, at: tuple[float, float], **said: Any) -> Claim:
    return Claim(domain=METALS, measured=measured, at=at, **said)


def _matrix(name: str, coefficients: tuple[tuple[float, ...], ...]) -> str:
    """LaTeX of coefficients, powers of the first variable down and of the second across."""
    rows = "\\\\".join("&".join(map(str, row)) for row in coefficients)
    return rf",\quad ({name})=\begin{{pmatrix}}{rows}\end{{pmatrix}}"


def _angle(k: Array, adjacent: Array) -> Array:
    """arctan(k / adjacent) / k, with its limit 1 / adjacent at k = 0."""
    ratio = k / adjacent
    bent = np.divide(np.arctan(ratio), ratio, out=np.ones_like(ratio), where=ratio > 0.0)
    return bent / adjacent


def _dunkle_s(interface: Interface) -> Array:
    n, k = np.broadcast_arrays(interface.eta, interface.kappa)
    square = n * n + k * k
    logarithm = np.log1p((2.0 * n + 1.0) / square)
    bracket = 1.0 - n * logarithm + (n - k) * (n + k) * _angle(k, n + square)
    return np.asarray(1.0 - 8.0 * n * bracket)


def _dunkle_p(interface: Interface) -> Array:
    n, k = np.broadcast_arrays(interface.eta, interface.kappa)
    square = n * n + k * k
    logarithm = np.log((1.0 + n) ** 2 + k * k)
    bracket = square - n * logarithm + (n - k) * (n + k) * _angle(k, 1.0 + n)
    return np.asarray(1.0 - 8.0 * n / square**2 * bracket)


def _dunkle(interface: Interface) -> Array:
    return 0.5 * (_dunkle_s(interface) + _dunkle_p(interface))


# Coefficients c[i][j] of k^i n^j and of G^i r^j.
_RATIONAL_NUMERATOR = (
    (-8.214737476609672, 133.7359744765862, -98.9832978804228),
    (-182.3702003078492, 59.56171376011442, -3.9828814738544107),
    (-62.591907101534154, -13.109290817253394, 0.3081804514395202),
)
_RATIONAL_DENOMINATOR = (
    (0.0, -395.2681486337069, -78.47602559071363),
    (-187.16625841046798, 94.65173464738277, -15.855805815946251),
    (-62.07520207202666, -15.438703954274438, 1.0),
)
_RG_NUMERATOR = (
    (-2.0451558353360357, 60.88405996107553, 322.2806535116558),
    (14.9839211083631, 97.32802959940146, -687.9935126644131),
    (1.3890774118488598, -145.19694441443767, 338.6486829760271),
)
_RG_DENOMINATOR = (
    (0.0, 512.5359759247783, -127.45924551986035),
    (230.27759868799, -1005.5551398186406, 191.70842828834142),
    (-198.15004297964407, 470.70682665699746, -73.78542717613104),
)


def _deon_rational(interface: Interface) -> Array:
    n, k = np.broadcast_arrays(interface.eta, interface.kappa)
    return polyval2d(k, n, _RATIONAL_NUMERATOR) / polyval2d(k, n, _RATIONAL_DENOMINATOR)


def _deon_rg(interface: Interface) -> Array:
    n, k = np.broadcast_arrays(interface.eta, interface.kappa)
    r = interface.F0
    tint = deon_G(n, k, r)
    return polyval2d(tint, r, _RG_NUMERATOR) / polyval2d(tint, r, _RG_DENOMINATOR)


def _schlick_nk(interface: Interface) -> Array:
    n, k = interface.eta, interface.kappa
    return 1.0 - 80.0 * n / (21.0 * (k * k + (1.0 + n) ** 2))


def _large_k(interface: Interface) -> Array:
    return 1.0 - 16.0 * interface.eta / (3.0 * interface.kappa**2)


def _kulla_conty(interface: Interface) -> Array:
    r = interface.F0
    g = gulbrandsen_g(interface.eta, r)
    return (
        polyval(g, (0.087237, 0.0230685, -0.0864902, 0.0774594))
        + r * polyval(r, (0.782654, -0.136432, 0.278708))
        + g * r * (0.19744 + 0.0360605 * g - 0.2586 * r)
    )


FITS = (
    Fit(
        id="dunkle_1963",
        title="Dunkle 1963, conductor",
        domains=(METALS,),
        latex=r"A\approx\tfrac12(A_s+A_p)",
        reference=_DUNKLE,
        note=_EXACT_FOR,
        claims=(_metals(0.00304, (0.85, 2.73)),),
        function=_dunkle,
    ),
    Fit(
        id="dunkle_1963_s",
        title="Dunkle 1963, conductor, s",
        quantity="s",
        domains=(METALS,),
        latex=r"A_s\approx 1-8n+8n^2\ln\frac{1+2n+n^2+k^2}{n^2+k^2}"
        r"-\frac{8n(n^2-k^2)}{k}\arctan\frac{k}{n+n^2+k^2}",
        reference=_DUNKLE,
        note=_EXACT_FOR,
        printed=_UNNAMED,
        claims=(_metals(0.0405, (0.69, 1.7)),),
        function=_dunkle_s,
    ),
    Fit(
        id="dunkle_1963_p",
        title="Dunkle 1963, conductor, p",
        quantity="p",
        domains=(METALS,),
        latex=r"A_p\approx 1-\frac{8n}{n^2+k^2}+\frac{8n^2}{(n^2+k^2)^2}\ln(1+2n+n^2+k^2)"
        r"-\frac{8n(n^2-k^2)}{k(n^2+k^2)^2}\arctan\frac{k}{1+n}",
        reference=_DUNKLE,
        note=_EXACT_FOR,
        printed=_UNNAMED,
        claims=(_metals(0.0381, (0.70, 1.7)),),
        function=_dunkle_p,
    ),
    Fit(
        id="deon_2019_rational",
        title="d'Eon 2019, first conductor fit",
        domains=(METALS,),
        latex=r"A\approx\frac{\sum_{i,j\le 2}a_{ij}\,k^i n^j}{\sum_{i,j\le 2}b_{ij}\,k^i n^j}"
        + _matrix("a_{ij}", _RATIONAL_NUMERATOR)
        + _matrix("b_{ij}", _RATIONAL_DENOMINATOR),
        symbols=_POWERS,
        reference=_HITCHHIKER,
        note="A quotient of polynomials in n and k.",
        claims=(_metals(0.00309, (0.50, 1.7), claimed=0.001, source=_D_EON),),
        function=_deon_rational,
    ),
    Fit(
        id="deon_2019_rg",
        title="d'Eon 2019, second conductor fit",
        domains=(METALS,),
        latex=r"A\approx\frac{\sum_{i,j\le 2}c_{ij}\,G^i r^j}{\sum_{i,j\le 2}d_{ij}\,G^i r^j},"
        r"\quad r=F_0,\quad G=\tfrac1\pi\operatorname{atan2}\!\left(k,\,n-\tfrac{1+r}{1-r}\right)"
        + _matrix("c_{ij}", _RG_NUMERATOR)
        + _matrix("d_{ij}", _RG_DENOMINATOR),
        symbols=_POWERS,
        reference=_HITCHHIKER,
        note="A quotient of polynomials in F0 and in the edge tint G of his modified mapping.",
        printed="The text of the notebook has lost the square of G in − 145.197 G²r, and the end of "
        "the first parenthesis, which is all of the numerator.",
        claims=(_metals(0.000165, (0.69, 1.7), claimed=0.00006, source=_D_EON),),
        function=_deon_rg,
    ),
    Fit(
        id="kulla_conty_2017_tint",
        title="Kulla and Conty 2017, reflectance and edge tint",
        domains=(METALS,),
        latex=r"A\approx 0.087237+0.0230685g-0.0864902g^2+0.0774594g^3+0.782654r-0.136432r^2"
        r"+0.278708r^3+0.19744gr+0.0360605g^2r-0.2586gr^2",
        reference="C. Kulla and A. Conty, Revisiting Physically Based Shading at Imageworks, "
        "SIGGRAPH 2017 course, over r = F0 and g of O. Gulbrandsen, JCGT 3(4), 2014",
        symbols=(
            Symbol("r", "reflectance at normal incidence, F₀"),
            Symbol("g", "Gulbrandsen's edge tint"),
        ),
        note="Made for r and g within 0 and 1, which n^2 + k^2 >= 1 grants.",
        claims=(_metals(0.0170, (0.29, 1.7)),),
        function=_kulla_conty,
    ),
    Fit(
        id="schlick_nk",
        title="Schlick's albedo of n and k",
        domains=(METALS,),
        latex=r"A\approx 1-\frac{80\,n}{21\,(k^2+(1+n)^2)}",
        reference=_HITCHHIKER,
        note="The albedo of Schlick's polynomial, written for a conductor.",
        claims=(_metals(0.0362, (4.0, 4.83)),),
        function=_schlick_nk,
    ),
    Fit(
        id="large_k",
        title="Asymptote for large k",
        domains=(Domain(eta=(0.1, 4.0), kappa=(10.0, 100.0)),),
        latex=r"A\approx 1-\frac{16\,n}{3\,k^2}",
        reference=_HITCHHIKER,
        note="Right to first order in n / k^2; below 0 where k^2 < 16 n / 3.",
        claims=(
            Claim(
                domain=Domain(eta=(0.1, 4.0), kappa=(10.0, 100.0)),
                source="given for large k without a bound",
                measured=0.0656,
                at=(4.0, 10.0),
            ),
            _metals(6.81, (4.0, 1.7)),
        ),
        function=_large_k,
    ),
)
