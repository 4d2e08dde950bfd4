"""The list of requests, made from what a server says of itself: its schema and its lists."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Sequence
from itertools import product
from math import sqrt
from pathlib import Path
from typing import Any
from urllib.parse import quote, urlencode

from tools.recorded_requests.bodies import bodies
from tools.recorded_requests.question import Question
from tools.recorded_requests.server import Server

API = "/api/v1"
HERE = Path(__file__).parent

NOT_NUMBERS = ["nan", "inf", "-Infinity", "1e400", "1_0", "1,5", "0x10", "abc", "", " 1.5", "+1"]

# What a schema cannot say of texts: some that are right, then some that are not.
TEXTS = {
    "models": [
        *("exact", "exact,schlick", "spherical_gaussian", "schlik", "Schlick", "exact,"),
        *("schlick,schlick", "f82-tint", ""),
    ],
    "model": ["exact", "one_minus_cos", "f82_tint", "schlik", "lut_1d", "EXACT", "a,b", ""],
    "material": ["Au", "water", "gold", "gld", "BK7", "ice-wloka", "au", "watr", "x" * 101, ""],
    "incident": ["water", "vacuum", "Au", "watr", "BK7", ""],
    "wavelength_nm": ["587.6", "550", "10", "200000", "0", "-1", "10000001", *NOT_NUMBERS],
    "wavelengths_nm": ["550", "400,700", "400,400", "10,500", "a,b", "", ",", "nan", "500," * 60],
    "fields": ["id", "id,title", "id,name,n,k", "title,id", "ids", "id,id", "id,", ""],
    "fits": ["deon_2019_log", "deon_2019_log,kulla_conty_2017", "deon_2019", "", "a,a"],
    "fit": ["deon_2019_rg", "deon_2019_log", "deon", ""],
    "q": ["gold", "Gold", "glass", "zzz", "%", "é", "", "x" * 101],
    "hex": ["#ff8800", "ff8800", "#f80", "#gggggg", ""],
    "example": ["deon", "lagarde", "none", ""],
    "minimum": ["1.1", "0.5", "3", "-1", "1e9", "0", *NOT_NUMBERS],
    "maximum": ["2.5", "1", "101", "-1", "1e9", *NOT_NUMBERS],
    "minimum_nm": ["400", "600", "5", "0", "-3", "1e8", *NOT_NUMBERS],
    "maximum_nm": ["700", "400", "1e7", "0", *NOT_NUMBERS],
    "step_nm": ["10", "0.01", "5000", "0", *NOT_NUMBERS],
    "x_minimum": ["1.5", "20", "-1", "200", "nan"],
    "x_maximum": ["2", "60", "-1", "200", "nan"],
    "y_minimum": ["1.5", "20", "-1", "200", "nan"],
    "y_maximum": ["2", "60", "-1", "200", "nan"],
}
COLORS = [
    "0.04",
    "1.0,0.766,0.336",
    "0.5,0.5",
    "-0.1",
    "a,b,c",
    "0.1,0.2,0.3,0.4",
    "2,0,0",
    "nan,0,0",
]
COLORS += [",,", "", "1.01", "0", "1", "inf"]

# What a parameter needs beside it to have a meaning, by route and name.
BESIDE = {
    ("/convert", "k_t"): {"from": "nk"},
    ("/convert", "F0"): {"from": "f0"},
    ("/convert", "F0_srgb"): {"from": "f0_srgb"},
    ("/convert", "hex"): {"from": "f0_srgb"},
    ("/convert", "r"): {"from": "rg", "g": "0.5"},
    ("/convert", "g"): {"from": "rg", "r": "0.5"},
    ("/convert", "G"): {"from": "dg", "r": "0.5"},
    ("/convert", "specular"): {"from": "specular"},
    ("/convert", "reflectance"): {"from": "reflectance"},
    ("/albedo/map", "show"): {"fit": "deon_2019_rg"},
    ("/errors/map", "x"): {"y": "k_t", "metric": "error"},
    ("/errors/map", "y"): {"x": "n_i", "metric": "rms"},
}

# Small answers take less time and say as much; the schema's default is asked for once a route.
SMALL = {"samples": "7", "steps": "5", "x_steps": "6", "y_steps": "4", "n_steps": "4"}
SMALL |= {"k_steps": "3", "size": "16", "rows": "5", "limit": "3"}
PARTS = {"model_id": "schlick", "material": "Au", "fit_id": "deon_2019_log"}
PARTS |= {"formula_id": "model.schlick", "claim_id": "deon-2019-log"}


def questions(server: Server) -> list[Question]:
    """List every request, in an order and number that depend on the server's own words alone."""
    schema = json.loads(server.ask(Question("GET", "/openapi.json")).body)
    lists = _lists(server)
    found: list[Question] = []
    seen: set[str] = set()
    for path, methods in schema["paths"].items():
        for method, operation in methods.items():
            filled = path.format(**PARTS)
            found += _of_http(method.upper(), filled)
            if method == "get":
                for query in _queries(path, operation.get("parameters", []), seen):
                    found.append(Question("GET", filled + ("?" + query if query else "")))
    for line in (HERE / "picked.txt").read_text("utf-8").splitlines():
        if line and line[0] != "#":
            found += _picked(line, lists)
    found += [Question("GET", address) for address in lists["claim_request"]]
    found += bodies()
    found.append(Question("GET", f"{API}/curves?models=" + "exact," * 4000))
    found.append(Question("GET", f"{API}/curves", {"X-Long": "x" * 40_000}))
    kept = {
        json.dumps(vars(q), sort_keys=True) + q.headers.get("If-None-Match", ""): q for q in found
    }
    return list(kept.values())


