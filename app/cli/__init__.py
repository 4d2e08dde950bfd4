"""The commands of `fresnel-explorer` beside `serve`."""
