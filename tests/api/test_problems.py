"""Every error is a problem (RFC 9457) that names the parameter, the value and what is allowed."""

import time
from collections.abc import Callable
from dataclasses import replace
from typing import Any, NoReturn
from urllib.parse import quote

import httpx
import pytest
from fastapi import FastAPI
from hypothesis import example, given
from hypothesis import strategies as st

from app.http.problems import MEDIA_TYPE, MOST_ERRORS, Problem
from app.main import create_app
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.parameters import Array
from app.optics.registry import Registry, default_registry
from tests.api.raw import Answer, send

Ask = Callable[..., httpx.Response]

API = b"/api/v1"
SECOND = 1.0
"""More than any refusal may take, on a busy machine too."""


def expect_problem(answer: Answer, *statuses: int) -> dict[str, Any]:
    """Check that an answer is a problem in every respect, and return it."""
    assert answer.headers["content-type"] == MEDIA_TYPE, (answer.status, answer.body[:200])
    told = Problem.model_validate_json(answer.body, strict=True, extra="forbid")
    assert told.status == answer.status
    assert answer.status in (statuses or range(400, 500)), told.detail
    assert told.type == "about:blank"
    assert told.title
    assert told.detail
    for error in told.errors:
        assert error.message
    assert "cache-control" not in answer.headers
    return told.model_dump()


REFUSED = [
    # what is no number
    ("/snell?n_t=nan", "n_t"),
    ("/snell?n_t=NaN", "n_t"),
    ("/snell?n_t=inf", "n_t"),
    ("/snell?n_t=-Infinity", "n_t"),
    ("/snell?n_t=1e400", "n_t"),
    ("/snell?n_t=", "n_t"),
    ("/snell?n_t", "n_t"),
    ("/snell?n_t=glass", "n_t"),
    ("/snell?n_t=1,5", "n_t"),
    ("/snell?n_t=0x10", "n_t"),
    ("/snell?n_t=1_5", "n_t"),
    ("/snell?n_t=1.5%00", "n_t"),
    ("/snell?n_t=%ff", "n_t"),
    ("/snell?n_t=%D9%A1", "n_t"),
    ("/snell?n_t=true", "n_t"),
    ("/snell?n_t=1.5;k_t=2", "n_t"),
    ("/snell?n_t=[1.5]", "n_t"),
    # out of bounds
    ("/snell?n_i=0", "n_i"),
    ("/snell?n_i=-1", "n_i"),
    ("/snell?n_i=100.0001", "n_i"),
    ("/snell?n_t=0.00099", "n_t"),
    ("/snell?k_t=-1e-300", "k_t"),
    ("/snell?k_t=101", "k_t"),
    ("/snell?theta_i_deg=-0.001", "theta_i_deg"),
    ("/snell?theta_i_deg=90.00001", "theta_i_deg"),
    ("/curves?samples=1000000000", "samples"),
    ("/curves?samples=99999999999999999999999999", "samples"),
    ("/curves?samples=1", "samples"),
    ("/curves?samples=0", "samples"),
    ("/curves?samples=-1", "samples"),
    ("/curves?samples=181.5", "samples"),
    ("/curves?samples=1e3", "samples"),
    ("/curves?samples=1_000", "samples"),
    ("/curves?digits=2", "digits"),
    ("/curves?digits=18", "digits"),
    ("/curves?format=xml", "format"),
    ("/curves?format=JSON", "format"),
    ("/curves?landmarks=maybe", "landmarks"),
    ("/curves?phase=2", "phase"),
    # names
    ("/snell?N_t=1.5", "N_t"),
    ("/snell?n=1.5", "n"),
    ("/snell?samples=5", "samples"),
    ("/snell?theta_i_deg=5&=1", ""),
    ("/snell?n_t=1.5&n_t=1.5", "n_t"),
    ("/curves?models=exact&models=schlick", "models"),
    ("/models?page=1", "page"),
    ("/parameters?n_t=1", "n_t"),
    # models and their parameters
    ("/curves?models=", "models"),
    ("/curves?models=,", "models"),
    ("/curves?models=exact,", "models"),
    ("/curves?models=exakt", "models"),
    ("/curves?models=exact,exact", "models"),
    ("/curves?models=EXACT", "models"),
    ("/curves?models=../exact", "models"),
    ("/curves?lazanyi2005.alpha=7.7", "lazanyi2005.alpha"),
    ("/curves?models=schlick&lazanyi2005.alpha=7.7", "lazanyi2005.alpha"),
    ("/curves?models=lazanyi2005&lazanyi2005.alpha=nan", "lazanyi2005.alpha"),
    ("/curves?models=lazanyi2005&lazanyi2005.alpha=-1", "lazanyi2005.alpha"),
    ("/curves?models=lazanyi2005&lazanyi2005.beta=1", "lazanyi2005.beta"),
    ("/curves?models=lazanyi2005&lazanyi2005__alpha=7", "lazanyi2005__alpha"),
    ("/curves?models=exact&exact.F0=0.04", "exact.F0"),
    ("/curves?models=lut_1d&lut_1d.size=2.5", "lut_1d.size"),
    ("/curves?models=lut_1d&lut_1d.bits=12", "lut_1d.bits"),
    ("/curves?models=hoffman_f82&hoffman_f82.F0=", "hoffman_f82.F0"),
    ("/curves?models=hoffman_f82&hoffman_f82.F0=1.5", "hoffman_f82.F0"),
    ("/curves?models=hoffman_f82&hoffman_f82.F0=0.1,0.2", "hoffman_f82.F0"),
    ("/curves?models=hoffman_f82&hoffman_f82.F0=0.1,nan,0.2", "hoffman_f82.F0"),
    ("/curves?models=hoffman_f82&hoffman_f82.F0=0_1,0,0", "hoffman_f82.F0"),
]


