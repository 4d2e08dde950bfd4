"""Every snippet, compiled and run by Chromium in 32 bit floats, against the model in 64."""

import os
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from playwright.sync_api import BrowserType, Page

from app.optics import vectors
from app.optics.registry import Model
from app.snippets.languages import LANGUAGES
from app.snippets.lookup import write_lookup
from app.snippets.snippet import arguments_of, write
from app.snippets.vectors import SUFFIX, write_vectors
from tests.browser.gpu import run
from tests.snippets.cases import MODELS, at_the_ends, cases, check_at_the_ends

SCHLICK, CONDUCTOR, DIELECTRIC = 5e-7, 2e-6, 1e-5
TRIGONOMETRY = 1e-3
"""The software GPU's own sine and cosine are wrong by 1.9e-4, its arc cosine by 7e-5."""


def tolerance(model: Model, interface: tuple[float, float, float]) -> float:
    n_i, n_t, k_t = interface
    if model.cost.trig:
        return TRIGONOMETRY
    if k_t > 0.0 and (model.kind == "exact" or model.cost.pow):
        return CONDUCTOR
    if n_t < n_i and k_t == 0.0:
        return DIELECTRIC
    if model.kind == "exact" or model.id == "cook_torrance":
        return DIELECTRIC
    return CONDUCTOR if model.cost.pow else SCHLICK


@pytest.fixture(scope="module")
def gpu_page(
    browser_type: BrowserType, browser_type_launch_args: dict[str, Any], server_url: str
) -> Iterator[Page]:
    """A page in a browser of its own that may use the software GPU for WebGPU too."""
    arguments = [*browser_type_launch_args["args"], "--enable-unsafe-webgpu"]
    browser = browser_type.launch(**browser_type_launch_args | {"args": arguments})
    page = browser.new_page()
    page.goto(f"{server_url}/docs")
    yield page
    browser.close()


@pytest.mark.parametrize("model", MODELS, ids=lambda model: model.id)
@pytest.mark.parametrize("language", ["glsl", "wgsl"])
def test_equals_the_model(gpu_page: Page, language: str, model: Model) -> None:
    code = write(model, LANGUAGES[language], 3)
    per_channel = [argument.per_channel for argument in arguments_of(model)]
    worst = {}
    for case in cases(model):
        values = run(gpu_page, language, code, model.id, per_channel, case.arguments)
        if isinstance(values, str):
            (pytest.fail if os.environ.get("CI") else pytest.skip)(values)
        error = np.max(np.abs(values - case.R[:, np.newaxis]))
        worst[case.interface] = error / tolerance(model, case.interface)
    assert max(worst.values()) <= 1.0, worst


@pytest.mark.parametrize("name", ["reflected", "refracted"])
@pytest.mark.parametrize("language", ["glsl", "wgsl"])
def test_directions_equal_those_of_the_optics(gpu_page: Page, language: str, name: str) -> None:
    rng = np.random.default_rng(6)
    mu, eta = rng.uniform(0.05, 1.0, 300), rng.uniform(0.6, 2.5, 300)
    given = np.array([mu, eta, *rng.uniform(-1.0, 1.0, (2, 300))], np.float32).astype(np.float64)
    arguments = given[[0, 2, 3]] if name == "reflected" else given
    # The harness calls a function of colors by the name that those of models have.
    code = write_vectors(LANGUAGES[language]).replace(SUFFIX, "_rgb")
    per_channel = [False] * (len(arguments) - 2) + [True, True]
    values = run(gpu_page, language, code, name, per_channel, arguments)
    if isinstance(values, str):
        (pytest.fail if os.environ.get("CI") else pytest.skip)(values)
    expected = getattr(vectors, name)(*arguments)
    clear = (
        np.abs(vectors.cos2_refracted(given[0], given[1])) > 1e-3
    )  # away from the critical angle
    assert np.max(np.abs(values - expected[:, np.newaxis])[clear]) < DIELECTRIC


def test_reading_a_table_compiles_in_webgpu(gpu_page: Page) -> None:
    told = gpu_page.evaluate(
        """async (code) => {
          const adapter = await navigator.gpu?.requestAdapter();
          if (!adapter) return 'no WebGPU';
          const device = await adapter.requestDevice();
          const module = device.createShaderModule({ code });
          return (await module.getCompilationInfo()).messages.map((m) => m.message);
        }""",
        write_lookup(LANGUAGES["wgsl"]),
    )
    if isinstance(told, str):
        (pytest.fail if os.environ.get("CI") else pytest.skip)(told)
    assert told == []


MOST_AT_ONCE = 4096
"""Columns that a texture has everywhere."""


@pytest.mark.parametrize("model", MODELS, ids=lambda model: model.id)
@pytest.mark.parametrize("language", ["glsl", "wgsl"])
def test_is_defined_at_and_beyond_the_ends(gpu_page: Page, language: str, model: Model) -> None:
    code = write(model, LANGUAGES[language], 3)
    per_channel = [argument.per_channel for argument in arguments_of(model)]
    columns = at_the_ends(model)
    R = []
    for start in range(0, columns.shape[1], MOST_AT_ONCE):
        given = columns[:, start : start + MOST_AT_ONCE]
        values = run(gpu_page, language, code, model.id, per_channel, given)
        if isinstance(values, str):
            (pytest.fail if os.environ.get("CI") else pytest.skip)(values)
        R.append(values)
    for channel in np.concatenate(R).T:
        check_at_the_ends(model, channel, slack=0.1 if model.cost.trig else 1e-5)
