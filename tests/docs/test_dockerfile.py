"""The Dockerfile is read, not built: no Docker engine is needed to see that it would work."""

import json
import re
import shlex
import tomllib
from fnmatch import fnmatch
from pathlib import Path
from urllib.parse import urlsplit

ROOT = Path(__file__).parents[2]
DOCKERFILE = (ROOT / "Dockerfile").read_text("utf-8")
INSTRUCTIONS = [
    (line.split(maxsplit=1)[0], line.split(maxsplit=1)[1])
    for line in re.sub(r"\\\n\s*", "", DOCKERFILE).splitlines()
    if line and not line.startswith("#")
]
LAST_STAGE = INSTRUCTIONS[
    max(i for i, (instruction, _) in enumerate(INSTRUCTIONS) if instruction == "FROM") :
]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))


def only(instruction: str) -> str:
    """Return the argument of the instruction that the last stage has once."""
    (argument,) = (argument for name, argument in LAST_STAGE if name == instruction)
    return argument


def copied_from_context() -> list[str]:
    """List the paths of the build context that the image is made from."""
    return [
        source
        for name, argument in INSTRUCTIONS
        if name == "COPY" and "--from=" not in argument
        for source in shlex.split(argument)[:-1]
    ]


def is_ignored(path: str) -> bool:
    """Apply .dockerignore: the last pattern that matches decides."""
    ignored = False
    for line in (ROOT / ".dockerignore").read_text("utf-8").splitlines():
        pattern = line.strip()
        if not pattern or pattern.startswith("#"):
            continue
        if fnmatch(path, pattern.removeprefix("!").removeprefix("**/")):
            ignored = not pattern.startswith("!")
    return ignored


def environment() -> dict[str, str]:
    """Read the last stage's ENV instructions."""
    pairs = [
        pair for name, argument in LAST_STAGE if name == "ENV" for pair in shlex.split(argument)
    ]
    return dict(pair.split("=", 1) for pair in pairs)


def test_copied_paths_exist_and_reach_the_build() -> None:
    paths = copied_from_context()
    assert paths
    assert [path for path in paths if not (ROOT / path).exists()] == []
    assert [path for path in paths if is_ignored(path)] == []


def test_everything_the_package_is_built_from_is_copied() -> None:
    wheel = PROJECT["tool"]["hatch"]["build"]["targets"]["wheel"]
    needed = {*wheel["only-include"], PROJECT["project"]["readme"]}
    needed |= {"pyproject.toml", *PROJECT["project"]["license-files"]}
    assert needed <= set(copied_from_context())


def test_installs_what_make_run_installs() -> None:
    locked_install = "install --require-hashes -r requirements.lock"
    built_install = "install --no-deps --no-build-isolation"
    makefile = (ROOT / "Makefile").read_text("utf-8").replace("$(INSTALL)", "install")
    dockerfile = DOCKERFILE.replace(" --no-cache-dir", "")
    for command in (locked_install, built_install):
        assert command in makefile
        assert command in dockerfile


def test_runs_the_command_that_make_run_runs() -> None:
    command = json.loads(only("CMD"))
    assert command[0] in PROJECT["project"]["scripts"]
    recipe = re.search(r"^run:.*\n\t@?(.+)$", (ROOT / "Makefile").read_text("utf-8"), re.MULTILINE)
    assert recipe is not None
    assert [Path(word).name for word in shlex.split(recipe[1].replace("$(BIN)/", ""))] == command


def test_the_copied_environment_is_on_the_path() -> None:
    assert only("COPY").endswith(" /venv /venv")
    assert environment()["PATH"].startswith("/venv/bin:")


def test_runs_as_an_unprivileged_user() -> None:
    user = only("USER").split(":")[0]
    assert user not in {"root", "0"}


def test_health_check_asks_a_route_of_the_application_on_the_served_port() -> None:
    from app.main import create_app

    match = re.search(r"http://[^']+", only("HEALTHCHECK"))
    assert match is not None
    address = urlsplit(match[0])
    assert str(address.port) == environment()["FRESNEL_PORT"] == only("EXPOSE")
    assert address.path in create_app().openapi()["paths"]


def test_listens_beyond_the_container() -> None:
    from app.settings import Settings

    assert environment()["FRESNEL_HOST"] == "0.0.0.0"  # noqa: S104
    prefix = Settings.model_config.get("env_prefix", "")
    variables = [name for name in environment() if name.startswith("FRESNEL_")]
    assert [
        name for name in variables if name.removeprefix(prefix).lower() not in Settings.model_fields
    ] == []
