"""One file a model; each exposes `MODEL`, and `app.optics.registry` finds them."""
