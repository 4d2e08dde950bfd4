"""The conversions as the collection of formulas shows them; what they compute is in `conversions`."""

from collections.abc import Callable, Sequence

import numpy as np

from app.optics.conversions import (
    F0_LINEAR,
    F0_SRGB,
    SEEN_FROM,
    TITLES,
    Form,
    Known,
    convert,
    know,
)
from app.optics.edge_tint import EDGE_TINT, TINT_ANGLE
from app.optics.formulas.formula import (
    Accuracy,
    Columns,
    Curves,
    Formula,
    Plotted,
    Symbol,
    over,
    rounding,
)
from app.optics.interface import Interface
from app.optics.knobs.reflectance import FILAMENT, SPECULAR
from app.optics.parameters import K_T, N_T, Array, Parameter
from app.optics.registry import default_registry

Names = Sequence[tuple[str, str]]
Value = Callable[[Interface, float], Sequence[float]]

_N = Plotted("n_t", "n_t", "index of refraction")
_GLASS, _GOLD = Interface(n_t=1.5), Interface(1.0, 0.27, 2.9)

# Ordinates, each with the names and titles of its series.
_TO_F0 = Plotted("F0", "F_0", "reflectance at normal incidence, linear"), (("F0", "F0"),)
_TO_N = _N, (("n_t", "n"),)
_TO_INDEX = (
    Plotted("index", "n_t, k_t", "index relative to the medium in front"),
    (("n_t", "n"), ("k_t", "k")),
)


def _curve(
    x: Plotted | tuple[Parameter, str],
    low: float,
    high: float,
    to: tuple[Plotted, Names],
    value: Value,
) -> Curves:
    """Plot what a conversion gives along its own number, one point at a time as it is asked for."""
    if not isinstance(x, Plotted):
        parameter, title = x
        x = Plotted(parameter.name, parameter.symbol, title, parameter.unit)
    y, names = to

    def columns(interface: Interface, at: Array) -> Columns:
        rows = np.array([value(interface, float(one)) for one in at], dtype=np.float64)
        for (name, title), column in zip(names, rows.T, strict=True):
            yield name, title, np.ascontiguousarray(column)

    return over(x, low, high, y, columns)


def _form(known: Known, form: str, *names: str, seen_from: float = 1.333) -> list[float]:
    """Values of one form; NaN where there is none."""
    values = next(c for c in convert(known, seen_from) if c.form == form).values
    return [float("nan") if values[name] is None else float(values[name] or 0.0) for name in names]


def _at(interface: Interface, **changed: float) -> Known:
    """Know the interface's relative n and k, or others in their places."""
    return know("nk", **{"n_t": float(interface.eta), "k_t": float(interface.kappa)} | changed)


def _there_and_back(value: float, over: str) -> Accuracy:
    return rounding(value, "what comes back", over, "what was given, there and back")


_BORN_AND_WOLF = (
    "M. Born and E. Wolf, Principles of Optics, 7th edition, 1.5.2, doi:10.1017/CBO9781139644181"
)


def _of_an_engine(
    name: Form,
    level: Parameter,
    title: str,
    largest: float,
    *,
    latex: str,
    reference: str,
    tried: str,
) -> Formula:
    """An engine's way to write F0, from 0 to 1, where it is `largest`."""

    def index(value: float) -> float:
        return know(name, **{name: value}).dielectric_eta

    return Formula(
        id=f"conversion.{name}",
        title=TITLES[name],
        latex=latex,
        parameters=(level,),
        reference=reference,
        validity=f"Dielectrics in air, F0 up to {largest:g}, an index up to {index(1.0):.3g}; "
        "metals are beyond it.",
        accuracy=(_there_and_back(1e-14, f"{tried} by way of n_t"),),
        at=_GLASS,
        curve=_curve((level, title), 0.0, 1.0, _TO_N, lambda _, x: [index(x)]),
    )


def _model_latex(model_id: str) -> str:
    """The index by reflectance and tint, without the curve that the model makes of it."""
    return default_registry()[model_id].latex.rpartition(r",\quad R=")[0]


