"""`fresnel-explorer atlas`: parts that are kept, a cluster, and what is told."""

import json
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import distributed
import pyarrow.parquet
import pytest
from typer.testing import CliRunner

from app.atlas.published import METADATA, read_atlas
from app.batch import atlas
from app.cli.main import cli

PAGES = ("--pages", "B", "--pages", "Au")


def run(*arguments: object) -> tuple[int, str]:
    result = CliRunner().invoke(cli, ["atlas", *map(str, arguments)], env={"COLUMNS": "200"})
    return result.exit_code, re.sub(r"[│╭╮╰╯─━╸╺]+|\s+", " ", result.output)


@pytest.fixture(scope="module")
def scheduler() -> Iterator[str]:
    """A cluster of threads here, which see what a test changes."""
    with distributed.LocalCluster(
        n_workers=1, threads_per_worker=1, processes=False, dashboard_address="127.0.0.1:0"
    ) as cluster:
        yield cluster.scheduler_address


@pytest.fixture
def small(monkeypatch: pytest.MonkeyPatch) -> int:
    monkeypatch.setattr(atlas, "PART", 3)
    return len(atlas.materials_beginning_with(("B", "Au")))


def test_an_atlas_of_some_materials(tmp_path: Path, scheduler: str) -> None:
    output = tmp_path / "some.parquet"
    code, printed = run("--output", output, "--scheduler", scheduler, *PAGES)
    assert code == 0, printed
    assert "materials," in printed
    found = read_atlas(output)
    assert {m.id for m in found.materials} == set(atlas.materials_beginning_with(("B", "Au")))
    assert list(tmp_path.iterdir()) == [output]


def test_a_run_that_ended_goes_on(
    tmp_path: Path, scheduler: str, small: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    whole, broken = tmp_path / "whole.parquet", tmp_path / "broken.parquet"
    assert run("--output", whole, "--scheduler", scheduler, *PAGES)[0] == 0
    kept: list[int] = []
    original = atlas.Parts.keep

    def failing(self: atlas.Parts, number: int, part: atlas.Part) -> None:
        if len(kept) == 1:
            kept.clear()
            raise KeyboardInterrupt
        kept.append(number)
        original(self, number, part)

    monkeypatch.setattr(atlas.Parts, "keep", failing)
    assert run("--output", broken, "--scheduler", scheduler, *PAGES)[0] != 0
    assert not broken.exists()

    def counting(self: atlas.Parts, number: int, part: atlas.Part) -> None:
        kept.append(number)
        original(self, number, part)

    monkeypatch.setattr(atlas.Parts, "keep", counting)
    code, printed = run("--output", broken, "--scheduler", scheduler, *PAGES)
    assert code == 0
    parts = -(-small // 3)
    assert f"1 of {parts} parts are there already" in printed
    assert kept == list(range(1, parts))
    # As text, in which NaN is NaN.
    rows = [repr(pyarrow.parquet.read_table(path).to_pylist()) for path in (broken, whole)]
    assert rows[0] == rows[1]
    assert sorted(tmp_path.iterdir()) == [broken, whole]


def test_parts_of_another_atlas_are_not_taken(tmp_path: Path, scheduler: str) -> None:
    output = tmp_path / "atlas.parquet"
    atlas.Parts(output, ("Ag", "Al"))
    code, printed = run("--output", output, "--scheduler", scheduler, *PAGES)
    assert code == 1
    assert "--fresh begins again" in printed
    assert run("--output", output, "--scheduler", scheduler, "--fresh", *PAGES)[0] == 0


def test_what_is_there_is_not_overwritten_unasked(tmp_path: Path) -> None:
    output = tmp_path / "atlas.parquet"
    output.write_text("mine")
    code, printed = run("--output", output, *PAGES)
    assert code == 2
    assert "--force overwrites it" in printed
    assert output.read_text() == "mine"


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (("--output", "atlas.csv"), "not .parquet"),
        (("--pages", "nothing-begins-so"), "no material's id begins with"),
        (("--workers", "0"), "workers"),
    ],
)
def test_what_is_wrong_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, arguments: tuple[str, ...], told: str
) -> None:
    monkeypatch.chdir(tmp_path)
    code, printed = run(*arguments)
    assert code == 2
    assert told in printed
    assert list(tmp_path.iterdir()) == []


def test_a_scheduler_that_is_not_there(tmp_path: Path) -> None:
    output = tmp_path / "atlas.parquet"
    code, printed = run("--output", output, "--scheduler", "tcp://127.0.0.1:9", *PAGES)
    assert code == 1
    assert "127.0.0.1:9" in printed


def test_on_a_cluster_of_its_own(tmp_path: Path) -> None:
    """Processes that start anew, as the command makes them."""
    output = tmp_path / "atlas.parquet"
    program = Path(sys.executable).with_name("fresnel-explorer")
    command = [str(program), "atlas", "--workers", "1", "--pages", "Au"]
    ended = subprocess.run(
        [*command, "--output", str(output)], capture_output=True, text=True, check=False
    )
    assert ended.returncode == 0, ended.stderr
    assert "100 %" in ended.stderr
    about = json.loads(pyarrow.parquet.read_schema(output).metadata[METADATA.encode()])
    assert about["seconds"] > 0.0
