"""Every fit of the albedo, by id."""

from __future__ import annotations

from app.optics.albedo.fit import Fit
from app.optics.albedo.fits import conductor, dielectric, schlick
from app.optics.errors import UnknownName

FITS: dict[str, Fit] = {fit.id: fit for fit in (*dielectric.FITS, *schlick.FITS, *conductor.FITS)}


class UnknownFit(UnknownName):
    """An id that is no fit's."""


def find_fit(fit_id: str, parameter: str = "fits") -> Fit:
    """Return the fit of that id.

    Raises
    ------
    UnknownFit
        If there is none, naming the nearest ids.
    """
    try:
        return FITS[fit_id]
    except KeyError:
        raise UnknownFit(parameter, fit_id, FITS) from None
