"""`/figures`: Plotly figures of what other routes answer, as JSON, a page or a picture."""

# No `from __future__ import annotations` here: the queries' types are made at run time, and FastAPI
# could not look up their names.

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from textwrap import wrap
from typing import TYPE_CHECKING, Annotated, Any, Literal
from urllib.parse import urlencode

import orjson
from fastapi import APIRouter, Query
from pydantic import BaseModel, Field, create_model
from starlette.exceptions import HTTPException
from starlette.responses import Response

from app import __version__
from app.api import PREFIX
from app.api.answers import Answer, Large
from app.api.params import AngleQuery, preset_name
from app.api.responses import ReadyBody, json_body, shown_as
from app.api.table import RouteTable
from app.figures.look import Ground, Look, Theme, theme_colors
from app.figures.render import MEDIA_TYPES, NoPictures, page, picture, policy
from app.http.query import Count, Number, QueryModel
from app.http.route import QueryRoute

if TYPE_CHECKING:
    import plotly.graph_objects as go

Format = Literal["json", "html", "svg", "png", "pdf"]

# Of a picture for which no size is asked, in px.
_WIDTH, _HEIGHT = 960, 600


class FigureQuery(QueryModel):
    """How a figure looks, and as what it is sent."""

    format: Format = Field(
        "json",
        description="Plotly's JSON, which plotly.io.from_json reads; a page that holds all it "
        "needs; "
        "or a picture, where the server has Kaleido and a browser.",
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


class MaterialName(QueryModel):
    """Which material."""

    material: str | None = preset_name(
        "Id or alias of a preset with a spectrum; Au by default.", "Au"
    )


class PlotlyFigureOut(BaseModel):
    """A Plotly figure."""

    data: list[dict[str, Any]] = Field(description="Traces.")
    layout: dict[str, Any]


class FigureKindOut(BaseModel):
    """One kind of figure."""

    name: str
    title: str
    request: str = Field(description="Path of the figure; its parameters are those of `of`.")
    of: str = Field(description="Path whose answer is drawn.")


class FigureKindsOut(BaseModel):
    """All kinds of figures."""

    figures: list[FigureKindOut]
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


def _sources(answer: Any, known: Mapping[str, tuple[str, str]]) -> list[str]:
    """Whom the figure's curves are from, by the models, fits and presets that are in it."""
    rows = [*answer.get("curves", ()), *answer.get("errors", ())]
    ids = [row.get("model") or row.get("id") for row in rows] + [answer.get("model")]
    named = [name for name in dict.fromkeys(ids) if name in known and name != "exact"]
    told = [
        f"{title}: {reference.rstrip('.')}." for title, reference in map(known.__getitem__, named)
    ]
    interface = answer.get("interface") or {}
    presets = [interface.get("incident"), interface.get("material"), answer.get("material")]
    return told + [f"{p['name']}: {p['source'].rstrip('.')}." for p in presets if p]


def router(table: RouteTable, static_dir: Path) -> APIRouter:
    """Routes of the figures, drawn from the answers of `table` in the look of the page's files."""
    routes = APIRouter(route_class=QueryRoute, tags=["figures"])

    @cache
    def model_ids() -> tuple[str, ...]:
        return tuple(m["id"] for m in table.json("/models?fields=id")["models"])

    @cache
    def sources() -> dict[str, tuple[str, str]]:
        """Title and reference of every model and fit by its id; models last, for they are drawn."""
        fits = table.json("/albedo/fits")["fits"]
        models = table.json("/models?fields=id,title,reference")["models"]
        return {entry["id"]: (entry["title"], entry["reference"]) for entry in (*fits, *models)}

    @cache
    def colors(theme: Theme) -> dict[str, str]:
        return theme_colors((static_dir / "css" / "base.css").read_text("utf-8"), theme)

    def look_of(query: FigureQuery) -> Look:
        return Look(
            colors(query.theme),
            model_ids(),
            query.background,
            query.font_px,
            query.width,
            query.height,
        )

    def answered(kind: Kind, query: FigureQuery) -> Any:
        """Ask the route that the figure is of, with the query that is validated already."""
        material = getattr(query, "material", None) or "Au"
        route, parts = table.find(kind.of.replace("{material}", material))
        assert route is not None  # noqa: S101 - every kind names a route, as a test checks
        written = route.written(parts, query.model_copy(update={"format": "json", "digits": 17}))
        return orjson.loads(bytes(written.body))

    def drawn(kind: Kind, query: FigureQuery) -> tuple["go.Figure", list[str], Look]:
        """The figure, its caption and its look."""
        from app.figures import draw  # Plotly takes a second and 50 MB: not before it is needed

        answer, look = answered(kind, query), look_of(query)
        known = sources()
        titles = {name: title for name, (title, _) in known.items()}
        make: Callable[..., go.Figure] = getattr(draw, kind.name)
        figure = make(answer, draw.Context(table.json, query, look, titles))
        request = _request(kind, query)
        figure.update_layout(meta={"request": request, "version": __version__})
        texts = [*_sources(answer, known), f"Fresnel Explorer {__version__}, {request}"]
        width = query.width or _WIDTH
        inside = query.caption and query.format != "html"
        columns = int((width - 40) / (0.41 * query.font_px))
        lines = [line for text in texts for line in wrap(text, columns)] if inside else []
        return draw.framed(figure, lines, look, width), texts if query.caption else [], look

    def sent(kind: Kind, query: FigureQuery) -> Response:
        (figure, caption, look), form = drawn(kind, query), query.format
        filename = shown_as(f"fresnel_{kind.name}.{form}")
        if form == "json":
            return ReadyBody(str(figure.to_json()).encode(), MEDIA_TYPES[form], filename)
        if form == "html":
            body = page(figure, kind.title, caption, look, static_dir)
            headers = {**filename, "Content-Security-Policy": policy(static_dir)}
            return ReadyBody(body, MEDIA_TYPES[form], headers)
        try:
            size = (query.width or _WIDTH, query.height or _HEIGHT)
            return ReadyBody(picture(figure, form, size, static_dir), MEDIA_TYPES[form], filename)
        except NoPictures as error:
            detail = f"format = {form} is not to be had here: {error}; json and html are"
            raise HTTPException(406, detail) from None

    def add(kind: Kind) -> None:
        source, _ = table.find(kind.of.replace("{material}", "Au"))
        if source is None or source.query_model is None:
            raise LookupError(kind.of)
        Query_ = _query_of(kind, source.query_model)

        @routes.get(
            f"/figures/{kind.name}",
            name=kind.name,
            response_model=PlotlyFigureOut,
            responses={200: {"content": {media: {} for media in list(MEDIA_TYPES.values())[1:]}}},
            summary=f"Figure: {kind.title[0].lower()}{kind.title[1:]}",
        )
        def figure(query: Annotated[Query_, Query()]) -> Answer:  # type: ignore[valid-type]
            return Large(sent, kind, query)

    @routes.get("/figures", response_model=FigureKindsOut, summary="Kinds of figures")
    def kinds() -> Answer:
        listed = [
            {
                "name": k.name,
                "title": k.title,
                "request": f"{PREFIX}/figures/{k.name}",
                "of": PREFIX + k.of,
            }
            for k in KINDS
        ]
        return json_body({"figures": listed, "formats": list(MEDIA_TYPES)})

    for kind in KINDS:
        add(kind)
    return routes
