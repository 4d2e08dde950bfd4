"""The service worker's script: every file of the page, and a version made of their contents."""

import json
import re
from pathlib import Path

from app.page.service_worker import SCRIPT, service_worker

STATIC = Path(__file__).parents[2] / "static"


def constant(script: bytes, name: str) -> object:
    found = re.search(rf"^const {name} = (.*);$", script.decode(), re.MULTILINE)
    assert found
    return json.loads(found[1])


def page(folder: Path) -> Path:
    (folder / "js").mkdir()
    for name in ("index.html", "js/a.js", "js/types.d.ts", SCRIPT):
        (folder / name).write_text(name)
    return folder


def test_the_version_is_that_of_the_contents(tmp_path: Path) -> None:
    folder = page(tmp_path)
    before = service_worker(folder)
    assert service_worker(folder) == before
    assert constant(before, "FILES") == ["index.html", "js/a.js"]
    (folder / "js" / "a.js").write_text("other")
    after = service_worker(folder)
    assert constant(after, "VERSION") != constant(before, "VERSION")
    (folder / "js" / "b.js").write_text("")
    assert constant(service_worker(folder), "FILES") == ["index.html", "js/a.js", "js/b.js"]
    made = service_worker(folder, {"kernels.js": b"1"})
    assert constant(made, "FILES") == ["index.html", "js/a.js", "js/b.js", "kernels.js"]
    other = service_worker(folder, {"kernels.js": b"2"})
    assert constant(made, "VERSION") != constant(other, "VERSION")


def test_it_keeps_what_every_view_needs_and_nothing_that_is_not_there() -> None:
    files = constant(service_worker(STATIC), "FILES")
    assert isinstance(files, list)
    assert all((STATIC / name).is_file() for name in files)
    views = {path.relative_to(STATIC).as_posix() for path in STATIC.glob("js/views/*.js")}
    assert views <= set(files)
    assert not [name for name in files if "swagger" in name or name.startswith("docs/")]
