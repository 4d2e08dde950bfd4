"""The HTTP API: one router a noun, over the optics core."""
