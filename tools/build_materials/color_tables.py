"""The CIE tables of `app/optics/color.py`, taken from colour-science at build time."""

import warnings
from importlib import import_module
from importlib.metadata import version
from typing import Any

import numpy as np

from app.optics.color import WAVELENGTH_NM

M1, M2 = -0.295, -0.689
"""Weights of the CIE D-series components S1 and S2 that reproduce the published D65 to 9e-4."""

HEADER = """\
# CIE 1931 2 degree and CIE 1964 10 degree color-matching functions; relative power of D65.
# From colour-science {version} (BSD-3-Clause), which cites CIE 015:2004.
# D65 is published in steps of 5 nm and interpolated linearly, as the CIE asks. colour-science ends
# it at 780 nm; beyond that it is S0 {m1:+} S1 {m2:+} S2 of the CIE daylight components.
# Made by tools/build_materials; do not edit.
# wavelength_nm,x_2deg,y_2deg,z_2deg,x_10deg,y_10deg,z_10deg,D65
"""


def _colour() -> Any:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # It warns of plotting libraries that it does not find.
        return import_module("colour")


def color_tables() -> str:
    """Return the text of `cie_360_830_1nm.csv`."""
    colour = _colour()
    columns = [WAVELENGTH_NM]
    for observer in ("CIE 1931 2 Degree Standard Observer", "CIE 1964 10 Degree Standard Observer"):
        functions = colour.MSDS_CMFS[observer]
        chosen = np.isin(functions.wavelengths, WAVELENGTH_NM)
        columns.extend(functions.values[chosen].T)
    daylight = colour.colorimetry.SDS_BASIS_FUNCTIONS_CIE_ILLUMINANT_D_SERIES
    published = colour.SDS_ILLUMINANTS["D65"]
    nodes = daylight["S0"].wavelengths
    power = daylight["S0"].values + M1 * daylight["S1"].values + M2 * daylight["S2"].values
    known = np.isin(nodes, published.wavelengths)
    power[known] = published.values
    columns.append(np.interp(WAVELENGTH_NM, nodes, power))
    lines = [",".join(_number(value) for value in row) for row in np.array(columns).T]
    header = HEADER.format(version=version("colour-science"), m1=M1, m2=M2)
    return header + "\n".join(lines) + "\n"


def _number(value: float) -> str:
    # Interpolated power has five decimals at most; more digits would be rounding noise.
    return f"{value:.12f}".rstrip("0").rstrip(".") if value else "0"
