"""Figures as Plotly objects, drawn from what the API's routes answer."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any
from urllib.parse import urlencode

import plotly.graph_objects as go
from plotly.subplots import make_subplots

from app.figures.look import Look

DEGREES = {"tickvals": list(range(0, 91, 15)), "range": [0, 90]}
ANGLE = "angle of incidence <i>θ</i><sub>i</sub> (degrees)"
WAVELENGTHS_NM = [step * 10**power for power in range(1, 6) for step in (1, 2, 5)]
_QUANTITIES = {"Rs": "Rs", "Rp": "Rp", "T": "T"}
_DASHES = {"Rs": "solid", "Rp": "dash", "T": "dot"}


@dataclass(frozen=True, slots=True)
class Context:
    """What a figure is drawn from, beside the answer."""

    ask: Callable[[str], Any]
    """Answer of another route by its path and query."""
    query: Any
    """The query, with its defaults."""
    look: Look
    """Colors and type."""
    titles: Mapping[str, str]
    """Titles of the models by id."""


def media(interface: Mapping[str, Any]) -> str:
    """Name both media: `n = 1 → 1.5`, with the presets' names where there are any."""
    front = interface["incident"]["name"] if interface["incident"] else f"{interface['n_i']:.6g}"
    k = f" + {interface['k_t']:.6g}i" if interface["k_t"] else ""
    behind = f"{interface['n_t']:.6g}{k}"
    if interface["material"]:
        behind = f"{interface['material']['name']} ({behind})"
    return f"n = {front} → {behind}"


def numbers(interface: Mapping[str, Any], **more: Any) -> str:
    """Query of the interface as numbers, for another route."""
    return urlencode({name: interface[name] for name in ("n_i", "n_t", "k_t")} | more)


def _line(x: Any, y: Any, name: str, line: Mapping[str, Any], **more: Any) -> go.Scatter:
    shown = {**line, "simplify": False}
    return go.Scatter(x=x, y=y, name=name, mode="lines", line=shown, **more)


def _curve_lines(answer: Mapping[str, Any], context: Context) -> list[go.Scatter]:
    """A line for each curve of a `/curves` answer, exact R last and on top."""
    look, lines, exact = context.look, [], []
    for curve in answer["curves"]:
        model, quantity = curve["model"], curve["quantity"]
        if model == "exact" and quantity in _QUANTITIES:
            line = {"color": look.colors[quantity], "dash": _DASHES[quantity], "width": 1.8}
            lines.append(_line(answer["theta_i_deg"], curve["values"], quantity, line))
        elif model == "exact" and quantity == "R":
            exact.append(
                _line(answer["theta_i_deg"], curve["values"], "exact R", look.line("exact"))
            )
        elif quantity.startswith("R"):
            name = context.titles[model] + quantity[1:].replace("_", ", ")
            lines.append(_line(answer["theta_i_deg"], curve["values"], name, look.line(model)))
    return lines + exact


def _rays(figure: go.Figure, ray: Mapping[str, Any], look: Look) -> None:
    """Draw one ray at the surface, arrows as long as the power they carry."""
    colors = look.colors
    figure.add_shape(
        type="rect",
        x0=-1.1,
        x1=1.1,
        y0=-1.1,
        y1=0,
        fillcolor=colors["rule"],
        line_width=0,
        layer="below",
        row=1,
        col=1,
    )
    figure.add_shape(
        type="line",
        x0=-1.1,
        x1=1.1,
        y0=0,
        y1=0,
        line={"color": colors["edge"], "width": 1.5},
        row=1,
        col=1,
    )
    figure.add_shape(
        type="line",
        x0=0,
        x1=0,
        y0=-1.05,
        y1=1.05,
        line={"color": colors["edge"], "width": 1, "dash": "dash"},
        row=1,
        col=1,
    )
    x, y = ray["reflected"]
    arrows = [((-x, y), (0.0, 0.0), colors["ink"], "")]
    arrows.append(((0.0, 0.0), (ray["R"] * x, ray["R"] * y), colors["R"], f"R = {ray['R']:.4f}"))
    if ray["refracted"] is not None:
        (u, v), T = ray["refracted"], ray["T"]
        arrows.append(((0.0, 0.0), (T * u, T * v), colors["T"], f"T = {T:.4f}"))
    for (x0, y0), (x1, y1), color, text in arrows:
        if math.hypot(x1 - x0, y1 - y0) > 1e-3:
            figure.add_annotation(
                x=x1,
                y=y1,
                ax=x0,
                ay=y0,
                xref="x",
                yref="y",
                axref="x",
                ayref="y",
                text="",
                showarrow=True,
                arrowhead=2,
                arrowwidth=2,
                arrowcolor=color,
            )
        if text:
            figure.add_annotation(
                x=1.05,
                y=0.12 if y1 >= 0 else -0.12,
                xref="x",
                yref="y",
                text=text,
                showarrow=False,
                xanchor="right",
                font={"color": color},
            )
    hidden = {"visible": False, "range": [-1.1, 1.1], "fixedrange": True}
    figure.update_xaxes(hidden | {"constrain": "domain"}, row=1, col=1)
    figure.update_yaxes(hidden | {"scaleanchor": "x", "constrain": "domain"}, row=1, col=1)


