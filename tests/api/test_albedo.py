"""The routes about albedos: numbers, shapes, refusals."""

import math

import numpy as np
import pytest

from app.optics.albedo import FITS, Fit, albedo, coat_split, flatland_albedo
from app.optics.interface import Interface
from tests.api.shape import Ask, error_of, json_of, rows_of


def test_every_fit_stands_beside_the_exact_value(ask: Ask) -> None:
    answer = json_of(ask("/albedo", n_t=1.5))
    exact = albedo(Interface(n_t=1.5))
    for name in ("unpolarized", "s", "p"):
        assert answer["exact"][name] == float(getattr(exact, name))
    assert [entry["id"] for entry in answer["approximations"]] == list(FITS)
    for entry in answer["approximations"]:
        fit, glass = FITS[entry["id"]], Interface(n_t=1.5)
        if np.isfinite(fit(glass)):
            assert entry["value"] == float(fit(glass))
            assert entry["error"] == pytest.approx(float(fit.error(glass)), abs=1e-15)
        else:  # large_k divides by k^2
            assert (entry["value"], entry["error"]) == (None, None)
        assert entry["in_domain"] == (fit.reason_outside(glass) is None)
        assert entry["in_domain"] == (entry["reason"] is None)
        assert entry["reference"] == fit.reference
    assert answer["flatland"] == float(flatland_albedo(Interface(n_t=1.5)))


def test_the_other_side(ask: Ask) -> None:
    """Internal diffuse reflectance, by reciprocity and by the fits made for it."""
    answer = ask("/albedo", n_t=1.5).json()
    outer, inner = answer["exact"]["unpolarized"], answer["reverse"]["exact"]
    assert inner["unpolarized"] == pytest.approx(1 - (1 - outer) / 1.5**2, rel=1e-14)
    assert inner["method"] == "closed form by reciprocity"
    fits = {entry["id"]: entry for entry in answer["reverse"]["approximations"]}
    assert fits["egan_hilgeman_1973"]["in_domain"]
    assert abs(fits["egan_hilgeman_1973"]["error"]) < 1e-3
    assert not fits["deon_2019_log"]["in_domain"]
    assert ask("/albedo", n_t=0.2, k_t=3.0).json()["reverse"] is None


def test_models_are_averaged_on_request(ask: Ask) -> None:
    answer = ask("/albedo", n_t=1.5, models="schlick,exact", digits=17).json()
    schlick, exact = answer["models"]
    assert schlick["value"] == pytest.approx(0.04 + 0.96 / 21, rel=1e-12)
    assert schlick["error"] == pytest.approx(
        schlick["value"] - answer["exact"]["unpolarized"], rel=1e-12
    )
    assert exact["error"] == 0.0


def test_a_model_with_three_colors(ask: Ask) -> None:
    parameters = {"models": "f82_tint", "f82_tint.F0": "1.0,0.766,0.336", "f82_tint.tint": "1"}
    answer = ask("/albedo", n_t=0.2, k_t=3.0, **parameters).json()
    expected = [F0 + (1 - F0) / 21 for F0 in (1.0, 0.766, 0.336)]
    assert answer["models"][0]["value"] == pytest.approx(expected, rel=1e-10)
    table = ask("/albedo", n_t=0.2, k_t=3.0, format="csv", **parameters)
    assert float(rows_of(table)[0]["model.f82_tint.value_green"]) == pytest.approx(expected[1])
    sweep = ask("/albedo/sweep", steps=3, k_t=3.0, **parameters).json()
    names = [curve["quantity"] for curve in sweep["curves"] if curve["kind"] == "model"]
    assert names == ["unpolarized_red", "unpolarized_green", "unpolarized_blue"]


def test_one_interface_as_csv(ask: Ask) -> None:
    (row,) = rows_of(ask("/albedo", n_t=1.5, format="csv", digits=5, models="schlick"))
    assert row["exact.unpolarized"] == "0.091778"
    assert row["deon_2019_log.error"] == "0.0013228"
    assert row["large_k.value"] == ""  # -inf without absorption is no number
    assert row["model.schlick.value"] == "0.085714"


def test_catalog_of_fits(ask: Ask) -> None:
    answer = json_of(ask("/albedo/fits"))
    assert [entry["id"] for entry in answer["fits"]] == list(FITS)
    second = json_of(ask("/albedo/fits/deon_2019_rg"))
    assert second in answer["fits"]
    (claim,) = second["claims"]
    assert (claim["claimed"], claim["measured"], claim["holds"]) == (6e-5, 1.65e-4, False)
    assert claim["domain"] == {"kind": "conductor", "eta": [0.1, 4.0], "kappa": [1.7, 8.0]}
    missing = ask("/albedo/fits/deon_2019_gr")
    assert missing.status_code == 404
    assert "deon_2019_rg" in missing.json()["detail"]


