"""Figures as Plotly objects, drawn from typed answers."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
import plotly.graph_objects as go
from plotly.subplots import make_subplots

from app.answers.albedo_grids import AlbedoSweep
from app.answers.curves import Curves, sampled_incidence
from app.answers.error_grids import ErrorMap, ErrorSweep
from app.answers.errors import Errors
from app.answers.interface import InterfaceFacts
from app.answers.materials.curves import MaterialCurves
from app.answers.materials.spectrum import spectrum
from app.answers.snell import Ray, ray
from app.figures.look import Look
from app.materials.media import default_catalog
from app.optics.amplitudes import power
from app.optics.incidence import Incidence
from app.optics.interface import Interface

DEGREES = {"tickvals": list(range(0, 91, 15)), "range": [0, 90]}
ANGLE = "angle of incidence <i>θ</i><sub>i</sub> (degrees)"
WAVELENGTHS_NM = [step * 10**power for power in range(1, 6) for step in (1, 2, 5)]
_DASHES = {"Rs": "solid", "Rp": "dash", "T": "dot"}
_POLARIZED = {"unpolarized": "R", "s": "Rs", "p": "Rp"}
_SIGNED = ("error", "cosine_weighted_mean", "albedo_error", "error_at_max")


class Named(Protocol):
    """A model or a fit."""

    @property
    def title(self) -> str:
        """What legends call it."""

    @property
    def reference(self) -> str:
        """Whom it is from."""


@dataclass(frozen=True, slots=True)
class Context:
    """What a figure is drawn from, beside the answer."""

    query: Any
    """The query, with its defaults."""
    look: Look
    """Colors and type."""
    named: Mapping[str, Named]
    """Models and fits by id."""

    def title(self, model_id: str, quantity: str = "") -> str:
        """Title of a model or fit, with what follows R in the name of its quantity."""
        return self.named[model_id].title + quantity[1:].replace("_", ", ")


def media(interface: InterfaceFacts) -> str:
    """Name both media: `n = 1 → 1.5`, with a preset's name and wavelength where there is one."""
    front = interface.incident.name if interface.incident else f"{interface.n_i:.6g}"
    k = f" + {interface.k_t:.6g}i" if interface.k_t else ""
    behind = f"{interface.n_t:.6g}{k}"
    if interface.material:
        nm = interface.material.wavelength_nm
        at = "" if nm is None else f" at {nm:g} nm"
        behind = f"{interface.material.name} ({behind}{at})"
    return f"n = {front} → {behind}"


def _numbers(interface: InterfaceFacts) -> Interface:
    """The interface of an answer, with as many digits as the answer has."""
    return Interface(interface.n_i, interface.n_t, interface.k_t)


def _line(x: Any, y: Any, name: str, line: Mapping[str, Any], **more: Any) -> go.Scatter:
    # Lists, for Plotly would send arrays as bytes.
    data = {"x": np.asarray(x).tolist(), "y": np.asarray(y).tolist()}
    return go.Scatter(**data, name=name, mode="lines", line={**line, "simplify": False}, **more)


def _above_and_below(
    figure: go.Figure, x: Any, above: Any, below: Any, name: str, line: Mapping[str, Any]
) -> None:
    """Draw a curve in the upper plot and its error in the lower one, hidden together."""
    figure.add_trace(_line(x, above, name, line, legendgroup=name), row=1, col=1)
    error = _line(x, below, name, line, legendgroup=name, showlegend=False)
    figure.add_trace(error, row=2, col=1)


def _curve_lines(answer: Curves, context: Context) -> list[go.Scatter]:
    """A line for each curve, exact R last and on top."""
    look, lines, exact = context.look, [], []
    for curve in answer.curves:
        model, quantity, points = curve.model, curve.quantity, (answer.theta_i_deg, curve.values)
        if model == "exact" and quantity in _DASHES:
            line = {"color": look.colors[quantity], "dash": _DASHES[quantity], "width": 1.8}
            lines.append(_line(*points, quantity, line))
        elif model == "exact" and quantity == "A":
            lines.append(_line(*points, "A", {"color": look.colors["edge"], "dash": "dashdot"}))
        elif model == "exact" and quantity == "R":
            exact.append(_line(*points, "exact R", look.line("exact")))
        elif quantity.startswith("R"):
            lines.append(_line(*points, context.title(model, quantity), look.line(model)))
    return lines + exact


