"""Pages of refractiveindex.info wherever a material is taken."""

import asyncio
import re
from typing import Any
from urllib.parse import quote

import httpx
import numpy as np
import pytest
from fastapi import FastAPI
from typer.testing import CliRunner

from app.cli.main import cli
from tests.api.shape import Ask, json_of

SILVER = "rii:main/Ag/Johnson"
GLASS = "rii:specs/SCHOTT-optical/N-BK7"


@pytest.mark.parametrize("path", [SILVER, quote(SILVER, safe="")])
@pytest.mark.parametrize("tail", ["", "/spectrum", "/curves", "/map", "/rgb_nk"])
def test_its_own_routes(ask: Ask, path: str, tail: str) -> None:
    answer = json_of(ask(f"/materials/{path}{tail}"))
    assert SILVER in (answer.get("id"), answer.get("material", {}).get("id"))


def test_files_are_named_after_it(ask: Ask) -> None:
    for page, name in (
        (SILVER, "rii-main-Ag-Johnson"),
        ("rii:main/KNbO3/Umemura-α", "rii-main-KNbO3-Umemura"),
    ):
        table = ask(f"/materials/{page}/spectrum", format="csv")
        assert table.headers["content-disposition"] == f'inline; filename="{name}_spectrum.csv"'
    exported = ask(f"/materials/{SILVER}/export", to="mitsuba")
    assert "rii_main_Ag_Johnson" in exported.headers["content-disposition"]


def test_all_that_takes_a_material_takes_it(ask: Ask) -> None:
    """The page that the preset Ag was made from, so that each answers as the preset does."""
    for path, name in (
        ("/curves?samples=5", "material"),
        ("/snell?theta_i_deg=40", "material"),
        ("/lut?size=16", "material"),
        ("/figures/material?samples=7", "material"),
        ("/errors?models=schlick", "material"),
    ):
        ours, page = (json_of(ask(f"{path}&{name}={quote(one)}")) for one in ("Ag", SILVER))
        np.testing.assert_allclose(_numbers(ours), _numbers(page), rtol=1e-9, atol=1e-12)
    films = [
        json_of(ask("/snell", layers=f"{one}:20", material="BK7", wavelength_nm=550))
        for one in ("Ag", SILVER)
    ]
    assert films[0]["R"] == films[1]["R"]
    assert films[1]["layers"][0]["material"]["id"] == SILVER


def _numbers(answer: Any) -> list[float]:
    if isinstance(answer, dict):
        return [n for key, one in answer.items() if key != "layout" for n in _numbers(one)]
    if isinstance(answer, list):
        return [n for one in answer for n in _numbers(one)]
    return [float(answer)] if isinstance(answer, int | float) else []


def test_a_page_in_front(ask: Ask) -> None:
    answer = json_of(ask("/snell", incident=GLASS, n_t=1, theta_i_deg=30, wavelength_nm=587.5618))
    assert answer["interface"]["incident"]["relative_to"] == "air"
    assert answer["interface"]["n_i"] == pytest.approx(1.51680003 * 1.000277, abs=2e-6)


def test_evaluate_takes_pages(app: FastAPI) -> None:
    items = [{"material": one, "wavelength_nm": 550, "theta_i_deg": 45} for one in ("Ag", SILVER)]

    async def request() -> httpx.Response:
        transport = httpx.ASGITransport(app=app)
        async with httpx.AsyncClient(transport=transport, base_url="http://test") as client:
            return await client.post("/api/v1/evaluate", json={"items": items})

    ours, page = asyncio.run(request()).json()["results"]
    assert ours == page


def test_the_command_takes_pages() -> None:
    said = CliRunner().invoke(cli, ["material", SILVER, "--format", "json"])
    assert said.exit_code == 0, said.output
    assert "Johnson and Christy 1972" in said.output
    wrong = CliRunner().invoke(cli, ["curve", "--material", "rii:main/AgGaSe2/Boyd-o"])
    assert wrong.exit_code == 2
    assert "an odd number for formula 2" in " ".join(wrong.output.split())


