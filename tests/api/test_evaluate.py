"""`POST /evaluate`: the same numbers as elsewhere, in order, whatever else is asked beside them."""

import asyncio
import io
import json
import subprocess
import sys
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from queue import Empty, SimpleQueue
from threading import Event
from typing import Any

import httpx
import numpy as np
import pyarrow as pa
import pytest
from fastapi import FastAPI
from hypothesis import given
from hypothesis import strategies as st

import app.api.evaluate.item_bounds as item_bounds
import app.api.evaluate.items as app_items
from app.optics.registry import default_registry
from app.server.pool import Pool
from tests.api.shape import error_of, rows_of
from tests.api.wire import exchange, get, served
from tests.optics.reference.fresnel import fresnel

ARROW = "application/vnd.apache.arrow.stream"
REGISTRY = default_registry()

Post = Callable[..., httpx.Response]


def poster(app: FastAPI) -> Post:
    def post(
        content: Any, kind: str = "application/json", query: str = "", **headers: str
    ) -> httpx.Response:
        body = content if isinstance(content, bytes) else json.dumps({"items": content}).encode()
        named = {name.replace("_", "-"): value for name, value in headers.items()}
        named["Content-Type"] = kind

        async def request() -> httpx.Response:
            transport = httpx.ASGITransport(app=app, raise_app_exceptions=False)
            async with httpx.AsyncClient(transport=transport, base_url="http://test") as client:
                target = f"/api/v1/evaluate?{query}"
                return await client.post(target, content=body, headers=named)

        return asyncio.run(request())

    return post


@pytest.fixture
def post(app: FastAPI) -> Post:
    return poster(app)


def results(response: httpx.Response) -> list[Any]:
    assert response.status_code == 200, response.text
    answer = response.json()
    assert set(answer) - {"failed_by"} == {"convention", "results", "failed"}
    assert answer["failed"] == sum(isinstance(r, dict) for r in answer["results"])
    found: list[Any] = answer["results"]
    return found


def as_arrow(columns: dict[str, Any]) -> bytes:
    sink = io.BytesIO()
    table = pa.table(columns)
    with pa.ipc.new_stream(sink, table.schema) as stream:
        stream.write_table(table)
    return sink.getvalue()


def from_arrow(response: httpx.Response) -> pa.Table:
    assert response.status_code == 200, response.text
    assert response.headers["content-type"] == ARROW
    return pa.ipc.open_stream(response.content).read_all()


def test_numbers_and_lists_come_back_as_they_went(post: Post) -> None:
    found = results(
        post([{"n_t": 1.5, "theta_i_deg": 0}, {"theta_i_deg": [0, 90]}, {"theta_i_deg": []}, {}])
    )
    assert found == [pytest.approx(0.04), [pytest.approx(0.04), 1.0], [], pytest.approx(0.04)]
    assert results(post([])) == []


def test_exact_values_beside_thirty_digits(post: Post) -> None:
    rng = np.random.default_rng(7)
    rays = [
        (float(n_i), float(n_t), float(k_t), float(theta))
        for n_i, n_t, k_t, theta in rng.uniform(
            (0.5, 0.1, 0.0, 0.0), (3.0, 5.0, 8.0, 90.0), (60, 4)
        )
    ]
    quantities = {name: name for name in ("R", "Rs", "Rp", "T", "Ts", "Tp")}
    quantities |= {"penetration_depth_wavelengths": "depth", "theta_t_deg": "theta_t_deg"}
    quantities |= {"field_penetration_depth_wavelengths": "field_depth"}
    items = [
        dict(zip(("n_i", "n_t", "k_t", "theta_i_deg"), ray, strict=True)) | {"quantity": quantity}
        for ray in rays
        for quantity in quantities
    ]
    expected = [float(getattr(fresnel(*ray), name)) for ray in rays for name in quantities.values()]
    np.testing.assert_allclose(results(post(items)), expected, rtol=1e-12)


