"""The contract that every registered model keeps, and the registry that finds them."""

import re
from dataclasses import astuple, replace
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

import app.optics.models
from app.optics.errors import NotAllowed, OutOfRange, UnknownModel
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.parameters import Parameter
from app.optics.registry import Model, Registry, default_registry

Array = NDArray[np.float64]

MODELS = list(default_registry().values())
WITH_PARAMETERS = [(model, parameter) for model in MODELS for parameter in model.parameters]

TRIPLES = [(model, parameter) for model, parameter in WITH_PARAMETERS if parameter.triple]

INTERFACES = [
    Interface(n_i, n_t, k_t)
    for n_i, n_t, k_t in [
        (1.0, 1.33, 0.0),
        (1.0, 1.5, 0.0),
        (1.0, 2.42, 0.0),
        (1.33, 1.5, 0.0),
        (1.5, 1.0, 0.0),
        (2.42, 1.33, 0.0),
        (1.0, 1.0, 0.0),
        (1.0, 1.0 + 1e-9, 0.0),
        (1e-3, 100.0, 0.0),
        (100.0, 1e-3, 0.0),
        (1.0, 0.2, 3.0),
        (1.0, 1.5, 5.0),
        (1.0, 3.0, 3.0),
        (1.5, 0.2, 3.0),
        (1.0, 1.5, 1e-9),
        (1.0, 1.0, 1e-20),
        (1.0, 1.0, 1e-300),
        (1.0, 1e-3, 100.0),
        (1.0, 100.0, 100.0),
    ]
]
INCIDENCE = Incidence.from_degrees(
    np.concatenate([np.linspace(0.0, 90.0, 91), [1e-9, 89.999, 90.0 - 1e-9]])
)

# Differences of squares may end a unit in the last place below 0, quotients one above 1.
ROUNDING = 1e-15

over_models = pytest.mark.parametrize("model", MODELS, ids=lambda model: model.id)
over_parameters = pytest.mark.parametrize(
    ("model", "parameter"), WITH_PARAMETERS, ids=[f"{m.id}.{p.name}" for m, p in WITH_PARAMETERS]
)


def domain(model: Model) -> list[Interface]:
    return [interface for interface in INTERFACES if model.reason_outside(interface) is None]


def applicable(model: Model) -> list[Interface]:
    return [interface for interface in INTERFACES if interface.kind in model.applies_to]


@over_models
def test_names_and_texts(model: Model) -> None:
    assert re.fullmatch(r"[a-z][a-z0-9]*(_[a-z0-9]+)*", model.id)
    for text in (model.title, model.latex, model.reference, model.validity):
        assert text == text.strip() != ""
    assert model.kind in {"exact", "approximation"}
    assert model.applies_to
    assert set(model.applies_to) <= {"dielectric", "conductor"}
    assert re.search(r"\b(18|19|20)\d\d\b", model.reference), "a reference names its year"
    assert model.validity.endswith(".")
    assert model.latex.count("{") == model.latex.count("}")
    assert model.latex.isascii()


@over_models
def test_one_file_a_model_of_the_same_name(model: Model) -> None:
    folder = Path(app.optics.models.__path__[0])
    assert f'id="{model.id}"' in (folder / f"{model.id}.py").read_text("utf-8")


@over_models
def test_the_cost_is_counted(model: Model) -> None:
    counts = astuple(model.cost)
    assert all(isinstance(count, int) and count >= 0 for count in counts)
    assert (sum(counts) == 0) == (model.id == "constant_f0")


@over_models
def test_evaluates_and_keeps_the_shape(model: Model) -> None:
    theta = Incidence.from_degrees([0.0, 30.0, 60.0, 89.0])
    for interface in applicable(model)[:2]:
        n_i, n_t, k_t = (float(n) for n in (interface.n_i, interface.n_t, interface.k_t))
        assert model(interface, theta).shape == (4,)
        assert model(interface, Incidence.from_degrees(30.0)).shape == ()
        column = Interface([[n_i]] * 3, n_t, k_t)
        assert model(column, theta).shape == (3, 4)
        assert model(column, theta).dtype == np.float64


@over_models
def test_one_by_one_is_all_at_once(model: Model) -> None:
    interfaces = applicable(model)
    n_i, n_t, k_t = np.array([[i.n_i, i.n_t, i.k_t] for i in interfaces]).T[..., np.newaxis]
    R = model(Interface(n_i, n_t, k_t), INCIDENCE)
    for row, interface in zip(R, interfaces, strict=True):
        alone = model(interface, INCIDENCE)
        assert np.allclose(row, alone, rtol=1e-12, atol=1e-15, equal_nan=True)


@over_models
def test_is_finite_in_its_domain(model: Model) -> None:
    for interface in domain(model):
        R = model(interface, INCIDENCE)
        undefined = np.zeros_like(R, dtype=bool)
        if "undefined beyond" in model.validity and interface.kind == "dielectric":
            undefined |= INCIDENCE.sin > interface.eta
        if "undefined at 90 degrees" in model.validity:
            undefined |= INCIDENCE.cos == 0.0
        if "0/0 for" in model.validity and interface.eta == 1.0:
            undefined |= INCIDENCE.cos == 0.0
        assert np.isfinite(R[~undefined]).all(), interface


@pytest.mark.parametrize("model", [m for m in MODELS if m.kind == "exact"], ids=lambda m: m.id)
def test_exact_forms_stay_within_0_and_1(model: Model) -> None:
    for interface in domain(model):
        R = model(interface, INCIDENCE)
        assert np.nanmin(R) >= -ROUNDING
        assert np.nanmax(R) <= 1.0 + ROUNDING


