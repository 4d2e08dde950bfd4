"""The exact albedos as the collection of formulas shows them."""

from app.optics.albedo.coat import BODY_ALBEDO, coat_split
from app.optics.albedo.dielectric import dunkle
from app.optics.albedo.exact import albedo
from app.optics.albedo.flatland import allen, flatland_albedo
from app.optics.formulas.formula import (
    ETA,
    Accuracy,
    Columns,
    Formula,
    Plotted,
    Symbol,
    over,
    rounding,
)
from app.optics.interface import Interface
from app.optics.parameters import K_T, N_T, Array

_ALBEDO = Plotted("albedo", "A", "albedo")
_SHARE = Plotted("share", "A", "share of diffuse light")
_BODY = Plotted(BODY_ALBEDO.name, BODY_ALBEDO.symbol, "albedo of the body under the coat")


def _by_polarization(interface: Interface, eta: Array) -> Columns:
    found = albedo(Interface(1.0, eta, interface.kappa))
    for name in ("unpolarized", "s", "p"):
        yield name, name, getattr(found, name)


def _both_sides(_: Interface, eta: Array) -> Columns:
    yield "outside", "from the thinner side", albedo(Interface(1.0, eta)).unpolarized
    yield "inside", "from the denser side", albedo(Interface(eta, 1.0)).unpolarized


def _flatland(interface: Interface, eta: Array) -> Columns:
    media = Interface(1.0, eta, interface.kappa)
    yield "flatland", "flatland", flatland_albedo(media)
    yield "unpolarized", "three dimensions", albedo(media).unpolarized


def _coat(interface: Interface, body: Array) -> Columns:
    split = coat_split(Interface(1.0, interface.eta), body)
    for name in ("surface", "body", "absorbed"):
        yield name, name, getattr(split, name)


def _dunkle(_: Interface, n: Array) -> Columns:
    yield "unpolarized", "unpolarized", dunkle(n)


def _allen(_: Interface, n: Array) -> Columns:
    yield "flatland", "flatland", allen(n)


_35_DIGITS = "35-digit arithmetic"
_N = Symbol("n", "relative index eta, above 1")

