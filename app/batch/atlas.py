"""The atlas as a Parquet file: made part by part, kept as it is made, and put together at the end."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from datetime import UTC, datetime
from hashlib import sha256
from itertools import chain
from pathlib import Path
from time import process_time
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.parquet

from app import __version__
from app.atlas.errors import DIGITS, Errors, errors_of
from app.atlas.grid import GRID
from app.atlas.pages import page, page_ids, refused_pages
from app.atlas.published import METADATA
from app.batch.files import FileFault
from app.materials.media import default_catalog
from app.optics.metrics import ROUNDING
from app.optics.registry import default_registry

PART = 32
"""Materials of a part."""

_ROOMS = ("atlas", "materials", "optics")

_NAMES = pa.dictionary(pa.int32(), pa.string())
_WRITTEN = {"compression": "zstd", "compression_level": 19}

SCHEMA = pa.schema(
    [
        ("material", _NAMES),
        ("page", _NAMES),
        ("name", _NAMES),
        ("shelf", _NAMES),
        ("kind", _NAMES),
        ("band", _NAMES),
        ("wavelength_nm", pa.float64()),
        ("n", pa.float64()),
        ("k", pa.float64()),
        ("middle", pa.bool_()),
        ("model", _NAMES),
        ("in_domain", pa.bool_()),
        ("max_abs", pa.float32()),
        ("max_abs_at_deg", pa.float32()),
        ("rms", pa.float32()),
        ("albedo_error", pa.float32()),
        ("delta_e", pa.float32()),
    ]
)


@dataclass(frozen=True)
class Part:
    """Errors at some materials, and what they cost."""

    table: pa.Table
    left_out: tuple[str, ...]
    """Materials that n and k are nowhere known of together, within the core's bounds."""
    seconds: float
    """Of a processor."""


def part_of(materials: Sequence[str]) -> Part:
    """Measure every model at some materials; a task of a cluster's worker."""
    started = process_time()
    found = {name: page(name) for name in materials}
    pages = [one for one in found.values() if one is not None]
    rows = chain.from_iterable(map(_rows, errors_of(pages, default_registry()))) if pages else ()
    table = pa.Table.from_batches(list(rows), SCHEMA)
    left_out = tuple(name for name, one in found.items() if one is None)
    return Part(table.unify_dictionaries(), left_out, process_time() - started)


def _rows(errors: Errors) -> Iterator[pa.RecordBatch]:
    page, at = errors.page, errors.at
    preset, count = page.preset, errors.at.size
    names = {
        "material": preset.id,
        "page": page.of_database,
        "name": preset.name,
        "shelf": page.shelf,
        "kind": page.kind,
        "band": page.band,
        "model": errors.model,
    }
    numbers = {
        "wavelength_nm": page.wavelength_nm[at],
        "n": page.n[at],
        "k": page.k[at],
        "middle": at == page.middle,
        "in_domain": errors.in_domain > 0.0,
        "max_abs": errors.max_abs,
        "max_abs_at_deg": errors.max_abs_at_deg,
        "rms": errors.rms,
        "albedo_error": errors.albedo_error,
        "delta_e": np.full(count, errors.delta_e),
    }
    columns = []
    for field in SCHEMA:
        if field.name in names:
            code = pa.array(np.zeros(count, np.int32))
            columns.append(pa.DictionaryArray.from_arrays(code, [names[field.name]]))
        else:
            columns.append(pa.array(numbers[field.name], field.type))
    yield pa.record_batch(columns, schema=SCHEMA)


class OtherParts(Exception):
    """Parts that are kept of an atlas of other materials, models or another release."""


