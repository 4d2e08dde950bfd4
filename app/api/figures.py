"""`/figures`: Plotly figures of what other routes answer, as JSON, a page or a picture."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from textwrap import wrap
from typing import TYPE_CHECKING, Annotated, Any, Literal
from urllib.parse import urlencode

from fastapi import APIRouter, Query
from pydantic import BaseModel, Field, create_model
from starlette.exceptions import HTTPException
from starlette.responses import Response
from typing_extensions import TypedDict

from app import __version__
from app.answers.answer import answer
from app.answers.errors import Errors
from app.answers.looks import Theme, theme_colors
from app.answers.rounding import rounded
from app.api import PREFIX
from app.api.params import AngleQuery, preset_name
from app.api.table import RouteTable
from app.figures.look import Ground, Look
from app.figures.pictures import NoPictures, PictureFailed, Pictures, Size
from app.figures.render import MEDIA_TYPES, page, policy
from app.http.problems import BadParameters
from app.http.query import Count, LongQuery, Number, QueryModel
from app.http.route import QueryRoute
from app.http.writing import shown_as
from app.optics.albedo import FITS, Fit
from app.optics.registry import Model, Registry
from app.server.pool import Overloaded

if TYPE_CHECKING:
    import plotly.graph_objects as go

Format = Literal["json", "html", "svg", "png", "pdf"]

# Of a picture for which no size is asked, in px.
_WIDTH, _HEIGHT = 960, 600
_SCALE = 2
"""Dots a px, as screens have them today."""
_MOST_DOTS = 16_000_000
"""Of a PNG; four times as many took a browser 20 s and 1.5 GB."""


class FigureQuery(LongQuery):
    """How a figure looks, and as what it is sent."""

    format: Format = Field(
        "json",
        description="Plotly's JSON, which plotly.io.from_json reads; a page that holds all it "
        "needs; or a picture, where the server has Kaleido and a browser.",
    )
    theme: Theme = Field("light", description="Colors on a light or a dark ground.")
    background: Ground = Field("paper", description="Ground: the page's paper, white or none.")
    width: Count | None = Field(
        None, ge=240, le=4000, description="Width in px; all there is, or 960 of a picture."
    )
    height: Count | None = Field(
        None, ge=200, le=4000, description="Height in px; all there is, or 600 of a picture."
    )
    font_px: Number = Field(
        14.0, ge=6.0, le=60.0, allow_inf_nan=False, description="Size of the text in px."
    )
    caption: bool = Field(True, description="Write the sources and the request below the figure.")

    @property
    def is_picture(self) -> bool:
        """Whether a browser draws it."""
        return self.format not in ("json", "html")

    @property
    def picture_size(self) -> Size:
        """How large a picture is to be."""
        return Size(self.width or _WIDTH, self.height or _HEIGHT, _SCALE)

    def refuse_beyond(self, max_samples: int, max_cells: int) -> None:
        """Refuse pictures of too many dots, beside what is too much to compute.

        Raises
        ------
        BadParameters
            Naming what there is too much of.
        """
        super().refuse_beyond(max_samples, max_cells)
        width, height, scale = self.picture_size
        if self.format == "png" and width * height * scale**2 > _MOST_DOTS:
            most = _MOST_DOTS // scale**2
            message = (
                f"width times height of a PNG is at most {most}, here {width * height}; "
                "svg and pdf have no such bound"
            )
            raise BadParameters({"parameter": "width", "value": width, "message": message})


class MaterialName(QueryModel):
    """Which material."""

    material: str | None = preset_name(
        "Id or alias of a preset with a spectrum; Au by default.", "Au"
    )


class PlotlyFigure(TypedDict):
    """A Plotly figure."""

    data: Annotated[list[dict[str, Any]], Field(description="Traces.")]
    layout: dict[str, Any]


class Drawing(Response):
    """A figure as it is sent, and as it was drawn for those within the process."""

    def __init__(
        self, figure: go.Figure, body: bytes, form: Format, headers: Mapping[str, str]
    ) -> None:
        super().__init__(body, headers=headers, media_type=MEDIA_TYPES[form])
        self.figure = figure


@answer
class FigureKind:
    """One kind of figure."""

    name: str
    title: str
    request: str
    """Path of the figure; its parameters are those of `of`."""
    of: str
    """Path whose answer is drawn."""


@answer
class FigureKinds:
    """All kinds of figures."""

    figures: list[FigureKind]
    formats: list[str]


@dataclass(frozen=True, slots=True)
class Kind:
    """A figure that can be asked for."""

    name: str
    """In the address, and of the function in `app.figures.draw`."""
    title: str
    """What it shows."""
    of: str
    """Path of the route whose answer is drawn and whose parameters are taken."""
    more: tuple[type[QueryModel], ...] = ()
    """Parameters besides."""


KINDS = (
    Kind("explore", "A ray and the curves of its surface", "/curves", (AngleQuery,)),
    Kind("compare", "Models beside the exact curve, and their errors", "/errors"),
    Kind("errors", "One model's error over a rectangle", "/errors/map"),
    Kind("sweep", "One model's errors along a line", "/errors/sweep"),
    Kind("albedo", "Albedos along a line, and the errors of fits", "/albedo/sweep"),
    Kind(
        "material",
        "A material's reflectance, n and k",
        "/materials/{material}/curves",
        (MaterialName,),
    ),
)


def _query_of(kind: Kind, source: type[BaseModel]) -> type[FigureQuery]:
    """The parameters of a figure: how it looks, and those of the route that it is of."""
    bases: Any = (FigureQuery, *kind.more, source)
    make: Any = create_model  # whose types do not know of bases that are worked out
    made: type[FigureQuery] = make(f"{kind.name.title()}Figure", __base__=bases)
    return made


def _spelled(value: Any) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, tuple):
        return ",".join(f"{number:.12g}" for number in value)
    return f"{value:.12g}" if isinstance(value, float) else str(value)


def _request(kind: Kind, query: BaseModel) -> str:
    """Write the request again, without what only concerns the look."""
    given = query.model_dump(exclude_unset=True, by_alias=True)
    query_string = urlencode(
        {name: _spelled(v) for name, v in given.items() if name not in FigureQuery.model_fields},
        safe=",.",
    )
    return f"{PREFIX}/figures/{kind.name}" + (f"?{query_string}" if query_string else "")


def _sources(answer: Any, named: Mapping[str, Fit | Model]) -> list[str]:
    """Whom the figure's curves are from, by the models, fits and presets that are in it."""
    rows: list[Any] = answer.errors if isinstance(answer, Errors) else getattr(answer, "curves", [])
    ids = [str(getattr(row, "model", getattr(row, "id", None))) for row in (*rows, answer)]
    known = [named[name] for name in dict.fromkeys(ids) if name in named and name != "exact"]
    interface = getattr(answer, "interface", None)
    presets = [getattr(interface, name, None) for name in ("incident", "material")]
    presets.append(getattr(answer, "material", None))
    sources = [(one.title, one.reference) for one in known]
    sources += [(preset.name, preset.source) for preset in presets if preset]
    return [f"{name}: {source.rstrip('.')}." for name, source in sources]


