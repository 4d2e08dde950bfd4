"""Tables for a renderer, each with the measured error of reading between its texels."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Annotated, Any, Self

import numpy as np

from app.answers.answer import SentAs, Table, answer
from app.answers.axes import INDICES, Axis, held, interfaces, refuse_many_cells
from app.answers.curves import Chosen
from app.answers.film_colors import seen_over_angle
from app.answers.film_media import FilmMedia, MediaFacts
from app.answers.films import Coated, LayerFacts, convention_text
from app.answers.interface import CONVENTION, InterfaceFacts
from app.answers.materials.about import refuse_more_than
from app.materials.appearance import color_curve
from app.materials.spectrum import Spectrum
from app.optics.albedo import albedo
from app.optics.errors import NotAllowed
from app.optics.films import reflectances
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.lookup import Depth, TableError, line_error, quantize, sheet_error
from app.optics.parameters import Array

MOST_TEXELS = 4096
"""Texels along one axis."""

MOST_LAYERS_OF_COLORS = 50
"""In a table of colors, whose error wants a whole spectrum at thousands of angles."""

_MOST_WAVELENGTHS = 500
"""Times layers, of errors of tables of colors of all sizes: seconds of work."""

_FEW_TEXELS = 256
"""Beyond these the error wants more angles."""

SIZES = tuple(2**power for power in range(1, 13))
"""Sizes whose errors are listed."""

DEPTHS: tuple[Depth, ...] = ("unorm8", "unorm16", "float")

READING = (
    "texel j of N stands at the j-th of N equally spaced values, both ends included; sample a "
    "texture at (x (N - 1) + 1/2) / N, x from 0 to 1 between the ends, with linear filtering"
)


@answer
class TableAxis:
    """What one direction of the table runs over."""

    name: str
    minimum: float
    maximum: float
    size: int

    @property
    def values(self) -> Array:
        """Coordinates of the texels."""
        return np.linspace(self.minimum, self.maximum, self.size)


@answer
class InterpolationError:
    """The largest error of what is read between the texels."""

    max_abs: float
    """Measured, rounding of the texels included; rounded up."""
    at: dict[str, float]
    """Where it is reached."""


@answer
class LookupTable:
    """A lookup table."""

    model: str
    quantity: str
    warnings: list[str]
    interface: InterfaceFacts | None
    """Null where an index varies."""
    n_i: float
    n_t: float | None
    k_t: float | None
    convention: str = CONVENTION
    axes: list[TableAxis]
    """The innermost, along a row, first."""
    channels: list[str]
    depth: Depth
    reading: str = READING
    error: InterpolationError
    texels: Annotated[Array, SentAs(list[Any])]
    """Rows of the last axis; a list where channels are three."""

    @property
    def pixels(self) -> Array:
        """Texels as those of a picture, of shape (rows, size, channels)."""
        return self.texels.reshape(-1, self.axes[0].size, len(self.channels))

    def filename(self, kind: str) -> str:
        """Name for a file of this kind."""
        return "_".join([self.model, *self._names, f"{self.axes[0].size}.{kind}"])

    def title(self) -> str:
        """What is tabulated, in words."""
        fixed = {name: getattr(self, name) for name in INDICES}
        media = ", ".join(f"{name} = {n:g}" for name, n in fixed.items() if n is not None)
        return f"{self.quantity} of {self.model} over {','.join(self._names)}, {media}"

    @property
    def _names(self) -> list[str]:
        return [axis.name for axis in self.axes]

    def table(self) -> Table:
        """Lay out a row each texel."""
        grid = np.meshgrid(*(axis.values for axis in self.axes))
        columns = {n: values.ravel() for n, values in zip(self._names, grid, strict=True)}
        columns |= {c: self.pixels[..., i].ravel() for i, c in enumerate(self.channels)}
        return Table(columns, self.filename("csv"))


@answer
class CoatedLookupTable(LookupTable):
    """A lookup table of a surface with layers on it; `interface` is that without them."""

    wavelength_nm: float
    layers: list[LayerFacts]
    """From the incident side on."""


@answer
class FilmLookupTable(LookupTable):
    """A lookup table of the colors of films; `interface` is that without them, at one wavelength."""

    media: MediaFacts
    """The media over the wavelength, and the layers."""


@answer
class LookupErrors:
    """Errors of tables of many sizes."""

    model: str
    quantity: str
    n_i: float
    n_t: float | None
    k_t: float | None
    over: str
    sizes: list[int]
    max_abs: dict[Depth, list[float | None]]
    """By depth: the largest error a size; null where the texels cannot hold the values."""


@dataclass(frozen=True)
class Tabulated:
    """A function that a table is made of."""

    model: str
    quantity: str
    fixed: Interface
    """The interface, or that whose other indices hold."""
    axes: tuple[TableAxis, ...]
    """One or two; the innermost first."""
    function: Callable[..., Array]
    """Coordinates of any shape, an argument each axis, to values with channels as a last axis."""
    warnings: tuple[str, ...] = ()
    coated: Coated | None = None
    """The boundary with layers on it, where there are any, at one wavelength."""
    media: FilmMedia | None = None
    """The media and layers, where R is one of colors."""
    work: int = 1
    """Wavelengths times layers behind each value."""

    def remembering(self) -> Self:
        """The same over one coordinate, evaluated once where it is asked for again."""

        @lru_cache(maxsize=8)
        def found(at: bytes, shape: tuple[int, ...]) -> Array:
            return self.function(np.frombuffer(at).reshape(shape))

        return replace(self, function=lambda at: found(at.tobytes(), at.shape))

    def values(self) -> Array:
        """Evaluate at the texels, of shape (rows, size, channels).

        Raises
        ------
        NotAllowed
            If the model is undefined at one.
        """
        along, *rows = (axis.values for axis in self.axes)
        values = self.function(along, *(row[:, np.newaxis] for row in rows))
        if not np.isfinite(values).all():
            raise NotAllowed("model", self.model, "one that is defined over the whole table")
        return values if rows else values[np.newaxis]

    def error(self, texels: Array) -> TableError:
        """Measure the largest error between quantized texels."""
        along, *across = ((axis.minimum, axis.maximum) for axis in self.axes)
        if across:
            return sheet_error(texels, (along, across[0]), self.function)
        return line_error(texels[0], along, self.function)


def reflectance_over_mu(chosen: Chosen, interface: Interface, size: int) -> Tabulated:
    """Tabulate R over mu, in one channel or, of a color, three."""
    arguments = chosen.arguments(interface)

    def values(mu: Array) -> Array:
        R = chosen.model.evaluate(interface, Incidence.from_cosine(mu.ravel()), arguments)
        return np.moveaxis(np.atleast_2d(R), 0, -1).reshape(*mu.shape, -1)

    return Tabulated(chosen.model.id, "R", interface, (_mu(size),), values)


def coated_over_mu(coated: Coated, size: int) -> Tabulated:
    """Tabulate R over mu where there are layers."""

    def values(mu: Array) -> Array:
        Rs, Rp = reflectances(coated.stack, Incidence.from_cosine(mu))
        return np.asarray(0.5 * (Rs + Rp))[..., np.newaxis]

    return Tabulated("exact", "R", coated.interface, (_mu(size),), values, (), coated)


def color_over_mu(spectrum: Spectrum, interface: Interface, size: int) -> Tabulated:
    """Tabulate R, G and B over mu, integrated from a spectrum."""
    n_i = float(interface.n_i)

    def values(mu: Array) -> Array:
        return color_curve(spectrum, Incidence.from_cosine(mu), n_i)

    warnings = spectrum.visible.warnings
    return Tabulated("exact", "R in linear sRGB", interface, (_mu(size),), values, warnings)


def film_color_over_mu(media: FilmMedia, interface: Interface, size: int) -> Tabulated:
    """Tabulate R, G and B of films over mu, integrated from the whole spectrum.

    Raises
    ------
    OpticsError
        If there are more layers than a table of that size has time for, or a medium has no spectrum.
    """
    most = MOST_LAYERS_OF_COLORS * _FEW_TEXELS // max(size, _FEW_TEXELS)
    what = f"layers over {size} texels in color"
    refuse_more_than("layers", len(media.layers), len(media.layers), what, most)
    colors, wavelengths, warnings = seen_over_angle(media)

    def values(mu: Array) -> Array:
        found = colors(Incidence.from_cosine(mu.ravel()))
        return found.reshape(*mu.shape, 3)

    axes = (_mu(size),)
    told = tuple(warnings)
    work = wavelengths * len(media.layers)
    return Tabulated("exact", "R in linear sRGB", interface, axes, values, told, None, media, work)


def albedo_over_index(chosen: Chosen, fixed: Interface, axis: Axis) -> Tabulated:
    """Tabulate the albedo over an index; of no model but exact."""
    if chosen.model.id != "exact":
        raise NotAllowed("model", chosen.model.id, "exact where the table is one of albedos")

    def values(index: Array) -> Array:
        shares = albedo(interfaces(fixed, {axis.name: index.ravel()})).unpolarized
        return shares.reshape(*index.shape, 1)

    return Tabulated("exact", "albedo", fixed, (_index(axis),), values)


def reflectance_over_mu_and_index(
    chosen: Chosen, fixed: Interface, axis: Axis, size: int
) -> Tabulated:
    """Tabulate R over mu, `size` texels, and an index; of one color."""
    refuse_many_cells("rows", size=size, rows=axis.values.size)
    model, given = chosen.model, chosen.of_one_color().given

    def values(mu: Array, index: Array) -> Array:
        interface = interfaces(fixed, {axis.name: index})
        arguments = model.arguments(interface, **given)
        return model.evaluate(interface, Incidence.from_cosine(mu), arguments)[..., np.newaxis]

    return Tabulated(model.id, "R", fixed, (_mu(size), _index(axis)), values)


def lookup_table(tabulated: Tabulated, depth: Depth) -> LookupTable:
    """Make a table, and measure how far what is read from it is off.

    Raises
    ------
    NotAllowed
        If the texels cannot hold a value.
    """
    texels = quantize(tabulated.values(), depth)
    worst, axes = tabulated.error(texels), tabulated.axes
    names = [axis.name for axis in axes]
    channels = [tabulated.quantity] if texels.shape[-1] == 1 else ["red", "green", "blue"]
    # Without the axes that only pictures need.
    plain = texels[0] if len(axes) == 1 else texels
    plain = plain[..., 0] if len(channels) == 1 else plain
    coated, media = tabulated.coated, tabulated.media
    kind: Any = LookupTable
    more: dict[str, Any] = {}
    if coated is not None:
        kind = CoatedLookupTable
        told = convention_text(layers=True)
        more = {
            "wavelength_nm": coated.wavelength_nm,
            "layers": coated.layers,
            "convention": told,
        }
    elif media is not None:
        kind = FilmLookupTable
        more = {"media": media.facts(), "convention": convention_text(layers=True)}
    table: LookupTable = kind(
        model=tabulated.model,
        quantity=tabulated.quantity,
        warnings=[*tabulated.warnings],
        interface=InterfaceFacts.of(tabulated.fixed) if names == ["mu"] else None,
        **held(tabulated.fixed, *names),
        axes=[*axes],
        channels=channels,
        depth=depth,
        error=InterpolationError(max_abs=worst.max_abs, at=dict(zip(names, worst.at, strict=True))),
        texels=np.ascontiguousarray(plain),
        **more,
    )
    return table


def lookup_errors(of_size: Callable[[int], Tabulated]) -> LookupErrors:
    """Measure tables of all sizes and depths, of a function that is tabulated in any size."""
    found: dict[Depth, list[float | None]] = {depth: [] for depth in DEPTHS}
    # All of them first: what is refused of the largest is refused before there is any work.
    tables = [of_size(size).remembering() for size in SIZES]
    what = "layers times wavelengths, of which a thick layer wants more,"
    refuse_more_than("layers", tables[0].work, tables[0].work, what, _MOST_WAVELENGTHS)
    for tabulated in tables:
        values = tabulated.values()
        for depth, errors in found.items():
            try:
                texels = quantize(values, depth)
            except NotAllowed:
                errors.append(None)
            else:
                errors.append(tabulated.error(texels).max_abs)
    (axis,) = tabulated.axes
    return LookupErrors(
        model=tabulated.model,
        quantity=tabulated.quantity,
        **held(tabulated.fixed, axis.name),
        over=axis.name,
        sizes=[*SIZES],
        max_abs=found,
    )


def _mu(size: int) -> TableAxis:
    return TableAxis(name="mu", minimum=0.0, maximum=1.0, size=size)


def _index(axis: Axis) -> TableAxis:
    low, high = float(axis.values[0]), float(axis.values[-1])
    return TableAxis(name=axis.name, minimum=low, maximum=high, size=axis.values.size)