def _rays(figure: go.Figure, drawn: Ray, look: Look) -> None:
    """Draw one ray at the surface, arrows as long as the power they carry."""
    colors, place = look.colors, {"row": 1, "col": 1}
    lower = {"x0": -1.1, "x1": 1.1, "y0": -1.1, "y1": 0, "fillcolor": colors["rule"]}
    figure.add_shape(type="rect", **lower, line_width=0, layer="below", **place)
    edge = colors["edge"]
    surface, normal = {"color": edge, "width": 1.5}, {"color": edge, "width": 1, "dash": "dash"}
    figure.add_shape(type="line", x0=-1.1, x1=1.1, y0=0, y1=0, line=surface, **place)
    figure.add_shape(type="line", x0=0, x1=0, y0=-1.05, y1=1.05, line=normal, **place)
    x, y = drawn.reflected
    R, T = drawn.R, drawn.T
    arrows = [((-x, y), (0.0, 0.0), colors["ink"], "")]
    arrows.append(((0.0, 0.0), (R * x, R * y), colors["R"], f"R = {R:.4f}"))
    if drawn.refracted is not None:
        u, v = drawn.refracted
        arrows.append(((0.0, 0.0), (T * u, T * v), colors["T"], f"T = {T:.4f}"))
    axes: dict[str, Any] = {"xref": "x", "yref": "y"}
    for (x0, y0), (x1, y1), color, text in arrows:
        if math.hypot(x1 - x0, y1 - y0) > 1e-3:
            ends = {"x": x1, "y": y1, "ax": x0, "ay": y0, "axref": "x", "ayref": "y", **axes}
            head = {"arrowhead": 2, "arrowwidth": 2, "arrowcolor": color}
            figure.add_annotation(**ends, text="", showarrow=True, **head)
        if text:
            at = {"x": 1.05, "y": 0.12 if y1 >= 0 else -0.12, "xanchor": "right", **axes}
            figure.add_annotation(**at, text=text, showarrow=False, font={"color": color})
    hidden = {"visible": False, "range": [-1.1, 1.1], "fixedrange": True}
    figure.update_xaxes(hidden | {"constrain": "domain"}, **place)
    figure.update_yaxes(hidden | {"scaleanchor": "x", "constrain": "domain"}, **place)


def explore(answer: Curves, context: Context) -> go.Figure:
    """One ray and the curves of its surface, with a mark at the ray's angle."""
    look, interface, theta = context.look, answer.interface, context.query.theta_i_deg
    figure = make_subplots(1, 2, column_widths=[0.36, 0.64], horizontal_spacing=0.09)
    coated = context.query.coated()
    _rays(figure, ray(_numbers(interface), Incidence.from_degrees(theta), coated), look)
    for line in _curve_lines(answer, context):
        figure.add_trace(line, row=1, col=2)
    figure.update_xaxes(look.axis(ANGLE, **DEGREES), row=1, col=2)
    figure.update_yaxes(look.axis("share of the power", range=[0, 1.02]), row=1, col=2)
    figure.add_vline(x=theta, line={"color": look.colors["accent"], "width": 1.5}, row=1, col=2)
    marks = (("Brewster", interface.brewster_deg), ("critical", interface.critical_deg))
    for text, angle in marks:
        if angle is not None:
            font = {"size": 0.8 * look.font_px}
            figure.add_vline(
                x=angle,
                line={"color": look.colors["edge"], "width": 1, "dash": "dot"},
                annotation={"text": text, "font": font, "textangle": -90, "xshift": -7},
                annotation_position="top left",
                row=1,
                col=2,
            )
    films = (
        "" if coated is None else f", films {context.query.layers} at {coated.wavelength_nm:g} nm"
    )
    title = f"Reflection at {theta:g}°, {media(interface)}{films}"
    figure.update_layout(look.layout(), title_text=title)
    return figure


