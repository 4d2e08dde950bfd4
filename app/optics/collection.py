"""What is registered under ids: models, formulas, fits."""

from collections.abc import Iterable, Iterator, Mapping
from typing import Protocol, TypeVar

from app.optics.errors import UnknownName


class HasId(Protocol):
    """Anything with an id."""

    @property
    def id(self) -> str:
        """Name in the API."""


Item = TypeVar("Item", bound=HasId)


class Collection(Mapping[str, Item]):
    """Things by id, in their order.

    Parameters
    ----------
    items
        The things, no two with the same id.
    unknown
        Error for an id of a user's that is no thing's.
    parameter
        Name of the parameter that such an id is given in, unless `find` is told another.
    """

    def __init__(self, items: Iterable[Item], unknown: type[UnknownName], parameter: str) -> None:
        items = tuple(items)
        self._items = {item.id: item for item in items}
        self._unknown, self._parameter = unknown, parameter
        if len(self._items) != len(items):
            raise ValueError("two share an id")

    def __getitem__(self, item_id: str) -> Item:
        """Return the thing of that id; `find` raises an error for users instead of a KeyError."""
        return self._items[item_id]

    def __iter__(self) -> Iterator[str]:
        return iter(self._items)

    def __len__(self) -> int:
        return len(self._items)

    def find(self, item_id: str, parameter: str | None = None) -> Item:
        """Return the thing of that id.

        Raises
        ------
        UnknownName
            If there is none, naming the nearest ids.
        """
        try:
            return self._items[item_id]
        except KeyError:
            raise self._unknown(parameter or self._parameter, item_id, self._items) from None
