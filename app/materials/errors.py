"""What the materials raise: errors that name the parameter, the value and what is allowed."""

from collections.abc import Sequence

from app.optics.errors import NotAllowed, OpticsError, OutOfRange, UnknownName
from app.optics.meant import in_nm


class UnknownMaterial(UnknownName):
    """No preset has this id, alias or name.

    Parameters
    ----------
    id
        What was asked for.
    nearest
        The ids that resemble it most, best first.
    """

    def __init__(self, id: str, nearest: tuple[str, ...] = ()) -> None:  # noqa: A002
        hint = "the id or an alias of a material"
        if nearest:
            hint += f"; nearest: {', '.join(nearest)}"
        OpticsError.__init__(self, "material", id, hint)
        self.nearest = list(nearest)


class WavelengthOutOfRange(OutOfRange):
    """A wavelength at which the source gives no value: nothing is extrapolated.

    Parameters
    ----------
    material
        Id of the material.
    quantity
        "n" or "k", whose range it is.
    value
        The wavelength asked for, in nanometers.
    minimum, maximum
        The valid range, inclusive, in nanometers.
    elsewhere
        Ids of other measurements that are known at the wavelength.
    """

    def __init__(
        self,
        material: str,
        quantity: str,
        value: float,
        minimum: float,
        maximum: float,
        elsewhere: Sequence[str] = (),
    ) -> None:
        span = f"{minimum:.10g}" if minimum == maximum else f"{minimum:.10g} to {maximum:.10g}"
        allowed = f"{span} nm, where {quantity} of {material} is known"
        if elsewhere:
            known = "is known" if len(elsewhere) == 1 else "are known"
            allowed += f"; {' and '.join(elsewhere)} {known} there"
        super().__init__("wavelength_nm", value, allowed + in_nm(value))
        self.material = material
        self.quantity = quantity
        self.minimum = minimum
        self.maximum = maximum


class NoSpectrum(NotAllowed):
    """A spectrum was asked of a material whose source prints a single index."""

    def __init__(self, material: str) -> None:
        super().__init__(
            "material", material, "a material with a spectrum; this one is a single index"
        )
