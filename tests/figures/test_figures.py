"""Figures: they show the numbers of the routes they are of, as JSON, as a page, as a picture."""

from __future__ import annotations

import base64
import json
import re
import struct
import subprocess
import sys
import tempfile
from hashlib import sha256
from pathlib import Path
from typing import Any
from urllib.parse import urlencode

import numpy as np
import plotly.io
import pytest
from fastapi import FastAPI

from app.answers import looks
from app.api import figures
from app.api.figures import KINDS
from app.figures import render
from app.main import create_app
from app.optics.registry import default_registry
from app.page.files import DOCUMENT_SECURITY_HEADERS
from tests.api.raw import Answer, send
from tests.browser.conftest import find_browser

ROOT = Path(__file__).parents[2]
STATIC = ROOT / "static"
QUERIES = {
    "explore": {"n_t": "1.5", "models": "exact,schlick", "theta_i_deg": "64"},
    "compare": {"n_t": "1.5", "k_t": "2", "models": "schlick,pharr_humphreys"},
    "errors": {"model": "schlick", "x_steps": "31", "y_steps": "21"},
    "sweep": {"model": "schlick", "minimum": "1.1", "maximum": "4", "steps": "21"},
    "albedo": {"fits": "deon_2019_log", "models": "schlick", "steps": "11"},
    "material": {"material": "Cu", "samples": "31"},
}


def figure(app: FastAPI, name: str, **more: str) -> Answer:
    return send(app, f"/api/v1/figures/{name}?{urlencode(QUERIES[name] | more)}".encode())


def data(app: FastAPI, path: str, **query: str) -> Any:
    answer = send(app, f"/api/v1{path}?{urlencode(query)}".encode())
    assert answer.status == 200, answer.body
    return answer.json()


def drawn(app: FastAPI, name: str, **more: str) -> dict[str, Any]:
    """Traces of a figure by name, those below with an apostrophe."""
    answer = figure(app, name, **more)
    assert answer.status == 200, answer.body
    read = plotly.io.from_json(answer.body.decode())
    return {f"{t.name}{chr(39) if t.showlegend is False else ''}": t for t in read.data}


def same(trace: Any, x: Any, y: Any) -> None:
    np.testing.assert_array_equal(np.array(trace.x, dtype=float), np.array(x, dtype=float))
    np.testing.assert_allclose(np.array(trace.y, dtype=float), np.array(y, dtype=float), atol=1e-15)


def test_every_kind_is_tried_here_and_listed(app: FastAPI) -> None:
    listed = data(app, "/figures")
    assert [kind["name"] for kind in listed["figures"]] == list(QUERIES) == [k.name for k in KINDS]
    assert listed["formats"] == ["json", "html", "svg", "png", "pdf"]


def test_explore_shows_the_curves(app: FastAPI) -> None:
    traces = drawn(app, "explore")
    answer = data(app, "/curves", n_t="1.5", models="exact,schlick")
    curves = {f"{c['model']}.{c['quantity']}": c["values"] for c in answer["curves"]}
    for name, key in (("exact R", "exact.R"), ("Rs", "exact.Rs"), ("Schlick", "schlick.R")):
        same(traces[name], answer["theta_i_deg"], curves[key])


def test_explore_marks_the_ray(app: FastAPI) -> None:
    layout = figure(app, "explore").json()["layout"]
    told = [note["text"] for note in layout["annotations"]]
    R = data(app, "/snell", n_t="1.5", theta_i_deg="64")["R"]
    assert f"R = {R:.4f}" in told
    assert any(shape.get("x0") == 64.0 for shape in layout["shapes"])
    beyond = figure(app, "explore", n_i="1.6", n_t="1").json()["layout"]
    assert not any(note["text"].startswith("T =") for note in beyond["annotations"])


def test_compare_shows_curves_and_errors(app: FastAPI) -> None:
    traces = drawn(app, "compare")
    answer = data(app, "/curves", n_t="1.5", k_t="2", models="exact,schlick,pharr_humphreys")
    curves = {f"{c['model']}.{c['quantity']}": np.array(c["values"]) for c in answer["curves"]}
    theta, exact = answer["theta_i_deg"], curves["exact.R"]
    same(traces["exact"], theta, exact)
    same(traces["Schlick"], theta, curves["schlick.R"])
    same(traces["Schlick'"], theta, curves["schlick.R"] - exact)


