"""`/films`: thin films over the wavelength, their colors, and thicknesses that reach something."""

import re
from typing import Annotated, Any, ClassVar, Self

import numpy as np
from fastapi import APIRouter, Query
from pydantic import BeforeValidator, Field, model_validator

from app.answers.axes import MOST_STEPS
from app.answers.film_colors import FilmColors, Quantity, film_colors
from app.answers.film_media import FilmMedia, Side
from app.answers.film_shortcuts import FilmModelList, film_model_list
from app.answers.film_solve import FilmSolutions, Target, film_solutions
from app.answers.film_spectrum import FilmSpectrum, film_spectrum
from app.answers.materials.about import refuse_more_than
from app.answers.pane import PaneCurves, pane_curves
from app.api.materials.queries import ColorQuery, FrontQuery
from app.api.model_parameters import each_once
from app.api.params import (
    AngleQuery,
    equal_samples,
    layers,
    number,
    preset_name,
    refuse_beside,
    wavelength,
)
from app.http.problems import BadParameters
from app.http.query import Count, DigitsQuery, LongQuery, Number, TableQuery
from app.http.route import QueryRoute
from app.materials.films import read_layers
from app.optics.errors import NotAllowed, OpticsError
from app.optics.incidence import Incidence
from app.optics.pane import (
    ABSORPTION_PER_M,
    ASHRAE_B,
    MARTIN_RUIZ_A_R,
    N_BEHIND,
    N_PANE,
    THICKNESS_MM,
    Pane,
)
from app.optics.parameters import (
    K_T,
    N_T,
    THETA_I_DEG,
    THETA_I_RAD,
    THICKNESS_NM,
    Array,
    Parameter,
)

_NUMBER = r"(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?"
_SWEEP = re.compile(rf"\s*({_NUMBER})\s*\.\.\s*({_NUMBER})\s*:\s*(\d+)\s*")
_MOST_NUMBERS = 2000
_MOST_AT_ONCE = 4000
"""Wavelengths times layers that are computed without the pool, about 7 ms."""
SWEEP = "first..last:steps, or numbers separated by commas"


class FilmQuery(FrontQuery):
    """Two media and the films between them, at every wavelength."""

    layers: str = layers("Materials are evaluated at every wavelength.", required=True)
    n_t: Number = number(N_T, examples=[1.5])
    k_t: Number = number(K_T, examples=[0.0])
    material: str | None = preset_name(
        "Id or alias of a preset with a spectrum, in place of n_t and k_t.", "BK7"
    )

    without_thickness: ClassVar[bool] = False
    """Whether a layer may come without its thickness."""

    @model_validator(mode="after")
    def _one_second_medium(self) -> Self:
        refuse_beside(self, "material", "n_t", "k_t")
        return self

    def media(self) -> FilmMedia:
        """Look up the media.

        Raises
        ------
        OpticsError
            If the layers cannot be read, or there is no such preset.
        """
        films = read_layers(self.layers, without_thickness=self.without_thickness)
        return FilmMedia(self.front(), films, Side(complex(self.n_t, self.k_t), self.material))


class FilmSpectrumQuery(FilmQuery, AngleQuery, TableQuery):
    """R, T and A over the wavelength."""

    minimum_nm: Number = wavelength(380.0, "Shortest wavelength, in nm.")
    maximum_nm: Number = wavelength(780.0, "Longest wavelength, in nm.")
    step_nm: Number = wavelength(1.0, "Distance of the wavelengths, in nm.")

    def wavelengths_nm(self) -> Array:
        """The wavelengths.

        Raises
        ------
        NotAllowed
            If they are in the wrong order, or too many.
        """
        low, high, step = self.minimum_nm, self.maximum_nm, self.step_nm
        if low > high:
            raise NotAllowed("minimum_nm", low, f"at most maximum_nm = {high:.10g}")
        count = int((high - low) / step + 1e-9) + 1
        refuse_more_than("step_nm", step, count, "wavelengths", MOST_STEPS)
        return np.asarray(low + step * np.arange(count))

    def evaluated(self) -> FilmSpectrum:
        """Evaluate the films.

        Raises
        ------
        OpticsError
            If a medium is not known at a wavelength: it names the end that is beyond what is known.
        """
        try:
            return film_spectrum(self.media(), self.theta_i_deg, self.wavelengths_nm())
        except OpticsError as error:
            if error.parameter == "wavelength_nm":
                middle = 0.5 * (self.minimum_nm + self.maximum_nm)
                below = isinstance(error.value, float) and error.value < middle
                error.parameter = "minimum_nm" if below else "maximum_nm"
                error.value = getattr(self, error.parameter)
            raise

    @property
    def takes_long(self) -> bool:
        """Whether it is more than the few milliseconds that a page waits for while it draws."""
        count = (self.maximum_nm - self.minimum_nm) / self.step_nm
        return count * (1 + self.layers.count(",")) > _MOST_AT_ONCE


