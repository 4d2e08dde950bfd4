"""What the page shows before any of its scripts: the ray and the curves of the state in its address.

The numbers are answers of the API, asked as the page asks them; what stands here is how they are
drawn. The page draws the same over it and takes it away.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from html import escape
from pathlib import Path
from string import Template
from typing import Any
from urllib.parse import parse_qsl, quote

import orjson

from app.answers.curves import Curves
from app.answers.looks import model_look
from app.answers.snell import Ray
from app.http.problems import BadParameters
from app.optics.errors import OpticsError

ANGLE_DEG = 64.0
"""Where the page starts, as in static/js/main.js: R, Rs and Rp are well apart."""

NEGLIGIBLE = 1e-6
"""k that the page leaves out, as in static/js/media/media.js: light goes 40 mm in it."""

_NUMBERS = ("n_i", "n_t", "k_t", "theta_i_deg", "wavelength_nm")
_NAMES = ("incident", "material", "models", "polarization", "view", "show", "light")
_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?", re.IGNORECASE)
_MOST_FIELDS = 60

_LENGTH = 0.84
"""Of the incident ray, in half the shorter side of the diagram."""

_X, _Y = 1800, 2000
"""Units of a curve's picture."""

_TEMPLATE = Template((Path(__file__).parent / "first_picture.html").read_text("utf-8").strip())
_OF_NUMBERS = "<div><dt></dt><dd><span class=number></span></dd></div>" * 17
_OF_AMPLITUDES = ("<tr><td></td>" + "<td><span class=number></span></td>" * 4 + "</tr>") * 4

_DASHES = {"solid": "", "dash": "9 5", "dot": "2 4", "dashdot": "9 4 2 4", "longdash": "14 5"}


@dataclass(frozen=True)
class FirstPicture:
    """HTML of the picture, and what the page will ask the API for first."""

    html: str
    asked: list[str]
    """Addresses relative to the page."""


def first_picture(ask: Callable[[str], Any], query: bytes) -> FirstPicture | None:
    """Draw what the query of an address says.

    Parameters
    ----------
    ask
        Answers a path and query of the API.
    query
        As it was sent.

    Returns
    -------
    FirstPicture | None
        None where the address shows another view, or says what cannot be taken: the page explains it.
    """
    try:
        given = parse_qsl(query.decode(), keep_blank_values=True, max_num_fields=_MOST_FIELDS)
        known = {*_NUMBERS, *_NAMES}
        state = {name: text for name, text in reversed(given) if name in known or "." in name}
        if state.get("view", "explore") != "explore" or not _is_written(state):
            return None
        return _drawn(ask, state)
    except (BadParameters, OpticsError, ValueError):
        return None


def _is_written(state: Mapping[str, str]) -> bool:
    """Whether the numbers are written as the page reads them."""
    return all(_NUMBER.fullmatch(state[name]) for name in _NUMBERS if name in state)


def _drawn(ask: Callable[[str], Any], state: Mapping[str, str]) -> FirstPicture:
    media = _media(ask, state)
    theta = float(state.get("theta_i_deg", ANGLE_DEG))
    models = state.get("models", "none").replace("none", "")
    parts = [f"{name}={_number(value)}" for name, value in media.items()]
    of_models = [f"models=exact,{quote(models, safe=',')}"] if models else []
    own = [name for name in state if name.partition(".")[0] in models.split(",")]
    of_models += [f"{quote(name)}={quote(state[name])}" for name in own if "." in name]
    curves = "&".join([*parts, *of_models, "landmarks=true", "refraction=true"])
    snell = "&".join([*parts, f"theta_i_deg={_number(theta)}"])
    found: Curves = ask(f"/curves?{curves}")
    ray: Ray = ask(f"/snell?{snell}")
    polarization = state.get("polarization", "unpolarized")
    shares = {"s": (ray.Rs, ray.Ts), "p": (ray.Rp, ray.Tp), "unpolarized": (ray.R, ray.T)}
    if polarization not in shares:
        raise ValueError(polarization)
    share, passed = shares[polarization]
    html = _TEMPLATE.substitute(
        ray=_ray(ray, share, 0.0 if ray.total_internal_reflection else passed),
        curves=_curves(found, ray, {"s": "Rs", "p": "Rp", "unpolarized": "R"}[polarization]),
        share=_number(share),
        reflected=percent(share),
        passed=percent(passed),
        into="into the absorber" if ray.interface.k_t > 0 else "transmitted",
        numbers=_OF_NUMBERS,
        amplitudes=_OF_AMPLITUDES,
    )
    # With models, phases or a wavelength the page asks otherwise than it is asked here.
    plain = not models and not state.get("show") and not state.get("wavelength_nm")
    return FirstPicture(
        html,
        [f"api/v1/curves?{escape(curves)}", f"api/v1/snell?{escape(snell)}"] if plain else [],
    )