@pytest.mark.parametrize(("target", "parameter"), REFUSED)
def test_a_bad_parameter_is_named(app: FastAPI, target: str, parameter: str) -> None:
    told = expect_problem(send(app, API + target.encode()), 422)
    assert told["title"].startswith("Unprocessable")  # Entity until Python 3.12, then Content
    assert parameter in [error["parameter"] for error in told["errors"]]
    assert told["instance"] == API.decode() + target.partition("?")[0]


def test_the_value_and_what_is_allowed_are_told(app: FastAPI) -> None:
    (error,) = expect_problem(send(app, API + b"/snell?n_t=1e400"), 422)["errors"]
    assert (error["parameter"], error["value"]) == ("n_t", "1e400")
    assert "0.001 to 100" in error["message"]
    (error,) = expect_problem(send(app, API + b"/curves?samples=1000000000"), 422)["errors"]
    assert error["value"] == "1000000000"
    assert "2 to 20001" in error["message"]
    (error,) = expect_problem(send(app, API + b"/snell?k_t=0&k_t=1"), 422)["errors"]
    assert (error["value"], error["message"]) == (["0", "1"], "given more than once")


def test_all_bad_parameters_are_told_at_once(app: FastAPI) -> None:
    told = expect_problem(send(app, API + b"/snell?n_i=0&n_t=x&k_t=-1&theta_i_deg=91"), 422)
    assert [error["parameter"] for error in told["errors"]] == ["n_i", "n_t", "k_t", "theta_i_deg"]
    told = expect_problem(send(app, API + b"/snell?x=0&y=1&n_t=1&n_t=2"), 422)
    assert [error["parameter"] for error in told["errors"]] == ["x", "y", "n_t"]


@pytest.mark.parametrize(
    ("target", "nearest"),
    [
        ("/curves?models=schlik", "schlick"),
        ("/curves?model=exact", "models"),
        ("/curves?sample=5", "samples"),
        ("/snell?theta_deg=5", "theta_i_deg"),
        ("/curves?models=lazanyi2005&lazanyi2005.alfa=7", "lazanyi2005.alpha"),
    ],
)
def test_unknown_names_list_the_nearest(app: FastAPI, target: str, nearest: str) -> None:
    (error,) = expect_problem(send(app, API + target.encode()), 422)["errors"]
    assert "nearest: " in error["message"]
    assert nearest in error["message"]


