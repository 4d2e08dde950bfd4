"""The page's scripts and styles without comments and indentation, a quarter of what they weigh."""

from __future__ import annotations

import re
from functools import cache

import tree_sitter_css
import tree_sitter_javascript
from tree_sitter import Language, Parser, Query, QueryCursor

_LANGUAGES = {".js": tree_sitter_javascript.language, ".css": tree_sitter_css.language}

# Inside of these each blank counts.
_VERBATIM = {
    ".js": "[(string) (template_string) (regex)] @verbatim",
    ".css": "(string_value) @verbatim",
}

_BLANK = b" \t\n"
_LINE_BREAK = re.compile(rb"[ \t]*\n\s*")


def without_comments(source: bytes, suffix: str) -> bytes:
    """Leave out comments, indentation and empty lines; every token and every line break stays.

    Nothing is renamed, moved or joined. A source that the parser does not understand comes back
    as it is: it is the browser's to complain, about the lines that the author knows.

    Parameters
    ----------
    source
        JavaScript or CSS in UTF-8.
    suffix
        ".js" or ".css"; anything else comes back as it is.
    """
    if suffix not in _LANGUAGES:
        return source
    parser, query = _grammar(suffix)
    root = parser.parse(source).root_node
    if root.has_error:
        return source
    captures = QueryCursor(query).captures(root)
    spans = sorted(
        (node.start_byte, node.end_byte, kind == "comment")
        for kind, nodes in captures.items()
        for node in nodes
    )
    kept: list[bytes] = []
    code: list[bytes] = []
    position = 0
    for start, end, is_comment in spans:
        if start < position:
            continue  # inside of a template
        code.append(source[position:start])
        position = end
        if is_comment:
            code.append(_in_place_of_comment(source, start, end))
        else:
            kept += [_LINE_BREAK.sub(b"\n", b"".join(code)), source[start:end]]
            code = []
    kept.append(_LINE_BREAK.sub(b"\n", b"".join([*code, source[position:]])))
    return b"".join(kept)


def _in_place_of_comment(source: bytes, start: int, end: int) -> bytes:
    before, after = source[max(start - 1, 0) : start], source[end : end + 1]
    if before not in _BLANK and after not in _BLANK:
        return source[start:end]  # it keeps its neighbors apart: a/**/.b in CSS is not a .b
    # JavaScript ends a statement at a comment that holds a line break.
    return b"\n" if b"\n" in source[start:end] else b""


@cache
def _grammar(suffix: str) -> tuple[Parser, Query]:
    language = Language(_LANGUAGES[suffix]())
    return Parser(language), Query(language, f"(comment) @comment {_VERBATIM[suffix]}")
