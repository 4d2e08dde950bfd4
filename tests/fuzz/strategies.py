"""Requests as anybody might send them: right, nearly right, and hostile, as bytes on the wire."""

import gzip
import json
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any
from urllib.parse import quote

from hypothesis import strategies as st

Schema = Mapping[str, Any]


@dataclass(frozen=True)
class Request:
    """One request; `broken` if what it announces is not what it sends."""

    method: bytes
    target: bytes
    headers: tuple[tuple[bytes, bytes], ...]
    body: bytes
    broken: bool = False

    def __repr__(self) -> str:
        """Show what matters of it, and of long parts the beginning."""
        shown = ", ".join(f"{name!r}: {value[:80]!r}" for name, value in self.headers)
        ends = " broken" if self.broken else ""
        return f"<{self.method!r} {self.target[:600]!r} {{{shown}}} {self.body[:300]!r}{ends}>"

    def _repr_pretty_(self, printer: Any, _: bool) -> None:
        printer.text(repr(self))

    def wire(self) -> bytes:
        """Write it down."""
        lines = [self.method + b" " + self.target + b" HTTP/1.1"]
        lines += [name + b": " + value for name, value in self.headers]
        return b"\r\n".join([*lines, b"", self.body])


WORDS = (
    "0 1 1.5 -0 90 nan inf -Infinity 1e400 1e-400 0x1p3 1_0 100 100.0000001 1e-3 0.00099999 "
    "5e-324 1.7976931348623157e308 1,5 1/1.5 \u0661 true null [1]"
)
NUMBERS = st.one_of(
    st.sampled_from(
        [
            *WORDS.split(),
            *("", " 1.5", "1.5\x00", "2" * 5000),
        ]
    ),
    st.floats(allow_nan=True).map(repr),
    st.floats(0.5, 4.0).map(repr),
    st.integers().map(str),
)
TEXT = st.text(max_size=30)


def values(parameter: Schema) -> st.SearchStrategy[str]:
    """Values for one parameter: what its schema names, its bounds and just beyond, anything else."""
    shown = parameter["schema"]
    kinds = [shown, *shown.get("anyOf", [])]
    named: list[Any] = [*parameter.get("examples", {}), *shown.get("examples", [])]
    for kind in kinds:
        named += [kind[key] for key in ("default", "minimum", "maximum") if key in kind]
        named += kind.get("enum", [])
    numbers = [x for x in named if isinstance(x, int | float) and not isinstance(x, bool)]
    named += [x + step for x in numbers for step in (-1, 1, 1e-9)]
    plain = [x if isinstance(x, str) else json.dumps(x) for x in named if x is not None]
    usual = [st.sampled_from(plain)] * 3 if plain else []
    return st.one_of(*usual, NUMBERS, TEXT)


@dataclass(frozen=True)
class Operation:
    """A route and a method of the schema, with what its query may be."""

    method: str
    path: str
    parts: tuple[str, ...]
    query: Mapping[str, st.SearchStrategy[str]]


def operations(schema: Schema) -> list[Operation]:
    """List what the schema knows; strategies are made once, for that takes longer than drawing."""
    return [
        Operation(
            method.upper(),
            path,
            tuple(p["name"] for p in operation.get("parameters", []) if p["in"] == "path"),
            {p["name"]: values(p) for p in operation.get("parameters", []) if p["in"] == "query"},
        )
        for path, methods in sorted(schema["paths"].items())
        for method, operation in sorted(methods.items())
    ]


@st.composite
def targets(draw: st.DrawFn, known: list[Operation], ids: list[str]) -> tuple[bytes, str]:
    """An address made from a route of the schema, and the method that the route knows."""
    operation = draw(st.sampled_from(known))
    path = operation.path
    for name in operation.parts:
        part = draw(st.one_of(st.sampled_from(ids), TEXT))
        path = path.replace(f"{{{name}}}", quote(part, safe=""))
    pairs: list[tuple[str, str]] = []
    if operation.query:
        names = draw(st.lists(st.sampled_from(sorted(operation.query)), max_size=5))
        if draw(st.integers(0, 9)):
            names = list(dict.fromkeys(names))
        pairs = [(name, draw(operation.query[name])) for name in names]
    if draw(st.integers(0, 9)) == 0:
        pairs.append((draw(TEXT), draw(TEXT)))
    query = "&".join(f"{quote(name, safe='.')}={quote(value, safe=',')}" for name, value in pairs)
    target = (path + ("?" + query if query else "")).encode()
    if draw(st.integers(0, 19)) == 0:  # bytes that no client would send
        at = draw(st.integers(1, len(target)))
        target = target[:at] + draw(st.binary(max_size=8)) + target[at:]
    if draw(st.integers(0, 49)) == 0:
        target += b"&" * draw(st.sampled_from([1, 100, 10_000, 70_000]))
    return target, operation.method


PATHS = st.one_of(
    st.sampled_from(
        [
            *b"/ /docs /openapi.json /metrics /js/main.js /vendor/manifest.json * // /api/v1//".split(),
            *b"/../app/main.py /%2e%2e/pyproject.toml /js/%00 /%ff%fe".split(),
            b"http://example.org/api/v1/health",
            b"/api/v1/models/" + b"x" * 5000,
        ]
    ),
    st.binary(max_size=20).map(lambda b: b"/" + quote(b).encode()),
)

