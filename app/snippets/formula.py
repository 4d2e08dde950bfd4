"""Read a model's function as a formula of real numbers: the part of Python that every language has.

A model's function is written once, in NumPy. Where it is closed, that is made of arithmetic, square
roots and the like, its syntax tree is all that another language needs. What is read here:

- `incidence.cos` is the argument mu, `incidence.sin` its square root, `interface.eta` an argument eta;
- `np.where(c, a, b)` is a choice, `x**2` a product, `np.asarray(x)` and `float(x)` nothing but x;
- `F82(interface)` is an argument F82, as it takes an evaluation of its own;
- another function of ours that is called comes along, or is put in place if it is one expression or
  returns several values;
- constants of the module become constants of the function, `with np.errstate` is passed over.

Anything else is refused, by a message that says what.
"""

from __future__ import annotations

import ast
import inspect
import io
import math
import re
import textwrap
import tokenize
from collections.abc import Callable, Iterator, Mapping
from copy import deepcopy
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

MU = "mu"
INTERFACE = ("n_i", "n_t", "k_t", "eta", "kappa", "F0", "F82")
"""What a formula may ask of the interface, in the order in which arguments are listed."""

FUNCTIONS = {
    "sqrt": "sqrt",
    "abs": "abs",
    "exp": "exp",
    "exp2": "exp2",
    "log": "log",
    "sin": "sin",
    "cos": "cos",
    "tan": "tan",
    "arcsin": "asin",
    "arccos": "acos",
    "arctan": "atan",
    "arctan2": "atan2",
    "minimum": "min",
    "maximum": "max",
    "power": "pow",
    "clip": "clamp",
}
"""NumPy's functions by the name that shading languages give them."""

_PLAIN = (ast.Name, ast.Constant)


class Untranslatable(ValueError):
    """A function that is no closed formula of real numbers; the message says why."""


@dataclass(frozen=True, slots=True)
class Step:
    """A named intermediate result, with the comment that stands above it."""

    name: str
    value: ast.expr
    comment: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Formula:
    """A function of real numbers: arguments, intermediate results, the value returned.

    Expressions hold names, numbers, `+ - * /`, comparisons, `and`/`or`/`not`, choices (`ast.IfExp`)
    and calls of `FUNCTIONS` or of a helper, and nothing else.
    """

    name: str
    arguments: tuple[str, ...]
    constants: Mapping[str, float]
    steps: tuple[Step, ...]
    value: ast.expr
    comment: tuple[str, ...]
    helpers: tuple[Formula, ...]

    def everything(self) -> Iterator[Formula]:
        """Yield the helpers, each before what calls it and once, then the formula itself."""
        seen: set[str] = set()
        for formula in (f for helper in self.helpers for f in helper.everything()):
            if formula.name not in seen:
                seen.add(formula.name)
                yield formula
        yield self


@lru_cache(maxsize=512)
def read(function: Callable[..., Any], name: str | None = None) -> Formula:
    """Read `function` as a formula, named `name` or else as the function is.

    Raises
    ------
    Untranslatable
        If it is not made of what is listed above.
    """
    return _Reader(function).formula(name or str(getattr(function, "__name__", "formula")))


def square() -> Formula:
    """Make the helper with which `x**2` is written where x is not a mere name."""
    product = ast.BinOp(ast.Name("x"), ast.Mult(), ast.Name("x"))
    return Formula("sqr", ("x",), {}, (), product, (), ())


_OF_SEVERAL = re.compile(r"^( +)(\w+(?:, \w+)+) = (\w+)\(interface, incidence\)$", re.MULTILINE)


