"""Which of the kinds of content that are there suits a client (RFC 9110, section 12.5.1)."""

from collections.abc import Sequence


def accepted(header: str, offered: Sequence[str]) -> str | None:
    """Choose what an Accept header likes best, the first offered among equals; None if nothing."""
    ranges: list[tuple[int, str, float]] = []
    for part in header.lower().split(","):
        media, *parameters = (piece.strip() for piece in part.split(";"))
        quality = next((p[2:] for p in parameters if p.startswith("q=")), "1")
        try:
            weight = float(quality)
        except ValueError:
            weight = 0.0  # a malformed weight asks for nothing
        if media:
            ranges.append(
                (0 if media == "*/*" else 1 if media.endswith("/*") else 2, media, weight)
            )
    if not ranges:
        return offered[0]

    def quality_of(offer: str) -> float:
        fitting = [
            (rank, weight)
            for rank, media, weight in ranges
            if media in ("*/*", offer, f"{offer.partition('/')[0]}/*")
        ]
        return max(fitting)[1] if fitting else 0.0

    best = max(offered, key=quality_of)
    return best if quality_of(best) > 0.0 else None
