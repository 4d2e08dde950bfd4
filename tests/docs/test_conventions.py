"""The table of other programs' signs, as far as they are installed here."""

import re
from pathlib import Path

from tools.conventions import of_tmm

PAGE = (Path(__file__).parents[2] / "docs" / "conventions.md").read_text("utf-8")


def test_tmm_does_what_the_table_says() -> None:
    assert "| " + " | ".join(of_tmm().values()) + " |" in PAGE


def test_the_table_names_the_columns_that_the_script_prints() -> None:
    (header,) = re.findall(r"^\| program .*$", PAGE, re.MULTILINE)
    assert header.strip("| ").split(" | ") == list(of_tmm())
