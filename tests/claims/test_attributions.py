"""Nothing is put into a source's mouth: what each claim and each example rests on, word for word.

The words were compared with the four texts; with `FRESNEL_SOURCES`, a folder of them as `*.txt`, they
are compared again. A claim or an example that is new has to be looked up before it may stand here.
"""

import os
import re
from pathlib import Path

import numpy as np
import pytest

from app.claims import CLAIMS
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.registry import default_registry

STATIC = Path(__file__).parents[2] / "static" / "js"
FILES = {"P. Shirley": "shirley", "S. Lagarde": "lagarde", "M. Wloka": "wloka", "E. d'Eon": "deon"}
QUOTES = {
    "f0-is-linear": "be careful about gamma",
    "when-in-doubt": "When in doubt, use 1.5",
    "adds-to-one": "The fraction of how much light is transmitted and how much is reflected adds to one",
    "brewster-zero": "R_p goes to zero for one angle",
    "water-23-percent": "for this particular one it is 23% reflected",
    "copper-schlick": "we can probably use the Schlick equations but with different base cases",
    "metals-vary": "the refractive index for metals can vary a lot with wavelength",
    "schlick-glass": "OK that is close!",
    "schlick-cheaper": "a lot easier and cheaper",
    "wrong-angle-in-glass": "instead of $\\cos \\theta_i$ in the FresnelSchlick when $n_i > n_t$",
    "same-both-ways": "as the expression is square “i” and “t” can be swap",
    "schlick-knows-no-tir": "FresnelSchlick don’t handle TIR",
    "schlick-tir-fixes-it": "This can be fix by using $\\cos \\theta_t$",
    "air-is-vacuum": "Air IOR is 1.000293 and is approximate to 1",
    "index-from-F0": "$n_t=\\frac{(1+\\sqrt{R(0)})}{(1-\\sqrt{R(0)})}$",
    "forms-agree": "An equivalent expression can be derive from the [1] formulation by setting $k_t=0$",
    "conductor-form-k0": "should not be used for Dielectric-Dielectric interface",
    "conductor-form-great": "for other case, the approximation is great",
    "lazanyi-alpha": "For the author’s case of $n_t=1.5$ and $k_t=5$ I get $alpha=7.7$",
    "lazanyi-dip": "Result is good",
    "lazanyi-term": "red is the rational approximation with $a=3$ and $\\alpha=7$",
    "dip-perpendicular": "perpendicular curve crosses the 0 line at the Brewster’s angle",
    "metal-rp-above-zero": "does not reach zero for a conductor as it does for a dielectric",
    "lazanyi-minimum": "local minimun of the error term is somewhere between 0.1 and 0.15",
    "dip-negligible": "the visual impact of this “dip” is negligible",
    "f0-not-enough": "for complex IOR there is no way to retrieve the correct $n_t$ and $k_t$",
    "schlick-range": "only accurate in the range $1.4 < n_t < 2.2$",
    "schlick-water-ok": "water at 1.33 still ok",
    "schlick-forms-agree": "This is exactly the same as the first one",
    "schlick-error-of-n": "still covers most use material in game",
    "polarization-small": "since their effect on Fresnel's formula is small",
    "one-wavelength": "Assume all light is of the same wavelength",
    "denser-reflects-more": "a family of curves for various indices of refraction",
    "schlick-below-polarization": "less error than the above non-polarized light approximation",
    "one-minus-cos": "approximation is visually unacceptable",
    "polynomial-like-texture": "comparing the two pixel-shader solutions shows little difference",
    "texture-most-accurate": "Only texture resolution introduces potential computation errors",
    "per-vertex-per-pixel": "visually distinguishable only through A/B-style comparisons",
    "deon-2019-log": "Our approximation [Aug 2019] for $1 < \\eta < 3$",
    "deon-2019-rational": "accurate to within about 0.001",
    "deon-2019-rg": "accurate to within about 0.00006",
    "large-k": "Asymptotic behaviour (large k)",
    "conductor-form-larger-k": "more accurate for larger k",
    "complex-dielectric": "Misunderstood form",
    "deon-n-i": "FRPharrHumphreys[n, k, t]",
    "deon-benchmark": "Benchmark data",
    "dunkle-exact-for-pharr": "exact for PharrHumphreys approximate form",
    "schlick-albedo-exact": "Schlick approximation",
}
OF_THE_FOUR = {name for name, claim in CLAIMS.items() if claim.source.author in FILES}

