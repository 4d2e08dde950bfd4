#!/usr/bin/env bash
# One would guess: the soap bubble of a material library shows its film: the source (physicallybased.info)
# says index 1.4, thickness [10, 1000, 500]: a range and a typical value, in nanometers.
# What happens: the MaterialX files that the package ships, as its converter writes them, put the three numbers
# into an input of one: MaterialX reads "10, 1000, 500" as 10, without a word from its validation. OpenPBR counts
# micrometers, so that would be 10 um; Standard Surface and glTF 10 nm. And no file sets the film's weight
# (thin_film_weight of OpenPBR, iridescence of glTF, both 0 by default): with specular_ior 1, OpenPBR's bubble
# reflects nothing at any angle. A film of 500 nm of 1.4 in air reflects 0.103 of light of 550 nm at 0 degrees,
# and 0.105 at most. Pearl (film of 2.0) and anodized titanium (2.488) come without film in the same way.
# Measured 2026-11-30 with materialxmaterials 1.39.5, MaterialX 1.39.5; the shader's defaults from MaterialX.
# Touches: our exports of films write weight and micrometers for OpenPBR (tests/api/test_export.py).
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3}" -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet --disable-pip-version-check materialxmaterials==1.39.5 materialx==1.39.5 tmm==0.2.0 numpy==2.2.6 scipy==1.15.3
"$folder/venv/bin/python" - <<'PYTHON'
import json
from importlib.metadata import version
from importlib.util import find_spec
from math import inf
from pathlib import Path

import MaterialX as mx
from tmm import coh_tmm

print("materialxmaterials", version("materialxmaterials"), "MaterialX", version("materialx"))
data = Path(find_spec("materialxMaterials").origin).parent / "data" / "PhysicallyBasedMaterialX"
source = {entry["name"]: entry for entry in json.loads((data / "PhysicallyBasedMaterial.json").read_text())}
library = mx.createDocument()
mx.loadLibraries(mx.getDefaultDataLibraryFolders(), mx.getDefaultDataSearchPath(), library)
targets = {
    "OPBR": ("open_pbr_surface", "thin_film_thickness", "um", "thin_film_weight", "specular_ior"),
    "SS": ("standard_surface", "thin_film_thickness", "nm", None, "specular_IOR"),
    "GLTF": ("gltf_pbr", "iridescence_thickness", "nm", "iridescence", "ior"),
}
same = True
for name, least in (("Soap Bubble", 10), ("Pearl", 200), ("Titanium (Anodized)", 20)):
    print(f"{name}: source {source[name]['thinFilmThickness']} nm of {source[name]['thinFilmIor']}")
    prefix = "".join(letter if letter.isalnum() else "_" for letter in name)
    for suffix, (category, thickness, unit, weight, ior) in targets.items():
        document = mx.createDocument()
        mx.readFromXmlFile(document, str(data / f"PhysicallyBasedMaterialX_{suffix}.mtlx"))
        document.setDataLibrary(library)
        (shader,) = (node for node in document.getNodes(category) if node.getName().startswith(prefix))
        text, value = shader.getInput(thickness).getValueString(), shader.getInputValue(thickness)
        film = None if weight is None else shader.getInputValue(weight)
        index = shader.getInputValue(ior)
        print(f'  {category}: "{text}" is {value:g} {unit}; weight of the film {film};',
              "valid" if document.validate()[0] else "not valid")
        same &= document.validate()[0] and value == least and film in (None, 0.0)
        if name == "Soap Bubble":
            print(f"    index {index:g} below the film")
            same &= index == 1
film = [float(coh_tmm("s", [1, 1.4, 1], [inf, nm, inf], 0, 550)["R"]) for nm in range(0, 1001)]
print(f"a film of 1.4 in air reflects {film[500]:.4f} at 500 nm, at most {max(film):.4f}")
same &= abs(max(film) - ((1.4**2 - 1) / (1.4**2 + 1)) ** 2) < 1e-5
print("unchanged" if same else "CHANGED")
raise SystemExit(0 if same else 1)
PYTHON
