"""All closed models as one module of JavaScript, from which the page draws while something moves.

Nobody writes a formula in JavaScript: each function of the module is translated from the Python that
defines it. What a function takes stands beside it, as `models.schlick.R.takes`.
"""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from hashlib import sha256

from app.optics import real
from app.optics.angles import LEAST_RP, QUADRATURE, Zero
from app.optics.registry import Model, Peak
from app.snippets.formula import MU, Formula, Untranslatable, read
from app.snippets.languages import LANGUAGES
from app.snippets.snippet import formula_of, reason_without

_HEAD = """\
/**
 * The exact solution and every closed model, translated from the Python that defines them.
 * mu = cos(theta_i), eta = n_t / n_i, kappa = k_t / n_i; `takes` names the arguments of a function.
 * `solve` works out a model's parameters that are not given, of the interface and of those before them.
 */
"""

_NUMERICS = """\
const takes = (f, ...names) => Object.assign(f, { takes: names });

/** Where f crosses 0 from below, by halving the interval. */
function zero(f, low, high) {
    for (let i = 0; i < 2000; i += 1) {
        const middle = 0.5 * (low + high);
        if (middle <= low || middle >= high) break;
        if (f(middle) > 0) high = middle;
        else low = middle;
    }
    return low;
}

/** The cosine where f is largest, between the neighbors of the highest of some, by golden sections. */
function top(f, cosines) {
    const heights = cosines.map(f);
    const highest = heights.indexOf(Math.max(...heights));
    const best = Math.min(Math.max(highest, 1), cosines.length - 2);
    let [low, high] = [cosines[best - 1], cosines[best + 1]];
    const share = 0.5 * (Math.sqrt(5) - 1);
    for (let i = 0; i < 40; i += 1) {
        const step = share * (high - low);
        if (f(high - step) > f(low + step)) high = low + step;
        else low = high - step;
    }
    return 0.5 * (low + high);
}
"""

_ZEROS: Mapping[str, Zero] = {"pseudo_brewster_deg": LEAST_RP, "principal_deg": QUADRATURE}


class _Module:
    """Functions of the module by name, each once."""

    def __init__(self) -> None:
        self.functions: dict[str, str] = {}

    def add(self, formula: Formula) -> str:
        """Add a formula with what it calls, and return the name it is called by."""
        for part in formula.everything():
            text = "\n".join(LANGUAGES["javascript"].function(_without_comments(part)))
            if self.functions.setdefault(part.name, text) != text:
                raise ValueError(f"two functions of different kind are named {part.name}")
        return formula.name

    def taking(self, formula: Formula) -> str:
        """Add a formula, and write it with the names of its arguments."""
        names = ", ".join(f'"{name}"' for name in formula.arguments)
        return f"takes({self.add(formula)}, {names})"

    def angle(self, zero: Zero) -> str:
        """Write the angle of a zero, which is Brewster's without absorption."""
        f, low, high, tangent2 = (
            self.add(read(part)) for part in (zero.function, zero.low, zero.high, zero.tangent2)
        )
        ends = f"{low}(eta, kappa), {high}(eta, kappa)"
        x = f"zero((x) => {f}(eta, kappa, x), {ends})"
        angle = f"(180 / Math.PI) * Math.atan(Math.sqrt({tangent2}(eta, kappa, {x})))"
        lossless = f"{self.add(read(real.brewster_deg))}(eta, kappa)"
        return f'takes((eta, kappa) => kappa === 0 ? {lossless} : {angle}, "eta", "kappa")'

    def at_top(self, peak: Peak, name: str) -> str:
        """Write a parameter that a curve has at its top."""
        height, value = read(peak.height, f"{name}_height"), read(peak.value, f"{name}_at")
        taken = [a for a in dict.fromkeys(height.arguments + value.arguments) if a != MU]
        names = ", ".join(f'"{a}"' for a in taken)
        cosines = ", ".join(f"{x:.4g}" for x in peak.cosines)
        found = f"top(({MU}) => {_called(height)}, [{cosines}])"
        self.add(height)
        self.add(value)
        return f"takes(({', '.join(taken)}) => {_called(value, found)}, {names})"


def _called(formula: Formula, cosine: str = MU) -> str:
    given = ", ".join(cosine if a == MU else a for a in formula.arguments)
    return f"{formula.name}({given})"


def kernels(registry: Mapping[str, Model]) -> str:
    """Write the module.

    Parameters
    ----------
    registry
        The models; those without a closed form are left out.
    """
    module = _Module()
    entries: list[str] = []
    for model in registry.values():
        if reason_without(model) is not None:
            continue
        parts = {"R": module.taking(formula_of(model))}
        if model.id == "exact":
            parts |= {
                name: module.taking(read(function)) for name, function in real.QUANTITIES.items()
            }
            parts |= {name: module.angle(zero) for name, zero in _ZEROS.items()}
        solved = [
            f"            {name}: {module.taking(formula)}," for name, formula in _solved(model)
        ] + [
            f"            {name}: {module.at_top(peak, f'{model.id}_{name}')},"
            for name, peak in model.peaks.items()
        ]
        lines = [f"        {name}: {text}," for name, text in parts.items()]
        if solved:
            lines += ["        solve: {", *solved, "        },"]
        entries += [f"    {model.id}: {{", *lines, "    },"]
    functions = "\n\n".join(module.functions.values())
    models = "\n".join(["export const models = {", *entries, "};"])
    body = f"{_NUMERICS}\n{functions}\n\n{models}\n"
    return f'{_HEAD}export const VERSION = "{sha256(body.encode()).hexdigest()[:16]}";\n\n{body}'


def _solved(model: Model) -> Iterator[tuple[str, Formula]]:
    """Yield how parameters are worked out, as far as that is a closed formula."""
    for name, function in model.solve.items():
        try:
            yield name, read(function, f"{model.id}_{name}")
        except Untranslatable:
            continue


def _without_comments(formula: Formula) -> Formula:
    steps = tuple(replace(step, comment=()) for step in formula.steps)
    return replace(formula, steps=steps, comment=())
