"""What engines call the reflectance of clear media, and their dispersion: one object a knob.

`conversions` reads each into what it says of an interface; this package tells what to type, with the
range, the default and what the engine clamps.
"""
