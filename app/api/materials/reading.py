"""`POST /materials/read`: a file of n and k becomes a material whose id carries the data."""

from collections.abc import AsyncIterator
from functools import partial
from typing import Annotated, Any, Literal, get_args
from urllib.parse import parse_qsl

from fastapi import APIRouter, Query, Request
from pydantic import Field
from starlette.datastructures import UploadFile
from starlette.exceptions import HTTPException
from starlette.formparsers import MultiPartException, MultiPartParser
from starlette.requests import ClientDisconnect
from starlette.responses import Response

from app.answers.materials.reading import ReadMaterial, read_material
from app.api.evaluate.body import Bodies
from app.http.query import DigitsQuery
from app.http.route import refuse_unknown_and_repeated
from app.http.serving import ClientGone, Unsent, unless_gone
from app.http.writing import write
from app.materials.reading.document import MOST_BYTES
from app.materials.reading.read import LONGEST_NAME, MOST_FILES
from app.materials.reading.registry import default_formats
from app.materials.reading.report import Choices, Sign
from app.materials.reading.units import UNITS
from app.materials.schema import Reference
from app.server.pool import Pool

_MOST_BODY = MOST_FILES * MOST_BYTES + 100_000
_KINDS = ("multipart/form-data", "text/plain")
_PASTED = "pasted.txt"

Unit = Literal["nm", "um", "A", "eV", "cm-1", "THz", "m", "mm", "keV", "meV", "GHz", "Hz"]

_DESCRIPTION = f"""
A file as a form's field `file`, or a pasted table as `text/plain`: at most {MOST_BYTES:,} bytes and
200,000 rows. Two files are eta and k of one material (.spd). Formats:
{", ".join(f"`{kind.id}` ({kind.title})" for kind in default_formats().values())}.

`report` says what was assumed and why, which parameter sets it otherwise, and which rows were left
out. What cannot be told is a problem that names the parameter which decides it. `material` is an id
that every route takes in place of a preset's: it carries n and k, so that an address says all, and
nothing is kept or logged here.
"""


class ReadQuery(DigitsQuery):
    """What is set by hand of how a file is read; what is left out is found out, and told."""

    format: str | None = Field(
        None, max_length=40, description=f"One of {', '.join(default_formats())}."
    )
    unit: Unit | None = Field(None, description="Of the wavelengths, energies or frequencies.")
    columns: str | None = Field(
        None,
        max_length=400,
        description="What the columns are, comma-separated: wavelength, energy, wavenumber or "
        "frequency; n and k, eps1 and eps2, or delta and beta; - for one that is not used.",
        examples=["wavelength,n,k"],
    )
    sign: Sign | None = Field(None, description="How an index that absorbs is written.")
    decimal: Literal[".", ","] | None = Field(None, description="The decimal sign.")
    zero_k: Literal["known", "unknown"] | None = Field(
        None, description="Whether k = 0 was measured, or stands for what was not."
    )
    n_from: Literal["table", "formula"] | None = Field(
        None, description="Which n is taken where a page has a formula and a table."
    )
    relative_to: Reference | None = Field(None, description="What n is relative to.")
    glass: str | None = Field(
        None, max_length=100, description="The glass of a catalog.", examples=["N-BK7"]
    )
    name: str | None = Field(
        None, min_length=1, max_length=LONGEST_NAME, description="What to call the material."
    )

    def choices(self) -> Choices:
        """What is set by hand, as the reader takes it."""
        given: dict[str, Any] = self.model_dump(exclude={"digits", "columns"})
        columns = None if self.columns is None else self.columns.replace(" ", "").split(",")
        return Choices(columns=None if columns is None else tuple(columns), **given)


def router(pool: Pool, body_bytes: int) -> APIRouter:
    """The route; files are read in the threads of `pool`, bodies at most `body_bytes` long."""
    routes = APIRouter(tags=["materials"])
    bodies = Bodies(
        min(body_bytes, _MOST_BODY),
        f"; a file has at most {MOST_BYTES:,}, and {MOST_FILES} are read",
    )
    text = {"schema": {"type": "string", "format": "binary"}}
    form = {
        "schema": {
            "type": "object",
            "properties": {
                "file": {
                    "type": "array",
                    "items": {"type": "string", "format": "binary"},
                    "minItems": 1,
                    "maxItems": MOST_FILES,
                }
            },
            "required": ["file"],
        }
    }

    @routes.post(
        "/materials/read",
        summary="A file of n and k as a material",
        description=_DESCRIPTION.strip(),
        response_model=ReadMaterial,
        openapi_extra={
            "requestBody": {
                "required": True,
                "content": {"multipart/form-data": form, "text/plain": text},
            }
        },
    )
    async def read(request: Request, query: Annotated[ReadQuery, Query()]) -> Response:
        given = parse_qsl(request.scope["query_string"].decode("latin-1"), keep_blank_values=True)
        refuse_unknown_and_repeated(given, ReadQuery.model_fields)
        header = request.headers.get("content-type", "text/plain")
        kind = header.partition(";")[0].strip().lower()
        if kind not in _KINDS:
            detail = f"{header[:200]} is not read here; send {' or '.join(_KINDS)}"
            raise HTTPException(415, detail, {"Accept-Post": ", ".join(_KINDS)})
        try:
            async with bodies.of(request) as body:
                files = [(_PASTED, bytes(body))]
                if kind != "text/plain":
                    files = await _files(request, bytes(body))
                work = pool.run(partial(read_material, files, query.choices()))
                answer = await unless_gone(request.receive, work)
        except (ClientDisconnect, ClientGone):
            return Unsent()
        response = write(answer, digits=query.digits)
        response.headers["cache-control"] = "no-store"
        return response

    return routes


class _InMemory(MultiPartParser):
    """A parser that writes nothing to the disk: the body is in memory and bounded."""

    spool_max_size = _MOST_BODY


async def _files(request: Request, body: bytes) -> list[tuple[str, bytes]]:
    """Take a form apart."""

    async def stream() -> AsyncIterator[bytes]:
        yield body

    parser = _InMemory(request.headers, stream(), max_files=MOST_FILES, max_fields=0)  # type: ignore[arg-type]
    try:
        form = await parser.parse()
    except MultiPartException as error:
        raise HTTPException(400, f"no form that can be read: {error.message[:200]}") from None
    parts = form.multi_items()
    files = [
        (part.filename or "file", await part.read())
        for name, part in parts
        if name == "file" and isinstance(part, UploadFile)
    ]
    await form.close()
    if not files or len(files) < len(parts):
        raise HTTPException(400, "the form has one or two files in the field `file`, and no others")
    return files


if set(get_args(Unit)) != set(UNITS):
    raise RuntimeError("the units of the query are those that are read")
