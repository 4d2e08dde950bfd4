"""`/lut`: tables in every format, the error they state, and what is refused."""

import io
from typing import Any

import numpy as np
import OpenEXR
import png
import pytest
from numpy.typing import NDArray

from app.materials.appearance import color_curve
from app.materials.media import default_catalog
from app.optics.albedo import albedo
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.registry import default_registry
from tests.api.shape import Ask, error_of, json_of

Array = NDArray[np.float64]

ANGLES = 10_000
FLOAT_ROUNDING = 2.0**-24


def exact(mu: Array, n_t: Any = 1.5, k_t: Any = 0.0, n_i: Any = 1.0) -> Array:
    """The textbook's quotients, in complex arithmetic."""
    N = n_t + 1j * np.asarray(k_t)
    q = np.sqrt(N**2 - n_i**2 * (1.0 - mu**2))
    r_s = (n_i * mu - q) / (n_i * mu + q)
    r_p = (N**2 * mu - n_i * q) / (N**2 * mu + n_i * q)
    return np.asarray(0.5 * (np.abs(r_s) ** 2 + np.abs(r_p) ** 2))


def pixels(body: bytes) -> tuple[NDArray[Any], dict[str, Any]]:
    width, height, rows, info = png.Reader(bytes=body).read()
    return np.array([list(row) for row in rows]).reshape(height, width, -1), info


@pytest.mark.parametrize("bits", [8, 16, 32])
@pytest.mark.parametrize("media", [{}, {"n_i": 1.5, "n_t": 1}, {"n_t": 0.27, "k_t": 2.9}])
@pytest.mark.parametrize("size", [2, 7, 256, 4096])
def test_the_stated_error_holds_at_random_angles(
    ask: Ask, size: int, bits: int, media: dict[str, float]
) -> None:
    answer = ask("/lut", size=size, bits=bits, **media)
    told = json_of(answer)
    error = told["error"]["max_abs"]
    assert answer.headers["interpolation-error"] == f"{error:g}"
    mu = np.random.default_rng(size).random(ANGLES)
    read = np.interp(mu, np.linspace(0.0, 1.0, size), told["texels"])
    off = np.abs(read - exact(mu, **media))
    assert off.max() <= error
    # It is reached, not a bound from theory: at the place named, to the digits it has.
    at = np.array(told["error"]["at"]["mu"])
    there = np.abs(np.interp(at, np.linspace(0.0, 1.0, size), told["texels"]) - exact(at, **media))
    assert error * 0.985 <= there <= error


@pytest.mark.parametrize("model", ["schlick", "f82_tint", "lagarde_gc", "lazanyi2005"])
def test_any_model(ask: Ask, model: str) -> None:
    media = (1.0, 1.5, 0.0) if model == "lagarde_gc" else (1.0, 2.9, 3.0)
    names = dict(zip(("n_i", "n_t", "k_t"), media, strict=True))
    told = ask("/lut", model=model, size=33, **names).json()
    grid = Incidence.from_cosine(np.linspace(0.0, 1.0, 33))
    R = default_registry()[model](Interface(*media), grid)
    np.testing.assert_allclose(told["texels"], R, rtol=0.0, atol=FLOAT_ROUNDING)
    mu = np.random.default_rng(1).random(ANGLES)
    between = default_registry()[model](Interface(*media), Incidence.from_cosine(mu))
    assert (
        np.abs(np.interp(mu, grid.cos, told["texels"]) - between).max() <= told["error"]["max_abs"]
    )


def test_three_values_of_a_parameter_are_three_channels(ask: Ask) -> None:
    told = ask("/lut", model="schlick", size=5, **{"schlick.F0": "1,0.766,0.336"}).json()
    assert told["channels"] == ["red", "green", "blue"]
    rise = (1.0 - np.linspace(0.0, 1.0, 5)[:, np.newaxis]) ** 5
    F0 = np.array([1.0, 0.766, 0.336])
    np.testing.assert_allclose(told["texels"], F0 + (1.0 - F0) * rise, atol=FLOAT_ROUNDING)


def test_a_material_in_rgb(ask: Ask) -> None:
    told = ask("/lut", material="Au", channels=3, size=64).json()
    mu = np.linspace(0.0, 1.0, 64)
    spectrum = default_catalog().spectrum("Au")
    colors = color_curve(spectrum, Incidence.from_cosine(mu))
    np.testing.assert_allclose(told["texels"], colors, rtol=0.0, atol=1e-7)
    some = np.random.default_rng(2).random(500)
    true = color_curve(spectrum, Incidence.from_cosine(some))
    read = np.stack([np.interp(some, mu, row) for row in np.array(told["texels"]).T], axis=-1)
    assert np.abs(read - true).max() <= told["error"]["max_abs"]
    picture, info = pixels(ask("/lut", material="Fe", channels=3, size=64, format="png").content)
    assert (info["bitdepth"], info["greyscale"], info["gamma"]) == (16, False, 1.0)
    iron = color_curve(default_catalog().spectrum("Fe"), Incidence.from_cosine(mu))
    np.testing.assert_allclose(picture[0] / 65535.0, iron, rtol=0.0, atol=0.5001 / 65535.0)