@pytest.mark.parametrize("model", REGISTRY)
def test_every_model_gives_what_curves_gives(
    post: Post, ask: Callable[..., httpx.Response], model: str
) -> None:
    medium = (
        {"n_t": 1.5} if "dielectric" in REGISTRY[model].applies_to else {"n_t": 0.27, "k_t": 2.9}
    )
    curve = next(
        c["values"]
        for c in ask("/curves", models=model, samples=19, **medium).json()["curves"]
        if c["quantity"] == "R"
    )
    angles = np.linspace(0.0, 90.0, 19).tolist()
    (together,) = results(post([medium | {"model": model, "theta_i_deg": angles}]))
    apart = results(post([medium | {"model": model, "theta_i_deg": angle} for angle in angles]))
    for found in (together, apart):
        np.testing.assert_allclose(
            np.array(found, float), np.array(curve, float), rtol=1e-12, atol=1e-15
        )


RADIANS = [0.0, 0.3, 0.9827937232473290, 1.2, float(np.pi / 2)]


@pytest.mark.parametrize("more", [{}, {"layers": "1.38:100"}, {"model": "schlick"}])
def test_angles_in_radians_are_those_of_snell(post: Post, more: dict[str, Any]) -> None:
    """To the last digit: radians do not become degrees on the way, where Rp is 0 least of all."""
    item = {"n_t": 1.5, **more}
    together, mixed = results(
        post([item | {"theta_i_rad": RADIANS}, item | {"theta_i_rad": RADIANS[1]}])
    )
    degrees = results(post([item | {"theta_i_deg": np.degrees(RADIANS).tolist()}]))[0]
    np.testing.assert_allclose(together, degrees, rtol=1e-9, atol=1e-15)
    assert mixed == together[1]
    assert together[-1] == 1.0
    (Rp,) = results(post([{"n_t": 1.5, "quantity": "Rp", "theta_i_rad": RADIANS[2]}]))
    assert Rp < 1e-31


def test_an_angle_comes_once(post: Post) -> None:
    both = {"theta_i_rad": 1.0, "theta_i_deg": 60.0}
    found = results(
        post([both, {"theta_i_rad": [1.0], "theta_i_deg": 2}, {"theta_i_rad": 1.6}, {}])
    )
    names = [one["errors"][0]["parameter"] for one in found[:3]]
    assert names == ["theta_i_deg", "theta_i_deg", "theta_i_rad"]
    assert found[3] == pytest.approx(0.04)
    columns = {
        "theta_i_rad": pa.array([1.0, None, 0.5, None]),
        "theta_i_deg": pa.array([None, 60.0, 3.0, None]),
    }
    table = from_arrow(post(as_arrow(columns), ARROW))
    expected = [float(fresnel(1.0, 1.5, 0.0, angle).R) for angle in (np.degrees(1.0), 60.0, 0.0)]
    values = table["value"].to_pylist()
    assert [values[0], values[1], values[3]] == pytest.approx(expected, rel=1e-12)
    assert table["error"].to_pylist()[2].startswith("theta_i_deg = 3.0: given beside theta_i_rad")


def test_groups_keep_the_order(post: Post) -> None:
    rng = np.random.default_rng(1)
    models = ["exact", "schlick", "lagarde_gc", "one_minus_cos", "lut_1d"]
    items = [
        {
            "model": models[rng.integers(5)],
            "n_t": float(rng.uniform(1.1, 3.0)),
            "theta_i_deg": float(rng.uniform(0.0, 90.0)),
        }
        for _ in range(500)
    ]
    together = results(post(items))
    apart = [results(post([item]))[0] for item in items[:40]]
    np.testing.assert_allclose(together[:40], apart, rtol=1e-13)


def test_a_models_own_parameters(post: Post) -> None:
    items = [
        {"model": "schlick", "schlick.F0": 0.5, "theta_i_deg": 0},
        {"model": "schlick", "theta_i_deg": 0},
        {"model": "lut_1d", "lut_1d.size": 2, "lut_1d.filtering": "nearest"},
        {"model": "lut_1d", "lut_1d.size": 3, "lut_1d.bits": "8", "theta_i_deg": 85},
    ]
    found = results(post(items))
    assert found[:3] == [0.5, pytest.approx(0.04), pytest.approx(0.04)]
    assert 0.04 < found[3] < 1.0


