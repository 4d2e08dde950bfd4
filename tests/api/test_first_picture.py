"""The document with the first picture of the state in its address, and the packed page."""

import cmath
import json
import math
import re
import shutil
from pathlib import Path

import pytest
from fastapi import FastAPI
from hypothesis import given
from hypothesis import strategies as st

from app.main import create_app
from app.page.document import Document
from app.page.first_picture import ANGLE_DEG, NEGLIGIBLE, FirstPicture
from app.page.packed import FOLDER, MANIFEST, digest, packed, page_form
from app.settings import Settings
from tests.api.raw import Answer, send

STATIC = Settings().static_dir


@pytest.fixture(scope="session")
def app() -> FastAPI:
    return create_app(Settings(page="sources"))


def page(app: FastAPI, query: str = "") -> Answer:
    answer = send(app, b"/" + query.encode())
    assert answer.status == 200
    return answer


def curve(text: str, color: str) -> list[tuple[float, float]]:
    """Points of a curve, as angle in degrees and reflectance, from its relative path."""
    found = re.search(rf"stroke:var\(--{color}\)[^>]*d=\"M([^\"]+)\"", text)
    assert found
    start, *steps = found[1].split("l")
    x, y = map(int, start.split())
    points = [(x, y)]
    for step in steps:
        dx, dy = map(int, re.findall(r"-?\d+", step))
        x, y = x + dx, y + dy
        points.append((x, y))
    return [(x / 20, 1 - y / 2000) for x, y in points]


def textbook(n: complex, theta_deg: float, n_i: float = 1.0) -> tuple[float, float]:
    """Rs and Rp from the equations in angles of a textbook."""
    ti = math.radians(theta_deg)
    tt = cmath.asin(n_i * math.sin(ti) / n)
    rs = (n_i * math.cos(ti) - n * cmath.cos(tt)) / (n_i * math.cos(ti) + n * cmath.cos(tt))
    rp = (n * math.cos(ti) - n_i * cmath.cos(tt)) / (n * math.cos(ti) + n_i * cmath.cos(tt))
    return abs(rs) ** 2, abs(rp) ** 2


@pytest.mark.parametrize(
    ("query", "n", "n_i"),
    [
        ("", 1.5, 1.0),
        ("?n_t=1.333", 1.333, 1.0),
        ("?material=water-shirley", 1.333, 1.0),
        ("?n_t=0.2&k_t=3", 0.2 + 3j, 1.0),
        ("?n_i=1.5&n_t=1&theta_i_deg=20", 1.0, 1.5),
    ],
)
def test_the_curves_are_those_of_the_state(
    app: FastAPI, query: str, n: complex, n_i: float
) -> None:
    text = page(app, query).body.decode()
    for number, color in enumerate(("Rs", "Rp")):
        points = curve(text, color)
        assert len(points) >= 181
        for angle, value in points[5:-5:10]:
            # x is rounded to 0.05 degrees, y to 0.0005
            near = [textbook(n, angle + d, n_i)[number] for d in (-0.05, 0.0, 0.05)]
            assert min(near) - 1e-3 <= value <= max(near) + 1e-3


def test_the_ray_is_that_of_the_address(app: FastAPI) -> None:
    text = page(app, "?n_t=1.5&theta_i_deg=30").body.decode()
    assert 'aria-label="Ray at 30.00°: 4.2 % reflected"' in text
    directions = re.findall(r'ray-direction[^>]*d="M0 0L(-?[\d.]+) (-?[\d.]+)"', text)
    reflected, refracted = [(float(x), float(y)) for x, y in directions]
    assert math.degrees(math.atan2(reflected[0], -reflected[1])) == pytest.approx(30, abs=0.01)
    expected = math.degrees(math.asin(0.5 / 1.5))
    assert math.degrees(math.atan2(refracted[0], refracted[1])) == pytest.approx(expected, abs=0.01)
    total = page(app, "?n_i=1.5&n_t=1&theta_i_deg=60").body.decode()
    assert total.count("ray-direction") == 1  # nothing is refracted


@pytest.mark.parametrize(
    "query",
    [
        "?n_t=abc",
        "?n_t=1e9",
        "?n_t=",
        "?theta_i_deg=91",
        "?material=nothing",
        "?incident=Au",
        "?polarization=x",
        "?models=nothing",
        "?view=theory",
        "?material=%3Cscript%3Ealert(1)%3C/script%3E",
        "?" + "&".join(f"a{i}=1" for i in range(200)),
        "?n_t=" + "1" * 3000,
        "?n_t=%ff",
    ],
)
def test_what_cannot_be_drawn_starts_with_the_plain_page(app: FastAPI, query: str) -> None:
    answer = page(app, query)
    assert answer.body == send(app, b"/index.html").body
    assert b"first-curves" not in answer.body


@given(
    names=st.lists(
        st.sampled_from(
            ["n_i", "n_t", "k_t", "theta_i_deg", "material", "incident", "wavelength_nm", "models"]
        ),
        max_size=5,
    ),
    values=st.lists(
        st.one_of(
            st.sampled_from(
                [
                    "Au",
                    "BK7",
                    "water",
                    "schlick",
                    "lut_1d",
                    "<i>x",
                    "<script>",
                    '"',
                    "%00",
                    "&",
                    "1,2",
                ]
            ),
            st.floats().map(repr),
            st.text(max_size=8),
        ),
        min_size=5,
        max_size=5,
    ),
)
def test_no_address_fails_or_puts_markup_into_the_page(
    app: FastAPI, names: list[str], values: list[str]
) -> None:
    query = "&".join(f"{n}={v}" for n, v in zip(names, values, strict=False))
    answer = send(app, b"/?" + query.encode("utf-8", "replace").replace(b" ", b"+"))
    assert answer.status == 200
    assert b"<script>" not in answer.body
    assert b"<i>x" not in answer.body


