"""Every format in `app.materials.reading.formats`."""

import importlib
import pkgutil
from functools import cache

from app.materials.reading import formats
from app.materials.reading.format import Format
from app.optics.collection import Collection
from app.optics.errors import UnknownName


class UnknownFormat(UnknownName):
    """A format that nothing reads."""


@cache
def default_formats() -> Collection[Format]:
    """Collect the formats, those that are tried first in front."""
    found: list[Format] = [
        importlib.import_module(f"{formats.__name__}.{module.name}").FORMAT
        for module in pkgutil.iter_modules(formats.__path__)
    ]
    return Collection(sorted(found, key=lambda f: (f.rank, f.id)), UnknownFormat, "format")