@pytest.mark.parametrize(("index", "low", "high"), [("n_t", 1.05, 3.0), ("k_t", 0.0, 5.0)])
@pytest.mark.parametrize("bits", [8, 32])
def test_two_coordinates(ask: Ask, index: str, low: float, high: float, bits: int) -> None:
    told = ask(
        "/lut", over=f"mu,{index}", size=64, rows=24, minimum=low, maximum=high, bits=bits
    ).json()
    assert [axis["name"] for axis in told["axes"]] == ["mu", index]
    texels = np.array(told["texels"])
    assert texels.shape == (24, 64)
    rng = np.random.default_rng(3)
    mu, y = rng.random(ANGLES), low + (high - low) * rng.random(ANGLES)
    u, v = mu * 63, (y - low) / (high - low) * 23
    i, j = u.astype(int), v.astype(int)
    u, v = u - i, v - j
    below = (1 - u) * texels[j, i] + u * texels[j, i + 1]
    above = (1 - u) * texels[j + 1, i] + u * texels[j + 1, i + 1]
    off = np.abs((1 - v) * below + v * above - exact(mu, **{index: y}))
    assert off.max() <= told["error"]["max_abs"]
    assert off.max() >= 0.5 * told["error"]["max_abs"]
    grid = exact(np.linspace(0, 1, 64), **{index: np.linspace(low, high, 24)[:, np.newaxis]})
    half_step = 0.5 / 255 if bits == 8 else FLOAT_ROUNDING
    np.testing.assert_allclose(texels, grid, rtol=0.0, atol=1.001 * half_step + 1e-12)


@pytest.mark.parametrize(("index", "fixed"), [("n_t", {}), ("k_t", {"n_t": 0.3})])
def test_albedo(ask: Ask, index: str, fixed: dict[str, float]) -> None:
    told = ask("/lut", over=index, minimum=0.5, maximum=3, size=65, **fixed).json()
    assert told["quantity"] == "albedo"
    at = 0.5 + 2.5 * np.random.default_rng(4).random(1000)
    media = {"n_t": fixed.get("n_t", 1.5), "k_t": 0.0} | {index: at}
    true = albedo(Interface(1.0, media["n_t"], media["k_t"])).unpolarized
    read = np.interp(at, np.linspace(0.5, 3.0, 65), told["texels"])
    assert np.abs(read - true).max() <= told["error"]["max_abs"]


class TestFormats:
    @pytest.mark.parametrize(("bits", "steps"), [(8, 255), (16, 65535)])
    def test_png(self, ask: Ask, bits: int, steps: int) -> None:
        answer = ask("/lut", size=19, bits=bits, format="png")
        assert answer.headers["content-type"] == "image/png"
        assert answer.headers["content-disposition"] == 'inline; filename="exact_mu_19.png"'
        picture, info = pixels(answer.content)
        assert picture.shape == (1, 19, 1)
        assert (info["bitdepth"], info["gamma"]) == (bits, 1.0)
        true = np.rint(exact(np.linspace(0.0, 1.0, 19)) * steps)
        np.testing.assert_array_equal(picture[0, :, 0], true)
        texts = dict(
            text.split(b"\0", 1)
            for kind, text in png.Reader(bytes=answer.content).chunks()
            if kind == b"tEXt"
        )
        assert texts[b"Interpolation-Error"].decode() == answer.headers["interpolation-error"]
        assert b"(x (N - 1) + 1/2) / N" in texts[b"Description"]

    @pytest.mark.parametrize(("bits", "dtype"), [(16, np.float16), (32, np.float32)])
    def test_exr(self, ask: Ask, bits: int, dtype: type) -> None:
        answer = ask("/lut", size=19, over="mu,n_t", rows=5, bits=bits, format="exr")
        file = OpenEXR.File(io.BytesIO(answer.content))
        stored = file.channels()["Y"].pixels
        assert stored.dtype == dtype
        n_t = np.linspace(0.1, 5.0, 5)[:, np.newaxis]
        true = exact(np.linspace(0.0, 1.0, 19), n_t=n_t)
        np.testing.assert_allclose(stored, true, rtol=0.0, atol=1e-3 if bits == 16 else 1e-7)
        assert file.header()["Interpolation-Error"] == answer.headers["interpolation-error"]

    def test_exr_in_rgb(self, ask: Ask) -> None:
        query = {"material": "Au", "channels": 3, "size": 9}
        file = OpenEXR.File(io.BytesIO(ask("/lut", format="exr", **query).content))
        stored = file.channels()["RGB"].pixels
        np.testing.assert_array_equal(stored[0], np.float32(ask("/lut", **query).json()["texels"]))

    @pytest.mark.parametrize(("bits", "dtype"), [(8, np.uint8), (16, np.uint16), (32, np.float32)])
    def test_npy(self, ask: Ask, bits: int, dtype: type) -> None:
        stored = np.load(io.BytesIO(ask("/lut", size=19, bits=bits, format="npy").content))
        assert (stored.dtype, stored.shape) == (dtype, (19,))
        scale = 1.0 if bits == 32 else 2.0**bits - 1.0
        texels = ask("/lut", size=19, bits=bits).json()["texels"]
        np.testing.assert_array_equal(stored / scale, np.array(texels))

    def test_tables_of_equal_texels_keep_their_names_and_errors(self, ask: Ask) -> None:
        """Two indices that 8 bits do not tell apart, and two models that are one here."""
        close = [{"bits": 8, "n_t": 1.5}, {"bits": 8, "n_t": 1.504}]
        alike = [{"model": "schlick"}, {"model": "schlick_four_percent"}]
        for pair, header in ((close, "interpolation-error"), (alike, "content-disposition")):
            for _ in range(2):
                first, second = (ask("/lut", size=2, format="npy", **query) for query in pair)
                assert first.content == second.content
                assert first.headers[header] != second.headers[header]

    def test_csv(self, ask: Ask) -> None:
        answer = ask("/lut", size=3, over="mu,k_t", rows=2, maximum=4, format="csv")
        lines = answer.text.splitlines()
        assert lines[0] == "mu,k_t,R"
        assert [line.rsplit(",", 1)[0] for line in lines[1:]] == [
            "0.0,0.0", "0.5,0.0", "1.0,0.0", "0.0,4.0", "0.5,4.0", "1.0,4.0"
        ]  # fmt: skip
        values = [float(line.rsplit(",", 1)[1]) for line in lines[1:]]
        true = exact(np.tile([0.0, 0.5, 1.0], 2), k_t=np.repeat([0.0, 4.0], 3))
        np.testing.assert_allclose(values, true, rtol=0.0, atol=FLOAT_ROUNDING)

    def test_an_answer_known_already_says_its_error_too(self, ask: Ask) -> None:
        first = ask("/lut", size=16, format="png")
        again = ask("/lut", {"if-none-match": first.headers["etag"]}, size=16, format="png")
        assert again.status_code == 304
        assert again.headers["interpolation-error"] == first.headers["interpolation-error"]


