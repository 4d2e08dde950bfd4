"""Pages of refractiveindex.info as materials, by ids `rii:SHELF/BOOK/PAGE`."""