def router(
    table: RouteTable, registry: Registry, static_dir: Path, pictures: Pictures
) -> APIRouter:
    """Routes of the figures, drawn from the answers of `table` in the look of the page's files."""
    routes = APIRouter(route_class=QueryRoute, tags=["figures"])
    # Models last, for they are drawn.
    named: Mapping[str, Fit | Model] = {**FITS, **registry}

    @cache
    def colors(theme: Theme) -> dict[str, str]:
        return theme_colors(static_dir, theme)

    def drawn(kind: Kind, query: FigureQuery) -> tuple[go.Figure, list[str], Look]:
        """The figure, its caption and its look."""
        from app.figures import draw  # Plotly takes a second and 50 MB: not before it is needed

        material = getattr(query, "material", None) or "Au"
        route, parts = table.find(kind.of.replace("{material}", material))
        assert route is not None  # noqa: S101 - every kind names a route, as a test checks
        # The query is validated already.
        answer = rounded(route.answer(parts, query), getattr(query, "digits", 17))
        size = (query.width, query.height)
        look = Look(colors(query.theme), query.background, query.font_px, *size)
        make: Callable[..., go.Figure] = getattr(draw, kind.name)
        figure, request = make(answer, draw.Context(query, look, named)), _request(kind, query)
        figure.update_layout(meta={"request": request, "version": __version__})
        texts = [*_sources(answer, named), f"Fresnel Explorer {__version__}, {request}"]
        width = query.picture_size.width
        inside = query.caption and query.format != "html"
        columns = int((width - 40) / (0.41 * query.font_px))
        lines = [line for text in texts for line in wrap(text, columns)] if inside else []
        return draw.framed(figure, lines, look, width), texts if query.caption else [], look

    def drawing(kind: Kind, query: FigureQuery) -> Drawing:
        (figure, caption, look), form = drawn(kind, query), query.format
        headers = shown_as(f"fresnel_{kind.name}.{form}")
        if form == "json":
            return Drawing(figure, str(figure.to_json()).encode(), form, headers)
        if form == "html":
            headers |= {"Content-Security-Policy": policy(static_dir)}
            body = page(figure, kind.title, caption, look, static_dir)
            return Drawing(figure, body, form, headers)
        try:
            picture = pictures.draw(str(figure.to_json()), form, query.picture_size)
        except NoPictures as error:
            detail = f"format = {form} is not to be had here: {error}; json and html are"
            raise HTTPException(406, detail) from None
        except PictureFailed as error:
            raise Overloaded(str(error)) from None
        return Drawing(figure, picture, form, headers)

    def add(kind: Kind) -> None:
        source, _ = table.find(kind.of.replace("{material}", "Au"))
        if source is None or source.query_model is None:
            raise LookupError(kind.of)

        def figure(query: FigureQuery) -> Drawing:
            return drawing(kind, query)

        figure.__annotations__["query"] = Annotated[_query_of(kind, source.query_model), Query()]
        routes.get(
            f"/figures/{kind.name}",
            name=kind.name,
            response_model=PlotlyFigure,
            responses={200: {"content": {media: {} for media in list(MEDIA_TYPES.values())[1:]}}},
            summary=f"Figure: {kind.title[0].lower()}{kind.title[1:]}",
        )(figure)

    @routes.get("/figures", summary="Kinds of figures")
    def kinds() -> FigureKinds:
        listed = [
            FigureKind(
                name=kind.name,
                title=kind.title,
                request=f"{PREFIX}/figures/{kind.name}",
                of=PREFIX + kind.of,
            )
            for kind in KINDS
        ]
        return FigureKinds(figures=listed, formats=list(MEDIA_TYPES))

    for kind in KINDS:
        add(kind)
    return routes
