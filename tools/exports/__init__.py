"""Every material of the catalog, exported to every target, and read by the target's own library."""
