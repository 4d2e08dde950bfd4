"""The index of standard air, which an index measured in air is relative to."""

import numpy as np
from numpy.typing import ArrayLike

from app.materials.dispersion import refractive_index
from app.optics.parameters import Array

CIDDOR = (0.0, 0.05792105, 238.0185, 0.00167917, 57.362)
"""Coefficients of dispersion formula 6 for dry air at 15 °C, 101.325 kPa and 450 ppm CO2.

The preset `air` has the same ones, so that a glass measured in air keeps its printed index there.
"""


def air_index(wavelength_nm: ArrayLike) -> Array:
    r"""Index of standard air against vacuum, of the wavelengths' shape.

    .. math:: n - 1 = \frac{0.05792105}{238.0185 - \lambda^{-2}}
        + \frac{0.00167917}{57.362 - \lambda^{-2}}, \quad \lambda \text{ in micrometers}

    Ciddor fitted it from 230 to 1690 nm [1]_. Materials known further than air, as glass is in the
    infrared, take it there as well: from 200 nm to 14 µm it stays within 2e-6 of what Peck and
    Reeder and Mathar have, less than any index of a solid is known to.

    Parameters
    ----------
    wavelength_nm
        From 200 nm on.

    References
    ----------
    .. [1] P. E. Ciddor, Appl. Opt. 35, 1566 (1996), the standard air of its equation 1.
    """
    return refractive_index(6, CIDDOR, np.asarray(wavelength_nm, dtype=np.float64) / 1000.0)
