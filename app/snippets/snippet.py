"""A model as code to take away: its formula with what has to be known of it."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from app.optics.parameters import K_T, MU, N_I, N_T
from app.optics.registry import Measured, Model
from app.snippets.formula import Formula, Untranslatable, read
from app.snippets.guards import guarded, told
from app.snippets.languages import Language

ETA_ENDS = (1e-3, 1e3)
"""What the code is run at: further out some forms lose all digits of 32 bit floats."""
_MEANINGS = {p.name: (p.description, p.minimum, p.maximum) for p in (MU, N_I, N_T, K_T)} | {
    "eta": ("Relative index n_t / n_i.", *ETA_ENDS),
    "kappa": ("Relative extinction k_t / n_i.", 0.0, ETA_ENDS[1]),
    "F0": ("Reflectance at normal incidence, linear.", 0.0, 1.0),
    "F82": ("Reflectance at cos(theta_i) = 1/7, linear.", 0.0, 1.0),
}
"""Words, least and largest value of what is no parameter of a model alone."""


@dataclass(frozen=True, slots=True)
class Argument:
    """An argument of a snippet."""

    name: str
    description: str
    """As everywhere: mu, n_i, n_t, k_t, eta, kappa, F0 or a parameter of the model."""
    per_channel: bool
    """Whether it differs from channel to channel of a color."""
    minimum: float
    maximum: float
    """Inclusive bounds."""


def formula_of(model: Model) -> Formula:
    """Read the model's formula.

    Raises
    ------
    Untranslatable
        If the model has no closed form of real numbers; the message says why.
    """
    if isinstance(model.snippet, str):
        raise Untranslatable(model.snippet)
    return read(model.snippet or model.function, model.id)


def reason_without(model: Model) -> str | None:
    """Why there is no snippet of the model, or None if there is one."""
    try:
        formula_of(model)
    except Untranslatable as error:
        return str(error)
    return None


def arguments_of(model: Model) -> tuple[Argument, ...]:
    """List the snippet's arguments in their order.

    Raises
    ------
    Untranslatable
        If the model has no closed form of real numbers.
    """
    own = {parameter.name: parameter for parameter in model.parameters}
    listed: list[Argument] = []
    for name in formula_of(model).arguments:
        if name in own:
            parameter = own[name]
            per_channel = parameter.triple or parameter.default is None
            least, most = parameter.minimum, parameter.maximum
            meaning = _in_code(parameter.description)
            if name in _MEANINGS:
                meaning = _MEANINGS[name][0]
        else:
            per_channel = name not in ("mu", "n_i")
            meaning, least, most = _MEANINGS[name]
        listed.append(Argument(name, meaning, per_channel, least, most))
    return tuple(listed)


def _in_code(description: str) -> str:
    """What a parameter is where it must be given: code has no value for one that is left out."""
    said = description.partition(" Three values")[0]
    sentences = []
    for sentence in said.split(". "):
        clauses = sentence.removesuffix(".").split("; ")
        kept = "; ".join(clause for clause in clauses if "nless given" not in clause)
        sentences += [f"{kept}."] if kept else []
    return " ".join(sentences)


def write(model: Model, language: Language, channels: int = 1) -> str:
    """Write the model in a language, with its source, domain and measured errors as comments.

    Parameters
    ----------
    model
        Any model with a closed form.
    language
        One of `LANGUAGES`.
    channels
        1 for a function of real numbers; 3 adds one of colors, `<id>_rgb`, that calls it three times.
        Python needs none: its arrays broadcast.

    Raises
    ------
    Untranslatable
        If the model has no closed form of real numbers.
    """
    formula, arguments = guarded(formula_of(model)), arguments_of(model)
    lines = language.commented(
        [
            *_told(model),
            *untested(language),
            *_ends(arguments),
            *filter(None, [told(formula)]),
        ]
    )
    if language.id == "python":
        lines += ["", "import numpy as np"]
    functions = [language.function(part) for part in formula.everything()]
    colors = [argument.name for argument in arguments if argument.per_channel]
    if channels == 3 and colors:
        functions.append(language.per_channel(formula, colors))
    between = ["", ""] if language.id == "python" else [""]
    for function in filter(None, functions):
        lines += [*between, *function]
    return "\n".join(lines) + "\n"


def _told(model: Model) -> Iterator[str]:
    but = " but for extreme arguments" if model.leaves_0_to_1 else ""
    yield f"{model.title}: reflectance of unpolarized light, 0 to 1{but}"
    yield f"Source: {model.reference}"
    yield f"Domain ({', '.join(model.applies_to)}): {model.validity}"
    if model.kind == "exact":
        yield "Error: none but rounding"
    else:
        errors = "; ".join(_error(measured) for measured in model.measured)
        yield f"Error, measured, largest of |R - exact|: {errors}"


def _ends(arguments: Sequence[Argument]) -> Iterator[str]:
    for a in arguments:
        yield f"{a.name}: {a.description} {a.minimum:g} to {a.maximum:g}."
    if {"n_i", "n_t"} <= {a.name for a in arguments}:
        yield "n_t / n_i: {:g} to {:g}.".format(*ETA_ENDS)


def untested(language: Language) -> Iterator[str]:
    """Say so where no test of ours can compile the language."""
    if language.checked == "untested":
        yield untested_words(language.checked_by)


def untested_words(by: str) -> str:
    """What is said in the code: pasted code has left behind what the page and the API say of it."""
    return f"Untested: {by}"


def _error(measured: Measured) -> str:
    index = f"{measured.n_t:g}" + (f" + {measured.k_t:g}i" if measured.k_t else "")
    at = f"{measured.at_deg:g} degrees"
    return f"{measured.max_abs:g} at {at}, from n = {measured.n_i:g} to {index}"
