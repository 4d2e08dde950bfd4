"""Renderers' shortcuts for films: held to their own shaders, and their errors measured again."""

from typing import NamedTuple

import numpy as np
import pytest
from numpy.typing import ArrayLike

from app.optics.color import WAVELENGTH_NM, delta_e_2000, lab, srgb_weights
from app.optics.film_color import swept_colors
from app.optics.film_models import CoatedSurface, Deviation, FilmModel, film_models
from app.optics.film_models.openpbr_film import effective_index
from app.optics.films import reflectances
from app.optics.incidence import Incidence
from app.optics.parameters import Array
from app.optics.stack import Layer, Stack

COPPER = ((0.2, 0.92, 1.1), (3.91, 2.45, 2.14))
CHANNELS_NM = np.array([450.0, 550.0, 650.0])


class Run(NamedTuple):
    """One run of a shader in WebGL 2, or of Cycles."""

    model: str
    theta_i_deg: float
    thickness_nm: float
    film_n: float
    n: tuple[float, ...]
    k: tuple[float, ...]
    rgb: tuple[float, float, float]


def of_F0(F0: float) -> tuple[float, ...]:
    """The real index with that F0."""
    return ((1.0 + F0**0.5) / (1.0 - F0**0.5),)


GLASS = ((1.5,), (0.0,))

# What evalIridescence of three 0.187.0 and mx_fresnel_airy of MaterialX 1.39.5 gave in WebGL 2, the text
# of the packages unchanged, in 32 bits; and a plane rendered by Cycles 5.2.3.
RUNS = [
    Run("gltf_iridescence", 60, 0.01, 1.3, *GLASS, (0.154851, 0.137461, 0.134869)),
    Run("gltf_iridescence", 60, 1, 1.3, *GLASS, (0.103238, 0.093555, 0.092108)),
    Run("gltf_iridescence", 0, 100, 1.3, *GLASS, (0.003096, 0.004420, 0.007592)),
    Run("gltf_iridescence", 30, 300, 1.33, *GLASS, (0.038178, 0.012198, 0.015102)),
    Run("gltf_iridescence", 60, 50, 1.5, of_F0(0.9), (0.0,), (0.904162, 0.882378, 0.859575)),
    Run("materialx_airy", 0, 0.001, 1.3, *GLASS, (0.040005, 0.040002, 0.040019)),
    Run("materialx_airy", 0, 100, 1.3, *GLASS, (0.005975, 0.004052, 0.005854)),
    Run("materialx_airy", 60, 100, 1.3, *GLASS, (0.050487, 0.040076, 0.030563)),
    Run("materialx_airy", 75, 400, 2.0, *GLASS, (0.343582, 0.338872, 0.289814)),
    Run("materialx_airy", 0, 1, 1.0, *COPPER, (1.0, 0.439866, 0.511274)),
    Run("materialx_airy", 60, 200, 1.4, *COPPER, (1.0, 0.437410, 0.533277)),
    Run("materialx_airy", 80, 500, 1.8, (4.1,), (0.04,), (0.425279, 0.478155, 0.468198)),
    Run("materialx_schlick_airy", 0, 1, 1.0, of_F0(0.95), (0.0,), (0.475, 0.475, 0.475)),
    Run(
        "materialx_schlick_airy", 70, 100, 2.0, of_F0(0.04), (0.0,), (0.280177, 0.269342, 0.246714)
    ),
    Run("cycles_film", 60, 100, 1.3, *GLASS, (0.0498, 0.0402, 0.0292)),
]


def unpolarized(mu: Array, n: Array, k: Array) -> Array:
    """R by Fresnel's equations in complex numbers."""
    N = n + 1j * k
    q = np.sqrt(N**2 - 1.0 + mu**2)
    s, p = (mu - q) / (mu + q), (N**2 * mu - q) / (N**2 * mu + q)
    return np.asarray(0.5 * (np.abs(s) ** 2 + np.abs(p) ** 2))


def surface(
    thickness_nm: Array, incidence: Incidence, film_n: float, n: ArrayLike, k: ArrayLike
) -> CoatedSurface:
    eta, kappa = (np.broadcast_to(np.asarray(each, dtype=np.float64), (3,)) for each in (n, k))
    F0 = ((eta - 1.0) ** 2 + kappa**2) / ((eta + 1.0) ** 2 + kappa**2)
    F82 = unpolarized(np.array([1.0 / 7.0]), eta, kappa)
    rows, columns = thickness_nm.reshape(-1, 1, 1), incidence.cos.reshape(1, -1, 1)
    return CoatedSurface(rows, columns, np.array([film_n]), eta, kappa, F0, F82)


@pytest.mark.parametrize("run", RUNS, ids=lambda run: f"{run.model}-{run.thickness_nm:g}nm")
def test_a_shortcut_is_what_its_renderer_evaluates(run: Run) -> None:
    incidence = Incidence.from_degrees([run.theta_i_deg])
    at = surface(np.array([float(run.thickness_nm)]), incidence, run.film_n, run.n, run.k)
    found = film_models()[run.model].color(at)[0, 0]
    np.testing.assert_allclose(found, run.rgb, atol=6e-5)


