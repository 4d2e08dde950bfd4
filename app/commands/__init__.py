"""The commands of `fresnel-explorer` beside `serve`, one a module."""
