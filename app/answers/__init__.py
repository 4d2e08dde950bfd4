"""Typed answers: what the API, the command, the claims and the figures say, without HTTP."""
