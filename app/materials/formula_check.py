"""Formulas that come from outside: whether they give an index throughout the range they claim."""

import numpy as np

from app.materials.dispersion import refractive_index
from app.materials.schema import Formula
from app.optics.errors import NotAllowed
from app.optics.parameters import N_T, WAVELENGTH_NM

_SCANNED = 2001
"""Wavelengths at which a formula has to make sense."""


def refuse_useless(formula: Formula) -> None:
    """Refuse a formula that has no n that can be computed with, somewhere in its range.

    Raises
    ------
    NotAllowed
        Naming where.
    """
    low, high = formula.range_nm
    if not 0.0 < low < high <= WAVELENGTH_NM.maximum:
        what = f"a range of wavelengths; {low:g} to {high:g} nm is none"
        raise NotAllowed("formula", formula.number, what)
    wavelength_nm = np.geomspace(low, high, _SCANNED)
    with np.errstate(all="ignore"):
        n = refractive_index(formula.number, formula.coefficients, wavelength_nm / 1000.0)
    wrong = np.flatnonzero(~N_T.admits(n))
    if wrong.size:
        at = int(wrong[0])
        what = (
            f"a formula with n from {N_T.minimum:g} to {N_T.maximum:g} throughout its range; at "
            f"{wavelength_nm[at]:.6g} nm it gives {n[at]:.4g}"
        )
        raise NotAllowed("formula", formula.number, what)