def test_the_map_and_the_sweep_show_errors(app: FastAPI) -> None:
    (heat,) = drawn(app, "errors").values()
    answer = data(app, "/errors/map", **QUERIES["errors"])
    np.testing.assert_array_equal(np.array(heat.z, dtype=float), np.array(answer["values"]))
    answer = data(app, "/errors/sweep", **QUERIES["sweep"])
    traces = drawn(app, "sweep")
    same(traces["largest error"], answer["values"], answer["max_abs"])


def test_albedo_and_material(app: FastAPI) -> None:
    answer = data(app, "/albedo/sweep", **QUERIES["albedo"])
    (fit,) = (c for c in answer["curves"] if c["kind"] == "fit")
    traces = drawn(app, "albedo")
    same(traces["d'Eon 2019, logarithm'"], answer["values"], fit["error"])
    answer = data(app, "/materials/Cu/curves", samples="31")
    traces = drawn(app, "material")
    same(traces["400 nm"], answer["theta_i_deg"], answer["wavelengths"][0]["R"])
    spectrum = data(app, "/materials/Cu/spectrum")
    same(traces["k"], spectrum["wavelength_nm"], spectrum["k"])


def test_digits_are_those_asked_for(app: FastAPI) -> None:
    traces = drawn(app, "compare", digits="4")
    answer = data(app, "/errors", **QUERIES["compare"], digits="4")
    row = next(row for row in answer["errors"] if row["model"] == "schlick")
    same(traces["Schlick'"], answer["theta_i_deg"], row["error"])
    layout = figure(app, "explore", digits="3").json()["layout"]
    at = [shape["x0"] for shape in layout["shapes"] if shape.get("line", {}).get("dash") == "dot"]
    assert at == [56.3]


@pytest.mark.parametrize("name", QUERIES)
def test_a_caption_tells_the_request_that_repeats_it(app: FastAPI, name: str) -> None:
    layout = figure(app, name, font_px="8").json()["layout"]
    caption = layout["annotations"][-1]["text"].replace("<br>", " ")
    request = layout["meta"]["request"]
    assert request in caption
    assert send(app, request.encode()).json()["layout"]["meta"]["request"] == request
    bare = figure(app, name, caption="false").json()["layout"]
    assert not any("Fresnel Explorer" in note["text"] for note in bare.get("annotations", []))


def test_a_caption_names_the_sources(app: FastAPI) -> None:
    texts = [figure(app, name, font_px="8").body.decode() for name in ("compare", "material")]
    assert "Pharr" in texts[0]
    assert "C. Schlick" in texts[0]
    assert "Johnson" in texts[1]


def test_the_look_is_asked_for(app: FastAPI) -> None:
    dark = looks.theme_colors(STATIC, "dark")
    layout = figure(app, "compare", theme="dark", width="500", height="400").json()["layout"]
    assert layout["paper_bgcolor"] == dark["paper"] != looks.theme_colors(STATIC, "light")["paper"]
    assert (layout["width"], layout["height"]) == (500, 400)
    layout = figure(app, "compare", background="transparent", font_px="9").json()["layout"]
    assert layout["paper_bgcolor"] == "rgba(0,0,0,0)"
    assert layout["font"]["size"] == 9


def test_each_model_has_a_look_of_its_own() -> None:
    ids = list(default_registry())
    assert looks.model_look("exact") == ("R", "solid")
    assert looks.model_look("schlick") == ("model-1", "dash")
    assert looks.model_look("pharr_humphreys") == ("model-4", "dashdot")
    told = [looks.model_look(name) for name in ids]
    assert len(set(told)) == len(ids)
    # A new model has the look that its id gives it, whatever else there is, and nobody else's.
    for new in ("aa", "bb", "zz"):
        assert looks.model_look(new) == looks.model_look(new) not in told


def test_figures_look_as_the_models_are_told_to(app: FastAPI) -> None:
    told = {model["id"]: model["look"] for model in data(app, "/models")["models"]}
    for theme in ("light", "dark"):
        line = drawn(app, "compare", theme=theme)["Schlick"].line
        assert (line.color, line.dash) == (told["schlick"][theme], told["schlick"]["dash"])
    for name, look in told.items():
        assert (look["color"], look["dash"]) == looks.model_look(name)


@pytest.mark.parametrize("name", QUERIES)
def test_what_is_wrong_is_told(app: FastAPI, name: str) -> None:
    for wrong in ({"format": "gif"}, {"theme": "blue"}, {"width": "1"}, {"nonsense": "1"}):
        answer = figure(app, name, **wrong)
        assert answer.status == 422
        assert answer.json()["errors"][0]["parameter"] == next(iter(wrong))