def test_errors_fall_fourfold_a_doubling_until_the_depth_is_reached(ask: Ask) -> None:
    told = json_of(ask("/lut/errors", n_t=1.5))
    assert told["sizes"] == [2**power for power in range(1, 13)]
    errors = np.array(told["max_abs"]["float"], dtype=float)
    ratios = errors[4:-1] / errors[5:]  # from 32 texels on; below, the curve is not yet resolved
    assert np.all((ratios > 3.6) & (ratios < 4.1))
    for depth, steps in (("unorm8", 255), ("unorm16", 65535)):
        last = told["max_abs"][depth][-1]
        assert last is not None
        assert 0.9 * 0.5 / steps < last < 1.1 * 0.5 / steps
    for size, error in zip(told["sizes"], told["max_abs"]["unorm16"], strict=True):
        assert ask("/lut", size=size, bits=16).json()["error"]["max_abs"] == error


@pytest.mark.parametrize(
    "media",
    [{"material": "Au"}, {"material": "BK7", "layers": "MgF2:99.6"}],
    ids=["a material", "a film"],
)
def test_errors_of_tables_of_colors_are_those_of_the_tables(
    ask: Ask, media: dict[str, str]
) -> None:
    told = json_of(ask("/lut/errors", channels=3, **media))
    assert told["quantity"] == "R in linear sRGB"
    assert told["max_abs"] != ask("/lut/errors", **media).json()["max_abs"]
    for size, bits, depth in ((4, 32, "float"), (256, 16, "unorm16"), (512, 8, "unorm8")):
        error = told["max_abs"][depth][told["sizes"].index(size)]
        if error is None:  # a channel below 0, which no integer holds
            assert ask("/lut", channels=3, size=size, bits=bits, **media).status_code == 422
            continue
        table = ask("/lut", channels=3, size=size, bits=bits, **media).json()
        assert table["error"]["max_abs"] == error


def test_errors_of_colors_of_many_layers_are_refused(ask: Ask) -> None:
    error = error_of(ask("/lut/errors", channels=3, layers="1.38:100,2:100,1.38:90,2:90"))
    assert error["parameter"] == "layers"
    assert "at most 3 layers" in error["message"]
    error = error_of(ask("/lut/errors", channels=3, layers="1.38:3000,2:3000"))
    assert error["message"].startswith("at most 500 layers times wavelengths")
    assert error_of(ask("/lut/errors", channels=3))["parameter"] == "channels"


def test_errors_of_values_that_no_integer_holds_are_null(ask: Ask) -> None:
    told = ask("/lut/errors", model="generalized_schlick", **{"generalized_schlick.a": 20}).json()
    assert told["max_abs"]["unorm8"][-1] is None
    assert told["max_abs"]["float"][-1] < 1e-5