def compare(answer: Errors, context: Context) -> go.Figure:
    """Models over the exact curve, and their signed errors below."""
    look, query, theta = context.look, context.query, answer.theta_i_deg
    interface = _numbers(answer.interface)
    exact = power(interface, sampled_incidence(interface, query.samples, query.landmarks)).R
    figure = make_subplots(2, 1, shared_xaxes=True, row_heights=[0.62, 0.38], vertical_spacing=0.06)
    for row in answer.errors:
        name, line = context.title(row.model, row.quantity), look.line(row.model)
        _above_and_below(figure, theta, row.error + exact, row.error, name, line)
    figure.add_trace(_line(theta, exact, "exact", look.line("exact")), row=1, col=1)
    figure.update_xaxes(look.axis("", **DEGREES), row=1, col=1)
    figure.update_xaxes(look.axis(ANGLE, **DEGREES), row=2, col=1)
    figure.update_yaxes(look.axis("reflectance R", range=[0, 1.02]), row=1, col=1)
    figure.update_yaxes(look.axis("error"), row=2, col=1)
    title = f"Approximations and exact, {media(answer.interface)}"
    figure.update_layout(look.layout(), title_text=title)
    return figure


_AXES = {
    "theta_i_deg": ANGLE,
    "n_t": "n<sub>t</sub>",
    "k_t": "k<sub>t</sub>",
    "eta": "n<sub>t</sub> / n<sub>i</sub>",
    "n_i": "n<sub>i</sub>",
}


def errors(answer: ErrorMap, context: Context) -> go.Figure:
    """Heat map of one model's error."""
    look, x, y = context.look, answer.x, answer.y
    sizes = np.abs(answer.values[np.isfinite(answer.values)])
    largest = float(sizes.max(initial=0.0)) or 1.0
    signed = answer.metric in _SIGNED
    middle = look.background if look.ground != "transparent" else "#ffffff"
    blue, red = look.colors["Rs"], look.colors["Rp"]
    heat = go.Heatmap(
        x=x.values.tolist(),
        y=y.values.tolist(),
        z=answer.values.tolist(),
        zmin=-largest if signed else 0.0,
        zmax=largest,
        colorscale=[[0.0, blue], [0.5, middle], [1.0, red]]
        if signed
        else [[0.0, middle], [1.0, red]],
        colorbar={"title": {"text": answer.metric}, "outlinewidth": 0, "thickness": 14},
        hovertemplate=f"{x.name} = %{{x:.4g}}<br>{y.name} = %{{y:.4g}}<br>%{{z:.4g}}"
        "<extra></extra>",
    )
    figure = go.Figure(heat)
    figure.update_xaxes(look.axis(_AXES[x.name], **(DEGREES if x.name == "theta_i_deg" else {})))
    figure.update_yaxes(look.axis(_AXES[y.name]))
    title = f"{context.title(answer.model)}: {answer.metric.replace('_', ' ')}"
    figure.update_layout(look.layout(), title_text=title, hovermode="closest")
    return figure


def sweep(answer: ErrorSweep, context: Context) -> go.Figure:
    """A model's errors along a line of surfaces."""
    look, x = context.look, answer.values
    figure = go.Figure()
    rms = {"color": look.colors["Rs"], "dash": "dash", "width": 2}
    albedo_error = {"color": look.colors["Rp"], "dash": "dot", "width": 2}
    figure.add_trace(_line(x, answer.max_abs, "largest error", look.line("exact")))
    figure.add_trace(_line(x, answer.rms, "root mean square", rms))
    figure.add_trace(_line(x, answer.albedo_error, "error of the albedo", albedo_error))
    figure.update_xaxes(look.axis(_AXES[answer.over], type=context.query.scale))
    figure.update_yaxes(look.axis("error"))
    title = f"{context.title(answer.model)}: errors over {answer.over}"
    figure.update_layout(look.layout(), title_text=title)
    return figure


