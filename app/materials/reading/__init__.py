"""Files of n and k as people have them: one module a format; see `app.materials.reading.read`."""
