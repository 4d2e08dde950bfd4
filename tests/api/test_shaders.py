"""`/shaders` and `/shaders/{model}`: models as code."""

import pytest

from app.optics.registry import default_registry
from app.snippets.languages import LANGUAGES
from app.snippets.snippet import reason_without
from tests.api.shape import Ask, error_of, json_of

CLOSED = [m.id for m in default_registry().values() if reason_without(m) is None]
OPEN = [m.id for m in default_registry().values() if reason_without(m) is not None]


def test_lists_languages_and_models(ask: Ask) -> None:
    listed = json_of(ask("/shaders"))
    checked = {language["id"]: language["checked"] for language in listed["languages"]}
    assert list(checked) == ["glsl", "hlsl", "wgsl", "osl", "javascript", "python"]
    assert checked["osl"] == "untested"
    assert [link["model"] for link in listed["shaders"]] == list(default_registry())
    for piece in listed["pieces"]:
        told = ask(piece["url"].removeprefix("/api/v1")).json()
        assert (told["id"], told["title"]) == (piece["id"], piece["title"])
    for link in listed["shaders"]:
        url = link["url"]
        assert (url is None) == (link["reason"] is not None) == (link["model"] in OPEN)
        assert ask(f"/models/{link['model']}").json()["shaders"] == url
        assert url is None or ask(url.removeprefix("/api/v1")).status_code == 200


@pytest.mark.parametrize("model", CLOSED)
@pytest.mark.parametrize("language", LANGUAGES)
def test_gives_each_in_each_language(ask: Ask, model: str, language: str) -> None:
    told = json_of(ask(f"/shaders/{model}", language=language, channels=3))
    code, arguments = told["code"], told["arguments"]
    assert (told["model"], told["language"], told["function"]) == (model, language, model)
    assert (arguments[0]["name"], arguments[0]["per_channel"]) == ("mu", False)
    assert f"{model}(" in code
    colors = any(argument["per_channel"] for argument in arguments)
    assert (f"{model}_rgb(" in code) == (colors and language != "python")
    assert f"{model}_rgb(" not in ask(f"/shaders/{model}", language=language).json()["code"]
    text = ask(f"/shaders/{model}", language=language, channels=3, format="text")
    assert text.headers["content-type"] == "text/plain; charset=utf-8"
    assert text.text == code
    assert ("Untested: " in code) == (told["checked"] == "untested")


@pytest.mark.parametrize("language", LANGUAGES)
def test_gives_directions_in_each_language(ask: Ask, language: str) -> None:
    told = json_of(ask("/shaders/vectors", language=language))
    assert told["functions"] == ["reflected", "refracted"]
    assert [argument["name"] for argument in told["arguments"]] == ["mu", "eta", "d", "n"]
    for name in told["functions"]:
        assert f"{name}(" in told["code"]
        assert (f"{name}_xyz(" in told["code"]) == (language != "python")
    assert ask("/shaders/lookup", language=language).json()["code"].count("table_lookup(") == 1
    assert ("Untested: " in told["code"]) == (told["checked"] == "untested")
    assert ask("/shaders/vectors", language=language, format="text").text == told["code"]


def test_is_glsl_of_real_numbers_unless_asked(ask: Ask) -> None:
    told = ask("/shaders/schlick").json()
    assert (told["language"], told["channels"], told["checked"]) == ("glsl", 1, "run")
    assert "float schlick(float mu, float F0) {" in told["code"]
    assert ask("/shaders/schlick").headers["etag"] != ask("/shaders/exact").headers["etag"]


@pytest.mark.parametrize("model", OPEN)
def test_says_why_there_is_none(ask: Ask, model: str) -> None:
    error = error_of(ask(f"/shaders/{model}"), 404)
    assert error["parameter"] == "model_id"
    assert str(default_registry()[model].snippet) in error["message"]


def test_an_unknown_model_is_not_found(ask: Ask) -> None:
    assert error_of(ask("/shaders/schlik"), 404)["parameter"] == "model_id"