def deviations() -> list[tuple[FilmModel, Deviation]]:
    return [(model, each) for model in film_models().values() for each in model.measured]


@pytest.mark.parametrize(
    ("model", "stated"),
    deviations(),
    ids=lambda each: getattr(each, "id", None) or f"{each.film_n}",
)
def test_the_error_of_a_shortcut_is_what_is_stated(model: FilmModel, stated: Deviation) -> None:
    thickness_nm = np.arange(0.0, 1001.0, 5.0)
    incidence = Incidence.from_degrees(np.arange(0.0, 86.0, 5.0))
    rows = Incidence(incidence.cos.reshape(-1, 1), incidence.sin.reshape(-1, 1))

    def stack(thickness: float, wavelength_nm: Array) -> Stack:
        layers = [Layer(stated.film_n, 0.0, thickness)]
        return Stack(1.0, layers, stated.n_t, stated.k_t, wavelength_nm=wavelength_nm)

    exact = swept_colors(stack(0.0, WAVELENGTH_NM), 0, thickness_nm, incidence, srgb_weights("D65"))
    R = np.array([np.mean(reflectances(stack(d, CHANNELS_NM), rows), axis=0) for d in thickness_nm])
    at = surface(thickness_nm, incidence, stated.film_n, stated.n_t, stated.k_t)
    off = delta_e_2000(lab(model.color(at)), lab(exact))
    assert np.abs(model.reflectance(at, CHANNELS_NM) - R).max() == pytest.approx(
        stated.max_abs, abs=1e-4
    )
    assert off.max() == pytest.approx(stated.max_delta_e, abs=0.01)
    assert off.mean() == pytest.approx(stated.mean_delta_e, abs=0.001)


def test_every_shortcut_states_the_same_surfaces() -> None:
    stated = {
        model.id: [(each.film_n, each.n_t, each.k_t) for each in model.measured]
        for model in film_models().values()
    }
    assert len(stated) == 5
    assert len({tuple(each) for each in stated.values()}) == 1


@pytest.mark.parametrize("model", ["materialx_airy", "cycles_film"])
def test_a_film_that_thins_away_leaves_the_surface(model: str) -> None:
    incidence = Incidence.from_degrees([0.0, 60.0])
    found = film_models()[model].reflectance(
        surface(np.array([1e-9]), incidence, 1.3, 1.5, 0.0), CHANNELS_NM
    )
    R = [0.04, 0.08918671]  # of bare glass, from Fresnel's equations at 0 and 60 degrees
    np.testing.assert_allclose(found[0, :, 1], R, atol=1e-4)


def test_three_jumps_above_thickness_0() -> None:
    incidence = Incidence.from_degrees([60.0])
    at = surface(np.array([0.0, 0.01]), incidence, 1.3, 1.5, 0.0)
    bare, thinnest = film_models()["gltf_iridescence"].color(at)[:, 0, 0]
    assert bare < 0.08
    assert thinnest > 0.15


@pytest.mark.parametrize("N", [1.5 + 2.0j, 0.27 + 2.9j, 2.9 + 3.0j, 0.9 + 6.0j])
def test_openpbr_finds_the_metal_behind_its_two_colors(N: complex) -> None:
    """F0 and F82 alone bring back n and k, where |N| is at least 1 and no tint above 1 is wanted."""
    n, k = np.array([N.real]), np.array([N.imag])
    F0, F82 = (unpolarized(np.array([mu]), n, k) for mu in (1.0, 1.0 / 7.0))
    assert F82 < F0 + (1.0 - F0) * (6.0 / 7.0) ** 5
    np.testing.assert_allclose(effective_index(F0, F82), [n, k], rtol=1e-9)


def test_openpbr_takes_a_tint_of_1_where_a_metal_wants_more() -> None:
    """Potassium reflects at 82 degrees more than Schlick's curve, which is all that a tint can say."""
    n, k = np.array([0.05]), np.array([1.5])
    F0, F82 = (unpolarized(np.array([mu]), n, k) for mu in (1.0, 1.0 / 7.0))
    schlick = F0 + (1.0 - F0) * (6.0 / 7.0) ** 5
    assert schlick < F82
    found = unpolarized(np.array([1.0, 1.0 / 7.0]), *effective_index(F0, F82))
    np.testing.assert_allclose(found, [F0[0], schlick[0]], rtol=1e-9)


@pytest.mark.parametrize("model", [model.id for model in film_models().values()])
def test_a_film_rarer_than_air_is_defined_at_every_angle(model: str) -> None:
    incidence = Incidence.from_degrees(np.linspace(0.0, 90.0, 19))
    at = surface(np.array([0.0, 50.0, 5e5]), incidence, 0.8, 1.5, 0.5)
    assert np.isfinite(film_models()[model].color(at)).all()
