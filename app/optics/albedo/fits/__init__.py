"""Every fit of the albedo, by id."""

from app.optics.albedo.fits import conductor, dielectric, schlick
from app.optics.collection import Collection
from app.optics.errors import UnknownName


class UnknownFit(UnknownName):
    """An id that is no fit's."""


FITS = Collection((*dielectric.FITS, *schlick.FITS, *conductor.FITS), UnknownFit, "fits")
find_fit = FITS.find
