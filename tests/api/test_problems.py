"""Every error is a problem (RFC 9457) that names the parameter, the value and what is allowed."""

import time
from dataclasses import replace
from typing import Any, NoReturn
from urllib.parse import quote

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
from app.settings import Settings
from tests.api.raw import Answer, send
from tests.api.shape import Ask, error_of

API = b"/api/v1"
SECOND = 1.0
"""More than any refusal may take, on a busy machine too."""


@pytest.fixture(scope="session")
def app() -> FastAPI:
    """One that reads targets as long as may be set; test_limits has those that are longer."""
    return create_app(Settings(max_target_bytes=65_535))


def expect_problem(answer: Answer, *statuses: int) -> dict[str, Any]:
    """Check that an answer is a problem in every respect, and return it."""
    assert answer.headers["content-type"] == MEDIA_TYPE, (answer.status, answer.body[:200])
    told = Problem.model_validate_json(answer.body, strict=True, extra="forbid")
    assert told.status == answer.status
    assert answer.status in (statuses or range(400, 500)), told.detail
    assert told.type == "about:blank"
    assert told.title
    assert told.detail
    assert "Value error" not in told.detail  # what pydantic puts before the words of a validator
    for error in told.errors:
        assert error.message
    assert "cache-control" not in answer.headers
    return told.model_dump()


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


NO_TRIPLE = ("", "a", "1,2", "0.1,,0.3", "0.1,0.2,0.3,0.4", "0_1", "0_1,0.2,0.3")
OUT_OF_BOUNDS = ("nan", "2", "0.1,0.2,inf", "0.1,-0.1,0.3")


@pytest.mark.parametrize(
    ("value", "message"),
    [(value, "one number, or three separated by commas") for value in NO_TRIPLE]
    + [(value, "a finite number from 0 to 1") for value in OUT_OF_BOUNDS],
)
def test_what_is_no_triple_is_one_error(ask: Ask, value: str, message: str) -> None:
    name = "generalized_schlick.F0"
    error = error_of(ask("/curves", models="generalized_schlick", **{name: value}))
    assert (error["parameter"], error["message"]) == (name, message)
    assert error["value"] == value or value in OUT_OF_BOUNDS


def test_what_is_no_number_is_said_plainly(ask: Ask) -> None:
    error = error_of(ask("/snell", n_t="1_5"))
    assert error["message"] == "a number has no underscore; allowed: 0.001 to 100.0"
    error = error_of(ask("/convert", **{"from": "f0", "F0": "1,0_1,0"}))
    assert error["message"].startswith("a number has no underscore")
    for text in ("1.5;n_i=2", "n_t", "_", "1,n_i,2"):
        for target, query in (("/snell", {"n_t": text}), ("/convert", {"from": "f0", "F0": text})):
            for error in ask(target, **query).json()["errors"]:
                assert "underscore" not in error["message"]


MISSING = [
    b"",
    *b"/nope / //snell /snell/ /snell/x /snell%20 /snell%00 /SNELL /models/ /models/exact/".split(),
    *b"/models/nope /models/%00 /models/%ff /models/%2e%2e".split(),
    *b"/models/..%2f..%2f..%2fetc%2fpasswd /%2e%2e/%2e%2e/pyproject.toml".split(),
    *b"/../../pyproject.toml /..%5c..%5cpyproject.toml".split(),
    *b"/materials/nothing /materials/..%2f..%2fetc%2fpasswd /materials/%00".split(),
    *b"/materials/nothing/spectrum /materials/nothing/map".split(),
    b"/materials/" + b"x" * 5000,
    b"/models/" + b"a" * 60_000,
    b"/" + b"a/" * 5_000,
]


@pytest.mark.parametrize("path", MISSING, ids=lambda path: repr(path[:40]))
def test_paths_that_name_nothing(app: FastAPI, path: bytes) -> None:
    expect_problem(send(app, API + path), 404)


@pytest.mark.parametrize(
    "path",
    [
        *b"/nope /%00 /%ff /%2e%2e/pyproject.toml /../pyproject.toml /..%5cpyproject.toml".split(),
        *b"/vendor/..%2f..%2fpyproject.toml /%2e%2e%2f%2e%2e%2fetc%2fpasswd //etc/passwd".split(),
        *b"/%2fetc%2fpasswd /vendor /css /api".split(),
        b"/" + b"a" * 60_000,
        b"/" + b"a/" * 5_000,
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
    b"/snell?n_t=" + b"1" * 60_000,
    b"/snell?" + b"x" * 60_000 + b"=1",
    b"/snell?" + b"n_t=1&" * 10_000,
    b"/snell?" + b"&".join(b"x%d=1" % i for i in range(7_000)),
    b"/snell?" + b"&".join(b"x%d=1&x%d=2" % (i, i) for i in range(3_500)),
    b"/curves?samples=" + b"9" * 60_000,
    b"/curves?models=" + b"a" * 60_000,
    b"/curves?models=" + b"exact," * 10_000,
    b"/curves?models=" + b",".join(b"m%d" % i for i in range(9_000)),
    b"/curves?models=hoffman_f82&hoffman_f82.F0=" + b"0.5," * 15_000,
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
        headers = {"Origin": "https://example.org"}
        answer = send(broken, API + b"/curves?models=broken", headers=headers)
        told = expect_problem(answer, 500)
        assert answer.headers["access-control-allow-origin"] == "*"
        assert told["errors"] == []
        for word in (b"Traceback", b"secret", b"password", b"shadow", b".py", b"RuntimeError"):
            assert word not in answer.body
        assert answer.headers["x-content-type-options"] == "nosniff"

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