@pytest.mark.parametrize("rare", [{"k_t": 3.0}, {"quantity": "Rp"}, {"theta_i_deg": [30, 60]}])
def test_what_few_items_hold_is_not_lost(post: Post, rare: dict[str, Any]) -> None:
    """Items are read as though all held what some of them hold, and again where one holds more."""
    usual = {"n_t": 1.5, "theta_i_deg": 60}
    for at in range(0, 200, 7):
        items = [usual] * 200
        items[at] = usual | rare
        found = results(post(items))
        (alone,) = results(post([usual | rare]))
        assert found[at] == alone != found[at - 1]
        assert all(found[other] == found[at - 1] for other in range(200) if other != at)


WRONG = [
    ({"n_t": -1}, "n_t", -1.0, "0.001 to 100"),
    ({"n_t": "glass"}, "n_t", "glass", "float"),
    ({"n_t": None}, "n_t", None, "float"),
    ({"theta_i_deg": [1, 91, 2]}, "theta_i_deg", 91.0, "0 to 90 deg"),
    ({"theta_i_deg": [1, "x"]}, "theta_i_deg", None, "float"),
    ({"theta": 3}, "theta", 3, "theta_i_deg"),
    ({"model": "schlik"}, "model", "schlik", "schlick"),
    ({"quantity": "Q"}, "quantity", "Q", "Rs"),
    ({"model": "schlick", "quantity": "Rs"}, "quantity", "Rs", "R alone"),
    ({"schlick.F0": 0.1}, "schlick.F0", 0.1, "exact"),
    ({"model": "schlick", "schlick.F0": 2}, "schlick.F0", 2.0, "0 to 1"),
    ({"model": "lut_1d", "lut_1d.bits": "7"}, "lut_1d.bits", "7", "7"),
    ({"model": "lut_1d", "lut_1d.size": 2.5}, "lut_1d.size", 2.5, "whole"),
    (5, "items", 5, "object"),
    ({"odd": 10**30}, "odd", str(10**30), "unknown"),
]


@pytest.mark.parametrize(("item", "parameter", "value", "hint"), WRONG)
def test_what_is_wrong_stands_in_its_place(
    post: Post, item: Any, parameter: str, value: object, hint: str
) -> None:
    good = {"n_t": 1.5}
    answered = results(post([good, item, {"theta_i_deg": [0, 0]}]))
    assert answered[0] == pytest.approx(0.04)
    assert answered[2] == pytest.approx([0.04, 0.04])
    assert answered[1]["index"] == 1
    (error,) = answered[1]["errors"]
    assert (error["parameter"], error["value"]) == (parameter, value)
    assert hint in error["message"]


@pytest.mark.parametrize(
    "body",
    [
        b"",
        b"{",
        b"[]",
        b"{}",
        b'{"items": 5}',
        b'{"items": [], "n": 1}',
        b"\xff\xfe",
        b"[" * 100_000,
    ],
)
def test_a_body_that_is_none(post: Post, body: bytes) -> None:
    assert error_of(post(body))["parameter"] == "items"


REPEATED = [
    (b'{"n_t":1.5,"n_t":2}', "n_t"),
    (b'{"theta_i_deg":[1],"n_t":1.5,"theta_i_deg":2}', "theta_i_deg"),
    (b'{"model":"exact","model":"exact"}', "model"),
    (b'{"n_t":1.5,"n\\u005ft":1.5}', "n_t"),
]


@pytest.mark.parametrize(("item", "parameter"), REPEATED)
def test_a_field_given_twice_is_refused(post: Post, item: bytes, parameter: str) -> None:
    good = b'{"n_t":1.5}'
    answered = results(post(b'{"items":[' + b",".join([good, item, good, b"5"]) + b"]}"))
    assert answered[0] == answered[2] == pytest.approx(0.04)
    (error,) = answered[1]["errors"]
    assert (error["parameter"], error["message"]) == (parameter, "given more than once")
    assert error_of(post(b'{"items":[],"items":[{}]}'))["message"].startswith("`items` is given")


def test_a_colon_in_a_name_is_no_field(post: Post) -> None:
    answered = results(post([{"material": "rii:x/y:z"}, {"model": "a:b"}, {"n_t": 1.5}]))
    assert [answered[i]["errors"][0]["parameter"] for i in (0, 1)] == ["material", "model"]
    assert answered[2] == pytest.approx(0.04)


