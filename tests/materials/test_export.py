"""Files for render engines: their structure, and that they hold what is said.

`python -m tools.exports` has the engines' own libraries load all of them.
"""

import ast
import base64
import json
import re
from collections.abc import Iterator
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest

from app.answers.materials.curves import curves
from app.answers.materials.export import Export, export, exported_file
from app.engines.explained import explained
from app.engines.measured import engines
from app.export.registry import TARGETS
from app.export.surface import Surface
from app.export.target import ModeId, TargetId
from app.export.targets.luxcore import LUXCORE
from app.materials.catalog import Catalog
from app.materials.front import Front
from app.optics.amplitudes import reflectance
from app.optics.errors import NotAllowed
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.registry import default_registry

OPAQUE = ("Au", "Cr", "red-brass", "TiN")
CLEAR = ("N-BK7", "water", "diamond", "window-glass-shirley")
EVERY_MODE = [
    (target.id, mode.id, mode.kind) for target in TARGETS.values() for mode in target.modes
]


def answers(catalog: Catalog, to: TargetId, mode: ModeId | None = None) -> Iterator[Export]:
    """A few materials of every kind that has the mode."""
    for id in (*OPAQUE, *CLEAR):  # noqa: A001
        answer = export(catalog.get(id), to)
        if mode in (None, *answer.modes):
            yield answer if mode in (None, answer.mode) else export(catalog.get(id), to, mode)


def text_of(answer: Export) -> str:
    (file,) = answer.files
    return file.text


@pytest.mark.parametrize(("to", "mode", "kind"), EVERY_MODE)
def test_each_mode_says_what_it_shows(
    catalog: Catalog, to: TargetId, mode: ModeId, kind: str
) -> None:
    seen = [answer for answer in answers(catalog, to, mode) if answer.kind == kind]
    assert len(seen) == 4
    for answer in seen:
        off = np.abs(answer.reflectance - answer.spectrum)
        assert answer.error.max_abs >= off.max() - 1e-12
        assert answer.reflectance.min() >= 0.0
        assert answer.lost
        assert all(sentence.endswith(".") for sentence in answer.lost)
        if mode == "spectral":
            assert answer.error.max_abs < 1e-4
        written = set(re.findall(r"-?\d+\.?\d*(?:e[-+]?\d+)?", text_of(answer)))
        typed = [v if isinstance(v, list) else [v] for v in answer.parameters.values()]
        told = {number for values in typed for number in values if isinstance(number, float)}
        assert told <= set(map(float, written)), answer.material.id


def test_errors_are_those_of_the_models_over_the_angle(catalog: Catalog) -> None:
    """By another route, which searches between the angles too."""
    models = [default_registry()[name] for name in ("schlick", "f82_tint")]
    ways: dict[str, tuple[TargetId, ModeId]] = {
        "schlick": ("gltf", "schlick"),
        "f82_tint": ("blender", "f82"),
    }
    for id in OPAQUE:  # noqa: A001
        found = curves(catalog.get(id), Front(1.0), models=models, gamut="clamped").rgb
        assert found is not None
        for curve in found.curves[1:]:
            assert curve.errors is not None
            by_channel = {c: getattr(curve.errors, c).max_abs for c in ("red", "green", "blue")}
            error = export(catalog.get(id), *ways[curve.model]).error
            assert error.max_abs == pytest.approx(max(by_channel.values()), abs=1e-4)
            assert by_channel[error.channel] == pytest.approx(error.max_abs, abs=1e-4)


@pytest.mark.parametrize(("to", "mode", "kind"), EVERY_MODE)
def test_what_stands_for_an_engine_explains_what_it_showed(
    to: TargetId, mode: ModeId, kind: str
) -> None:
    (basis,) = (m.basis for m in TARGETS[to].modes if (m.id, m.kind) == (mode, kind))
    if basis.engine is None:
        assert basis.note
        return
    engine = engines()[basis.engine]
    of_way = [c for c in engine.curves if c.way == basis.way and c.medium.kind == kind]
    assert basis.model in {explained(engine, curve) for curve in of_way}


