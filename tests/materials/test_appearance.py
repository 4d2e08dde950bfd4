"""R over angle and wavelength, and its color."""

import numpy as np
import pytest

from app.materials.appearance import Viewing, appearance, averaged_interface, color_curve, interface
from app.materials.catalog import Catalog
from app.materials.errors import WavelengthOutOfRange
from app.optics.color import WAVELENGTH_NM, Gamut, Space, luminance
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.registry import default_registry
from app.optics.specular import MU_BAR, polynomial, tint_at_82

ROUNDING = 1e-12
INDEX_DECIMALS = 5.1e-7


def test_shape_is_the_angles_then_the_channels(catalog: Catalog) -> None:
    copper = catalog.spectrum("Cu")
    assert color_curve(copper, Incidence.from_degrees(np.zeros((2, 4)))).shape == (2, 4, 3)
    assert color_curve(copper, Incidence.from_degrees(10.0)).shape == (3,)
    assert color_curve(copper, Incidence.from_degrees([])).shape == (0, 3)


def test_an_interface_is_refused_where_n_or_k_is_not_known(catalog: Catalog) -> None:
    with pytest.raises(WavelengthOutOfRange, match="n of Cu"):
        interface(catalog.spectrum("Cu"), [500.0, 2000.0])
    with pytest.raises(WavelengthOutOfRange, match="k of LASF9"):
        interface(catalog.spectrum("LASF9"), 367.0)


def test_unknown_k_reflects_as_a_dielectric(catalog: Catalog) -> None:
    water = catalog.spectrum("water")
    boundary = interface(water, 589.0)
    assert boundary.kind == "dielectric"
    assert "k is not known and counts as 0" in appearance(water).warnings


def test_color_at_both_ends_and_at_f82(catalog: Catalog) -> None:
    gold = catalog.spectrum("Au")
    look = appearance(gold)
    rgb = color_curve(gold, Incidence.from_cosine([1.0, MU_BAR, 0.0]))
    np.testing.assert_allclose(rgb[0], look.F0, rtol=0, atol=ROUNDING)
    np.testing.assert_allclose(rgb[1], look.F82, rtol=0, atol=ROUNDING)
    np.testing.assert_allclose(rgb[2], 1.0, rtol=0, atol=ROUNDING)
    np.testing.assert_array_equal(look.F82_tint, tint_at_82(look.F0, look.F82))


def test_long_curves_are_made_in_pieces(catalog: Catalog) -> None:
    copper = catalog.spectrum("Cu")
    degrees = np.linspace(0.0, 90.0, 601)
    whole = color_curve(copper, Incidence.from_degrees(degrees))
    parts = [
        color_curve(copper, Incidence.from_degrees(degrees[i : i + 7])) for i in range(0, 601, 7)
    ]
    np.testing.assert_allclose(whole, np.concatenate(parts), rtol=0, atol=ROUNDING)


def test_incident_media_darken(catalog: Catalog) -> None:
    water = catalog.spectrum("water").visible.n
    diamond = catalog.spectrum("diamond")
    assert np.all(appearance(diamond, n_i=water).F0 < appearance(diamond).F0)


def test_adapted_illuminants_agree_and_others_do_not(catalog: Catalog) -> None:
    silver = catalog.spectrum("Ag")
    day, equal = appearance(silver), appearance(silver, viewing=Viewing("E"))
    np.testing.assert_allclose(equal.F0, day.F0, rtol=0, atol=2e-3)
    raw = appearance(silver, viewing=Viewing("E", adaptation="none"))
    assert raw.F0[0] - day.F0[0] == pytest.approx(0.20, abs=0.01)


def test_averaged_constants_keep_what_does_not_vary(catalog: Catalog) -> None:
    helium = catalog.spectrum("He")
    averaged = averaged_interface(helium)
    np.testing.assert_allclose(averaged.n_t, helium.n(587.6), rtol=0, atol=1e-5)
    np.testing.assert_array_equal(averaged.k_t, 0.0)


def test_averaged_constants_of_gold_miss_its_color(catalog: Catalog) -> None:
    # Why n, k triples are no substitute for spectra; red is most wrong, where n is near 0.
    gold = catalog.spectrum("Au")
    error = averaged_interface(gold).F0.ravel() - appearance(gold).F0
    assert np.abs(error).max() > 0.03


