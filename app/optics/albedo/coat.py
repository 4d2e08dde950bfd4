r"""A diffuse body under a smooth dielectric coat: glossy paint.

Light that passes the coat is scattered by the body; of what comes back up, the share A_i is reflected
down again by the inner side of the coat, and so on without end. With A_e the coat's albedo from
outside, A_i from inside and rho the body's albedo the geometric series gives

.. math::
    \text{surface} = A_e, \qquad
    \text{body} = (1 - A_e) \frac{(1 - A_i)\,\rho}{1 - A_i\,\rho}, \qquad
    \text{absorbed} = (1 - A_e) \frac{1 - \rho}{1 - A_i\,\rho}

for diffuse light, and R(theta_i) in the place of A_e for a ray. The coat itself absorbs nothing.

References
----------
.. [1] J. L. Saunderson, Calculation of the color of pigmented plastics, J. Opt. Soc. Am. 32 (1942)
   727, doi:10.1364/JOSA.32.000727.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from app.optics.albedo.exact import albedo
from app.optics.amplitudes import power
from app.optics.errors import NotAllowed
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.parameters import Array, share

BODY_ALBEDO = share(
    "body_albedo",
    r"\rho",
    "Share of the light reaching the diffuse body under the coat that it scatters back.",
    default=0.5,
)


@dataclass(frozen=True, slots=True, eq=False)
class CoatSplit:
    """Where the light goes, shares of what arrives; surface + body + absorbed = 1."""

    external: Array
    internal: Array
    """Albedo of the coat's surface for diffuse light from outside, and from the body's side."""
    surface: Array
    """Reflected by the surface without reaching the body."""
    body: Array
    """Scattered by the body and let out again."""
    absorbed: Array
    """Lost in the body."""


def coat_split(
    coat: Interface, body_albedo: ArrayLike, incidence: Incidence | None = None
) -> CoatSplit:
    """Split the light that falls on a diffuse body under a dielectric coat.

    Parameters
    ----------
    coat
        The surface between the outside (n_i) and the coat (n_t).
    body_albedo
        Albedo of the diffuse body, 0 to 1; 1 absorbs nothing.
    incidence
        Directions of a ray; diffuse light from the whole hemisphere if not given.

    Returns
    -------
    CoatSplit
        Arrays of the broadcast shape; `external` and `internal` of the coat's.

    Raises
    ------
    NotAllowed
        If the coat absorbs (k_t > 0): no light would reach the body in the limit assumed here.
    OutOfRange
        If the body's albedo is not within 0 and 1.

    Examples
    --------
    A white body under a coat returns everything in the end:

    >>> split = coat_split(Interface(n_t=1.5), 1.0)
    >>> bool(abs(split.surface + split.body - 1.0) < 1e-15)
    True
    """
    if coat.is_conductor:
        raise NotAllowed("k_t", float(np.max(coat.k_t)), "a coat is clear: k_t = 0")
    rho = BODY_ALBEDO.check(body_albedo)
    external = albedo(coat).unpolarized
    internal = albedo(Interface(coat.n_t, coat.n_i)).unpolarized
    if incidence is None:
        surface, entering = external, 1.0 - external
    else:
        energy = power(coat, incidence)
        surface, entering = energy.R, energy.T
    let_out, lost = 1.0 - internal, 1.0 - rho
    # 1 - A_i rho as a sum of positive terms, at least one of which is above 0 ...
    remaining = let_out + internal * lost
    # ... unless the coat lets nothing out of a white body: then what entered stays there.
    escapes = np.divide(
        let_out * rho, remaining, out=np.zeros(np.shape(remaining)), where=remaining > 0.0
    )
    body = np.asarray(entering * escapes)
    absorbed = np.asarray(entering * (1.0 - escapes))
    shape = body.shape
    return CoatSplit(external, internal, np.broadcast_to(surface, shape), body, absorbed)
