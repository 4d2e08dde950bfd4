"""Units of the abscissa: wavelengths, energies, wavenumbers and frequencies."""

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from app.optics.parameters import Array

HC_EV_NM = 1239.8419843320026
"""h c in eV nm, exact in the SI."""
LIGHT_NM_THZ = 299792.458
"""c in nm THz, exact."""


@dataclass(frozen=True)
class Unit:
    """A unit of the abscissa."""

    name: str
    kind: str
    """wavelength, energy, wavenumber or frequency"""
    factor: float
    """Nanometers in one of it; of energies and the like, what divided by it gives nanometers."""
    usual: tuple[float, float]
    """Between which numbers tables of optical constants without a unit are taken for this one."""

    @property
    def is_reciprocal(self) -> bool:
        """Whether the wavelength falls where the number rises."""
        return self.kind != "wavelength"

    def nanometers(self, x: Array) -> Array:
        """Convert to wavelengths in vacuum, to 15 digits, so that 0.36 um are 360 nm."""
        with np.errstate(divide="ignore", over="ignore"):
            exact = self.factor / x if self.is_reciprocal else x * self.factor
        if self.name == "nm":
            return exact
        return np.array([float(f"{value:.15g}") for value in exact.tolist()])


def _wavelength(name: str, factor: float, *usual: float) -> Unit:
    return Unit(name, "wavelength", factor, (usual[0], usual[1]))


UNITS = {
    unit.name: unit
    for unit in (
        _wavelength("nm", 1.0, 100.0, 1e5),
        _wavelength("um", 1e3, 0.1, 1000.0),
        _wavelength("A", 0.1, 1000.0, 1e6),
        Unit("eV", "energy", HC_EV_NM, (0.005, 100.0)),
        Unit("cm-1", "wavenumber", 1e7, (10.0, 1e5)),
        Unit("THz", "frequency", LIGHT_NM_THZ, (0.1, 3000.0)),
        _wavelength("m", 1e9, 1e-8, 1e-3),
        _wavelength("mm", 1e6, 1e-4, 10.0),
        Unit("keV", "energy", HC_EV_NM / 1e3, (0.01, 100.0)),
        Unit("meV", "energy", HC_EV_NM * 1e3, (1.0, 1e4)),
        Unit("GHz", "frequency", LIGHT_NM_THZ * 1e3, (10.0, 1e6)),
        Unit("Hz", "frequency", LIGHT_NM_THZ * 1e12, (1e11, 1e16)),
    )
}
"""By the names that the parameter `unit` takes."""

_SPELLINGS = {
    "nm": r"nm|nanomet(?:er|re)s?",
    "um": r"[uµμ]m|mic(?:ron|rons|romet(?:er|re)s?)",
    "A": r"å|\u212b|a|ang(?:str[oö]ms?)?",
    "eV": r"ev|electron-?\s?volts?",
    "cm-1": r"cm\^?\(?[-−⁻][1¹]\)?|(?:1/|/|per\s|inverse\s)\s?cm|wavenumbers?",
    "THz": r"thz",
    "m": r"m|met(?:er|re)s?",
    "mm": r"mm|millimet(?:er|re)s?",
    "keV": r"kev",
    "meV": r"mev",
    "GHz": r"ghz",
    "Hz": r"hz",
}
_EXACT = {name: re.compile(spelling, re.IGNORECASE) for name, spelling in _SPELLINGS.items()}
_IN_PROSE = re.compile(
    r"(?<![\w.])(?:"
    + "|".join(
        f"(?P<u{i}>{spelling})"
        for i, (name, spelling) in enumerate(_SPELLINGS.items())
        if name not in ("A", "m", "mm", "Hz", "GHz")
    )
    + r"|(?P<ua>å|\u212b|angstr[oö]ms?|\(a\)|\[a\]))(?![\w])",
    re.IGNORECASE,
)


def unit_spelled(text: str) -> str | None:
    """Name the unit that a word is, None if it is none."""
    text = text.strip().strip(".")
    if text == "meV":  # and MeV, which is no unit of this field
        return "meV"
    for name, spelling in _EXACT.items():
        if spelling.fullmatch(text):
            return name
    return None


def units_named(text: str) -> list[str]:
    """Units that words of a header or comment name, each once."""
    names = list(_SPELLINGS)
    found = []
    for match in _IN_PROSE.finditer(text):
        group = match.lastgroup or ""
        found.append("A" if group == "ua" else names[int(group[1:])])
    return list(dict.fromkeys(found))


def ranges(units: Sequence[str], x: Array) -> str:
    """Say which wavelengths numbers are in each of some units."""
    said = []
    for name in units:
        low, high = sorted(UNITS[name].nanometers(np.array([x.min(), x.max()])).tolist())
        said.append(f"in {name} they are {low:.4g} to {high:.4g} nm")
    return ", ".join(said)


def plausible(x: Array, looks_solid: Callable[[], bool] = lambda: False) -> list[str]:
    """Units in which numbers without one may be, the likeliest first.

    Parameters
    ----------
    x
        The numbers, positive.
    looks_solid
        Whether n beside them is that of matter in visible light, which rules X-rays out.
    """
    low, high = float(x.min()), float(x.max())
    fitting = [
        name
        for name in ("nm", "um", "A", "eV", "cm-1", "m")
        if UNITS[name].usual[0] <= low and high <= UNITS[name].usual[1]
    ]
    if "nm" in fitting and high <= 2600.0:  # where nearly every table of n and k in nm ends
        return ["nm"]
    if looks_solid():
        solid = [
            name
            for name in fitting
            if UNITS[name].nanometers(np.array([low, high])).max() > SHORTEST_SOLID_NM
        ]
        return solid or fitting
    return fitting


SHORTEST_SOLID_NM = 40.0
"""Below this wavelength n of everything is close to 1."""
