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
ITEMS: Sequence[Mapping[str, Any]] = (
    {},
    {"n_t": 1.5, "theta_i_deg": [0, 56.31, 80]},
    {"n_t": 0.27, "k_t": 2.9, "theta_i_deg": [0, 45, 80], "model": "schlick"},
    {"material": "Au", "incident": "water", "wavelength_nm": 550},
    {"material": "Au", "theta_i_deg": [0, 90], "quantity": "Rs"},
    {"material": "BK7", "theta_i_deg": 30, "quantity": "T"},
    {"n_i": 1.5, "n_t": 1, "theta_i_deg": [41, 42, 90], "quantity": "Rp"},
    {"model": "lazanyi2005", "n_t": 2.9, "k_t": 3, "lazanyi2005.alpha": 7.7},
    {"model": "f82_tint", "n_t": 2.9, "k_t": 3, "f82_tint.tint": 0.5, "theta_i_deg": [82]},
    {"model": "lut_1d", "lut_1d.size": 16, "lut_1d.bits": "8", "theta_i_deg": [10, 20]},
    {"model": "cos_form", "n_t": 2.9, "k_t": 3},
    {"model": "schlik"},
    {"model": "schlick", "quantity": "Rs"},
    {"model": "schlick", "spherical_gaussian.F0": 0.5},
    {"material": "gld"},
    {"material": "Au", "n_t": 1.5},
    {"material": "Au", "wavelength_nm": 5},
    {"wavelength_nm": 550},
    {"incident": "Au"},
    {"n_t": [1.3, 1.5], "theta_i_deg": [0, 80]},
    {"n_t": 0},
    {"n_t": 101},
    {"n_t": "1.5"},
    {"n_t": None},
    {"n_t": True},
    {"k_t": -1},
    {"theta_i_deg": 90.001},
    {"theta_i_deg": []},
    {"theta_i_deg": [0, "a"]},
    {"theta_i_deg": [[0]]},
    {"quantity": "X"},
    {"odd": 1},
    {"theta": 1},
    {"model": 5},
)
COLUMNS: Sequence[Mapping[str, Sequence[Any]]] = (
    {"n_t": [1.5, 1.33, None], "theta_i_deg": [0.0, 60.0, 90.0]},
    {"n_t": [1.5, 101.0], "model": ["schlick", "schlik"], "theta_i_deg": [10.0, 20.0]},
    {"material": ["Au", "water", None, "gld"], "wavelength_nm": [550.0, None, None, None]},
    {"n_t": [1, 2, 3]},
    {"n_t": ["a"]},
    {"n_t": [float("nan"), float("inf"), -1.0]},
    {"odd": [1.0]},
    {"theta_i_deg": [x / 8 for x in range(720)], "n_t": [1.5] * 720},
    {"n_t": []},
)
WRONG = (
    *(b"", b"{", b"[]", b"{}", b"null", b"5", b'"items"', b'{"items": 5}', b'{"items": [1]}'),
    *(b'{"items": {}}', b'{"items": null}', b'{"items": [], "odd": 1}', b'{"item": []}'),
    *(b'{"items": [{"n_t": NaN}]}', b'{"items": [{"n_t": 1e999}]}', b"[" * 2000, b"\xff\xfe"),
    b'{"items": [{"n_t": 1.5, "n_t": 1.6}]}',
    json.dumps({"items": [{"theta_i_deg": [0] * 250_001}] * 4}).encode(),
)


def bodies() -> Iterator[Question]:
    """List them: each item alone, all together, Arrow, and everything that is none of these."""
    kinds = ("application/json", "text/csv", ARROW)
    for item in ITEMS:
        yield post(TARGET, json.dumps({"items": [item]}).encode(), Accept=kinds[0])
        yield post(TARGET, json.dumps({"items": [ITEMS[1], item]}).encode(), Accept=kinds[1])
    everything = json.dumps({"items": ITEMS}).encode()
    plain = json.dumps({"items": ITEMS[1:3]}).encode()
    streams = [_stream(columns) for columns in COLUMNS]
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
    for body in WRONG:
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
