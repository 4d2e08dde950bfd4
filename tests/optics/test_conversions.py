"""Conversions: printed figures, every way there and back, and what has no way back."""

import math

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from app.optics.conversions import (
    TAKES,
    TITLES,
    Conversion,
    Form,
    Known,
    convert,
    hex_channels,
    know,
)
from app.optics.errors import NotAllowed, OutOfRange
from app.optics.formulas.conversions import FORMULAS


def all_of(known: Known, seen_from: float = 1.333) -> dict[str, Conversion]:
    return {conversion.form: conversion for conversion in convert(known, seen_from)}


def number(conversion: Conversion, name: str) -> float:
    value = conversion.values[name]
    assert isinstance(value, float)
    return value


def back(form: Form, conversions: dict[str, Conversion], n_i: float = 1.0) -> Known:
    """Read a result as if it had been given."""
    names = [parameter.name for parameter in TAKES[form]]
    return know(form, n_i, **{name: number(conversions[form], name) for name in names})


# Figures from elsewhere


def test_figures_of_the_sources() -> None:
    glass = all_of(know("ior", n_t=1.5))
    assert number(glass["f0"], "F0") == pytest.approx(0.04, abs=1e-15)
    assert glass["f0_seen_from"].status == "exact"
    assert number(glass["specular"], "specular") == pytest.approx(0.5, abs=1e-14)
    # Filament's default: reflectance 0.5 is F0 = 4 %.
    assert number(glass["reflectance"], "reflectance") == pytest.approx(0.5, abs=1e-14)
    # formulas.md: the index is 1.788789 at specular 1.
    top = all_of(know("specular", specular=1.0))
    assert round(number(top["ior"], "n_t"), 6) == 1.788789
    # IEC 61966-2-1: linear 0.214 is middle gray, code 127 or 128.
    assert all_of(know("f0", F0=0.2158605))["f0_hex"].values["hex"] == "#808080"


# Round trips

indices = st.floats(1.001, 60.0)
reflectances = st.floats(1e-5, 0.999)
front = st.floats(1.0, 2.5)


@given(indices, front)
def test_a_dielectric_there_and_back(eta: float, n_i: float) -> None:
    n_t = eta * n_i
    assume(n_t <= 100.0)
    forms = all_of(know("ior", n_i, n_t=n_t))
    for form in TAKES:
        if form not in forms or forms[form].status == "infeasible":
            continue
        assert forms[form].status == "exact"
        again = all_of(back(form, forms, n_i))
        assert number(again["ior"], "n_t") == pytest.approx(n_t, rel=1e-6)


@given(st.floats(0.05, 20.0), st.floats(0.01, 20.0), front)
def test_a_metal_there_and_back(n_t: float, k_t: float, n_i: float) -> None:
    forms = all_of(know("nk", n_i, n_t=n_t, k_t=k_t))
    assert forms["dg"].status == "exact"
    # Only above |N| = n_i does Gulbrandsen's mapping reach; near |N| = n_i the digits go.
    assert (forms["rg"].status == "exact") == (math.hypot(n_t, k_t) >= n_i * (1.0 - 1e-7)) or (
        abs(math.hypot(n_t, k_t) - n_i) < 1e-6
    )
    for form in ("nk", "rg", "dg"):
        if forms[form].status == "exact":
            again = all_of(back(form, forms, n_i))["nk"]
            N = complex(number(again, "n_t"), number(again, "k_t"))
            assert abs(N - complex(n_t, k_t)) <= 1e-5 * max(1.0, abs(complex(n_t, k_t)) ** 2)
    for form in ("f0", "f0_srgb", "f82", "f0_seen_from"):
        assert forms[form].status == "lossy"


@given(reflectances)
def test_a_reflectance_there_and_back(F0: float) -> None:
    forms = all_of(know("f0", F0=F0))
    for form in ("f0", "f0_srgb", "specular", "reflectance"):
        if forms[form].status != "infeasible":
            again = all_of(back(form, forms))
            assert number(again["f0"], "F0") == pytest.approx(F0, rel=1e-9)
    if number(forms["ior"], "n_t") <= 100.0:
        assert number(all_of(back("ior", forms))["f0"], "F0") == pytest.approx(F0, rel=1e-9)


@given(st.floats(1e-4, 0.9999), st.floats(0.0, 1.0))
def test_tints_there_and_back(r: float, tint: float) -> None:
    for form, name in (("rg", "g"), ("dg", "G")):
        known = know(form, r=r, **{name: tint})  # type: ignore[arg-type]
        again = all_of(known)[form]
        assert again.status == "exact"
        assert number(again, "r") == r
        assert number(again, name) == pytest.approx(tint, abs=1e-5)


@given(st.integers(0, 255))
def test_every_code_there_and_back(code: int) -> None:
    encoded = hex_channels(f"#{code:02x}0000")[0]
    conversion = all_of(know("f0_srgb", F0_srgb=encoded))["f0_hex"]
    assert conversion.values["hex"] == "#" + f"{code:02x}" * 3
    assert conversion.status == "exact"


@given(st.floats(0.0, 1.0))
def test_eight_bits_cost_at_most_half_a_step(F0: float) -> None:
    conversion = all_of(know("f0", F0=F0))["f0_hex"]
    assert abs(number(conversion, "F0") - F0) <= 0.5 * (1.0 - 0.9911) + 1e-9
    assert conversion.status in ("exact", "lossy")


