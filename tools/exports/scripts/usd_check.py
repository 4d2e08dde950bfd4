"""USD: each layer is opened, validated by all validators, and its shader's inputs looked up."""

from __future__ import annotations

import json
import sys
from collections import Counter

from pxr import Sdr, Usd, UsdShade, UsdValidation


def main() -> None:
    """Check the files that standard input lists."""
    registry = UsdValidation.ValidationRegistry()
    validators = registry.GetOrLoadAllValidators()
    context = UsdValidation.ValidationContext(validators)
    definition = Sdr.Registry().GetShaderNodeByIdentifier("UsdPreviewSurface")
    warnings: Counter[str] = Counter()
    errors, entries = [], json.load(sys.stdin)
    for entry in entries:
        stage = Usd.Stage.Open(entry["file"])
        for found in context.Validate(stage):
            told = f"{found.GetName()}: {found.GetMessage()}"
            if found.GetType() == UsdValidation.ValidationErrorType.Error:
                errors.append(f"{entry['material']} {entry['mode']}: {told}")
            else:
                warnings[found.GetName()] += 1
        material = UsdShade.Material(stage.GetDefaultPrim())
        shader, *_ = material.ComputeSurfaceSource()
        if not shader:
            errors.append(f"{entry['material']} {entry['mode']}: its material has no surface")
            continue
        for given in shader.GetInputs():
            known = definition.GetShaderInput(given.GetBaseName())
            if known is None or known.GetTypeAsSdfType().GetSdfType() != given.GetTypeName():
                errors.append(f"{entry['material']}: no such {given.GetBaseName()}")
    print(json.dumps({"read": len(entries), "errors": errors, "warnings": dict(warnings)}))


main()
