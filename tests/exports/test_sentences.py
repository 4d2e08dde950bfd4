"""Sentences about engines: each names what shows it, and what their libraries show here is shown."""

import json
import subprocess
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import MaterialX
import mitsuba
import numpy as np
import pytest
from MaterialX import PyMaterialXGenOsl, PyMaterialXGenShader

from app.answers.materials.export import export, exported_file
from app.engines.explained import DEPARTURES
from app.engines.measured import engines
from app.export.registry import TARGETS
from app.export.target import ModeId, TargetId
from app.materials.media import default_catalog
from app.optics.coats import Base, coat_shortcuts
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from tools.engines.engines import ENGINES

ROOT = Path(__file__).parents[2]
HERE = "tests/exports/test_sentences.py"

SHOWN_BY: Mapping[str, str] = {
    "its metallic workflow would reflect the same": "materials/engines/usd.json",
    "Its shader shows Schlick's curve of the index": "materials/engines/usd.json",
    "Below an index of 1.5 Babylon's": "materials/engines/babylon.json",
    "Filament shows no reflection without it": "materials/engines/filament.json",
    "The generator's prefiltered environment": "materials/engines/materialx.json",
    "Viewers show Schlick's curve": "materials/engines/three.json",
    "the formula of LuxCore's source": "tools/exports/scripts/luxcore_check.py",
    "LuxCore's formula for constant n and k": "findings/luxcore-metals-of-constant-n-k.sh",
    "MaterialX's generator for OSL": HERE,
    "spectral ones take the numbers for reflectances": HERE,
    "those of RGB end in an error": HERE,
}
"""What an export says of an engine, by a part of the sentence, and what shows it."""

OF_THE_FILE = (
    "no extension has it",
    "One index stands",
    "The color at 0 and 82",
    "The spectrum becomes",
    "What the medium absorbs",
    "sampled every 5 nm",
    "Dispersion is kept",
)
"""What is said of the file, or of its format's specification."""

DOCUMENTED = ("by its source; not run", "by its documentation; not run")


def test_every_sentence_of_an_export_names_what_shows_it() -> None:
    modes = [mode for target in TARGETS.values() for mode in target.modes]
    said = {*(s for mode in modes for s in mode.lost), *(m.basis.note for m in modes)} - {""}
    for sentence in said:
        shown = [path for part, path in SHOWN_BY.items() if part in sentence]
        told = any(part in sentence for part in (*OF_THE_FILE, *DOCUMENTED))
        assert shown or told, sentence
        assert all((ROOT / path).is_file() for path in shown)
    assert all(any(part in sentence for sentence in said) for part in SHOWN_BY)


@pytest.mark.parametrize(
    "engine", ["babylon", "filament", "materialx", "playcanvas", "three", "usd"]
)
def test_departures_are_of_curves_that_a_script_measures_again(engine: str) -> None:
    """What a departure says is filled in from the file; tests/engines has that it is no noise."""
    measured, tool = engines()[engine], ENGINES[engine]
    assert measured.repeat == f"python -m tools.engines {engine}"
    assert (measured.package, measured.version) == (tool.package, tool.version)
    assert measured.how == tool.how
    for departure in DEPARTURES[engine]:
        assert departure.told(measured)


def test_every_engine_names_a_script_that_is_there() -> None:
    assert set(engines()) == set(ENGINES)
    for measured in engines().values():
        assert measured.repeat == f"python -m tools.engines {measured.id}"


# MaterialX


def _standard() -> Any:
    library = MaterialX.createDocument()
    folders = MaterialX.getDefaultDataLibraryFolders()
    MaterialX.loadLibraries(folders, MaterialX.getDefaultDataSearchPath(), library)
    return library


def _osl(text: str) -> str:
    library = _standard()
    document = MaterialX.createDocument()
    MaterialX.readFromXmlString(document, text)
    document.setDataLibrary(library)
    generator = PyMaterialXGenOsl.OslShaderGenerator.create()
    context = PyMaterialXGenShader.GenContext(generator)
    context.registerSourceCodeSearchPath(MaterialX.getDefaultDataSearchPath())
    (material,) = document.getMaterialNodes()
    shader = generator.generate(material.getName(), material, context)
    return str(shader.getSourceCode("pixel"))


@pytest.mark.parametrize(("to", "mode"), [("openpbr", "f82"), ("materialx", "f82")])
def test_osl_drops_the_color_at_82_degrees(to: TargetId, mode: ModeId) -> None:
    """The function takes it, and its closure, which is all that it does, does not."""
    text = exported_file(default_catalog().get("Cr"), to, mode, "clamped", "srgb").text
    code = _osl(text)
    body = code[code.index("void mx_generalized_schlick_bsdf(") :]
    taken, body = body[: body.index("{")], body[body.index("{") : body.index("}")]
    assert "color82" in taken
    assert "color90" in body
    assert "color82" not in body


