"""What make's targets promise beyond running a tool."""

import subprocess
from pathlib import Path

ROOT = Path(__file__).parents[2]
PIP_AUDIT = """#!/bin/sh
# As pip-audit does where it finds no package to look up: it warns, and fails if it is to be strict.
case " $* " in *" --strict "*) exit 1 ;; esac
"""


def test_an_audit_that_could_look_up_nothing_is_red(tmp_path: Path) -> None:
    tools = tmp_path / "bin"
    tools.mkdir()
    for name, script in (("python", "#!/bin/sh\n"), ("pip-audit", PIP_AUDIT)):
        (tools / name).write_text(script, "utf-8")
        (tools / name).chmod(0o755)
    made = subprocess.run(
        ["make", "audit", f"VENV={tmp_path}", "INSTALL=true"],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )
    assert made.returncode != 0
    assert "pip-audit" in made.stdout
