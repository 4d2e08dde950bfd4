"""What engines answered, and the files in which it is kept."""

from __future__ import annotations

import datetime
import json
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, TypedDict

import numpy as np

from tools.engines.questions import CHANNELS_NM, THETA_I_DEG, WHITE, media

if TYPE_CHECKING:
    from tools.engines.engines import Engine

FOLDER = Path(__file__).resolve().parents[2] / "materials" / "engines"

SETTINGS = "settings"
"""Stands for the medium where an engine was asked for what is typed, in the even environment."""

# Engines compute in single precision at best.
_DIGITS = 6


class Told(TypedDict):
    """Reflectance of one medium over the angle, as an engine's script answers."""

    medium: str
    light: Literal["environment", "light"]
    """An even environment, or one light in the mirror's direction."""
    way: str
    """Which of the engine's materials, or of their modes."""
    typed: dict[str, Any]
    """Its parameters, by the engine's own names."""
    reflectance: list[list[float]]
    """A row an angle, a column a channel."""


def write(name: str, engine: Engine, curves: list[Told]) -> Path:
    """Keep what an engine answered among the project's data."""
    whites = [curve["reflectance"] for curve in curves if curve["medium"] == WHITE.name]
    noise = float(np.max(np.abs(np.array(whites) - 1.0), initial=0.0))
    told = {
        "engine": name,
        "title": engine.title,
        "package": engine.package,
        "version": engine.version,
        "date": datetime.datetime.now(datetime.UTC).date().isoformat(),
        "how": engine.how,
        "repeat": f"python -m tools.engines {name}",
        "noise": float(f"{max(noise, engine.rounding):.1g}"),
        "channels_nm": CHANNELS_NM,
        "media": [{"name": m.name, "n": m.n, "k": m.k} for m in media()],
        "theta_i_deg": THETA_I_DEG.tolist(),
        "curves": [_rounded(dict(c)) for c in curves if c["medium"] not in (WHITE.name, SETTINGS)],
        "settings": [
            {key: _rounded(c[key]) for key in ("way", "typed", "reflectance")}
            for c in curves
            if c["medium"] == SETTINGS
        ],
    }
    FOLDER.mkdir(parents=True, exist_ok=True)
    path = FOLDER / f"{name}.json"
    path.write_text("{\n" + ",\n".join(f'"{k}": {_lines(v)}' for k, v in told.items()) + "\n}\n")
    return path


def _lines(value: Any) -> str:
    """Write lists of objects an object a line, all else on one."""
    if isinstance(value, list) and value and isinstance(value[0], dict):
        return "[\n" + ",\n".join(json.dumps(v) for v in value) + "\n]"
    return json.dumps(value)


def _rounded(value: Any) -> Any:
    if isinstance(value, float):
        return round(value, _DIGITS)
    if isinstance(value, dict):
        return {key: _rounded(v) for key, v in value.items()}
    return [_rounded(v) for v in value] if isinstance(value, list) else value
