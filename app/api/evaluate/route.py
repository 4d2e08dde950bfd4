"""The route of `/evaluate`: what it takes, what it sends, and in which kinds."""

from __future__ import annotations

from collections.abc import AsyncIterator, Callable, Iterator
from functools import partial
from urllib.parse import parse_qsl

from fastapi import APIRouter, Request
from starlette.exceptions import HTTPException
from starlette.requests import ClientDisconnect
from starlette.responses import Response, StreamingResponse

from app.api.evaluate import arrow
from app.api.evaluate.answers import Evaluated, Writer, write_arrow, write_csv, write_json
from app.api.evaluate.body import Bodies
from app.api.evaluate.items import ItemReader
from app.api.evaluate.negotiation import accepted
from app.api.evaluate.openapi import operation
from app.api.evaluate.pieces import MOST_VALUES, Questions, TooManyValues
from app.api.problems import API_HEADERS
from app.api.route import refuse_unknown_and_repeated
from app.batch.rows import evaluate
from app.optics.registry import Registry
from app.pool import Pool

# Values of a piece: enough to fill NumPy's calls, few enough that what is sent stays small.
_PIECE = 65_536

JSON = "application/json"

WRITERS = {JSON: Writer(JSON, write_json), "text/csv": Writer("text/csv; charset=utf-8", write_csv)}
if arrow.AVAILABLE:
    WRITERS[arrow.MEDIA_TYPE] = Writer(arrow.MEDIA_TYPE, write_arrow)


def router(registry: Registry, pool: Pool, body_bytes: int) -> APIRouter:
    """Build the route over the models of `registry`.

    Parameters
    ----------
    registry
        The models that may be asked.
    pool
        Where bodies are read and values computed.
    body_bytes
        Size of the largest body.
    """
    routes = APIRouter(tags=["optics"])
    bodies = Bodies(body_bytes)
    readers: dict[str, Callable[[bytes | bytearray], Questions]] = {JSON: ItemReader(registry).read}
    if arrow.AVAILABLE:
        readers[arrow.MEDIA_TYPE] = partial(arrow.read_arrow, registry=registry)

    @routes.post("/evaluate", summary="Many values in one call", **operation(registry))
    async def evaluate_(request: Request) -> Response:
        query = parse_qsl(request.scope["query_string"].decode("latin-1"), keep_blank_values=True)
        refuse_unknown_and_repeated(query, {})
        kind = _kind_of_body(request, list(readers))
        writer = WRITERS[_kind_of_answer(request, kind)]
        try:
            async with bodies.of(request) as body:
                questions = await pool.run(partial(readers[kind], body))
        except TooManyValues:
            detail = f"more than {MOST_VALUES} values are asked for; send them in several calls"
            raise HTTPException(413, detail) from None
        except ClientDisconnect:
            return Response(status_code=400)  # nobody is there to read it
        chunks = writer.write(_evaluated(questions, registry))
        first = await pool.run(partial(next, chunks, b""))
        response = StreamingResponse(_streamed(first, chunks, pool), media_type=writer.media_type)
        response.raw_headers += [(b"cache-control", b"no-store"), *API_HEADERS]
        return response

    return routes


def _evaluated(questions: Questions, registry: Registry) -> Evaluated:
    for piece in questions.pieces(_PIECE):
        yield piece, evaluate(piece.rows, registry)


async def _streamed(first: bytes, rest: Iterator[bytes], pool: Pool) -> AsyncIterator[bytes]:
    """Send what is there while the next is computed in a thread."""
    chunk: bytes | None = first
    while chunk is not None:
        yield chunk
        chunk = await pool.run(partial(next, rest, None), let_in=True)


def _kind_of_body(request: Request, offered: list[str]) -> str:
    header = request.headers.get("content-type", JSON)
    kind = header.partition(";")[0].strip().lower()
    coding = request.headers.get("content-encoding", "identity").strip().lower()
    if kind not in offered or coding != "identity":
        asked = header if coding == "identity" else f"Content-Encoding: {coding}"
        detail = f"{asked[:200]} is not read here; send {' or '.join(offered)}, not compressed"
        raise HTTPException(415, detail, {"Accept-Post": ", ".join(offered)})
    return kind


def _kind_of_answer(request: Request, kind_of_body: str) -> str:
    """Choose by the Accept header; where it leaves the choice, the kind of the body."""
    offered = sorted(WRITERS, key=lambda kind: kind != kind_of_body)
    kind = accepted(request.headers.get("accept", "*/*"), offered)
    if kind is None:
        asked = request.headers["accept"][:200]
        detail = f"Accept: {asked} asks for none of the kinds that are sent: {', '.join(WRITERS)}"
        raise HTTPException(406, detail)
    return kind
