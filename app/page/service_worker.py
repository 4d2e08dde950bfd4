"""The page's service worker: its script with the files to keep and a version made of them."""

import json
from collections.abc import Mapping
from functools import lru_cache
from hashlib import sha256
from pathlib import Path

from app import __version__
from app.page.document import STYLES
from app.page.packed import FOLDER

SCRIPT = "sw.js"

# Of the page itself; the API's documentation and what only tools read can wait for the server.
_KEPT = {".css", ".html", ".js", ".svg", ".webmanifest", ".woff2"}
_NOT_KEPT = ("docs/", "vendor/swagger", SCRIPT)
_AS_IT_IS = ("js/page/theme.js", "js/server/fetcher.js")
"""Scripts that the packed page takes from its sources: no modules of it."""


def service_worker(
    static_dir: Path, made: Mapping[str, bytes] | None = None, packed: bool = False
) -> bytes:
    """Return the script of the service worker, which changes when any file of the page does.

    Parameters
    ----------
    static_dir
        The folder of the page's files.
    made
        What the server adds to them, by name.
    packed
        Whether the document names packed files in place of their sources.
    """
    left_out = _NOT_KEPT + (("js/", *STYLES) if packed else (f"{FOLDER}/",))

    def is_kept(name: str) -> bool:
        return not name.startswith(left_out) or (packed and name in _AS_IT_IS)

    files = sorted(
        path
        for path in static_dir.rglob("*")
        if path.suffix in _KEPT and is_kept(path.relative_to(static_dir).as_posix())
    )
    stamped = tuple((path, path.stat().st_mtime_ns) for path in files)
    return _script(static_dir, stamped, tuple((made or {}).items()))


@lru_cache(maxsize=1)
def _script(
    static_dir: Path, files: tuple[tuple[Path, int], ...], made: tuple[tuple[str, bytes], ...]
) -> bytes:
    digest = sha256(__version__.encode())
    addresses = []
    for path, _ in files:
        address = path.relative_to(static_dir).as_posix()
        digest.update(address.encode())
        digest.update(sha256(path.read_bytes()).digest())
        addresses.append(address)
    for name, content in made:
        addresses.append(name)
        digest.update(sha256(content).digest())
    source = (static_dir / SCRIPT).read_bytes()
    digest.update(source)
    head = (
        f"const VERSION = {json.dumps(digest.hexdigest()[:16])};\n"
        f"const FILES = {json.dumps(addresses)};\n"
    )
    return head.encode() + source
