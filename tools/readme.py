"""Rewrite the parts of README.md that the code itself knows best: run it by `make readme`.

Each part stands between `<!-- name:begin -->` and `<!-- name:end -->`; a test compares them with what
this module makes, so that the README cannot fall behind the code.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path

from app.answers.atlas import which_formula
from app.answers.atlas_shares import KindShare
from app.atlas.pages import Kind
from app.atlas.published import Metric
from app.main import create_app
from app.optics.registry import Measured, Model, default_registry
from app.settings import Settings

README = Path(__file__).resolve().parent.parent / "README.md"


def table(header: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """Lay out a Markdown table; a bar inside a cell would end it."""
    lines = [header, ["---"] * len(header), *rows]
    return "\n".join(f"| {' | '.join(c.replace('|', '&#124;') for c in line)} |" for line in lines)


def kinds(model: Model) -> str:
    """Say what the model is made for."""
    return "both" if len(model.applies_to) > 1 else model.applies_to[0]


def exact_forms() -> str:
    """List the exact solution and the forms equal to it."""
    models = [model for model in default_registry().values() if model.kind == "exact"]
    rows = [(f"`{m.id}`", m.title, kinds(m), m.reference) for m in models]
    return table(("id", "name", "for", "source"), rows)


def error_at(measured: Measured) -> str:
    """Write the largest error at one interface: `0.0357 at 1.5`."""
    index = f"{measured.n_t:g}" + (f" + {measured.k_t:g}i" if measured.k_t else "")
    side = "" if measured.n_i == 1.0 else f"{measured.n_i:g} → "
    return f"{measured.max_abs:g} at {side}{index}"


def approximations() -> str:
    """List the approximations with what they are wrong by, as far as a test measures it."""
    models = [model for model in default_registry().values() if model.kind == "approximation"]
    rows = [
        (
            f"`{m.id}`",
            m.title,
            kinds(m),
            ", ".join(f"`{parameter.name}`" for parameter in m.parameters),
            "; ".join(error_at(measured) for measured in m.measured),
        )
        for m in models
    ]
    return table(("id", "name", "for", "parameters", "largest error, measured"), rows)


def atlas() -> str:
    """Count the materials of the atlas at which the error of each approximation is small."""
    columns: tuple[tuple[str, Kind, Metric, float], ...] = (
        ("clear, 1 %", "clear", "max_abs", 0.01),
        ("clear, 5 %", "clear", "max_abs", 0.05),
        ("metals, 1 %", "metal", "max_abs", 0.01),
        ("metals, 5 %", "metal", "max_abs", 0.05),
        ("metals, ΔE 1", "metal", "delta_e", 1.0),
    )
    registry = default_registry()
    shares = [
        {
            share.model: one
            for share in which_formula(
                registry, registry["schlick"], metric=metric, within=within, kind=kind
            ).models
            for one in share.kinds
        }
        for _, kind, metric, within in columns
    ]
    rows = [
        (
            f"`{m.id}`",
            *(f"{o[m.id].within:,} of {o[m.id].materials:,}" if m.id in o else "" for o in shares),
        )
        for m in registry.values()
        if m.kind == "approximation" and not m.trap
    ]
    return table(("id", *(title for title, *_ in columns)), rows)


def _counted(share: KindShare | None) -> str:
    return "" if share is None else f"{share.within:,} of {share.materials:,}"


def routes() -> str:
    """List every route of the API with its summary."""
    paths = create_app().openapi()["paths"]
    rows = [
        (f"`{method.upper()} {path}`", operation["summary"])
        for path, operations in paths.items()
        for method, operation in operations.items()
    ]
    return table(("route", "what it answers"), rows)


def settings() -> str:
    """List the environment variables with their defaults."""
    prefix = Settings.model_config.get("env_prefix", "")
    rows = [
        (
            f"`{prefix}{name.upper()}`",
            "found beside the code" if field.default_factory else f"`{field.default}`",
            field.description or "",
        )
        for name, field in Settings.model_fields.items()
    ]
    return table(("variable", "default", "meaning"), rows)


PARTS = {
    "routes": routes,
    "exact-forms": exact_forms,
    "approximations": approximations,
    "atlas": atlas,
    "settings": settings,
}


def refreshed(text: str) -> str:
    """Return `text` with every generated part made anew.

    Raises
    ------
    ValueError
        If a part's markers are missing.
    """
    for name, make in PARTS.items():
        begin, end = f"<!-- {name}:begin -->", f"<!-- {name}:end -->"
        if text.count(begin) != 1 or text.count(end) != 1:
            raise ValueError(f"README.md needs the markers of {name} once")
        before, _, rest = text.partition(begin)
        text = f"{before}{begin}\n{make()}\n{end}{rest.partition(end)[2]}"
    return text


def main() -> None:
    """Rewrite README.md in place."""
    README.write_text(refreshed(README.read_text("utf-8")), "utf-8")


if __name__ == "__main__":
    main()
