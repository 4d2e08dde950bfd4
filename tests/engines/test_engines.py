"""What is told of render engines: their measured curves, models that explain them, sentences."""

import numpy as np
import pytest

from app.engines.explained import (
    DEPARTURES,
    EXPLAINED,
    Departure,
    SettingDeparture,
    explained,
)
from app.engines.measured import Curve, Engine, engines
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.registry import default_registry

ENGINES = list(engines().values())
CURVES = [(engine, curve) for engine in ENGINES for curve in engine.curves]
MODELS = default_registry()

# Below these angles no engine's least roughness, table of albedos or compensation shows much.
PLAIN_DEG = 60.0


def named(value: object) -> str:
    if isinstance(value, Curve):
        return f"{value.medium.name}-{value.light}-{value.way}"
    return value.id if isinstance(value, Engine) else str(value)


def model_of(engine: Engine, curve: Curve, model: str) -> np.ndarray:
    incidence = Incidence.from_degrees(engine.theta_i_deg[:, None])
    return np.broadcast_to(
        MODELS[model](curve.medium.interface, incidence), curve.reflectance.shape
    )


def test_eight_engines_were_measured() -> None:
    assert set(engines()) == set(EXPLAINED)
    assert len(ENGINES) == 8


@pytest.mark.parametrize(("engine", "curve"), CURVES, ids=named)
def test_a_curve_is_one_of_reflectances(engine: Engine, curve: Curve) -> None:
    """At most 1, but for MaterialX's energy compensation, of which a departure tells."""
    at_most = 1.1 if (engine.id, curve.light) == ("materialx", "light") else 1.0
    assert curve.reflectance.shape == (engine.theta_i_deg.size, 3)
    assert np.all(curve.reflectance >= 0.0)
    assert np.all(curve.reflectance <= at_most + engine.noise)


@pytest.mark.parametrize(
    ("engine", "curve"), [pair for pair in CURVES if explained(*pair) is not None], ids=named
)
def test_the_model_explains_the_curve(engine: Engine, curve: Curve) -> None:
    """Up to 60 degrees within 4e-3 and the noise; MaterialX's fit is no better than that."""
    plain = engine.theta_i_deg <= PLAIN_DEG
    values = model_of(engine, curve, explained(engine, curve) or "")
    at_most = 0.0051 if engine.id == "materialx" else 0.004
    assert np.max(np.abs(curve.reflectance - values)[plain]) <= at_most + engine.noise


@pytest.mark.parametrize("engine_id", ["mitsuba", "cycles"])
def test_engines_that_evaluate_the_formulas_agree_with_ours(engine_id: str) -> None:
    """Independent programs, in single precision."""
    engine = engines()[engine_id]
    for curve in engine.curves:
        values = model_of(engine, curve, explained(engine, curve) or "")
        np.testing.assert_allclose(curve.reflectance, values, atol=2e-5, rtol=0.0)


@pytest.mark.parametrize(
    ("engine_id", "departure"),
    [(name, d) for name, all_ in DEPARTURES.items() for d in all_ if isinstance(d, Departure)],
)
def test_a_departure_is_more_than_noise(engine_id: str, departure: Departure) -> None:
    engine = engines()[engine_id]
    curve = engine.curve(departure.medium, departure.way, departure.light)
    row = engine.theta_i_deg == departure.at_deg
    error = np.abs(curve.reflectance - engine.exact(curve.medium))[row, 0]
    assert error > 0.03
    assert error > 20 * engine.noise
    assert "{" not in departure.told(engine)


def test_departures_of_what_is_typed_are_more_than_noise() -> None:
    """Half of glTF's 0.04 is 0.02; gold below a coat is F + (1 - F)^2 R / (1 - F R)."""
    (gold,) = (medium for medium in engines()["babylon"].media if medium.name == "gold")
    inside = Interface(1.5, gold.n, gold.k).F0[0]
    below_a_coat = 0.04 + 0.96**2 * inside / (1.0 - 0.04 * inside)
    assert below_a_coat == pytest.approx(0.942, abs=5e-4)  # as the sentence says
    meant = {"filament": 0.02, "babylon": below_a_coat}
    for name, expected in meant.items():
        (departure,) = (d for d in DEPARTURES[name] if isinstance(d, SettingDeparture))
        off = abs(departure.measured(engines()[name]) - expected)
        assert off > 0.4 * expected
        assert "{" not in departure.told(engines()[name])