def test_what_the_route_refuses_is_told_as_it_tells_it(app: FastAPI) -> None:
    for name, wrong in (
        ("explore", {"n_t": "1e9"}),
        ("compare", {"models": "schlik"}),
        ("errors", {"y": "theta_i_deg"}),
        ("albedo", {"fits": "none"}),
    ):
        of = next(kind.of for kind in KINDS if kind.name == name)
        query = urlencode({k: v for k, v in (QUERIES[name] | wrong).items() if k != "theta_i_deg"})
        there = send(app, f"/api/v1{of}?{query}".encode())
        here = figure(app, name, **wrong)
        assert here.status == there.status == 422
        assert here.json()["errors"] == there.json()["errors"]
    assert figure(app, "material", material="unobtainium").status == 404
    assert send(app, b"/api/v1/figures/nope").status == 404


def test_a_page_of_its_own_is_as_safe_as_the_page(app: FastAPI) -> None:
    own, shell = figure(app, "compare", format="html").headers, send(app, b"/").headers
    for name in DOCUMENT_SECURITY_HEADERS:
        if name != "Content-Security-Policy":  # its own is narrower
            assert own[name.lower()] == shell[name.lower()]
    assert own["x-content-type-options"] == shell["x-content-type-options"] == "nosniff"
    assert "default-src 'none'" in own["content-security-policy"]
    assert "base-uri 'none'" in own["content-security-policy"]


def test_a_page_holds_all_it_needs(app: FastAPI) -> None:
    answer = figure(app, "compare", format="html")
    assert answer.headers["content-type"] == "text/html; charset=utf-8"
    page, policy = answer.body.decode(), answer.headers["content-security-policy"]
    assert policy.startswith("default-src 'none'; script-src 'sha256-")
    scripts = re.findall(r"<script>(.*?)</script>", page, re.DOTALL)
    assert len(scripts) == 2
    for script in scripts:
        digest = base64.b64encode(sha256(script.encode()).digest()).decode()
        assert f"'sha256-{digest}'" in policy
    outside = page.replace(scripts[0], "")
    assert re.findall(r"(?:src|href)=\"?(?!data:)", outside) == []
    assert "Fresnel Explorer" in page
    held = re.search(r'<script type="application/json" id="figure">(.*?)</script>', page, re.DOTALL)
    assert held is not None
    assert json.loads(held[1])["data"] == figure(app, "compare").json()["data"]


@pytest.mark.parametrize(
    ("form", "magic"), [("png", b"\x89PNG\r\n"), ("svg", b"<svg"), ("pdf", b"%PDF")]
)
def test_pictures(app: FastAPI, form: str, magic: bytes) -> None:
    if find_browser() is None:
        pytest.skip("no browser")
    answer = figure(app, "sweep", format=form, width="500", height="400")
    assert answer.status == 200, answer.body
    assert answer.headers["content-type"].startswith(render.MEDIA_TYPES[form].partition(";")[0])
    assert magic in answer.body[:200]
    if form == "png":
        assert struct.unpack(">II", answer.body[16:24]) == (
            1000,
            800,
        )  # for screens of two dots a px


def test_a_picture_has_a_bound_on_its_dots(app: FastAPI) -> None:
    answer = figure(app, "sweep", format="png", width="4000", height="1001")
    assert answer.status == 422
    (error,) = answer.json()["errors"]
    assert (error["parameter"], error["value"]) == ("width", 4000)
    assert "4000000, here 4004000" in error["message"]


def test_no_pictures_without_a_folder_to_write_to(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(**_: str) -> str:
        raise FileNotFoundError("No usable temporary directory found")

    fresh = create_app()
    monkeypatch.setattr(tempfile, "mkdtemp", refuse)
    answer = figure(fresh, "sweep", format="png", width="502")
    assert answer.status == 406
    assert "TMPDIR" in answer.json()["detail"]


def test_no_pictures_without_kaleido(app: FastAPI, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "kaleido", None)
    answer = figure(app, "sweep", format="png", width="501")
    assert answer.status == 406
    assert "kaleido" in answer.json()["detail"]
    assert "html" in answer.json()["detail"]


def test_plotly_is_loaded_when_a_figure_is_drawn() -> None:
    code = "import sys, app.main; app.main.create_app(); print('plotly' in sys.modules)"
    run = subprocess.run(
        [sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=True
    )
    assert run.stdout.strip() == "False"


def test_a_kind_without_a_route_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(figures, "KINDS", (figures.Kind("x", "X", "/nowhere"),))
    with pytest.raises(LookupError, match="nowhere"):
        create_app()
