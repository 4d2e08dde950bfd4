"""R, G and B over the angle: the spectrum's, and those of models that keep three numbers."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from pydantic import Field

from app.api.materials.queries import ColorQuery, swatch_gamut
from app.api.model_parameters import ModelsParameter
from app.http.problems import BadParameters, ParameterError
from app.materials import Spectrum, appearance, color_curve, rgb_constants
from app.optics.amplitudes import reflectance
from app.optics.color import Gamut, apply_gamut, linear_srgb
from app.optics.errors import NotAllowed
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.numerics.quadrature import Nodes, crowded_gauss_legendre
from app.optics.parameters import K_T, N_I, N_T, Array
from app.optics.registry import COLORS, Model, Registry
from app.optics.specular import tint_at_82

CHANNELS = ("red", "green", "blue")
_SPLIT = 0.3  # of the integral over the cosine: half of what happens, happens close to grazing


class RgbQuery(ColorQuery):
    """Whether and how R, G and B are made."""

    rgb: bool = Field(True, description="Whether to add R, G and B.")
    models: ModelsParameter = Field(
        "schlick,f82_tint,exact",
        description="Comma-separated ids of the models that stand beside the spectrum as R, G and "
        "B: `exact` (from n and k averaged to R, G and B), and those whose parameters are F0, F82 "
        "or a tint.",
        examples=["schlick,f82_tint,exact"],
    )
    gamut: Gamut = swatch_gamut("unclamped")

    def refuse_what_is_of_no_use(self) -> None:
        """Refuse what only R, G and B depend on where they are not asked for.

        Raises
        ------
        BadParameters
            Naming each parameter.
        """
        lost = {*RgbQuery.model_fields} - {"rgb"}
        errors: list[ParameterError] = [
            {
                "parameter": name,
                "value": getattr(self, name),
                "message": "given although rgb = false leaves R, G and B out",
            }
            for name in sorted(lost & self.model_fields_set)
        ]
        if errors and not self.rgb:
            raise BadParameters(*errors)


@dataclass(frozen=True, slots=True)
class RgbModel:
    """A curve from three numbers a material: `evaluate(inputs, incidence)`, shape (3, angles)."""

    id: str
    title: str
    inputs: dict[str, Array]
    evaluate: Callable[[Incidence], Array]


def check_models(models: list[Model], registry: Registry) -> None:
    """Refuse models that cannot be given a color.

    Raises
    ------
    NotAllowed
        Naming those that can.
    """
    for model in models:
        if model.id != "exact" and not model.takes_color:
            able = [m.id for m in registry.values() if m.takes_color]
            raise NotAllowed("models", model.id, f"one of {', '.join(('exact', *able))}")


def rgb_models(
    spectrum: Spectrum, n_i: Array | float, models: list[Model], query: RgbQuery
) -> Iterator[RgbModel]:
    """Yield the models with what they are given: F0, F82 and the tint by the gamut policy."""
    how = query.illuminant, query.observer, query.adaptation
    color = appearance(spectrum, n_i, *how)
    F0, F82 = apply_gamut(color.F0, query.gamut), apply_gamut(color.F82, query.gamut)
    colors = {"F0": F0, "F82": F82, "tint": tint_at_82(F0, F82)}
    averaged = _averaged(spectrum, n_i, query)
    inputs: dict[str, Array]
    for model in models:
        if model.id == "exact":
            inputs = {
                "n_i": averaged.n_i.ravel(),
                "n": averaged.n_t.ravel(),
                "k": averaged.k_t.ravel(),
            }
            yield RgbModel("exact", "Exact, from n and k averaged", inputs, _exact(averaged))
        else:
            inputs = {p.name: colors[p.name] for p in model.parameters if p.name in COLORS}
            given = {name: value[:, np.newaxis] for name, value in inputs.items()}
            rest = {p.name: np.asarray(p.default) for p in model.parameters if p.name not in COLORS}
            yield RgbModel(model.id, model.title, inputs, _of(model, averaged, given | rest))


def _averaged(spectrum: Spectrum, n_i: Array | float, query: RgbQuery) -> Interface:
    """Boundary whose constants are averaged over each channel, of shape (3, 1)."""
    how = query.illuminant, query.observer, query.adaptation
    n, k = rgb_constants(spectrum, *how)
    in_front = np.broadcast_to(n_i, spectrum.visible.n.shape)
    front = np.full(3, n_i) if np.ndim(n_i) == 0 else linear_srgb(in_front, *how)
    limited = (
        np.clip(values, bounds.minimum, bounds.maximum)[:, np.newaxis]
        for values, bounds in ((front, N_I), (n, N_T), (k, K_T))
    )
    return Interface(*limited)


def _exact(interface: Interface) -> Callable[[Incidence], Array]:
    return lambda incidence: reflectance(interface, incidence)


def _of(
    model: Model, interface: Interface, arguments: dict[str, Array]
) -> Callable[[Incidence], Array]:
    # Not `model(...)`, which refuses the unclamped F0 above 1 that gold has in red.
    return lambda incidence: model.evaluate(interface, incidence, arguments)


@cache
def hemisphere_nodes() -> Nodes:
    """Cosines with the weights of an integral over them, dense where R turns up, ends included."""
    x, w = crowded_gauss_legendre(96)
    low, high = _SPLIT * x, _SPLIT + (1.0 - _SPLIT) * x
    mu = np.concatenate([[0.0], low, [_SPLIT], high, [1.0]])
    weights = np.concatenate([[0.0], _SPLIT * w, [0.0], (1.0 - _SPLIT) * w, [0.0]])
    return Nodes(mu, weights)


def channel_errors(error: Array, nodes: Nodes) -> dict[str, float | None]:
    """Metrics of one channel's signed error at the nodes; None where the model is undefined."""
    at = int(np.argmax(np.abs(np.nan_to_num(error))))
    values = {
        "max_abs": abs(error[at]),
        "max_abs_at_deg": np.degrees(np.arccos(nodes.mu[at])),
        "error_at_max": error[at],
        "rms": np.sqrt(nodes.w @ error**2),
        "cosine_weighted_mean": 2.0 * (nodes.w @ (nodes.mu * error)),
    }
    defined = bool(np.isfinite(error).all())
    return {name: float(value) if defined else None for name, value in values.items()}


