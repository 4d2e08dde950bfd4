"""What is read out of a file of n and k: the material, and how it was read."""

from __future__ import annotations

from collections.abc import Sequence

from app.answers.answer import Gaps, Values, answer, filled
from app.materials.own.material import own
from app.materials.own.token import OwnData, write
from app.materials.reading.read import read
from app.materials.reading.report import Choices, Order, Sign
from app.materials.schema import Range, Reference


@answer
class Assumed:
    """Something that the file does not say, or that may be read in another way."""

    what: str
    """The parameter that sets it by hand."""
    value: str
    """What was assumed."""
    why: str
    alternatives: list[str]
    """Values of the parameter that are possible as well."""


@answer
class RowLeftOut:
    """A row that is not used."""

    line: int
    """Its number in the file, from 1."""
    why: str


@answer
class Report:
    """How a file was read."""

    format: str
    """Id of the format."""
    unit: str
    """Of the abscissa in the file."""
    columns: str
    """What the columns are, of the first table."""
    sign: Sign
    """n+ik or n-ik, as the file writes an index that absorbs."""
    order: Order
    """Of the abscissa in the file."""
    relative_to: Reference | None
    """What n is relative to; null where nothing says it."""
    assumed: list[Assumed]
    left_out: list[RowLeftOut]
    merged: int
    """Points at the wavelength of another one, which are part of its mean."""
    n_range_nm: Range
    k_range_nm: Range | None
    """Null where k is not known."""
    points_given: int
    """Of n and k together; none of a formula, which is kept as it is."""
    points_kept: int
    """Those that `material` carries: as few as linear interpolation needs."""
    largest_difference_n: float
    """From the points given, with linear interpolation between those that are kept: at most 1e-5,
    unless a warning says otherwise."""
    largest_difference_k: float | None
    warnings: list[str]


@answer
class ReadSpectrum:
    """n and k that the material carries; null where one is not known."""

    wavelength_nm: Values
    n: Gaps
    k: Gaps | None


@answer
class ReadMaterial:
    """A material out of a file."""

    material: str
    """An id that every route takes; it carries the data, and no server keeps them."""
    name: str
    report: Report
    spectrum: ReadSpectrum


def read_material(
    files: Sequence[tuple[str, bytes]], choices: Choices | None = None
) -> ReadMaterial:
    """Read a file, or two that hold eta and k.

    Parameters
    ----------
    files
        Names and contents.
    choices
        What is set by hand.

    Raises
    ------
    Unreadable, Undecided, NotAllowed
        As `read` does.
    """
    reading = read(files, choices)
    made = write(
        OwnData(name=reading.name, relative_to=reading.relative_to, n=reading.n, k=reading.k)
    )
    spectrum = own(made.token).spectrum
    wavelength_nm = spectrum.native_wavelengths(*spectrum.known_range_nm)
    warnings = list(reading.warnings)
    if made.is_coarse:
        warnings.append(
            f"too many points, or too noisy ones, for an id: {made.points_kept} stand for "
            f"{made.points_given}; largest differences below"
        )
    report = filled(
        Report,
        made,
        format=reading.format,
        unit=reading.unit,
        columns=",".join(reading.columns),
        sign=reading.sign,
        order=reading.order,
        relative_to=reading.relative_to,
        assumed=[
            filled(Assumed, one, alternatives=list(one.alternatives)) for one in reading.assumed
        ],
        left_out=[filled(RowLeftOut, row) for row in reading.left_out],
        merged=reading.merged,
        n_range_nm=spectrum.n_range_nm,
        k_range_nm=spectrum.k_range_nm,
        warnings=[*warnings, *spectrum.unknown_k],
    )
    return ReadMaterial(
        material=made.token,
        name=reading.name,
        report=report,
        spectrum=ReadSpectrum(
            wavelength_nm=wavelength_nm,
            n=spectrum.n_or_nan(wavelength_nm),
            k=spectrum.k_or_nan(wavelength_nm),
        ),
    )