def _numbers(parameter: Parameter) -> BeforeValidator:
    """Read `first..last:steps` or numbers separated by commas, within the bounds of a parameter."""

    def read(given: object) -> object:
        if not isinstance(given, str):
            return given
        sweep = _SWEEP.fullmatch(given)
        if sweep:
            first, last, steps = float(sweep[1]), float(sweep[2]), int(sweep[3])
            if not 2 <= steps <= MOST_STEPS or first >= last:
                raise ValueError(f"{SWEEP}; first below last, 2 to {MOST_STEPS} steps")
            values = np.linspace(first, last, steps).tolist()
        else:
            parts = given.split(",")
            if len(parts) > _MOST_NUMBERS or not all(
                re.fullmatch(rf"\s*{_NUMBER}\s*", part) for part in parts
            ):
                raise ValueError(SWEEP)
            values = [float(part) for part in parts]
        if not parameter.admits(np.array(values)).all():
            raise ValueError(f"each {parameter.allowed}")
        return tuple(values)

    return BeforeValidator(read, json_schema_input_type=str)


Thicknesses = Annotated[tuple[float, ...], _numbers(THICKNESS_NM)]
Angles = Annotated[tuple[float, ...], _numbers(THETA_I_DEG)]
Radians = Annotated[tuple[float, ...], _numbers(THETA_I_RAD)]


def _layer_number(what: str) -> Any:
    return Field(
        1, ge=1, le=1000, description=f"Number of the layer {what}, from 1 at the incident side."
    )


class FilmColorQuery(FilmQuery, ColorQuery, TableQuery, LongQuery):
    """Colors over the thickness of one layer and the angle."""

    without_thickness = True

    layer: Count = _layer_number("whose thickness varies")
    thickness_nm: Thicknesses = Field(
        ...,
        description=f"Thicknesses of that layer in nm: {SWEEP}.",
        examples=["0..1000:256", "100,200,300"],
    )
    theta_i_deg: Angles | None = Field(
        None,
        description=f"Angles of incidence in degrees: {SWEEP}. 0 unless given.",
        examples=["0,45,60"],
    )
    theta_i_rad: Radians | None = Field(
        None,
        description=f"The angles in radians, in place of theta_i_deg: {SWEEP}. The double nearest "
        "pi/2 counts as 90 degrees.",
        examples=["0,0.5,1"],
    )
    samples: Count | None = Field(
        None, ge=2, le=2000, description="Equally spaced angles from 0 to 90 degrees instead."
    )
    models: str = Field(
        "exact",
        max_length=500,
        description="Comma-separated: `exact`, and ids of shortcuts of renderers, as listed at "
        "/films/models, for one film in air. What is exact always comes first.",
        examples=["exact,gltf_iridescence"],
    )
    quantity: Quantity = Field(
        "R",
        description="Colors of the light that is reflected, `R`, or of what enters the second "
        "medium, `T`.",
    )

    def refuse_beyond(self, max_samples: int, max_cells: int) -> None:
        """Refuse more than an operator lets the server compute at once."""
        super().refuse_beyond(max_samples, max_cells)
        count = len(self.thickness_nm)
        cells = count * (self.samples or len(self.theta_i_rad or self.theta_i_deg or (0.0,)))
        if cells > max_cells:
            message = f"this server computes at most {max_cells} colors (FRESNEL_MAX_CELLS)"
            raise BadParameters({"parameter": "thickness_nm", "value": count, "message": message})

    def incidence(self) -> Incidence:
        """The directions.

        Raises
        ------
        NotAllowed
            If they are given twice.
        """
        given = [name for name in ("theta_i_rad", "theta_i_deg", "samples") if getattr(self, name)]
        for name in given[1:]:
            raise NotAllowed(name, getattr(self, name), f"not beside {given[0]}")
        if self.theta_i_rad is not None:
            return Incidence.from_radians(self.theta_i_rad)
        if self.samples is not None:
            return Incidence.from_degrees(np.linspace(0.0, 90.0, self.samples))
        return Incidence.from_degrees(self.theta_i_deg or (0.0,))

    def shortcuts(self) -> list[str]:
        """Ids of the shortcuts.

        Raises
        ------
        NotAllowed
            If one is given twice.
        """
        return [name for name in each_once(self.models, str) if name != "exact"]


