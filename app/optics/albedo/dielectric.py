r"""Closed form of a dielectric's hemispherical albedo, in a variable in which nothing cancels.

Dunkle's expression in n loses eight digits at n = 1.0001. In z = (n - 1)/(n + 1), whose square is the
reflectance at normal incidence, its poles at n = 1 cancel on paper:

.. math::
    A_s &= \frac{z (2 + z)}{3} \\
    A_p &= \frac{z}{2 (1 + z^2)^3} \left[ P(z) + (1+z)^4 (1-z)^2 (1 + 6 z^2 + z^4) \, T(z)
           + 8 z (1+z)^2 \ln z \right] \\
    P(z) &= 1 + 14 z - 4 z^2 - 10 z^3 - 2 z^4 + 10 z^5 + 4 z^6 + 2 z^7 + z^8, \qquad
    T(z) = \frac{\operatorname{artanh} z - z}{z^3} = \frac13 + \frac{z^2}{5} + \frac{z^4}{7} + \dots

From the dense side, n < 1, reciprocity holds for each polarization:
A(n) = 1 - n^2 (1 - A(1/n)) = (1 - n^2) + n^2 A(1/n), a sum of positive terms.

References
----------
.. [1] R. V. Dunkle, Thermal radiation characteristics of surfaces, in Theory and Fundamental
   Research in Heat Transfer, Pergamon 1963, pp. 1-31.
.. [2] M. N. Ozisik, Radiative Transfer, Wiley 1973, p. 60.
"""

import numpy as np
from numpy.polynomial.polynomial import polyval
from scipy.special import xlogy

from app.optics.interface import Interface
from app.optics.parameters import Array

_P = (1.0, 14.0, -4.0, -10.0, -2.0, 10.0, 4.0, 2.0, 1.0)
# Above z = 0.3 (n = 1.86) artanh z - z keeps 13 digits; below, 14 terms reach the last one.
_SERIES_BELOW = 0.3
_T_SERIES = tuple(1.0 / (2 * k + 3) for k in range(15))


def dielectric_albedo(interface: Interface) -> tuple[Array, Array]:
    """Hemispherical albedo for s and p polarization; k_t is left out of account.

    Parameters
    ----------
    interface
        Any shape; n_t may be above or below n_i.

    Returns
    -------
    A_s, A_p
        Within 0 and 1, relative error below 1e-13.

    Examples
    --------
    >>> s, p = dielectric_albedo(Interface(n_t=1.5))
    >>> round(float(s), 12), round(float(p), 12)
    (0.146666666667, 0.036889252018)
    """
    z = np.abs(interface.n_t - interface.n_i) / (interface.n_t + interface.n_i)
    s, p = z * (2.0 + z) / 3.0, _p_polarized(z)
    dense = interface.eta < 1.0
    totally = np.where(dense, -interface.eta_minus_1 * (interface.eta + 1.0), 0.0)  # 1 - n^2
    entering = np.where(dense, interface.eta**2, 1.0)
    return np.asarray(totally + entering * s), np.asarray(totally + entering * p)


def dunkle(n: Array) -> Array:
    """The closed form of unpolarized light in n > 1, as Dunkle and Ozisik have it.

    It is shown for its source; near n = 1 its terms cancel as (n - 1)^-2.
    """
    square, fourth = n * n, n**4
    logarithms = 8.0 * fourth * (fourth + 1.0) / ((square + 1.0) * (fourth - 1.0) ** 2) * np.log(n)
    logarithms += square * (square - 1.0) ** 2 / (square + 1.0) ** 3 * np.log((n - 1.0) / (n + 1.0))
    quotients = 0.5 + (n - 1.0) * (3.0 * n + 1.0) / (6.0 * (n + 1.0) ** 2)
    quotients -= 2.0 * n**3 * (square + 2.0 * n - 1.0) / ((square + 1.0) * (fourth - 1.0))
    return np.asarray(quotients + logarithms)


def _p_polarized(z: Array) -> Array:
    square = z * z
    weight = (1.0 + z) ** 4 * (1.0 - z) ** 2 * (1.0 + square * (6.0 + square))
    bracket = polyval(z, _P) + weight * _artanh_remainder(z) + 8.0 * (1.0 + z) ** 2 * xlogy(z, z)
    return np.asarray(0.5 * z * bracket / (1.0 + square) ** 3)


def _artanh_remainder(z: Array) -> Array:
    """T(z) = (artanh z - z) / z^3."""
    small = z < _SERIES_BELOW
    safe = np.where(small, 0.5, np.minimum(z, 1.0 - 1e-16))
    return np.where(small, polyval(z * z, _T_SERIES), (np.arctanh(safe) - safe) / safe**3)
