"""`/benchmarks/deon2019`: the printed cells, beside what a model answers."""

import pytest

from tests.api.shape import Ask, json_of, rows_of


def test_the_exact_model_has_all_cells(ask: Ask) -> None:
    told = json_of(ask("/benchmarks/deon2019"))
    assert len(told["printed"]) == 108
    assert told["apart"] == 0
    assert max(map(abs, told["difference"])) <= told["half_unit"] + 1e-15
    cell = told["n_t"].index(1.4) + 3
    assert (told["theta_i_rad"][cell], told["printed"][cell]) == (1.0, 0.06118057)


def test_a_model_has_those_that_it_is_made_for(ask: Ask) -> None:
    told = json_of(ask("/benchmarks/deon2019", model="pharr_humphreys"))
    assert sum(R is None for R in told["R"]) == 48
    assert told["apart"] > 30
    rows = rows_of(ask("/benchmarks/deon2019", model="cos_form", format="csv"))
    assert len(rows) == 108
    known = [row for row in rows if row["R"]]
    assert {float(row["k_t"]) for row in known} == {0.0}
    for row in known:
        assert float(row["R"]) == pytest.approx(float(row["printed"]), abs=5.001e-9)
