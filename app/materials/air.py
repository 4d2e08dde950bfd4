"""The index of standard air, which an index measured in air is relative to."""

import numpy as np
from numpy.typing import ArrayLike

from app.materials.dispersion import refractive_index
from app.optics.parameters import Array

CIDDOR = (0.0, 0.05792105, 238.0185, 0.00167917, 57.362)
"""Coefficients of dispersion formula 6 for dry air at 15 °C, 101.325 kPa and 450 ppm CO2.

The preset `air` has the same ones, so that a glass measured in air keeps its printed index there.
"""

OPAQUE_BELOW_NM = 185.0


def air_index(wavelength_nm: ArrayLike) -> Array:
    r"""Index of standard air against vacuum, of the wavelengths' shape.

    .. math:: n - 1 = \frac{0.05792105}{238.0185 - \lambda^{-2}}
        + \frac{0.00167917}{57.362 - \lambda^{-2}}, \quad \lambda \text{ in micrometers}

    Ciddor fitted it from 230 to 1690 nm [1]_. Materials known further than air, as glass is in the
    infrared, take it there as well: from 200 nm to 14 µm it stays within 2e-6 of what Peck and
    Reeder and Mathar have, less than any index of a solid is known to. Below 185 nm, where air is
    opaque and the formula nears its poles, the value at 185 nm is held.

    Parameters
    ----------
    wavelength_nm
        Wavelengths in nanometers, any shape.

    References
    ----------
    .. [1] P. E. Ciddor, Appl. Opt. 35, 1566 (1996), the standard air of its equation 1.
    """
    held = np.maximum(np.asarray(wavelength_nm, dtype=np.float64), OPAQUE_BELOW_NM)
    return refractive_index(6, CIDDOR, held / 1000.0)
