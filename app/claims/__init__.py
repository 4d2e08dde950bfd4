"""Claims of the literature and of popular code, each with the requests that measure it."""

from app.claims.claim import Claim, Figure, Part, Source, UnknownClaim, UnknownExample, Verdict
from app.claims.registry import CLAIMS, claims_of, find_claim

__all__ = [
    "CLAIMS",
    "Claim",
    "Figure",
    "Part",
    "Source",
    "UnknownClaim",
    "UnknownExample",
    "Verdict",
    "claims_of",
    "find_claim",
]
