"""Finding materials: ids, aliases, typing errors, categories, rivals, constants."""

import tracemalloc
from collections import Counter

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.materials.catalog import Catalog, load_catalog
from app.materials.errors import NoSpectrum, UnknownMaterial, WavelengthOutOfRange
from app.optics.errors import NotAllowed, UnknownName

LOAD_BYTES = 40e6

CONDUCTORS = {"metal", "alloy", "semimetal", "semiconductor", "ceramic"}
DIELECTRICS = {"gas", "liquid", "glass", "polymer", "crystal"}


def test_there_is_enough_of_everything(catalog: Catalog) -> None:
    chosen = [p for p in catalog.presets if p.kind == "spectrum" and p.rival_of is None]
    assert sum(preset.category in CONDUCTORS for preset in chosen) >= 30
    assert sum(preset.category in DIELECTRICS for preset in chosen) >= 25
    assert sum(preset.rival_of is not None for preset in catalog.presets) >= 20
    tables = Counter(p.id.rsplit("-", 1)[1] for p in catalog.presets if p.kind == "single")
    assert tables == {"shirley": 19, "wloka": 23}


ASKED = {"Au": ["Au", "au", "gold", "GOLD", " aurum "], "water": ["water", "H2O"]}
ASKED |= {"diamond": ["Diamond"], "NaCl": ["salt"], "garnet-wloka": ["garnet"]}
ASKED |= {"stainless": ["steel"], "Co": ["Co"], "CO2": ["CO2"], "Au-Johnson": ["au-johnson"]}


@pytest.mark.parametrize(
    ("asked", "found"), [(asked, found) for found, words in ASKED.items() for asked in words]
)
def test_ids_aliases_and_names_lead_there(catalog: Catalog, asked: str, found: str) -> None:
    assert catalog.get(asked).id == found


ELEMENTS = """
hydrogen helium lithium beryllium boron carbon nitrogen oxygen fluorine neon sodium magnesium
aluminium aluminum silicon phosphorus sulfur sulphur chlorine argon potassium calcium scandium
titanium vanadium chromium manganese iron cobalt nickel copper zinc gallium germanium arsenic
selenium bromine krypton rubidium strontium yttrium zirconium niobium molybdenum technetium
ruthenium rhodium palladium silver cadmium indium tin antimony tellurium iodine xenon cesium
caesium barium lanthanum cerium praseodymium neodymium promethium samarium europium gadolinium
terbium dysprosium holmium erbium thulium ytterbium lutetium hafnium tantalum tungsten rhenium
osmium iridium platinum gold mercury thallium lead bismuth polonium astatine radon francium radium
actinium thorium protactinium uranium
"""
MATERIALS = """
air alumina amber asphalt bone brick bronze butter cardboard cement ceramic chalk charcoal clay
coal concrete cork cotton dirt fabric fat felt flint foam glass glue granite gravel grease gypsum
hair honey ink ivory jade lacquer leather lime linen marble mica milk mud nylon oil opal paint
paper pearl pewter pitch plaster plastic porcelain quartz resin rubber rust salt sand silica silk
skin slate snow soap soil solder soot starch steam steel stone sugar tar teflon tile vinegar wax
wood wool zinc ice water brass
"""
FORMULAS = """
CO NO HF HI HBr SiO PbO PbS CaO CuO NiO ZnO SnO FeO MnO CoO BN AlN GaN InN SiN HCl CN OH NH PH TiO
VO NaH
"""


@pytest.mark.parametrize("word", (ELEMENTS + MATERIALS).split())
def test_a_word_for_a_material_answers_no_other(catalog: Catalog, word: str) -> None:
    for spelled in (word, word.upper(), word.title()):
        found = catalog.find(spelled)
        called = () if found is None else (found.name, *found.aliases)
        assert found is None or any(
            word in name.casefold().split(",")[0].split() for name in called
        )


@pytest.mark.parametrize("formula", FORMULAS.split())
def test_a_formula_answers_no_other(catalog: Catalog, formula: str) -> None:
    found = catalog.find(formula)
    assert found is None or formula in (found.id, *found.aliases)


def test_tin_is_no_nitride(catalog: Catalog) -> None:
    for word in ("tin", "TIN", "Tin", " tin "):
        with pytest.raises(UnknownMaterial):
            catalog.get(word)
    assert catalog.get("TiN").id == catalog.get(" TiN").id == "TiN"
    assert pytest.approx(0.586, abs=5e-4) == catalog.get("titanium nitride").F0
    assert catalog.get("co").id == catalog.get("cobalt").id == "Co"


TYPED = {"Au": "Aurumm arum golde goold", "Cu": "coper", "Al": "aluminnium"}
TYPED |= {"diamond": "diamnod", "PMMA": "plexiglass", "sapphire-o": "saphire"}


