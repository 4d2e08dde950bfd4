"""The route of `/evaluate`: what it takes, what it sends, and in which kinds."""

import asyncio
from collections import Counter, deque
from collections.abc import AsyncIterator, Callable
from contextlib import ExitStack
from functools import partial
from typing import Annotated, NamedTuple
from urllib.parse import parse_qsl

import numpy as np
from fastapi import APIRouter, Query, Request
from starlette.exceptions import HTTPException
from starlette.requests import ClientDisconnect
from starlette.responses import Response, StreamingResponse
from starlette.types import Receive, Scope, Send

from app.api.evaluate import arrow
from app.api.evaluate.answers import ARROW, CSV, JSON, Writer, Written, by_item
from app.api.evaluate.body import Bodies, Held
from app.api.evaluate.items import ItemReader
from app.api.evaluate.negotiation import accepted
from app.api.evaluate.openapi import operation
from app.api.evaluate.pieces import MOST_TOLD, MOST_VALUES, Piece, Questions, TooManyValues
from app.batch.evaluation import evaluate
from app.batch.rows import Fault
from app.http.query import DigitsQuery
from app.http.route import refuse_unknown_and_repeated
from app.http.serving import ClientGone, Unsent, unless_gone
from app.optics.numerics.significant import round_significant
from app.optics.parameters import Array
from app.optics.registry import Registry
from app.server.pool import Pool

# Values of a piece: enough to fill NumPy's calls, few enough that what is sent stays small.
_PIECE = 65_536

_LONGEST_NAME = 200

# Pieces that are computed or waiting to be sent: the next is ready when one has been sent.
_AHEAD = 3

WRITERS = {
    writer.media_type.partition(";")[0]: writer
    for writer in ((JSON, CSV, ARROW) if arrow.AVAILABLE else (JSON, CSV))
}


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
    readers: dict[str, Callable[[bytes | bytearray], Questions]] = {
        JSON.media_type: ItemReader(registry).read
    }
    if arrow.AVAILABLE:
        readers[arrow.MEDIA_TYPE] = partial(arrow.read_arrow, registry=registry)

    @routes.post("/evaluate", summary="Many values in one call", **operation(registry))
    async def evaluate_(request: Request, query: Annotated[DigitsQuery, Query()]) -> Response:
        given = parse_qsl(request.scope["query_string"].decode("latin-1"), keep_blank_values=True)
        refuse_unknown_and_repeated(given, DigitsQuery.model_fields)
        kind = _kind_of_body(request, list(readers))
        writer = WRITERS[_kind_of_answer(request, kind)]
        with ExitStack() as stack:
            held = stack.enter_context(Held(bodies))
            try:
                await bodies.read(request, held)
                reading = pool.run(partial(held.parsed, readers[kind]))
                questions = await unless_gone(request.receive, reading)
            except TooManyValues:
                detail = f"more than {MOST_VALUES} values are asked for; send them in several calls"
                raise HTTPException(413, detail) from None
            except (ClientDisconnect, ClientGone):
                return Unsent()
            held.becomes(questions.size)
            chunks = _streamed(questions, writer, registry, pool, query.digits)
            return _Streamed(chunks, writer.media_type, stack.pop_all())

    return routes


def _answered(piece: Piece, registry: Registry) -> tuple[Array, dict[int, Fault]]:
    """Answer a piece; one that is a single item of many angles, in parts."""
    values = [np.zeros(0)]
    wrong: dict[int, Fault] = {}
    for start in range(0, piece.rows.count, _PIECE):
        outcome = evaluate(piece.rows.part(start, start + _PIECE), registry)
        values.append(outcome.values)
        wrong |= {
            item: fault
            for item, fault in by_item(piece, outcome, start).items()
            if item not in wrong
        }
    return np.concatenate(values), wrong


class _Streamed(StreamingResponse):
    """An answer that gives back what it holds when it has been sent, or cannot be any more."""

    def __init__(self, chunks: AsyncIterator[bytes], media_type: str, held: ExitStack) -> None:
        super().__init__(chunks, media_type=media_type)
        self.raw_headers.append((b"cache-control", b"no-store"))
        self._held = held

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        with self._held:
            await super().__call__(scope, receive, send)


class _Computed(NamedTuple):
    """A piece whose values are known."""

    write: Callable[[int], Written]
    """Writes it, given how many faults may still be told in full; at once if there are none."""
    wrong: Counter[str]
    """How many of its items are wrong in which parameter."""


async def _streamed(
    questions: Questions, writer: Writer, registry: Registry, pool: Pool, digits: int
) -> AsyncIterator[bytes]:
    """Send pieces in order while the next ones are computed in threads."""

    def computed(made: Callable[[], Piece]) -> _Computed:
        piece = made()
        values, wrong = _answered(piece, registry)
        values = round_significant(values, digits)
        write = partial(writer.piece, piece, values, wrong)
        if wrong:
            return _Computed(write, Counter(f.parameter[:_LONGEST_NAME] for f in wrong.values()))
        written = write(0)
        return _Computed(lambda _: written, Counter())

    yield writer.head()
    failed: Counter[str] = Counter()
    told = 0
    pieces = questions.pieces(_PIECE)
    under_way: deque[asyncio.Task[_Computed]] = deque()
    try:
        while True:
            while len(under_way) < _AHEAD and (piece := next(pieces, None)):
                work = pool.run(partial(computed, piece), let_in=True)
                under_way.append(asyncio.create_task(work))
            if not under_way:
                break
            write, wrong = await under_way.popleft()
            left = MOST_TOLD - told
            written = await pool.run(partial(write, left), let_in=True) if wrong else write(left)
            told += written.told
            failed += wrong
            yield written.body
    finally:
        for task in under_way:
            task.cancel()
    yield writer.tail(failed)


def _kind_of_body(request: Request, offered: list[str]) -> str:
    header = request.headers.get("content-type", JSON.media_type)
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
