"""Ids that carry a material: what they keep, how long they are, and what is refused."""

import base64
import zlib

import numpy as np
import orjson
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.materials.catalog import Catalog
from app.materials.errors import UnknownMaterial
from app.materials.media import default_catalog
from app.materials.own.token import CLOSE, LONGEST, PREFIX, BrokenToken, OwnData, read, write
from app.materials.schema import Formula, Points
from app.optics.parameters import Array


def points(x: Array, values: Array) -> Points:
    return Points(kind="points", wavelength_nm=tuple(x.tolist()), values=tuple(values.tolist()))


def data(n: Points | Formula, k: Points | Formula | None = None) -> OwnData:
    return OwnData(name="mine", relative_to=None, n=n, k=k)


def apart(given_: Points, token: str, quantity: str) -> float:
    """Largest distance to linear interpolation of what the token says, at ten times the points."""
    taken = getattr(read(token), quantity)
    x = np.array(given_.wavelength_nm)
    fine = np.interp(np.linspace(0, x.size - 1, 10 * x.size), np.arange(x.size), x)
    return float(
        np.abs(
            np.interp(fine, taken.wavelength_nm, taken.values) - np.interp(fine, x, given_.values)
        ).max()
    )


GRID = np.linspace(300.0, 1500.0, 200)
RANDOM = np.random.default_rng(14)


@pytest.mark.parametrize(
    ("n", "k"),
    [
        (1.5 + 0.3 * np.sin(GRID / 100), 0.1 + 0.09 * np.cos(GRID / 70)),
        (1.5 + RANDOM.normal(0, 0.1, 200), np.abs(RANDOM.normal(2, 0.5, 200))),
        (np.full(200, 2.0), np.geomspace(1e-9, 30.0, 200)),
        (np.geomspace(0.01, 90.0, 200), np.zeros(200)),
    ],
)
def test_200_points_are_kept_to_1e_5_within_the_length(n: Array, k: Array) -> None:
    given_n, given_k = points(GRID, n), points(GRID, k)
    made = write(data(given_n, given_k))
    assert len(made.token) < LONGEST
    assert apart(given_n, made.token, "n") <= CLOSE
    assert apart(given_k, made.token, "k") <= CLOSE
    assert made.largest_difference_n <= CLOSE


def test_points_on_lines_are_left_out_and_no_others() -> None:
    x = np.linspace(400.0, 800.0, 401)
    made = write(data(points(x, np.interp(x, [400, 550, 800], [1.5, 1.6, 1.4]))))
    assert (made.points_given, made.points_kept) == (401, 3)
    assert made.largest_difference_n < 1e-6


def test_small_k_keeps_its_digits() -> None:
    """Absorption of glass counts over centimeters: 1e-5 would be all of it."""
    x = np.linspace(400.0, 800.0, 100)
    k = 1e-8 * (2.0 + np.sin(x / 20))
    made = write(data(points(x, np.full(100, 1.5)), points(x, k)))
    taken = read(made.token).k
    assert isinstance(taken, Points)
    assert np.interp(x, taken.wavelength_nm, taken.values) == pytest.approx(k, rel=2e-3)


def test_n_and_k_keep_wavelengths_of_their_own() -> None:
    n = points(np.array([300.0, 900.0]), np.array([1.5, 1.4]))
    k = points(np.array([350.0, 400.0, 700.0]), np.array([0.0, 0.1, 0.3]))
    assert read(write(data(n, k)).token) == data(n, k)


def test_a_formula_is_kept_as_it_is() -> None:
    formula = Formula(
        kind="formula",
        number=2,
        coefficients=(0.0, 1.03961212, 0.00600069867),
        range_nm=(300.0, 2500.0),
    )
    taken = read(write(OwnData(name="glass", relative_to="air", n=formula, k=None)).token)
    assert taken == OwnData(name="glass", relative_to="air", n=formula, k=None)


def test_what_is_too_much_is_averaged_and_told() -> None:
    x = np.linspace(300.0, 1500.0, 20_000)
    noisy = points(x, 1.5 + RANDOM.normal(0, 0.01, x.size))
    made = write(data(noisy))
    assert len(made.token) <= LONGEST
    assert made.is_coarse
    assert made.largest_difference_n == pytest.approx(
        float(
            np.abs(
                np.interp(x, read(made.token).n.wavelength_nm, read(made.token).n.values)  # type: ignore[union-attr]
                - noisy.values
            ).max()
        )
    )


