r"""The letters of a formula: which there are, and what each means.

The glossary holds those that mean the same everywhere. A formula explains the others itself, as its
parameters, by declared symbols, or by an equation of its own such as `g=\sqrt{\eta^2-1+c^2}`.
"""

import re
from collections.abc import Iterable, Iterator

from app.optics.formulas.formula import Symbol
from app.optics.parameters import Parameter

GLOSSARY = (
    Symbol("R", "reflectance of unpolarized light"),
    Symbol("R_s", "reflectance of light polarized perpendicular to the plane of incidence"),
    Symbol("R_p", "reflectance of light polarized in the plane of incidence"),
    Symbol("r_s", "amplitude coefficient of s-polarized light"),
    Symbol("r_p", "amplitude coefficient of p-polarized light, −r_s at normal incidence"),
    Symbol(r"R_\text{exact}", "reflectance by the exact solution"),
    Symbol(r"\theta_i", "angle of incidence from the normal", "rad"),
    Symbol(r"\theta", "angle of incidence from the normal", "rad"),
    Symbol(r"\theta_t", "angle of refraction from the normal", "rad"),
    Symbol(r"\mu", "cosine of the angle of incidence"),
    Symbol(r"\bar\mu", "cosine 1/7, an angle of 81.8 degrees"),
    Symbol("n_i", "refractive index of the incident medium, real"),
    Symbol("n_t", "refractive index of the second medium, its real part"),
    Symbol("k_t", "extinction of the second medium, at least 0"),
    Symbol("N", "complex index of the second medium, over n_i unless written otherwise"),
    Symbol(r"\eta", "relative index n_t / n_i"),
    Symbol(r"\kappa", "relative extinction k_t / n_i"),
    Symbol("i", "imaginary unit"),
    Symbol("F_0", "reflectance at normal incidence, linear"),
    Symbol("F_{82}", "reflectance at cosine 1/7, about 82 degrees, linear"),
    Symbol("F_{90}", "reflectance at grazing incidence"),
    Symbol("A", "hemispherical albedo, the reflectance of diffuse light"),
    Symbol("A_s", "albedo for light polarized perpendicular to each plane of incidence"),
    Symbol("A_p", "albedo for light polarized in each plane of incidence"),
    Symbol("S", "Schlick's polynomial F₀ + (1 − F₀)(1 − μ)⁵"),
)

_GREEK = "alpha|beta|eta|kappa|lambda|mu|phi|Pi|rho|theta"
# Commands whose braces hold no letters of the formula.
_PROSE = re.compile(r"\\(?:operatorname|mathrm|begin|end)\{[^{}]*\}")
_INDEX = r"(?:_(?:\{[^{}]*\}|\\text\{[^{}]*\}|\\[a-z]+|[A-Za-z0-9]))?'?(?:\^\\text\{[^{}]*\})?"
_TOKEN = re.compile(
    rf"(?P<text>\\text\{{(?P<words>[^{{}}]*)\}})"
    rf"|(?P<name>(?:\\bar)?\\(?:{_GREEK})(?![a-z]){_INDEX})"
    rf"|(?P<command>\\[A-Za-z]+)"
    rf"|(?P<letter>[A-Za-z]{_INDEX})"
)
_WORD = re.compile(r"[a-z]+")


def letters(latex: str) -> list[str]:
    r"""Every letter of a formula, with its index and its prime, in the order of appearance.

    Examples
    --------
    >>> letters(r"F_0+(1-F_0)(1-\mu)^5\quad\text{for}\ \theta_i<90")
    ['F_0', '\\mu', '\\theta_i']
    """
    return list(dict.fromkeys(_letters(_PROSE.sub(" ", latex))))


def _letters(latex: str) -> Iterator[str]:
    prose = {"for", "if", "and", "although", "else", "otherwise"}
    for match in _TOKEN.finditer(latex):
        if match["text"] is not None:
            # A parameter may be a word, such as a tint.
            if _WORD.fullmatch(match["words"]) and match["words"] not in prose:
                yield match["text"]
        elif match["command"] is None:
            yield match[0]


def defined(latex: str) -> set[str]:
    """The letters on the left of an equation within the formula."""
    found: set[str] = set()
    for clause in re.split(r",\\(?:quad|qquad|\\)", latex):
        left, sign, _ = clause.partition("=")
        if sign:
            found |= {*letters(left)}
    return found


def explain(latex: str, own: Iterable[Symbol], parameters: Iterable[Parameter]) -> list[Symbol]:
    """Say what each letter of a formula means, in the order of appearance.

    Raises
    ------
    LookupError
        If nothing explains a letter.
    """
    known = {symbol.latex: symbol for symbol in GLOSSARY}
    known |= {p.symbol: Symbol(p.symbol, _sentence(p.description), p.unit) for p in parameters}
    known |= {symbol.latex: symbol for symbol in own}
    here, explained = defined(latex), []
    for letter in letters(latex):
        if letter in known:
            explained.append(known[letter])
        elif letter in here:
            explained.append(Symbol(letter, "as the formula says"))
        else:
            raise LookupError(f"{letter} of {latex} is not explained")
    return explained


def _sentence(description: str) -> str:
    return description[:1].lower() + description[1:].rstrip(".")
