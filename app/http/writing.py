"""Answers as bytes: JSON by orjson, tables as CSV."""

import csv
import io
import math
from typing import Any, Protocol, runtime_checkable

import numpy as np
import orjson
from starlette.responses import Response

from app.answers.answer import Table
from app.answers.rounding import rounded
from app.optics.numerics.significant import round_significant

JSON = "application/json"
CSV = "text/csv; charset=utf-8"


@runtime_checkable
class Tabular(Protocol):
    """An answer that is a table too."""

    def table(self) -> Table:
        """Lay the answer out in columns."""
        ...


def write(answer: Any, form: str = "json", digits: int = 17) -> Response:
    """Write what an endpoint returned.

    Parameters
    ----------
    answer
        An answer, a table, or bytes that are written already.
    form
        "csv" for the answer as a table.
    digits
        Significant digits of the numbers.
    """
    if isinstance(answer, Response):
        return answer
    if form == "csv" and isinstance(answer, Tabular):
        answer = answer.table()
    if isinstance(answer, Table):
        return Response(
            csv_bytes(answer, digits), headers=shown_as(answer.filename), media_type=CSV
        )
    # Arrays are written without a Python loop, NaN as null.
    body = orjson.dumps(rounded(answer, digits), option=orjson.OPT_SERIALIZE_NUMPY)
    return Response(body, media_type=JSON)


def csv_bytes(table: Table, digits: int = 17) -> bytes:
    """Write CSV: a header row, then one row an index; None, NaN and infinity are empty fields."""
    columns = table.columns.values()
    if all(isinstance(column, np.ndarray) and column.dtype.kind == "f" for column in columns):
        numbers = [round_significant(np.asarray(column), digits) for column in columns]
        stacked = np.ascontiguousarray(np.column_stack(numbers))
        # orjson writes the shortest digits that round-trip, faster than any loop over repr().
        rows = orjson.dumps(stacked, option=orjson.OPT_SERIALIZE_NUMPY)[2:-2]
        lines = rows.replace(b"],[", b"\r\n").replace(b"null", b"")
        return b"\r\n".join([",".join(table.columns).encode(), lines, b""])
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\r\n")
    writer.writerow(table.columns)
    lists = [rounded(list(column), digits) for column in columns]
    writer.writerows([_cell(value) for value in row] for row in zip(*lists, strict=True))
    return text.getvalue().encode()


def _cell(value: object) -> object:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, float):
        return repr(float(value)) if math.isfinite(value) else ""
    return "" if value is None else value


def shown_as(filename: str) -> dict[str, str]:
    """Header that names the file which a browser saves."""
    return {"Content-Disposition": f'inline; filename="{filename}"'}