ITEMS = st.lists(
    st.fixed_dictionaries(
        {},
        optional={
            "n_t": st.floats(-1, 3) | st.just("glass"),
            "theta_i_deg": st.floats(0, 90) | st.lists(st.floats(0, 90), max_size=4),
            "model": st.sampled_from(["exact", "schlick", "},{", '"},', "[:"]),
            "odd": st.lists(st.fixed_dictionaries({"a": st.integers()}), max_size=3),
        },
    )
    | st.integers()
    | st.lists(st.none(), max_size=2),
    max_size=20,
)


@given(items=ITEMS, indent=st.sampled_from([None, 1]), window=st.integers(10, 200))
def test_items_are_the_same_wherever_the_body_is_parted(
    app: FastAPI, items: list[Any], indent: int | None, window: int
) -> None:
    text = json.dumps({"items": items}, indent=indent).encode()
    whole = results(poster(app)(text))
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(app_items, "_WINDOW", window)
        patched.setattr(item_bounds, "_LONGEST_ANGLE", 10_000)
        assert results(poster(app)(text)) == whole
    assert len(whole) == len(items)


@pytest.mark.parametrize("wrong", [{"n_t": -1}, {"odd": 1}, 5])
def test_the_first_hundred_are_told_in_full_and_the_others_counted(post: Post, wrong: Any) -> None:
    items = [{"n_t": 1.5}, *[wrong] * 150, {"k_t": -1.0}, {}]
    answer = post(items).json()
    answered = answer["results"]
    assert answered[0] == answered[-1] == pytest.approx(0.04)
    assert [entry["index"] for entry in answered[1:-1]] == list(range(1, 152))
    assert [len(entry["errors"]) for entry in answered[1:-1]] == [1] * 100 + [0] * 51
    assert answer["failed"] == sum(answer["failed_by"].values()) == 151
    assert answer["failed_by"]["k_t"] == 1
    rows = rows_of(post(items, accept="text/csv"))
    table = from_arrow(post(items, accept=ARROW))
    for errors in ([row["error"] for row in rows], table["error"].to_pylist()):
        assert errors[1] == errors[100]
        assert len(errors[1]) > 0
        assert errors[101].endswith(": wrong; 100 rows are told in full")
    few = post(items[:50]).json()
    assert (few["failed"], "failed_by" in few) == (49, False)


def test_a_long_item_is_wrong_as_a_short_one_is(post: Post) -> None:
    """It is answered in parts, of which one has the wrong angle."""
    theta = [0.0] * 200_000
    theta[150_000] = 91.0
    answered = results(post([{"theta_i_deg": theta}, {"theta_i_deg": theta[:100_000]}]))
    assert answered[0]["errors"][0]["value"] == 91.0
    assert len(answered[1]) == 100_000
    table = from_arrow(post([{"theta_i_deg": theta}, {}], accept=ARROW))
    assert table["value"].null_count == 200_000
    assert table["item"].to_pylist()[-1] == 1


def test_many_small_batches_are_as_one(post: Post) -> None:
    """Each with a dictionary of its own, or all with one, of which rows say a little."""
    names = ["Au", None, "water", "nope", *(f"x{i}" for i in range(1000))]
    for shared in (False, True):
        batches = []
        for i in range(60):
            said = pa.array(names if shared else names[i % 3 :] + names[: i % 3])
            codes = pa.array([i % 4, 0, None], pa.int32())
            material = pa.DictionaryArray.from_arrays(codes, said)
            batches.append(pa.record_batch({"material": material}))
        sink = io.BytesIO()
        with pa.ipc.new_stream(sink, batches[0].schema) as stream:
            for batch in batches:
                stream.write_batch(batch)
        found = from_arrow(post(sink.getvalue(), ARROW))["value"].to_pylist()
        asked = [name for batch in batches for name in batch["material"].to_pylist()]
        expected = results(post([{} if name is None else {"material": name} for name in asked]))
        expected = [None if isinstance(one, dict) else one for one in expected]
        assert found == expected


def test_csv(post: Post) -> None:
    items = [{"theta_i_deg": [0, 90]}, {"n_t": -1}, {"n_t": 1.0, "k_t": 0}]
    rows = rows_of(post(items, accept="text/csv"))
    assert [row["item"] for row in rows] == ["0", "0", "1", "2"]
    assert [row["value"] for row in rows[1:]] == ["1.0", "", "0.0"]
    assert float(rows[0]["value"]) == pytest.approx(0.04)
    assert rows[1]["error"] == ""
    assert rows[2]["error"].startswith("n_t = -1.0: ")


