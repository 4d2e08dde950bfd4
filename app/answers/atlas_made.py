"""How the atlas was made."""

from __future__ import annotations

from app.answers.answer import answer
from app.atlas.published import Atlas


@answer
class AtlasMade:
    """How the atlas was made."""

    program: str
    """Which version of this program made it."""
    code: str
    """A digest of the sources that the numbers depend on."""
    database: str
    """The release that the spectra were taken from."""
    date: str
    how: str
    """By which functions."""
    wavelengths: str
    """At which wavelengths."""
    incident: str
    """The medium in front."""
    digits: str
    """How the numbers are kept."""
    materials: int
    """How many were looked at."""
    refused: list[str]
    """Pages of the database that nothing is computed of."""
    left_out: list[str]
    """Those whose n and k are nowhere known together, within what is computed."""
    rows: int
    """A material, model and wavelength each."""

    @classmethod
    def of(cls, found: Atlas) -> AtlasMade:
        """Take from the file's own words."""
        about = found.about
        names = (
            *("program", "code", "database", "date", "how"),
            *("wavelengths", "incident", "digits", "rows"),
        )
        return cls(
            **{name: about[name] for name in names},
            materials=about["materials"],
            refused=list(about["refused"]),
            left_out=list(about["left_out"]),
        )
