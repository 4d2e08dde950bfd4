"""One file a model; each exposes `MODEL`, and `app.optics.registry` finds them.

What the file of a model needs is imported from here.
"""

from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.parameters import RGB, Array, Parameter, share
from app.optics.registry import Cost, Measured, Model

__all__ = [
    "RGB",
    "Array",
    "Cost",
    "Incidence",
    "Interface",
    "Measured",
    "Model",
    "Parameter",
    "share",
]