def test_sweep_over_n_t(ask: Ask) -> None:
    answer = json_of(
        ask("/albedo/sweep", minimum=1, maximum=4, steps=301, fits="deon_2019_log", flatland="true")
    )
    n = np.linspace(1.0, 4.0, 301)
    assert answer["values"] == n.tolist()
    assert answer["n_t"] is None
    curves = {(curve["id"], curve["quantity"]): curve for curve in answer["curves"]}
    exact = albedo(Interface(1.0, n))
    for name in ("unpolarized", "s", "p"):
        assert curves["exact", name]["values"] == getattr(exact, name).tolist()
    flat = flatland_albedo(Interface(1.0, n)).tolist()
    assert curves["flatland", "unpolarized"]["values"] == flat
    fitted = curves["deon_2019_log", "unpolarized"]
    assert fitted["in_domain"] == [1.0, 3.0]
    errors = np.array(fitted["error"])
    np.testing.assert_array_equal(errors, np.array(fitted["values"]) - exact.unpolarized)
    assert np.max(np.abs(errors[n <= 3.0])) == pytest.approx(0.0017, abs=5e-5)


@pytest.mark.parametrize("over", ["n_t", "eta", "k_t"])
def test_sweeps_hold_the_rest(ask: Ask, over: str) -> None:
    fixed: dict[str, float] = {"n_t": 0.4} if over == "k_t" else {"k_t": 2.5}
    answer = ask(
        "/albedo/sweep", over=over, n_i=1.33, minimum=0.5, maximum=3, steps=4, scale="log", **fixed
    ).json()
    values = np.geomspace(0.5, 3.0, 4)
    np.testing.assert_allclose(answer["values"], values)
    interface = {
        "n_t": Interface(1.33, values, 2.5),
        "eta": Interface(1.33, 1.33 * values, 2.5),
        "k_t": Interface(1.33, 0.4, values),
    }[over]
    np.testing.assert_allclose(
        answer["curves"][0]["values"], albedo(interface).unpolarized, rtol=1e-13
    )
    assert {name: answer[name] for name in fixed} == fixed


def test_presets_stand_in_place_of_numbers(ask: Ask) -> None:
    answer = ask("/albedo", material="gold", incident="water").json()
    interface = Interface(*(answer["interface"][name] for name in ("n_i", "n_t", "k_t")))
    assert answer["exact"]["unpolarized"] == float(albedo(interface).unpolarized)
    assert answer["interface"]["material"]["id"] == "Au"
    sweep = ask("/albedo/sweep", incident="water", k_t=2.0, steps=3).json()
    assert sweep["incident"]["id"] == "water"
    assert sweep["n_i"] == answer["interface"]["n_i"]
    assert ask("/albedo/sweep", n_i=1.33, steps=3).json()["incident"] is None


def test_a_sweep_outside_a_domain(ask: Ask) -> None:
    answer = ask("/albedo/sweep", k_t=0.5, steps=3, fits="deon_2019_rg,dunkle_1963_s").json()
    assert [curve["in_domain"] for curve in answer["curves"]] == [None] * 5
    assert answer["curves"][4]["quantity"] == "s"


def test_sweep_as_csv(ask: Ask) -> None:
    table = rows_of(
        ask(
            "/albedo/sweep",
            minimum=1,
            maximum=2,
            steps=2,
            digits=5,
            format="csv",
            fits="schlick",
            models="schlick",
        )
    )
    assert table[1] == {
        "n_t": "2.0",
        "exact.unpolarized": "0.1606",
        "exact.s": "0.25926",
        "exact.p": "0.061934",
        "schlick.unpolarized": "0.15344",
        "schlick.unpolarized.error": "-0.0071575",
        "model.schlick.unpolarized": "0.15344",
        "model.schlick.unpolarized.error": "-0.0071575",
    }


def test_map_of_a_fits_error(ask: Ask) -> None:
    answer = json_of(
        ask(
            "/albedo/map",
            fit="deon_2019_rg",
            n_i=1.33,
            n_minimum=0.5,
            n_steps=5,
            k_minimum=3,
            k_steps=4,
        )
    )
    values, fit = np.array(answer["values"]), FITS["deon_2019_rg"]
    assert values.shape == (4, 5)
    assert answer["show"] == "error"
    n, k = np.linspace(0.5, 4.0, 5), np.linspace(3.0, 8.0, 4)
    interface = Interface(1.33, n[np.newaxis, :], k[:, np.newaxis])
    np.testing.assert_allclose(values, fit.error(interface), atol=1e-15)
    assert answer["domains"] == [
        {"n_t": pytest.approx([0.133, 5.32]), "k_t": pytest.approx([2.261, 10.64])}
    ]
    assert answer["largest_in_domain"] == answer["largest"]
    assert abs(answer["largest"]["value"]) > np.abs(values).max()
    there = Interface(1.33, answer["largest"]["n_t"], answer["largest"]["k_t"])
    assert answer["largest"]["value"] == pytest.approx(float(fit.error(there)), rel=1e-9)


