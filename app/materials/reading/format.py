"""What a format of files is."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from app.materials.reading.constants import Table
from app.materials.reading.document import Document
from app.materials.reading.report import Notes
from app.materials.schema import Formula, Reference


@dataclass(frozen=True, kw_only=True, eq=False)
class Content:
    """What a format finds in a file, before signs, order and gaps are looked at."""

    tables: Sequence[Table] = ()
    formula: Formula | None = None
    """Of n."""
    name: str | None = None
    """Of the material, where the file says it."""
    relative_to: Reference | None = None
    columns: tuple[str, ...] = field(default=())
    """What the columns of the first table are; from its roles unless given."""


@dataclass(frozen=True, kw_only=True)
class Format:
    """A way in which programs of this field write n and k."""

    id: str
    title: str
    """Id of the parameter `format`, and name in sentences."""
    sniff: Callable[[Document], str | None]
    """Says why a file is of this format; None where it is not."""
    read: Callable[[Sequence[Document], Notes], Content]
    """Reads the file, or the files that make one material."""
    rank: int = 0
    """Formats of a lower rank are tried first."""