@given(
    st.lists(st.floats(1.0, 1e6), min_size=1, max_size=60, unique=True),
    st.integers(0, 2**32),
)
def test_any_spectrum_comes_back(wavelengths: list[float], seed: int) -> None:
    random = np.random.default_rng(seed)
    x = np.array(sorted(wavelengths))
    n = points(x, random.uniform(0.01, 99.0, x.size))
    k = points(x, random.uniform(0.0, 99.0, x.size))
    made = write(data(n, k))
    taken = read(made.token)
    assert isinstance(taken.n, Points)
    assert taken.n.wavelength_nm[0] == pytest.approx(x[0], rel=1e-8)
    assert taken.n.wavelength_nm[-1] == pytest.approx(x[-1], rel=1e-8)
    if np.diff(x, append=2e6).min() > 1e-3 * x.max():
        assert made.largest_difference_n <= CLOSE
        assert made.largest_difference_k is not None
        assert made.largest_difference_k <= CLOSE


TOKEN = write(data(points(GRID, 1.5 + 0.1 * np.sin(GRID / 100)))).token


@pytest.mark.parametrize(
    ("token", "words"),
    [
        (TOKEN[:-4], "cut or changed"),
        (TOKEN[:50] + ("A" if TOKEN[50] != "A" else "B") + TOKEN[51:], "cut or changed"),
        (TOKEN + "!", "letters"),
        (PREFIX + "A" * LONGEST, "letters"),
        (PREFIX, "another version"),
        (PREFIX + "Zm9yZWlnbg", "another version"),
    ],
)
def test_a_broken_token_says_so(token: str, words: str) -> None:
    with pytest.raises(BrokenToken) as raised:
        read(token)
    assert words in raised.value.allowed


def forged(body: object, packed: bytes | None = None) -> str:
    compressed = zlib.compress(orjson.dumps(body)) if packed is None else packed
    content = b"\x01" + zlib.crc32(compressed).to_bytes(4, "big") + compressed
    return PREFIX + base64.urlsafe_b64encode(content).decode().rstrip("=")


N = {"x": [0, 0, 400, 500], "y": [1, 0, 15, 16]}


@pytest.mark.parametrize(
    "body",
    [
        [],
        {"name": "a"},
        {"name": "", "n": N},
        {"name": "a\nb", "n": N},
        {"name": "a" * 100, "n": N},
        {"name": "a", "n": N, "odd": 1},
        {"name": "a", "n": N, "relative_to": "water"},
        {"name": "a", "n": N | {"x": [0, 0, 500, 400]}},
        {"name": "a", "n": N | {"x": [0, 0, 400]}},
        {"name": "a", "n": N | {"x": [0, 0, -1, 400]}},
        {"name": "a", "n": N | {"x": [99, 0, 400, 500]}},
        {"name": "a", "n": N | {"x": [0, 9, 400, 500]}},
        {"name": "a", "n": N | {"y": [0, 0, 0, 1]}},
        {"name": "a", "n": N | {"y": [0, 0, 1.5, 1]}},
        {"name": "a", "n": N | {"y": [0, 0, True, 1]}},
        {"name": "a", "n": N | {"y": [0, 2, 2**63, 2**63]}},
        {"name": "a", "n": N | {"y": "text"}},
        {"name": "a", "n": N, "k": {"y": [0, 0, -1, 1]}},
        {"name": "a", "n": {"f": 2, "c": [0.0, 1.0], "r": [300, 400]}},
        {"name": "a", "n": {"f": 99, "c": [0.0], "r": [300, 400]}},
        {"name": "a", "n": {"f": 5, "c": [1.5], "r": [400, 300]}},
        {"name": "a", "n": {"f": 5, "c": [-1.5], "r": [300, 400]}},
    ],
)
def test_a_forged_token_is_no_material(body: object) -> None:
    with pytest.raises(BrokenToken, match="no material"):
        read(forged(body))


def test_what_expands_without_end_is_given_up() -> None:
    with pytest.raises(BrokenToken, match="no material"):
        read(forged(None, zlib.compress(b"[" * 5_000_000, 9)))


def test_the_catalog_finds_it_and_lists_it_nowhere() -> None:
    catalog: Catalog = default_catalog()
    preset = catalog.get(TOKEN)
    assert (preset.id, preset.name, preset.called) == (TOKEN, "mine", "own-mine")
    assert catalog.find(TOKEN) == preset
    assert catalog.get(f" {TOKEN}\n") == preset  # as it is copied out of a line
    assert catalog.find(TOKEN[:-4]) is None
    assert catalog.rivals(TOKEN) == ()
    assert all(other.id != TOKEN for other in catalog.search("mine"))
    with pytest.raises(UnknownMaterial, match="cut or changed"):
        catalog.get(TOKEN[:-4])