class Parts:
    """Parts of an atlas kept in a directory, so that a run that ended goes on with the next.

    Parameters
    ----------
    output
        The atlas that they become; the directory is beside it.
    materials
        Ids in order.
    afresh
        Whether to leave what is kept already.

    Raises
    ------
    OtherParts
        If what is kept is of something else.
    FileFault
        If it cannot be read or made.
    """

    def __init__(self, output: Path, materials: Sequence[str], *, afresh: bool = False) -> None:
        self.output = output
        self.directory = output.with_name(f"{output.name}.parts")
        self.parts = [materials[i : i + PART] for i in range(0, len(materials), PART)]
        self._about = self.directory / "made.json"
        self._made = making(materials)
        try:
            if afresh:
                self.remove()
            self.directory.mkdir(parents=True, exist_ok=True)
            if not self._about.exists():
                self._about.write_text(json.dumps(self._made), encoding="utf-8")
            kept = json.loads(self._about.read_text(encoding="utf-8"))
        except (OSError, ValueError) as error:
            raise FileFault(self.directory, error) from None
        if kept != self._made:
            raise OtherParts(str(self.directory))

    def _path(self, number: int) -> Path:
        return self.directory / f"{number:05d}.parquet"

    @property
    def missing(self) -> list[int]:
        """Numbers of the parts that are to be made."""
        return [number for number in range(len(self.parts)) if not self._path(number).exists()]

    def keep(self, number: int, part: Part) -> None:
        """Write a part, which is there as a whole or not at all."""
        path = self._path(number)
        told = {"left_out": part.left_out, "seconds": part.seconds}
        table = part.table.replace_schema_metadata({METADATA: json.dumps(told)})
        _write(table, path)

    def joined(self) -> dict[str, Any]:
        """Write the atlas of all parts, in order, and remove them.

        Returns
        -------
        dict
            What it says of itself.
        """
        try:
            tables = [pa.parquet.read_table(self._path(n)) for n in range(len(self.parts))]
        except (OSError, pa.ArrowException) as error:
            raise FileFault(self.directory, error) from None
        told = [json.loads(table.schema.metadata[METADATA.encode()]) for table in tables]
        table = pa.concat_tables([t.replace_schema_metadata() for t in tables])
        table = table.unify_dictionaries().combine_chunks()
        about = {
            **self._made,
            "date": datetime.now(UTC).date().isoformat(),
            "left_out": [name for one in told for name in one["left_out"]],
            "seconds": round(sum(one["seconds"] for one in told), 1),
            "rows": table.num_rows,
        }
        _write(table.replace_schema_metadata({METADATA: json.dumps(about)}), self.output)
        self.remove()
        return about

    def remove(self) -> None:
        """Remove the directory with all parts."""
        for path in self.directory.glob("*.parquet*"):
            path.unlink(missing_ok=True)
        self._about.unlink(missing_ok=True)
        with suppress(FileNotFoundError):
            self.directory.rmdir()


def making(materials: Sequence[str]) -> dict[str, Any]:
    """What an atlas is made of and how: parts of other makings do not go together."""
    database = default_catalog().database
    return {
        "program": f"fresnel-explorer {__version__}",
        "code": _code(),
        "database": f"{database.name} {database.tag}",
        "package": database.package,
        "materials": len(materials),
        "refused": list(refused_pages()),
        "of_materials": sha256("\n".join(materials).encode()).hexdigest(),
        "models": list(default_registry()),
        "part": PART,
        "wavelengths": GRID,
        "incident": "vacuum",
        "how": "fresnel-explorer atlas: app.optics.metrics.measure in full precision for max_abs, "
        "max_abs_at_deg, rms and albedo_error; app.materials.rgb_index.distance for delta_e",
        "digits": f"{DIGITS} significant; 0 below {ROUNDING:g}; NaN: undefined, not known, no RGB form",
    }


def _code() -> str:
    """What the numbers depend on, so that it can be told whether it has changed since."""
    root = Path(__file__).resolve().parents[1]
    files = [file for room in _ROOMS for file in (root / room).rglob("*.py")]
    digest = sha256(b"".join(file.read_bytes() for file in sorted(files)))
    return f"sha256 {digest.hexdigest()} of all .py in {', '.join(f'app/{r}' for r in _ROOMS)}"


def materials_beginning_with(prefixes: Sequence[str]) -> tuple[str, ...]:
    """Ids of the materials that begin with any of these; all without one."""
    return tuple(name for name in page_ids() if not prefixes or name.startswith(tuple(prefixes)))


def _write(table: pa.Table, path: Path) -> None:
    part = path.with_name(f"{path.name}.part")
    # Errors hardly repeat: their bytes apart from one another are what compresses.
    split = [field.name for field in table.schema if field.type == pa.float32()]
    split.remove("delta_e")
    encoded = [field.name for field in table.schema if field.name not in split]
    try:
        pa.parquet.write_table(
            table, part, use_dictionary=encoded, use_byte_stream_split=split, **_WRITTEN
        )
        part.replace(path)
    except (OSError, pa.ArrowException) as error:
        raise FileFault(path, error) from None
    finally:
        part.unlink(missing_ok=True)
