"""Engines that are Python packages: each in an environment of its own, where a script of ours runs."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from pathlib import Path
from tempfile import TemporaryDirectory

from tools.engines.questions import Settings, asked
from tools.engines.results import Told

SCRIPTS = Path(__file__).parent / "scripts"


def told(
    package: str, version: str, script: str, python: str, settings: Settings = ()
) -> list[Told]:
    """Install a package, run its script with the questions on standard input, and read its answers.

    Parameters
    ----------
    package, version
        As the package index knows them.
    script
        In `scripts`; the last line that it prints is its answer.
    python
        The Python that the package is built for, as `3.13`: found on the PATH as `python3.13`, or
        named by the variable PYTHON_3_13.
    settings
        What is typed besides the media.
    """
    name = os.environ.get(f"PYTHON_{python.replace('.', '_')}") or shutil.which(f"python{python}")
    if name is None:
        raise SystemExit(f"{package} {version} is built for Python {python}, which is not here")
    with TemporaryDirectory() as folder:
        subprocess.run([name, "-m", "venv", folder], check=True)
        inner = str(Path(folder) / "bin" / "python")
        install = [inner, "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
        subprocess.run([*install, f"{package}=={version}"], check=True)
        # -P: the folder of the script is not searched, where its neighbors would hide modules.
        run = [inner, "-P", str(SCRIPTS / script)]
        done = subprocess.run(
            run, input=json.dumps(asked(settings)), capture_output=True, text=True
        )
        if done.returncode:
            raise SystemExit(done.stderr)
        answers: list[Told] = json.loads(done.stdout.splitlines()[-1])
        return answers