@over_models
def test_leaves_its_arguments_alone(model: Model) -> None:
    interface, theta = applicable(model)[0], np.linspace(0.0, 90.0, 7)
    incidence = Incidence.from_degrees(theta)
    before = [
        array.copy() for array in (interface.n_i, interface.n_t, interface.k_t, incidence.cos)
    ]
    first, second = model(interface, incidence), model(interface, incidence)
    assert np.array_equal(first, second, equal_nan=True)
    after = (interface.n_i, interface.n_t, interface.k_t, incidence.cos)
    assert all(np.array_equal(a, b) for a, b in zip(before, after, strict=True))


@over_models
def test_all_but_traps_have_a_domain(model: Model) -> None:
    assert bool(domain(model)) != model.trap
    assert model.trap == model.title.endswith("(trap)")
    for kind in {"dielectric", "conductor"} - set(model.applies_to):
        outside = [interface for interface in INTERFACES if interface.kind == kind]
        assert all(f"this is a {kind}" in str(model.reason_outside(i)) for i in outside)


@over_models
def test_names_of_parameters_differ(model: Model) -> None:
    names = [parameter.name for parameter in model.parameters]
    assert len(set(names)) == len(names)


@over_models
def test_foreign_parameters_are_refused(model: Model) -> None:
    with pytest.raises(NotAllowed) as caught:
        model(applicable(model)[0], INCIDENCE, nonsense=1.0)
    assert caught.value.parameter == f"{model.id}.nonsense"


@over_parameters
def test_parameters_are_declared_in_full(model: Model, parameter: Parameter) -> None:
    assert parameter in model.parameters
    assert re.fullmatch(r"[A-Za-z][A-Za-z0-9_]*", parameter.name)
    assert parameter.symbol
    assert parameter.description.endswith(".")
    assert parameter.minimum < parameter.maximum
    if parameter.default is not None:
        assert float(parameter.check(parameter.default)) == parameter.default
    for name, number in parameter.choices:
        assert float(parameter.check(name)) == number


@over_parameters
def test_defaults_are_what_leaving_out_means(model: Model, parameter: Parameter) -> None:
    interface = applicable(model)[0]
    value = model.arguments(interface)[parameter.name]
    assert np.isfinite(value).all()
    given = model(interface, INCIDENCE, **{parameter.name: value})
    assert np.allclose(given, model(interface, INCIDENCE), rtol=1e-13, atol=0.0, equal_nan=True)
    none = model(interface, INCIDENCE, **{parameter.name: None})
    assert np.array_equal(none, model(interface, INCIDENCE), equal_nan=True)


@over_parameters
@pytest.mark.parametrize("value", [np.nan, np.inf, "nonsense"])
def test_bounds_of_parameters_are_checked(
    model: Model, parameter: Parameter, value: float | str
) -> None:
    with pytest.raises(OutOfRange) as caught:
        model(applicable(model)[0], INCIDENCE, **{parameter.name: value})
    assert caught.value.parameter == f"{model.id}.{parameter.name}"


@over_parameters
def test_bounds_of_parameters_are_inclusive(model: Model, parameter: Parameter) -> None:
    for value in (parameter.minimum, parameter.maximum):
        R = model(applicable(model)[0], INCIDENCE, **{parameter.name: value})
        assert R.shape == INCIDENCE.cos.shape
    for value in (parameter.minimum - 1.0, parameter.maximum + 1.0):
        with pytest.raises(OutOfRange):
            model(applicable(model)[0], INCIDENCE, **{parameter.name: value})


@pytest.mark.parametrize(
    ("model", "parameter"), TRIPLES, ids=[f"{m.id}.{p.name}" for m, p in TRIPLES]
)
def test_triples_give_three_curves(model: Model, parameter: Parameter) -> None:
    values = np.linspace(parameter.minimum, parameter.maximum, 5)[1:4]
    for interface in (applicable(model)[0], Interface(1.0, 1.5, 5.0)):
        R = model(interface, INCIDENCE, **{parameter.name: values[:, np.newaxis]})
        assert R.shape == (3, *INCIDENCE.cos.shape)
        assert len({row.tobytes() for row in R}) == 3
        for row, value in zip(R, values, strict=True):
            np.testing.assert_array_equal(
                row, model(interface, INCIDENCE, **{parameter.name: value})
            )


def test_exact_comes_first_then_exact_forms_then_approximations() -> None:
    kinds = [model.kind for model in MODELS]
    assert MODELS[0].id == "exact"
    assert kinds == sorted(kinds, reverse=True)
    assert list(default_registry()) == [model.id for model in MODELS]


def test_schlick_is_the_first_approximation_and_traps_are_the_last() -> None:
    approximations = [model for model in MODELS if model.kind == "approximation"]
    assert approximations[0].id == "schlick"
    traps = [model.trap for model in approximations]
    assert any(traps)
    assert traps == sorted(traps)
    names = [model.id for model in approximations[1:] if not model.trap]
    assert names == sorted(names)


def test_every_file_is_registered() -> None:
    folder = Path(app.optics.models.__path__[0])
    files = {path.stem for path in folder.glob("*.py")} - {"__init__"}
    assert set(default_registry()) == files


def test_find_names_the_nearest() -> None:
    registry = default_registry()
    assert registry.find("exact") is registry["exact"]
    with pytest.raises(UnknownModel) as caught:
        registry.find("schlik")
    assert caught.value.parameter == "models"
    assert "schlick" in caught.value.nearest
    with pytest.raises(UnknownModel) as caught:
        registry.find("exakt", "model_id")
    assert caught.value.parameter == "model_id"
    assert caught.value.nearest[0] == "exact"


def test_two_models_of_one_name_are_refused() -> None:
    exact = default_registry()["exact"]
    with pytest.raises(ValueError, match="share an id"):
        Registry([exact, replace(exact, title="Another")])
