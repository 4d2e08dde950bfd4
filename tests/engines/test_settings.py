"""Knobs and coats as they were measured: what is typed into engines, and what they show."""

from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest

from app.engines.measured import Setting, engines
from app.optics.amplitudes import reflectance
from app.optics.coats import Base, coat_shortcuts
from app.optics.conversions import Form, know
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.knobs.reflectance import KNOBS

# The tables of albedo that engines look an environment up in.
TABLE = 1e-3

BY_ENGINE: dict[str, dict[str, str]] = {
    "three": {
        "ior": "ior",
        "specularIntensity": "specularFactor",
        "specularColor": "specularColorFactor",
    },
    "filament": {
        "ior": "ior",
        "specularFactor": "specularFactor",
        "specularColorFactor": "specularColorFactor",
    },
    "babylon": {"specularIor": "specular_ior", "specularWeight": "specular_weight"},
    "cycles": {"IOR": "ior", "Specular IOR Level": "specular_ior_level"},
}
"""What each engine calls the numbers of a knob."""


def flat(typed: dict[str, Any]) -> dict[str, Any]:
    """What is typed, extensions of glTF merged."""
    extensions = typed.get("extensions", {})
    return {k: v for values in (typed, *extensions.values()) for k, v in values.items()}


def settings(engine: str, *ways: str) -> Iterator[Setting]:
    """The settings of some of an engine's ways."""
    found = [one for one in engines()[engine].settings if one.way in ways]
    assert found
    yield from found


def F0_of(form: Form, engine: str, typed: dict[str, Any]) -> np.ndarray:
    """What a knob says of what was typed, by channel."""
    (knob,) = (knob for knob in KNOBS if knob.id == form)
    own = flat(typed)
    given: dict[str, Any] = {one.parameter.name: one.default for one in knob.inputs}
    given |= {name: own[key] for key, name in BY_ENGINE[engine].items() if key in own}
    channels = [
        {name: float(v[c]) if isinstance(v, list) else v for name, v in given.items()}
        for c in range(3)
    ]
    return np.array([know(form, **numbers).F0 for numbers in channels])


def test_gltf_is_what_three_shows() -> None:
    for one in settings("three", "ior", "specularIntensity", "specularColor"):
        expected = F0_of("gltf", "three", dict(one.typed))
        np.testing.assert_allclose(one.reflectance[0], expected, atol=TABLE, err_msg=str(one.typed))


def test_reflectivity_of_three() -> None:
    """Above 1 it is an ior as any; in a file no more than 1 is kept, and no ior above 2.333."""
    for one in settings("three", "reflectivity"):
        expected = 0.16 * one.typed["reflectivity"] ** 2
        np.testing.assert_allclose(one.reflectance[0], expected, atol=TABLE)
    kept = {one.typed["ior"]: one.reflectance[0, 0] for one in settings("three", "ior, saved")}
    assert kept[2.0] == pytest.approx(1.0 / 9.0, abs=TABLE)
    assert kept[3.0] == pytest.approx(0.16, abs=TABLE)
    assert kept[3.0] < 0.25 - 0.05


def test_gltf_is_what_filament_shows_but_for_the_factor() -> None:
    """It squares specularFactor in F0, as its departure says."""
    for one in settings("filament", "glTF"):
        factor = flat(dict(one.typed)).get("specularFactor", 1.0)
        expected = F0_of("gltf", "filament", dict(one.typed)) * factor
        np.testing.assert_allclose(one.reflectance[0], expected, atol=TABLE, err_msg=str(one.typed))


def test_openpbr_is_what_babylon_shows() -> None:
    found = [one for one in settings("babylon", "OpenPBRMaterial") if "specularWeight" in one.typed]
    for one in found:
        expected = F0_of("openpbr", "babylon", dict(one.typed))
        np.testing.assert_allclose(one.reflectance[0], expected, atol=TABLE, err_msg=str(one.typed))


def test_blender_is_what_cycles_shows() -> None:
    """At all angles: the curve of the index that has the F0."""
    engine = engines()["cycles"]
    at = Incidence.from_degrees(engine.theta_i_deg)
    for one in settings("cycles", "Principled BSDF"):
        ior, level = one.typed["IOR"], one.typed["Specular IOR Level"]
        known = know("blender", ior=ior, specular_ior_level=level)
        np.testing.assert_allclose(one.reflectance[0], known.F0, atol=5e-5, err_msg=str(one.typed))
        if known.eta is not None and 1e-3 < known.eta < 3.7:
            exact = reflectance(Interface(1.0, known.eta), at)
            np.testing.assert_allclose(one.reflectance[:, 0], exact, atol=5e-5)


# Coats on gold


def gold_in(one: Setting) -> Base:
    """What was typed for gold, and the index of its coat."""
    typed = flat(dict(one.typed))
    typed |= typed.get("pbrMetallicRoughness", {})
    names = ("color", "Base Color", "baseColorFactor", "albedoColor", "baseColor")
    color = next(typed[n] for n in names if n in typed)
    tint = next((typed[n] for n in ("Specular Tint", "specularColor") if n in typed), [1.0] * 3)
    coat = typed.get("clearCoat", {}) | typed
    n = next((coat[n] for n in ("Coat IOR", "coatIor", "indexOfRefraction") if n in coat), 1.5)
    return Base(np.array(color[:3]), np.array(tint), n)


@pytest.mark.parametrize(
    ("shortcut", "engine_id", "way", "n", "at_most"),
    [
        ("gltf_clearcoat", "three", "clearcoat", 1.5, 0.1),
        ("gltf_clearcoat", "filament", "glTF, clearcoat", 1.5, 0.01),
        ("filament_clearcoat", "babylon", "PBRMaterial, clearCoat", 1.5, 0.01),
        ("babylon_clearcoat", "babylon", "PBRMaterial, clearCoat", 1.8, 0.01),
        ("babylon_openpbr_coat", "babylon", "OpenPBRMaterial", 1.5, 0.01),
        ("babylon_openpbr_coat", "babylon", "OpenPBRMaterial", 1.8, 0.01),
        ("cycles_coat", "cycles", "Principled BSDF, coat", 1.5, 0.02),
        ("cycles_coat", "cycles", "Principled BSDF, coat", 1.8, 0.02),
    ],
)
def test_a_coat_is_what_its_shortcut_says(
    shortcut: str, engine_id: str, way: str, n: float, at_most: float
) -> None:
    """Up to 60 degrees, where no engine's least roughness or table shows much, and beyond."""
    model, engine = coat_shortcuts()[shortcut], engines()[engine_id]
    assert engine_id in model.engines
    plain = engine.theta_i_deg <= 60.0
    at = Incidence.from_degrees(engine.theta_i_deg)
    (one,) = (
        each
        for each in settings(engine_id, way)
        if "specularWeight" not in each.typed and gold_in(each).n == n
    )
    off = np.abs(one.reflectance - model.color(gold_in(one), at))
    assert off[plain].max() < 0.003 + engine.noise
    assert off.max() < at_most + engine.noise


def test_engines_of_shortcuts_are_those_measured() -> None:
    measured = {name for model in coat_shortcuts().values() for name in model.engines}
    assert measured == {"three", "filament", "babylon", "cycles"}