def test_every_material_has_a_file_of_every_target(catalog: Catalog) -> None:
    for preset in catalog.presets:
        assert Surface(preset, "clamped", "srgb").name.isidentifier()
        for to in TARGETS:
            file = exported_file(preset, to, None, "clamped", "srgb")
            assert Surface(preset, "clamped", "srgb").name in file.name
            assert "nan" not in file.text.split()


@pytest.mark.parametrize("to", ["materialx", "openpbr"])
def test_materialx_is_connected(catalog: Catalog, to: TargetId) -> None:
    for answer in answers(catalog, to):
        root = ElementTree.fromstring(text_of(answer).encode())  # noqa: S314
        nodes = {node.get("name"): node for node in root}
        assert root.tag == "materialx"
        assert root.findall("surfacematerial")
        for given in root.iter("input"):
            if "nodename" in given.attrib:
                assert nodes[given.get("nodename")].get("type") == given.get("type")
            else:
                size = {"float": 1, "vector2": 2, "color3": 3, "string": 1}[given.attrib["type"]]
                assert len(given.attrib["value"].split(",")) == size


def test_colors_of_materialx_name_their_space(catalog: Catalog) -> None:
    for space, name in (("srgb", "lin_rec709"), ("acescg", "acescg")):
        answer = export(catalog.get("Cu"), "openpbr", space=space)  # type: ignore[arg-type]
        assert f'colorspace="{name}"' in text_of(answer)
    # n and k are no colors, which color management would turn into others.
    assert "colorspace" not in text_of(export(catalog.get("Cu"), "materialx", "nk"))


def test_gltf_is_whole(catalog: Catalog) -> None:
    for answer in answers(catalog, "gltf"):
        document: dict[str, Any] = json.loads(text_of(answer))
        (material,), (buffer,) = document["materials"], document["buffers"]
        data = base64.b64decode(buffer["uri"].partition(",")[2])
        assert len(data) == buffer["byteLength"]
        assert sum(view["byteLength"] for view in document["bufferViews"]) == len(data)
        assert document.get("extensionsUsed", []) == list(material.get("extensions", {}))
        assert all(0.0 <= c <= 1.0 for c in material["pbrMetallicRoughness"]["baseColorFactor"])
        extensions = material.get("extensions", {})
        if answer.kind == "dielectric":
            assert extensions["KHR_materials_ior"]["ior"] >= 1.0
            if "KHR_materials_dispersion" in extensions:
                assert extensions["KHR_materials_volume"]["thicknessFactor"] > 0.0
    bk7 = json.loads(text_of(export(catalog.get("N-BK7"), "gltf")))["materials"][0]["extensions"]
    assert bk7["KHR_materials_dispersion"]["dispersion"] == pytest.approx(20.0 / 64.17, abs=1e-4)
    # Schott prints 1.5168 relative to air, whose index is 1.00028.
    assert bk7["KHR_materials_ior"]["ior"] == pytest.approx(1.5168 * 1.000277, abs=2e-5)


def test_usd_is_text_of_one_material(catalog: Catalog) -> None:
    for answer in answers(catalog, "usd"):
        text = text_of(answer)
        assert text.startswith("#usda 1.0\n")
        assert text.count("{") == text.count("}") == 2
        name = re.search(r'def Material "(\w+)"', text)
        assert name is not None
        assert f"</{name[1]}/Surface.outputs:surface>" in text
        for parameter in answer.parameters:
            assert f" inputs:{parameter} = " in text


