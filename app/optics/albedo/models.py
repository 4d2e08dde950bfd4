"""Albedo of any registered model."""

import numpy as np
from numpy.typing import ArrayLike

from app.optics.albedo.exact import albedo
from app.optics.interface import Interface
from app.optics.metrics import Metric, measure
from app.optics.parameters import Array
from app.optics.registry import Model

_MEAN_ERROR: tuple[Metric, ...] = ("cosine_weighted_mean",)


def model_albedo(model: Model, interface: Interface, **parameters: ArrayLike | None) -> Array:
    """Hemispherical albedo of a model's curve, 2 int R sin cos dtheta.

    The exact albedo plus the quadrature of the model's error, which resolves the critical angle
    and the model's own kinks.

    Parameters
    ----------
    model
        Any registered model.
    interface
        Any shape.
    **parameters
        The model's own parameters; those left out are solved from the interface.

    Returns
    -------
    Array
        Of the broadcast shape of interface and parameters; NaN where the model is undefined over a
        range of angles.

    Raises
    ------
    NotAllowed, OutOfRange
        If a parameter is not the model's own or out of its bounds.

    Examples
    --------
    >>> from app.optics.registry import default_registry
    >>> schlick = model_albedo(default_registry()["schlick"], Interface(n_t=1.5))
    >>> bool(abs(schlick - (0.04 + 0.96 / 21)) < 1e-12)
    True
    """
    arguments = model.arguments(interface, **parameters)
    error = measure(model, interface, arguments, wanted=_MEAN_ERROR)
    return np.asarray(albedo(interface).unpolarized + error["cosine_weighted_mean"])
