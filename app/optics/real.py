"""The exact solution in real arithmetic, for languages that know neither arrays nor complex numbers.

Each function is one expression of mu = cos(theta_i), eta and kappa after a few named steps, so that
`app.snippets` can translate it; the forms are those of `app.optics.amplitudes`, which are careful about
directions given in degrees as well. Where mu, eta and kappa are doubles, the powers agree with those but
within 1e-6 radians of the critical angle, and a power that vanishes at an angle but close to it.
"""

from collections.abc import Callable, Mapping

import numpy as np

from app.optics.interface import normal_reflectance
from app.optics.parameters import Array, Condition, Number
from app.optics.specular import MU_BAR

_DEGREES = 180.0 / np.pi
_SMALLEST = 1e-300


def sine2(mu: Number) -> Array:
    """sin^2(theta_i)."""
    return np.asarray((1.0 - mu) * (1.0 + mu))


def square_re(eta: Array, kappa: Array) -> Array:
    """Real part of N^2; the imaginary one is 2 eta kappa."""
    return (eta - kappa) * (eta + kappa)


def contrast2(eta: Array, kappa: Array) -> Array:
    """|N^2 - 1|^2."""
    return ((eta - 1.0) ** 2 + kappa**2) * ((eta + 1.0) ** 2 + kappa**2)


def q2_re(mu: Number, eta: Array, kappa: Array) -> Array:
    """Real part of q^2 = N^2 - sin^2; where both are near 1 by their differences from 1."""
    grazing = (eta - 1.0) * (eta + 1.0) - kappa**2 + mu * mu
    return np.where(mu * mu > 0.5, square_re(eta, kappa) - sine2(mu), grazing)


def larger(mu: Number, eta: Array, kappa: Array) -> Array:
    """The larger part of q = sqrt(N^2 - sin^2), from a sum of positive terms."""
    re = q2_re(mu, eta, kappa)
    im = 2.0 * eta * kappa
    return np.sqrt(0.5 * (np.sqrt(re * re + im * im) + np.abs(re)))


def q_re(mu: Number, eta: Array, kappa: Array) -> Array:
    """Real part of q; the smaller part of q is taken from the product of both."""
    part = larger(mu, eta, kappa)
    forward = q2_re(mu, eta, kappa) >= 0.0
    return np.where(forward, part, eta * kappa / np.maximum(part, _SMALLEST))


def q_im(mu: Number, eta: Array, kappa: Array) -> Array:
    """Imaginary part of q."""
    part = larger(mu, eta, kappa)
    forward = q2_re(mu, eta, kappa) >= 0.0
    return np.where(forward, eta * kappa / np.maximum(part, _SMALLEST), part)


def is_total(mu: Number, eta: Array, kappa: Array) -> Condition:
    """Whether all is reflected: beyond the critical angle, and at 90 degrees."""
    return np.asarray((mu == 0.0) | ((kappa == 0.0) & (q2_re(mu, eta, kappa) < 0.0)))


def Rs(mu: Number, eta: Array, kappa: Array) -> Array:
    """Reflectance of s-polarized light, 0 without a boundary."""
    contrast = contrast2(eta, kappa)
    den = (mu + q_re(mu, eta, kappa)) ** 2 + q_im(mu, eta, kappa) ** 2
    part = np.where(is_total(mu, eta, kappa), 1.0, np.minimum(contrast / (den * den), 1.0))
    return np.where(contrast == 0.0, 0.0, part)


def Rp(mu: Number, eta: Array, kappa: Array) -> Array:
    """Reflectance of p-polarized light, 0 without a boundary."""
    contrast, mu2 = contrast2(eta, kappa), mu * mu
    re, im = square_re(eta, kappa), 2.0 * eta * kappa
    null = (re * mu2 - sine2(mu)) ** 2 + (im * mu2) ** 2
    den = (re * mu + q_re(mu, eta, kappa)) ** 2 + (im * mu + q_im(mu, eta, kappa)) ** 2
    part = np.minimum(contrast * null / (den * den), 1.0)
    return np.where(contrast == 0.0, 0.0, np.where(is_total(mu, eta, kappa), 1.0, part))


def R(mu: Number, eta: Array, kappa: Array) -> Array:
    """Reflectance of unpolarized light, 1 to the last bit where all is reflected."""
    return 0.5 * (Rs(mu, eta, kappa) + Rp(mu, eta, kappa))


def Ts(mu: Array, eta: Array, kappa: Array) -> Array:
    """Transmittance of s-polarized light, 1 without a boundary."""
    a, b = q_re(mu, eta, kappa), q_im(mu, eta, kappa)
    passed = 4.0 * mu * a / ((mu + a) ** 2 + b * b)
    return np.where(contrast2(eta, kappa) == 0.0, 1.0, np.minimum(passed, 1.0))


