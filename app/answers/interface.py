"""The interface that an answer was computed for, and the presets that its numbers come from."""

from __future__ import annotations

from app.answers.answer import answer, filled, number_or_none
from app.materials.media import Resolved
from app.materials.schema import Confidence, RelativeTo, WavelengthIn
from app.optics.angles import LANDMARKS
from app.optics.ellipsometry import CORE
from app.optics.interface import Interface, Kind
from app.optics.specular import F82

REST = "angles from the surface normal; T = 1 - R is the power that enters the second medium"
CONVENTION = f"{CORE.text}; {REST}"


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


@answer
class ResolvedPreset:
    """A preset that stands in place of numbers, and where those come from."""

    id: str
    name: str
    wavelength_nm: float | None
    """Where it was evaluated, in nm; null where the source names no wavelength."""
    n: float
    """Relative to what the source measured it."""
    n_absolute: float
    """The same against vacuum: this is n_t or n_i."""
    k: float | None
    """Null where the source does not give it."""
    relative_to: RelativeTo
    wavelength_in: WavelengthIn
    sample: str
    """bulk, film, model, calculated or unstated"""
    confidence: Confidence
    source: str
    """The reference."""
    doi: list[str]
    warnings: list[str]

    @classmethod
    def of(cls, resolved: Resolved | None) -> ResolvedPreset | None:
        """Describe where n and k come from."""
        if resolved is None:
            return None
        preset, constants = resolved.preset, resolved.constants
        return filled(
            cls,
            preset,
            wavelength_nm=constants.wavelength_nm,
            n=constants.n,
            n_absolute=constants.n_absolute,
            k=constants.k,
            doi=list(preset.doi),
            warnings=list(resolved.warnings),
        )


@answer
class InterfaceFacts:
    """The interface an answer was computed for, with everything derived from it."""

    n_i: float
    n_t: float
    k_t: float
    eta: float
    """n_t / n_i"""
    kappa: float
    """k_t / n_i"""
    kind: Kind
    F0: float
    """Reflectance at normal incidence."""
    F82: float
    """Exact reflectance at cos(theta_i) = 1/7."""
    brewster_deg: float | None
    """Angle where Rp = 0; null in absorbers."""
    critical_deg: float | None
    """Angle of total reflection; null if none."""
    pseudo_brewster_deg: float
    """Angle of least Rp."""
    principal_deg: float
    """Smallest angle where the phases of r_p and r_s are 90 degrees apart; Brewster's angle without
    absorption."""
    incident: ResolvedPreset | None
    """The preset that n_i comes from; null if it was given as a number."""
    material: ResolvedPreset | None
    """The preset that n_t and k_t come from; null if they were given as numbers."""

    @classmethod
    def of(cls, interface: Interface) -> InterfaceFacts:
        """Describe an interface as every answer does."""
        named = interface if isinstance(interface, PresetInterface) else None
        landmarks = {name: number_or_none(angle(interface)) for name, angle in LANDMARKS.items()}
        return cls(
            n_i=float(interface.n_i),
            n_t=float(interface.n_t),
            k_t=float(interface.k_t),
            eta=float(interface.eta),
            kappa=float(interface.kappa),
            kind=interface.kind,
            F0=float(interface.F0),
            F82=float(F82(interface)),
            brewster_deg=landmarks["brewster_deg"],
            critical_deg=landmarks["critical_deg"],
            pseudo_brewster_deg=float(landmarks["pseudo_brewster_deg"] or 0.0),
            principal_deg=float(landmarks["principal_deg"] or 0.0),
            incident=ResolvedPreset.of(named.incident) if named else None,
            material=ResolvedPreset.of(named.material) if named else None,
        )
