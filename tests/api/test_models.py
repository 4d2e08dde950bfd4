"""`/models`, `/models/{id}` and `/parameters`, and what one more model file changes."""

import sys
from pathlib import Path

import numpy as np
import pytest
from fastapi import FastAPI

import app.optics.models
from app.main import create_app
from app.optics.parameters import K_T, N_I, N_T, THETA_I_DEG
from app.optics.registry import default_registry
from tests.api.raw import send
from tests.api.shape import Ask, error_of, json_of

MODEL_FILE = '''
"""A fraction of all light, at any angle: a file that a test adds."""

import numpy as np

from app.optics.parameters import Parameter
from app.optics.registry import Cost, Model

SHARE = Parameter("share", "s", 0.25, 0.0, 1.0, "", "Part that is reflected.")

MODEL = Model(
    id="mirror_share",
    title="Constant share",
    applies_to=("dielectric",),
    latex=r"R\\approx s",
    reference="Nobody, Nowhere (2000)",
    validity="For this test alone.",
    cost=Cost(lookup=1),
    function=lambda interface, incidence, share: np.full(incidence.cos.shape, share),
    parameters=(SHARE,),
)
'''


def test_lists_all_that_is_registered_in_order(ask: Ask) -> None:
    listed = json_of(ask("/models"))["models"]
    assert [model["id"] for model in listed] == list(default_registry())


@pytest.mark.parametrize("model_id", default_registry())
def test_describes_each(ask: Ask, model_id: str) -> None:
    told, model = json_of(ask(f"/models/{model_id}")), default_registry()[model_id]
    assert (told["id"], told["kind"]) == (model_id, model.kind)
    assert told["applies_to"] == list(model.applies_to)
    for shown, declared in zip(told["parameters"], model.parameters, strict=True):
        for name in ("name", "minimum", "maximum", "default", "symbol", "unit"):
            assert shown[name] == getattr(declared, name)
    assert told in ask("/models").json()["models"]


def test_sends_of_each_only_what_is_asked_for(ask: Ask) -> None:
    rows = ask("/models", fields="id, title").json()["models"]
    assert rows == [{"id": m.id, "title": m.title} for m in default_registry().values()]
    assert error_of(ask("/models", fields="id,size"))["parameter"] == "fields"


@pytest.mark.parametrize(
    ("asked", "nearest"), [("exakt", "exact"), ("Schlick", "schlick"), ("wloka_eq", "wloka_eq6")]
)
def test_unknown_models_are_not_found_but_the_nearest_are(
    ask: Ask, asked: str, nearest: str
) -> None:
    error = error_of(ask(f"/models/{asked}"), 404)
    assert error["parameter"] == "model_id"
    assert nearest in error["message"]


def test_parameters_are_those_declared(ask: Ask) -> None:
    told = {parameter["name"]: parameter for parameter in json_of(ask("/parameters"))["parameters"]}
    for declared in (N_I, N_T, K_T, THETA_I_DEG):
        for name in ("default", "minimum", "maximum", "unit", "description"):
            assert told[declared.name][name] == getattr(declared, name)


@pytest.fixture(scope="module")
def extended(tmp_path_factory: pytest.TempPathFactory) -> FastAPI:
    """The application as it starts with one more file among the models."""
    folder = tmp_path_factory.mktemp("models")
    Path(folder / "mirror_share.py").write_text(MODEL_FILE, "utf-8")
    search = app.optics.models.__path__
    search.append(str(folder))
    default_registry.cache_clear()
    try:
        return create_app()
    finally:
        search.remove(str(folder))
        sys.modules.pop("app.optics.models.mirror_share", None)
        default_registry.cache_clear()


class TestOneMoreFile:
    """A file beside the others is all it takes to add a model."""

    def test_is_listed_last_of_its_kind_by_name(self, extended: FastAPI) -> None:
        ids = [m["id"] for m in send(extended, b"/api/v1/models").json()["models"]]
        assert ids.index("mirror_share") == ids.index("lut_1d") + 1
        alone = send(extended, b"/api/v1/models/mirror_share").json()
        assert (alone["title"], alone["kind"]) == ("Constant share", "approximation")

    def test_gives_curves_with_its_own_parameter(self, extended: FastAPI) -> None:
        target = b"/api/v1/curves?samples=3&models=exact,mirror_share"
        (default,) = send(extended, target).json()["curves"][-1:]
        assert (default["model"], default["values"]) == ("mirror_share", [0.25] * 3)
        given = send(extended, target + b"&mirror_share.share=0.5").json()["curves"][-1]
        assert given["values"] == [0.5] * 3
        outside = send(extended, target + b"&mirror_share.share=1.5")
        assert outside.status == 422
        assert outside.json()["errors"][0]["parameter"] == "mirror_share.share"

    def test_stands_in_openapi(self, extended: FastAPI) -> None:
        schema = send(extended, b"/openapi.json").json()
        parameters = {p["name"]: p for p in schema["paths"]["/api/v1/curves"]["get"]["parameters"]}
        own = parameters["mirror_share.share"]
        assert (own["schema"]["minimum"], own["schema"]["maximum"]) == (0.0, 1.0)
        assert own["schema"]["default"] == 0.25
        assert own["description"] == "Part that is reflected."
        assert "mirror_share" in parameters["models"]["description"]

    def test_is_gone_with_its_file(self, extended: FastAPI) -> None:
        assert send(extended, b"/api/v1/models/mirror_share").status == 200
        assert send(create_app(), b"/api/v1/models/mirror_share").status == 404


def test_a_registry_of_ones_own_can_be_served() -> None:
    from app.optics.registry import Registry

    only = create_app(registry=Registry([default_registry()["schlick"]]))
    assert [m["id"] for m in send(only, b"/api/v1/models").json()["models"]] == ["schlick"]
    values = send(only, b"/api/v1/curves?models=schlick&samples=2").json()["curves"][0]["values"]
    assert np.allclose(values, [0.04, 1.0], rtol=1e-15)
    assert send(only, b"/api/v1/curves").status == 422  # the default is `exact`
