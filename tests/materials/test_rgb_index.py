"""Three pairs of n and k that match a spectral color, against searches of another kind."""

import json

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import Bounds, differential_evolution

from app.answers.materials.rgb_nk import rgb_nk
from app.materials.catalog import Catalog
from app.materials.location import data_directory
from app.materials.rgb_index import (
    PAIRS_FILE,
    exact_at_angles,
    fit,
    fitted_interface,
    reflected,
    reflected_at_angles,
)
from app.optics.fitted_index import fit_index, fitting_nodes
from app.optics.incidence import Incidence


def textbook(mu: np.ndarray, n: float, k: float) -> np.ndarray:
    """Fresnel's equations by complex numbers, from vacuum."""
    N = n + 1j * k
    inside = np.sqrt(1.0 - (1.0 - mu**2) / N**2 + 0j)
    s = (mu - N * inside) / (mu + N * inside)
    p = (N * mu - inside) / (N * mu + inside)
    return np.asarray(0.5 * (np.abs(s) ** 2 + np.abs(p) ** 2))


def cost(R: np.ndarray, n: float, k: float) -> float:
    rule = fitting_nodes()
    return float((textbook(rule.x, n, k) - R) ** 2 @ rule.w)


@pytest.mark.parametrize(
    ("n", "k"), [(0.18, 3.4), (1.5, 0.0), (2.7, 3.2), (1.05, 0.3), (0.05, 4.0)]
)
def test_a_curve_of_one_index_gives_it_back(n: float, k: float) -> None:
    found = fit_index(textbook(fitting_nodes().x, n, k), start=(1.4, 2.0))
    assert found.rms < 1e-6
    assert found.n == pytest.approx(n, abs=2e-4)
    assert found.k == pytest.approx(k, abs=2e-3 if k else 2e-2)  # R depends on the square of k


@pytest.mark.parametrize("id", ["Cu", "Cr", "Ag", "TiN", "Ge", "Au-Hagemann"])
def test_no_other_index_is_closer(catalog: Catalog, id: str) -> None:  # noqa: A002
    """Evolution over the whole plane, which starts nowhere and takes no derivative."""
    R = reflected(catalog.get(id), Incidence.from_cosine(fitting_nodes().x))
    pairs = fitted_interface(id)
    for channel in range(3):
        target = np.clip(R[:, channel], 0.0, 1.0)
        n, k = float(pairs.n_t[channel, 0]), float(pairs.k_t[channel, 0])

        def of(x: np.ndarray, target: np.ndarray = target) -> float:
            return cost(target, float(np.exp(x[0])), float(x[1]))

        plane = Bounds([np.log(0.01), 0.0], [np.log(20.0), 20.0])
        best = differential_evolution(of, plane, rng=5, popsize=20, maxiter=60, tol=1e-12).fun
        assert np.sqrt(cost(target, n, k)) <= np.sqrt(best) + 1e-6


def test_the_nodes_measure_the_hemisphere(catalog: Catalog) -> None:
    """The rms left in copper's red against adaptive integration."""
    pairs = fitted_interface("Cu")
    n, k = float(pairs.n_t[0, 0]), float(pairs.k_t[0, 0])
    copper = catalog.get("Cu")

    def square(mu: float) -> float:
        target = reflected(copper, Incidence.from_cosine([mu]))[0, 0]
        return float((textbook(np.array([mu]), n, k)[0] - target) ** 2)

    R = reflected(copper, Incidence.from_cosine(fitting_nodes().x))[:, 0]
    assert cost(R, n, k) == pytest.approx(quad(square, 0.0, 1.0, epsabs=1e-10)[0], rel=1e-3)


def test_every_material_has_pairs_that_engines_take(catalog: Catalog) -> None:
    left = {}
    for preset in catalog.presets:
        pairs = fitted_interface(preset.id)
        assert pairs.n_t.min() >= 0.01
        assert pairs.n_t.max() <= 100.0
        assert pairs.k_t.max() <= 100.0
        truth = np.clip(reflected_at_angles(preset.id), 0.0, 1.0)
        left[preset.id] = np.abs(exact_at_angles(pairs) - truth).max()
    # The worst is Hagemann's gold; an 8-bit image shows 0.004.
    assert len(left) == len(catalog.presets)
    assert max(left.values()) < 0.0101
    assert sorted(left.values())[int(0.95 * len(left))] < 0.004


def test_the_file_has_what_a_new_fit_finds(catalog: Catalog) -> None:
    """By their curves: where R hardly depends on k, k may differ."""
    kept = {one["id"] for one in json.loads((data_directory() / PAIRS_FILE).read_text())["pairs"]}
    assert kept == {preset.id for preset in catalog.presets}
    for id in kept:  # noqa: A001
        on_file, new = (exact_at_angles(found(id)) for found in (fitted_interface, fit))
        np.testing.assert_allclose(on_file, new, atol=2e-6, err_msg=id)


def test_clear_media_stay_clear(catalog: Catalog) -> None:
    for id in ("N-BK7", "water", "window-glass-shirley"):  # noqa: A001
        pairs = fitted_interface(id)
        assert not pairs.k_t.any()
        n = catalog.get(id).n_absolute  # N-BK7's n is relative to air, and its F0 is not
        assert pairs.n_t.ravel()[1] == pytest.approx(n, abs=3e-3)
    bk7 = catalog.spectrum("N-BK7")
    assert np.ptp(fitted_interface("N-BK7").n_t) < np.ptp(bk7.visible.n)


def test_the_fit_is_the_best_of_all_ways(catalog: Catalog) -> None:
    metals = [p for p in catalog.presets if p.category == "metal" and p.kind == "spectrum"]
    for preset in metals[::6]:
        errors = {way.way: way.error.rms for way in rgb_nk(preset).ways}
        assert errors["fitted"] == min(errors.values()), preset.id


def test_policies_and_spaces_of_gold(catalog: Catalog) -> None:
    gold = catalog.get("Au")
    scaled = rgb_nk(gold, gamut="scaled")
    F0 = exact_at_angles(fitted_interface("Au", gamut="scaled"))[0]
    truth = reflected_at_angles("Au")[0]
    np.testing.assert_allclose(F0, truth / truth.max(), rtol=0, atol=0.015)
    assert scaled.error.max_abs > rgb_nk(gold).error.max_abs
    # ACEScg has gold's red, and the fit nothing to cut.
    assert rgb_nk(gold, space="acescg").error.max_abs < 0.01
