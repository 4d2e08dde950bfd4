"""eta cos(theta_i) - sin(theta_i) with all its digits, near Brewster's angle too."""

from __future__ import annotations

import numpy as np

from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.parameters import Array


def brewster_factor(interface: Interface, incidence: Incidence) -> Array:
    """Placeholder, replaced by the compensated form."""
    return np.asarray(interface.eta * incidence.cos - incidence.sin)