# What has no way


def test_a_perfect_mirror() -> None:
    mirror = all_of(know("f0", F0=1.0))
    assert mirror["ior"].status == "infeasible"
    assert "F0 = 1" in mirror["ior"].why
    for form in ("nk", "rg", "dg", "specular", "reflectance", "f82", "f82_tint", "f0_seen_from"):
        assert mirror[form].status == "infeasible", form
    assert mirror["f0_hex"].values["hex"] == "#ffffff"


def test_nothing_reflects_at_all() -> None:
    nothing = all_of(know("ior", n_t=1.0))
    assert {form for form, c in nothing.items() if c.status != "exact"} == {"f0_seen_from"}
    assert number(nothing["rg"], "g") == 0.0
    assert number(nothing["specular"], "specular") == 0.0


def test_the_index_is_not_in_F0() -> None:
    forms = all_of(know("f0", F0=0.9))
    for form in ("nk", "rg", "dg"):
        assert forms[form].status == "infeasible"
        assert "circle" in forms[form].why
    assert forms["rg"].values == {"r": 0.9, "g": None}


def test_what_holds_of_a_dielectric_alone_says_so() -> None:
    gold = [all_of(know("f0", F0=F0)) for F0 in (0.947, 0.776, 0.371)]
    for form in ("ior", "f82", "f82_tint", "f0_seen_from"):
        assert [forms[form].status for forms in gold] == ["dielectric only"] * 3
        assert all("does not absorb" in forms[form].why for forms in gold)
    impossible = ["no medium without absorption" in forms["f82_tint"].why for forms in gold]
    assert impossible == ["no medium without absorption" in f["ior"].why for f in gold]
    assert impossible == [True, True, False]
    for form, given_ in (("specular", {"specular": 0.5}), ("ior", {"n_t": 1.5})):
        assert all_of(know(form, **given_))["f82_tint"].status == "exact"  # type: ignore[arg-type]


def test_which_dielectrics_have_a_tint_above_one() -> None:
    def tint(n_t: float) -> float:
        return number(all_of(know("ior", n_t=n_t))["f82_tint"], "tint")

    assert max(map(tint, np.geomspace(1.001, 100.0, 200))) < 0.955  # from the thinner side none
    assert min(map(tint, np.geomspace(0.1, 0.98, 20))) > 1.0  # 82 degrees is beyond critical
    said = next(one.validity for one in FORMULAS if one.id == "conversion.f82_tint")
    assert "no dielectric seen from the thinner side" in said


def test_gulbrandsen_needs_an_index_of_modulus_one() -> None:
    weak = all_of(know("nk", n_t=0.5, k_t=0.3))
    assert weak["rg"].status == "infeasible"
    assert "1.166" in weak["rg"].why
    assert weak["dg"].status == "exact"


def test_a_strong_reflector_has_no_specular_level() -> None:
    forms = all_of(know("f0", F0=0.12))
    assert forms["specular"].status == "infeasible"
    assert forms["reflectance"].status == "exact"
    assert all_of(know("f0", F0=0.17))["reflectance"].status == "infeasible"


def test_the_denser_side_cannot_be_told_from_F0() -> None:
    inside = all_of(know("ior", 1.5, n_t=1.0))
    assert inside["f0"].status == "lossy"
    assert inside["f82"].status == "exact"  # R = 1 at 82 degrees tells it
    tint = number(inside["f82_tint"], "tint")  # R = 1 over Schlick's of F0 = 0.04
    assert tint == pytest.approx(1.0 / (0.04 + 0.96 * (6.0 / 7.0) ** 5), rel=1e-12)
    assert "exceeds Schlick's" in inside["f82_tint"].why
    assert inside["dg"].values["G"] == 1.0


def test_a_metal_as_a_dielectric_is_lossy() -> None:
    forms = all_of(know("nk", n_t=0.27, k_t=2.9))
    assert forms["ior"].status == "lossy"
    n = number(forms["ior"], "n_t")
    assert ((n - 1.0) / (n + 1.0)) ** 2 == pytest.approx(number(forms["f0"], "F0"), rel=1e-12)


def test_every_form_is_answered_with_a_reason() -> None:
    for known in (know("ior", n_t=1.5), know("nk", n_t=1.0, k_t=5.0), know("f0", F0=0.5)):
        conversions = convert(known)
        assert [c.form for c in conversions] == list(TITLES)
        assert all(c.why and c.title for c in conversions)


def test_only_what_a_form_takes() -> None:
    with pytest.raises(NotAllowed, match="n_t and k_t"):
        know("nk", n_t=1.5)
    with pytest.raises(NotAllowed, match="F0"):
        know("f0", F0=0.04, n_t=1.5)
    with pytest.raises(OutOfRange, match="specular"):
        know("specular", specular=1.1)
    with pytest.raises(OutOfRange, match="seen_from"):
        convert(know("ior", n_t=1.5), seen_from=0.0)


@pytest.mark.parametrize("code", ["#12345", "zzzzzz", "#1234567", ""])
def test_no_color(code: str) -> None:
    with pytest.raises(NotAllowed, match="hexadecimal"):
        hex_channels(code)


def test_colors() -> None:
    assert hex_channels("#FF0080") == (1.0, 0.0, 128 / 255)
    assert hex_channels("ff0080") == (1.0, 0.0, 128 / 255)
