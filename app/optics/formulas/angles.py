"""Snell's angle and the angles at which something happens, as the collection of formulas shows them."""

from collections.abc import Callable

import numpy as np

from app.optics.angles import brewster_deg, critical_deg, principal_deg, pseudo_brewster_deg
from app.optics.formulas.formula import (
    ETA,
    THETA,
    Accuracy,
    Columns,
    Curves,
    Formula,
    Plotted,
    Symbol,
    over,
    rounding,
)
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.parameters import K_T, N_I, N_T, Array
from app.optics.snell import (
    field_penetration_depth_wavelengths,
    penetration_depth_wavelengths,
    refraction_angle_deg,
)
from app.optics.vectors import cos2_refracted, reflected, refracted

_REFRACTION = Plotted("theta_t_deg", r"\theta_t", "angle of refraction", "deg")
_DEPTH = Plotted("depth", "d", "depth of 1/e in vacuum wavelengths")
_ANGLE = Plotted("angle_deg", r"\theta_i", "angle of incidence", "deg")


def _refraction(interface: Interface, theta: Array) -> Columns:
    angle = refraction_angle_deg(interface, Incidence.from_degrees(theta))
    yield "theta_t_deg", "angle of refraction", angle


def _penetration(interface: Interface, theta: Array) -> Columns:
    incidence = Incidence.from_degrees(theta)
    yield "depth", "of the power", penetration_depth_wavelengths(interface, incidence)
    yield "field_depth", "of the field", field_penetration_depth_wavelengths(interface, incidence)


def _over_eta(low: float, high: float, angle: Callable[[Interface], Array], title: str) -> Curves:
    """Plot an angle over the relative index."""
    return over(
        ETA,
        low,
        high,
        _ANGLE,
        lambda i, eta: [("angle_deg", title, angle(Interface(1.0, eta, i.kappa)))],
    )


def _of_direction(kind: str) -> Accuracy:
    return Accuracy(
        value=1e-15,
        of="each component",
        over=f"1000 rays scattered in space, eta from 0.5 to 4, as far as they are {kind}",
        against="50-digit arithmetic",
        at_most=True,
    )


_SCATTERED = "1500 interfaces scattered over the whole range, angles from 0 to 90 degrees"


_DIRECTION = Plotted("component", r"\mathbf{t}", "component of the direction")
_OF_RAY = (
    Symbol("d", "unit vector of the incident direction, toward the surface"),
    Symbol("n", "unit normal on the incident side"),
)
_GREVE = (
    "S. Lagarde, Memo on Fresnel equations (2013), after B. de Greve, Reflections and Refractions in "
    "Ray Tracing (2006); E. d'Eon, A Hitchhiker's Guide to Multiple Scattering, Fresnel Boundaries "
    "(2019)"
)


def _components(theta: Array, direction: Callable[[Array, Array, float], Array]) -> Columns:
    """Plot a direction in the plane of incidence, by its components along surface and normal."""
    at = Incidence.from_degrees(theta)
    yield "along", "along the surface", direction(at.cos, at.sin, 0.0)
    yield "normal", "along the normal", direction(at.cos, -at.cos, 1.0)


def _reflected(_: Interface, theta: Array) -> Columns:
    return _components(theta, reflected)


def _refracted(interface: Interface, theta: Array) -> Columns:
    def direction(mu: Array, d: Array, n: float) -> Array:
        there = cos2_refracted(mu, interface.eta) >= 0.0
        return np.where(there, refracted(mu, interface.eta, d, n), np.nan)

    return _components(theta, direction)


