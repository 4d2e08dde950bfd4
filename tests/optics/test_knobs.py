"""Knobs of engines: what their sources print, every way there and back, and what they cut."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.optics.conversions import Form, Known, know, settings
from app.optics.errors import OutOfRange
from app.optics.knobs.dispersion import DISPERSION_KNOBS, cauchy, spread
from app.optics.knobs.knob import KnobId, Setting, Typed
from app.optics.knobs.reflectance import KNOBS

IDS = [knob.id for knob in KNOBS]
ROUNDING = 1e-9


def typed(*channels: Known) -> dict[KnobId, Setting]:
    return {knob.id: setting for knob, setting in settings(channels)}


def one(value: Typed) -> float:
    assert isinstance(value, float)
    return value


def back(form: KnobId, setting: Setting, n_i: float = 1.0) -> Known:
    return know(form, n_i, **{name: one(value) for name, value in setting.values.items()})


def at_default(form: KnobId) -> Known:
    (knob,) = (knob for knob in KNOBS if knob.id == form)
    return know(form, **{given.parameter.name: given.default for given in knob.inputs})


@pytest.mark.parametrize("form", IDS)
def test_every_default_is_four_percent(form: KnobId) -> None:
    """As the documentation of each says of its own: an index of 1.5."""
    assert pytest.approx(0.04, abs=1e-15) == at_default(form).F0
    setting = typed(know("ior", n_t=1.5))[form]
    (knob,) = (knob for knob in KNOBS if knob.id == form)
    for each in knob.inputs:
        assert setting.values[each.parameter.name] == pytest.approx(each.default, abs=1e-12)
    assert setting.status == "exact"


@pytest.mark.parametrize(
    ("form", "numbers", "F0"),
    [
        # Filament's own table of reflectance: 0.35 is water's 2 %, 1.0 ruby's and diamond's 16 %.
        ("reflectance", {"reflectance": 0.35}, 0.0196),
        ("reflectance", {"reflectance": 1.0}, 0.16),
        # Burley: specular 1 is an F0 of 8 %, an index of about 1.8.
        ("specular", {"specular": 1.0}, 0.08),
        # Unreal's documentation of measured speculars: water 0.255 at an index of 1.333.
        ("unreal", {"specular": 0.255}, (0.333 / 2.333) ** 2),
        ("godot", {"metallic_specular": 1.0}, 0.16),
        ("three", {"reflectivity": 1.0}, 0.16),
    ],
)
def test_figures_of_the_sources(form: Form, numbers: dict[str, float], F0: float) -> None:
    assert pytest.approx(F0, abs=5e-5) == know(form, **numbers).F0


def test_openpbr_keeps_the_side() -> None:
    """Equation modulated_ior of the specification, written out again with complex numbers."""
    for n, weight in ((1.5, 0.5), (1.5, 2.0), (0.8, 0.5), (2.42, 1.0)):
        F = abs((1 - n) / (1 + n)) ** 2
        epsilon = math.copysign(math.sqrt(weight * F), n - 1)
        known = know("openpbr", specular_ior=n, specular_weight=weight)
        assert known.eta == pytest.approx((1 + epsilon) / (1 - epsilon), rel=1e-12)
    assert know("openpbr", specular_ior=1.5, specular_weight=25.0).F0 == 1.0


@given(st.floats(1.001, 2.3), st.floats(1.0, 2.5))
def test_clear_media_there_and_back(eta: float, n_i: float) -> None:
    for form, setting in typed(know("ior", n_i, n_t=eta * n_i)).items():
        if setting.status != "infeasible":
            assert setting.status == "exact", form
            assert back(form, setting, n_i).dielectric_eta == pytest.approx(eta, rel=1e-6)
    assert typed(know("ior", n_t=1.7))["specular"].status == "exact"
    assert typed(know("ior", n_t=1.9))["specular"].status == "infeasible"


@given(st.floats(1e-6, 1.0))
def test_a_reflectance_there_and_back(F0: float) -> None:
    for form, setting in typed(know("f0", F0=F0)).items():
        if setting.status != "infeasible":
            assert pytest.approx(F0, rel=1e-7, abs=1e-15) == back(form, setting).F0
            assert setting.status == "dielectric only"


def test_the_thinner_medium() -> None:
    """Engines with an index keep the side, those with F0 cannot; glTF has no index below 1."""
    found = typed(know("ior", 1.5, n_t=1.0))
    of_index: tuple[KnobId, ...] = ("blender", "openpbr")
    for form in of_index:
        assert found[form].status == "exact"
        assert back(form, found[form]).eta == pytest.approx(1.0 / 1.5, rel=1e-12)
    assert found["gltf"].values["ior"] == pytest.approx(1.5)
    assert {found[form].status for form in IDS if form not in of_index} == {"lossy"}
    with pytest.raises(OutOfRange, match="from 1 on"):
        know("gltf", ior=0.5, specularFactor=1.0, specularColorFactor=1.0)


def test_a_mirror_and_a_metal() -> None:
    mirror = typed(know("f0", F0=1.0))
    assert mirror["gltf"].values["ior"] == 0.0
    assert back("gltf", mirror["gltf"]).F0 == 1.0
    assert all(mirror[form].status == "infeasible" for form in IDS if form != "gltf")
    metal = typed(know("nk", n_t=1.3, k_t=0.1))
    assert {setting.status for setting in metal.values()} == {"lossy"}


def test_three_channels_need_a_color() -> None:
    gold = [know("f0", F0=F0) for F0 in (0.06, 0.04, 0.01)]
    found = typed(*gold)
    assert {form for form in IDS if found[form].status != "infeasible"} == {"gltf"}
    assert "0.75, 0.5 and 0.125" in found["specular"].why
    values = found["gltf"].values
    colors = values["specularColorFactor"]
    assert isinstance(colors, tuple)
    for known, color in zip(gold, colors, strict=True):
        numbers = {"ior": one(values["ior"]), "specularFactor": one(values["specularFactor"])}
        again = know("gltf", **numbers, specularColorFactor=color)
        assert pytest.approx(known.F0, rel=1e-12) == again.F0
    same = typed(*[know("f0", F0=0.04)] * 3)
    assert same["unreal"].values["specular"] == pytest.approx(0.5)


def test_what_a_pair_says_besides_is_lost() -> None:
    half = know("gltf", ior=1.5, specularFactor=0.5, specularColorFactor=1.0)
    assert pytest.approx(0.02) == half.F0
    assert {setting.status for setting in typed(half).values()} == {"lossy"}
    assert all("F90" in setting.why for setting in typed(half).values())
    level = know("blender", ior=1.5, specular_ior_level=1.0)
    assert level.eta == pytest.approx(1.788789, abs=5e-7)
    assert "Specular IOR Level" in typed(level)["blender"].why


@given(st.floats(5.0, 150.0), st.floats(1.2, 2.6))
def test_dispersion_there_and_back(abbe: float, n_d: float) -> None:
    for knob in DISPERSION_KNOBS:
        values = knob.write(abbe)
        assert knob.read(*map(one, values.values())) == pytest.approx(abbe, rel=1e-12)
    for curve in (cauchy, spread):
        n_F, d, n_C = curve(n_d, abbe, np.array([486.1327, 587.5618, 656.2725]))
        assert d == pytest.approx(n_d, rel=1e-12)
        assert (n_d - 1.0) / (n_F - n_C) == pytest.approx(abbe, rel=ROUNDING * 1e3)
    gltf, openpbr = DISPERSION_KNOBS
    assert gltf.write(math.inf) == {"dispersion": 0.0}
    assert openpbr.read(*map(one, openpbr.write(math.inf).values())) == math.inf


def test_cauchy_of_openpbr_is_that_of_its_specification() -> None:
    """A and B as it prints them, in micrometers."""
    F, d, C = 0.4861327, 0.5875618, 0.6562725
    B = (1.5168 - 1.0) / (64.17 * (F**-2 - C**-2))
    A = 1.5168 - B / d**2
    at = np.array([400.0, 550.0, 700.0])
    np.testing.assert_allclose(cauchy(1.5168, 64.17, at), A + B / (at / 1e3) ** 2, rtol=1e-12)