MISSING = [
    b"/nope",
    b"/",
    b"",
    b"//snell",
    b"/snell/",
    b"/snell/x",
    b"/snell%20",
    b"/snell%00",
    b"/SNELL",
    b"/models/",
    b"/models/exact/",
    b"/models/nope",
    b"/models/%00",
    b"/models/%ff",
    b"/models/%2e%2e",
    b"/models/..%2f..%2f..%2fetc%2fpasswd",
    b"/%2e%2e/%2e%2e/pyproject.toml",
    b"/../../pyproject.toml",
    b"/..%5c..%5cpyproject.toml",
    b"/models/" + b"a" * 60_000,
    b"/" + b"a/" * 5_000,
]


@pytest.mark.parametrize("path", MISSING, ids=lambda path: repr(path[:40]))
def test_paths_that_name_nothing(app: FastAPI, path: bytes) -> None:
    expect_problem(send(app, API + path), 404)


@pytest.mark.parametrize(
    "path",
    [
        b"/nope",
        b"/%00",
        b"/%ff",
        b"/%2e%2e/pyproject.toml",
        b"/../pyproject.toml",
        b"/vendor/..%2f..%2fpyproject.toml",
        b"/..%5cpyproject.toml",
        b"/%2e%2e%2f%2e%2e%2fetc%2fpasswd",
        b"//etc/passwd",
        b"/%2fetc%2fpasswd",
        b"/vendor",
        b"/css",
        b"/" + b"a" * 60_000,
        b"/" + b"a/" * 5_000,
        b"/api",
    ],
    ids=lambda path: repr(path[:40]),
)
def test_no_trick_reaches_a_file_beyond_the_page(app: FastAPI, path: bytes) -> None:
    expect_problem(send(app, path), 404)


@pytest.mark.parametrize("method", ["POST", "PUT", "DELETE", "PATCH", "OPTIONS", "TRACE", "NOPE"])
@pytest.mark.parametrize("target", [b"/snell", b"/curves?n_t=2", b"/health", b"/models/exact"])
def test_wrong_methods(app: FastAPI, method: str, target: bytes) -> None:
    answer = send(app, API + target, method)
    told = expect_problem(answer, 405)
    assert method in told["detail"]
    assert answer.headers["allow"] == "GET, HEAD"


@pytest.mark.parametrize("method", ["POST", "DELETE"])
def test_wrong_methods_on_the_page(app: FastAPI, method: str) -> None:
    expect_problem(send(app, b"/", method), 405)


LONG = [
    b"/snell?n_t=" + b"1" * 100_000,
    b"/snell?" + b"x" * 100_000 + b"=1",
    b"/snell?" + b"n_t=1&" * 17_000,
    b"/snell?" + b"&".join(b"x%d=1" % i for i in range(12_000)),
    b"/snell?" + b"&".join(b"x%d=1&x%d=2" % (i, i) for i in range(6_000)),
    b"/curves?samples=" + b"9" * 100_000,
    b"/curves?models=" + b"a" * 100_000,
    b"/curves?models=" + b"exact," * 17_000,
    b"/curves?models=" + b",".join(b"m%d" % i for i in range(15_000)),
    b"/curves?models=hoffman_f82&hoffman_f82.F0=" + b"0.5," * 25_000,
    b"/models/" + b"schlick_" * 8_000,
]


@pytest.mark.parametrize("target", LONG, ids=lambda target: repr(target[:30]))
def test_a_long_query_costs_little_and_is_not_echoed_in_full(app: FastAPI, target: bytes) -> None:
    before = time.process_time()
    answer = send(app, API + target)
    assert time.process_time() - before < SECOND
    told = expect_problem(answer, 404, 422)
    assert len(told["errors"]) <= MOST_ERRORS
    if answer.status == 422:
        assert len(answer.body) < 30_000


RAW = [
    b"\xff\xfe",
    b"\x00",
    b"%",
    b"%zz",
    b"%e2%28%a1",
    b"\xed\xa0\x80",
    b"\r\nX: y",
    b" ",
    b"'\"<>",
]