def Tp(mu: Array, eta: Array, kappa: Array) -> Array:
    """Transmittance of p-polarized light, 1 without a boundary."""
    a, b, sin2 = q_re(mu, eta, kappa), q_im(mu, eta, kappa), sine2(mu)
    ratio = (a * a + b * b + sin2) / ((mu * a + sin2) ** 2 + (mu * b) ** 2)
    passed = 4.0 * mu * a / ((mu + a) ** 2 + b * b) * ratio
    return np.where(contrast2(eta, kappa) == 0.0, 1.0, np.minimum(passed, 1.0))


def T(mu: Array, eta: Array, kappa: Array) -> Array:
    """Transmittance of unpolarized light."""
    return 0.5 * (Ts(mu, eta, kappa) + Tp(mu, eta, kappa))


def r_s_re(mu: Array, eta: Array, kappa: Array) -> Array:
    """Real part of r_s = (1 - N^2)/(c + q)^2."""
    x, b = mu + q_re(mu, eta, kappa), q_im(mu, eta, kappa)
    re, im = (eta - 1.0) * (eta + 1.0) - kappa**2, 2.0 * eta * kappa
    den, matched = x * x + b * b, contrast2(eta, kappa) == 0.0
    r = -(re * (x - b) * (x + b) + im * 2.0 * x * b) / (den * den)
    return np.where(matched, 0.0, np.where(mu == 0.0, -1.0, r))


def r_s_im(mu: Array, eta: Array, kappa: Array) -> Array:
    """Imaginary part of r_s."""
    x, b = mu + q_re(mu, eta, kappa), q_im(mu, eta, kappa)
    re, im = (eta - 1.0) * (eta + 1.0) - kappa**2, 2.0 * eta * kappa
    den, matched = x * x + b * b, contrast2(eta, kappa) == 0.0
    r = (re * 2.0 * x * b - im * (x - b) * (x + b)) / (den * den)
    return np.where(matched | (mu == 0.0), 0.0, r + 0.0)  # no negative zero, whose phase is -180


def null_re(mu: Array, eta: Array, kappa: Array) -> Array:
    """Real part of (N^2 - 1)(N^2 c^2 - s^2)."""
    re, im, mu2 = square_re(eta, kappa), 2.0 * eta * kappa, mu * mu
    contrast = (eta - 1.0) * (eta + 1.0) - kappa**2
    return contrast * (re * mu2 - sine2(mu)) - im * im * mu2


def null_im(mu: Array, eta: Array, kappa: Array) -> Array:
    """Imaginary part of the same."""
    re, im, mu2 = square_re(eta, kappa), 2.0 * eta * kappa, mu * mu
    contrast = (eta - 1.0) * (eta + 1.0) - kappa**2
    return contrast * im * mu2 + im * (re * mu2 - sine2(mu))


def r_p_re(mu: Array, eta: Array, kappa: Array) -> Array:
    """Real part of r_p = (N^2 - 1)(N^2 c^2 - s^2)/(N^2 c + q)^2."""
    x = square_re(eta, kappa) * mu + q_re(mu, eta, kappa)
    y = 2.0 * eta * kappa * mu + q_im(mu, eta, kappa)
    re, im = null_re(mu, eta, kappa), null_im(mu, eta, kappa)
    den, matched = x * x + y * y, contrast2(eta, kappa) == 0.0
    r = (re * (x - y) * (x + y) + im * 2.0 * x * y) / (den * den)
    return np.where(matched, 0.0, np.where(mu == 0.0, -1.0, r))


def r_p_im(mu: Array, eta: Array, kappa: Array) -> Array:
    """Imaginary part of r_p."""
    x = square_re(eta, kappa) * mu + q_re(mu, eta, kappa)
    y = 2.0 * eta * kappa * mu + q_im(mu, eta, kappa)
    re, im = null_re(mu, eta, kappa), null_im(mu, eta, kappa)
    den, matched = x * x + y * y, contrast2(eta, kappa) == 0.0
    r = (im * (x - y) * (x + y) - re * 2.0 * x * y) / (den * den)
    return np.where(matched | (mu == 0.0), 0.0, r + 0.0)  # no negative zero, whose phase is -180


def t_s_re(mu: Array, eta: Array, kappa: Array) -> Array:
    """Real part of t_s = 1 + r_s = 2 c/(c + q)."""
    x, b = mu + q_re(mu, eta, kappa), q_im(mu, eta, kappa)
    t = 2.0 * mu * x / (x * x + b * b)
    return np.where(contrast2(eta, kappa) == 0.0, 1.0, t)


def t_s_im(mu: Array, eta: Array, kappa: Array) -> Array:
    """Imaginary part of t_s."""
    x, b = mu + q_re(mu, eta, kappa), q_im(mu, eta, kappa)
    t = -2.0 * mu * b / (x * x + b * b)
    return np.where(contrast2(eta, kappa) == 0.0, 0.0, t)


