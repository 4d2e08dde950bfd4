"""Claims about fits of the hemispherical albedo, made from those that the fits themselves list."""

from collections.abc import Iterator

from app.claims import sources
from app.claims.claim import Claim, Figure, Part, Source
from app.claims.readings import largest_ratio, modulus
from app.optics.albedo import FITS, Fit
from app.optics.albedo import Claim as FitClaim

_STEPS = 201
"""Of a relative error, whose largest lies on an edge or at a smooth maximum."""


def _source(fit: Fit, claim: FitClaim) -> Source:
    if "Mitsuba" in claim.source:
        return sources.MITSUBA
    return sources.KULLA_CONTY if fit.id.startswith("kulla") else sources.DEON


def _largest(fit: Fit, claim: FitClaim) -> Figure:
    over = claim.measured_over
    (low, high), (k_low, k_high) = over.eta, over.kappa
    kind = "relative error" if claim.relative else "error"
    says = f"largest {kind} of the albedo, {over.words}"
    if claim.relative:
        ends = f"minimum={low!r}&maximum={high!r}&steps={_STEPS}&scale=log"
        error = f"curves[kind=fit,id={fit.id}].error"
        exact = f"curves[kind=exact,quantity={fit.quantity}].values"
        request = f"/albedo/sweep?over=eta&{ends}&fits={fit.id}"
        return Figure("largest", says, request, largest_ratio(error, exact, "values"))
    # The search does not depend on the grid, whose points are not asked for.
    ends = f"n_minimum={low!r}&n_maximum={high!r}&n_steps=2"
    ends += f"&k_minimum={k_low!r}&k_maximum={k_high or 1.0!r}&k_steps=2"
    part = "largest_in_domain" if over in fit.domains or not k_high else "largest"
    return Figure("largest", says, f"/albedo/map?{ends}&fit={fit.id}", modulus(f"{part}.value"))


def _found(fit: Fit, claim: FitClaim) -> str:
    unit = "relative" if claim.relative else "absolute"
    found = "{largest:.3g}" + f" {unit}. {fit.note}"
    if claim.over is None:
        return found
    return found + " A(1) = 0 makes every offset infinite there: measured from 1 % off eta = 1."


def _offered(claim: FitClaim) -> str:
    return claim.source if "without a bound" in claim.source else f"for {claim.domain.words}"


def _promise(claim: FitClaim) -> str:
    if claim.claimed is None:
        return "a fit without a figure"
    size = f"{100.0 * claim.claimed:g} %" if claim.relative else f"{claim.claimed:g}"
    return f"within {size} for {claim.domain.words}"


def _claims(fit: Fit) -> Iterator[Claim]:
    for number, claim in enumerate(fit.claims):
        published = claim.claimed is not None
        unit = "relative" if claim.relative else "absolute"
        if not published and not fit.id.startswith(
            ("kulla_conty_2017", "deon_2019_log", "large_k")
        ):
            continue
        if not published and number > 0:
            continue
        says = (
            f"The largest error is {claim.claimed:g} ({unit}) for {claim.domain.words}."
            if published
            else f"Offered without a figure: {_offered(claim)}."
        )
        yield Claim(
            id=f"{fit.id.replace('_', '-')}-{number + 1}" if number else fit.id.replace("_", "-"),
            title=f"{fit.title}: {_promise(claim)}",
            claimed=says,
            source=_source(fit, claim),
            where=claim.source,
            domain=claim.measured_over.words,
            figures=(_largest(fit, claim),),
            # 9.51 % measured is the 9.5 % that was claimed: claims have one or two digits.
            parts=(
                (
                    Part(
                        says="within what was claimed",
                        figure="largest",
                        at_most=1.005 * claim.claimed,
                    ),
                )
                if claim.claimed is not None
                else ()
            ),
            found=_found(fit, claim),
        )


CLAIMS = tuple(claim for fit in FITS.values() for claim in _claims(fit))