def test_blenders_script_types_the_parameters(catalog: Catalog) -> None:
    for mode in ("nk", "f82", "principled", "ior"):
        for answer in answers(catalog, "blender", mode):
            typed = {}
            modes_before_inputs = []
            for line in ast.parse(text_of(answer)).body:
                if isinstance(line, ast.Assign) and isinstance(line.targets[0], ast.Attribute):
                    modes_before_inputs.append(line.targets[0].attr)
                    of = line.targets[0].value
                    if isinstance(of, ast.Subscript) and isinstance(of.slice, ast.Constant):
                        value = ast.literal_eval(line.value)
                        typed[of.slice.value] = list(value) if isinstance(value, tuple) else value
            assert typed == answer.parameters
            if "fresnel_type" in modes_before_inputs:  # else the inputs are not found by name
                first = modes_before_inputs.index("default_value")
                assert modes_before_inputs.index("fresnel_type") < first


def test_a_source_cannot_leave_its_comment(catalog: Catalog) -> None:
    for preset in catalog.presets:
        text = exported_file(preset, "blender", None, "clamped", "srgb").text
        assert text.splitlines()[1] == "import bpy", preset.id


def test_spectra_are_the_material_s(catalog: Catalog) -> None:
    gold = catalog.spectrum("Au")
    bsdf = json.loads(text_of(export(catalog.get("Au"), "mitsuba", "spectral")))
    words = re.findall(
        r'"spectrum (\w+)" \[ ([^]]*) \]', text_of(export(catalog.get("Au"), "pbrt"))
    )
    of_pbrt = {name: np.array(values.split(), float).reshape(-1, 2) for name, values in words}
    for name, constants in (("eta", gold.n_absolute), ("k", gold.k)):
        at, values = (
            np.array(bsdf[name][key].split(","), float) for key in ("wavelengths", "values")
        )
        assert np.all(np.diff(at) > 0.0)
        np.testing.assert_allclose(values, np.asarray(constants(at), float), rtol=5e-6)
        np.testing.assert_array_equal(of_pbrt[name], np.column_stack([at, values]))


def test_luxcore_names_what_it_defines(catalog: Catalog) -> None:
    for answer in answers(catalog, "luxcore"):
        lines = dict(line.split(" = ") for line in text_of(answer).splitlines())
        defined = {key.split(".")[2] for key in lines if key.startswith("scene.textures.")}
        used = {v.strip('"') for key, v in lines.items() if key.endswith(".fresnel")}
        assert used == defined


def test_luxcores_formula_is_exact_where_nothing_absorbs_and_at_normal_incidence(
    catalog: Catalog,
) -> None:
    class Given(Surface):
        n = [1.3, 1.5, 2.4]  # noqa: RUF012
        k = [0.0, 0.0, 0.0]  # noqa: RUF012

    of_metals = LUXCORE.of("conductor")[0].curve
    angles = Incidence.from_degrees(np.linspace(0.0, 89.75, 360)[:, np.newaxis])
    clear = of_metals(Given(catalog.get("Au"), "clamped", "srgb"))
    exact = reflectance(Interface(1.0, Given.n, 0.0), angles)
    np.testing.assert_allclose(clear, exact, rtol=0, atol=1e-12)
    gold = Surface(catalog.get("Au"), "clamped", "srgb")
    np.testing.assert_allclose(
        of_metals(gold)[0], Interface(1.0, gold.n, gold.k).F0, rtol=0, atol=1e-12
    )


def test_what_a_target_cannot_take_is_refused(catalog: Catalog) -> None:
    gold, water = catalog.get("Au"), catalog.get("water")
    with pytest.raises(NotAllowed, match="nk or f82 for to = materialx"):
        export(gold, "materialx", "ior")
    with pytest.raises(NotAllowed, match="ior for to = blender and a material that is clear"):
        export(water, "blender", "nk")
    with pytest.raises(NotAllowed, match="srgb for to = gltf"):
        export(gold, "gltf", space="acescg")
    with pytest.raises(NotAllowed, match="clamped or scaled"):
        export(gold, "gltf", policy="unclamped")
    assert max(export(gold, "openpbr", policy="unclamped").parameters["base_color"]) > 1.0  # type: ignore[operator, arg-type]
