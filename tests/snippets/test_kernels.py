"""The kernels: run by Node.js at 10,000 points each, they say what Python says."""

import gzip
import json
import os
import shutil
import subprocess
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from app.optics.amplitudes import amplitudes
from app.optics.angles import LANDMARKS
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.quantities import QUANTITIES
from app.optics.registry import Model, default_registry
from app.optics.specular import F82
from app.snippets.kernels import kernels
from app.snippets.languages import LANGUAGES
from app.snippets.snippet import arguments_of, write
from tests.snippets.cases import MODELS, cases

Array = NDArray[np.float64]

POINTS = 10_000
LARGEST = 12_000
"""Bytes of the module, compressed."""

EVALUATE = """
import { readFileSync } from "node:fs";
const [path, module] = process.argv.slice(1);
const { models } = await import(module);
const asked = JSON.parse(readFileSync(path, "utf8"));
const answers = asked.map(({ path, columns }) => {
  const f = path.reduce((found, key) => found[key], models);
  const given = f.takes.map((name) => columns[name]);
  return given[0].map((_, i) => f(...given.map((column) => column[i])));
});
process.stdout.write(JSON.stringify(answers));
"""


@pytest.fixture(scope="module")
def node() -> str:
    """Node.js; without it skip on a laptop and fail in CI."""
    found = shutil.which("node")
    if found is None:
        if os.environ.get("CI"):
            pytest.fail("no Node.js")
        pytest.skip("no Node.js")
    return found


@dataclass(frozen=True)
class Points:
    """Interfaces and directions, of one shape; eta and kappa are exact quotients."""

    n_i: Array
    n_t: Array
    k_t: Array
    mu: Array

    @property
    def interface(self) -> Interface:
        return Interface(self.n_i, self.n_t, self.k_t)

    @property
    def incidence(self) -> Incidence:
        return Incidence.from_cosine(self.mu)

    @property
    def columns(self) -> dict[str, Array]:
        media = self.interface
        names = ("n_i", "n_t", "k_t", "eta", "kappa", "F0")
        return {"mu": self.mu, "F82": F82(media)} | {n: getattr(media, n) for n in names}

    @property
    def from_critical(self) -> Array:
        """Distance in radians from the critical angle, infinite where there is none."""
        with np.errstate(invalid="ignore"):
            distance = np.abs(np.arccos(self.mu) - np.arcsin(self.n_t / self.n_i))
        return np.where((self.n_t < self.n_i) & (self.k_t == 0.0), distance, np.inf)


def points(kinds: tuple[str, ...], guard: float, contrast: float = 0.0) -> Points:
    """Spread points over both kinds of interface and both sides, crowded where digits get lost.

    These are the neighborhoods of grazing and of normal incidence, of Brewster's and of the critical
    angle, but not within `guard` radians of the latter, nor with an eta within `contrast` of 1.
    """
    rng = np.random.default_rng(17)
    count = 2 * POINTS
    n_i = np.exp2(rng.integers(-1, 3, count).astype(np.float64))
    far = rng.random(count) < 0.5
    ratio = np.power(10.0, rng.uniform(np.where(far, -1.5, -0.3), np.where(far, 1.3, 0.3)))
    n_t = n_i * ratio
    absorbs = {"dielectric": 0.0, "conductor": 1.0}[kinds[0]] if len(kinds) == 1 else 0.5
    k_t = np.where(rng.random(count) < absorbs, n_i * 10.0 ** rng.uniform(-4.0, 1.3, count), 0.0)
    near = rng.choice([-1.0, 1.0], count) * 10.0 ** rng.uniform(-5.9, -1.0, count)
    tiny = 10.0 ** rng.uniform(-12.0, -1.0, count)
    brewster, critical = np.arctan(n_t / n_i), np.arcsin(np.minimum(n_t / n_i, 1.0))
    about = [
        np.cos(np.clip(angle + near, 0.0, 0.5 * np.pi)).clip(0.0) for angle in (brewster, critical)
    ]
    where = rng.integers(0, 5, count)
    mu = np.choose(where, [rng.uniform(0.0, 1.0, count), tiny, 1.0 - tiny, *about])
    mu[:2] = 0.0, 1.0
    seen = np.abs(n_t / n_i - 1.0) > contrast
    kept = np.flatnonzero(seen & (Points(n_i, n_t, k_t, mu).from_critical > guard))[:POINTS]
    assert kept.size == POINTS
    return Points(n_i[kept], n_t[kept], k_t[kept], mu[kept])


def own(model: Model, media: Interface) -> dict[str, Array]:
    """Values of a model's parameters: of the interface or the default for half, any for the others."""
    rng, given = np.random.default_rng(5), {}
    for parameter, solved in zip(model.parameters, model.arguments(media).values(), strict=True):
        low, high = max(parameter.minimum, -20.0), min(parameter.maximum, 20.0)
        anything = rng.uniform(low, high, POINTS)
        allowed = parameter.admits(np.broadcast_to(solved, POINTS))
        given[parameter.name] = np.where(allowed & (rng.random(POINTS) < 0.5), solved, anything)
    return given


