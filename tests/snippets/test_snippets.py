"""Snippets: the Python runs and equals the model, compilers take GLSL and HLSL, what is refused."""

import json
import os
import shutil
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.registry import Model, default_registry
from app.optics.vectors import reflect, refract
from app.snippets.formula import Untranslatable, read
from app.snippets.guards import guarded
from app.snippets.languages import LANGUAGES, WIDTH
from app.snippets.lookup import write_lookup
from app.snippets.snippet import arguments_of, reason_without, write
from app.snippets.vectors import write_vectors
from tests.snippets.cases import MODELS, at_the_ends, cases, check_at_the_ends

Array = NDArray[np.float64]

ROUNDING = 1e-13
"""Of the snippets' forms, which lose a few digits where the models do not."""

over_models = pytest.mark.parametrize("model", MODELS, ids=lambda model: model.id)


def executed(model: Model) -> Any:
    names: dict[str, Any] = {}
    exec(write(model, LANGUAGES["python"], 3), names)  # noqa: S102
    return names[model.id]


@over_models
def test_says_where_it_leaves_0_to_1(model: Model) -> None:
    rng, mu = np.random.default_rng(7), Incidence.from_cosine(np.linspace(0.0, 1.0, 41))
    largest = 0.0
    for _ in range(300):
        k_t = rng.uniform(0.01, 8.0) if "conductor" in model.applies_to else 0.0
        interface = Interface(rng.uniform(0.5, 2.0), 10.0 ** rng.uniform(-1.0, 1.0), k_t)
        given = {
            p.name: rng.choice([p.minimum, min(p.maximum, 50.0), rng.uniform(p.minimum, 1.0)])
            for p in model.parameters
            if rng.random() < 0.6 and p.minimum < 1.0
        }
        if model.reason_outside(interface) is None:
            R = model(interface, mu, **given)
            largest = max(largest, float(np.nanmax(np.maximum(R - 1.0, -R), initial=0.0)))
    assert (largest > 1e-3) == model.leaves_0_to_1
    assert largest < 1e-12 or model.leaves_0_to_1
    for language in LANGUAGES.values():
        told = " ".join(write(model, language).split())
        assert ("0 to 1 but for extreme arguments" in told) == model.leaves_0_to_1


@over_models
def test_comments_are_true_of_the_code_they_stand_on(model: Model) -> None:
    written = write(model, LANGUAGES["glsl"])
    lines = written.splitlines()
    comments = " ".join(line.removeprefix("//").strip() for line in lines if line.startswith("//"))
    code = "\n".join(line for line in lines if not line.startswith("//"))
    assert "nless given" not in comments  # every argument must be
    for argument in arguments_of(model):
        assert f"{argument.name}: {argument.description}" in comments
    for words, call in (
        ("a root of less than 0 is 0", "sqrt(max("),
        ("a power of less than 0", "pow(max("),
        ("an arc sine of more than 1", "asin(min("),
        ("mu is cut to them", "clamp(mu"),
    ):
        assert (words in comments) == (call in code), words


def test_only_what_says_why_has_none() -> None:
    without = {m.id: reason_without(m) for m in default_registry().values() if m not in MODELS}
    assert set(without) == {"complex_form", "complex_dielectric", "constant_f0", "lut_1d"}
    assert all(default_registry()[model].snippet == why for model, why in without.items())


@over_models
def test_python_equals_the_model(model: Model) -> None:
    function = executed(model)
    seen = 0
    for case in cases(model, exactly=True):
        with np.errstate(all="ignore"):
            values = function(*case.arguments)
        assert np.max(np.abs(values - case.R)) < ROUNDING
        seen += case.R.size
    assert seen > 400


@over_models
def test_is_defined_at_and_beyond_the_ends_in_32_bits(model: Model) -> None:
    columns = at_the_ends(model).astype(np.float32)
    with np.errstate(all="ignore"):
        R = np.broadcast_to(executed(model)(*columns), columns.shape[1:])
    assert R.dtype == np.float32
    check_at_the_ends(model, R.astype(np.float64), slack=6e-4 if model.cost.trig else 7e-6)


@over_models
@pytest.mark.parametrize("language", LANGUAGES)
def test_says_the_bounds_of_every_argument(model: Model, language: str) -> None:
    code = write(model, LANGUAGES[language], 3).replace(LANGUAGES[language].comment, "")
    told = " ".join(code.split())
    for a in arguments_of(model):
        assert f"{a.name}: {a.description} {a.minimum:g} to {a.maximum:g}." in told
    assert "Beyond its ends mu is cut to them" in told


@over_models
@pytest.mark.parametrize("language", LANGUAGES)
def test_says_what_has_to_be_known(model: Model, language: str) -> None:
    code = write(model, LANGUAGES[language], 3)
    start = LANGUAGES[language].comment
    comments = " ".join(
        line.removeprefix(start).strip() for line in code.splitlines() if line.startswith(start)
    )
    for told in (model.title, model.reference, model.validity):
        assert told in comments
    assert all(f"{m.max_abs:g} at {m.at_deg:g} degrees" in comments for m in model.measured)
    assert all(len(line) <= WIDTH + 8 for line in code.splitlines())
    assert len(code.splitlines()) < 70


