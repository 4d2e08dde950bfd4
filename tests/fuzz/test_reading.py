"""Damaged and invented files for the reader: no crash, nothing slow, little memory.

`make fuzz` reads 200,000 of them and prints what became of them.
"""

import os
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from random import Random
from typing import Any

import pytest
from hypothesis import HealthCheck, Phase, given, seed, settings
from hypothesis import strategies as st

from app.answers.materials.reading import read_material
from app.materials.own.token import LONGEST, read
from app.materials.reading.columns import ROLES
from app.materials.reading.registry import default_formats
from app.materials.reading.report import Choices
from app.materials.reading.units import UNITS
from app.optics.errors import OpticsError

READS = int(os.environ.get("FUZZ_READS", "400"))
SEED = int(os.environ.get("FUZZ_SEED", "7"))
SLOWEST_S = 2.0
"""Of the processor: how long others keep it does not count."""
MOST_MB = 300
ROOT = Path(__file__).parents[2]

File = tuple[str, bytes]
FILES = [
    (path.name, path.read_bytes())
    for path in sorted((Path(__file__).parents[1] / "materials/reading/files").iterdir())
]
NAMES = ["x.nk", "x.mat", "x.agf", "x.yml", "x.csv", "x.eta.spd", "x.nff", "", ".", "a/b\\c.k.spd"]
WORDS = Path(__file__).with_name("words.txt").read_text("utf-8").split()
"""What is hard to read, or is a keyword of some format."""


class Damage:
    """Damages files as editors, programs and transfers do, the same way for the same seed."""

    def __init__(self, number: int) -> None:
        self._random = Random(f"{SEED} {number}")  # noqa: S311

    def word(self) -> bytes:
        random = self._random
        number = repr(random.uniform(-10.0, 10.0) * 10.0 ** random.randint(-9, 9))
        return random.choice(
            [random.choice(WORDS), number, chr(random.randint(0, 0x2FFF))]
        ).encode()

    def changed(self, content: bytes) -> bytes:
        random = self._random
        for _ in range(random.randint(0, 4)):
            lines = content.split(b"\n")
            at, beside = random.randrange(len(lines)), random.randrange(len(lines))
            kind = random.random()
            if kind < 0.5:
                words = lines[at].split(random.choice([b" ", b",", b";", b"\t"]))
                words[random.randrange(len(words))] = self.word()
                lines[at] = random.choice([b" ", b",", b";", b"\t"]).join(words)
            elif kind < 0.6:
                lines.insert(at, self.word())
            elif kind < 0.7:
                del lines[at]
            elif kind < 0.8:
                lines.insert(beside, lines[at])
            elif kind < 0.9:
                lines[at], lines[beside] = lines[beside], lines[at]
            elif kind < 0.902:  # rarely, as it takes long
                lines[at:at] = [lines[at]] * 20_000
            content = b"\n".join(lines)
            if kind > 0.97:
                content = content[: random.randrange(len(content) + 1)]
            elif kind > 0.94 and content:
                place = random.randrange(len(content))
                content = content[:place] + self.word()[:1] + content[place + 1 :]
        return content

    def files(self) -> list[File]:
        random = self._random
        if random.random() < 0.03:
            pair = [file for file in FILES if file[0].startswith("Xx.")]
        else:
            pair = random.sample(FILES, 1 + (random.random() < 0.02))
        return [
            (random.choice(NAMES) if random.random() < 0.1 else name, self.changed(content))
            for name, content in pair
        ]

    def choices(self) -> Choices:
        random = self._random
        drawn: dict[str, Callable[[], Any]] = {
            "format": lambda: random.choice([*default_formats(), "nope"]),
            "unit": lambda: random.choice([*UNITS, "furlong"]),
            "columns": lambda: tuple(random.choices([*ROLES, "q", ""], k=random.randint(1, 5))),
            "sign": lambda: random.choice(["n+ik", "n-ik"]),
            "decimal": lambda: random.choice([".", ","]),
            "zero_k": lambda: random.choice(["known", "unknown"]),
            "n_from": lambda: random.choice(["table", "formula"]),
            "relative_to": lambda: random.choice(["vacuum", "air"]),
            "glass": lambda: random.choice(["ONE", "TWO", "SOLO", "x" * 100]),
            "name": lambda: self.word().decode() * random.randint(1, 5),
        }
        if random.random() < 0.4:
            del drawn["glass"]
        return Choices(
            **{
                name: draw()
                for name, draw in drawn.items()
                if random.random() < (0.9 if name == "glass" else 0.06)
            }
        )


