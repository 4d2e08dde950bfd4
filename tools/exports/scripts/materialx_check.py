"""MaterialX: each document is read, validated with the standard library, and made into GLSL."""

from __future__ import annotations

import json
import sys

import MaterialX
from MaterialX import PyMaterialXGenGlsl, PyMaterialXGenShader


def main() -> None:
    """Check the files that standard input lists."""
    library = MaterialX.createDocument()
    search = MaterialX.getDefaultDataSearchPath()
    MaterialX.loadLibraries(MaterialX.getDefaultDataLibraryFolders(), search, library)
    generator = PyMaterialXGenGlsl.GlslShaderGenerator.create()
    context = PyMaterialXGenShader.GenContext(generator)
    context.registerSourceCodeSearchPath(search)
    errors, entries = [], json.load(sys.stdin)
    for entry in entries:
        document = MaterialX.createDocument()
        try:
            MaterialX.readFromXmlFile(document, entry["file"])
            document.setDataLibrary(library)
            valid, message = document.validate()
            if not valid:
                raise ValueError(message)
            for node in document.getNodes():
                definition = node.getNodeDef()
                if definition is None:
                    raise ValueError(f"{node.getCategory()} is no node")
                for given in node.getInputs():
                    known = definition.getActiveInput(given.getName())
                    if known is None or known.getType() != given.getType():
                        raise ValueError(f"{node.getCategory()} has no such {given.getName()}")
            (material,) = document.getMaterialNodes()
            shader = generator.generate(material.getName(), material, context)
            if "mx_" not in shader.getSourceCode("pixel"):
                raise ValueError("no shader")
        except Exception as error:  # whatever the library finds wrong is what is asked
            errors.append(f"{entry['material']} {entry['mode']}: {error}")
    print(json.dumps({"read": len(entries), "errors": errors}))


main()
