"""Fits of a dielectric's albedo, from the thin side (eta > 1) and from the dense side (eta < 1)."""

from typing import Any

import numpy as np
from numpy.polynomial import polynomial

from app.optics.albedo.fit import Claim, Domain, Fit
from app.optics.interface import Interface
from app.optics.parameters import Array

_MITSUBA = "comment in Mitsuba, include/mitsuba/render/fresnel.h, fresnel_diffuse_reflectance"


def polyval(x: Array, coefficients: tuple[float, ...]) -> Array:
    """sum c_j x^j, coefficients from the constant up."""
    return np.asarray(polynomial.polyval(x, np.array(coefficients)), dtype=np.float64)


def _deon_log(interface: Interface) -> Array:
    n = interface.eta
    return np.asarray(np.log((10893.0 * n - 1438.2) / (1.0 + 10212.0 * n - 774.4 * n * n)))


def _deon_irving(interface: Interface) -> Array:
    return polyval(1.0 / interface.eta, (0.919317, -3.4793, 6.75335, -7.80989, 4.98554, -1.36881))


def _egan_hilgeman_external(interface: Interface) -> Array:
    return polyval(interface.eta, (-0.4399, 0.7099, -0.3319, 0.0636))


def _kulla_conty(interface: Interface) -> Array:
    return interface.eta_minus_1 / (4.08567 + 1.00071 * interface.eta)


def _egan_hilgeman(interface: Interface) -> Array:
    x = interface.eta
    return 0.0636 / x + polyval(x, (0.6681, 0.7099, -1.4399))


def _deon_irving_internal(interface: Interface) -> Array:
    # Published, and coded in PBRT, as the first moment int R mu dmu: half the albedo.
    moment = polyval(1.0 / interface.eta, (-4.61686, 11.1136, -10.4646, 5.11455, -1.27198, 0.12746))
    return 2.0 * moment


def _kulla_conty_internal(interface: Interface) -> Array:
    return polyval(interface.eta, (0.997118, 0.1014, -0.965241, -0.130607))


def _claim(low: float, high: float, measured: float, at: float, **said: Any) -> Claim:
    return Claim(domain=Domain(eta=(low, high)), measured=measured, at=(at, 0.0), **said)


def _relative(
    low: float, high: float, claimed: float, measured: float, at: float, over: Domain | None = None
) -> Claim:
    said = {"claimed": claimed, "relative": True, "source": _MITSUBA, "over": over}
    return _claim(low, high, measured, at, **said)


