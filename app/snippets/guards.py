"""Keep a formula defined at the ends of its arguments and just beyond them, where shaders go.

A renderer's cosine is a dot product and may be 1.0000001 or -1e-8; what NumPy answers with NaN there a
GPU may answer with anything. So the cosine is cut to what it can be, and roots and arc sines are taken
of nothing beyond their ends. Inside the domain nothing changes.
"""

import ast
from copy import deepcopy
from dataclasses import replace

from app.snippets.formula import MU, Formula, Replace, Step

LEAST_COSINE = 5e-16
"""What stands in for a cosine of 0 in a formula that divides by what may vanish there. R differs from
that at 0 by less than rounding, and the squares of mu and 1/mu times any index are 32 bit floats."""

_TOLD = {
    ("sqrt", "max"): "a root of less than 0 is 0",
    ("pow", "max"): "a power of less than 0 is that of 0",
    ("asin", "min"): "an arc sine of more than 1 is that of 1",
}
"""What is said of a function whose argument is kept from its ends."""


def told(formula: Formula) -> str:
    """Say what a guarded formula does beyond the ends of its arguments; "" if it has nothing to say."""
    calls = [
        (ast.unparse(node.func), ast.unparse(node.args[0].func))
        for part in formula.everything()
        for value in (*(step.value for step in part.steps), part.value)
        for node in ast.walk(value)
        if isinstance(node, ast.Call) and node.args and isinstance(node.args[0], ast.Call)
    ]
    said = ["beyond its ends mu is cut to them"] if MU in formula.arguments else []
    said += [words for call, words in _TOLD.items() if call in calls]
    text = "; ".join(said)
    return f"{text[:1].upper()}{text[1:]}." if said else ""


def guarded(formula: Formula) -> Formula:
    """Cut mu to 0 to 1, and what roots and arc sines are taken of to what they are defined for."""
    formula = deepcopy(formula)
    helpers = tuple(_defined(helper, cosine=None) for helper in formula.helpers)
    formula = replace(formula, helpers=helpers)
    if MU not in formula.arguments:
        return _defined(formula, cosine=None)
    own = next(
        (s for s in formula.steps if isinstance(s.value, ast.Name) and s.value.id == MU), None
    )
    taken = {*formula.arguments, *(step.name for step in formula.steps)}
    name = own.name if own else next(n for n in ("c", "cosine") if n not in taken)
    cut = Step(name, _cut(formula), own.comment if own else ())
    put = Replace({MU: ast.Name(name)})
    steps = tuple(
        replace(step, value=put.put_into(step.value)) for step in formula.steps if step is not own
    )
    inside = replace(formula, steps=steps, value=put.put_into(formula.value))
    defined = _defined(inside, cosine=name)
    return replace(defined, steps=(cut, *defined.steps))


def _cut(formula: Formula) -> ast.expr:
    least = LEAST_COSINE if any(map(_divides_by_what_mu_makes_0, formula.everything())) else 0.0
    return ast.Call(ast.Name("clamp"), [ast.Name(MU), ast.Constant(least), ast.Constant(1.0)], [])


def _divides_by_what_mu_makes_0(formula: Formula) -> bool:
    depends = {MU}
    for step in formula.steps:
        if _names(step.value) & depends:
            depends.add(step.name)
    return any(
        isinstance(node, ast.BinOp)
        and isinstance(node.op, ast.Div)
        and _names(node.right) & depends
        for value in (*(step.value for step in formula.steps), formula.value)
        for node in ast.walk(value)
    )


def _names(expression: ast.expr) -> set[str]:
    return {node.id for node in ast.walk(expression) if isinstance(node, ast.Name)}


def _defined(formula: Formula, cosine: str | None) -> Formula:
    """Guard the roots, powers and arc sines of one function."""
    guard = _Guard(set() if cosine is None else {cosine})
    steps: list[Step] = []
    for step in formula.steps:
        value = guard.guarded(step.value)
        steps.append(replace(step, value=value))
        if guard.not_negative(value):
            guard.positive.add(step.name)
    return replace(formula, steps=tuple(steps), value=guard.guarded(formula.value))


class _Guard(ast.NodeTransformer):
    """Puts a bound where a function may be asked for what it is not defined for."""

    def __init__(self, cosines: set[str]) -> None:
        self.cosines = cosines
        """Names of numbers from 0 to 1."""
        self.positive = set(cosines)
        """Names of numbers that are not negative."""

    def guarded(self, expression: ast.expr) -> ast.expr:
        value: ast.expr = self.visit(expression)
        return value

    def visit_Call(self, node: ast.Call) -> ast.expr:
        name, arguments = ast.unparse(node.func), [self.guarded(a) for a in node.args]
        if name in ("sqrt", "pow") and not self.not_negative(arguments[0]):
            arguments[0] = ast.Call(ast.Name("max"), [arguments[0], ast.Constant(0.0)], [])
        if name == "asin":
            arguments[0] = ast.Call(ast.Name("min"), [arguments[0], ast.Constant(1.0)], [])
        return ast.Call(node.func, arguments, [])

    def not_negative(self, node: ast.expr) -> bool:
        """Whether an expression is a sum, product or the like of what is not negative."""
        match node:
            case ast.Constant(value=float() as value):
                return value >= 0.0
            case ast.Name(id=name):
                return name in self.positive
            case ast.BinOp(left=left, op=ast.Mult(), right=right) if _same(left, right):
                return True
            case ast.BinOp(left=left, op=ast.Add() | ast.Mult() | ast.Div(), right=right):
                return self.not_negative(left) and self.not_negative(right)
            case ast.BinOp(left=ast.Constant(value=1.0), op=ast.Sub(), right=right):
                return self._at_most_1(right)
            case ast.Call(func=ast.Name(id="sqrt" | "abs" | "sqr")):
                return True
            case ast.Call(func=ast.Name(id="clamp"), args=[_, least, _]):
                return self.not_negative(least)
            case ast.Call(func=ast.Name(id="max"), args=arguments):
                return any(map(self.not_negative, arguments))
            case _:
                return False

    def _at_most_1(self, node: ast.expr) -> bool:
        match node:
            case ast.Name(id=name):
                return name in self.cosines
            case ast.BinOp(left=left, op=ast.Mult(), right=right):
                return self._at_most_1(left) and self._at_most_1(right)
            case _:
                return False


def _same(a: ast.expr, b: ast.expr) -> bool:
    return ast.dump(a) == ast.dump(b)
