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

import yaml

from tools.recorded_requests.bodies import bodies
from tools.recorded_requests.question import Question
from tools.recorded_requests.server import Server

API = "/api/v1"
HERE = Path(__file__).parent

VALUES: dict[str, Any] = yaml.safe_load((HERE / "values.yaml").read_text("utf-8"))


def questions(server: Server) -> list[Question]:
    """List every request, in an order and number that depend on the server's own words alone."""
    schema = json.loads(server.ask(Question("GET", "/openapi.json")).body)
    lists = _lists(server)
    found: list[Question] = []
    seen: set[str] = set()
    for path, methods in schema["paths"].items():
        for method, operation in methods.items():
            filled = path.format(**VALUES["parts"])
            found += _of_http(method.upper(), filled)
            if method == "get":
                for query in _queries(path, operation.get("parameters", []), seen):
                    found.append(Question("GET", filled + ("?" + query if query else "")))
    for line in (HERE / "picked.txt").read_text("utf-8").splitlines():
        if line and line[0] != "#":
            found += _picked(line, lists)
    found += [Question("GET", address) for address in lists["claim_request"]]
    found += bodies(VALUES["items"], VALUES["columns"], VALUES["wrong"])
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
    small = {name: value for name, value in VALUES["small"].items() if name in known}
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
    found: dict[str, dict[str, str]] = VALUES["beside"].get(route, {})
    return found.get(name, {})


def _values(name: str, schema: dict[str, Any]) -> list[str]:
    """Values of a parameter from its schema: right ones first, the last one always wrong."""
    kinds = [kind for kind in schema.get("anyOf", [schema]) if kind.get("type") != "null"]
    if name in VALUES["texts"]:
        return list(VALUES["texts"][name])
    if name in VALUES["numbers"]:
        return [*VALUES["numbers"][name], *VALUES["not_numbers"]]
    if "1.0,0.766,0.336" in schema.get("examples", []):
        return list(VALUES["colors"])
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
    return list(dict.fromkeys([*map(str, usual), "1e2", *VALUES["not_numbers"]]))


def _fewer(name: str, values: list[str], schema: dict[str, Any]) -> list[str]:
    """What may differ from route to route: what is right, what is beyond, and no value."""
    if "." in name:
        return values[1:4:2]
    return values if "enum" in str(schema) else [*values[:4], ""]
