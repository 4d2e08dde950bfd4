r"""Albedo in flatland, where light and surfaces live in a plane: int R cos(theta_i) dtheta_i.

Allen's closed form for dielectrics holds elliptic integrals of the parameter m = 1/(1 - n^2) < 0, and
one of the third kind whose characteristic 1 + n^2 > 1 makes it complex; what is meant is its real
part, Cauchy's principal value. In Carlson's symmetric integrals all of it is real,

.. math::
    K = R_F(0, 1-m, 1), \quad E = K - \tfrac{m}{3} R_D(0, 1-m, 1), \quad
    \Pi = K + \tfrac{1+n^2}{3} R_J(0, 1-m, 1, -n^2),

R_J being the principal value for its negative last argument. The terms of the closed form cancel as
(n - 1)^-3, so near n = 1 the integral is summed instead. From the dense side reciprocity reads
A(n) = 1 - n (1 - A(1/n)) = (1 - n) + n A(1/n).

References
----------
.. [1] W. A. Allen, Transmission of isotropic light across a dielectric surface in two and three
   dimensions, J. Opt. Soc. Am. 63 (1973) 664, doi:10.1364/JOSA.63.000664.
.. [2] B. C. Carlson, Numerical computation of real or complex elliptic integrals, Numerical
   Algorithms 10 (1995) 13, doi:10.1007/BF02198293.
"""

import numpy as np
from numpy.polynomial.polynomial import polyval
from scipy.special import elliprd, elliprf, elliprj

from app.optics.albedo.exact import flatland_by_quadrature
from app.optics.interface import Interface
from app.optics.parameters import Array

# Allen's form has lost four digits here.
_ALLEN_FROM = 1.25


def flatland_albedo(interface: Interface) -> Array:
    """Albedo of unpolarized light in two dimensions.

    Parameters
    ----------
    interface
        Any shape, dielectrics (by Allen's closed form) and conductors (by quadrature) mixed.

    Returns
    -------
    Array
        Of the interface's shape, within 0 and 1, relative error below 1e-11.

    Examples
    --------
    >>> round(float(flatland_albedo(Interface(n_t=1.5))), 12)
    0.067976526841
    """
    n_i, n_t, k_t = np.broadcast_arrays(interface.n_i, interface.n_t, interface.k_t)
    clear = k_t == 0.0
    reverse = clear & (n_t < n_i)
    thin, dense = np.where(reverse, n_t, n_i), np.where(reverse, n_i, n_t)
    closed = clear & (dense >= _ALLEN_FROM * thin)
    result = np.empty(k_t.shape)
    result[closed] = allen(dense[closed] / thin[closed])
    if not closed.all():
        summed = Interface(thin[~closed], dense[~closed], k_t[~closed])
        result[~closed] = flatland_by_quadrature(summed).unpolarized
    eta = interface.eta
    return np.where(reverse, -interface.eta_minus_1 + eta * result, result)


def allen(n: Array) -> Array:
    """Allen's closed form, n > 1; its terms cancel as (n - 1)^-3."""
    x = n * n
    contrast, total = (n - 1.0) * (n + 1.0), x + 1.0
    m = -1.0 / contrast
    K = elliprf(0.0, 1.0 - m, 1.0)
    E = K - m / 3.0 * elliprd(0.0, 1.0 - m, 1.0)
    Pi = K + total / 3.0 * elliprj(0.0, 1.0 - m, 1.0, -x)
    common = 2.0 + x + 2.0 * x * x
    elementary = total * polyval(x, (7.0, 24.0, 102.0, 10.0, 15.0)) + 30.0 * n * x * np.sqrt(
        total
    ) * common * np.arcsinh(n)
    elliptic = polyval(x, (-22.0, -15.0, -47.0, -1.0, 9.0, 1.0)) * K + 15.0 * x * x * common * Pi
    quartic = contrast * total  # n^4 - 1
    first = -2.0 * polyval(x, (1.0, 31.0, 15.0, 31.0, 1.0)) * E / (contrast**1.5 * total**2)
    second = (contrast * elementary + 2.0 * x * np.sqrt(contrast) * elliptic) / quartic**3
    return np.asarray((first + second) / 15.0)
