"""Fresnel's equations in 50-digit arithmetic, from the textbook quotients.

Inputs are taken as the exact numbers that the doubles are, angles as degrees. The quotients are not
those of `app.optics.amplitudes`, so that a mistake there cannot repeat itself here.
"""

from dataclasses import dataclass

from mpmath import mp, mpc, mpf

DIGITS = 50


@dataclass(frozen=True)
class Reference:
    """Amplitudes and powers of one ray, rounded to doubles.

    `theta_t_deg` is the real angle of refraction, 90 at total reflection; `depth` of the
    power and `field_depth` are in vacuum wavelengths, infinite where the wave is not damped.
    """

    r_s: complex
    r_p: complex
    t_s: complex
    t_p: complex
    Rs: float
    Rp: float
    R: float
    Ts: float
    Tp: float
    T: float
    theta_t_deg: float
    depth: float
    field_depth: float


def fresnel(n_i: float, n_t: float, k_t: float, theta_i_deg: float) -> Reference:
    """Solve one interface at one angle."""
    with mp.workdps(DIGITS):
        ni, index = mpf(n_i), mpc(n_t, k_t)
        theta = mpf(theta_i_deg) * mp.pi / 180
        # mpmath's pi / 2 is rounded too; at 90 degrees the cosine is 0, as in exact arithmetic.
        cos = mpf(0) if theta_i_deg == 90.0 else mp.cos(theta)
        sin = mp.sin(theta)
        q = mp.sqrt(index**2 - (ni * sin) ** 2)  # N cos(theta_t), with Re q >= 0 and Im q >= 0
        if index == ni:  # no boundary: not even a grazing ray, whose quotients are 0/0, meets one
            r_s, r_p, t_s, t_p = mpc(0), mpc(0), mpc(1), mpc(1)
        else:
            r_s = (ni * cos - q) / (ni * cos + q)
            r_p = (index**2 * cos - ni * q) / (index**2 * cos + ni * q)
            t_s = 2 * ni * cos / (ni * cos + q)
            t_p = 2 * ni * index * cos / (index**2 * cos + ni * q)
        Rs, Rp = abs(r_s) ** 2, abs(r_p) ** 2
        total = q.real == 0 and index != ni
        Ts, Tp = (mpf(0), mpf(0)) if total else (1 - Rs, 1 - Rp)
        return Reference(
            r_s=complex(r_s),
            r_p=complex(r_p),
            t_s=complex(t_s),
            t_p=complex(t_p),
            Rs=float(Rs),
            Rp=float(Rp),
            R=float((Rs + Rp) / 2),
            Ts=float(Ts),
            Tp=float(Tp),
            T=float((Ts + Tp) / 2),
            theta_t_deg=float(mp.degrees(mp.atan2(ni * sin, q.real))),
            # |exp(2 pi i q z)|^2 = 1/e, and |exp(2 pi i q z)| = 1/e
            depth=float(1 / (4 * mp.pi * q.imag)) if q.imag > 0 else float("inf"),
            field_depth=float(1 / (2 * mp.pi * q.imag)) if q.imag > 0 else float("inf"),
        )