def albedo(answer: AlbedoSweep, context: Context) -> go.Figure:
    """Albedos along a line of surfaces, and the errors of fits and models below."""
    look, x = context.look, answer.values
    others = [curve for curve in answer.curves if curve.kind in ("fit", "model")]
    rows = 2 if others else 1
    heights = [0.62, 0.38] if others else [1.0]
    figure = make_subplots(rows, 1, shared_xaxes=True, row_heights=heights, vertical_spacing=0.06)
    for curve in answer.curves:
        if curve.kind == "exact":
            quantity = _POLARIZED[curve.quantity]
            line = {
                "color": look.colors[quantity],
                "dash": "dash" if quantity == "Rp" else "solid",
                "width": 2.6 if quantity == "R" else 1.6,
            }
            figure.add_trace(_line(x, curve.values, f"exact, {curve.quantity}", line), row=1, col=1)
    for place, curve in enumerate(others):
        dash = ("dash", "dot", "dashdot")[place % 3]
        line = {"color": look.color_at(place), "dash": dash, "width": 2}
        name = context.title(curve.id)
        _above_and_below(figure, x, curve.values, curve.error, name, line)
    for row in range(1, rows + 1):
        title = _AXES[answer.over] if row == rows else ""
        figure.update_xaxes(look.axis(title, type=context.query.scale), row=row, col=1)
        figure.update_yaxes(look.axis("albedo" if row == 1 else "error"), row=row, col=1)
    figure.update_layout(look.layout(), title_text=f"Hemispherical albedo over {answer.over}")
    return figure


def material(answer: MaterialCurves, context: Context) -> go.Figure:
    """Reflectance of a material over the angle at its wavelengths, and n and k beside it."""
    look, told = context.look, answer.material
    constants = spectrum(default_catalog().get(told.id))
    figure = make_subplots(1, 2, horizontal_spacing=0.1, column_widths=[0.58, 0.42])
    for place, curve in enumerate(answer.wavelengths):
        line = {"color": look.color_at(place), "width": 2}
        name = f"{curve.wavelength_nm:g} nm"
        figure.add_trace(_line(answer.theta_i_deg, curve.R, name, line), row=1, col=1)
    for name, values, color, dash in (
        ("n", constants.n, "Rs", "solid"),
        ("k", constants.k, "Rp", "dash"),
    ):
        if values is not None:
            line = {"color": look.colors[color], "dash": dash, "width": 2}
            figure.add_trace(_line(constants.wavelength_nm, values, name, line), row=1, col=2)
    figure.update_xaxes(look.axis(ANGLE, **DEGREES), row=1, col=1)
    figure.update_yaxes(look.axis("reflectance R", range=[0, 1.02]), row=1, col=1)
    wavelengths = look.axis("wavelength (nm)", type="log", tickvals=WAVELENGTHS_NM)
    figure.update_xaxes(wavelengths, row=1, col=2)
    figure.update_yaxes(look.axis("n and k"), row=1, col=2)
    figure.update_layout(look.layout(), title_text=f"{told.name}: reflectance, n and k")
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
    size, room = 0.78 * look.font_px, 4.4 * look.font_px
    names = [str(t.name) for t in figure.data if t.name and t.showlegend is not False]
    taken = sum(0.55 * look.font_px * len(name) + 50.0 for name in names)
    rows = math.ceil(taken / (width - 90.0)) if len(names) > 1 else 0
    above, below = (3.2 + 1.7 * rows) * look.font_px, room + 1.5 * size * len(lines)
    place = {"x": 0, "y": 1.01, "xanchor": "left", "yanchor": "bottom"}
    figure.update_layout(
        margin={"l": 5.0 * look.font_px, "r": 24, "t": above, "b": below},
        title={"yref": "container", "y": 1.0, "yanchor": "top", "pad": {"t": look.font_px}},
        legend={"orientation": "h", "tracegroupgap": 0, **place},
    )
    if lines:
        corner = {"x": 0, "y": 0, "xref": "paper", "yref": "paper"}
        figure.add_annotation(
            text="<br>".join(lines),
            **corner,
            xanchor="left",
            yanchor="top",
            xshift=-3.0 * look.font_px,
            yshift=0.4 * look.font_px - room,
            align="left",
            showarrow=False,
            font={"size": size, "color": look.colors["muted"]},
        )
    return figure