@pytest.mark.parametrize(
    ("path", "status"),
    [("/materials/{}", 404), ("/materials/{}/curves", 404), ("/curves?material={}", 422)],
)
@pytest.mark.parametrize(
    ("page", "said"),
    [
        ("rii:main/AgGaSe2/Boyd-o", "an odd number for formula 2"),
        ("rii:main/Si/Daub", "this page has k alone"),
        ("rii:main/Ag/Johnsen", "nearest: rii:main/Ag/Johnson"),
        ("rii:Ag", "rii:SHELF/BOOK/PAGE"),
    ],
)
def test_what_is_wrong_says_so(ask: Ask, path: str, status: int, page: str, said: str) -> None:
    answer = ask(path.format(page))
    assert answer.status_code == status
    assert said in answer.json()["errors"][0]["message"]


def test_a_search_tells_shelf_book_page_ranges_and_paper(ask: Ask) -> None:
    rows = json_of(ask("/materials", q="Johnson silver", catalog="pages"))["materials"]
    assert rows[0]["page"] == {
        "shelf": "main",
        "book": "Ag",
        "page": "Johnson",
        "title": "Ag (Silver) · Experimental data: bulk, thick film · "
        "Johnson and Christy 1972: n,k 0.188–1.94 µm",
    }
    assert rows[0]["n_range_nm"] == rows[0]["k_range_nm"] == [187.9, 1937.0]
    assert rows[0]["doi"] == ["10.1103/PhysRevB.6.4370"]
    assert "Optical constants of the noble metals" in rows[0]["source"]


def test_the_first_load_has_no_pages(ask: Ask) -> None:
    rows = json_of(ask("/materials"))["materials"]
    assert len(rows) == 192
    assert all(row["page"] is None for row in rows)


def _found(ask: Ask, query: str) -> list[dict[str, Any]]:
    return list(json_of(ask("/materials", q=query, limit=1000))["materials"])


def test_words_come_before_parts_of_words(ask: Ask) -> None:
    """Tin is inside setting and Tselin, and is the name of a metal that is no preset."""
    for word in ("tin", "TIN"):
        rows = _found(ask, word)
        assert [row["page"]["book"] for row in rows[:3]] == ["Sn"] * 3
        ids = [row["id"] for row in rows]
        assert ids[3:5] == ["TiN", "TiN-Pfluger"]
        oxide = [i for i, row in enumerate(rows) if "Indium tin oxide" in row["name"]]
        assert oxide
        assert max(oxide) < ids.index("Pt-Tselin")
    assert _found(ask, "TiN")[0]["id"] == "TiN"
    assert [row["id"] for row in _found(ask, "CO")[:2]] == ["rii:main/CO/Smith", "Co"]
    assert _found(ask, "co")[0]["id"] == "Co"


@pytest.mark.parametrize("word", ["ice", "gold", "glass", "oil", "Johnson"])
def test_presets_that_have_the_word_come_before_pages(ask: Ask, word: str) -> None:
    rows = _found(ask, word)
    start = re.compile(rf"\b{word}", re.IGNORECASE)
    has_it = [
        bool(start.search(" ".join([row["id"], row["name"], *row["aliases"], row["source"]])))
        for row in rows
        if row["page"] is None
    ]
    count = sum(has_it)
    assert count
    assert has_it == [True] * count + [False] * (len(has_it) - count)
    assert all(row["page"] is None for row in rows[:count])


def test_offset_and_limit_go_on_from_presets_to_pages(ask: Ask) -> None:
    whole = json_of(ask("/materials", q="silver", limit=1000))
    ids = [row["id"] for row in whole["materials"]]
    assert len(ids) == whole["total"]
    assert whole["curated"] == sum(not one.startswith("rii:") for one in ids)
    parts = [
        row["id"]
        for offset in range(0, whole["total"], 7)
        for row in json_of(ask("/materials", q="silver", offset=offset, limit=7))["materials"]
    ]
    assert parts == ids