def _lists(server: Server) -> dict[str, list[str]]:
    """Ids of everything that the server lists."""

    def of(noun: str, path: str = "") -> list[dict[str, Any]]:
        answer = server.ask(Question("GET", f"{API}/{path or noun}"))
        listed: list[dict[str, Any]] = json.loads(answer.body)[noun]
        return listed

    ids = {
        "model": [entry["id"] for entry in of("models")],
        "material": [entry["id"] for entry in of("materials")],
        "fit": [entry["id"] for entry in of("fits", "albedo/fits")],
        "formula": [entry["id"] for entry in of("formulas")],
        "claim": [entry["id"] for entry in of("claims")],
        "language": [entry["id"] for entry in of("languages", "shaders")],
        "figure": [entry["name"] for entry in of("figures")],
    }
    asked = [figure["request"] for claim in of("claims") for figure in claim["figures"]]
    return ids | {"claim_request": list(dict.fromkeys(filter(None, asked)))}


def _picked(line: str, lists: dict[str, list[str]]) -> Iterator[Question]:
    """Read a line of `picked.txt`, once for each value of each name in braces."""
    asked, *given = line.split(" | ")
    headers = dict(header.split(": ", 1) for header in given)
    method, target = asked.split(" ", 1)
    names = re.findall(r"{(\w+)}", target)
    for values in product(*(lists[name] for name in names)):
        filled = {name: quote(value) for name, value in zip(names, values, strict=True)}
        yield Question(method, target.format(**filled) if names else target, headers)


def _of_http(method: str, path: str) -> Iterator[Question]:
    """Ask a path as HTTP lets one ask: other methods, other codings, from other pages."""
    for other in ("HEAD", "POST", "PUT", "DELETE", "PATCH", "OPTIONS", "GET"):
        if other != method:
            yield Question(other, path)
    page = {"Origin": "https://example.org"}
    for wanted in ("GET", "POST"):
        yield Question("OPTIONS", path, page | {"Access-Control-Request-Method": wanted})
    if method == "GET":
        yield Question("GET", path, page)
        for coding in ("gzip", "br", "zstd", "identity", "br;q=0, gzip;q=0.5", "*"):
            yield Question("GET", path, {"Accept-Encoding": coding})
        yield Question("GET", path, {"If-None-Match": "{etag}"})
        yield Question("GET", path, {"If-None-Match": '"other", {etag}', "Accept-Encoding": "br"})
        yield Question("HEAD", path, {"If-None-Match": "*"})
        yield Question("GET", path + "/")


