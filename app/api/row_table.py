"""Tables whose cells are words and numbers, as CSV."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Mapping, Sequence
from typing import Any

from starlette.responses import Response

from app.api.responses import CSV, ReadyBody, rounded, shown_as


def rows_csv_body(
    header: Sequence[str],
    rows: Sequence[Mapping[str, Any]],
    digits: int,
    filename: str,
) -> Response:
    """Answer with CSV: a header row, then one row each; None, NaN and infinity are empty fields."""
    text = io.StringIO()
    table = csv.DictWriter(text, header, extrasaction="ignore", lineterminator="\r\n")
    table.writeheader()
    table.writerows(
        {name: _cell(row.get(name)) for name in header} for row in rounded(rows, digits)
    )
    return ReadyBody(text.getvalue().encode(), CSV, shown_as(filename))


def _cell(value: object) -> object:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, float):
        return repr(value) if math.isfinite(value) else ""
    return "" if value is None else value
