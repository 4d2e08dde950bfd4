"""Runs lines of `commands.txt`, each in an empty folder but for a file of rows."""

from __future__ import annotations

import os
import shlex
import subprocess
from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory

from tools.recorded_requests.question import Answer, Question, text_or_digest

ROWS = "name,n_t,k_t,material,theta_i_deg,model\n" + "\n".join(
    [
        "a,1.5,,,0,",
        "b,0.27,2.9,,80,schlick",
        "c,,,Au,45,exact",
        "d,1.5,,,91,",
        "e,,,gld,0,",
        "f,x,,,0,",
    ]
)


def command_lines() -> Iterator[Question]:
    """Read the file."""
    for line in (Path(__file__).parent / "commands.txt").read_text("utf-8").splitlines():
        if line and line[0] != "#":
            yield Question("$", line)


def run(program: Path, question: Question) -> Answer:
    """Run one: the exit code, what it prints, and the files it leaves."""
    # Rich measures the terminal; colors and the width are not what is compared.
    environment = os.environ | {
        "COLUMNS": "100",
        "NO_COLOR": "1",
        "TERM": "dumb",
        "LC_ALL": "C.UTF-8",
    }
    environment = {k: v for k, v in environment.items() if not k.startswith("FRESNEL_")}
    with TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "rows.csv").write_text(ROWS, "utf-8")
        words = [str(program), *shlex.split(question.target)]
        done = subprocess.run(words, cwd=folder, env=environment, capture_output=True, check=False)
        files = {p.name: text_or_digest(p.read_bytes()) for p in sorted(folder.iterdir())}
        del files["rows.csv"]
    said = {"standard error": text_or_digest(done.stderr).replace(name, "FOLDER")}
    return Answer(
        done.returncode, said | files, text_or_digest(done.stdout).replace(name, "FOLDER")
    )
