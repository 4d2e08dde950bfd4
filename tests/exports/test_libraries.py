"""Every material, in every mode of every target that a library reads, given to that library.

Each library reads all of its files in one process of its own. LuxCore's and Blender's are read by
`python -m tools.exports` alone, and pbrt has no library that reads a material.
"""

import sys

import pytest

from app.export.registry import TARGETS
from app.materials.media import default_catalog
from tools.exports.checking import checked
from tools.exports.libraries import LIBRARIES, SCRIPTS, Library

READING = [library for library in LIBRARIES if library.in_tests]

# By library and code: none so far.
WARNINGS: dict[str, dict[str, int]] = {}


def run_here(library: Library) -> list[str]:
    """Node finds the validator in the project's own packages, as this Python finds the others."""
    script = str(SCRIPTS / library.script)
    if library.python is None:
        return ["node", script]
    return [sys.executable, "-P", script]


@pytest.mark.parametrize("library", READING, ids=lambda library: library.package)
def test_every_material_is_accepted(library: Library) -> None:
    found = checked(library, run_here(library))
    assert found["errors"] == []
    assert found["read"] >= len(default_catalog().presets) * len(library.targets)
    assert found.get("warnings", {}) == WARNINGS.get(library.package, {})
    if library.package == "mitsuba":
        # At 0, 30, 60, 80 and 85 degrees, of what the answers say that it will reflect.
        assert 0.0 < found["farthest"] < 1e-3


def test_what_no_library_reads_here_is_told() -> None:
    read = {target for library in READING for target in library.targets}
    assert set(TARGETS) - read == {"blender", "luxcore", "pbrt"}
