"""Questions and answers as they are stored: one JSON object a line, compressed."""

from __future__ import annotations

import gzip
import json
from base64 import b64decode, b64encode
from collections.abc import Iterable, Iterator
from dataclasses import asdict, dataclass, field
from hashlib import sha256
from pathlib import Path


@dataclass(frozen=True)
class Question:
    """A request of HTTP, or a command line (method `$`)."""

    method: str
    target: str
    headers: dict[str, str] = field(default_factory=dict)
    body: str = ""  # base64, for it may be Arrow

    @property
    def content(self) -> bytes:
        """Its body."""
        return b64decode(self.body)

    def __str__(self) -> str:
        """Write it as a report shows it."""
        shown = self.target if len(self.target) < 200 else self.target[:200] + "..."
        size = f" {len(self.content)} bytes" if self.body else ""
        return f"{self.method} {shown}{size}{f' {self.headers}' if self.headers else ''}"


@dataclass(frozen=True)
class Answer:
    """What came back: headers that matter, or besides standard output what a command made."""

    status: int
    headers: dict[str, str]
    body: str


def post(target: str, body: bytes, **headers: str) -> Question:
    """Build a POST; underscores in names of headers stand for hyphens."""
    named = {name.replace("_", "-"): value for name, value in headers.items()}
    return Question("POST", target, named, b64encode(body).decode())


def text_or_digest(content: bytes) -> str:
    """Text as it is; of anything else what tells whether it changed."""
    try:
        text = content.decode()
    except UnicodeDecodeError:
        text = "\0"
    return text if "\0" not in text else f"sha256 {sha256(content).hexdigest()}, {len(content)} B"


def store(path: Path, pairs: Iterable[tuple[Question, Answer]]) -> int:
    """Write questions with their answers, and count them."""
    count = 0
    path.parent.mkdir(parents=True, exist_ok=True)
    with gzip.open(path, "wt", compresslevel=3, encoding="utf-8") as lines:
        for question, answer in pairs:
            lines.write(json.dumps([asdict(question), asdict(answer)]) + "\n")
            count += 1
    return count


def stored(path: Path) -> Iterator[tuple[Question, Answer]]:
    """Read them again."""
    with gzip.open(path, "rt", encoding="utf-8") as lines:
        for line in lines:
            question, answer = json.loads(line)
            yield Question(**question), Answer(**answer)