def _worked_out(graph: Any, name: str, given: Mapping[str, float]) -> float:
    """One number of a graph of arithmetic nodes."""
    node = graph.getNode(name)

    def value(port: str) -> float:
        wire = node.getInput(port)
        if wire.getNodeName():
            return _worked_out(graph, wire.getNodeName(), given)
        if wire.getInterfaceName():
            return given[wire.getInterfaceName()]
        return float(str(wire.getValueString()).split(",")[0])

    operation = node.getCategory()
    if operation == "convert":
        return value("in")
    if operation == "mix":
        share = value("mix")
        return share * value("fg") + (1.0 - share) * value("bg")
    a, b = value("in1"), value("in2")
    results = {"add": a + b, "subtract": a - b, "multiply": a * b}
    return a / b if operation == "divide" else results[operation]


@pytest.mark.parametrize(("F0", "n"), [(0.9, 1.5), (0.3, 1.6), (0.6, 2.0)])
def test_openpbr_in_materialx_darkens_a_metal_as_its_graph_does(F0: float, n: float) -> None:
    graph = _standard().getNodeGraph("NG_open_pbr_surface_surfaceshader")
    given = {"base_color": F0, "base_metalness": 1.0, "specular_weight": 1.0, "coat_ior": n}
    given |= {"subsurface_color": 0.8, "subsurface_weight": 0.0}
    darkening = _worked_out(graph, "base_darkening", given)
    coat = float(Interface(1.0, n).F0)
    base = Base(np.full(3, F0), np.ones(3), n)
    at_normal = Incidence.from_degrees(np.zeros(1))
    found = coat_shortcuts()["materialx_openpbr_coat"].color(base, at_normal)
    np.testing.assert_allclose(found, coat + (1.0 - coat) * F0 * darkening, rtol=1e-12)


# Mitsuba


def _reflected(bsdf: dict[str, Any], variant: str, nm: float = 550.0) -> list[float]:
    mitsuba.set_variant(variant)
    loaded = mitsuba.load_dict(bsdf)
    at = mitsuba.SurfaceInteraction3f()
    at.wi = [0.0, 0.0, 1.0]
    if variant.endswith("spectral"):
        at.wavelengths = [nm] * 4
    _, weight = loaded.sample(mitsuba.BSDFContext(), at, 0.5, [0.5, 0.5])
    return [float(x) for x in weight]


def test_modes_of_mitsuba_are_for_their_variants() -> None:
    copper = default_catalog().get("Cu")
    pairs = json.loads(exported_file(copper, "mitsuba", "nk", "clamped", "srgb").text)
    said = export(copper, "mitsuba", "nk").reflectance[0]
    np.testing.assert_allclose(_reflected(pairs, "scalar_rgb")[:3], said, atol=1e-5)
    assert abs(_reflected(pairs, "scalar_spectral")[0] - said[1]) > 0.1
    spectra = json.loads(exported_file(copper, "mitsuba", "spectral", "clamped", "srgb").text)
    with pytest.raises(RuntimeError, match="not implemented"):
        _reflected(spectra, "scalar_rgb")


# glTF


def _issues(extension: str, values: dict[str, Any]) -> list[str]:
    document = {
        "asset": {"version": "2.0"},
        "extensionsUsed": [extension],
        "materials": [{"extensions": {extension: values}}],
    }
    script = (
        "import { validateString } from 'gltf-validator';"
        f"const {{ issues }} = await validateString({json.dumps(json.dumps(document))});"
        "console.log(JSON.stringify(issues.messages.filter((m) => m.severity === 0)))"
    )
    run = ["node", "--input-type=module", "-e", script]
    done = subprocess.run(run, capture_output=True, text=True, check=True, cwd=ROOT)
    return [message["code"] for message in json.loads(done.stdout)]


@pytest.mark.parametrize(
    ("extension", "values", "wrong"),
    [
        ("KHR_materials_ior", {"ior": 0.5}, True),
        ("KHR_materials_ior", {"ior": 0.0}, False),
        ("KHR_materials_ior", {"ior": 100.0}, False),
        ("KHR_materials_specular", {"specularFactor": 1.5}, True),
        ("KHR_materials_dispersion", {"dispersion": -0.1}, True),
        ("KHR_materials_dispersion", {"dispersion": 4.0}, False),
        ("KHR_materials_specular", {"specularColorFactor": [2.0, 2.0, 2.0]}, False),
    ],
)
def test_what_the_validator_takes_for_an_error(
    extension: str, values: dict[str, Any], wrong: bool
) -> None:
    assert _issues(extension, values) == (["VALUE_NOT_IN_RANGE"] if wrong else [])
