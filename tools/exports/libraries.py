"""The libraries that read the exports, and where they come from."""

from __future__ import annotations

import os
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path

from app.export.target import TargetId

SCRIPTS = Path(__file__).parent / "scripts"


@dataclass(frozen=True, slots=True)
class Library:
    """A package that reads the files of some targets."""

    package: str
    version: str
    script: str
    targets: tuple[TargetId, ...]
    python: str | None = "3.11"
    """The Python that the package is run with; None for a package of npm."""
    in_tests: bool = True
    """Whether it is among what the tests install."""


LIBRARIES = (
    Library("materialx", "1.39.5", "materialx_check.py", ("materialx", "openpbr")),
    Library("usd-core", "26.11", "usd_check.py", ("usd",)),
    Library("mitsuba", "3.9.1", "mitsuba_check.py", ("mitsuba",)),
    Library("gltf-validator", "2.0.0-dev.3.10", "gltf_check.mjs", ("gltf",), python=None),
    Library("pyluxcore", "2.11.2", "luxcore_check.py", ("luxcore",), in_tests=False),
    Library("bpy", "5.2.3", "blender_check.py", ("blender",), "3.13", in_tests=False),
)


def command(library: Library, folder: Path) -> list[str]:
    """Install a library below a folder, unless it is there, and return how its script is run."""
    script = str(SCRIPTS / library.script)
    home = folder / library.package
    if library.python is None:
        if not home.exists():
            home.mkdir(parents=True)
            shutil.copy(script, home)  # a module finds packages beside itself
            wanted = f"{library.package}@{library.version}"
            subprocess.run(["npm", "install", "--silent", "--prefix", home, wanted], check=True)
        return ["node", str(home / library.script)]
    if not home.exists():
        variable = f"PYTHON_{library.python.replace('.', '_')}"
        name = os.environ.get(variable) or shutil.which(f"python{library.python}")
        if name is None:
            raise SystemExit(f"{library.package} is built for Python {library.python}: {variable}")
        subprocess.run([name, "-m", "venv", home], check=True)
        install = [str(home / "bin" / "python"), "-m", "pip", "install", "--quiet", "numpy"]
        subprocess.run([*install, f"{library.package}=={library.version}"], check=True)
    return [str(home / "bin" / "python"), "-P", script]
