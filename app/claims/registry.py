"""Every claim of the modules in `app.claims.topics`; adding a file there adds its claims."""

import importlib
import pkgutil
from collections.abc import Mapping

from app.claims import topics
from app.claims.claim import Claim, UnknownClaim, UnknownExample, by_id


def _all() -> Mapping[str, Claim]:
    names = sorted(info.name for info in pkgutil.iter_modules(topics.__path__))
    modules = [importlib.import_module(f"{topics.__name__}.{name}") for name in names]
    return by_id(claim for module in modules for claim in module.CLAIMS)


CLAIMS = _all()


def find_claim(claim_id: str, parameter: str = "claim_id") -> Claim:
    """Return the claim of that id.

    Raises
    ------
    UnknownClaim
        If there is none, naming the nearest ids.
    """
    try:
        return CLAIMS[claim_id]
    except KeyError:
        raise UnknownClaim(parameter, claim_id, CLAIMS) from None


def claims_of(example: str | None) -> list[Claim]:
    """Return the claims that a named example shows, all without one.

    Raises
    ------
    UnknownExample
        If no claim names it, naming the nearest that are.
    """
    if example is None:
        return list(CLAIMS.values())
    found = [claim for claim in CLAIMS.values() if claim.example == example]
    if not found:
        known = {claim.example for claim in CLAIMS.values() if claim.example}
        raise UnknownExample("example", example, known)
    return found
