"""What the README says is so: its commands, its example, its tables, its links."""

import asyncio
import io
import re
import shlex
import subprocess
import urllib.request
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import httpx
import plotly.graph_objects
import pytest
import yaml
from typer.testing import CliRunner

from app import __version__
from app.cli.main import cli
from app.main import create_app
from app.optics.registry import default_registry
from app.settings import Settings
from tests.api.raw import send
from tools.readme import PARTS, refreshed

ROOT = Path(__file__).parents[2]
README = (ROOT / "README.md").read_text("utf-8")
BLOCKS: list[tuple[str, str]] = re.findall(
    r"^```(\w*)\n(.*?)^```$", README, re.MULTILINE | re.DOTALL
)
COMMANDS = [line for language, block in BLOCKS if language == "sh" for line in block.splitlines()]
MAKE = [command for command in COMMANDS if command.startswith("make ")]
CALLS = [command for command in COMMANDS if command.startswith("curl ")]
ASKED = [command for command in COMMANDS if command.startswith("fresnel-explorer ")]
CELLS = [block for language, block in BLOCKS if language == "python"]
TARGETS = re.findall(r"^([a-z]+):", (ROOT / "Makefile").read_text("utf-8"), re.MULTILINE)
# Of Markdown [text](address), of HTML src="address" and srcset="address".
ADDRESSES = re.findall(r"\]\(([^)\s]+)\)|src(?:set)?=\"([^\"]+)\"", README)
RELATIVE = sorted({path for pair in ADDRESSES for path in pair if path and "://" not in path})


def test_every_command_is_one_that_is_checked_here() -> None:
    assert {"make run", "make test"} <= set(MAKE)
    assert len(CALLS) == 1
    assert sorted(COMMANDS) == sorted(MAKE + CALLS + ASKED)


@pytest.mark.parametrize("command", [*MAKE, *re.findall(r"`(make [a-z]+)`", README)])
def test_make_knows_the_command(command: str) -> None:
    assert command.removeprefix("make ") in TARGETS
    dry_run = [*shlex.split(command), "--dry-run", "--silent"]
    subprocess.run(dry_run, cwd=ROOT, check=True, stdout=subprocess.DEVNULL)


async def answer(address: str) -> httpx.Response:
    """Ask the application itself, without a server."""
    transport = httpx.ASGITransport(app=create_app())
    async with httpx.AsyncClient(transport=transport) as client:
        return await client.get(address)


def test_the_call_gives_the_answer_shown() -> None:
    (_, address) = shlex.split(CALLS[0])
    served_at = Settings.model_construct()  # the defaults, whatever the environment says
    called = urlsplit(address)
    assert (called.hostname, called.port) == (served_at.host, served_at.port)
    at = next(i for i, (_, block) in enumerate(BLOCKS) if CALLS[0] in block)
    language, shown = BLOCKS[at + 1]
    assert language == "text"
    response = asyncio.run(answer(address))
    assert response.status_code == 200
    assert response.text.splitlines() == shown.splitlines()


@pytest.mark.parametrize("command", ASKED)
def test_a_command_prints_what_is_shown(command: str) -> None:
    at = next(i for i, (_, block) in enumerate(BLOCKS) if command in block)
    language, shown = BLOCKS[at + 1]
    assert language == "text"
    result = CliRunner().invoke(cli, shlex.split(command)[1:])
    assert result.exit_code == 0
    assert result.output.splitlines() == shown.splitlines()


def test_a_cell_shows_a_figure(monkeypatch: pytest.MonkeyPatch) -> None:
    """Three lines, run as they stand; the last one's value is what a notebook shows."""
    (cell,) = CELLS
    *before, last = filter(None, cell.splitlines())
    assert len(before) == 2
    app = create_app()

    def urlopen(address: str) -> io.BytesIO:
        parts = urlsplit(address)
        assert parts.netloc == "127.0.0.1:8000"
        answer = send(app, f"{parts.path}?{parts.query}".encode())
        assert answer.status == 200
        return io.BytesIO(answer.body)

    monkeypatch.setattr(urllib.request, "urlopen", urlopen)
    names: dict[str, Any] = {}
    exec("\n".join(before), names)  # noqa: S102 - the README's own lines
    figure = eval(last, names)  # noqa: S307
    assert isinstance(figure, plotly.graph_objects.Figure)
    assert {trace.name for trace in figure.data} == {"exact", "Schlick", "1 - cos"}


def test_generated_parts_are_fresh() -> None:
    assert refreshed(README) == README, "run make readme"


def test_generated_parts_name_everything() -> None:
    made = {name: make() for name, make in PARTS.items()}
    models = made["exact-forms"] + made["approximations"]
    assert [model_id for model_id in default_registry() if f"| `{model_id}` |" not in models] == []
    assert [path for path in create_app().openapi()["paths"] if path not in made["routes"]] == []
    assert [
        name for name in Settings.model_fields if f"FRESNEL_{name.upper()}" not in made["settings"]
    ] == []


def test_a_readme_without_its_markers_is_refused() -> None:
    with pytest.raises(ValueError, match="markers of routes"):
        refreshed(README.replace("<!-- routes:end -->", ""))


@pytest.mark.parametrize("path", RELATIVE)
def test_link_leads_somewhere(path: str) -> None:
    assert (ROOT / path).exists()
    tracked = ["git", "ls-files", "--error-unmatch", path]
    if (ROOT / ".git").exists():
        subprocess.run(tracked, cwd=ROOT, check=True, stdout=subprocess.DEVNULL)


def test_the_citation_is_of_this_version() -> None:
    citation = yaml.safe_load((ROOT / "CITATION.cff").read_text("utf-8"))
    assert citation["version"] == __version__
    assert {"cff-version", "message", "title", "authors"} <= citation.keys()


def test_pictures_are_pictures() -> None:
    pictures = [path for path in RELATIVE if path.endswith(".png")]
    assert "docs/explore-light.png" in pictures
    for picture in pictures:
        content = (ROOT / picture).read_bytes()
        assert content.startswith(b"\x89PNG\r\n")
        width, height = (int.from_bytes(content[at : at + 4], "big") for at in (16, 20))
        assert (width, height) == (1440, 900)
