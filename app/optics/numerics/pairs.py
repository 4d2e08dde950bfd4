"""Complex numbers as pairs of their real and imaginary parts, each one number or many.

NumPy evaluates functions of complex arrays ten to twenty times slower than of real ones, and much of
what is complex in principle is real in fact. A part that is the float 0.0 is known to be 0
everywhere, and no operation is spent on it.
"""

from app.optics.parameters import Number

Pair = tuple[Number, Number]
"""Real and imaginary part."""

ONE: Pair = (1.0, 0.0)


def is_zero(part: Number) -> bool:
    """Whether a part is known to be 0 everywhere."""
    return isinstance(part, float) and part == 0.0


def plus(x: Pair, y: Pair) -> Pair:
    """Add."""
    return _sum(x[0], y[0]), _sum(x[1], y[1])


def minus(x: Pair, y: Pair) -> Pair:
    """Subtract."""
    return _difference(x[0], y[0]), _difference(x[1], y[1])


def times(x: Pair, y: Pair) -> Pair:
    """Multiply."""
    return (
        _difference(product(x[0], y[0]), product(x[1], y[1])),
        _sum(product(x[0], y[1]), product(x[1], y[0])),
    )


def plus_i(x: Pair, y: Pair) -> Pair:
    """x + i y."""
    return _difference(x[0], y[1]), _sum(x[1], y[0])


def minus_i(x: Pair, y: Pair) -> Pair:
    """x - i y."""
    return _sum(x[0], y[1]), _difference(x[1], y[0])


def conjugate(x: Pair) -> Pair:
    """Change the sign of the imaginary part."""
    return x[0], _difference(0.0, x[1])


def scaled(x: Pair, factor: Number) -> Pair:
    """Multiply by a real number."""
    return product(x[0], factor), product(x[1], factor)


def square_of(x: Pair) -> Number:
    """Square of the modulus."""
    return _sum(product(x[0], x[0]), product(x[1], x[1]))


def over(x: Pair, y: Pair) -> Pair:
    """Divide, where y is not 0."""
    if is_zero(y[1]):
        return x[0] / y[0], x[1] / y[0]
    return scaled(times(x, conjugate(y)), 1.0 / square_of(y))


def product(x: Number, y: Number) -> Number:
    """Multiply real numbers, either of which may be known to be 0 or 1 everywhere."""
    if isinstance(x, float) and x in (0.0, 1.0):
        return y if x else 0.0
    if isinstance(y, float) and y in (0.0, 1.0):
        return x if y else 0.0
    return x * y


def _sum(x: Number, y: Number) -> Number:
    return y if is_zero(x) else x if is_zero(y) else x + y


def _difference(x: Number, y: Number) -> Number:
    return x if is_zero(y) else -y if is_zero(x) else x - y
