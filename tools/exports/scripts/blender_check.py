"""Blender: each script is run, and what its nodes keep compared with what is typed."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

import bpy


def kept(entry: dict[str, Any]) -> None:
    """Run a script, and look its inputs up in the material that it made."""
    before = set(bpy.data.materials)
    exec(Path(entry["file"]).read_text(encoding="utf-8"), {})  # noqa: S102
    (material,) = set(bpy.data.materials) - before
    (link,) = material.node_tree.links
    for name, typed in entry["parameters"].items():
        value = link.from_node.inputs[name].default_value
        pair = zip(value, typed, strict=True) if isinstance(typed, list) else [(value, typed)]
        for has, wanted in pair:
            if abs(has - wanted) > 1e-5 * max(1.0, abs(wanted)):
                raise ValueError(f"{name} is {has}, not {wanted}")
    bpy.data.materials.remove(material)


def main() -> None:
    """Check the files that standard input lists."""
    errors, entries = [], json.load(sys.stdin)
    for entry in entries:
        try:
            kept(entry)
        except Exception as error:  # whatever the library finds wrong is what is asked
            errors.append(f"{entry['material']} {entry['mode']}: {error}")
    print(json.dumps({"read": len(entries), "errors": errors}))


main()
