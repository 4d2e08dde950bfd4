"""What a number that is refused may have meant: a habit of notation, or a unit of its own."""

import re
from collections.abc import Collection

SHORTEST_NM = 10.0
"""Below this a wavelength in nanometers is most likely one in micrometers."""

_LONGEST_M = 1e-4
"""Below this it is most likely one in meters: no spectrum is known at 100 fm, many to 100 um."""

_NUMBER = r"(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?"
_PERCENT = re.compile(rf"\s*(-?{_NUMBER})\s*%\s*", re.IGNORECASE)
_LONGEST = 100  # letters that are looked into: the patterns take time as its square
_NO_GAIN = "N = n + i k with k >= 0"

UNITS = {
    "um": ("nm", 1e3),
    "mm": ("nm", 1e6),
    "m": ("nm", 1e9),
    "pm": ("nm", 1e-3),
    "A": ("nm", 0.1),
}
"""Units that names may end in, each with ours and what one of it is in ours."""


def instead(name: str, given: object) -> str | None:
    """Say what to give in place of a number that was refused; None where nothing is known.

    Parameters
    ----------
    name
        Of the parameter.
    given
        A number, a complex number or text.
    """
    if isinstance(given, str) and len(given) > _LONGEST:
        return None
    number = _number(given)
    if name.startswith("k_") and number is not None and number < 0.0:
        return f"{_NO_GAIN}; for n - i k give {-number:.15g}"
    N = _complex(given) if name in ("n_t", "k_t") and number is None else None
    if N is not None and N.imag != 0.0:
        sign = "-" if N.imag < 0.0 else "+"
        n_t = f"n_t = {N.real:.15g} and " if N.real else ""
        return f"{_NO_GAIN}; for n {sign} i k give {n_t}k_t = {abs(N.imag):.15g}"
    text = given if isinstance(given, str) else ""
    percents = [_PERCENT.fullmatch(part) for part in text.split(",")]
    shares = [f"{float(part[1]) / 100.0:.15g}" for part in percents if part]
    if len(shares) == len(percents):
        return f"a number without a percent sign; did you mean {','.join(shares)}?"
    return None


def in_nm(value: float) -> str:
    """Ask whether a few nanometers were meant in micrometers, or far less in meters; else nothing."""
    if not 0.0 < value < SHORTEST_NM:
        return ""
    _, factor = UNITS["m" if value < _LONGEST_M else "um"]
    return f"; in nm: did you mean {factor * value:.10g}?"


def in_our_unit(name: str, known: Collection[str], value: object = None) -> str | None:
    """Say what a name that ends in another unit is called here, and what its value is then."""
    stem, _, unit = name.rpartition("_")
    ours, factor = UNITS.get(unit, ("", 1.0))
    right = f"{stem}_{ours}"
    if not ours or right not in known:
        return None
    number = _number(value)
    worth = "" if number is None else f": {right} = {number * factor:.10g}"
    return f"give {right}, which is {name} times {factor:.10g}{worth}"


def _complex(given: object) -> complex | None:
    """Read n + i k as people write it, with i or j, with spaces or without."""
    if isinstance(given, str):
        text = re.sub(r"\s*([-+*])\s*", r"\1", given.strip().strip("()").lower())
        # In an address a plus sign that is not encoded is read as a space.
        given = re.sub(r"\s+", "+", text).replace("*", "").replace("i", "j")
    try:
        return complex(given)  # type: ignore[call-overload, no-any-return]
    except (TypeError, ValueError):
        return None


def _number(given: object) -> float | None:
    try:
        return float(given)  # type: ignore[arg-type]
    except (TypeError, ValueError):
        return None