def test_the_document_is_tagged_and_asked_after(app: FastAPI) -> None:
    first = page(app, "?n_t=1.7")
    assert first.headers["cache-control"] == "no-cache"
    assert "script-src 'self'" in first.headers["content-security-policy"]
    again = send(app, b"/?n_t=1.7", "GET", {"If-None-Match": first.headers["etag"]})
    assert again.status == 304
    head = send(app, b"/?n_t=1.7", "HEAD", {})
    assert (head.status, head.body) == (200, b"")
    assert page(app).headers["etag"] != first.headers["etag"]


def test_no_script_or_style_stands_in_the_document(app: FastAPI) -> None:
    text = page(app, "?models=schlick").body.decode()
    assert re.findall(r"<script(?![^>]*\bsrc=)|<style|\son\w+=", text) == []


def test_numbers_that_the_page_writes_too_are_the_same() -> None:
    script = (STATIC / "js" / "main.js").read_text("utf-8")
    assert f"const PAGE_ANGLE = {ANGLE_DEG:g};" in script
    media = (STATIC / "js" / "media" / "media.js").read_text("utf-8")
    written = re.search(r"NEGLIGIBLE = (\S+);", media)
    assert written
    assert float(written[1]) == NEGLIGIBLE


def test_the_tabs_are_those_of_the_views() -> None:
    script = (STATIC / "js" / "main.js").read_text("utf-8")
    views = re.findall(r'\{ id: "(\w+)", title: "(\w+)"', script)
    tabs = re.findall(r'data-view="(\w+)">(\w+)<', (STATIC / "index.html").read_text("utf-8"))
    assert tabs == views


class TestPacked:
    """What `tools/pack.mjs` makes is packed by hand here: that it is made is tested in a browser."""

    @pytest.fixture
    def folder(self, tmp_path: Path) -> Path:
        copy = tmp_path / "static"
        shutil.copytree(STATIC, copy, ignore=shutil.ignore_patterns(FOLDER))
        (copy / FOLDER).mkdir()
        names = {"main": "main-1.js", "first": ["first-2.js"], "style": "first-3.css"}
        for name in ("main-1.js", "first-2.js", "first-3.css", "main-1.js.map"):
            (copy / FOLDER / name).write_text("{}")
        manifest = {"sources": digest(copy), **names}
        (copy / MANIFEST).write_text(json.dumps(manifest))
        return copy

    def test_the_document_names_the_packed_files(self, folder: Path) -> None:
        app = create_app(Settings(static_dir=folder, page="packed"))
        text = page(app).body.decode()
        named = re.findall(r'(?:href|src)="(packed/[^"]+)"', text)
        assert sorted(set(named)) == ["packed/first-2.js", "packed/first-3.css", "packed/main-1.js"]
        assert "js/main.js" not in text
        assert "css/base.css" not in text
        for name in named:
            answer = send(app, f"/{name}".encode())
            assert answer.headers["cache-control"] == "public, max-age=31536000, immutable"
        source_map = send(app, b"/packed/main-1.js.map")
        assert source_map.headers["content-type"] == "application/json"
        assert send(app, f"/{MANIFEST}".encode()).headers["cache-control"] == "no-cache"
        worker = send(app, b"/sw.js").body.decode()
        assert '"packed/main-1.js"' in worker
        assert '"js/main.js"' not in worker
        assert '"js/page/theme.js"' in worker

    def test_a_page_that_is_older_than_its_sources_is_not_taken(self, folder: Path) -> None:
        assert packed(folder) is not None
        with (folder / "js" / "main.js").open("a") as script:
            script.write("\n")
        assert packed(folder) is None
        assert b'"js/main.js"' in page(create_app(Settings(static_dir=folder))).body
        with pytest.raises(ValueError, match="make pack"):
            page_form("packed", folder)

    @pytest.mark.parametrize("text", ["", "[]", '{"sources": 1}'])
    def test_a_manifest_that_is_none_is_as_if_it_were_missing(
        self, folder: Path, text: str
    ) -> None:
        (folder / MANIFEST).write_text(text)
        assert packed(folder) is None
        assert page_form("auto", folder) is None


def test_light_from_the_denser_side_comes_from_below(app: FastAPI) -> None:
    turned = 'first-ray" viewBox="-1 -1 2 2"'
    for query, below in (("?n_i=1.333&n_t=1", True), ("?n_t=1.5", False), ("?n_i=2&k_t=1", False)):
        text = page(app, query).body.decode()
        assert turned in text
        assert ('<g transform="scale(1 -1)"><rect class="ray-medium ray-upper"' in text) is below


def test_documents_are_kept_within_a_bound_of_bytes() -> None:
    def picture(query: bytes) -> FirstPicture:
        return FirstPicture("x" * 1_000_000 + query.decode(), [])

    document = Document(STATIC, picture, {})
    first = document.body(b"a=1")
    assert document.body(b"a=1") is first
    for number in range(12):
        document.body(b"b=%d" % number)
    assert document.body(b"a=1") is not first
    assert document.body(b"a=1").size > 1_000_000