def _spliced(source: str, function: Callable[..., Any]) -> str:
    """Put the lines of a function of ours that returns several values in place of its call.

    What they are assigned to is what they are called there, or stands for what is returned.
    """

    def lines(found: re.Match[str]) -> str:
        indent, targets, name = found.groups()
        called = getattr(function, "__globals__", {}).get(name)
        if not inspect.isfunction(called):
            return found[0]
        text = textwrap.dedent(inspect.getsource(called))
        (definition,) = ast.parse(text).body
        match definition:
            case ast.FunctionDef(body=[ast.Expr() as words, *_, ast.Return(ast.Tuple()) as last]):
                inner = text.splitlines()[words.end_lineno or 0 : last.lineno - 1]
                returned = ", ".join(map(ast.unparse, last.value.elts))  # type: ignore[union-attr]
                dedented = textwrap.dedent("\n".join(inner)).splitlines()
                return "\n".join(indent + x for x in [*dedented, f"{targets} = {returned}"])
        return found[0]

    return _OF_SEVERAL.sub(lines, source)


class _Reader(ast.NodeTransformer):
    """Turns the expressions of one function into those of a `Formula`, noting what they need."""

    def __init__(self, function: Callable[..., Any]) -> None:
        try:
            source = _spliced(textwrap.dedent(inspect.getsource(function)), function)
            (definition,) = ast.parse(source).body
        except (OSError, TypeError, SyntaxError):
            raise Untranslatable("its source cannot be read") from None
        if not isinstance(definition, ast.FunctionDef):
            raise Untranslatable("it is not defined by `def`")
        self._definition = definition
        self._comments = _comments(source)
        self._globals: Mapping[str, Any] = getattr(function, "__globals__", {})
        self._own = [argument.arg for argument in definition.args.args]
        self._asked: set[str] = set()
        self._constants: dict[str, float] = {}
        self._helpers: dict[str, Formula] = {}
        self._locals: set[str] = set()
        self._passed: set[str] = set()

    def formula(self, name: str) -> Formula:
        steps: list[Step] = []
        body = self._definition.body[ast.get_docstring(self._definition) is not None :]
        body = [inner for statement in body for inner in _unwrapped(statement)]
        value: ast.expr | None = None
        comment: tuple[str, ...] = ()
        for statement in body:
            if value is not None:
                raise self._refusal(statement, "something after its return")
            comment = self._comments_above(statement)
            match statement:
                case ast.Return(value=ast.expr() as result):
                    value = self.visit(result)
                case ast.Assign(targets=[ast.Name(id=target)], value=result):
                    steps += self._step(target, result, comment)
                case ast.Assign(
                    targets=[ast.Tuple(elts=targets)], value=ast.Tuple(elts=results)
                ) if len(targets) == len(results):
                    for target_, result in zip(targets, results, strict=True):
                        if not isinstance(target_, ast.Name):
                            raise self._refusal(
                                statement, "an assignment to something other than names"
                            )
                        steps += self._step(target_.id, result, comment)
                        comment = ()
                case _:
                    raise self._refusal(statement, "more than assignments and a return")
        if value is None:
            raise Untranslatable("it returns nothing")
        own = [a for a in self._own if a not in ("interface", "incidence", MU, *INTERFACE)]
        asked = self._asked | set(self._own)
        arguments = [q for q in (MU, *INTERFACE) if q in asked and q not in self._locals] + own
        helpers = tuple(self._helpers.values())
        return Formula(
            name, tuple(arguments), self._constants, tuple(steps), value, comment, helpers
        )

    def _step(self, target: str, result: ast.expr, comment: tuple[str, ...]) -> list[Step]:
        value = self.visit(result)
        if isinstance(value, ast.Name) and value.id == target:
            self._passed.add(target)  # eta = interface.eta
            return []
        if target in self._locals or target in self._own or target in self._asked:
            raise Untranslatable(f"it gives {target} a second meaning")
        self._locals.add(target)
        return [Step(target, value, comment)]

    def _comments_above(self, statement: ast.stmt) -> tuple[str, ...]:
        found: list[str] = []
        line = statement.lineno - 1
        while line in self._comments:
            found.insert(0, self._comments[line])
            line -= 1
        return tuple(found)

    def _quantity(self, name: str) -> ast.Name:
        if name in self._locals or name in self._own:
            raise Untranslatable(f"it gives {name} a second meaning")
        self._asked.add(name)
        return ast.Name(name)

    def _sine_squared(self) -> ast.expr:
        # 1 - mu^2 would have few digits near normal incidence.
        mu, one = self._quantity(MU), ast.Constant(1.0)
        sides = ast.BinOp(one, ast.Sub(), mu), ast.BinOp(one, ast.Add(), mu)
        return ast.BinOp(sides[0], ast.Mult(), sides[1])

    def _refusal(self, node: ast.AST, what: str) -> Untranslatable:
        return Untranslatable(f"it holds {what}: {ast.unparse(node).splitlines()[0]}")

    def generic_visit(self, node: ast.AST) -> ast.AST:
        raise self._refusal(node, "what shading languages lack")

    def visit_Attribute(self, node: ast.Attribute) -> ast.expr:
        match node:
            case ast.Attribute(value=ast.Name(id="interface"), attr=name) if name in INTERFACE:
                return self._quantity(name)
            case ast.Attribute(value=ast.Name(id="incidence"), attr="cos"):
                return self._quantity(MU)
            case ast.Attribute(value=ast.Name(id="incidence"), attr="sin"):
                return ast.Call(ast.Name("sqrt"), [self._sine_squared()], [])
            case ast.Attribute(value=ast.Name(id="incidence"), attr="theta_i"):
                return ast.Call(ast.Name("acos"), [self._quantity(MU)], [])
            case ast.Attribute(value=ast.Name(id="np"), attr="pi"):
                return ast.Constant(math.pi)
            case ast.Attribute(value=ast.Name(id="np"), attr="nan"):
                return ast.Constant(math.nan)
            case _:
                raise self._refusal(node, "what shading languages lack")

    def visit_Name(self, node: ast.Name) -> ast.expr:
        if node.id in {*self._own, *self._locals, *self._passed}:
            return ast.Name(node.id)
        value = self._globals.get(node.id)
        if not isinstance(value, int | float):
            raise self._refusal(node, "a name that is no number")
        self._constants[node.id] = float(value)
        return ast.Name(node.id)

    def visit_Constant(self, node: ast.Constant) -> ast.expr:
        if isinstance(node.value, bool) or not isinstance(node.value, int | float):
            raise self._refusal(node, "something other than real numbers")
        return ast.Constant(float(node.value))

    def visit_UnaryOp(self, node: ast.UnaryOp) -> ast.expr:
        operand = self.visit(node.operand)
        match node.op:
            case ast.USub():
                return ast.UnaryOp(ast.USub(), operand)
            case ast.Invert() | ast.Not():
                return ast.UnaryOp(ast.Not(), operand)
            case _:
                raise self._refusal(node, "an operator that shading languages lack")

    def visit_BinOp(self, node: ast.BinOp) -> ast.expr:
        match node:
            case ast.BinOp(op=ast.Pow(), right=ast.Constant(value=2 | 2.0), left=base):
                return self._squared(base)
            case ast.BinOp(op=ast.Add() | ast.Sub() | ast.Mult() | ast.Div() as op):
                return ast.BinOp(self.visit(node.left), op, self.visit(node.right))
            case ast.BinOp(op=ast.Pow()):
                both = [self.visit(node.left), self.visit(node.right)]
                return ast.Call(ast.Name("pow"), both, [])
            case ast.BinOp(op=ast.BitAnd() | ast.BitOr() as op):
                both = [self.visit(node.left), self.visit(node.right)]
                return ast.BoolOp(ast.And() if isinstance(op, ast.BitAnd) else ast.Or(), both)
            case _:
                raise self._refusal(node, "an operator that shading languages lack")

    def _squared(self, base: ast.expr) -> ast.expr:
        match base:
            case ast.Attribute(value=ast.Name(id="incidence"), attr="sin"):
                return self._sine_squared()
            case _:
                value = self.visit(base)
                if isinstance(value, ast.Name):
                    return ast.BinOp(value, ast.Mult(), value)
                self._helpers["sqr"] = square()
                return ast.Call(ast.Name("sqr"), [value], [])

    def visit_Compare(self, node: ast.Compare) -> ast.expr:
        if len(node.ops) != 1:
            raise self._refusal(node, "a chain of comparisons")
        return ast.Compare(self.visit(node.left), node.ops, [self.visit(node.comparators[0])])

    def visit_Call(self, node: ast.Call) -> ast.expr:
        match node:
            case (
                ast.Call(func=ast.Attribute(value=ast.Name(id="np"), attr="asarray"))
                | ast.Call(func=ast.Name(id="float"))
            ):
                inner: ast.expr = self.visit(node.args[0])
                return inner
            case ast.Call(
                func=ast.Attribute(value=ast.Name(id="np"), attr="where"), args=[test, a, b]
            ):
                return ast.IfExp(self.visit(test), self.visit(a), self.visit(b))
            case ast.Call(func=ast.Attribute(value=ast.Name(id="np" | "math"), attr=name)) if (
                name in FUNCTIONS and not node.keywords
            ):
                return ast.Call(ast.Name(FUNCTIONS[name]), [self.visit(a) for a in node.args], [])
            case ast.Call(func=ast.Name(id="F82"), args=[ast.Name(id="interface")]):
                return self._quantity("F82")
            case ast.Call(func=ast.Name(id=name)) if not node.keywords:
                function = self._globals.get(name)
                if not inspect.isfunction(function):
                    raise self._refusal(node, "a call of something other than a function")
                return self._call(function, node.args)
            case _:
                raise self._refusal(node, "what shading languages lack")

    def _call(self, function: Callable[..., Any], arguments: list[ast.expr]) -> ast.expr:
        """Call a helper, or put its expression in place where that repeats no work."""
        helper = read(function)
        values: dict[str, ast.expr] = {}
        for name, argument in zip(inspect.signature(function).parameters, arguments, strict=True):
            if name not in ("interface", "incidence"):
                values[name] = self.visit(argument)
        # The rest is what the helper reads off the interface and the incidence, passed on as it is.
        values |= {name: self._quantity(name) for name in helper.arguments if name not in values}
        once = all(isinstance(value, _PLAIN) for value in values.values())
        if once and not helper.steps:
            self._constants |= helper.constants
            self._helpers |= {inner.name: inner for inner in helper.helpers}
            return Replace(values).put_into(helper.value)
        self._helpers[helper.name] = helper
        return ast.Call(ast.Name(helper.name), [values[name] for name in helper.arguments], [])


class Replace(ast.NodeTransformer):
    """Puts expressions in the place of names."""

    def __init__(self, values: Mapping[str, ast.expr]) -> None:
        self._values = values

    def put_into(self, expression: ast.expr) -> ast.expr:
        """Return the expression with that done."""
        replaced: ast.expr = self.visit(deepcopy(expression))
        return replaced

    def visit_Name(self, node: ast.Name) -> ast.expr:  # noqa: D102
        return self._values.get(node.id, node)


def _unwrapped(statement: ast.stmt) -> list[ast.stmt]:
    """Take what stands in `with np.errstate(...)` out of it: other languages do not warn."""
    match statement:
        case ast.With(items=[ast.withitem(context_expr=call)], body=body) if ast.unparse(
            call
        ).startswith("np.errstate("):
            return body
        case _:
            return [statement]


def _comments(source: str) -> dict[int, str]:
    """Comments that have a line of their own, by line."""
    lines = source.splitlines()
    return {
        token.start[0]: token.string.lstrip("# ")
        for token in tokenize.generate_tokens(io.StringIO(source).readline)
        if token.type == tokenize.COMMENT and lines[token.start[0] - 1].lstrip().startswith("#")
    }