def test_arrow_both_ways(post: Post) -> None:
    theta = np.linspace(0.0, 90.0, 200_000)
    columns = {
        "n_t": pa.array(np.where(np.arange(theta.size) % 2, 1.5, 0.27)),
        "k_t": pa.array(np.where(np.arange(theta.size) % 2, 0.0, 2.9)),
        "theta_i_deg": pa.array(theta),
        "model": pa.array(["exact", "schlick", None, "lut_1d"] * 50_000),
    }
    table = from_arrow(post(as_arrow(columns), ARROW))
    assert table.schema.names == ["item", "value", "error"]
    assert table["item"].to_pylist()[::50_000] == [0, 50_000, 100_000, 150_000]
    assert table["error"].null_count == theta.size
    at = list(range(0, 200_000, 8_191))
    items = [
        {"n_t": 1.5 if i % 2 else 0.27, "k_t": 0.0 if i % 2 else 2.9, "theta_i_deg": theta[i],
         "model": ["exact", "schlick", "exact", "lut_1d"][i % 4]}
        for i in at
    ]  # fmt: skip
    found = table["value"].to_numpy()[at]
    np.testing.assert_allclose(found, results(post(items)), rtol=1e-13)


def test_arrow_rows_that_are_wrong(post: Post) -> None:
    columns = {
        "n_t": pa.array([1.5, float("nan"), None, -1.0], pa.float64()),
        "model": pa.array(["exact", "exact", "exact", "exact"]).dictionary_encode(),
    }
    table = from_arrow(post(as_arrow(columns), ARROW))
    assert table["value"].to_pylist() == [pytest.approx(0.04), None, pytest.approx(0.04), None]
    errors = table["error"].to_pylist()
    assert errors[0] is None
    assert errors[1].startswith("n_t = nan")
    assert errors[3].startswith("n_t = -1.0")


def test_arrow_integers_and_choices(post: Post) -> None:
    columns = {
        "theta_i_deg": pa.array([0, 90], pa.int16()),
        "model": pa.array(["lut_1d", "lut_1d"]),
        "lut_1d.filtering": pa.array(["nearest", "cubic"]),
    }
    table = from_arrow(post(as_arrow(columns), ARROW))
    assert table["value"].to_pylist() == [pytest.approx(0.04), None]
    assert "linear" in table["error"].to_pylist()[1]


@pytest.mark.parametrize(
    ("columns", "parameter"),
    [
        ({"theta": [1.0]}, "theta"),
        ({"n_t": ["1.5"]}, "n_t"),
        ({"model": [1]}, "model"),
        ({"n_t": [[1.5]]}, "n_t"),
    ],
)
def test_arrow_columns_that_are_wrong(post: Post, columns: dict[str, Any], parameter: str) -> None:
    assert error_of(post(as_arrow(columns), ARROW))["parameter"] == parameter


