"""The HTTP API: one router a noun, over the optics core."""

PREFIX = "/api/v1"
"""What the path of every route of the API begins with."""
