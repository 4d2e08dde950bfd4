"""The changelog tells of this version, in order."""

import re
import tomllib
from pathlib import Path

from app import __version__

ROOT = Path(__file__).parents[2]
CHANGELOG = (ROOT / "CHANGELOG.md").read_text("utf-8")
VERSIONS = re.findall(r"^## (.+)$", CHANGELOG, re.MULTILINE)


def test_starts_with_the_version_of_the_project() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    assert VERSIONS[0] == project["version"]


def test_the_installed_version_is_the_project_s() -> None:
    assert __version__ == VERSIONS[0]


def test_versions_fall() -> None:
    numbers = [tuple(map(int, version.split("."))) for version in VERSIONS]
    assert all(len(number) == 3 for number in numbers)
    assert numbers == sorted(set(numbers), reverse=True)


def test_every_version_says_something() -> None:
    parts = re.split(r"^## .+$", CHANGELOG, flags=re.MULTILINE)[1:]
    assert all("\n- " in part for part in parts)
