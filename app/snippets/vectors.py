"""Reflected and refracted directions as code to take away, component by component and as vectors."""

from dataclasses import replace

from app.optics import vectors
from app.optics.parameters import MU
from app.snippets.formula import read
from app.snippets.guards import guarded, told
from app.snippets.languages import Language
from app.snippets.piece import Piece
from app.snippets.snippet import ETA_ENDS, Argument, untested

REFERENCE = (
    "S. Lagarde, Memo on Fresnel equations (2013), after B. de Greve, Reflections and Refractions in "
    "Ray Tracing (2006)"
)
VALIDITY = (
    "d points toward the surface, n is its unit normal on the incident side, mu = -dot(d, n); refracted "
    "is 0 where all is reflected."
)
FUNCTIONS = (vectors.reflected, vectors.refracted)
SUFFIX = "_xyz"
"""Of the functions of vectors, which call those of components."""

_VECTORS = ("d", "n")
ARGUMENTS = (
    Argument(MU.name, MU.description, per_channel=False, minimum=MU.minimum, maximum=MU.maximum),
    Argument(
        "eta",
        "Relative index n_t / n_i.",
        per_channel=False,
        minimum=ETA_ENDS[0],
        maximum=ETA_ENDS[1],
    ),
    Argument("d", "Incident direction, a component.", per_channel=True, minimum=-1.0, maximum=1.0),
    Argument("n", "Normal, a component.", per_channel=True, minimum=-1.0, maximum=1.0),
)


def write_vectors(language: Language) -> str:
    """Write both directions in a language, with their source and meaning as comments.

    Each comes as a function of one component and, but for Python, whose arrays broadcast, as one of
    vectors, `reflected_xyz` and `refracted_xyz`.
    """
    formulas = [guarded(read(function)) for function in FUNCTIONS]
    lines = language.commented(
        [
            "Reflected and refracted directions of unit length, by Snell's law in vector form",
            f"Source: {REFERENCE}",
            VALIDITY,
            *untested(language),
            *(f"{a.name}: {a.description} {a.minimum:g} to {a.maximum:g}." for a in ARGUMENTS),
            max(map(told, formulas), key=len),
        ]
    )
    if language.id == "python":
        lines += ["", "import numpy as np"]
    of_space = replace(
        language,
        rgb=language.rgb if language.id == "osl" else (".x", ".y", ".z"),
        color="vector" if language.id == "osl" else language.color,
    )
    between = ["", ""] if language.id == "python" else [""]
    seen: set[str] = set()
    for formula in formulas:
        parts = [part for part in formula.everything() if part.name not in seen]
        seen |= {part.name for part in parts}
        written = [language.function(part) for part in parts]
        written.append(of_space.per_channel(formula, _VECTORS, SUFFIX))
        for each in filter(None, written):
            lines += [*between, *each]
    return "\n".join(lines) + "\n"


PIECE = Piece(
    id="vectors",
    title="Reflected and refracted directions",
    reference=REFERENCE,
    validity=VALIDITY,
    functions=tuple(function.__name__ for function in FUNCTIONS),
    arguments=ARGUMENTS,
    write=write_vectors,
)
