"""`fresnel-explorer material FILE`: a file of n and k in a preset's place, and how it was read."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np
from pydantic import ValidationError

from app.answers.answer import Table
from app.answers.materials.reading import ReadMaterial, read_material
from app.api.materials.reading import ReadQuery
from app.cli.tables import Sheet, cell
from app.http.problems import BadParameters
from app.http.route import explain
from app.materials.media import default_catalog
from app.materials.reading.document import MOST_BYTES

FORMAT = "file_format"
"""What the parameter `format` is called here, where `--format` says as what to print."""

FIELDS = {
    FORMAT if name == "format" else name: info
    for name, info in ReadQuery.model_fields.items()
    if name != "digits"
}
"""What may be set by hand, by the names of the options."""

_FACTS = (
    "format",
    "unit",
    "columns",
    "sign",
    "order",
    "relative_to",
    "n_range_nm",
    "k_range_nm",
    "merged",
    "points_given",
    "points_kept",
    "largest_difference_n",
    "largest_difference_k",
)
_SHOWN = 40
"""Points that a table shows; CSV and JSON have all."""


def is_file(name: str) -> bool:
    """Whether a name is that of a file, and not of a preset; ./Au is a file in any case."""
    return Path(name).is_file() and default_catalog().find(name) is None


def read(name: str, given: Mapping[str, str]) -> ReadMaterial:
    """Read a file, and where it is the eta of an .spd, its k beside it.

    Raises
    ------
    BadParameters, OpticsError
        As the route `/materials/read` does.
    """
    named = {"format" if key == FORMAT else key: value for key, value in given.items()}
    try:
        query = ReadQuery.model_validate(named)
    except ValidationError as error:
        raise BadParameters(*explain(error, ReadQuery.model_fields)) from None
    path = Path(name)
    paths = [path]
    if path.name.endswith(".eta.spd"):
        beside = path.with_name(path.name.removesuffix(".eta.spd") + ".k.spd")
        paths += [beside] if beside.is_file() else []
    return read_material([(one.name, _content(one)) for one in paths], query.choices())


def _content(path: Path) -> bytes:
    with path.open("rb") as file:
        return file.read(MOST_BYTES + 1)  # what is more is refused, however much it is


def sheets(answer: ReadMaterial) -> list[Sheet]:
    """The report, what was assumed and left out, and the numbers."""
    report = answer.report
    facts = [(name, cell(getattr(report, name))) for name in _FACTS]
    made = [
        Sheet(("name", "value"), [("name", answer.name), *facts], "read"),
        Sheet(
            ("option", "value", "why", "or"),
            [
                (
                    f"--{FORMAT if one.what == 'format' else one.what}",
                    one.value,
                    one.why,
                    ", ".join(one.alternatives),
                )
                for one in report.assumed
            ],
            "assumed",
        ),
        Sheet(("line", "why"), [(row.line, row.why) for row in report.left_out], "left out"),
        Sheet(("warning",), [(sentence,) for sentence in report.warnings], "to know"),
        _numbers(answer),
        Sheet(("id",), [(answer.material,)], "takes its place everywhere"),
    ]
    return [sheet for sheet in made if sheet.rows]


def table(answer: ReadMaterial) -> Table:
    """All points."""
    spectrum = answer.spectrum
    k = np.full(spectrum.n.shape, np.nan) if spectrum.k is None else spectrum.k
    return Table({"wavelength_nm": spectrum.wavelength_nm, "n": spectrum.n, "k": k})


def _numbers(answer: ReadMaterial) -> Sheet:
    columns = table(answer).columns
    count = len(columns["wavelength_nm"])
    at = np.unique(np.linspace(0, count - 1, min(count, _SHOWN)).astype(int))
    title = "n and k" if at.size == count else f"n and k at {at.size} of {count} points"
    rows = np.array([np.asarray(column)[at] for column in columns.values()]).T.tolist()
    return Sheet(list(columns), rows, title)
