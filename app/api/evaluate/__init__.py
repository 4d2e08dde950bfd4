"""`POST /evaluate`: up to a million values of any models, media and quantities in one call."""

from app.api.evaluate.route import router

__all__ = ["router"]
