"""The page's document: index.html, with the first picture of the state in its address."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from threading import Lock

from cachetools import LRUCache

from app.http.body import EncodedBody
from app.page.first_picture import FirstPicture

NAME = "index.html"
MAIN = "js/main.js"
VIEW = "js/views/explore.js"
STYLES = ("css/base.css", "css/explore.css", "vendor/plotly-cartesian-4.1.1/plotly.css")
"""What the document names; where the page is packed, its files stand in their place."""

_STARTING = '<p class="starting">Starting …</p>'
_BEFORE = f'  <link rel="modulepreload" href="{MAIN}">\n'

_TAB = '<a href="./" data-view="explore"'

_MOST_BYTES = 8_000_000
"""What the documents kept may take."""

_FORMS = 4
"""As a document is kept: the text and three encodings, none longer than the text."""

_LONGEST_QUERY = 1000
"""Longer ones start with the plain page: nobody can say how many more there are."""


class Document:
    """The page's document by the query of its address.

    Parameters
    ----------
    static_dir
        The folder of the page's files.
    picture
        Draws what an address says; None of what cannot be drawn.
    replaced
        Files of the packed page by those that stand in the document.
    """

    def __init__(
        self,
        static_dir: Path,
        picture: Callable[[bytes], FirstPicture | None],
        replaced: Mapping[str, str],
    ) -> None:
        self._path = static_dir / NAME
        self._picture = picture
        self._replaced = replaced
        self._kept: LRUCache[tuple[bytes | None, int], EncodedBody] = LRUCache(
            _MOST_BYTES, getsizeof=lambda body: _FORMS * body.size
        )
        self._lock = Lock()

    def body(self, query: bytes | None) -> EncodedBody:
        """The document for a query; without a picture where that is None, or says nothing to draw."""
        key = query, self._path.stat().st_mtime_ns
        with self._lock:
            found = self._kept.get(key)
        if found is None:
            found = self._made(query)
            if query is None or len(query) <= _LONGEST_QUERY:
                with self._lock:
                    self._kept[key] = found
        return found

    def _made(self, query: bytes | None) -> EncodedBody:
        text = self._path.read_text("utf-8")
        drawable = query is not None and len(query) <= _LONGEST_QUERY
        picture = self._picture(query) if query is not None and drawable else None
        if picture is not None:
            links = "".join(
                f'  <link rel="preload" href="{path}" as="fetch" crossorigin>\n'
                for path in picture.asked
            )
            text = text.replace(_BEFORE, links + _BEFORE).replace(_STARTING, picture.html)
            text = text.replace(_TAB, f'{_TAB} aria-current="page"')
        for style in STYLES[:-1] if self._replaced else ():
            text = text.replace(f'  <link rel="stylesheet" href="{style}">\n', "")
        for source, packed in self._replaced.items():
            text = text.replace(f'"{source}"', f'"{packed}"')
        headers = [(b"content-type", b"text/html; charset=utf-8"), (b"cache-control", b"no-cache")]
        return EncodedBody(text.encode(), headers, "quick" if query else "thorough")
