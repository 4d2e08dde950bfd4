"""Materials under something: against another package, by hand, and where nothing is in front."""

import numpy as np
import pytest
import tmm

from app.answers.materials.covered import covered
from app.materials.catalog import Catalog
from app.materials.covered import Cover, CoverKind, below, spectral, through, whole
from app.materials.front import Front
from app.optics.color import WAVELENGTH_NM, linear_srgb
from app.optics.errors import NotAllowed
from app.optics.incidence import Incidence
from app.optics.specular import MU_BAR, polynomial

MATERIALS = ("Au", "Cr", "N-BK7")
DEGREES = np.array([0.0, 40.0, 75.0, np.degrees(np.arccos(MU_BAR))])
INCIDENCE = Incidence.from_degrees(DEGREES)


def independent(
    catalog: Catalog, material: str, kind: CoverKind, n: float, nm: float, degrees: float
) -> float:
    """Reflectance of unpolarized light by tmm, thick layers incoherent."""
    at = np.flatnonzero(nm == WAVELENGTH_NM)[0]
    seen = catalog.spectrum(material).visible
    back = complex(seen.n[at], seen.k[at])
    indices: dict[CoverKind, list[complex]] = {
        "medium": [n, back],
        "coat": [1.0, n, back],
        "pane": [1.0, n, 1.0, back],
    }
    stack = indices[kind]
    thick = [np.inf, *[1e6] * (len(stack) - 2), np.inf]
    found = [
        tmm.inc_tmm(pol, stack, thick, ["i"] * len(stack), np.radians(degrees), nm)["R"]
        for pol in "sp"
    ]
    return float(np.mean(found))


@pytest.mark.parametrize("material", MATERIALS)
@pytest.mark.parametrize(("kind", "n"), [("medium", 1.333), ("coat", 1.5), ("pane", 1.52)])
def test_by_another_package(catalog: Catalog, material: str, kind: CoverKind, n: float) -> None:
    found = spectral(catalog.get(material), Cover(kind, Front(n)), INCIDENCE)
    for nm in (420.0, 550.0, 700.0):
        column = int(np.flatnonzero(nm == WAVELENGTH_NM)[0])
        for row, degrees in enumerate(DEGREES):
            other = independent(catalog, material, kind, n, nm, float(degrees))
            assert found[row, column] == pytest.approx(other, abs=1e-10)


def test_colors_are_integrals_of_that(catalog: Catalog) -> None:
    """Of every tenth nanometer by tmm, which gold's smooth spectrum allows to a thousandth."""
    cover = Cover("coat", Front(1.5))
    look = whole(catalog.get("Au"), cover)
    nm = WAVELENGTH_NM[::10]
    for degrees, color in ((0.0, look.F0), (DEGREES[-1], look.F82)):
        R = [independent(catalog, "Au", "coat", 1.5, at, float(degrees)) for at in nm]
        other = linear_srgb(np.interp(WAVELENGTH_NM, nm, R))
        np.testing.assert_allclose(color, other, atol=1e-3)
    F0, schlick = look.F0, polynomial(look.F0, MU_BAR)
    np.testing.assert_allclose(look.F82_tint, look.F82 / schlick, rtol=1e-12)
    curve = through(catalog.get("Au"), cover, INCIDENCE)
    np.testing.assert_allclose(curve[[0, -1]], [F0, look.F82], atol=1e-12)


def test_gold_under_water_by_hand(catalog: Catalog) -> None:
    """F0 = |N - n_w|^2 / |N + n_w|^2 with the water's own dispersion (Lagarde 2013)."""
    gold, water = (catalog.spectrum(name).visible for name in ("Au", "water"))
    N = gold.n + 1j * gold.k
    by_hand = linear_srgb(np.abs((N - water.n) / (N + water.n)) ** 2)
    found = below(catalog.get("Au"), Cover("medium", Front.named("water")))
    np.testing.assert_allclose(found.F0, by_hand, rtol=1e-12)
    assert np.all(found.F0 < below(catalog.get("Au"), Cover("medium", Front(1.0))).F0)


@pytest.mark.parametrize("kind", ["medium", "coat", "pane"])
def test_a_cover_of_index_1_is_none(catalog: Catalog, kind: CoverKind) -> None:
    answer = covered(catalog.get("Cu"), Cover(kind, Front(1.0)))
    for look in (answer.below, answer.whole):
        np.testing.assert_allclose(look.F0, answer.air.F0, atol=1e-12)
        np.testing.assert_allclose(look.F82_tint, answer.air.F82_tint, atol=1e-12)


def test_errors_are_against_the_whole(catalog: Catalog) -> None:
    answer = covered(catalog.get("Cr"), Cover("coat", Front(1.5)))
    assert answer.largest_angle_deg == pytest.approx(41.8103, abs=1e-4)
    assert len(answer.shortcuts) == 8
    for shortcut in answer.shortcuts:
        off = np.abs(shortcut.reflectance - answer.reflectance)
        assert shortcut.error.max_abs >= off.max() - 1e-9
        assert shortcut.error.max_abs <= off.max() + 0.02
        np.testing.assert_allclose(shortcut.F0_error, shortcut.F0 - answer.below.F0, atol=1e-9)
    by_id = {shortcut.id: shortcut for shortcut in answer.shortcuts}
    # Chromium is darker from the coat; what keeps its F0 is off by that.
    assert np.all(by_id["gltf_clearcoat"].F0_error > 0.05)
    assert by_id["openpbr_coat"].error.max_abs < by_id["cycles_coat"].error.max_abs


def test_a_cover_is_clear(catalog: Catalog) -> None:
    with pytest.raises(NotAllowed, match="transparent"):
        covered(catalog.get("Au"), Cover("coat", Front.named("Cu")))
