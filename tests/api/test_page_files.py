"""The page's own scripts and styles are sent without comments, and with nothing else changed."""

from collections.abc import Iterator
from pathlib import Path
from types import ModuleType

import pytest
import tree_sitter_css
import tree_sitter_javascript
from fastapi import FastAPI
from tree_sitter import Language, Node, Parser

from app.page.comments import without_comments
from app.settings import Settings
from tests.api.raw import send

STATIC = Settings().static_dir
GRAMMARS: dict[str, ModuleType] = {".js": tree_sitter_javascript, ".css": tree_sitter_css}
SOURCES = sorted(
    path
    for path in STATIC.rglob("*")
    if path.suffix in GRAMMARS and "vendor" not in path.relative_to(STATIC).parts
)


def syntax(source: bytes, suffix: str) -> list[tuple[int, str, bytes]]:
    """The syntax tree as depth, kind and, of a leaf, its text, without comments."""

    def walk(node: Node, depth: int) -> Iterator[tuple[int, str, bytes]]:
        if node.type == "comment":
            return
        # What lies between the parts of a string or template belongs to it.
        whole = node.child_count == 0 or node.type in {"string", "template_string", "string_value"}
        text = source[node.start_byte : node.end_byte] if whole else b""
        # A blank that combines two selectors may be a line break or none.
        yield depth, node.type, text.strip()
        for child in node.children:
            yield from walk(child, depth + 1)

    return list(walk(Parser(Language(GRAMMARS[suffix].language())).parse(source).root_node, 0))


@pytest.mark.parametrize("path", SOURCES, ids=lambda path: str(path.relative_to(STATIC)))
def test_nothing_but_comments_is_left_out(path: Path) -> None:
    source = path.read_bytes()
    sent = without_comments(source, path.suffix)
    assert syntax(sent, path.suffix) == syntax(source, path.suffix)


def test_there_are_sources() -> None:
    assert len(SOURCES) > 100
    assert {path.suffix for path in SOURCES} == {".js", ".css"}


@pytest.mark.parametrize(
    ("suffix", "source", "sent"),
    [
        (".js", "/** Why. */\nconst a = 1; // one\n\n\n  b();\n", "\nconst a = 1;\nb();\n"),
        (".js", 'const url = "http://a//b"; // no comment there', 'const url = "http://a//b"; '),
        (".js", "const re = /\\/\\/ *\\n/g; /* x */ go();", "const re = /\\/\\/ *\\n/g;  go();"),
        (".js", "`a\n  // ${b /* c */}\n  d`;", "`a\n  // ${b /* c */}\n  d`;"),
        (".js", "return /*\n*/ 1;", "return\n1;"),
        (".js", "a/**/in/**/b", "a/**/in/**/b"),
        (".js", "this is { not JavaScript // x", "this is { not JavaScript // x"),
        (".css", "/* Why. */\na {\n  color: red; /* x */\n}\n", "\na {\ncolor: red;\n}\n"),
        (".css", "a/**/.b { }", "a/**/.b { }"),
        (".css", 'a { content: "/* x */  y"; }', 'a { content: "/* x */  y"; }'),
        (".html", "<!-- x -->\n\n <p>", "<!-- x -->\n\n <p>"),
    ],
)
def test_what_is_a_comment(suffix: str, source: str, sent: str) -> None:
    assert without_comments(source.encode(), suffix).decode() == sent


def test_own_files_are_sent_so_and_vendored_ones_as_they_are(app: FastAPI) -> None:
    own = STATIC / "js" / "main.js"
    body = send(app, b"/js/main.js").body
    assert b"/**" not in body
    assert body == without_comments(own.read_bytes(), ".js")
    vendored = next((STATIC / "vendor").rglob("plotly.css"))
    target = "/" + vendored.relative_to(STATIC).as_posix()
    assert send(app, target.encode()).body == vendored.read_bytes()