FORMULAS = (
    Formula(
        id="albedo.exact",
        title="Hemispherical albedo",
        latex=r"A=2\int_0^{\pi/2}R(\theta_i)\,\sin\theta_i\cos\theta_i\,\mathrm{d}\theta_i",
        reference="the definition, as in M. N. Ozisik, Radiative Transfer, Wiley 1973; E. d'Eon, "
        "A Hitchhiker's Guide to Multiple Scattering, Fresnel Boundaries, 2019",
        validity="Every interface; of absorbing media there is no closed form, and it is summed.",
        accuracy=(rounding(1e-13, "A", "absorbers, eta and kappa up to 100", _35_DIGITS),),
        at=Interface(1.0, 1.5, 3.0),
        takes=(K_T,),
        curve=over(ETA, 0.2, 4.0, _ALBEDO, _by_polarization),
    ),
    Formula(
        id="albedo.dielectric",
        title="Dielectric, closed form",
        latex=r"A_s=\frac{z(2+z)}{3},\quad "
        r"A_p=\frac{z}{2(1+z^2)^3}\left[P+(1+z)^4(1-z)^2(1+6z^2+z^4)\,T+8z(1+z)^2\ln z\right],"
        r"\quad z=\frac{\eta-1}{\eta+1},"
        r"\quad P=1+14z-4z^2-10z^3-2z^4+10z^5+4z^6+2z^7+z^8,"
        r"\quad T=\frac{\operatorname{artanh}z-z}{z^3}",
        reference="R. V. Dunkle, Thermal radiation characteristics of surfaces (1963); M. N. Ozisik, "
        "Radiative Transfer (1973), p. 60; E. d'Eon, A Hitchhiker's Guide to Multiple Scattering "
        "(2019); rewritten here so that nothing cancels as eta nears 1",
        validity="Dielectrics from the thinner side, eta > 1; from the denser side by reciprocity.",
        accuracy=(rounding(1e-14, "A", "eta from 1 + 1e-12 to 100", _35_DIGITS),),
        at=Interface(n_t=1.5),
        curve=over(ETA, 0.2, 4.0, _ALBEDO, _by_polarization),
    ),
    Formula(
        id="albedo.dunkle",
        title="Dielectric, as Dunkle and d'Eon write it",
        latex=r"A=\frac12+\frac{(n-1)(3n+1)}{6(n+1)^2}-\frac{2n^3(n^2+2n-1)}{(n^2+1)(n^4-1)}"
        r"+\frac{8n^4(n^4+1)}{(n^2+1)(n^4-1)^2}\ln n+\frac{n^2(n^2-1)^2}{(n^2+1)^3}\ln\frac{n-1}{n+1}",
        symbols=(_N,),
        reference="R. V. Dunkle, Thermal radiation characteristics of surfaces (1963); M. N. Ozisik, "
        "Radiative Transfer (1973), p. 60; E. d'Eon, A Hitchhiker's Guide to Multiple Scattering, "
        "Fresnel Boundaries, 2019",
        printed="The text of d'Eon's notebook has a stray − 1/(6(n + 1)) behind the second term: with "
        "it A would be 0.0251 and not 0.0918 at n = 1.5.",
        validity="Dielectrics from the thinner side, n > 1. Its terms cancel near n = 1: at 1.0001 five "
        "digits are left. What is computed here is the other closed form.",
        accuracy=(
            rounding(1e-4, "A", "n from 1.0001 to 100", "the closed form in which nothing cancels"),
        ),
        at=Interface(n_t=1.5),
        curve=over(Plotted("n", "n", "relative index n_t/n_i"), 1.01, 4.0, _ALBEDO, _dunkle),
    ),
    Formula(
        id="albedo.reciprocity",
        title="From the denser side",
        latex=r"1-A(1/\eta)=\eta^2\left(1-A(\eta)\right)",
        reference="F. Stern, Transmission of isotropic radiation across an interface between two "
        "dielectrics, Appl. Opt. 3, 111 (1964), doi:10.1364/AO.3.000111; W. G. Egan and T. W. Hilgeman, "
        "Optical Properties of Inhomogeneous Materials (1979)",
        validity="Dielectrics, for each polarization: what leaves a dense medium is limited to the cone "
        "within the critical angle, and the rest is reflected inside.",
        accuracy=(rounding(1e-14, "A", "eta from 0.001 to 1 - 1e-9", _35_DIGITS),),
        at=Interface(1.5, 1.0),
        curve=over(ETA, 1.0, 4.0, _ALBEDO, _both_sides),
    ),
    Formula(
        id="albedo.flatland",
        title="Flatland albedo",
        latex=r"A=\int_0^{\pi/2}R(\theta_i)\cos\theta_i\,\mathrm{d}\theta_i",
        reference="W. A. Allen, Transmission of isotropic light across a dielectric surface in two and "
        "three dimensions, J. Opt. Soc. Am. 63, 664 (1973), doi:10.1364/JOSA.63.000664, which gives the "
        "closed form of a dielectric in elliptic integrals",
        validity="Light and surface in a plane, as in two-dimensional teaching scenes. Where the closed "
        "form's elliptic integral of the third kind is complex, its real part counts.",
        accuracy=(rounding(1e-11, "A", "eta from 0.001 to 100, kappa up to 100", _35_DIGITS),),
        at=Interface(n_t=1.5),
        takes=(K_T,),
        curve=over(ETA, 0.2, 4.0, _ALBEDO, _flatland),
    ),
    Formula(
        id="albedo.allen",
        title="Flatland, Allen's closed form",
        latex=r"A=\frac{1}{15}\left(-\frac{2(1+31n^2+15n^4+31n^6+n^8)\,E(m)}{(n^2-1)^{3/2}(1+n^2)^2}"
        r"+\frac{(n^2-1)P+2n^2\sqrt{n^2-1}\,Q}{(n^4-1)^3}\right),"
        r"\quad P=(1+n^2)(7+24n^2+102n^4+10n^6+15n^8)"
        r"+30n^3\sqrt{1+n^2}\,(2+n^2+2n^4)\operatorname{arsinh}n,"
        r"\quad Q=(-22-15n^2-47n^4-n^6+9n^8+n^{10})\,K(m)"
        r"+15n^4(2+n^2+2n^4)\operatorname{Re}\Pi(1+n^2\mid m),\quad m=\frac{1}{1-n^2}",
        symbols=(
            _N,
            Symbol("m", "parameter of the elliptic integrals, below 0"),
            Symbol("K", "complete elliptic integral of the first kind"),
            Symbol("E", "complete elliptic integral of the second kind"),
            Symbol(
                r"\Pi",
                "complete elliptic integral of the third kind, of characteristic and parameter",
            ),
        ),
        reference="W. A. Allen, Transmission of isotropic light across a dielectric surface in two and "
        "three dimensions, J. Opt. Soc. Am. 63, 664 (1973), doi:10.1364/JOSA.63.000664; E. d'Eon, "
        "A Hitchhiker's Guide to Multiple Scattering, Fresnel Boundaries, 2019",
        printed="Right as d'Eon prints it, but that the elliptic integral of the third kind has a "
        "characteristic above 1 and is complex: its real part is meant, Cauchy's principal value.",
        validity="Dielectrics from the thinner side, n > 1, in two dimensions; its terms cancel near "
        "n = 1.",
        accuracy=(rounding(1e-11, "A", "n from 1.25 to 100", _35_DIGITS),),
        at=Interface(n_t=1.5),
        curve=over(Plotted("n", "n", "relative index n_t/n_i"), 1.01, 4.0, _ALBEDO, _allen),
    ),
    Formula(
        id="albedo.coat",
        title="Diffuse body under a coat",
        latex=r"\text{body}=(1-A_e)\frac{(1-A_i)\,\rho}{1-A_i\,\rho},\quad "
        r"\text{absorbed}=(1-A_e)\frac{1-\rho}{1-A_i\,\rho},\quad \text{surface}=A_e",
        symbols=(
            Symbol("A_e", "albedo of the coat's surface from outside"),
            Symbol("A_i", "albedo of the coat's surface from the body's side"),
            Symbol(r"\text{body}", "share that the body scatters and the coat lets out"),
            Symbol(r"\text{absorbed}", "share lost in the body"),
            Symbol(r"\text{surface}", "share that the surface reflects"),
        ),
        parameters=(BODY_ALBEDO,),
        reference="J. L. Saunderson, Calculation of the color of pigmented plastics, J. Opt. "
        "Soc. Am. 32, "
        "727 (1942), doi:10.1364/JOSA.32.000727",
        validity="A clear coat over a body that scatters evenly in all directions, as in glossy "
        "paint; for a "
        "ray R takes the place of A_e on its way in.",
        accuracy=(
            Accuracy(
                value=1e-14,
                of="share",
                over="eta from 1.1 to 4, body albedos up to 0.95",
                against="the light followed bounce by bounce",
                at_most=True,
            ),
        ),
        at=Interface(n_t=1.5),
        takes=(N_T,),
        curve=over(_BODY, 0.0, 1.0, _SHARE, _coat),
    ),
)