def explore(answer: Mapping[str, Any], context: Context) -> go.Figure:
    """One ray and the curves of its surface, with a mark at the ray's angle."""
    look, interface = context.look, answer["interface"]
    theta = context.query.theta_i_deg
    ray = context.ask(f"/snell?{numbers(interface, theta_i_deg=theta)}")
    figure = make_subplots(1, 2, column_widths=[0.36, 0.64], horizontal_spacing=0.09)
    _rays(figure, ray, look)
    for line in _curve_lines(answer, context):
        figure.add_trace(line, row=1, col=2)
    figure.update_xaxes(look.axis(ANGLE, **DEGREES), row=1, col=2)
    figure.update_yaxes(look.axis("share of the power", range=[0, 1.02]), row=1, col=2)
    figure.add_vline(x=theta, line={"color": look.colors["accent"], "width": 1.5}, row=1, col=2)
    marks = [("Brewster", "brewster_deg"), ("critical", "critical_deg")]
    for name, key in marks:
        if interface[key] is not None:
            figure.add_vline(
                x=interface[key],
                line={"color": look.colors["edge"], "width": 1, "dash": "dot"},
                annotation={
                    "text": name,
                    "font": {"size": 0.8 * look.font_px},
                    "textangle": -90,
                    "xshift": -7,
                },
                annotation_position="top left",
                row=1,
                col=2,
            )
    figure.update_layout(look.layout(), title_text=f"Reflection at {theta:g}°, {media(interface)}")
    return figure


def compare(answer: Mapping[str, Any], context: Context) -> go.Figure:
    """Models over the exact curve, and their signed errors below."""
    look, interface, theta = context.look, answer["interface"], answer["theta_i_deg"]
    landmarks = str(context.query.landmarks).lower()
    query = numbers(interface, samples=context.query.samples, landmarks=landmarks)
    (exact,) = (
        c["values"] for c in context.ask(f"/curves?{query}")["curves"] if c["quantity"] == "R"
    )
    figure = make_subplots(2, 1, shared_xaxes=True, row_heights=[0.62, 0.38], vertical_spacing=0.06)
    for row in answer["errors"]:
        name = context.titles[row["model"]] + row["quantity"][1:].replace("_", ", ")
        line = look.line(row["model"])
        R = [None if e is None else e + r for e, r in zip(row["error"], exact, strict=True)]
        figure.add_trace(_line(theta, R, name, line, legendgroup=name), row=1, col=1)
        figure.add_trace(
            _line(theta, row["error"], name, line, legendgroup=name, showlegend=False), row=2, col=1
        )
    figure.add_trace(_line(theta, exact, "exact", look.line("exact")), row=1, col=1)
    figure.update_xaxes(look.axis("", **DEGREES), row=1, col=1)
    figure.update_xaxes(look.axis(ANGLE, **DEGREES), row=2, col=1)
    figure.update_yaxes(look.axis("reflectance R", range=[0, 1.02]), row=1, col=1)
    figure.update_yaxes(look.axis("error"), row=2, col=1)
    figure.update_layout(look.layout(), title_text=f"Approximations and exact, {media(interface)}")
    return figure


