"""The .MAT of the SOPRA tables: DATA1*i*lambda*n*k* in nanometers."""

from collections.abc import Sequence

import numpy as np

from app.materials.reading.formats import (
    Content,
    Document,
    Format,
    Notes,
    Table,
    Unreadable,
    decided_unit,
)


def _sniff(document: Document) -> str | None:
    if any(line.lstrip().startswith("DATA1*") for line in document.lines):
        return "its lines are DATA1*i*lambda*n*k*"
    return None


def _read(documents: Sequence[Document], notes: Notes) -> Content:
    document = documents[0]
    rows, lines, announced = [], [], None
    for number, line in enumerate(document.lines, start=1):
        cells = line.strip().split("*")
        if cells[0] == "POINTS" and len(cells) > 1 and cells[1].strip().isdecimal():
            announced = int(cells[1][:12])
        if cells[0] != "DATA1":
            continue
        try:
            x, n, k = (float(cell) for cell in cells[2:5])
        except ValueError:
            notes.leave_out(number, f"no DATA1*i*lambda*n*k*: {line.strip()[:60]}")
            continue
        rows.append((x, n, k))
        lines.append(number)
    if not rows:
        raise Unreadable("file", document.name, "lines DATA1*i*lambda*n*k*")
    if announced is not None and announced != len(rows):
        notes.warn(f"POINTS announces {announced} rows; there are {len(rows)}")
    numbers = np.array(rows)
    unit = decided_unit(
        numbers[:, 0], notes, named="nm", why="the .MAT of SOPRA has nanometers", is_certain=True
    )
    columns = {"n": numbers[:, 1], "k": numbers[:, 2]}
    return Content(tables=[Table(numbers[:, 0], unit, columns, np.array(lines))])


FORMAT = Format(
    id="sopra_mat",
    title="the .MAT of the SOPRA tables",
    sniff=_sniff,
    read=_read,
)