ENCODINGS = st.lists(
    st.sampled_from(["gzip", "br", "zstd", "identity", "*", "deflate", "gzip;q=0", "br;q=x", "é"]),
    max_size=4,
).map(lambda names: ", ".join(names).encode("latin-1"))
PRINTABLE = st.binary(max_size=40).map(lambda b: b.translate(None, bytes(range(32)) + b"\x7f"))
HEADERS = st.one_of(
    st.tuples(st.just(b"Accept-Encoding"), ENCODINGS),
    st.tuples(
        st.sampled_from([b"Accept", b"Content-Type"]),
        st.sampled_from(
            [
                b"application/json",
                b"text/csv",
                b"application/vnd.apache.arrow.stream",
                b"*/*",
                b"application/json;q=0",
                b"text/html",
                b";;;",
                b"application/json; charset=latin-9",
            ]
        ),
    ),
    st.tuples(st.just(b"If-None-Match"), st.sampled_from([b"*", b'W/"x"', b'"', b",,,"])),
    st.tuples(st.just(b"Origin"), st.sampled_from([b"https://example.org", b"null", b"\xff"])),
    st.tuples(
        st.just(b"Access-Control-Request-Method"), st.sampled_from([b"GET", b"POST", b"BREW"])
    ),
    st.tuples(st.just(b"Access-Control-Request-Headers"), st.sampled_from([b"x-odd", b"\xff,"])),
    st.tuples(st.just(b"Range"), st.sampled_from([b"bytes=0-1", b"bytes=9-1", b"bytes=-", b"x"])),
    st.tuples(st.just(b"Expect"), st.sampled_from([b"100-continue", b"200-ok"])),
    st.tuples(st.just(b"X-Forwarded-For"), PRINTABLE),
    st.tuples(st.just(b"X-Request-ID"), PRINTABLE),
    st.tuples(st.just(b"Content-Encoding"), st.sampled_from([b"gzip", b"br", b"x"])),
    st.tuples(
        st.sampled_from([b"Cookie", b"Authorization", b"Host", b"X-" + b"a" * 200]), PRINTABLE
    ),
)
METHODS = st.sampled_from(
    [b"GET"] * 8 + [b"HEAD", b"POST", b"PUT", b"DELETE", b"PATCH", b"OPTIONS", b"TRACE", b"CONNECT"]
)

JSON = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | TEXT,
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(TEXT, inner, max_size=4),
    max_leaves=8,
)
ITEM_VALUES = {
    "n_i": st.floats(-1, 101) | st.lists(st.floats(0.5, 2), max_size=3) | JSON,
    "n_t": st.floats(-1, 101) | st.lists(st.floats(0.5, 2), max_size=3) | JSON,
    "k_t": st.floats(-1, 101) | JSON,
    "theta_i_deg": st.floats(-1, 91) | st.lists(st.floats(-1, 91), max_size=5) | JSON,
    "model": st.sampled_from(["exact", "schlick", "lazanyi2005", "nope", ""]) | JSON,
    "material": st.sampled_from(["Au", "water", "BK7", "ice-wloka", "vacuum", "nope", ""]) | JSON,
    "incident": st.sampled_from(["Au", "water", "BK7", "vacuum-shirley", "watr", ""]) | JSON,
    "wavelength_nm": st.floats(-1, 30_000) | st.sampled_from([0, 550, 587.6, 1e7, 1e9]) | JSON,
    "quantity": st.sampled_from(["R", "Rs", "Rp", "T", "x"]) | JSON,
}
ITEM = st.fixed_dictionaries({}, optional={**ITEM_VALUES, "odd": JSON})
BODIES = st.one_of(
    st.fixed_dictionaries({"items": st.lists(ITEM, max_size=4)}).map(json.dumps).map(str.encode),
    JSON.map(json.dumps).map(str.encode),
    st.binary(max_size=60),
    st.sampled_from([b"", b"{", b"[" * 5000, b'{"items": 1e999}', b"\xff\xff\xff\xff\x00\x00\x00"]),
)


@st.composite
def requests(draw: st.DrawFn, known: list[Operation], ids: list[str]) -> Request:
    """Any request at all, most of them to routes that exist."""
    target, own = draw(targets(known, ids)) if draw(st.integers(0, 9)) else (draw(PATHS), "GET")
    method = own.encode() if draw(st.booleans()) else draw(METHODS)
    headers = [(b"Host", b"test"), *draw(st.lists(HEADERS, max_size=4))]
    body, broken = b"", False
    if method not in (b"GET", b"HEAD") or draw(st.integers(0, 19)) == 0:
        body = draw(BODIES)
        if draw(st.integers(0, 5)) == 0:
            body = gzip.compress(body)
        length = len(body)
        if draw(st.integers(0, 19)) == 0:
            length, broken = draw(st.sampled_from([length + 5, 0, 10**12, -1])), True
        headers.append((b"Content-Length", str(length).encode()))
        if method == b"POST" and draw(st.booleans()):
            headers.append((b"Content-Type", b"application/json"))
    if draw(st.integers(0, 39)) == 0:
        headers.append((draw(st.binary(min_size=1, max_size=8)), draw(st.binary(max_size=8))))
        broken = True
    return Request(method, target, tuple(headers), body, broken)