class Asking:
    """Kernels that are asked all at once."""

    def __init__(self) -> None:
        self.asked: list[dict[str, Any]] = []

    def ask(self, path: list[str], columns: Mapping[str, Array], size: int = POINTS) -> None:
        lists = {name: np.broadcast_to(c, size).tolist() for name, c in columns.items()}
        self.asked.append({"path": path, "columns": lists})

    def answers(self, node: str, folder: Path, module: str | None = None) -> list[Array]:
        text = kernels(default_registry()) if module is None else module
        (folder / "kernels.mjs").write_text(text, "utf-8")
        (folder / "asked.json").write_text(json.dumps(self.asked), "utf-8")
        run = subprocess.run(
            [node, "--input-type=module", "-e", EVALUATE, "asked.json", f"{folder}/kernels.mjs"],
            cwd=folder,
            capture_output=True,
            text=True,
            check=True,
        )
        return [np.array(values, dtype=np.float64) for values in json.loads(run.stdout)]


def assert_near(values: Array, right: Array, rtol: float, atol: float = 0.0) -> None:
    right = np.broadcast_to(right, values.shape)
    assert np.array_equal(np.isnan(values), np.isnan(right))
    with np.errstate(invalid="ignore"):
        excess = np.nan_to_num(np.abs(values - right) - atol - rtol * np.abs(right), nan=-1.0)
    assert excess.max() <= 0.0, f"{values[excess.argmax()]} is not {right[excess.argmax()]}"


def test_R_of_every_model_is_that_of_python(node: str, tmp_path: Path) -> None:
    asking, right = Asking(), []
    for model in MODELS:
        # Other forms lose digits at the critical angle from farther away, and as eta approaches 1.
        guards = (1e-6, 0.0) if model.id == "exact" else (1e-3, 0.05)
        at = points(model.applies_to, *guards)
        given = own(model, at.interface)
        asking.ask([model.id, "R"], at.columns | given)
        right.append(model(at.interface, at.incidence, **given))
    for model, values, R in zip(MODELS, asking.answers(node, tmp_path), right, strict=True):
        assert np.isfinite(R).sum() > POINTS // 2
        if model.id in {"deon_pq", "shirley_ab"}:
            # Beyond the critical angle they take a root of what rounding leaves of 0.
            at = points(model.applies_to, 1e-3, 0.05)
            total = (at.k_t < 0.3 * at.n_i) & (
                at.mu < np.cos(np.arcsin(np.minimum(at.n_t / at.n_i, 1.0)))
            )
            values, R = np.where(total, 1.0, values), np.where(total, 1.0, R)
        # Where a difference all but vanishes, a few roundings of 1 are left.
        assert_near(values, R, 1e-12, 0.0 if model.id == "exact" else 1e-15)


def test_what_exact_knows_besides_is_that_of_python(node: str, tmp_path: Path) -> None:
    both = ("dielectric", "conductor")
    at, apart = points(both, 1e-6), points(both, 1e-3)
    asking, right = Asking(), dict[str, tuple[Array, float, float]]()
    for name in ("Rs", "Rp", "T", "Ts", "Tp", "theta_t_deg"):
        # A power that vanishes at an angle has its digits a little away from it.
        right[name] = (QUANTITIES[name](at.interface, at.incidence), 1e-12, 1e-12)
    r = amplitudes(at.interface, at.incidence)
    for name in ("r_s", "r_p", "t_s", "t_p"):
        amplitude = getattr(r, name)
        right[f"{name}_re"] = (amplitude.real, 1e-12, 1e-11)
        right[f"{name}_im"] = (amplitude.imag, 1e-12, 1e-11)
    for name in ("F0", "F82", *LANDMARKS):
        value = at.columns[name] if name in at.columns else LANDMARKS[name](at.interface)
        right[name] = (value, 1e-12, 0.0)
    for name in right:
        asking.ask(["exact", name], at.columns)
    depths = [f"{field}penetration_depth_wavelengths" for field in ("", "field_")]
    for name in depths:
        asking.ask(["exact", name], apart.columns)
    phases = ("phase_s_deg", "phase_p_deg")
    for name in phases:
        asking.ask(["exact", name], at.columns)
    *answers, power, field, s, p = asking.answers(node, tmp_path)
    for values, expected in zip(answers, right.values(), strict=True):
        assert_near(values, *expected)
    for name, values in zip(depths, (power, field), strict=True):
        assert_near(values, QUANTITIES[name](apart.interface, apart.incidence), 1e-12)
    for name, phase in zip(phases, (s, p), strict=True):
        turned = phase - QUANTITIES[name](at.interface, at.incidence)
        # Where an amplitude all but vanishes its phase is anything.
        seen = np.abs(r.r_s if name == "phase_s_deg" else r.r_p) > 1e-4
        assert np.abs((turned[seen] + 180.0) % 360.0 - 180.0).max() < 1e-8


