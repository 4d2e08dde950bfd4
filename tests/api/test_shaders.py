"""`/shaders` and `/shaders/{model}`: models as code."""

from collections.abc import Callable

import httpx
import pytest

from app.optics.registry import default_registry
from app.snippets.languages import LANGUAGES
from app.snippets.snippet import reason_without
from tests.api.shape import fields_of

Ask = Callable[..., httpx.Response]

CLOSED = [m.id for m in default_registry().values() if reason_without(m) is None]
OPEN = [m.id for m in default_registry().values() if reason_without(m) is not None]


def test_lists_languages_and_models(ask: Ask) -> None:
    answer = ask("/shaders")
    listed = fields_of(answer.content)
    assert [x.id for x in listed.languages] == ["glsl", "hlsl", "wgsl", "osl", "python"]
    assert {x.id: x.checked for x in listed.languages}["osl"] == "untested"
    assert [x.model for x in listed.shaders] == list(default_registry())
    for link in listed.shaders:
        assert (link.url is None) == (link.reason is not None) == (link.model in OPEN)
        assert ask(f"/models/{link.model}").json()["shaders"] == link.url
        if link.url is not None:
            assert ask(link.url.removeprefix("/api/v1")).status_code == 200


@pytest.mark.parametrize("model", CLOSED)
@pytest.mark.parametrize("language", LANGUAGES)
def test_gives_each_in_each_language(ask: Ask, model: str, language: str) -> None:
    answer = ask(f"/shaders/{model}", language=language, channels=3)
    told = fields_of(answer.content)
    assert (told.model, told.language, told.function) == (model, language, model)
    assert told.arguments[0].name == "mu"
    assert not told.arguments[0].per_channel
    assert f"{model}(" in told.code
    colors = any(argument.per_channel for argument in told.arguments)
    assert (f"{model}_rgb(" in told.code) == (colors and language != "python")
    assert f"{model}_rgb(" not in ask(f"/shaders/{model}", language=language).json()["code"]
    text = ask(f"/shaders/{model}", language=language, channels=3, format="text")
    assert text.headers["content-type"] == "text/plain; charset=utf-8"
    assert text.text == told.code
    assert ("Untested: " in text.text) == (told.checked == "untested")


def test_is_glsl_of_real_numbers_unless_asked(ask: Ask) -> None:
    told = ask("/shaders/schlick").json()
    assert (told["language"], told["channels"], told["checked"]) == ("glsl", 1, "run")
    assert "float schlick(float mu, float F0) {" in told["code"]
    assert ask("/shaders/schlick").headers["etag"] != ask("/shaders/exact").headers["etag"]


@pytest.mark.parametrize("model", OPEN)
def test_says_why_there_is_none(ask: Ask, model: str) -> None:
    answer = ask(f"/shaders/{model}")
    assert answer.status_code == 404
    (error,) = answer.json()["errors"]
    assert error["parameter"] == "model_id"
    assert str(default_registry()[model].snippet) in error["message"]


@pytest.mark.parametrize(
    ("path", "query", "status", "parameter"),
    [
        ("/shaders/schlik", {}, 404, "model_id"),
        ("/shaders/schlick", {"language": "metal"}, 422, "language"),
        ("/shaders/schlick", {"channels": "2"}, 422, "channels"),
        ("/shaders/schlick", {"lang": "glsl"}, 422, "lang"),
        ("/shaders/schlick", {"format": "png"}, 422, "format"),
        ("/shaders", {"language": "glsl"}, 422, "language"),
    ],
)
def test_refuses(ask: Ask, path: str, query: dict[str, str], status: int, parameter: str) -> None:
    answer = ask(path, **query)
    assert answer.status_code == status
    assert answer.headers["content-type"] == "application/problem+json"
    assert [error["parameter"] for error in answer.json()["errors"]] == [parameter]
