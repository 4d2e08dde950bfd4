"""Presets in place of numbers: what answers say of them, and what is said of wrong ones."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from app.http.problems import BadParameters, given
from app.materials import Resolved
from app.optics.errors import OpticsError
from app.optics.interface import Interface


@contextmanager
def reported_as(**names: str) -> Iterator[None]:
    """Turn what the core refuses into the API's own error, its parameters renamed.

    Inside a pydantic validator nothing of the core's errors, which are ValueErrors, would be left.

    Parameters
    ----------
    names
        What the client calls the core's parameters.
    """
    try:
        yield
    except OpticsError as error:
        name = names.get(error.parameter, error.parameter)
        raise BadParameters(
            {"parameter": name, "value": given(error), "message": error.allowed}
        ) from None


class PresetInterface(Interface):
    """An interface that knows which presets it was made from, so that answers can say so."""

    incident: Resolved | None
    material: Resolved | None

    def __init__(
        self,
        n_i: float,
        n_t: float,
        k_t: float,
        incident: Resolved | None,
        material: Resolved | None,
    ) -> None:
        super().__init__(n_i, n_t, k_t)
        object.__setattr__(self, "incident", incident)
        object.__setattr__(self, "material", material)


def preset_json(resolved: Resolved) -> dict[str, Any]:
    """Describe where n and k come from."""
    preset, constants = resolved.preset, resolved.constants
    return {
        "id": preset.id,
        "name": preset.name,
        "wavelength_nm": constants.wavelength_nm,
        "n": constants.n,
        "k": constants.k,
        "sample": preset.sample,
        "confidence": preset.confidence,
        "source": preset.source,
        "doi": list(preset.doi),
        "warnings": list(resolved.warnings),
    }