def _queries(path: str, parameters: Sequence[dict[str, Any]], seen: set[str]) -> Iterator[str]:
    """Ask with each value of each parameter; all that is wrong where it is met first, some after."""
    known = {p["name"]: p["schema"] for p in parameters if p["in"] == "query"}
    route = path.removeprefix(API).replace("/figures/errors", "/errors/map")
    small = {name: value for name, value in SMALL.items() if name in known}
    yield ""
    yield "nonsense=1"
    formats = [f for f in known.get("format", {}).get("enum", []) if f not in ("svg", "pdf")]
    if path.startswith(f"{API}/figures/"):
        formats = ["json"]  # a page holds Plotly, a picture needs a browser: a few are picked
    for name, schema in known.items():
        beside = small | _beside(route, name, known)
        sent = [
            value for value in _values(name, schema) if value not in ("svg", "png", "pdf", "html")
        ]
        if path.endswith("/lut") and name == "format":
            sent = [*formats, "html", "JSON", ""]
        if (key := f"{name} {schema}") in seen or ("." in name and not path.endswith("/curves")):
            sent = _fewer(name, sent, schema)
        seen.add(key)
        for value in sent:
            yield urlencode(beside | {name: value}, safe=",")
        if "." not in name:
            yield f"{urlencode({name: sent[0]})}&{urlencode({name: sent[-1]})}"
            yield urlencode({name[:-1] + "_": sent[0]})
            for kind in formats[1:]:
                for value in schema.get("enum", [sent[0]]):
                    yield urlencode(beside | {"format": kind} | {name: value}, safe=",")


def _beside(route: str, name: str, known: dict[str, Any]) -> dict[str, str]:
    model, dot, _ = name.partition(".")
    if dot:
        return {"n_t": "2.9", "k_t": "3"} | {"models" if "models" in known else "model": model}
    if name == "wavelength_nm":
        return {"material": "Au"} if "material" in known else {}
    return BESIDE.get((route, name), {})


def _values(name: str, schema: dict[str, Any]) -> list[str]:
    """Values of a parameter from its schema: right ones first, the last one always wrong."""
    kinds = [kind for kind in schema.get("anyOf", [schema]) if kind.get("type") != "null"]
    if name in TEXTS:
        return TEXTS[name]
    if "1.0,0.766,0.336" in schema.get("examples", []):
        return COLORS
    if "enum" in kinds[0]:
        named = [str(value) for value in kinds[0]["enum"]]
        return [*named, named[0].upper() + "x", named[-1][:-1], ""]
    if kinds[0]["type"] == "boolean":
        return ["true", "false", "1", "no", "TRUE", "maybe", ""]
    if kinds[0]["type"] in ("number", "integer"):
        return _numbers(schema | kinds[0])
    return ["schlick", "x", ""]


def _numbers(schema: dict[str, Any]) -> list[str]:
    """Low, middle, high and usual ones, whole where they must be, then beyond and none at all."""
    low, high = (
        next(schema[key] for key in keys if key in schema)
        for keys in (("minimum", "ge", "exclusiveMinimum", "gt"), ("maximum", "le", "type"))
    )
    if not isinstance(high, int | float):
        high = 100.0
    whole = schema["type"] == "integer"
    middle = sqrt(low * high) if low > 0 else low + (high - low) / 3
    usual = [low, round(middle) if whole else middle, high, low - 1, high + 1, low - 1e-9]
    usual += [*schema.get("examples", []), *([2.5] if whole else [])]
    return list(dict.fromkeys([*map(str, usual), "1e2", *NOT_NUMBERS]))


def _fewer(name: str, values: list[str], schema: dict[str, Any]) -> list[str]:
    """What may differ from route to route: what is right, what is beyond, and no value."""
    if "." in name:
        return values[1:4:2]
    return values if "enum" in str(schema) else [*values[:4], ""]
