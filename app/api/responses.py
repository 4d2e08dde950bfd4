"""Answers as ready bytes: JSON by orjson, CSV."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import orjson

from app.api.presets import PresetInterface, preset_json
from app.http.body import ReadyBody
from app.optics.angles import LANDMARKS
from app.optics.interface import Interface
from app.optics.parameters import Array
from app.optics.specular import F82

CSV = "text/csv; charset=utf-8"

CONVENTION = (
    "time factor exp(-i w t); N = n_t + i k_t with k_t >= 0; r_p = -r_s at normal incidence; "
    "angles from the surface normal; T = 1 - R is the power that enters the second medium"
)

# 10^22 is the largest power of ten that is a double.
_LARGEST_EXACT_POWER = 22

# Beyond so many, the error of a product or of a logarithm is no longer small beside the last digit.
_MOST_DIGITS_SCALED = 13


def round_significant(values: Array, digits: int) -> Array:
    """Round to `digits` significant digits, to the very double that those digits spell.

    As Python's formatting does: to the nearest, by all that a double holds, and between two that are
    as near to the even one.
    """
    if digits >= 17:
        return values
    magnitude = np.abs(values)
    ordinary = np.isfinite(values) & (magnitude > 0.0)
    power = digits - 1 - np.floor(np.log10(magnitude, where=ordinary, out=np.zeros_like(values)))
    scalable = ordinary & (np.abs(power) <= _LARGEST_EXACT_POWER) & (digits <= _MOST_DIGITS_SCALED)
    scale = 10.0 ** np.where(scalable, np.abs(power), 0.0)
    up = power >= 0.0
    numbers = np.where(scalable, values, 0.0)
    scaled = np.where(up, numbers * scale, numbers / scale)
    whole = np.round(scaled)
    # Where the product's own error could turn it the other way, it is not trusted.
    scalable &= 0.5 - np.abs(scaled - whole) > np.finfo(np.float64).eps * np.abs(scaled)
    result = np.asarray(np.where(scalable, np.where(up, whole / scale, whole * scale), values))
    spelled = ordinary & ~scalable
    result[spelled] = [float(f"{value:.{digits}g}") for value in values[spelled].tolist()]
    return result


def rounded(payload: Any, digits: int) -> Any:
    """Round every float and every float array inside `payload`."""
    if digits >= 17:
        return payload
    if isinstance(payload, Mapping):
        return {key: rounded(value, digits) for key, value in payload.items()}
    if isinstance(payload, list | tuple):
        return [rounded(value, digits) for value in payload]
    if isinstance(payload, np.ndarray) and payload.dtype.kind == "f":
        return round_significant(payload, digits)
    if isinstance(payload, float):
        return float(f"{payload:.{digits}g}")
    return payload


def number_or_null(value: Array) -> float | None:
    """Turn a zero-dimensional array into a float, NaN into None."""
    number = float(value)
    return None if np.isnan(number) else number


def interface_json(interface: Interface) -> dict[str, Any]:
    """Describe an interface as every answer does, with the presets its numbers come from."""
    named = interface if isinstance(interface, PresetInterface) else None
    return {
        "n_i": float(interface.n_i),
        "n_t": float(interface.n_t),
        "k_t": float(interface.k_t),
        "eta": float(interface.eta),
        "kappa": float(interface.kappa),
        "kind": interface.kind,
        "F0": float(interface.F0),
        "F82": float(F82(interface)),
        **{name: number_or_null(angle(interface)) for name, angle in LANDMARKS.items()},
        "incident": preset_json(named.incident) if named and named.incident else None,
        "material": preset_json(named.material) if named and named.material else None,
    }


def json_body(
    payload: Any, digits: int = 17, headers: Mapping[str, str] | None = None
) -> ReadyBody:
    """Write JSON; arrays are written by orjson without a Python loop, NaN as null."""
    body = orjson.dumps(rounded(payload, digits), option=orjson.OPT_SERIALIZE_NUMPY)
    return ReadyBody(body, "application/json", headers)


def csv_body(
    columns: Mapping[str, Array],
    digits: int = 17,
    filename: str = "fresnel.csv",
    headers: Mapping[str, str] | None = None,
) -> ReadyBody:
    """Write CSV: a header row, then one row an index; NaN is an empty field."""
    table = np.ascontiguousarray(
        np.column_stack([round_significant(column, digits) for column in columns.values()])
    )
    # orjson writes the shortest digits that round-trip, faster than any loop over repr().
    rows = orjson.dumps(table, option=orjson.OPT_SERIALIZE_NUMPY)[2:-2]
    body = (
        ",".join(columns).encode()
        + b"\r\n"
        + rows.replace(b"],[", b"\r\n").replace(b"null", b"")
        + b"\r\n"
    )
    return ReadyBody(body, CSV, {**shown_as(filename), **(headers or {})})


def shown_as(filename: str) -> dict[str, str]:
    """Header that names the file which a browser saves."""
    return {"Content-Disposition": f'inline; filename="{filename}"'}