def rgb_json(
    spectrum: Spectrum,
    n_i: Array | float,
    incidence: Incidence,
    models: list[Model],
    query: RgbQuery,
) -> list[dict[str, Any]]:
    """R, G and B of the spectrum and of the models, with errors."""
    how = query.illuminant, query.observer, query.adaptation
    nodes = hemisphere_nodes()
    at_nodes = Incidence.from_cosine(nodes.mu)
    truth = color_curve(spectrum, incidence, n_i, *how).T
    truth_at_nodes = color_curve(spectrum, at_nodes, n_i, *how).T
    color = appearance(spectrum, n_i, *how)
    curves: list[dict[str, Any]] = [
        {
            "model": "spectral",
            "title": "Spectrum, integrated at every angle",
            "inputs": {"F0": color.F0, "F82": color.F82},
            **_channels(truth),
            "errors": None,
        }
    ]
    for model in rgb_models(spectrum, n_i, models, query):
        error = model.evaluate(at_nodes) - truth_at_nodes
        curves.append(
            {
                "model": model.id,
                "title": model.title,
                "inputs": model.inputs,
                **_channels(model.evaluate(incidence)),
                "errors": {
                    name: channel_errors(row, nodes)
                    for name, row in zip(CHANNELS, error, strict=True)
                },
            }
        )
    return curves


def _channels(rows: Array) -> dict[str, Array]:
    return {
        f"R_{name}": np.ascontiguousarray(row) for name, row in zip(CHANNELS, rows, strict=True)
    }
