"""Averages of Schlick's polynomial and of its descendants, from F0 (and F82) alone."""

import numpy as np

from app.optics.albedo.fit import Claim, Domain, Fit
from app.optics.albedo.fits.conductor import METALS
from app.optics.interface import Interface
from app.optics.parameters import Array
from app.optics.specular import DIP_SCALE, F82, MU_BAR, polynomial

_GLASSES = Domain(eta=(1.0, 3.0))


def _schlick(interface: Interface) -> Array:
    F0 = interface.F0
    return F0 + (1.0 - F0) / 21.0


def _f82_tint(interface: Interface) -> Array:
    # S(mu_bar) (1 - tint) with tint = F82 / S(mu_bar).
    missing = polynomial(interface.F0, MU_BAR) - F82(interface)
    return np.asarray(_schlick(interface) - DIP_SCALE * missing / 126.0)


FITS = (
    Fit(
        id="schlick",
        title="Schlick's albedo of F0",
        domains=(_GLASSES, METALS),
        latex=r"A\approx F_0+\frac{1-F_0}{21}",
        reference="The average of C. Schlick's polynomial, 2 B(2, 6) = 1/21, "
        "doi:10.1111/1467-8659.1330233",
        note="Exact for Schlick's own curve; 1/21 remains at n = 1.",
        claims=(
            Claim(domain=_GLASSES, measured=0.0477, at=(1.0, 0.0)),
            Claim(domain=METALS, measured=0.0362, at=(4.0, 4.83)),
        ),
        function=_schlick,
    ),
    Fit(
        id="f82_tint",
        title="F82-tint's albedo",
        domains=(METALS,),
        latex=r"A\approx F_0+\frac{1-F_0}{21}-\frac{b}{126},\quad "
        r"b=\frac{S(\bar\mu)-F_{82}}{\bar\mu(1-\bar\mu)^6},\quad \bar\mu=\tfrac17",
        reference="P. Kutz, M. Hašan and D. Edmondson, Novel Aspects of the Adobe Standard Material "
        "(2021); OpenPBR; in Blender Cycles",
        note="Exact for the models f82_tint and hoffman_f82, which are the same curve, where that stays "
        "above 0; f82_tint is cut at 0.",
        claims=(Claim(domain=METALS, measured=0.0125, at=(0.83, 1.7)),),
        function=_f82_tint,
    ),
)
