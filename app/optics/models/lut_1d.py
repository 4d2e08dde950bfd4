"""Wloka's lookup texture: exact R tabulated over cos(theta_i)."""

import numpy as np

from app.optics.amplitudes import reflectance
from app.optics.errors import NotAllowed
from app.optics.formulas.formula import Symbol
from app.optics.lookup import Depth, quantize
from app.optics.models import Array, Cost, Incidence, Interface, Measured, Model, Parameter

SIZE = Parameter("size", "N", 256, 2, 4096, "texels", "Texels of the table.", integer=True)
BITS = Parameter(
    "bits",
    "b",
    32,
    8,
    32,
    "bit",
    "Depth of a texel: 8 or 16 bits as integers from 0 to 1, or a 32 bit float.",
    choices=(("8", 8), ("16", 16), ("32", 32)),
)
DEPTHS: dict[int, Depth] = {8: "unorm8", 16: "unorm16", 32: "float"}
FILTERING = Parameter(
    "filtering",
    r"\text{filter}",
    1,
    0,
    1,
    "",
    "How a value between two texels is read: the nearest texel, or linearly interpolated.",
    choices=(("nearest", 0), ("linear", 1)),
)


def lut_1d(
    interface: Interface, incidence: Incidence, size: Array, bits: Array, filtering: Array
) -> Array:
    """Read the table at cos(theta_i): texels j = 0 ... N - 1 hold R at mu = j / (N - 1)."""
    at = np.linspace(0.0, 1.0, _one("size", size))
    depth = DEPTHS[_one("bits", bits)]
    position = incidence.cos * (at.size - 1)

    def texel(index: Array) -> Array:
        # Only those that are read: the whole tables of many interfaces would fill the memory.
        mu = at[index.astype(np.intp)]
        return quantize(reflectance(interface, Incidence.from_cosine(mu)), depth)

    if _one("filtering", filtering) == 0:
        return texel(np.floor(position + 0.5))
    low = np.minimum(np.floor(position), at.size - 2)
    fraction = position - low
    return np.asarray((1.0 - fraction) * texel(low) + fraction * texel(low + 1.0))


def _one(name: str, value: Array) -> int:
    if value.ndim:
        raise NotAllowed(f"lut_1d.{name}", value.tolist(), "one number for all")
    return int(value)


def _kinks(size: Array, filtering: Array, **_: Array) -> Array:
    texels = _one("size", size)
    if _one("filtering", filtering) == 0:
        return np.asarray((np.arange(texels - 1) + 0.5) / (texels - 1))
    return np.linspace(0.0, 1.0, texels)[1:-1]


MODEL = Model(
    id="lut_1d",
    title="Lookup texture",
    latex=r"R\approx(1-f)\,T_j+f\,T_{j+1},\quad j+f=\mu\,(N-1),\quad "
    r"T_j=R_\text{exact}\!\left(\arccos\tfrac{j}{N-1}\right)",
    symbols=(Symbol("T_{j+1}", "next texel"),),
    reference="M. Wloka, Fresnel Reflection, NVIDIA technical report (2002), figures 10, 11 and 13",
    validity="Every interface, one table each. The error is the curve's bend between two texels, "
    "largest at grazing incidence and at a critical angle, plus half a step of the depth. A shader "
    "has to read at (mu (N - 1) + 1/2) / N to hit the texels' centers.",
    cost=Cost(lookup=1),
    function=lut_1d,
    parameters=(SIZE, BITS, FILTERING),
    kinks=_kinks,
    snippet="it is read from a table, which /lut makes",
    measured=(
        Measured(1, 1.333, 0, max_abs=8.11e-05, at_deg=89.9, rms=1.6e-05),
        Measured(1, 2.9, 3, max_abs=0.000134, at_deg=89.9, rms=2.16e-05),
    ),
)
