"""One file a format; each exposes `FORMAT`, and `app.materials.reading.registry` finds them.

What the file of a format needs is imported from here.
"""

from app.materials.reading.columns import by_hand, by_number, columns_named, unit_in
from app.materials.reading.constants import Table, decided_unit
from app.materials.reading.document import Document
from app.materials.reading.format import Content, Format
from app.materials.reading.report import Notes, Undecided, Unreadable
from app.materials.reading.rows import Block, Layout, blocks_of, layout_of

__all__ = [
    "Block",
    "Content",
    "Document",
    "Format",
    "Layout",
    "Notes",
    "Table",
    "Undecided",
    "Unreadable",
    "blocks_of",
    "by_hand",
    "by_number",
    "columns_named",
    "decided_unit",
    "layout_of",
    "unit_in",
]