class Reader:
    """Reads files, and keeps count of what became of them."""

    def __init__(self) -> None:
        self.became: Counter[str] = Counter()
        self.slowest = 0.0

    def read(self, files: list[File], choices: Choices) -> None:
        began = time.process_time()
        try:
            answer = read_material(files, choices)
        except OpticsError as error:
            self.became[f"{type(error).__name__} {error.parameter}"] += 1
        else:
            self.became[answer.report.format] += 1
            assert len(answer.material) <= LONGEST
            assert read(answer.material).name == answer.name
            low, high = answer.report.n_range_nm
            assert 0.0 < low <= high <= 1e7
        took = time.process_time() - began
        self.slowest = max(self.slowest, took)
        assert took < SLOWEST_S

    def tell(self) -> None:
        count = sum(self.became.values())
        print(f"{count} files, slowest {self.slowest:.3f} s: {self.became}")  # noqa: T201


def test_no_damaged_file_brings_the_reader_down() -> None:
    reader = Reader()
    for number in range(READS * 3 // 4):
        damage = Damage(number)
        files, choices = damage.files(), damage.choices()
        try:
            reader.read(files, choices)
        except BaseException:
            shown = [(name, content[:2000]) for name, content in files]
            print(f"file {number} of seed {SEED}: {shown}, {choices}")  # noqa: T201
            raise
    reader.tell()


NUMBER = st.one_of(
    st.floats(-10.0, 5000.0).map(lambda x: f"{x:.6g}"),
    st.sampled_from(WORDS),
    st.floats().map(repr),
    st.text(max_size=6),
)
TABLE = st.tuples(
    st.sampled_from([" ", ",", ";", "\t", "  ", " ; "]),
    st.lists(st.lists(NUMBER, min_size=1, max_size=5), max_size=12),
).map(lambda drawn: "\n".join(drawn[0].join(row) for row in drawn[1]).encode("utf-8", "replace"))
TEXT = st.tuples(
    st.text(max_size=200), st.sampled_from(["utf-8", "utf-16", "utf-16-be", "latin-1"])
).map(lambda drawn: drawn[0].encode(drawn[1], "replace"))
INVENTED = st.lists(
    st.tuples(
        st.sampled_from(NAMES + [name for name, _ in FILES]),
        st.one_of(TABLE, st.binary(max_size=200), TEXT),
    ),
    min_size=1,
    max_size=2,
)


def test_no_invented_file_brings_the_reader_down() -> None:
    reader = Reader()

    @seed(SEED)
    @settings(
        max_examples=READS // 4,
        deadline=None,
        database=None,
        phases=[Phase.generate],
        suppress_health_check=list(HealthCheck),
    )
    @given(INVENTED, st.integers(0, 10**6))
    def reads(files: list[File], number: int) -> None:
        reader.read(files, Damage(number).choices())

    reads()
    reader.tell()


LARGEST = {
    "rows": ("a.csv", "b'\\n'.join(b'%.2f 1.5%d' % (300 + i / 99, i % 97) for i in range(150000))"),
    "no numbers": ("a.csv", "b'nm,n,k\\n' + b'400,1.5,x\\n' * 190000"),
    "one wavelength": ("a.csv", "b'nm,n,k\\n' + b'400,1.5,0.1\\n' * 160000"),
    "a page": (
        "a.yml",
        "b'DATA:\\n  - type: tabulated nk\\n    data: |\\n' + b'     0.4 1.5 0.1\\n' * 110000",
    ),
}
CHILD = """
from pathlib import Path
from app.answers.materials.reading import read_material
from app.optics.errors import OpticsError
try:
    read_material([({name!r}, {content})])
except OpticsError:
    pass
peak = Path("/proc/self/status").read_text().split("VmHWM:")[1].split()[0]
print(int(peak) // 1024)
"""


@pytest.mark.skipif(sys.platform != "linux", reason="counts memory as Linux does")
@pytest.mark.parametrize("kind", LARGEST)
def test_the_largest_files_take_little_memory(kind: str) -> None:
    """In a process of its own: what generates files takes more than what reads them."""
    name, content = LARGEST[kind]
    child = CHILD.format(name=name, content=content)
    done = subprocess.run(
        [sys.executable, "-c", child], check=True, capture_output=True, text=True, cwd=ROOT
    )
    assert int(done.stdout) < MOST_MB
