"""Whatever the light, what reflects all wavelengths alike reflects each channel alike."""

from itertools import product

import numpy as np
import pytest

from app.answers.materials.detail import detail
from app.answers.materials.rgb import rgb_curves
from app.materials.appearance import Viewing, appearance, averaged_interface
from app.materials.catalog import Catalog
from app.materials.media import default_catalog
from app.materials.schema import Points
from app.materials.spectrum import Spectrum
from app.optics.color import (
    ADAPTATIONS,
    ILLUMINANTS,
    OBSERVERS,
    WAVELENGTH_NM,
    linear_srgb,
    rendered_white,
)
from app.optics.incidence import Incidence
from app.optics.registry import default_registry

LIGHTS = [Viewing(*light) for light in product(ILLUMINANTS, OBSERVERS, ADAPTATIONS)]
CAST = Viewing("E", "cie1931_2deg", "none")
MODELS = ("exact", "schlick", "f82_tint", "hoffman_f82")

TINT_OF_1_52 = 0.94319
"""F82 of n = 1.52, 0.458266, over Schlick's value there, 0.485869."""


def grey(n: float, k: float) -> Spectrum:
    """A material with the same n and k at all wavelengths."""
    of_n, of_k = (
        Points(kind="points", wavelength_nm=(360.0, 830.0), values=(value, value))
        for value in (n, k)
    )
    file = default_catalog().spectrum("Au").file
    return Spectrum(file.model_copy(update={"n": of_n, "k": of_k}))


@pytest.mark.parametrize("viewing", LIGHTS, ids="-".join)
def test_the_tint_of_a_constant_index(viewing: Viewing) -> None:
    np.testing.assert_allclose(
        appearance(grey(1.52, 0.0), 1.0, viewing).F82_tint, TINT_OF_1_52, rtol=0, atol=5e-6
    )
    told = detail(default_catalog().get("window-glass-shirley"), viewing=viewing)
    for shown in (told.color, told.display):
        np.testing.assert_allclose(shown.F82_tint, TINT_OF_1_52, rtol=0, atol=5e-6)


@pytest.mark.parametrize("viewing", LIGHTS, ids="-".join)
@pytest.mark.parametrize(("n", "k"), [(1.52, 0.0), (0.2, 3.0)])
def test_means_of_constants_are_the_constants(viewing: Viewing, n: float, k: float) -> None:
    mean = averaged_interface(grey(n, k), np.full(WAVELENGTH_NM.shape, 1.2), viewing)
    np.testing.assert_allclose(mean.n_i, 1.2, rtol=1e-12)
    np.testing.assert_allclose(mean.n_t, n, rtol=1e-12)
    np.testing.assert_allclose(mean.k_t, k, rtol=0, atol=1e-11)


@pytest.mark.parametrize("viewing", LIGHTS, ids="-".join)
def test_models_are_compared_in_one_normalization(viewing: Viewing) -> None:
    models = [default_registry()[name] for name in MODELS]
    at = Incidence.from_degrees(np.array([0.0, 90.0]))
    told = rgb_curves(grey(1.52, 0.0), 1.0, at, models, viewing, "unclamped")
    white = rendered_white(*viewing)
    truth, *curves = told.curves
    for curve, given in zip(curves, models, strict=True):
        ends = np.array([curve.R_red, curve.R_green, curve.R_blue])
        spectral = np.array([truth.R_red, truth.R_green, truth.R_blue])
        np.testing.assert_allclose(ends, spectral, rtol=1e-12, err_msg=given.id)
        np.testing.assert_allclose(ends[:, 1], white, rtol=1e-12, err_msg=given.id)
        assert curve.errors is not None
        # The error of a grey material is that of its one index, in units of the channel's white.
        errors = [curve.errors.red, curve.errors.green, curve.errors.blue]
        relative = [error.max_abs / one for error, one in zip(errors, white, strict=True)]
        np.testing.assert_allclose(relative, relative[0], rtol=1e-9, atol=1e-12)
        if given.id == "exact":
            assert max(relative) < 1e-12
    np.testing.assert_allclose(told.white, white, rtol=0, atol=0)


def test_the_white_that_keeps_a_cast_is_that_of_the_light() -> None:
    for viewing in LIGHTS:
        reflected = linear_srgb(np.ones(WAVELENGTH_NM.size), *viewing)
        np.testing.assert_allclose(rendered_white(*viewing), reflected, rtol=1e-12)
    # XYZ = (1, 1, 1) by the matrix of IEC 61966-2-1.
    np.testing.assert_allclose(rendered_white(*CAST), [1.2048, 0.9483, 0.9089], rtol=0, atol=4e-4)


def test_fused_silica_without_adaptation(catalog: Catalog) -> None:
    silica = catalog.spectrum("fused-silica")
    mean = averaged_interface(silica, 1.0, CAST).n_t.ravel()
    # Malitson's n, relative to air, is 1.456, 1.460 and 1.466 and a bit.
    in_air = averaged_interface(silica, catalog.spectrum("air").visible.n, CAST)
    np.testing.assert_array_equal(np.floor(in_air.eta.ravel() * 1e3), [1456, 1460, 1466])
    np.testing.assert_allclose(mean / in_air.eta.ravel(), 1.000278, rtol=0, atol=4e-6)
    exact = default_registry()["exact"]
    at = Incidence.from_degrees(np.array([0.0]))
    _, curve = rgb_curves(silica, 1.0, at, [exact], CAST, "unclamped").curves
    assert curve.errors is not None
    for error in (curve.errors.red, curve.errors.green, curve.errors.blue):
        assert error.max_abs is not None
        assert error.max_abs < 1.5e-6
