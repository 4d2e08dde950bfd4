"""`materials/refractiveindex/reference_media.json`, from the history of the database.

    python -m tools.build_materials.reference_media REPOSITORY

REPOSITORY is a clone of refractiveindex.info-database. Until November 2024 its pages said of
themselves whether n is absolute and whether wavelengths are those in vacuum; later releases do not.
A page of today is taken for one of then where all numbers of n and k are the same.
"""

import json
import re
import subprocess
import sys
from pathlib import Path

from app.materials.published.files import page_bytes
from tools.build_materials.published import MEDIA, listings

COMMIT = "733e360717b8a0024c7be5e3ffa243178e762084"
"""The last that says it."""

_MEDIA = {"true": "vacuum", "false": "air"}
_FACTS = ("n_is_absolute", "wavelength_is_vacuum")

Media = tuple[str | None, str | None]


def _git(repository: Path, *arguments: str) -> bytes:
    return subprocess.run(
        ["git", "-C", repository, *arguments], capture_output=True, check=True
    ).stdout


def numbers(page: str) -> tuple[str, ...]:
    """Everything between DATA and the next key, without its layout."""
    data = re.split(r"^(?=[A-Z_]+:)", page.partition("\nDATA:")[2], maxsplit=1, flags=re.MULTILINE)
    return tuple(data[0].replace("wavelength_range", "range").split())


def media_of(page: str) -> Media:
    """What a page says of n and of its wavelengths."""
    said = [re.search(rf"^\s+{fact}: *(\w+)", page, re.MULTILINE) for fact in _FACTS]
    n, wavelength = (_MEDIA[found[1]] if found else None for found in said)
    return n, wavelength


def main() -> int:
    """Write the file."""
    repository = Path(sys.argv[1])
    then: dict[tuple[str, ...], Media] = {}
    for name in _git(repository, "ls-tree", "-rz", "--name-only", COMMIT, "database/data-nk").split(
        b"\0"
    ):
        if name.endswith(b".yml"):
            try:
                page = _git(repository, "show", f"{COMMIT}:{name.decode()}").decode()
            except subprocess.CalledProcessError:
                print(f"{name.decode()} is not in this clone", file=sys.stderr)
                continue
            then.setdefault(numbers(page), media_of(page))
    groups: dict[Media, list[str]] = {}
    for listing in listings():
        media = then.get(numbers(page_bytes(listing.file).decode()), (None, None))
        if any(media):
            groups.setdefault(media, []).append(listing.file)
    listed = [
        {"relative_to": n, "wavelength_in": wavelength, "files": sorted(files)}
        for (n, wavelength), files in sorted(groups.items(), key=lambda item: -len(item[1]))
    ]
    text = json.dumps({"commit": COMMIT, "groups": listed}, indent=1, ensure_ascii=False)
    (Path(__file__).parents[2] / "materials" / MEDIA).write_text(text + "\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
