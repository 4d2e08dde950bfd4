"""What the materials raise: errors that name the parameter, the value and what is allowed."""

from __future__ import annotations

from app.optics.errors import OpticsError


class UnknownMaterial(OpticsError):
    """No preset has this id or alias.

    Parameters
    ----------
    id : str
        What was asked for.
    nearest : tuple of str
        The ids that resemble it most, best first.
    """

    def __init__(self, id: str, nearest: tuple[str, ...] = ()) -> None:  # noqa: A002
        self.id = id
        self.nearest = nearest
        allowed = "the id or an alias of a preset"
        if nearest:
            allowed += "; nearest: " + ", ".join(nearest)
        super().__init__("material", id, allowed)
