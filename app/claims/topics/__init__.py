"""Claims by topic: every module here has a tuple `CLAIMS`."""
