"""Imports go one way: optics, then materials, then the API, then the application."""

import ast
import subprocess
import sys
from collections.abc import Iterator
from graphlib import TopologicalSorter
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]

LAYERS = {
    "app.optics": set(),
    "app.materials": {"app.optics"},
    "app.engines": {"app.materials", "app.optics"},
    "app.atlas": {"app.materials", "app.optics"},
    "app.export": {"app.materials", "app.optics"},
    "app.snippets": {"app.optics"},
    "app.claims": {"app.answers", "app.optics"},
    "app.batch": {"app.atlas", "app.materials", "app.optics"},
    "app.figures": {"app.answers", "app.materials", "app.optics"},
    "app.answers": {
        "app.atlas",
        "app.engines",
        "app.export",
        "app.materials",
        "app.optics",
        "app.snippets",
    },
    "app.server.pool": set(),
    "app.server.drain": set(),
    "app.server.memory": set(),
    "app.http": {"app.answers", "app.optics", "app.server.pool"},
    "app.api": {
        "app.answers",
        "app.atlas",
        "app.batch",
        "app.claims",
        "app.engines",
        "app.export",
        "app.figures",
        "app.http",
        "app.materials",
        "app.optics",
        "app.server.drain",
        "app.server.memory",
        "app.server.pool",
        "app.snippets",
    },
    "app.page": {"app.answers", "app.http", "app.optics"},
    "app.settings": set(),
}
OUTSIDE = {
    "app.optics": {"numpy", "scipy"},
    "app.engines": {"numpy"},
    "app.atlas": {"numpy", "arro3"},
    "app.export": {"numpy"},
    "app.snippets": set(),
    "app.materials": {"cachetools", "numpy", "scipy", "pydantic", "yaml", "orjson"},
    "app.claims": {"numpy"},
}
WEB = {"fastapi", "starlette", "uvicorn", "pydantic", "pydantic_core", "orjson", "typer"}


def name_of(path: Path) -> str:
    parts = path.relative_to(ROOT).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


MODULES = {name_of(path): path for path in sorted((ROOT / "app").rglob("*.py"))}


def imported(node: ast.AST) -> Iterator[str]:
    """Full names that one import statement reaches for."""
    if isinstance(node, ast.Import):
        yield from (alias.name for alias in node.names)
    elif isinstance(node, ast.ImportFrom):
        assert node.level == 0, "imports are absolute"
        assert node.module is not None
        for alias in node.names:
            submodule = f"{node.module}.{alias.name}"
            yield submodule if submodule in MODULES else node.module


def imports(module: str) -> set[str]:
    """Everything a module imports, inside functions too."""
    tree = ast.parse(MODULES[module].read_text("utf-8"))
    return {name for node in ast.walk(tree) for name in imported(node)}


def imports_when_loaded(module: str) -> set[str]:
    """What a module imports before its first line of use."""
    tree = ast.parse(MODULES[module].read_text("utf-8"))
    return {name for node in tree.body for name in imported(node)}


def layer(module: str) -> str | None:
    return next((x for x in LAYERS if module == x or module.startswith(f"{x}.")), None)


@pytest.mark.parametrize("module", [module for module in MODULES if layer(module)])
def test_a_layer_imports_those_below(module: str) -> None:
    own = layer(module)
    assert own is not None
    inside = {name for name in imports(module) if name.split(".")[0] == "app"} - {"app"}
    assert {name for name in inside if layer(name) not in LAYERS[own] | {own}} == set()


@pytest.mark.parametrize("module", [module for module in MODULES if layer(module) in OUTSIDE])
def test_the_lower_layers_need_few_packages(module: str) -> None:
    own = layer(module)
    assert own is not None
    packages = {name.split(".")[0] for name in imports(module)}
    assert packages - OUTSIDE[own] - {"app"} - sys.stdlib_module_names == set()


def test_no_modules_import_each_other() -> None:
    graph = {module: imports_when_loaded(module) & set(MODULES) for module in MODULES}
    order = list(TopologicalSorter(graph).static_order())  # raises CycleError
    assert len(order) == len(MODULES)


def test_the_core_has_no_import_circle() -> None:
    """Counting imports within functions and for types alone, which only hide a circle."""
    core = {module for module in MODULES if layer(module) == "app.optics"}
    graph = {module: imports(module) & core for module in core}
    assert set(TopologicalSorter(graph).static_order()) == core  # raises CycleError


def test_numerics_know_no_physics() -> None:
    for module in MODULES:
        if module.startswith("app.optics.numerics."):
            inside = {name for name in imports(module) if name.startswith("app.")}
            below = {name for name in inside if name.startswith("app.optics.numerics.")}
            assert inside - below <= {"app.optics.parameters"}, module


def test_the_core_runs_without_the_web() -> None:
    """In a process of its own: every module of the core, and a curve of every model."""
    code = f"""
import importlib, pkgutil, sys
import app.optics
for module in pkgutil.walk_packages(app.optics.__path__, "app.optics."):
    importlib.import_module(module.name)
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.registry import default_registry
for model in default_registry().values():
    model(Interface(), Incidence.from_degrees([0.0, 45.0]))
print(*sorted({WEB!r} & set(sys.modules)))
"""
    command = [sys.executable, "-W", "error", "-c", code]
    run = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True)
    assert run.stdout.split() == []