@pytest.mark.parametrize("bad", RAW, ids=repr)
@pytest.mark.parametrize("target", [b"/snell?n_t=", b"/snell?", b"/curves?models=", b"/nope?x="])
def test_bytes_that_are_no_text(app: FastAPI, target: bytes, bad: bytes) -> None:
    expect_problem(send(app, API + target + bad))


names = st.sampled_from(
    ["n_i", "n_t", "k_t", "theta_i_deg", "samples", "models", "digits", "format", "landmarks"]
) | st.text(max_size=12)
values = (
    st.text(max_size=30)
    | st.floats().map(repr)
    | st.integers().map(str)
    | st.sampled_from(["", "nan", "1e400", "-0", "1.5", "exact", "schlick,exact", "true", "csv"])
)
pairs = st.lists(st.tuples(names, values), max_size=6)


@given(path=st.sampled_from(["/snell", "/curves", "/models", "/health"]), query=pairs)
def test_no_query_whatever_makes_the_server_fail(
    app: FastAPI, path: str, query: list[tuple[str, str]]
) -> None:
    text = "&".join(f"{quote(n, safe='')}={quote(v, safe='')}" for n, v in query)
    answer = send(app, API + f"{path}?{text}".encode())
    if answer.status != 200:
        expect_problem(answer, 422)


@given(tail=st.binary(max_size=40))
@example(tail=b"/snell?\x80")
def test_no_bytes_whatever_make_the_server_fail(app: FastAPI, tail: bytes) -> None:
    path, _, query = tail.partition(b"?")
    answer = send(app, API + quote(path, safe="/%").encode() + b"?" + query)
    if answer.status != 200:
        expect_problem(answer, 404, 422)


class TestCrash:
    """A fault in the program is answered without a word about its insides."""

    @pytest.fixture(scope="class")
    @classmethod
    def broken(cls) -> FastAPI:
        def fail(interface: Interface, incidence: Incidence) -> Array:
            return secret(interface, incidence)

        def secret(*_: object) -> NoReturn:
            raise RuntimeError("the password is in /etc/shadow")

        exact = default_registry()["exact"]
        return create_app(registry=Registry([exact, replace(exact, id="broken", function=fail)]))

    def test_is_a_problem_without_trace_or_path(self, broken: FastAPI) -> None:
        answer = send(broken, API + b"/curves?models=broken")
        told = expect_problem(answer, 500)
        assert told["errors"] == []
        for word in (b"Traceback", b"secret", b"password", b"shadow", b".py", b"RuntimeError"):
            assert word not in answer.body
        assert answer.headers["x-content-type-options"] == "nosniff"

    def test_is_no_less_open_to_pages_elsewhere(self, broken: FastAPI) -> None:
        headers = {"Origin": "https://example.org"}
        answer = send(broken, API + b"/curves?models=broken", headers=headers)
        assert answer.status == 500
        assert answer.headers["access-control-allow-origin"] == "*"

    def test_leaves_the_rest_running(self, broken: FastAPI) -> None:
        assert send(broken, API + b"/curves?models=exact").status == 200


@pytest.mark.parametrize(
    ("target", "value"),
    [
        (b"/snell?material=Auu", "Auu"),
        (b"/snell?incident=Au", "Au"),
        (b"/snell?material=Au&wavelength_nm=3", "3"),
        (b"/curves?models=bogus", "bogus"),
        (b"/formulas/brewster", "brewster"),
        (b"/materials/Auu", "Auu"),
        (b"/materials/Au/spectrum?step_nm=0.001", "0.001"),
        (b"/materials/Au/spectrum?minimum_nm=600&maximum_nm=500", "600"),
        (b"/materials/Au/curves?wavelengths_nm=500,b", "b"),
        (b"/convert?from=f0_srgb&hex=zz", "zz"),
    ],
)
def test_the_value_is_told_as_it_was_given(app: FastAPI, target: bytes, value: str) -> None:
    assert [e["value"] for e in send(app, API + target).json()["errors"]] == [value]
