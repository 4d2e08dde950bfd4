"""The command: what it prints, where it serves, how it ends."""

import json
import os
import re
import signal
import socket
import subprocess
import sys
import tomllib
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from urllib.request import urlopen

import pytest
from pydantic import ValidationError
from typer.testing import CliRunner

from app.cli.main import cli
from app.settings import Settings

ROOT = Path(__file__).parents[2]
COMMAND = Path(sys.executable).with_name("fresnel-explorer")
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
VERSION = PROJECT["version"]
PATIENCE_S = 300.0  # starting takes two seconds, and minutes on a machine with much else to do


def run(*arguments: str, **environment: str) -> tuple[int, str]:
    """Exit code and everything printed, without the frame that a terminal's width breaks."""
    result = CliRunner().invoke(cli, arguments, env={"COLUMNS": "200", **environment})
    return result.exit_code, re.sub(r"[│╭╮╰╯─]+|\s+", " ", result.output)


@contextmanager
def serving(*arguments: str, **environment: str) -> Iterator[tuple[subprocess.Popen[str], str]]:
    """Start the installed command; yield it and the line it prints."""
    with subprocess.Popen(
        [COMMAND, *arguments],
        env=os.environ | environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    ) as process:
        assert process.stdout is not None
        try:
            yield process, process.stdout.readline()
        finally:
            process.kill()


def health(url: str) -> dict[str, str]:
    """Ask at once: what is announced is listened at."""
    with urlopen(f"{url}/api/v1/health") as answer:  # noqa: S310 - an http URL of our own
        told: dict[str, str] = json.load(answer)
        return told


def test_the_command_is_installed() -> None:
    assert PROJECT["scripts"]["fresnel-explorer"] == "app.cli.main:main"
    assert COMMAND.is_file()


def test_without_a_command_it_tells_what_there_is() -> None:
    assert run() == run("--help")
    assert run()[0] == 0


def test_version() -> None:
    code, printed = run("--version")
    assert (code, printed.strip()) == (0, VERSION)


def test_help_names_the_commands_and_options() -> None:
    code, printed = run("--help")
    assert code == 0
    assert "serve" in printed
    assert "--version" in printed
    code, printed = run("serve", "--help")
    assert code == 0
    for word in ("--host", "--port", "--workers", "FRESNEL_HOST", "FRESNEL_WORKERS"):
        assert word in printed


@pytest.mark.parametrize("arguments", [("nope",), ("--nope",), ("serve", "--nope")])
def test_what_it_does_not_know(arguments: tuple[str, ...]) -> None:
    code, printed = run(*arguments)
    assert code == 2
    assert "nope" in printed


@pytest.mark.parametrize("port", ["99999", "-1", "http"])
def test_a_bad_port_is_told_without_a_trace(port: str) -> None:
    code, printed = run("serve", f"--port={port}")
    assert code == 2
    assert "--port" in printed
    code, printed = run("serve", FRESNEL_PORT=port)
    assert code == 2
    assert "FRESNEL_PORT" in printed
    assert port in printed
    assert "Traceback" not in printed


@pytest.mark.parametrize(
    ("variable", "value"),
    [
        ("FRESNEL_HOST", ""),
        ("FRESNEL_MAX_WAITING", "-1"),
        ("FRESNEL_STATIC_DIR", "/nowhere"),
        ("FRESNEL_STATIC_DIR", str(ROOT / "tests")),
    ],
)
def test_a_setting_that_cannot_work_is_refused_by_its_name(variable: str, value: str) -> None:
    code, printed = run("serve", **{variable: value})
    assert code == 2
    assert f"Error: {variable} = {value}: " in printed  # and no option
    assert "Traceback" not in printed


def test_all_settings_that_are_wrong_are_told() -> None:
    code, printed = run("serve", "--workers", "0", FRESNEL_PORT="-1", FRESNEL_THREADS="none")
    assert code == 2
    for named in (
        "--workers or FRESNEL_WORKERS = 0",
        "FRESNEL_PORT = -1",
        "FRESNEL_THREADS = none",
    ):
        assert f"Error: {named}: " in printed


def test_a_misspelt_setting_is_told() -> None:
    wrong = {"FRESNEL_WORKRES": "4", "FRESNEL_QQQ": "", "fresnel_host": "x"}
    code, printed = run("serve", FRESNEL_PORT="http", **wrong)
    assert code == 2  # for the port: else it would serve
    assert (
        "FRESNEL_WORKRES is no setting and has no effect: did you mean FRESNEL_WORKERS?" in printed
    )
    assert "FRESNEL_QQQ is no setting" in printed
    assert "fresnel_host" not in printed


def test_a_setting_that_does_not_exist_is_refused_in_python() -> None:
    with pytest.raises(ValidationError, match="max_sample"):
        Settings(max_sample=5)  # type: ignore[call-arg]


def test_prints_where_it_serves_and_serves_there() -> None:
    with serving("serve", "--port", "0") as (process, line):
        match = re.fullmatch(rf"Fresnel Explorer {re.escape(VERSION)} at (http://\S+)\n", line)
        assert match is not None
        assert match[1].startswith("http://127.0.0.1:")
        assert not match[1].endswith(":0")
        told = health(match[1])
        assert (told["status"], told["version"]) == ("ok", VERSION)
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=PATIENCE_S)
        assert (process.returncode, errors) == (0, "")


def test_it_serves_where_the_environment_says() -> None:
    with serving("serve", FRESNEL_HOST="localhost", FRESNEL_PORT="0") as (_, line):
        assert " at http://localhost:" in line
        assert health(line.split()[-1])["status"] == "ok"


def test_a_port_in_use_is_told_without_a_trace() -> None:
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = str(taken.getsockname()[1])
        ended = subprocess.run(
            [COMMAND, "serve", "--port", port],
            capture_output=True,
            text=True,
            timeout=PATIENCE_S,
            check=False,
        )
    assert ended.returncode == 1
    assert f"FRESNEL_PORT = {port}: " in ended.stderr
    assert "already in use" in ended.stderr.lower()
    assert "Traceback" not in ended.stderr
    assert ended.stdout == ""
