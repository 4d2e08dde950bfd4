"""`/engines`: what render engines reflect."""

import pytest

from tests.api.shape import Ask


def test_engines_are_listed_with_what_was_found(ask: Ask) -> None:
    listed = {engine["id"]: engine for engine in ask("/engines").json()["engines"]}
    assert listed["three"]["version"] == "0.187.0"
    assert any("0.389 at 80 degrees" in told for told in listed["three"]["departures"])
    assert listed["mitsuba"]["departures"] == []


@pytest.mark.parametrize(
    ("engine", "way", "light", "medium", "at_deg", "red"),
    [
        ("three", "ior", "environment", "glass", 60.0, 0.0712),
        ("three", "ior", "environment", "glass", 80.0, 0.4133),
        ("three", "ior", "light", "n = 1", 80.0, 0.384),
        ("babylon", "OpenPBRMaterial", "environment", "water", 85.0, 0.4304),
        ("filament", "glTF, ior and specular", "environment", "diamond", 0.0, 0.1725),
        ("playcanvas", "refractionIndex", "environment", "glass", 89.0, 0.04),
        ("cycles", "Principled BSDF", "environment", "glass", 80.0, 0.3877),
        ("usd", "metallic", "light", "copper", 80.0, 0.9352),
    ],
)
def test_curves_agree_with_measurements_made_before(
    ask: Ask, engine: str, way: str, light: str, medium: str, at_deg: float, red: float
) -> None:
    """By others, on another day, of the same versions."""
    told = ask(f"/engines/{engine}").json()
    row = told["theta_i_deg"].index(at_deg)
    (curve,) = (
        c for c in told["curves"] if (c["way"], c["light"], c["medium"]) == (way, light, medium)
    )
    assert curve["reflectance"][row][0] == pytest.approx(red, abs=5e-4)


def test_a_curve_says_where_it_is_wrong_and_what_explains_it(ask: Ask) -> None:
    told = ask("/engines/usd").json()
    (curve,) = (c for c in told["curves"] if (c["way"], c["medium"]) == ("metallic", "chromium"))
    assert curve["model"] == "constant_f0"
    assert curve["model_error"]["max_abs"] < 1e-6
    assert curve["error"]["at_deg"] == 89.0


def test_an_unknown_engine_is_told_the_nearest(ask: Ask) -> None:
    problem = ask("/engines/threee").json()
    assert problem["errors"][0]["message"] == "nearest: three"