def t_p_re(mu: Array, eta: Array, kappa: Array) -> Array:
    """Real part of t_p = (1 + r_p)/N = 2 N c/(N^2 c + q)."""
    x = square_re(eta, kappa) * mu + q_re(mu, eta, kappa)
    y = 2.0 * eta * kappa * mu + q_im(mu, eta, kappa)
    t = 2.0 * mu * (eta * x + kappa * y) / (x * x + y * y)
    return np.where(contrast2(eta, kappa) == 0.0, 1.0, t)


def t_p_im(mu: Array, eta: Array, kappa: Array) -> Array:
    """Imaginary part of t_p."""
    x = square_re(eta, kappa) * mu + q_re(mu, eta, kappa)
    y = 2.0 * eta * kappa * mu + q_im(mu, eta, kappa)
    t = 2.0 * mu * (kappa * x - eta * y) / (x * x + y * y)
    return np.where(contrast2(eta, kappa) == 0.0, 0.0, t)


def phase_s_deg(mu: Array, eta: Array, kappa: Array) -> Array:
    """Phase of r_s in degrees; at 90 degrees the limit from smaller angles."""
    grazing = np.where(q_im(mu, eta, kappa) > 0.0, -180.0, 180.0)
    phase = _DEGREES * np.arctan2(r_s_im(mu, eta, kappa), r_s_re(mu, eta, kappa))
    return np.where((mu == 0.0) & (contrast2(eta, kappa) > 0.0), grazing, phase)


def phase_p_deg(mu: Array, eta: Array, kappa: Array) -> Array:
    """Phase of r_p in degrees; at 90 degrees the limit from smaller angles."""
    a, b = q_re(mu, eta, kappa), q_im(mu, eta, kappa)
    below = 2.0 * eta * kappa * a < square_re(eta, kappa) * b
    phase = _DEGREES * np.arctan2(r_p_im(mu, eta, kappa), r_p_re(mu, eta, kappa))
    grazing = np.where(below, -180.0, 180.0)
    return np.where((mu == 0.0) & (contrast2(eta, kappa) > 0.0), grazing, phase)


def theta_t_deg(mu: Array, eta: Array, kappa: Array) -> Array:
    """Real angle of refraction in degrees, NaN at total reflection."""
    total = (kappa == 0.0) & (q2_re(mu, eta, kappa) < 0.0)
    angle = _DEGREES * np.arctan2(np.sqrt(sine2(mu)), q_re(mu, eta, kappa))
    return np.where(total, np.nan, angle)


def penetration_depth_wavelengths(mu: Array, n_i: Array, eta: Array, kappa: Array) -> Array:
    """Depth of 1/e of the power in vacuum wavelengths, NaN where the wave is undamped."""
    b = q_im(mu, eta, kappa)
    return np.where(b > 0.0, 1.0 / (4.0 * np.pi * n_i * np.maximum(b, _SMALLEST)), np.nan)


def field_penetration_depth_wavelengths(mu: Array, n_i: Array, eta: Array, kappa: Array) -> Array:
    """Depth of 1/e of the field, twice that of the power."""
    return 2.0 * penetration_depth_wavelengths(mu, n_i, eta, kappa)


def F0(n_i: Array, n_t: Array, k_t: Array) -> Array:
    """Reflectance at normal incidence."""
    return np.asarray(normal_reflectance(n_i, n_t, k_t))


def F82(eta: Array, kappa: Array) -> Array:
    """Exact reflectance at cos(theta_i) = 1/7."""
    return R(MU_BAR, eta, kappa)


def brewster_deg(eta: Array, kappa: Array) -> Array:
    """Brewster's angle in degrees, NaN in absorbers."""
    return np.where(kappa > 0.0, np.nan, _DEGREES * np.arctan(eta))


def critical_deg(eta: Array, kappa: Array) -> Array:
    """Critical angle in degrees, NaN where there is none."""
    exists = (eta < 1.0) & (kappa == 0.0)
    return np.where(exists, _DEGREES * np.arcsin(np.minimum(eta, 1.0)), np.nan)


QUANTITIES: Mapping[str, Callable[..., Array]] = {
    function.__name__: function
    for function in (
        *(R, Rs, Rp, T, Ts, Tp),
        *(r_s_re, r_s_im, r_p_re, r_p_im, t_s_re, t_s_im, t_p_re, t_p_im),
        *(phase_s_deg, phase_p_deg, theta_t_deg),
        *(penetration_depth_wavelengths, field_penetration_depth_wavelengths),
        *(F0, F82, brewster_deg, critical_deg),
    )
}
"""What is known of a ray beside R, and of an interface, by its name in the API."""
