"""R, G and B over the angle: the spectrum's, and those of models that keep three numbers."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cache, partial

import numpy as np

from app.answers.answer import Gaps, answer
from app.answers.curves import COLORS
from app.answers.materials.about import Rgb
from app.answers.materials.detail import Seen
from app.materials.appearance import Viewing, appearance, averaged_interface, color_curve
from app.materials.rgb_models import color_arguments, color_given, rgb_title
from app.materials.spectrum import Spectrum
from app.optics.color import Gamut
from app.optics.hemisphere import hemisphere
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.metrics import cosine_weighted_mean, root_mean_square
from app.optics.numerics.peaks import largest
from app.optics.numerics.quadrature import Nodes, crowded_gauss_legendre
from app.optics.parameters import Array
from app.optics.registry import Model

_Own = Mapping[str, Array]


@answer
class ChannelError:
    """Error against the spectrum, over the hemisphere; null where the model is undefined."""

    max_abs: float | None
    """Largest absolute error, sought between the angles too."""
    max_abs_at_deg: float | None
    error_at_max: float | None
    """Signed error there."""
    rms: float | None
    """Root mean square, each solid angle alike."""
    cosine_weighted_mean: float | None
    """Signed: the error of the albedo."""

    @classmethod
    def of(cls, error_at: Callable[[Array], Array], error: Array, nodes: Nodes) -> ChannelError:
        """Measure one channel's signed error, of cosines and at the nodes."""
        peak = largest(error_at, nodes.mu, np.nan_to_num(error)[np.newaxis], points=7, rounds=4)
        value, mu = peak.value[0], peak.at[0]
        measured = {
            "max_abs": abs(value),
            "max_abs_at_deg": np.degrees(np.arccos(mu)),
            "error_at_max": value,
            "rms": root_mean_square(error, nodes),
            "cosine_weighted_mean": cosine_weighted_mean(error, nodes),
        }
        defined = bool(np.isfinite(error).all())
        return cls(**{name: float(value) if defined else None for name, value in measured.items()})


@answer
class ChannelErrors:
    """Errors of the three channels."""

    red: ChannelError
    green: ChannelError
    blue: ChannelError


@answer
class RgbCurve:
    """R, G and B over the angle, by the spectrum or by what a renderer makes of three numbers."""

    model: str
    """`spectral` is the truth; others are ids of /models."""
    title: str
    inputs: dict[str, Rgb]
    """What the model was given, of the light's white; of `spectral` the colors as they are seen."""
    R_red: Gaps
    R_green: Gaps
    R_blue: Gaps
    errors: ChannelErrors | None
    """Null for the truth."""


@answer
class RgbCurves(Seen):
    """Curves in linear sRGB."""

    gamut: Gamut
    """Applied to the colors that the models are given; no curve is clamped."""
    white: Rgb
    """The perfect reflector in this light, linear sRGB: 1 unless the light keeps its cast. Models
    take what is reflected of it, and their R times it is their curve."""
    curves: list[RgbCurve]


def rgb_curves(
    spectrum: Spectrum,
    n_i: Array | float,
    incidence: Incidence,
    models: Sequence[Model],
    viewing: Viewing,
    gamut: Gamut,
) -> RgbCurves:
    """Evaluate R, G and B of the spectrum and of models, with their errors.

    Parameters
    ----------
    spectrum, n_i
        The material and the index in front of it, as `color_curve` takes them.
    incidence
        The angles.
    models
        `exact`, from n and k averaged over each channel, and models that take a color.
    viewing
        How the channels are made.
    gamut
        What is done about the colors that models are given.
    """
    nodes = _nodes()
    at_nodes = Incidence.from_cosine(nodes.mu)
    truth_at_nodes = color_curve(spectrum, at_nodes, n_i, viewing).T
    color = appearance(spectrum, n_i, viewing)
    shown = color.of_white().within(gamut)
    averaged = averaged_interface(spectrum, n_i, viewing)
    white = color.white[:, np.newaxis]
    curves = [
        RgbCurve(
            model="spectral",
            title="Spectrum, integrated at every angle",
            inputs={"F0": color.F0, "F82": color.F82},
            **_channels(color_curve(spectrum, incidence, n_i, viewing).T),
            errors=None,
        )
    ]
    for model in models:
        given, arguments = color_given(model, shown), color_arguments(model, shown)
        if model.id == "exact":
            constants = {"n_i": averaged.n_i, "n": averaged.n_t, "k": averaged.k_t}
            given = {name: value.ravel() for name, value in constants.items()}
        # Not `model(...)`, which refuses the unclamped F0 above 1 that gold has in red.
        error = white * model.evaluate(averaged, at_nodes, arguments) - truth_at_nodes

        def error_at(mu: Array, channel: int, model: Model = model, own: _Own = arguments) -> Array:
            at = Incidence.from_cosine(mu.ravel())
            truth = color_curve(spectrum, at, n_i, viewing)[:, channel]
            error = (white * model.evaluate(averaged, at, own))[channel] - truth
            return np.asarray(error.reshape(mu.shape))

        red, green, blue = (
            ChannelError.of(partial(error_at, channel=channel), row, nodes)
            for channel, row in enumerate(error)
        )
        curves.append(
            RgbCurve(
                model=model.id,
                title=rgb_title(model),
                inputs=given,
                **_channels(white * model.evaluate(averaged, incidence, arguments)),
                errors=ChannelErrors(red=red, green=green, blue=blue),
            )
        )
    return RgbCurves(**viewing._asdict(), gamut=gamut, white=color.white, curves=curves)


@cache
def _nodes() -> Nodes:
    """Nodes that are fit for all materials: dense at both ends and where glass turns up."""
    return hemisphere(Interface(), crowded_gauss_legendre(96))


def _channels(rows: Array) -> dict[str, Array]:
    return dict(zip(COLORS, map(np.ascontiguousarray, rows), strict=True))