_AXES = {
    "theta_i_deg": ANGLE,
    "n_t": "n<sub>t</sub>",
    "k_t": "k<sub>t</sub>",
    "eta": "n<sub>t</sub> / n<sub>i</sub>",
    "n_i": "n<sub>i</sub>",
}


def errors(answer: Mapping[str, Any], context: Context) -> go.Figure:
    """Heat map of one model's error."""
    look, x, y = context.look, answer["x"], answer["y"]
    sizes = [abs(v) for row in answer["values"] for v in row if v is not None]
    largest = max(sizes, default=1.0) or 1.0
    signed = answer["metric"] in ("error", "cosine_weighted_mean", "albedo_error", "error_at_max")
    scale = [
        [0.0, look.colors["Rs"]],
        [0.5, look.background if look.ground != "transparent" else "#ffffff"],
        [1.0, look.colors["Rp"]],
    ]
    heat = go.Heatmap(
        x=x["values"],
        y=y["values"],
        z=answer["values"],
        zmin=-largest if signed else 0.0,
        zmax=largest,
        colorscale=scale if signed else [[0.0, scale[1][1]], [1.0, look.colors["Rp"]]],
        colorbar={"title": {"text": answer["metric"]}, "outlinewidth": 0, "thickness": 14},
        hovertemplate=f"{x['name']} = %{{x:.4g}}<br>{y['name']} = %{{y:.4g}}<br>%{{z:.4g}}"
        "<extra></extra>",
    )
    figure = go.Figure(heat)
    figure.update_xaxes(
        look.axis(_AXES[x["name"]], **(DEGREES if x["name"] == "theta_i_deg" else {}))
    )
    figure.update_yaxes(look.axis(_AXES[y["name"]]))
    title = f"{context.titles[answer['model']]}: {answer['metric'].replace('_', ' ')}"
    figure.update_layout(look.layout(), title_text=title, hovermode="closest")
    return figure


def sweep(answer: Mapping[str, Any], context: Context) -> go.Figure:
    """A model's errors along a line of surfaces."""
    look = context.look
    figure = go.Figure()
    named = (
        ("max_abs", "largest error", look.line("exact")),
        ("rms", "root mean square", {"color": look.colors["Rs"], "dash": "dash", "width": 2}),
        (
            "albedo_error",
            "error of the albedo",
            {"color": look.colors["Rp"], "dash": "dot", "width": 2},
        ),
    )
    for metric, name, line in named:
        figure.add_trace(_line(answer["values"], answer[metric], name, line))
    scale = "log" if context.query.scale == "log" else "linear"
    figure.update_xaxes(look.axis(_AXES[answer["over"]], type=scale))
    figure.update_yaxes(look.axis("error"))
    title = f"{context.titles[answer['model']]}: errors over {answer['over']}"
    figure.update_layout(look.layout(), title_text=title)
    return figure


def albedo(answer: Mapping[str, Any], context: Context) -> go.Figure:
    """Albedos along a line of surfaces, and the errors of fits and models below."""
    look, x = context.look, answer["values"]
    others = [c for c in answer["curves"] if c["kind"] in ("fit", "model")]
    rows = 2 if others else 1
    heights = [0.62, 0.38] if others else [1.0]
    figure = make_subplots(rows, 1, shared_xaxes=True, row_heights=heights, vertical_spacing=0.06)
    for curve in answer["curves"]:
        if curve["kind"] == "exact":
            quantity = {"unpolarized": "R", "s": "Rs", "p": "Rp"}[curve["quantity"]]
            dash = {"R": "solid", "Rs": "solid", "Rp": "dash"}[quantity]
            line = {
                "color": look.colors[quantity],
                "dash": dash,
                "width": 2.6 if quantity == "R" else 1.6,
            }
            figure.add_trace(
                _line(x, curve["values"], f"exact, {curve['quantity']}", line), row=1, col=1
            )
        elif curve["kind"] not in ("fit", "model"):
            line = {"color": look.colors["muted"], "dash": "dashdot", "width": 1.6}
            figure.add_trace(_line(x, curve["values"], curve["id"], line), row=1, col=1)
    for place, curve in enumerate(others):
        name = context.titles[curve["id"]]
        line = {
            "color": look.colors[f"model-{place % 8 + 1}"],
            "dash": ("dash", "dot", "dashdot")[place % 3],
            "width": 2,
        }
        figure.add_trace(_line(x, curve["values"], name, line, legendgroup=name), row=1, col=1)
        figure.add_trace(
            _line(x, curve["error"], name, line, legendgroup=name, showlegend=False), row=2, col=1
        )
    scale = "log" if context.query.scale == "log" else "linear"
    for row in range(1, rows + 1):
        title = _AXES[answer["over"]] if row == rows else ""
        figure.update_xaxes(look.axis(title, type=scale), row=row, col=1)
        figure.update_yaxes(look.axis("albedo" if row == 1 else "error"), row=row, col=1)
    figure.update_layout(look.layout(), title_text=f"Hemispherical albedo over {answer['over']}")
    return figure