def test_averaged_constants_stay_legal_where_a_channel_is_negative(catalog: Catalog) -> None:
    for id in ("Cu-Babar", "GaP", "AlSb"):  # noqa: A001
        averaged = averaged_interface(catalog.spectrum(id))
        assert averaged.n_t.min() > 0.0
        assert averaged.k_t.min() >= 0.0


def test_every_material_is_physical(catalog: Catalog) -> None:
    for preset in catalog.presets:
        if preset.kind == "single":
            continue
        spectrum = catalog.spectrum(preset.id)
        low, high = spectrum.range_nm
        within = np.clip(np.geomspace(max(low, 1.0), min(high, 2e4), 400), low, high)
        n, k = spectrum.n(within), spectrum.k(within)
        assert np.all(n > 0.0), preset.id
        assert k is None or np.all(k >= 0.0), preset.id
        seen = spectrum.visible
        F0 = Interface(n_t=seen.n, k_t=seen.k).F0
        assert np.all((F0 >= 0.0) & (F0 <= 1.0)), preset.id


def test_the_index_is_what_the_spectra_give(catalog: Catalog) -> None:
    for preset in catalog.presets:
        if preset.kind == "single":
            continue
        spectrum = catalog.spectrum(preset.id)
        look = appearance(spectrum)
        for name in ("F0", "F82", "F82_tint"):
            np.testing.assert_allclose(
                getattr(preset.color, name),
                getattr(look, name),
                rtol=0,
                atol=INDEX_DECIMALS,
                err_msg=preset.id,
            )
        assert preset.color.luminance == pytest.approx(look.luminance, abs=INDEX_DECIMALS)
        at_reference = interface(spectrum, 587.6)
        np.testing.assert_allclose(preset.F0, at_reference.F0, rtol=1e-9)
        assert spectrum.n(587.6) == pytest.approx(preset.n, rel=1e-9)
        seen = spectrum.visible
        bright = luminance(Interface(n_t=seen.n, k_t=seen.k).F0)
        assert look.luminance == bright
        assert seen.n.shape == WAVELENGTH_NM.shape


@pytest.mark.parametrize("gamut", ["clamped", "scaled"])
def test_a_gamut_policy_moves_F0_and_F82_together(catalog: Catalog, gamut: Gamut) -> None:
    gold = appearance(catalog.spectrum("Au"))
    shown = gold.within(gamut)
    assert shown.F0[0] == 1.0
    np.testing.assert_allclose(shown.F82_tint, [0.9698, 1.0, 0.9823], rtol=0, atol=5e-5)
    assert gold.outside == ("F0", "F82_tint")
    assert gold.within("unclamped") is gold


@pytest.mark.parametrize("gamut", ["clamped", "scaled"])
@pytest.mark.parametrize("space", ["srgb", "acescg"])
def test_what_a_gamut_policy_hands_out_can_be_typed(
    catalog: Catalog, gamut: Gamut, space: Space
) -> None:
    outside = 0
    for preset in catalog.presets:
        if preset.kind == "spectrum":
            look = appearance(catalog.spectrum(preset.id)).in_space(space)
            outside += bool(look.outside)
            shown = look.within(gamut)
            assert shown.outside == (), preset.id
            np.testing.assert_allclose(
                shown.F82, shown.F82_tint * polynomial(shown.F0, MU_BAR), rtol=0, atol=ROUNDING
            )
    assert outside > 0


def test_the_tint_of_every_metal_can_be_given_to_the_model(catalog: Catalog) -> None:
    tint = next(p for p in default_registry()["f82_tint"].parameters if p.name == "tint")
    tints = {p.id: p.color.F82_tint for p in catalog.presets if p.category in ("metal", "alloy")}
    assert all(tint.admits(np.array(rgb)).all() for rgb in tints.values())
    assert len(tints) == 71
    assert sum(max(rgb) > 1.0 for rgb in tints.values()) == 14
    assert max(tints["red-brass"]) == pytest.approx(1.056, abs=5e-4)