def test_the_largest_of_a_map_is_found_whatever_the_grid(ask: Ask) -> None:
    """D'Eon's first rational fit: the grid of the page had 0.00256, the table beside it 0.00309."""
    for steps in ({}, {"n_steps": 2, "k_steps": 2}, {"n_steps": 201, "k_steps": 3}):
        answer = ask("/albedo/map", fit="deon_2019_rational", **steps).json()
        assert answer["largest_in_domain"]["value"] == pytest.approx(-0.003086, abs=5e-7)
        assert answer["largest_in_domain"]["n_t"] == pytest.approx(0.4966, abs=5e-5)
        assert answer["largest_in_domain"]["k_t"] == 1.7


@pytest.mark.parametrize("fit", FITS.values(), ids=FITS)
def test_the_largest_within_a_domain_is_what_the_fit_states(ask: Ask, fit: Fit) -> None:
    """The claims' figures are rounded up to three digits; a dense grid finds no more."""
    for claim in fit.claims:
        domain = claim.measured_over
        (low, high), (least, most) = domain.eta, domain.kappa
        ends = {"n_minimum": low, "n_maximum": high, "n_steps": 2, "k_steps": 2}
        ends |= {"k_minimum": least, "k_maximum": most or 1.0}
        answer = ask("/albedo/map", fit=fit.id, **ends).json()
        found = answer["largest_in_domain" if domain.kind == "dielectric" else "largest"]
        sampled = np.abs(fit.error(domain.grid(301))).max()
        assert abs(found["value"]) >= sampled * (1.0 - 1e-9)
        if not claim.relative and domain in fit.domains:
            assert 0.99 * claim.measured <= abs(found["value"]) <= claim.measured * (1.0 + 1e-9)


def test_map_shows_what_is_asked(ask: Ask) -> None:
    shape = {"n_steps": 3, "k_steps": 2}
    exact = ask("/albedo/map", quantity="s", **shape).json()
    assert (exact["fit"], exact["show"], exact["quantity"]) == (None, "exact", "s")
    assert exact["largest_in_domain"] is None
    same = ask("/albedo/map", fit="dunkle_1963_s", show="exact", **shape).json()
    assert same["values"] == exact["values"]
    value = ask("/albedo/map", fit="dunkle_1963_s", show="value", **shape).json()
    error = ask("/albedo/map", fit="dunkle_1963_s", **shape).json()
    difference = np.array(value["values"]) - np.array(exact["values"])
    np.testing.assert_array_equal(error["values"], difference)


def test_map_holds_null_where_a_fit_is_undefined(ask: Ask) -> None:
    answer = json_of(ask("/albedo/map", fit="large_k", n_steps=3, k_steps=3))
    assert answer["values"][0] == [None] * 3  # k = 0
    assert answer["largest"] is None  # beside k = 0 it has no bound
    assert answer["largest_in_domain"] is None
    assert rows_of(ask("/albedo/map", fit="large_k", n_steps=2, k_steps=2, format="csv"))[0] == {
        "n_t": "0.1",
        "k_t": "0.0",
        "error": "",
    }


def test_coat(ask: Ask) -> None:
    answer = json_of(ask("/albedo/coat", n_t=1.5, body_albedo=0.8))
    split = coat_split(Interface(n_t=1.5), 0.8)
    for name in ("external", "internal", "surface", "body", "absorbed"):
        assert answer[name] == float(getattr(split, name))
    assert answer["theta_i_deg"] is None
    ray = ask("/albedo/coat", n_t=1.5, body_albedo=0.8, theta_i_deg=0).json()
    assert ray["surface"] == pytest.approx(0.04, rel=1e-14)
    assert ray["internal"] == answer["internal"]
    in_radians = ask("/albedo/coat", n_t=1.5, theta_i_rad=1.0).json()
    in_degrees = ask("/albedo/coat", n_t=1.5, theta_i_deg=math.degrees(1.0)).json()
    assert in_radians["theta_i_deg"] == pytest.approx(math.degrees(1.0), rel=1e-15)
    assert in_radians["surface"] == pytest.approx(in_degrees["surface"], rel=1e-13)
    both = error_of(ask("/albedo/coat", theta_i_rad=1.0, theta_i_deg=57))
    assert both["parameter"] == "theta_i_deg"
    (row,) = rows_of(ask("/albedo/coat", n_t=1.5, body_albedo=0.8, format="csv"))
    assert float(row["body"]) == answer["body"]
