"""What columns hold, by their names, by their numbers and by hand."""

import re
from collections.abc import Sequence

import numpy as np

from app.materials.reading.report import Notes, Undecided
from app.materials.reading.rows import COMMENT, Layout
from app.materials.reading.units import UNITS, unit_spelled, units_named
from app.optics.errors import NotAllowed
from app.optics.parameters import Array

ABSCISSAE = ("wavelength", "energy", "wavenumber", "frequency")
PAIRS = (("n", "k"), ("eps1", "eps2"), ("delta", "beta"))
"""Columns that are N = n + i k together, n, k or 1 - n."""
ROLES = (*ABSCISSAE, *(name for pair in PAIRS for name in pair), "-")
"""What the parameter `columns` takes; - stands for a column that is not used."""

_UNIT = re.compile(r"[\(\[\{/,_ ]\s*([^\(\)\[\]\{\}/,_ ]+(?:\^?\(?[-−⁻][1¹]\)?)?)\s*[\)\]\}]?\s*$")
_NAMES = {
    "wavelength": r"wl|w|wave|wvl|lam|lambda|λ|wave-?len(gth)?s?|wellenl(ä|ae)nge|longueurd.?onde|"
    r"longituddeonda|lunghezzad.?onda",
    "energy": r"e|energy|photonenergy|[eé]nergie|energ[ií]a|hv|hν|ħω|hbaromega",
    "wavenumber": r"wavenumbers?|wellenzahl|sigma|ν̃",
    "frequency": r"f|freq|frequency|frequenz|nu|ν",
    "n": r"n|nr|n_?t|eta|index(ofrefraction)?|ior|"
    r"ri|refr?(active)?(index|ind)|ref\.?index|indexn|brechungsindex|"
    r"indice(der[eé]fraction)?|[ií]ndice(derefracci[oó]n)?|indicedirifrazione",
    "k": r"k|ni|k_?t|kappa|κ|ext(inction)?\.?(coeff?(icient)?\.?)?|"
    r"extinktionskoeffizient|absorptionindex|coefficientd.?extinction|"
    r"coeficientedeextinci[oó]n|coefficientediestinzione",
    "eps1": r"(e|eps|epsilon|ε|er|die)_?(1|₁|r|')",
    "eps2": r"(e|eps|epsilon|ε|die)_?(2|₂|i|''|\")",
    "delta": r"delta|δ",
    "beta": r"beta|β",
}
_BARE_UNIT = re.compile(
    r"\b(wavelength|lambda|λ|energy|wavenumber|frequency)\s+(nm|[uµμ]m|[mk]?ev|cm-1|thz|hz)\b",
    re.IGNORECASE,
)
_SYMBOL = re.compile(r"^(?:vacuum|in vacuo)\s+|[\s,]+(?:[nkeκλ]|λ_?0|lambda)\s*$", re.IGNORECASE)
"""Words around a name: what is meant by it, or its symbol."""
_INDEX = r"n|nk|index|ior|ri|(complex)?refractive_?index|(complex)?index_?of_?refraction"
_EPSILON = r"e|eps|epsilon|ε|(relative)?permittivity|die|dielectric_?(constant|function)"
_OF = r"(part)?(of)?(the)?_?\(?"
_PART = re.compile(
    rf"(?:(?P<before>re|real|im|imag|imaginary){_OF})?(?:(?P<n>{_INDEX})|{_EPSILON})\)?"
    r"(?(before)|[_,]?\(?(?P<behind>re|real|im|imag|imaginary)(part)?\)?)",
    re.IGNORECASE,
)
"""Real and imaginary parts of the index or the permittivity."""
_BRACKETS = str.maketrans("[]{}", "()()")
_ROLE = {role: re.compile(names, re.IGNORECASE) for role, names in _NAMES.items()}


def role_of(name: str) -> tuple[str, str | None]:
    """Tell what a column of this name holds, and the unit that the name carries.

    Returns
    -------
    tuple
        One of `ROLES`, "-" where nothing is known; and a unit or None.
    """
    name = name.strip().lstrip("\"'#;%*:").rstrip("#;%*:").strip()
    if not re.search(r"[εe](ps\w*)?['\"]+$", name, re.IGNORECASE):  # two strokes are a part
        name = name.rstrip("\"'").strip()
    if name.casefold() == "wl":  # so refractiveindex.info calls its columns, which are in um
        return "wavelength", "um"
    bare = unit_spelled(name)
    if bare is not None and name.lower() != "a":
        return UNITS[bare].kind, bare
    unit = None
    found = _UNIT.search(name)
    if found is not None:
        unit = unit_spelled(found[1])
        if unit is not None:
            name = name[: found.start()]
    stem = re.sub(r"\s+", "", re.sub(r"[\(\[\{][^\(\)\[\]\{\}]*[\)\]\}]\s*$", "", name))
    texts = (stem, re.sub(r"\s+", "", name), re.sub(r"\s+", "", _SYMBOL.sub("", name)))
    part = _PART.fullmatch(texts[1].translate(_BRACKETS))
    if part is not None:
        is_real = (part["before"] or part["behind"]).lower().startswith("re")
        return (("k", "n") if part["n"] else ("eps2", "eps1"))[is_real], unit
    for role, pattern in _ROLE.items():
        for text in texts:
            if pattern.fullmatch(text):
                # k in 1/cm is a wavenumber or an absorption coefficient, and no k.
                return (UNITS[unit].kind if unit else role), unit
    if unit is not None:
        return UNITS[unit].kind, unit
    return "-", None