FORMULAS = (
    Formula(
        id="conversion.ior",
        title=TITLES["ior"],
        latex=r"F_0=\left(\frac{n_t-n_i}{n_t+n_i}\right)^2",
        reference=_BORN_AND_WOLF,
        validity="Dielectrics, from either side; F0 does not tell n_t from n_i^2 / n_t.",
        accuracy=(_there_and_back(1e-14, "n_t from 1.05 to 60 by way of F0"),),
        at=_GLASS,
        curve=_curve(_N, 1.0, 4.0, _TO_F0, lambda _, x: [know("ior", n_t=x).F0]),
    ),
    Formula(
        id="conversion.nk",
        title=TITLES["nk"],
        latex=r"F_0=\frac{(n_t-n_i)^2+k_t^2}{(n_t+n_i)^2+k_t^2}",
        reference=_BORN_AND_WOLF + ", and 14.2",
        validity="Every interface. Two numbers become one: n and k cannot be had back from F0.",
        accuracy=(rounding(1e-14, "F0", "n from 0.05 to 10, k up to 10"),),
        at=_GOLD,
        takes=(N_T,),
        curve=_curve((K_T, "extinction k_t"), 0.0, 8.0, _TO_F0, lambda i, x: [_at(i, k_t=x).F0]),
    ),
    Formula(
        id="conversion.f0",
        title=TITLES["f0"],
        latex=r"n_t=n_i\,\frac{1+\sqrt{F_0}}{1-\sqrt{F_0}}",
        reference=_BORN_AND_WOLF + "; S. Lagarde, Memo on Fresnel equations (2013)",
        validity="Where the second medium does not absorb and is the denser one, which F0 does "
        "not tell.",
        accuracy=(_there_and_back(1e-14, "F0 from 0.001 to 0.96 by way of n_t"),),
        at=_GLASS,
        curve=_curve(
            (F0_LINEAR, "F0, linear"), 0.0, 0.5, _TO_N, lambda _, x: [know("f0", F0=x).index[0]]
        ),
    ),
    Formula(
        id="conversion.f0_srgb",
        title=TITLES["f0_srgb"],
        latex=r"F_0=\begin{cases}F_0^\text{sRGB}/12.92 & F_0^\text{sRGB}\le 0.04045\\"
        r"\left(\frac{F_0^\text{sRGB}+0.055}{1.055}\right)^{2.4} & \text{otherwise}\end{cases}",
        symbols=(Symbol(r"F_0^\text{sRGB}", "F0 as an sRGB value, 0 to 1"),),
        reference="IEC 61966-2-1:1999, section 5.2; P. Shirley, Fresnel Equations, Schlick "
        "Approximation, "
        "Metals, and Dielectrics (2020): be careful about gamma",
        validity="Values from 0 to 1, channel by channel. Reflectances are linear: decode a "
        "picked color "
        "before it becomes an F0.",
        accuracy=(_there_and_back(1e-14, "F0 from 0.001 to 1 by way of sRGB"),),
        at=_GLASS,
        curve=_curve(
            (F0_SRGB, "F0 as an sRGB value"),
            0.0,
            1.0,
            _TO_F0,
            lambda _, x: [know("f0_srgb", F0_srgb=x).F0],
        ),
    ),
    Formula(
        id="conversion.f0_hex",
        title=TITLES["f0_hex"],
        latex=r"c=\operatorname{round}\left(255\,F_0^\text{sRGB}\right)",
        symbols=(Symbol(r"F_0^\text{sRGB}", "F0 as an sRGB value, 0 to 1"),),
        reference="IEC 61966-2-1:1999, section 5.2",
        validity="One of 256 codes a channel: a dark F0 keeps more digits than a bright one.",
        accuracy=(
            Accuracy(
                value=0.00445,
                of="F0",
                over="F0 from 0 to 1",
                against="F0 before it was rounded to a code",
            ),
        ),
        at=_GLASS,
        curve=_curve(
            (F0_LINEAR, "F0 before rounding"),
            0.0,
            0.02,
            (Plotted("F0_decoded", "F_0", "F0 of the code"), [("F0", "F0 of the code")]),
            lambda _, x: _form(know("f0", F0=x), "f0_hex", "F0"),
        ),
    ),
    _of_an_engine(
        "specular",
        SPECULAR,
        "specular level",
        0.08,
        latex=r"F_0=0.08\,\text{specular}",
        reference="B. Burley, Physically Based Shading at Disney, SIGGRAPH 2012 course notes",
        tried="specular from 0.01 to 1",
    ),
    _of_an_engine(
        "reflectance",
        FILAMENT,
        "Filament's reflectance",
        0.16,
        latex=r"F_0=0.16\,\text{reflectance}^2",
        reference="R. Guy and M. Agopian, Physically Based Rendering in Filament",
        tried="reflectance from 0.1 to 1",
    ),
    Formula(
        id="conversion.rg",
        title=TITLES["rg"],
        latex=_model_latex("gulbrandsen_rg"),
        parameters=default_registry()["gulbrandsen_rg"].parameters,
        reference=default_registry()["gulbrandsen_rg"].reference,
        validity="Interfaces with |N| of at least n_i; g runs from 0, a dielectric, to 1, |N| = n_i.",
        accuracy=(
            _there_and_back(1e-11, "eta from 0.1 to 10, kappa up to 10, |N| of at least 1.01"),
        ),
        at=_GOLD,
        takes=(N_T, K_T),
        curve=_curve(
            (EDGE_TINT, "edge tint g, at the F0 of n and k"),
            0.0,
            1.0,
            _TO_INDEX,
            lambda i, x: know("rg", r=float(i.F0), g=x).index,
        ),
    ),
    Formula(
        id="conversion.dg",
        title=TITLES["dg"],
        latex=_model_latex("deon_rg"),
        parameters=default_registry()["deon_rg"].parameters,
        reference=default_registry()["deon_rg"].reference,
        printed="The notebook has n by r and G, and G by n and k; the formula of k is missing from its "
        "text. This one is equivalent to both.",
        validity="Every interface that reflects something: G = 0 is the denser dielectric of that "
        "reflectance, G = 1 the thinner.",
        accuracy=(_there_and_back(1e-13, "eta from 0.1 to 10, kappa up to 10"),),
        at=_GOLD,
        takes=(N_T, K_T),
        curve=_curve(
            (TINT_ANGLE, "edge tint G, at the F0 of n and k"),
            0.0,
            1.0,
            _TO_INDEX,
            lambda i, x: know("dg", r=float(i.F0), G=x).index,
        ),
    ),
    Formula(
        id="conversion.f82",
        title=TITLES["f82"],
        latex=r"F_{82}=R(\theta_i),\quad \cos\theta_i=\bar\mu=\tfrac17",
        reference="N. Hoffman, Fresnel Equations Considered Harmful, Eurographics Workshop on Material "
        "Appearance Modeling (2019), doi:10.2312/mam.20191305",
        validity="Every interface; cosine 1/7 is where the dip of metals under Schlick's curve "
        "is deepest "
        "in Hoffman's form.",
        accuracy=(rounding(1e-14, "F82", "n from 0.05 to 10, k up to 10"),),
        at=Interface(1.0, 1.5, 3.0),
        takes=(K_T,),
        curve=_curve(
            _N,
            0.1,
            4.0,
            (Plotted("R", "R", "reflectance"), [("F0", "F0"), ("F82", "F82")]),
            lambda i, x: _form(_at(i, n_t=x), "f82", "F0", "F82"),
        ),
    ),
    Formula(
        id="conversion.f82_tint",
        title=TITLES["f82_tint"],
        latex=r"\text{tint}=\frac{F_{82}}{S(\bar\mu)},\quad S(\mu)=F_0+(1-F_0)(1-\mu)^5,"
        r"\quad \bar\mu=\tfrac17",
        symbols=(Symbol(r"\text{tint}", "F82 over what Schlick's polynomial has there"),),
        reference="P. Kutz, M. Hašan and D. Edmondson, Novel Aspects of the Adobe Standard Material "
        "(2021); OpenPBR Surface specification, metal",
        validity="Every interface. The tint is above 1 where R at 82 degrees exceeds Schlick's, as it "
        "does beyond the critical angle, and by up to 6 % for some metals, but for no dielectric seen "
        "from the thinner side; renderers that end at 1 cut it.",
        accuracy=(rounding(1e-14, "tint", "n from 0.05 to 10, k up to 10"),),
        at=Interface(1.0, 1.5, 3.0),
        takes=(K_T,),
        curve=_curve(
            _N,
            0.1,
            4.0,
            (Plotted("tint", r"\text{tint}", "tint"), [("tint", "tint")]),
            lambda i, x: _form(_at(i, n_t=x), "f82_tint", "tint"),
        ),
    ),
    Formula(
        id="conversion.f0_seen_from",
        title=TITLES["f0_seen_from"],
        latex=r"F_0'=\frac{(n_t-n_i')^2+k_t^2}{(n_t+n_i')^2+k_t^2}",
        symbols=(Symbol("F_0'", "F0 from the other medium"),),
        parameters=(SEEN_FROM,),
        reference="S. Lagarde, Memo on Fresnel equations (2013): F0 is another under water",
        validity="Every interface. From F0 alone it holds if the second medium does not absorb "
        "and is the "
        "denser one.",
        accuracy=(rounding(1e-14, "F0", "n from 0.05 to 10, k up to 10, from 1.333"),),
        at=_GLASS,
        takes=(N_T, K_T),
        curve=_curve(
            (SEEN_FROM, "index of the medium in front"),
            1.0,
            3.0,
            _TO_F0,
            lambda i, x: _form(_at(i), "f0_seen_from", "F0", seen_from=x),
        ),
    ),
)