def test_grazing_phases_have_the_sign_of_their_limit(node: str, tmp_path: Path) -> None:
    at = points(("dielectric", "conductor"), 0.0)
    grazing = Points(at.n_i, at.n_t, at.k_t, np.zeros(POINTS))
    asking, names = Asking(), ("phase_s_deg", "phase_p_deg")
    for name in names:
        asking.ask(["exact", name], grazing.columns)
    for name, values in zip(names, asking.answers(node, tmp_path), strict=True):
        assert np.array_equal(values, QUANTITIES[name](grazing.interface, grazing.incidence))


def test_parameters_are_worked_out_as_in_python(node: str, tmp_path: Path) -> None:
    asking, right = Asking(), []
    for model in MODELS:
        at = points(model.applies_to, 0.0)
        solved, given = model.arguments(at.interface), own(model, at.interface)
        for known in (solved, given):
            for i, parameter in enumerate(model.parameters):
                if parameter.default is not None or parameter.name in model.peaks:
                    continue
                before = {p.name: known[p.name] for p in model.parameters[:i]}
                asking.ask([model.id, "solve", parameter.name], at.columns | before)
                right.append(model.arguments(at.interface, **before)[parameter.name])
    for values, expected in zip(asking.answers(node, tmp_path), right, strict=True):
        assert_near(values, expected, 1e-12, 1e-13)


def test_alpha_of_metals_is_found_as_in_python(node: str, tmp_path: Path) -> None:
    model, asking = default_registry()["lazanyi2005"], Asking()
    at = points(("conductor",), 0.0)
    solved = model.arguments(at.interface)
    asking.ask([model.id, "solve", "alpha"], at.columns | {"a": solved["a"]})
    (alpha,) = asking.answers(node, tmp_path)
    mu = np.linspace(0.0, 1.0, 181)[:, np.newaxis]
    curves = [
        model.evaluate(at.interface, Incidence.from_cosine(mu), solved | {"alpha": values})
        for values in (alpha, solved["alpha"])
    ]
    # A top is known to half the digits of its height, and so is what is drawn of it. Next to no metals
    # have several tops of nearly one height, or the one that NumPy's search stops before.
    metals, found = at.k_t > 0.1 * at.n_i, np.isfinite(solved["alpha"])
    assert (np.isfinite(alpha) != found)[metals].sum() < 5
    both = metals & found & np.isfinite(alpha)
    assert both.sum() > POINTS // 4
    assert_near(curves[0][:, both], curves[1][:, both], 0.0, 1e-6)


def test_code_to_take_away_runs(node: str, tmp_path: Path) -> None:
    asking, right, entries = Asking(), list[Array](), list[str]()
    for model in MODELS:
        names = [a.name for a in arguments_of(model)]
        code = write(model, LANGUAGES["javascript"], 3)
        colors = [a.name for a in arguments_of(model) if a.per_channel]
        entries.append(f"{model.id}: (() => {{ {code}")
        entries.append(f"Object.assign({model.id}, {{takes: {json.dumps(names)}}});")
        if colors:
            once = ", ".join(f"[{n}, 1, {n}]" if n in colors else n for n in names)
            entries.append(
                f"const rgb = Object.assign(({', '.join(names)}) => {{"
                f" const [R, , B] = {model.id}_rgb({once}); return R === B ? R : 'differ'; }},"
                f" {{takes: {json.dumps(names)}}}); return {{R: {model.id}, rgb}}; }})(),"
            )
        else:
            entries.append(f"return {{R: {model.id}, rgb: {model.id}}}; }})(),")
        for case in cases(model, exactly=True):
            for function in ("R", "rgb"):
                columns = dict(zip(names, case.arguments, strict=True))
                asking.ask([model.id, function], columns, case.R.size)
                right.append(case.R)
    module = "\n".join(["export const models = {", *entries, "};"])
    for values, R in zip(asking.answers(node, tmp_path, module), right, strict=True):
        assert_near(values, R, 0.0, 1e-13)


def test_is_small_and_versioned() -> None:
    module = kernels(default_registry())
    assert len(gzip.compress(module.encode(), 1)) < LARGEST
    assert kernels(default_registry()) == module
    few = kernels({name: default_registry()[name] for name in ("exact", "schlick")})
    versions = [text.split('VERSION = "')[1][:16] for text in (module, few)]
    assert versions[0] != versions[1]
    for model in MODELS:
        names = ", ".join(f'"{a.name}"' for a in arguments_of(model))
        function = "R" if model.id == "exact" else model.id
        assert f"R: takes({function}, {names})" in module