EXAMPLES = {
    "models": {
        ("Glass, exact and Schlick", "Shirley"),  # "If I graph that too for the n=1.5"
        ("Conductor formula at k = 0", "Lagarde"),
        ("Conductor formula at k > 0", "Lagarde"),
        ("A dip for metals, α = 7.7", "Lagarde after Lazányi"),
        ("What a metal's dip takes away", "Lagarde after Lazányi"),  # "with a=3 and α=7"
        ("s and p, a dielectric", "Lagarde"),  # a pair of plots, whose indices are not named
        ("s and p, a metal", "Lagarde"),
        ("Water to air", "Lagarde"),  # "for n_i=1.33 and n_t=1 (water-air interface)"
        ("Schlick over n", "Lagarde"),
        ("A family of curves over n", "Wloka"),  # figure 3, whose indices are not named
        ("Water and diamond, 1 − cos", "Wloka"),  # figure 4
        ("Conductor comparison", "d'Eon"),
    },
    "preview": {
        ("Glossy paint", "Shirley"),  # figure 2.11
        ("T and R mixed, in glass", "after Shirley"),  # his is water
        ("Gold", "measured n, k"),  # in no memo
        ("Per vertex, figure 7", "Wloka"),
        ("Per pixel, figure 12", "Wloka"),
        ("Texture, figure 13, of 16 texels", "Wloka"),  # he names no size
        ("No reflection, figure 14", "Wloka"),
        ("1 − cos, figure 15", "Wloka"),
        ("Even light", "furnace"),
        # of films, in no memo
        ("Soap bubble", "330 nm of water"),
        ("Oil on water", "against no oil"),
        ("Anodized titanium", "25 volts"),
        ("Iridescence as glTF has it", "against the spectrum"),
    },
    "materials": {
        ("Copper at 400 to 800 nm", "Shirley"),  # figure 2.8
        ("Glass: one float will do", "Shirley"),
        ("Gold: it takes RGB", "Shirley"),
    },
}


def test_every_claim_of_the_four_sources_has_their_words() -> None:
    assert set(QUOTES) == OF_THE_FOUR


def test_the_words_stand_in_the_source() -> None:
    folder = os.environ.get("FRESNEL_SOURCES")
    if folder is None:
        pytest.skip("no FRESNEL_SOURCES")
    for name, words in QUOTES.items():
        (path,) = Path(folder).glob(f"{FILES[CLAIMS[name].source.author]}*.txt")
        assert plain(words) in plain(path.read_text("utf-8")), name


def plain(text: str) -> str:
    """Text without marks of emphasis, code and links, and with one space between words."""
    return " ".join(re.sub(r"[*`]|</?\w+>|\[(?=[A-Z])|\]\([^)]*\)", "", text).split())


@pytest.mark.parametrize("view", EXAMPLES)
def test_every_example_was_looked_up(view: str) -> None:
    text = (STATIC / view / "examples.js").read_text("utf-8")
    found = re.findall(r'title: "([^"]+)",\s*source: "([^"]+)"', text)
    assert set(found) == EXAMPLES[view]
    assert len(found) == len(EXAMPLES[view])


def test_figures_of_wloka_show_what_his_show() -> None:
    text = (STATIC / "preview" / "examples.js").read_text("utf-8")
    shown = {
        figure: re.search(rf'figure {figure}[^}}]*?right: ("\w+"|NONE)', text)
        for figure in (7, 12, 13, 14, 15)
    }
    right = {figure: found[1] if found else None for figure, found in shown.items()}
    # Figure 7 is the vertex shader of his equation 10, which is Schlick's, and 12 its pixel shader.
    assert right == {
        7: '"schlick"',
        12: '"schlick"',
        13: '"exact"',
        14: "NONE",
        15: '"one_minus_cos"',
    }


@pytest.mark.parametrize(
    ("model", "apart"), [("complex_dielectric", 0.117), ("pharr_humphreys", 0.107)]
)
def test_what_leaving_out_n_i_costs(model: str, apart: float) -> None:
    """Two of the four curves in d'Eon's comparison; the trap's card says by how much they are off."""
    theta = Incidence.from_degrees(np.linspace(0.0, 90.0, 1801))
    curve = default_registry()[model]
    right, left_out = (curve(Interface(n_i, 1.5, 2.0), theta) for n_i in (1.5, 1.0))
    assert np.abs(right - left_out).max() == pytest.approx(apart, abs=5e-4)
    card = (STATIC / "theory" / "trap-cards.js").read_text("utf-8")
    assert str(apart) in card
    assert "deon-n-i" in {
        claim.id for claim in CLAIMS.values() if claim.example == "deon-conductor"
    }


def test_light_in_the_water_is_weighed_by_the_square_of_the_index() -> None:
    """Step 2 of the path: what T leaves out, of a lamp in the water."""
    steps = (STATIC / "theory" / "steps.js").read_text("utf-8")
    assert "This is the whole recipe" not in steps
    assert "$(n_i/n_t)^2$ besides $T$, here 0.56" in steps
    n = 1.333
    # A cone of rays about the normal keeps its power but for T, and is n^2 times as wide outside.
    inside = np.linspace(0.0, 1e-4, 2001)
    outside = np.arcsin(n * np.sin(inside))
    wide = [np.trapezoid(np.sin(angle), angle) for angle in (inside, outside)]
    assert wide[0] / wide[1] == pytest.approx(1.0 / n**2, rel=1e-6)
    assert round(1.0 / n**2, 2) == 0.56


def test_what_is_measured_off_1_alone_says_so() -> None:
    """The sentence belongs to claims that begin at eta = 1, and to no other of the same fit."""
    said = {c.id for c in CLAIMS.values() if "from 1 % off eta = 1" in c.found}
    assert said == {"deon-irving-2011", "egan-hilgeman-1973"}
    for name in said:
        assert re.search(r"1\.01|0\.990099", CLAIMS[name].domain)
