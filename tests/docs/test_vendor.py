"""static/vendor holds what its manifest says, and the page asks for nothing else."""

import hashlib
import json
import re
import tomllib
from pathlib import Path
from typing import Any

import pytest
from fontTools.ttLib import TTFont

from app.figures.look import FACE

ROOT = Path(__file__).parents[2]
STATIC = ROOT / "static"
VENDOR = STATIC / "vendor"
PACKAGES: list[dict[str, Any]] = json.loads((VENDOR / "manifest.json").read_text("utf-8"))[
    "packages"
]
FILES: dict[str, dict[str, Any]] = {
    name: recorded for package in PACKAGES for name, recorded in package["files"].items()
}
LOCKED: dict[str, dict[str, Any]] = json.loads((ROOT / "package-lock.json").read_text("utf-8"))[
    "packages"
]
FREE_LICENCES = {"Apache-2.0", "BSD-3-Clause", "MIT", "OFL-1.1"}


@pytest.mark.parametrize("name", sorted(FILES))
def test_file_is_the_recorded_one(name: str) -> None:
    content = (VENDOR / name).read_bytes()
    assert len(content) == FILES[name]["bytes"]
    assert hashlib.sha256(content).hexdigest() == FILES[name]["sha256"]


def test_no_file_is_unlisted() -> None:
    present = {path.relative_to(VENDOR).as_posix() for path in VENDOR.rglob("*") if path.is_file()}
    assert present == {"manifest.json", *FILES}


@pytest.mark.parametrize("package", PACKAGES, ids=lambda package: str(package["name"]))
def test_package_is_the_locked_one_with_its_licence(package: dict[str, Any]) -> None:
    locked = LOCKED[f"node_modules/{package['npm']}"]
    assert (package["version"], package["licence"]) == (locked["version"], locked["license"])
    assert package["licence"] in FREE_LICENCES
    assert package["licence_file"] in package["files"]
    # The server lets browsers keep these files for ever, so a new version needs a new folder.
    folder = f"{package['name']}-{package['version']}/"
    assert all(name.startswith(folder) for name in package["files"])


def test_the_cut_font_has_no_reserved_name_and_keeps_its_copyright() -> None:
    """The Open Font License reserves "Plex" for what is not changed (section 3)."""
    (package,) = (p for p in PACKAGES if p["npm"] == "@fontsource-variable/ibm-plex-sans")
    (cut,) = (name for name in package["files"] if name.endswith(".woff2"))
    with TTFont(VENDOR / cut) as font:
        names = {record.nameID: record.toUnicode() for record in font["name"].names}
    assert names[1] == "Fresnel Sans"
    assert "IBM Corp." in names[0]
    assert names[14] == "http://scripts.sil.org/OFL"
    pages = [path for path in STATIC.rglob("*") if path.suffix in {".css", ".html", ".js"}]
    told = [cut, *names.values(), FACE, *(path.read_text("utf-8") for path in pages)]
    assert not any(re.search(r"\bplex", text, re.IGNORECASE) for text in told)


def test_every_vendored_address_on_the_page_exists() -> None:
    sources = [
        path
        for path in STATIC.rglob("*")
        if path.suffix in {".html", ".css", ".js"} and VENDOR not in path.parents
    ]
    # A script may name a package's folder and put the files' names behind it.
    known = {"manifest.json", *FILES, *(name.split("/")[0] for name in FILES)}
    missing = [
        f"{source.relative_to(ROOT)}: {address}"
        for source in sources
        for address in re.findall(r"vendor/([\w./-]+\.\w+)", source.read_text("utf-8"))
        if address not in known
    ]
    assert missing == []


def test_stylesheets_find_their_fonts() -> None:
    stylesheet = "katex-0.19.1/katex.min.css"
    fonts = re.findall(r"url\((fonts/[^)]+\.woff2)\)", (VENDOR / stylesheet).read_text("utf-8"))
    assert fonts
    assert {f"katex-0.19.1/{font}" for font in fonts} <= set(FILES)


@pytest.mark.parametrize(
    "lock", sorted(ROOT.glob("requirements*.lock")), ids=lambda path: path.name
)
def test_python_locks_pin_every_package_by_hash_and_name_no_host(lock: Path) -> None:
    text = lock.read_text("utf-8")
    assert "://" not in text
    requirements = re.findall(r"^(\S.*?)(?= \\$)", text, re.MULTILINE)
    assert requirements
    assert all(re.match(r"[\w.-]+==\S+", requirement) for requirement in requirements)
    assert len(requirements) == len(re.findall(r"^[\w]", text, re.MULTILINE))


def test_python_locks_hold_the_declared_dependencies() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))
    groups = project["dependency-groups"]
    run = [*project["project"]["dependencies"], *groups["build"]]
    for lock, declared in (
        ("requirements.lock", run),
        ("requirements-test.lock", [*run, *groups["test"]]),
        ("requirements-node.lock", groups["node"]),
    ):
        locked = set(re.findall(r"^([\w.-]+)==", (ROOT / lock).read_text("utf-8"), re.MULTILINE))
        names = {re.split(r"[<>=\[ ]", requirement)[0].lower() for requirement in declared}
        assert names <= locked, lock


def test_npm_lock_names_no_registry() -> None:
    assert not [name for name, package in LOCKED.items() if "resolved" in package]
    assert all("integrity" in package for name, package in LOCKED.items() if name)
