"""The page's modules in a few files, where `tools/pack.mjs` has made them."""

from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path
from typing import Literal

import msgspec

from app.page.document import MAIN, STYLES, VIEW

FOLDER = "packed"
"""Below the page's files; its names carry digests, so that browsers may keep them for ever."""

MANIFEST = f"{FOLDER}/manifest.json"


@dataclass(frozen=True)
class Packed:
    """What the packed page starts with, and of which sources it was made."""

    sources: str
    main: str
    first: list[str]
    """What the first view imports."""
    style: str

    @property
    def replaced(self) -> dict[str, str]:
        """Addresses in the page's document, and what stands there instead; the last style is all."""
        files = {MAIN: self.main, VIEW: self.first[0], STYLES[-1]: self.style}
        return {source: f"{FOLDER}/{name}" for source, name in files.items()}


def page_form(wanted: Literal["auto", "packed", "sources"], static_dir: Path) -> Packed | None:
    """Return the packed page if it is wanted and there.

    Raises
    ------
    ValueError
        If it is wanted without fail, and missing or older than its sources.
    """
    if wanted == "sources":
        return None
    found = packed(static_dir)
    if found is None and wanted == "packed":
        raise ValueError(f"{static_dir / MANIFEST} is missing or older than its sources: make pack")
    return found


def packed(static_dir: Path) -> Packed | None:
    """Return what was packed of the sources as they are; None where that was not done."""
    try:
        found = msgspec.json.decode((static_dir / MANIFEST).read_bytes(), type=Packed)
    except (FileNotFoundError, NotADirectoryError):
        return None
    except msgspec.DecodeError:
        return None
    return found if found.sources == digest(static_dir) else None


def digest(static_dir: Path) -> str:
    """Digest of the sources, as `tools/pack.mjs` computes it."""
    scripts = [path.relative_to(static_dir).as_posix() for path in static_dir.glob("js/**/*.js")]
    made = sha256()
    for name in sorted([*scripts, *STYLES]):
        made.update(name.encode())
        made.update((static_dir / name).read_bytes())
    return made.hexdigest()
