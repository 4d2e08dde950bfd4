"""Many values at once: rows that ask for any model, quantity and medium, evaluated together."""
