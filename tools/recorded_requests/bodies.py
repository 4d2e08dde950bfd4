"""Requests to `/evaluate`: right and wrong bodies of each kind."""

from __future__ import annotations

import io
import json
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import pyarrow as pa

from tools.recorded_requests.question import Question, post

TARGET = "/api/v1/evaluate"
ARROW = "application/vnd.apache.arrow.stream"
MADE = (
    b"[" * 2000,
    b"\xff\xfe",
    json.dumps({"items": [{"theta_i_deg": [0] * 250_001}] * 4}).encode(),  # too many values
)


def bodies(
    items: Sequence[Mapping[str, Any]],
    tables: Sequence[Mapping[str, Sequence[Any]]],
    wrong: Sequence[str],
) -> Iterator[Question]:
    """List them: each item alone, all together, Arrow, and everything that is none of these."""
    long = {"theta_i_deg": [x / 8 for x in range(720)], "n_t": [1.5] * 720}
    kinds = ("application/json", "text/csv", ARROW)
    for item in items:
        yield post(TARGET, json.dumps({"items": [item]}).encode(), Accept=kinds[0])
        yield post(TARGET, json.dumps({"items": [items[1], item]}).encode(), Accept=kinds[1])
    everything = json.dumps({"items": items}).encode()
    plain = json.dumps({"items": items[1:3]}).encode()
    streams = [_stream(columns) for columns in (*tables, long)]
    for stream in streams:
        for kind in kinds:
            yield post(TARGET, stream, Accept=kind, Content_Type=ARROW)
    for kind in (*kinds, "*/*", "text/*, */*;q=0.1", "image/png", f"{kinds[0]};q=0", "", ";;"):
        yield post(TARGET, everything, Accept=kind)
        yield post(TARGET, streams[0], Accept=kind, Content_Type=ARROW)
    for query in (
        "digits=5",
        "digits=3",
        "digits=2",
        "digits=a",
        "digits=5&digits=6",
        "n_t=1",
        "?",
    ):
        yield post(f"{TARGET}?{query}", plain)
    for body in (*map(str.encode, wrong), *MADE):
        yield post(TARGET, body)
        yield post(TARGET, body, Accept="text/csv")
        yield post(TARGET, body[:1000], Content_Type=ARROW)
    yield post(TARGET, streams[0][:-20], Content_Type=ARROW)
    for kind in (
        "text/plain",
        "text/csv",
        "application/json; charset=utf-8",
        "",
        "APPLICATION/JSON",
    ):
        yield post(TARGET, plain, Content_Type=kind)
    for coding in ("gzip", "br", "identity"):
        yield post(TARGET, plain, Content_Encoding=coding)
        yield post(TARGET, plain, Accept_Encoding=coding)
    yield post(TARGET, plain, Origin="https://example.org")
    yield Question("POST", TARGET, {"Content-Length": "200000000"})


def _stream(columns: Mapping[str, Sequence[Any]]) -> bytes:
    table = pa.table({name: pa.array(values) for name, values in columns.items()})
    sink = io.BytesIO()
    with pa.ipc.new_stream(sink, table.schema) as writer:
        writer.write_table(table)
    return sink.getvalue()