def columns_named(
    header: Sequence[str], layout: Layout, width: int, notes: Notes
) -> tuple[tuple[str, ...], tuple[str | None, ...]] | None:
    """Find the names of columns in the lines above them.

    Returns
    -------
    tuple
        A role and a unit a column; None where no line names an abscissa.

    Raises
    ------
    Undecided
        If a line names an abscissa, and none of the others is called as n and k are, two are called
        alike, or they are fewer or more than the numbers.
    """
    doubtful: list[str] | None = None
    for line in reversed(header[-12:]):
        for cells in sorted(_cells(line, layout), key=lambda way: len(way) != width):
            if len(cells) < 2:
                continue
            roles = [role_of(cell) for cell in cells]
            kinds = [kind for kind, _ in roles]
            if any(_is_called(cell) for cell in cells):  # thickness (nm) is no wavelength then
                kinds = [
                    "-" if kind in ABSCISSAE and not _is_called(cell) else kind
                    for cell, kind in zip(cells, kinds, strict=True)
                ]
            others = [kind for kind in kinds if kind not in (*ABSCISSAE, "-")]
            if not set(ABSCISSAE).intersection(kinds):
                continue
            is_whole = len(cells) >= width and set(kinds[width:]) <= {"-"}
            if others and is_whole and len(set(others)) == len(others):
                unused = [cell for cell, kind in zip(cells, kinds, strict=True) if kind == "-"]
                if any(unused) and notes.choices.columns is None:
                    notes.warn(f"not used: {', '.join(cell[:40] for cell in unused if cell)}")
                return tuple(kinds[:width]), tuple(unit for _, unit in roles[:width])
            is_named = not any(layout.number(cell) is not None for cell in cells if cell)
            if doubtful is None and is_named and (others or len(cells) == width):
                doubtful = cells
    if doubtful is not None and notes.choices.columns is None:
        called = ", ".join(cell[:40] for cell in doubtful[:12])
        raise Undecided(
            "columns",
            f"what the {width} columns hold: a line calls them {called}; say it as wavelength,n,k or "
            "energy,eps1,eps2 with - for a column that is not used",
        )
    return None


def _is_called(cell: str) -> bool:
    """Whether a name is that of an abscissa, or its unit alone, and not of something in that unit."""
    name = cell.strip("\"'#;%*: ()[]{}")
    found = _UNIT.search(name)
    stem = name[: found.start()] if found is not None and unit_spelled(found[1]) else name
    return role_of(stem)[0] in ABSCISSAE


def _cells(line: str, layout: Layout) -> list[list[str]]:
    """Ways to part a line of names: as the rows are, by wide gaps, and by any blanks."""
    comment = COMMENT.match(line)
    if comment is not None and line[comment.end() - 1] not in "'\"":
        line = line[comment.end() :]
    joined = re.sub(r"\s+(?=[\(\[\{])", "", line.strip())
    joined = _BARE_UNIT.sub(r"\1_\2", joined)
    ways = [re.split(r"\t+|\s{2,}", line.strip()), joined.split()]
    ways += [[cell.strip() for cell in line.split(",")], [cell.strip() for cell in line.split(";")]]
    # A column of numbers of rows, which programs of statistics write first, has an empty name.
    return [layout.cells(line), *([cell for cell in way if cell] for way in ways)]


def by_hand(columns: Sequence[str], width: int) -> tuple[str, ...]:
    """Check what was said of the columns.

    Raises
    ------
    NotAllowed
        If a word is none of `ROLES` or of a file's columns, or one is there twice.
    """
    given = tuple(columns)
    allowed = f"comma-separated words of {', '.join(ROLES)}, one a column, with an abscissa"
    used = [word for word in given if word != "-"]
    wrong = (
        any(word not in ROLES for word in given)
        or len(set(used)) < len(used)
        or sum(word in ABSCISSAE for word in given) != 1
        or not {"n", "k", "eps1", "delta"}.intersection(given)
    )
    if wrong:
        raise NotAllowed("columns", ",".join(given), allowed)
    if len(given) > width:
        what = f"at most {width} words: the rows have {width} numbers"
        raise NotAllowed("columns", ",".join(given), what)
    return given + ("-",) * (width - len(given))


def by_number(table: Array, notes: Notes) -> tuple[str, ...]:
    """Tell what columns without names hold.

    Raises
    ------
    Undecided
        If there are too many.
    """
    width = table.shape[1]
    if width == 2:
        columns = ("wavelength", "n")
        why = "two columns without names: an abscissa and n"
        notes.assume("columns", ",".join(columns), why)
        return columns
    if width == 3:
        second = table[:, 1]
        second = second[np.isfinite(second) & (second > -900.0)]
        negative = float(np.mean(second < 0.0)) if second.size else 0.0
        if negative > 0.2:
            columns3 = ("wavelength", "eps1", "eps2")
            why = f"the second of three columns is negative in {negative:.0%} of the rows, as n is not"
            notes.assume("columns", ",".join(columns3), why, ["wavelength,n,k"])
        else:
            columns3 = ("wavelength", "n", "k")
            why = "three columns without names: an abscissa, n and k"
            notes.assume("columns", ",".join(columns3), why, ["wavelength,eps1,eps2"])
        return columns3
    raise Undecided(
        "columns",
        f"what the {width} columns hold: no line names them; say it as wavelength,n,k or "
        "energy,eps1,eps2 with - for a column that is not used",
    )


def unit_in(header: Sequence[str]) -> list[str]:
    """Units that the lines above a table name."""
    return units_named("\n".join(header[-40:])[:8000])
