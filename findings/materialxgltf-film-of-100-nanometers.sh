#!/usr/bin/env bash
# One would guess: a glTF film of 550 nm (KHR_materials_iridescence, factor 1, iridescenceThicknessMaximum 550 and
# no texture, so that the maximum is the thickness everywhere) is a film of 550 nm as MaterialX, and again as glTF;
# and a material without specular reflection (KHR_materials_specular, specularFactor 0) stays one.
# What happens: the numbers are taken over only with a texture. The film's iridescence_thickness is 100 (nm), the
# default of MaterialX' glTF shader; so it is for the thickness that glTF takes if none is said, 400 nm. Back in
# glTF the thickness is gone (so 400 nm), and the film stands a second time, as KHR_materials_anisotropy with the
# fields of iridescence. specularFactor 0 is dropped, so F0 is 0.04; 0.5 is kept. The documents validate.
# A film of 1.33 on glass of 1.5 reflects of light of 550 nm 0.0069 at 100 nm, 0.0387 at 400 nm, 0.0147 at 550 nm.
# Measured 2026-11-30 with materialxgltf 1.39.5, MaterialX 1.39.5, against the text of both glTF extensions.
# Touches: our glTF files of films, when this converter takes them on; MaterialX is exported by itself, and both
# thicknesses are tested in tests/api/test_export.py.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3}" -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet --disable-pip-version-check materialxgltf==1.39.5 materialx==1.39.5
"$folder/venv/bin/python" - "$folder" <<'PYTHON'
import base64
import contextlib
import io
import json
import struct
import sys
from importlib.metadata import version
from pathlib import Path

from materialxgltf.core import GLTF2MtlxOptions, GLTF2MtlxReader, MTLX2GLTFOptions, MTLX2GLTFWriter

folder = Path(sys.argv[1])
print("materialxgltf", version("materialxgltf"), "MaterialX", version("materialx"))
TRIANGLE = base64.b64encode(struct.pack("9f", 0, 0, 0, 1, 0, 0, 0, 1, 0)).decode()


def converted(extension, fields):
    """The inputs of the MaterialX shader, and the material that comes back as glTF."""
    material = {"name": "m", "pbrMetallicRoughness": {"metallicFactor": 0}, "extensions": {extension: fields}}
    document = {
        "asset": {"version": "2.0"},
        "extensionsUsed": [extension],
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
        "materials": [material],
        "buffers": [{"byteLength": 36, "uri": f"data:application/octet-stream;base64,{TRIANGLE}"}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}
        ],
    }
    file = folder / "material.gltf"
    file.write_text(json.dumps(document))
    with contextlib.redirect_stdout(io.StringIO()):
        reader, writer = GLTF2MtlxReader(), MTLX2GLTFWriter()
        options = GLTF2MtlxOptions()
        options["createAssignments"] = False
        reader.setOptions(options)
        writer.setOptions(MTLX2GLTFOptions())
        read = reader.convert(str(file))
        assert read.validate()[0]
        shader = read.getNodes("gltf_pbr")[0]
        inputs = {entry.getName(): entry.getValue() for entry in shader.getInputs()}
        if "iridescence" in inputs:
            inputs["iridescence_thickness"] = shader.getInputValue("iridescence_thickness")
        back = json.loads(writer.convert(read))["materials"][0].get("extensions", {})
    return inputs, back


same = True
film = {"iridescenceFactor": 1, "iridescenceIor": 1.33}
for nm in (550, None):
    thickness = {} if nm is None else {"iridescenceThicknessMaximum": nm}
    inputs, back = converted("KHR_materials_iridescence", film | thickness)
    print(f"glTF film of {nm or '400 (not said)'} nm: MaterialX {inputs['iridescence_thickness']:.0f} nm; glTF again: {back}")
    same &= inputs["iridescence_thickness"] == 100 and inputs["iridescence"] == 1
    same &= list(back["KHR_materials_iridescence"]) == ["iridescenceFactor", "iridescenceIor"]
    same &= back.get("KHR_materials_anisotropy") == back["KHR_materials_iridescence"]
for factor in (0, 0.5):
    inputs, back = converted("KHR_materials_specular", {"specularFactor": factor})
    print(f"glTF specularFactor {factor}: MaterialX specular {inputs.get('specular', 'not set, so 1')}; glTF again: {back}")
    same &= inputs.get("specular") == (factor or None)
print("unchanged" if same else "CHANGED")
raise SystemExit(0 if same else 1)
PYTHON