@pytest.fixture(scope="module")
def validator() -> str:
    """The reference compiler; without it skip on a laptop and fail in CI."""
    found = shutil.which("glslangValidator")
    if found is None:
        reason = "no glslangValidator: install glslang-tools"
        if os.environ.get("CI"):
            pytest.fail(reason)
        pytest.skip(reason)
    return found


FRAMES = {
    "glsl": "#version 300 es\nprecision highp float;\nout vec4 result;\n{}\n"
    "void main() {{ result = vec4(0.0); }}\n",
    "hlsl": "{}\nfloat4 main() : SV_TARGET {{ return 0.0; }}\n",
}


def compiled(validator: str, language: str, code: str, tmp_path: Path) -> str | None:
    path = tmp_path / "snippet.frag"
    path.write_text(FRAMES[language].format(code), "utf-8")
    options = ["-D", "-e", "main", "-V"] if language == "hlsl" else []
    command = [validator, *options, str(path), *(["-o", os.devnull] if options else [])]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    return None if run.returncode == 0 else run.stdout


@pytest.mark.parametrize("language", FRAMES)
@over_models
def test_compiles(validator: str, model: Model, language: str, tmp_path: Path) -> None:
    code = write(model, LANGUAGES[language], 3)
    assert compiled(validator, language, code, tmp_path) is None
    wrong = code.replace("return", "return undeclared +", 1)
    assert compiled(validator, language, wrong, tmp_path) is not None


def rays() -> tuple[Array, Array, Array, Array]:
    """Incident directions and normals in space, of shape (rays, 3), with mu and eta of each."""
    rng = np.random.default_rng(5)
    d, n = (v / np.linalg.norm(v, axis=1, keepdims=True) for v in rng.normal(size=(2, 200, 3)))
    n = np.where((d * n).sum(axis=1, keepdims=True) > 0.0, -n, n)
    return d, n, -(d * n).sum(axis=1), rng.uniform(0.5, 2.5, 200)


def test_directions_in_python_are_those_of_the_optics() -> None:
    names: dict[str, Any] = {}
    exec(write_vectors(LANGUAGES["python"]), names)  # noqa: S102
    for d, n, mu, eta in zip(*rays(), strict=True):
        np.testing.assert_allclose(names["reflected"](mu, d, n), reflect(d, n), atol=1e-15)
        ray = refract(d, n, 1.0, eta)
        np.testing.assert_allclose(names["refracted"](mu, eta, d, n), ray.direction, atol=1e-15)


def test_directions_in_javascript_are_those_of_the_optics() -> None:
    node = shutil.which("node")
    if node is None:
        (pytest.fail if os.environ.get("CI") else pytest.skip)("no node")
    d, n, mu, eta = (values.tolist() for values in rays())
    script = write_vectors(LANGUAGES["javascript"]) + (
        f"const [d, n, mu, eta] = {json.dumps([d, n, mu, eta])};\n"
        "console.log(JSON.stringify(d.map((each, j) => [reflected_xyz(mu[j], each, n[j]), "
        "refracted_xyz(mu[j], eta[j], each, n[j])])));"
    )
    told = subprocess.run([node, "-e", script], capture_output=True, text=True, check=True)
    for i, up, ratio, (mirrored, bent) in zip(d, n, eta, json.loads(told.stdout), strict=True):
        np.testing.assert_allclose(mirrored, reflect(i, up), atol=1e-15)
        np.testing.assert_allclose(bent, refract(i, up, 1.0, ratio).direction, atol=1e-15)


@pytest.mark.parametrize("language", FRAMES)
def test_directions_compile(validator: str, language: str, tmp_path: Path) -> None:
    code = write_vectors(LANGUAGES[language])
    assert "reflected_xyz(float mu, " in code
    assert compiled(validator, language, code, tmp_path) is None
    wrong = code.replace("return", "return undeclared +", 1)
    assert compiled(validator, language, wrong, tmp_path) is not None


TABLE = [0.0, 0.3, 0.35, 1.0, 0.9]
COSINES = [-0.1, 0.0, 0.1, 0.5, 0.77, 1.0, 1.1]
READ = np.interp(COSINES, np.linspace(0.0, 1.0, len(TABLE)), TABLE)


def test_a_table_is_read_in_python_as_numpy_interpolates() -> None:
    names: dict[str, Any] = {}
    exec(write_lookup(LANGUAGES["python"]), names)  # noqa: S102
    np.testing.assert_allclose(names["table_lookup"](TABLE, np.array(COSINES)), READ, atol=1e-15)


def test_a_table_is_read_in_javascript_as_numpy_interpolates() -> None:
    node = shutil.which("node")
    if node is None:
        (pytest.fail if os.environ.get("CI") else pytest.skip)("no node")
    script = write_lookup(LANGUAGES["javascript"]) + (
        f"console.log(JSON.stringify({COSINES}.map((mu) => table_lookup({TABLE}, mu))));"
    )
    told = subprocess.run([node, "-e", script], capture_output=True, text=True, check=True)
    np.testing.assert_allclose(json.loads(told.stdout), READ, atol=1e-15)


