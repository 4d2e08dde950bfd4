"""The optics core: NumPy arrays in, NumPy arrays out; it knows nothing of HTTP or of materials."""