FITS = (
    Fit(
        id="deon_2019_log",
        title="d'Eon 2019, logarithm",
        domains=(Domain(eta=(1.0, 3.0)),),
        latex=r"A\approx\ln\frac{10893\,n-1438.2}{1+10212\,n-774.4\,n^2}",
        reference="E. d'Eon, A Hitchhiker's Guide to Multiple Scattering, Fresnel Boundaries, 2019",
        note="Does not go to 0 as n approaches 1, where its error is largest.",
        printed="The text of the notebook reads 10.893 and 10.212: thousands separators became decimal "
        "points. With those it is −0.194 at n = 1.5, where the albedo is 0.0918.",
        claims=(
            _claim(1.0, 3.0, 0.00172, 1.0, source="error plot without a figure, for 1 < n < 3"),
        ),
        function=_deon_log,
    ),
    Fit(
        id="deon_irving_2011",
        title="d'Eon and Irving 2011, external",
        domains=(Domain(eta=(1.0, 10.0)),),
        latex=r"A\approx 0.919317-3.4793x+6.75335x^2-7.80989x^3+4.98554x^4-1.36881x^5,"
        r"\quad x=\tfrac1n",
        reference="E. d'Eon and G. Irving, A Quantized-Diffusion Model for Rendering Translucent "
        "Materials, ACM Trans. Graph. 30(4), 2011, doi:10.1145/2010324.1964951; in Mitsuba and PBRT",
        note="The fit that renderers use from outside.",
        claims=(
            _relative(1.0, 2.0, 0.001, 0.00936, 1.01, Domain(eta=(1.01, 2.0))),
            _relative(2.0, 10.0, 0.002, 0.0135, 10.0),
            _claim(1.02, 2.0, 7.18e-5, 1.035),
        ),
        function=_deon_irving,
    ),
    Fit(
        id="egan_hilgeman_1973_external",
        title="Egan and Hilgeman 1973, external",
        domains=(Domain(eta=(1.0, 2.0)),),
        latex=r"A\approx -0.4399+0.7099\,n-0.3319\,n^2+0.0636\,n^3",
        reference="W. G. Egan and T. W. Hilgeman 1973, as C. Donner and H. W. Jensen, Light "
        "Diffusion in Multi-Layered Translucent Materials, SIGGRAPH 2005, "
        "doi:10.1145/1073204.1073308, print it",
        note="Printed there with the reciprocal index, for eta < 1.",
        claims=(_claim(1.0, 2.0, 0.0017, 1.0),),
        function=_egan_hilgeman_external,
    ),
    Fit(
        id="kulla_conty_2017",
        title="Kulla and Conty 2017, external",
        domains=(Domain(eta=(1.0, 100.0)),),
        latex=r"A\approx\frac{n-1}{4.08567+1.00071\,n}",
        reference="C. Kulla and A. Conty, Revisiting Physically Based Shading at Imageworks, "
        "SIGGRAPH 2017 course; in Blender Cycles",
        note="Goes to 0 at n = 1, though with the slope 0.197 in place of 1/3.",
        claims=(_claim(1.0, 100.0, 0.00653, 1.173),),
        function=_kulla_conty,
    ),
    Fit(
        id="egan_hilgeman_1973",
        title="Egan and Hilgeman 1973, internal",
        domains=(Domain(eta=(0.2, 1.0)),),
        latex=r"A\approx 0.0636\,n+0.6681+0.7099\,x-1.4399\,x^2,\quad x=\tfrac1n=\eta",
        reference="W. G. Egan and T. W. Hilgeman 1973, as H. W. Jensen et al., A Practical Model for "
        "Subsurface Light Transport, SIGGRAPH 2001, doi:10.1145/383259.383319, quote it; in Mitsuba",
        note="Internal diffuse reflectance, n the dense medium's relative index.",
        claims=(
            _relative(
                1.0 / 1.5, 1.0, 0.001, 0.0391, 1.0 / 1.01, Domain(eta=(1.0 / 1.5, 1.0 / 1.01))
            ),
            _relative(0.5, 1.0 / 1.5, 0.006, 0.000781, 1.0 / 1.5),
            _relative(0.2, 0.5, 0.095, 0.0952, 0.2),
            _claim(0.5, 1.0 / 1.01, 0.000932, 0.916),
        ),
        function=_egan_hilgeman,
    ),
    Fit(
        id="deon_irving_2011_internal",
        title="d'Eon and Irving 2011, internal",
        domains=(Domain(eta=(0.5, 1.0)),),
        latex=r"A\approx 2\,(-4.61686+11.1136\,n-10.4646\,n^2+5.11455\,n^3-1.27198\,n^4"
        r"+0.12746\,n^5)",
        reference="E. d'Eon and G. Irving, A Quantized-Diffusion Model for Rendering Translucent "
        "Materials, 2011, doi:10.1145/2010324.1964951; in PBRT, FresnelMoment1",
        note="Internal diffuse reflectance, n = 1/eta; a polynomial that runs away above n = 2.",
        claims=(_claim(0.5, 1.0, 0.00434, 1.0),),
        function=_deon_irving_internal,
    ),
    Fit(
        id="kulla_conty_2017_internal",
        title="Kulla and Conty 2017, internal",
        domains=(Domain(eta=(0.01, 1.0)),),
        latex=r"A\approx 0.997118+0.1014\,\eta-0.965241\,\eta^2-0.130607\,\eta^3",
        reference="C. Kulla and A. Conty, Revisiting Physically Based Shading at Imageworks, SIGGRAPH "
        "2017 course; in Blender Cycles",
        note="Internal diffuse reflectance. Leaves 0.0027 at eta = 1.",
        claims=(_claim(0.01, 1.0, 0.00267, 1.0),),
        function=_kulla_conty_internal,
    ),
)