@pytest.mark.parametrize(
    ("typed", "meant"), [(typed, meant) for meant, all_ in TYPED.items() for typed in all_.split()]
)
def test_typing_errors_are_answered_with_what_was_meant(
    catalog: Catalog, typed: str, meant: str
) -> None:
    with pytest.raises(UnknownMaterial) as caught:
        catalog.get(typed)
    assert caught.value.parameter == "material"
    assert caught.value.nearest[0] == meant
    assert meant in caught.value.allowed


def test_nothing_like_it_has_no_suggestion(catalog: Catalog) -> None:
    with pytest.raises(UnknownName) as caught:
        catalog.get("zzzzzzzz")
    assert caught.value.nearest == []


@pytest.mark.parametrize("query", ["au", "gold", "Aurum", "GOL", "Au"])
def test_search_finds_gold_first(catalog: Catalog, query: str) -> None:
    assert catalog.search(query)[0].id == "Au"


def test_search_ranks_rivals_after_materials_and_references_last(catalog: Catalog) -> None:
    gold = [preset.id for preset in catalog.search("gold")]
    assert gold[0] == "Au"
    assert {"Au-Johnson", "Au-Babar"} <= set(gold[1:])
    johnson = [preset.id for preset in catalog.search("Christy")]
    assert {"Ag", "Cu", "Ni", "Au-Johnson"} <= set(johnson)


def test_search_within_a_category(catalog: Catalog) -> None:
    assert {preset.category for preset in catalog.search(category="alloy")} == {"alloy"}
    assert catalog.search("brass", "alloy")[0].id == "brass"
    assert catalog.search("brass", "gas") == ()
    assert catalog.search("  ") == catalog.search() == catalog.presets
    counted = sum(len(catalog.search(category=category)) for category in catalog.categories)
    assert counted == len(catalog.presets)


@settings(deadline=None)
@given(text=st.text(max_size=12))
def test_any_text_can_be_asked_for(catalog: Catalog, text: str) -> None:
    found = catalog.search(text)
    assert len(found) == len({preset.id for preset in found})
    assert all(catalog.get(id).id == id for id in catalog.nearest(text))  # noqa: A001


def test_every_preset_is_found_by_its_id(catalog: Catalog) -> None:
    assert all(catalog.get(preset.id) is preset for preset in catalog.presets)
    assert all(catalog.search(preset.id)[0].id == preset.id for preset in catalog.presets)


def test_constants_at_the_reference_and_elsewhere(catalog: Catalog) -> None:
    gold = catalog.get("Au")
    there = catalog.constants("gold")
    assert there.n == pytest.approx(gold.n)
    assert there.k == pytest.approx(gold.k)
    assert there.wavelength_nm == 587.6
    assert catalog.constants("Au", 450.0).n > 1.0
    assert catalog.constants("fused-silica").k is None
    with pytest.raises(WavelengthOutOfRange, match="300 to 24930 nm"):
        catalog.constants("Au", 250.0)


def test_single_indices_hold_at_their_own_wavelength_alone(catalog: Catalog) -> None:
    assert catalog.constants("water-shirley").n == 1.333
    assert catalog.constants("water-shirley", 589.0).n == 1.333
    with pytest.raises(WavelengthOutOfRange, match="589 nm"):
        catalog.constants("water-shirley", 500.0)
    assert catalog.constants("water-wloka").wavelength_nm is None
    with pytest.raises(NotAllowed, match="names none"):
        catalog.constants("water-wloka", 589.0)
    with pytest.raises(NoSpectrum, match="single index"):
        catalog.spectrum("water-wloka")


def test_spectra_are_read_once(catalog: Catalog) -> None:
    assert catalog.spectrum("gold") is catalog.spectrum("Au")


def test_rivals_know_each_other(catalog: Catalog) -> None:
    of_gold = {preset.id for preset in catalog.rivals("Au")}
    assert of_gold == {"Au-Johnson", "Au-McPeak", "Au-Babar", "Au-Olmon-sc", "Au-Hagemann"}
    assert {preset.id for preset in catalog.rivals("Au-Babar")} == of_gold - {"Au-Babar"} | {"Au"}
    assert catalog.rivals("garnet-wloka") == ()
    alone = catalog.spread("Hg")
    assert alone.minimum == alone.maximum == catalog.get("Hg").color.luminance


def test_loading_is_small_even_with_every_spectrum() -> None:
    tracemalloc.start()
    try:
        catalog = load_catalog()
        for preset in catalog.presets:
            if preset.kind == "spectrum":
                assert catalog.spectrum(preset.id).visible.n.size == 471
        used, peak = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert max(used, peak) < LOAD_BYTES


def test_a_maker_is_named_once_and_a_rival_that_is_another_product_by_its_own_name(
    catalog: Catalog,
) -> None:
    """OHARA makes no N-BK7: its equivalent is called S-BSL7."""
    assert catalog.get("BK7-OHARA").name == "S-BSL7 (Ohara)"
    makers = ("Schott", "Ohara", "Hoya", "Sumita", "CDGM")
    for preset in catalog.presets:
        assert sum(maker.lower() in preset.name.lower() for maker in makers) <= 1, preset.name
