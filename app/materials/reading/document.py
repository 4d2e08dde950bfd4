"""A file as text: which encoding it has, and how much of it is read."""

import codecs
from dataclasses import dataclass
from functools import cached_property

from app.materials.reading.report import Unreadable

MOST_BYTES = 2_000_000
"""Size of the largest file."""

MOST_ROWS = 200_000
"""Rows of the longest table."""

_MARKS = (
    (codecs.BOM_UTF8, "utf-8"),
    (codecs.BOM_UTF16_LE, "utf-16-le"),
    (codecs.BOM_UTF16_BE, "utf-16-be"),
)
_END_OF_FILE = "\x1a"
"""What DOS wrote at the end of text."""
_CONTROLS = dict.fromkeys([*range(9), 11, 12, *range(14, 32), 127])


@dataclass(frozen=True)
class Document:
    """A file that has been decoded."""

    name: str
    """Of the file, without its folder."""
    text: str
    encoding: str

    @cached_property
    def lines(self) -> list[str]:
        """The lines, of which the first is number 1 in reports."""
        return self.text.split("\n")

    @property
    def suffix(self) -> str:
        """What the name ends in, in lower case, with its dot."""
        return ("." + self.name.rpartition(".")[2].lower()) if "." in self.name else ""


def document(name: str, content: bytes) -> Document:
    """Decode a file: by its byte-order mark, as UTF-16 or UTF-8 where it is, else as Latin-1.

    Raises
    ------
    Unreadable
        If it is too large or no text.
    """
    name = name.replace("\\", "/").rpartition("/")[2][:200]
    if len(content) > MOST_BYTES:
        what = f"a file of at most {MOST_BYTES:,} bytes; this one has {len(content):,}"
        raise Unreadable("file", name, what)
    text, encoding = _decoded(content)
    text = text.replace("\r\n", "\n").replace("\r", "\n").replace("\N{MINUS SIGN}", "-")
    text = text.rstrip(_END_OF_FILE)
    if text.translate(_CONTROLS) != text:
        raise Unreadable("file", name, "a text file; save a spreadsheet or workspace as CSV")
    if not text.strip():
        raise Unreadable("file", name, "a file that is not empty")
    return Document(name, text, encoding)


def _decoded(content: bytes) -> tuple[str, str]:
    for mark, encoding in _MARKS:
        if content.startswith(mark):
            return content[len(mark) :].decode(encoding, errors="replace"), encoding
    if len(content) > 3:  # text of this field is ASCII for the most part: every other byte is 0
        for encoding, zeros in (("utf-16-le", content[1:400:2]), ("utf-16-be", content[:400:2])):
            if zeros.count(0) > 0.9 * len(zeros):
                return content.decode(encoding, errors="replace"), encoding
    try:
        return content.decode(), "utf-8"
    except UnicodeDecodeError:
        return content.decode("latin-1"), "latin-1"
