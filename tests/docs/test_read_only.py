"""The server needs to write nothing: it runs in a container whose file system is read-only."""

import os
import subprocess
import sys
from pathlib import Path

PROGRAM = r"""
import os, re, sys, tempfile

def refuse(event, arguments):
    if event == "open":
        path, _, flags = arguments
        writes = flags & (os.O_WRONLY | os.O_RDWR | os.O_CREAT | os.O_TRUNC | os.O_APPEND)
        if writes and path != os.devnull:
            raise PermissionError(f"wrote {path}")
    elif event in ("os.mkdir", "os.rename", "os.remove", "os.rmdir", "os.link", "os.symlink",
                   "os.truncate", "os.chmod", "os.utime", "tempfile.mkstemp", "tempfile.mkdtemp"):
        raise PermissionError(f"{event} {arguments}")

sys.addaudithook(refuse)
try:
    open("/tmp/written", "w")
except PermissionError:
    print("the hook works")

from app.main import create_app
from tests.api.raw import send

app = create_app()
for path, operations in app.openapi()["paths"].items():
    if "get" in operations:
        names = {"material": "Au", "fit_id": "schlick_F0", "formula_id": "schlick"}
        target = re.sub(r"\{(\w+)\}", lambda part: names.get(part[1], "schlick"), path)
        status = send(app, target.encode()).status
        assert status < 500, (path, status)
for path in ("/", "/docs/", "/js/main.js", "/openapi.json"):
    assert send(app, path.encode(), headers={"accept-encoding": "br, gzip"}).status == 200
print("answered")
"""


def test_nothing_is_written_at_run_time() -> None:
    root = Path(__file__).parents[2]
    ran = subprocess.run(
        [sys.executable, "-B", "-c", PROGRAM],
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
        cwd=root,
        env=os.environ | {"PYTHONPATH": str(root), "PYTHONDONTWRITEBYTECODE": "1"},
    )
    assert ran.returncode == 0, ran.stderr
    assert ran.stdout.split("\n")[:2] == ["the hook works", "answered"]
