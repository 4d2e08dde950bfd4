"""Models as short functions of shading languages, translated from the Python that defines them."""
