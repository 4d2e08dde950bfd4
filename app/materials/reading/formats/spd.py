"""Spectra of Mitsuba and pbrt (.spd): eta and k in two files, wavelengths in nanometers."""

import re
from collections.abc import Sequence

import numpy as np

from app.materials.reading.formats import (
    Content,
    Document,
    Format,
    Notes,
    Table,
    Undecided,
    Unreadable,
    blocks_of,
    decided_unit,
    layout_of,
)

_ROLE = re.compile(r"(?:^|[._\- ])(eta|n|ior|k)$", re.IGNORECASE)


def _sniff(document: Document) -> str | None:
    return (
        "it ends in .spd, as spectra of Mitsuba and pbrt do" if document.suffix == ".spd" else None
    )


def _role(document: Document, notes: Notes) -> str:
    """Whether a file holds n or k, by its name."""
    if notes.choices.columns is not None and len(notes.choices.columns) == 2:
        return notes.choices.columns[1]
    found = _ROLE.search(document.name.rpartition(".")[0])
    if found is not None:
        return "k" if found[1].lower() == "k" else "n"
    raise Undecided(
        "columns",
        f"whether {document.name} is eta or k, which its name does not say; name the files "
        "NAME.eta.spd and NAME.k.spd, or say columns=wavelength,n",
    )


def _read(documents: Sequence[Document], notes: Notes) -> Content:
    tables = []
    for document in documents:
        role = _role(document, notes)
        layout = layout_of(document.lines, notes)
        blocks = blocks_of(document.lines, layout, notes, document.name) if layout else []
        if len(blocks) != 1 or len(blocks[0].rows[0]) != 2:
            raise Unreadable("file", document.name, "rows of a wavelength and a value")
        numbers = np.array(blocks[0].rows)
        unit = decided_unit(
            numbers[:, 0],
            notes,
            named="nm",
            why=".spd has nanometers, whatever a comment that was copied along says",
            is_certain=True,
        )
        tables.append(
            Table(numbers[:, 0], unit, {role: numbers[:, 1]}, np.array(blocks[0].numbers))
        )
    roles = [name for table in tables for name in table.columns]
    if sorted(roles) not in (["n"], ["k", "n"]):
        what = f"the file of eta, and that of k beside it where there is one; these are {roles}"
        raise Unreadable("file", ", ".join(d.name for d in documents), what)
    if roles == ["n"]:
        notes.warn("k is not known: give its .spd along with that of eta")
    return Content(tables=tables, columns=("wavelength", *sorted(roles, reverse=True)))


FORMAT = Format(
    id="spd",
    title="eta and k of Mitsuba and pbrt",
    sniff=_sniff,
    read=_read,
)