FORMULAS = (
    Formula(
        id="angle.reflected_direction",
        title="Reflected direction, in space",
        latex=r"\mathbf{r}=\mathbf{d}+2\mu\,\mathbf{n},\quad \mu=-\mathbf{d}\cdot\mathbf{n}",
        symbols=(Symbol("r", "unit vector of the reflected direction"), *_OF_RAY),
        reference=_GREVE,
        validity="Every surface, component by component; the incident direction points toward the "
        "surface, the reflected one away from it. Shading languages call it reflect(d, n).",
        accuracy=(_of_direction("reflected"),),
        at=Interface(n_t=1.5),
        curve=over(THETA, 0.0, 90.0, _DIRECTION, _reflected),
    ),
    Formula(
        id="angle.refracted_direction",
        title="Refracted direction, in space",
        latex=r"\mathbf{t}=\frac{\mathbf{d}+\mu\,\mathbf{n}}{\eta}"
        r"-\sqrt{1-\frac{1-\mu^2}{\eta^2}}\;\mathbf{n},\quad \mu=-\mathbf{d}\cdot\mathbf{n}",
        symbols=(Symbol("t", "unit vector of the refracted direction"), *_OF_RAY),
        reference=_GREVE,
        validity="Snell's law in vector form, component by component; where the root is one of less "
        "than 0 all is reflected and there is no such direction. Shading languages call it "
        "refract(d, n, 1 / eta).",
        accuracy=(_of_direction("refracted"),),
        at=Interface(n_t=1.5),
        takes=(N_I, N_T),
        curve=over(THETA, 0.0, 90.0, _DIRECTION, _refracted),
    ),
    Formula(
        id="angle.refraction",
        title="Angle of refraction, Snell's law",
        latex=r"n_i\sin\theta_i=n_t\sin\theta_t,\quad "
        r"\tan\theta_t=\frac{\sin\theta_i}{\operatorname{Re}q},\quad q=\sqrt{N^2-\sin^2\theta_i}",
        reference="M. Born and E. Wolf, Principles of Optics, 7th edition, 1.5.1 and 14.2, "
        "doi:10.1017/CBO9781139644181; of absorbers, P. Shirley, Fresnel Equations, Schlick "
        "Approximation, Metals, and Dielectrics (2020), quoting Wikipedia",
        validity="Every interface; none beyond the critical angle. In an absorber it is the "
        "angle of the "
        "planes of constant phase, while those of constant amplitude stay parallel to the surface.",
        accuracy=(rounding(1e-14, "angle", _SCATTERED),),
        at=Interface(n_t=1.5),
        takes=(N_I, N_T, K_T),
        curve=over(THETA, 0.0, 90.0, _REFRACTION, _refraction),
    ),
    Formula(
        id="angle.penetration_depth",
        title="Penetration depths of the power and of the field",
        latex=r"d=\frac{1}{2\operatorname{Im}k_z}=\frac{\lambda_0}{4\pi n_i\operatorname{Im}q},\quad "
        r"d_E=2d=\frac{1}{\operatorname{Im}k_z},\quad q=\sqrt{N^2-\sin^2\theta_i}",
        symbols=(
            Symbol("d", "depth at which the power has fallen to 1/e", "length"),
            Symbol("d_E", "depth at which the field has fallen to 1/e", "length"),
            Symbol("k_z", "normal component of the wave vector in the second medium", "1/length"),
            Symbol(r"\lambda_0", "wavelength in vacuum", "length"),
        ),
        reference="M. Born and E. Wolf, Principles of Optics, 7th edition, 1.5.4 and 14.1, "
        "doi:10.1017/CBO9781139644181",
        validity="Absorbers at every angle, and total internal reflection, where it is the reach of the "
        "evanescent wave; elsewhere light travels on undamped. Attenuated total reflection (ATR) and "
        "many textbooks call that of the field the penetration depth.",
        accuracy=(rounding(1e-14, "depth", _SCATTERED),),
        at=Interface(1.5, 1.0),
        takes=(N_I, N_T, K_T),
        curve=over(THETA, 0.0, 90.0, _DEPTH, _penetration),
    ),
    Formula(
        id="angle.brewster",
        title="Brewster's angle",
        latex=r"\theta_B=\arctan\eta,\quad R_p(\theta_B)=0,\quad \theta_B+\theta_t=90^\circ",
        reference="D. Brewster, On the laws which regulate the polarisation of light by reflexion, "
        "Phil. Trans. R. Soc. 105, 125 (1815), doi:10.1098/rstl.1815.0010",
        validity="Dielectrics, from either side; what is reflected there is s-polarized. Without "
        "absorption alone: see the pseudo-Brewster angle.",
        accuracy=(rounding(1e-14, "angle", "eta from 0.001 to 100"),),
        at=Interface(n_t=1.5),
        curve=_over_eta(0.2, 4.0, brewster_deg, "Brewster's angle"),
    ),
    Formula(
        id="angle.critical",
        title="Critical angle",
        latex=r"\theta_c=\arcsin\eta,\quad R(\theta_i)=1\ \text{for}\ \theta_i\ge\theta_c",
        reference="J. Kepler, Dioptrice (1611); M. Born and E. Wolf, Principles of Optics, 7th edition, "
        "1.5.4, doi:10.1017/CBO9781139644181",
        validity="From the denser side, eta < 1, into a medium that does not absorb; elsewhere there is "
        "none. The light that seems to be lost runs along the surface as an evanescent wave.",
        accuracy=(rounding(1e-14, "angle", "eta from 0.001 to 1 - 1e-9"),),
        at=Interface(1.5, 1.0),
        curve=_over_eta(0.2, 1.2, critical_deg, "critical angle"),
    ),
    Formula(
        id="angle.pseudo_brewster",
        title="Pseudo-Brewster angle",
        latex=r"\frac{\mathrm{d}R_p}{\mathrm{d}\theta_i}(\theta_{pB})=0,\quad "
        r"\theta_{pB}=\theta_B\ \text{for}\ \kappa=0",
        symbols=(
            Symbol(r"\theta_{pB}", "pseudo-Brewster angle, where R_p is least", "rad"),
            Symbol(r"\theta_B", "Brewster's angle", "rad"),
        ),
        reference="R. M. A. Azzam, Complex reflection coefficients of p- and s-polarized light at the "
        "pseudo-Brewster angle of a dielectric-conductor interface, J. Opt. Soc. Am. A 30, 1975 "
        "(2013), doi:10.1364/JOSAA.30.001975",
        validity="Every interface: the angle of least R_p, which is 0 without absorption alone. It is "
        "solved numerically.",
        accuracy=(rounding(1e-14, "angle", "eta from 0.2 to 4, kappa from 0.1 to 8"),),
        at=Interface(1.0, 1.5, 3.0),
        takes=(K_T,),
        curve=_over_eta(0.2, 4.0, pseudo_brewster_deg, "pseudo-Brewster angle"),
    ),
    Formula(
        id="angle.principal",
        title="Principal angle",
        latex=r"\arg r_p-\arg r_s=\pm 90^\circ,\quad "
        r"|N^2-\sin^2\theta_P|=\sin^2\theta_P\tan^2\theta_P,\quad "
        r"\theta_P=\theta_B\ \text{for}\ \kappa=0",
        symbols=(
            Symbol("N", "complex relative index eta + i kappa"),
            Symbol(r"\theta_P", "principal angle, where the phases are 90 degrees apart", "rad"),
            Symbol(r"\theta_B", "Brewster's angle", "rad"),
        ),
        reference="R. M. A. Azzam, Contours of constant principal angle and constant principal azimuth "
        "in the complex epsilon plane, J. Opt. Soc. Am. 71, 1523 (1981), doi:10.1364/JOSA.71.001523",
        validity="Every interface; the smallest, where there are three, which takes |N| < 1. Without "
        "absorption it is Brewster's angle, where the phase jumps by 180 degrees. Ellipsometers "
        "measure metals near it; it is close to the pseudo-Brewster angle, but not the same.",
        accuracy=(rounding(1e-14, "angle", "eta from 0.2 to 4, kappa from 0.1 to 8"),),
        at=Interface(1.0, 1.5, 3.0),
        takes=(K_T,),
        curve=_over_eta(0.2, 4.0, principal_deg, "principal angle"),
    ),
)