def material(answer: Mapping[str, Any], context: Context) -> go.Figure:
    """Reflectance of a material over the angle at its wavelengths, and n and k beside it."""
    look, told = context.look, answer["material"]
    spectrum = context.ask(f"/materials/{told['id']}/spectrum")
    figure = make_subplots(1, 2, horizontal_spacing=0.1, column_widths=[0.58, 0.42])
    for place, curve in enumerate(answer["wavelengths"]):
        line = {"color": look.colors[f"model-{place % 8 + 1}"], "width": 2}
        name = f"{curve['wavelength_nm']:g} nm"
        figure.add_trace(_line(answer["theta_i_deg"], curve["R"], name, line), row=1, col=1)
    for quantity, color, dash in (("n", "Rs", "solid"), ("k", "Rp", "dash")):
        if spectrum[quantity] is not None:
            line = {"color": look.colors[color], "dash": dash, "width": 2}
            figure.add_trace(
                _line(spectrum["wavelength_nm"], spectrum[quantity], quantity, line), row=1, col=2
            )
    figure.update_xaxes(look.axis(ANGLE, **DEGREES), row=1, col=1)
    figure.update_yaxes(look.axis("reflectance R", range=[0, 1.02]), row=1, col=1)
    figure.update_xaxes(
        look.axis("wavelength (nm)", type="log", tickvals=WAVELENGTHS_NM), row=1, col=2
    )
    figure.update_yaxes(look.axis("n and k"), row=1, col=2)
    figure.update_layout(look.layout(), title_text=f"{told['name']}: reflectance, n and k")
    figure.update_layout(hovermode="closest")
    return figure


def framed(figure: go.Figure, lines: list[str], look: Look, width: int) -> go.Figure:
    """Make room for the legend above a figure and for lines of text below it.

    Parameters
    ----------
    figure
        Changed in place.
    lines
        Caption, written below the plot.
    look
        Its type.
    width
        Which the legend's rows are counted for, in px.
    """
    size = 0.78 * look.font_px
    names = [str(t.name) for t in figure.data if t.name and t.showlegend is not False]
    taken = sum(0.55 * look.font_px * len(name) + 50.0 for name in names)
    rows = math.ceil(taken / (width - 90.0)) if len(names) > 1 else 0
    room = 4.4 * look.font_px
    figure.update_layout(
        margin={
            "l": 5.0 * look.font_px,
            "r": 24,
            "t": (3.2 + 1.7 * rows) * look.font_px,
            "b": room + 1.5 * size * len(lines),
        },
        title={"yref": "container", "y": 1.0, "yanchor": "top", "pad": {"t": look.font_px}},
        legend={
            "orientation": "h",
            "tracegroupgap": 0,
            "x": 0,
            "y": 1.01,
            "xanchor": "left",
            "yanchor": "bottom",
        },
    )
    if lines:
        figure.add_annotation(
            text="<br>".join(lines),
            xref="paper",
            yref="paper",
            x=0,
            y=0,
            xanchor="left",
            yanchor="top",
            xshift=-3.0 * look.font_px,
            yshift=0.4 * look.font_px - room,
            align="left",
            showarrow=False,
            font={"size": size, "color": look.colors["muted"]},
        )
    return figure