def test_arrow_bytes_that_are_none(post: Post) -> None:
    good = as_arrow({"n_t": np.full(1000, 1.5), "model": ["exact"] * 1000})
    rng = np.random.default_rng(0)
    bodies = [b"", b"x" * 100, good[:50], good[: len(good) // 2]]
    for _ in range(200):
        damaged = bytearray(good)
        for at in rng.integers(0, len(good), 4):
            damaged[at] ^= 1 << int(rng.integers(8))
        bodies.append(bytes(damaged))
    for body in bodies:
        assert post(body, ARROW).status_code in (200, 413, 422)


def test_what_a_compressed_stream_holds_is_not_taken_on_trust(post: Post) -> None:
    table = pa.table({"n_t": np.full(100_000, 1.5)})
    sink = io.BytesIO()
    options = pa.ipc.IpcWriteOptions(compression="zstd")
    with pa.ipc.new_stream(sink, table.schema, options=options) as stream:
        stream.write_table(table)
    response = post(sink.getvalue(), ARROW)
    assert response.status_code == 422
    assert "compressed" in response.json()["detail"]


@pytest.mark.parametrize(
    ("accept", "kind"),
    [
        ("application/json", "application/json"),
        ("text/csv;q=0.5, application/json;q=0.4", "text/csv; charset=utf-8"),
        ("text/*", "text/csv; charset=utf-8"),
        (f"{ARROW}, */*;q=0.1", ARROW),
        ("*/*", "application/json"),
        ("application/*;q=0, */*", "text/csv; charset=utf-8"),
    ],
)
def test_the_kind_of_answer_is_asked_for(post: Post, accept: str, kind: str) -> None:
    response = post([{}], accept=accept)
    assert (response.status_code, response.headers["content-type"]) == (200, kind)


def test_kinds_that_are_not_there(post: Post) -> None:
    response = post([{}], accept="image/png")
    assert (response.status_code, response.json()["status"]) == (406, 406)
    assert "text/csv" in response.json()["detail"]
    for headers in ({"kind": "text/plain"}, {"content_encoding": "gzip"}):
        response = post([{}], **headers)
        assert response.status_code == 415
        assert response.headers["accept-post"] == f"application/json, {ARROW}"


def test_a_million_values_and_no_more(post: Post) -> None:
    text = b'{"items":[{"theta_i_deg":[' + b",".join([b"1"] * 1_000_000) + b"]}]}"
    (found,) = results(post(text))
    assert len(found) == 1_000_000
    more = text.replace(b"]}]}", b"]},{}]}")
    assert post(more).status_code == 413
    rows = as_arrow({"theta_i_deg": np.zeros(1_000_001, np.int8)})
    assert post(rows, ARROW).status_code == 413


def test_no_query_but_digits(post: Post) -> None:
    assert error_of(post([], query="samples=3"))["parameter"] == "samples"


def test_health_answers_whatever_a_large_call_is_at(monkeypatch: pytest.MonkeyPatch) -> None:
    """Reading the items and each piece of the answer wait in turn until somebody else was answered."""
    begun: SimpleQueue[Event] = SimpleQueue()
    run = Pool.run

    def held(pool: Pool, function: Callable[[], Any], **how: Any) -> Any:
        def wait() -> Any:
            go_on = Event()
            begun.put(go_on)
            assert go_on.wait(10)
            return function()

        return run(pool, wait, **how)

    monkeypatch.setattr(Pool, "run", held)
    items = b",".join([b'{"theta_i_deg":60}'] * 100_000)
    body = b'{"items":[' + items + b"]}"
    head = b"POST /api/v1/evaluate HTTP/1.1\r\nHost: test\r\nConnection: close\r\n"
    request = head + b"Content-Length: %d\r\n\r\n" % len(body) + body
    steps = 0
    with served() as address, ThreadPoolExecutor(1) as clients:
        call = clients.submit(exchange, address, request)
        while not call.done():
            with suppress(Empty):
                go_on = begun.get(timeout=0.05)
                assert get(address, b"/api/v1/health").status == 200
                go_on.set()
                steps += 1
        assert call.result().status == 200
    assert steps >= 2


WITHOUT_PYARROW = """
import asyncio, json, sys
sys.modules["pyarrow"] = None  # as if it were not installed
import httpx
from app.main import create_app

async def ask():
    async with httpx.AsyncClient(
        transport=httpx.ASGITransport(create_app()), base_url="http://test"
    ) as client:
        for kind, accept in json.loads(sys.argv[1]):
            headers = {"Content-Type": kind, "Accept": accept}
            answer = await client.post(
                "/api/v1/evaluate", content=b'{"items": [{}]}', headers=headers
            )
            print(answer.status_code, answer.headers["content-type"])
            print(answer.text.splitlines()[0])

asyncio.run(ask())
"""


def test_without_pyarrow_the_other_kinds_remain() -> None:
    asked = [("application/json", ARROW), (ARROW, "*/*"), ("application/json", f"{ARROW}, */*")]
    ran = subprocess.run(
        [sys.executable, "-c", WITHOUT_PYARROW, json.dumps(asked)],
        capture_output=True,
        text=True,
        check=True,
    )
    status = ran.stdout.splitlines()
    assert status[::2] == [
        "406 application/problem+json",
        "415 application/problem+json",
        "200 application/json",
    ]
    no_answer, not_read, answered = (json.loads(line) for line in status[1::2])
    assert no_answer["detail"].endswith("application/json, text/csv")
    assert "send application/json, not compressed" in not_read["detail"]
    assert answered["results"] == [pytest.approx(0.04)]
