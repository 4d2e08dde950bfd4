"""`/mystery/{code}`: the curve of a material to guess, and no more of it than was asked for."""

import re

import numpy as np
import pytest

from app.answers.mystery import CLUES
from tests.api.shape import Ask, error_of, json_of
from tests.optics.reference.fresnel import fresnel

# Codes of links that teachers have sent, which static/js/theory/mystery-code.js made.
SENT = {"z1amiz": (2.42, 0.0), "g21piv": (0.27, 2.9), "qy2f0x": (1.77, 0.0)}


@pytest.mark.parametrize("code", SENT)
def test_the_curve_is_that_of_the_material(ask: Ask, code: str) -> None:
    n, k = SENT[code]
    told = json_of(ask(f"/mystery/{code}"))
    expected = [float(fresnel(1.0, n, k, theta).R) for theta in told["theta_i_deg"]]
    np.testing.assert_allclose(told["R"], expected, rtol=1e-12)


@pytest.mark.parametrize("code", SENT)
def test_clues_are_sent_as_they_are_asked_for(ask: Ask, code: str) -> None:
    n, k = SENT[code]
    names = ["Rs", "Rp", "F0", "kind", "pseudo_brewster_deg"]
    for clues in range(CLUES + 1):
        told = json_of(ask(f"/mystery/{code}", clues=clues))
        assert [told[name] is not None for name in names] == [
            i <= clues + (clues > 0) for i in range(1, 6)
        ]
        assert not {"n", "k", "n_t", "k_t", "interface"} & told.keys()
    assert told["Rs"][60] == pytest.approx(float(fresnel(1.0, n, k, 30.0).Rs), rel=1e-12)
    assert told["F0"] == pytest.approx(((n - 1) ** 2 + k**2) / ((n + 1) ** 2 + k**2), rel=1e-12)
    assert told["kind"] == ("conductor" if k else "dielectric")
    if not k:
        assert told["pseudo_brewster_deg"] == pytest.approx(np.degrees(np.arctan(n)), rel=1e-12)


def test_neither_n_nor_k_is_written_in_the_answer(ask: Ask) -> None:
    body = ask("/mystery/g21piv", clues=CLUES).text
    assert not re.search(r"\b0\.27\b|\b2\.9\b", body)


@pytest.mark.parametrize("code", ["zzzzzz", "0", "00", "abcdefg", "ABC", "1", "g21pi%20", "-1"])
def test_what_is_no_code_is_not_found(ask: Ask, code: str) -> None:
    error = error_of(ask(f"/mystery/{code}"), 404)
    assert error["parameter"] == "code"
    assert "the code of a mystery material" in error["message"]