def _media(ask: Callable[[str], Any], state: Mapping[str, str]) -> dict[str, float]:
    """The three indices that differ from the API's defaults, as the page has them."""
    asked = [name for name in ("incident", "material") if name in state]
    numbers = {name: float(state[name]) for name in ("n_i", "n_t", "k_t") if name in state}
    if "incident" in asked:
        numbers.pop("n_i", None)
    if "material" in asked:
        numbers.pop("n_t", None)
        numbers.pop("k_t", None)
    if asked:
        parts = [f"{name}={_number(value)}" for name, value in numbers.items()]
        parts += [f"{name}={quote(state[name])}" for name in asked]
        if "wavelength_nm" in state:
            parts.append(f"wavelength_nm={state['wavelength_nm']}")
        facts = ask(f"/snell?{'&'.join([*parts, 'theta_i_deg=0'])}").interface
        k_t = facts.k_t if facts.k_t >= NEGLIGIBLE else 0.0
        numbers = {"n_i": facts.n_i, "n_t": facts.n_t, "k_t": k_t}
    defaults = {"n_i": 1.0, "n_t": 1.5, "k_t": 0.0}
    return {name: value for name, value in numbers.items() if value != defaults[name]}


def _number(value: float) -> str:
    """A number as JavaScript writes it."""
    return (
        str(int(value))
        if value.is_integer() and abs(value) < 1e15
        else orjson.dumps(value).decode()
    )


def percent(share: float) -> str:
    """A share as the page writes it, such as 11.3 %."""
    hundredfold = 100 * share
    if 99.95 < hundredfold < 100:
        return "&gt; 99.9\u00a0%"
    if 0 < hundredfold < 0.05:
        return "&lt; 0.1\u00a0%"
    return f"{hundredfold:.1f}\u00a0%".replace("-", "\u2212")


def _ray(ray: Ray, share: float, passed: float) -> str:
    """The diagram: the unit is half its shorter side, the origin the point of incidence."""
    facts = ray.interface
    incident = _direction(ray.theta_i_deg)
    parts = [
        _medium(facts.n_i, "ray-upper", -50),
        _medium(facts.n_t, "ray-lower", 0),
        _stroke("ray-normal", "M0-.94V.94"),
        _stroke("ray-surface", "M-50 0H50"),
        _stroke("ray-protractor", f"M0-{_LENGTH}A{_LENGTH} {_LENGTH} 0 0 0-{_LENGTH} 0"),
        _line("ray-direction", incident[0], -incident[1]),
        _arrow(-incident[0], -incident[1], 1.0, incoming=True),
        _arrow(incident[0], -incident[1], share),
    ]
    if ray.theta_t_deg is not None and not ray.total_internal_reflection:
        refracted = _direction(ray.theta_t_deg)
        parts += [_line("ray-direction", *refracted), _arrow(*refracted, passed)]
    # Light from the denser side comes from below, as static/js/diagram/diagram.js has it.
    below = facts.k_t == 0.0 and facts.n_i > facts.n_t
    drawn = "".join(parts)
    drawn = f'<g transform="scale(1 -1)">{drawn}</g>' if below else drawn
    said = f"Ray at {ray.theta_i_deg:.2f}°: {100 * share:.1f} % reflected"
    return (
        f'<svg class="diagram first-ray" viewBox="-1 -1 2 2" role="img" aria-label="{escape(said)}">'
        f"{drawn}</svg>"
    )


def _direction(angle_deg: float) -> tuple[float, float]:
    return math.sin(math.radians(angle_deg)), math.cos(math.radians(angle_deg))


def _medium(n: float, name: str, y: int) -> str:
    # as static/js/diagram/scene.js tints it: more with each doubling of the index
    tint = 0.0 if n <= 1 else min(1.0, math.log2(n) / 3)
    return (
        f'<rect class="ray-medium {name}" x="-50" y="{y}" width="100" height="50" '
        f'style="--tint: {100 * tint:.1f}%"/>'
    )


def _stroke(name: str, path: str) -> str:
    return f'<path class="{name} first-stroke" d="{path}"/>'


