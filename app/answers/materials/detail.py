"""All that is known of one material: constants, color, provenance and rivals."""

from dataclasses import fields

from app.answers.answer import answer, filled
from app.answers.materials.about import Rgb
from app.answers.materials.listing import Material, Swatch, hex_of, in_gamut
from app.materials.appearance import DAYLIGHT, Appearance, Viewing, appearance
from app.materials.catalog import Spread
from app.materials.colored import colored
from app.materials.media import default_catalog, resolve_material
from app.materials.schema import (
    Channels,
    Color,
    Confidence,
    Database,
    Preset,
    Provenance,
    RelativeTo,
    Sample,
)
from app.optics.color import (
    TRANSFER,
    Adaptation,
    Gamut,
    Illuminant,
    Observer,
)
from app.optics.interface import Interface
from app.optics.parameters import Array
from app.optics.specular import F82


@answer
class Seen:
    """Under which light, by which observer a color is seen."""

    illuminant: Illuminant
    observer: Observer
    adaptation: Adaptation


@answer
class SeenColor(Color, Seen):  # the fields of Seen come first
    """Linear sRGB in full precision, with the light and the observer."""

    outside_0_to_1: tuple[str, ...]
    """Which of F0, F82 and F82_tint have channels outside 0 to 1, where engines cut or refuse them;
    `display` has all three within, by a policy."""


@answer
class Constants:
    """Constants at one wavelength, with what they give from vacuum."""

    wavelength_nm: float | None
    n: float
    """Relative to what the source measured it."""
    n_absolute: float
    """The same against vacuum."""
    k: float | None
    F0: float
    F82: float
    """Exact reflectance at cos(theta_i) = 1/7."""


@answer
class Look:
    """F0, F82 and tint by a gamut policy, linear."""

    F0: Rgb
    F82: Rgb
    F82_tint: Rgb


@answer
class LookCodes:
    """F0, F82 and tint as #rrggbb; null where unclamped channels leave 0 to 1."""

    F0: str | None
    F82: str | None
    F82_tint: str | None


@answer
class Display(Swatch):
    """The color by a gamut policy."""

    F0: Rgb
    """Linear sRGB."""
    F82: Rgb
    """Linear sRGB."""
    F82_tint: Rgb
    """The tint that belongs to this F0 and F82."""
    in_gamut: bool
    """Whether the unclamped F0 is within 0 and 1."""
    acescg: Look
    """The same three in linear ACEScg, the policy applied there."""
    codes: LookCodes
    """The same three in sRGB as #rrggbb, for fields that take no numbers."""
    transfer: str
    """The curve that `hex` and `codes` are encoded by; all numbers are linear."""


@answer
class Rival:
    """Another measurement of the same material."""

    id: str
    name: str
    n: float
    n_absolute: float
    k: float | None
    wavelength_nm: float | None
    relative_to: RelativeTo
    sample: Sample
    confidence: Confidence
    source: str
    F0: Channels
    """Linear sRGB under D65, not clamped."""
    luminance: float


_TOLD = tuple(field.name for field in fields(Rival) if field.name not in {"F0", "luminance"})


@answer
class MaterialDetail(Material):
    """All that is known of a preset."""

    color: SeenColor
    constants: Constants
    display: Display
    conditions: dict[str, float | str]
    """Keys carry their unit."""
    provenance: Provenance | None
    """Null for an index out of a table."""
    rivals: list[Rival]
    spread: Spread
    database: Database


def detail(
    preset: Preset,
    *,
    wavelength_nm: float | None = None,
    viewing: Viewing = DAYLIGHT,
    gamut: Gamut = "scaled",
) -> MaterialDetail:
    """Tell all that is known of a preset.

    Parameters
    ----------
    preset
        The material.
    wavelength_nm
        Where the constants are evaluated, by default its reference wavelength.
    viewing
        How its colors are made.
    gamut
        What is done about colors that sRGB cannot show.

    Raises
    ------
    WavelengthOutOfRange, OutOfRange, NotAllowed
        As `resolve_material` does.
    """
    catalog = default_catalog()
    color = appearance(colored(preset), 1.0, viewing)
    file = catalog.spectrum(preset.id).file if preset.kind == "spectrum" else None
    display = _display(color, gamut, viewing.observer)
    return MaterialDetail(
        **vars(preset)
        | {
            "color": SeenColor(
                **viewing._asdict(),
                F0=_channels(color.F0),
                F82=_channels(color.F82),
                F82_tint=_channels(color.F82_tint),
                luminance=color.luminance,
                outside_0_to_1=color.outside,
            )
        },
        swatch=Swatch(gamut=gamut, hex=display.hex),
        constants=_constants(preset, wavelength_nm),
        display=display,
        conditions={} if file is None else file.conditions,
        provenance=None if file is None else file.provenance,
        rivals=[
            Rival(
                **{name: getattr(other, name) for name in _TOLD},
                F0=other.color.F0,
                luminance=other.color.luminance,
            )
            for other in catalog.rivals(preset.id)
        ],
        spread=catalog.spread(preset.id),
        database=catalog.database,
    )


def _constants(preset: Preset, wavelength_nm: float | None) -> Constants:
    at = resolve_material(preset.id, wavelength_nm).constants
    boundary = Interface(1.0, at.n_absolute, at.k or 0.0)
    return Constants(
        wavelength_nm=at.wavelength_nm,
        n=at.n,
        n_absolute=at.n_absolute,
        k=at.k,
        F0=float(boundary.F0),
        F82=float(F82(boundary)),
    )


def _display(color: Appearance, gamut: Gamut, observer: Observer) -> Display:
    shown = color.within(gamut)
    wide = color.in_space("acescg", observer).within(gamut)
    return Display(
        gamut=gamut,
        hex=hex_of(shown.F0),
        F0=shown.F0,
        F82=shown.F82,
        F82_tint=shown.F82_tint,
        in_gamut=in_gamut(color.F0),
        acescg=filled(Look, wide),
        codes=LookCodes(
            F0=hex_of(shown.F0), F82=hex_of(shown.F82), F82_tint=hex_of(shown.F82_tint)
        ),
        transfer=TRANSFER,
    )


def _channels(rgb: Array) -> Channels:
    red, green, blue = rgb.tolist()
    return red, green, blue