@pytest.mark.parametrize("language", FRAMES)
def test_reading_a_table_compiles(validator: str, language: str, tmp_path: Path) -> None:
    code = write_lookup(LANGUAGES[language])
    assert compiled(validator, language, code, tmp_path) is None
    wrong = code.replace("return", "return undeclared +", 1)
    assert compiled(validator, language, wrong, tmp_path) is not None


CONSTANT = 2.5


def doubled(x: Array) -> Array:
    return 2.0 * x


def busy(x: Array) -> Array:
    y = x + 1.0
    return np.asarray(y * y)


def made(interface: Interface, incidence: Incidence, share: Array) -> Array:
    """All that a formula may hold."""
    eta, c = interface.eta, incidence.cos
    # Two lines that belong
    # to what stands below.
    inside = (c > 0.5) & ~(eta == CONSTANT)
    return np.where(inside, busy(-share), doubled(eta) - (c - share) ** 3 / (c * share))


def rooted(interface: Interface, incidence: Incidence, share: Array) -> Array:
    """Roots, powers and arc sines that need a bound, and some that need none."""
    s = incidence.sin
    ratio = np.sqrt(share * share + s) / interface.eta
    return np.arcsin(ratio) + np.sqrt(1.0 - ratio) + (1.0 - incidence.cos) ** share + share**0.5


def test_bounds_stand_where_something_may_be_undefined_and_nowhere_else() -> None:
    glsl = "\n".join(LANGUAGES["glsl"].function(guarded(read(rooted))))
    assert glsl == (
        "float rooted(float mu, float eta, float share) {\n"
        "    float c = clamp(mu, 0.0, 1.0);\n"
        "    float s = sqrt((1.0 - c) * (1.0 + c));\n"
        "    float ratio = sqrt(share * share + s) / eta;\n"
        "    return asin(min(ratio, 1.0)) + sqrt(max(1.0 - ratio, 0.0)) + pow(1.0 - c, share)\n"
        "            + pow(max(share, 0.0), 0.5);\n"
        "}"
    )


class TestReading:
    def test_every_language_writes_the_same(self) -> None:
        formula = read(made)
        assert formula.arguments == ("mu", "eta", "share")
        (glsl, osl, wgsl) = (
            "\n".join(LANGUAGES[x].function(formula)) for x in ("glsl", "osl", "wgsl")
        )
        assert glsl == (
            "float made(float mu, float eta, float share) {\n"
            "    const float CONSTANT = 2.5;\n"
            "    float c = mu;\n"
            "    // Two lines that belong\n"
            "    // to what stands below.\n"
            "    bool inside = (c > 0.5) && !(eta == CONSTANT);\n"
            "    return inside ? busy(-share) : 2.0 * eta - pow(c - share, 3.0) / (c * share);\n"
            "}"
        )
        assert "    int inside = (c > 0.5) && !(eta == CONSTANT);" in osl
        assert "    let inside = (c > 0.5) && !(eta == CONSTANT);" in wgsl
        assert "select(2.0 * eta - pow(c - share, 3.0) / (c * share), busy(-share), inside)" in wgsl
        assert [f.name for f in formula.everything()] == ["busy", "made"]

    def test_python_comes_back(self) -> None:
        names: dict[str, Any] = {"np": np}
        for part in read(made).everything():
            exec("\n".join(LANGUAGES["python"].function(part)), names)  # noqa: S102
        mu, eta, share = np.array([[0.2, 0.7, 0.9], [1.5, 1.5, 2.5], [0.3, 0.6, 0.8]])
        interface, incidence = Interface(1.0, eta), Incidence.from_cosine(mu)
        assert np.array_equal(names["made"](mu, eta, share), made(interface, incidence, share))

    def test_floats_do_not_associate(self) -> None:
        formula = read(lopsided)
        assert LANGUAGES["glsl"].inside(formula.value, 0) == "x + (y - (x - y)) / (x / (y * x))"

    @pytest.mark.parametrize("name", ["branching", "looping", "renaming", "listing", "asking"])
    def test_refuses_what_it_cannot_write(self, name: str) -> None:
        with pytest.raises(Untranslatable):
            read(globals()[name])

    def test_refuses_what_it_cannot_read(self) -> None:
        for function in (np.sqrt, lambda x: x):
            with pytest.raises(Untranslatable):
                read(function)


def lopsided(x: Array, y: Array) -> Array:
    return x + (y - (x - y)) / (x / (y * x))


def branching(x: float) -> float:
    if x > 0.0:
        return x
    return 0.0


def looping(x: Array) -> Array:
    for _ in range(3):
        x = x * x
    return x


def renaming(x: Array) -> Array:
    x = x + 1.0
    return x * x


def listing(x: Array) -> Array:
    return np.array([x, x])


def asking(interface: Interface) -> Array:
    return interface.eta_minus_1