def _line(name: str, x: float, y: float) -> str:
    return _stroke(name, f"M0 0L{_LENGTH * x:.4f} {_LENGTH * y:.4f}")


def _arrow(x: float, y: float, share: float, *, incoming: bool = False) -> str:
    """An arrow as long and as heavy as its share of the light; the incident one comes in."""
    if share * _LENGTH < 0.004:
        return ""
    length = _LENGTH * share
    head = min(length, (7 + 8 * share) / 210)
    shaft = length if incoming else length - 0.7 * head
    width = 1.25 + 2 * share
    tip, turn = (0.54 * _LENGTH - head / 2, 180.0) if incoming else (length, 0.0)
    angle = math.degrees(math.atan2(y, x)) + turn
    return (
        f'<path class="first-stroke" style="stroke-width:{width * (0.8 if incoming else 1):.2f}" '
        f'd="M0 0L{shaft * x:.4f} {shaft * y:.4f}"/>'
        f'<path class="first-head" d="M0 0L-1-.4L-.78 0L-1 .4Z" transform="translate({tip * x:.4f} '
        f'{tip * y:.4f})rotate({angle:.2f})scale({head:.4f})"/>'
    )


def _curves(found: Curves, ray: Ray, chosen: str) -> str:
    """The plot: curves in a stretched picture, all else placed beside it in shares of its size."""
    angles = found.theta_i_deg
    looks = {"Rs": ("Rs", "solid"), "Rp": ("Rp", "dash"), "R": ("R", "solid")}
    drawn, names = [], []
    for curve in found.curves:
        if curve.model == "exact" and curve.quantity in looks:
            color, dash = looks[curve.quantity]
            name = {"Rs": "R<sub>s</sub>", "Rp": "R<sub>p</sub>"}.get(curve.quantity, "R")
            width = 2.6 if curve.quantity in {chosen, "R"} else 1.9
        elif curve.model != "exact" and curve.quantity == "R":
            color, dash = model_look(curve.model)
            name = escape(curve.model.replace("_", " "))
            width = 1.9
        else:
            continue
        names.append(f'<i style="color:var(--{color})">{name}</i>')
        dashes = _DASHES.get(dash, dash.replace("px", ""))
        dashed = f";stroke-dasharray:{dashes}" if dashes else ""
        drawn.append(
            '<path class="first-curve first-stroke" '
            f'style="stroke:var(--{color});stroke-width:{width}{dashed}" '
            f'd="{_path(angles, curve.values)}"/>'
        )
    levels = [20 * i for i in range(6)]
    ticks = [
        f'<span class="first-line" style="top:{100 - level}%"><span class="first-name">'
        f"{_number(level / 100)}</span></span>"
        for level in levels
    ]
    ticks += [
        f'<span class="first-line first-x" style="left:{100 * degrees / 90:.3f}%">'
        f'<span class="first-name first-name-x">{degrees}°</span></span>'
        for degrees in range(0, 91, 15)
    ]
    at = f"left:{100 * ray.theta_i_deg / 90:.3f}%"
    marker = f'<span class="first-line first-x first-marker" style="{at}"></span>'
    points = "".join(
        f'<span class="first-point" style="{at};top:{100 * (1 - value):.2f}%;'
        f'background:var(--{name})"></span>'
        for name, value in (("Rs", ray.Rs), ("Rp", ray.Rp), ("R", ray.R))
    )
    return (
        '<div class="first-curves" role="img" aria-label="Reflectance against the angle of incidence">'
        f"{''.join(ticks)}{marker}"
        f'<svg viewBox="0 0 {_X} {_Y}" preserveAspectRatio="none" aria-hidden="true">{"".join(drawn)}'
        f'</svg>{points}<span class="first-y-title">reflectance</span>'
        f'<span class="first-key">{" ".join(names)}</span>'
        '<span class="first-x-title">angle of incidence <i>θ<sub>i</sub></i> (degrees)</span></div>'
    )


def _path(angles: Any, values: Any) -> str:
    """A curve in whole units, each point relative to the one before: a third of the bytes."""
    path, at, pen = [], (0, 0), False
    for angle, value in zip(angles, values, strict=True):
        if value is None or not math.isfinite(value):
            pen = False
            continue
        x, y = round(_X * angle / 90), round(_Y * (1 - value))
        path.append(f"l{x - at[0]} {y - at[1]}" if pen else f"M{x} {y}")
        at, pen = (x, y), True
    return "".join(path).replace(" -", "-")