class FilmSolveQuery(FilmQuery, AngleQuery, DigitsQuery, LongQuery):
    """Thicknesses that reach something."""

    without_thickness = True

    target: Target = Field(
        "minimum_R",
        description="`minimum_R`: least reflectance of unpolarized light at wavelength_nm; `color`: "
        "the color nearest to `color` by CIEDE2000; `quarter_wave`: every layer a quarter of "
        "wavelength_nm thick, at this angle.",
    )
    layer: Count = _layer_number("whose thickness is looked for")
    wavelength_nm: Number = wavelength(550.0, "Wavelength in nm; of a color R is told there.")
    thickness_nm: Thicknesses = Field(
        tuple(np.linspace(0.0, 1000.0, 1001).tolist()),
        description=f"Where to look, in nm: {SWEEP}; 0..1000:1001 unless given. The best are found "
        "between two of them.",
        examples=["0..500:501"],
    )
    color: str | None = Field(
        None, max_length=7, description="The wanted color in sRGB.", examples=["#8040c0"]
    )
    repeat: Count = Field(
        1, ge=1, le=500, description="How often the layers follow one another, of quarter waves."
    )

    def solutions(self) -> FilmSolutions:
        """Look for them.

        Raises
        ------
        NotAllowed
            If something is given that the target does not depend on.
        """
        uses = {
            "minimum_R": {"layer", "thickness_nm"},
            "color": {"layer", "thickness_nm", "color"},
            "quarter_wave": {"repeat"},
        }[self.target]
        for name in ("layer", "thickness_nm", "color", "repeat"):
            if name in self.model_fields_set and name not in uses:
                raise NotAllowed(name, getattr(self, name), f"not with target = {self.target}")
        return film_solutions(
            self.media(),
            self.target,
            wavelength_nm=self.wavelength_nm,
            theta_i_deg=self.theta_i_deg,
            layer=self.layer,
            thickness_nm=np.array(self.thickness_nm),
            repeat=self.repeat,
            color=self.color,
        )


class PaneQuery(TableQuery):
    """A pane, and the modifiers' own parameters."""

    n: Number = number(N_PANE)
    thickness_mm: Number = number(THICKNESS_MM)
    absorption_per_m: Number = number(ABSORPTION_PER_M)
    n_behind: Number = number(N_BEHIND)
    samples: Count = equal_samples(91)
    b: Number = number(ASHRAE_B, alias="ashrae.b")
    a_r: Number = number(MARTIN_RUIZ_A_R, alias="martin_ruiz.a_r")

    def pane(self) -> Pane:
        """The pane."""
        return Pane(self.n, self.thickness_mm, self.absorption_per_m, self.n_behind)


def router() -> APIRouter:
    """Routes about films."""
    routes = APIRouter(route_class=QueryRoute, tags=["films"])

    @routes.get("/films/spectrum", summary="R, T and A of films over the wavelength")
    def spectrum(query: Annotated[FilmSpectrumQuery, Query()]) -> FilmSpectrum:
        return query.evaluated()

    @routes.get("/films/color", summary="Colors of films over thickness and angle")
    def color(query: Annotated[FilmColorQuery, Query()]) -> FilmColors:
        thickness_nm = np.array(query.thickness_nm)
        return film_colors(
            query.media(),
            query.layer,
            thickness_nm,
            query.incidence(),
            query.viewing(),
            query.quantity,
            query.shortcuts(),
        )

    @routes.get(
        "/films/models", summary="Shortcuts of renderers for films, and how far they are off"
    )
    def models(query: Annotated[DigitsQuery, Query()]) -> FilmModelList:  # noqa: ARG001
        return film_model_list()

    @routes.get("/films/solve", summary="Thicknesses for least R, a color, or quarter waves")
    def solve(query: Annotated[FilmSolveQuery, Query()]) -> FilmSolutions:
        return query.solutions()

    @routes.get("/films/pane", summary="A pane over the angle, and incidence-angle modifiers")
    def pane(query: Annotated[PaneQuery, Query()]) -> PaneCurves:
        return pane_curves(query.pane(), query.samples, {"b": query.b, "a_r": query.a_r})

    return routes
