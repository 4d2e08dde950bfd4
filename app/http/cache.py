"""Finished answers by what was asked, within a bound on the bytes they take."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Hashable
from dataclasses import dataclass, field

from app.http.body import ReadyBody

# What Python's objects add to the bytes of an answer, and to those of a key.
_ENTRY, _KEY = 2000, 1000


@dataclass(slots=True, eq=False)
class Entry:
    """One answer, with the keys it is found by and what it is counted with."""

    ready: ReadyBody
    keys: list[Hashable] = field(default_factory=list)
    key_bytes: int = 0
    counted: int = 0


class AnswerCache:
    """The answers asked for last; equal ones are kept once, however they were asked for.

    Parameters
    ----------
    limit
        Bytes that the answers, in all encodings made so far, may take together with their keys.
    """

    def __init__(self, limit: int) -> None:
        self.limit = limit
        self.bytes = 0
        self._by_key: dict[Hashable, Entry] = {}
        self._by_age: OrderedDict[Entry, None] = OrderedDict()  # the longest unused first

    def __len__(self) -> int:
        return len(self._by_age)

    def get(self, key: Hashable) -> ReadyBody | None:
        """Find an answer, and count it again if it was compressed since."""
        entry = self._by_key.get(key)
        if entry is None:
            return None
        self._by_age.move_to_end(entry)
        if entry.counted != entry.ready.size:
            self._count(entry)
        return entry.ready

    def put(self, ready: ReadyBody, key: Hashable, key_bytes: int) -> ReadyBody:
        """Keep an answer and return the one kept, which is an equal one if there is one.

        Parameters
        ----------
        ready
            The answer.
        key
            What it will be found by.
        key_bytes
            Size of the key.
        """
        entry = self._by_key.get(ready.etag)
        if entry is None or entry.ready.body != ready.body:
            entry = Entry(ready)
            self._by_age[entry] = None
            self.bytes += _ENTRY
            self._add(entry, ready.etag, 0)
        self._add(entry, key, key_bytes)
        self._by_age.move_to_end(entry)
        self._count(entry)
        return entry.ready

    def _add(self, entry: Entry, key: Hashable, key_bytes: int) -> None:
        if key not in self._by_key:
            self._by_key[key] = entry
            entry.keys.append(key)
            entry.key_bytes += key_bytes + _KEY
            self.bytes += key_bytes + _KEY

    def _count(self, entry: Entry) -> None:
        self.bytes += entry.ready.size - entry.counted
        entry.counted = entry.ready.size
        while self.bytes > self.limit:
            oldest, _ = self._by_age.popitem(last=False)
            self.bytes -= oldest.counted + oldest.key_bytes + _ENTRY
            for key in oldest.keys:
                del self._by_key[key]
