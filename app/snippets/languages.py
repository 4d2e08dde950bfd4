"""How each language writes a formula."""

import ast
import math
import textwrap
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from app.snippets.formula import FUNCTIONS, Formula, Step, Untranslatable

Trust = Literal["run", "compiled", "untested"]

WIDTH = 96
"""Columns that no line of a snippet exceeds unless a single name or call does."""

# What binds tighter has the larger number; choices bind least.
_CHOICE, _OR, _AND, _COMPARE, _SUM, _PRODUCT, _SIGN, _ATOM = range(8)

_OPERATORS: dict[type[ast.operator], tuple[str, int]] = {
    ast.Add: ("+", _SUM),
    ast.Sub: ("-", _SUM),
    ast.Mult: ("*", _PRODUCT),
    ast.Div: ("/", _PRODUCT),
}
_COMPARISONS: dict[type[ast.cmpop], str] = {
    ast.Lt: "<",
    ast.LtE: "<=",
    ast.Gt: ">",
    ast.GtE: ">=",
    ast.Eq: "==",
    ast.NotEq: "!=",
}


@dataclass(frozen=True, slots=True, kw_only=True)
class Language:
    """A language with C's syntax, and what the others change of it."""

    id: str
    title: str
    """Name in the API and on the page."""
    checked: Trust
    """'run' where our tests run every snippet and compare its numbers with Python's, 'untested'
    where nothing here can compile it."""
    checked_by: str
    """What runs it, or why nothing does."""
    comment: str = "//"
    """What starts a comment."""
    real: str = "float"
    truth: str = "bool"
    color: str = "vec3"
    """Names of the types of a real number, a condition and a color."""
    constant: str = "const "
    """What stands before the type of a constant."""
    rgb: tuple[str, str, str] = (".r", ".g", ".b")
    """How the channels of a color are reached."""
    reserved: frozenset[str] = frozenset()
    """Names of ours that mean something else in the language."""

    def name(self, name: str) -> str:
        """Write a name, out of the way of the language's own words."""
        return f"{name}_" if name in self.reserved else name

    def number(self, value: float) -> str:
        """Write a number with the digits that 32 bit floats need."""
        if math.isnan(value):
            raise Untranslatable(f"it holds NaN, which {self.title} has no way to write")
        text = f"{value:.9g}"
        return text if set(text) & set(".en") else f"{text}.0"

    def called(self, name: str) -> str:
        """Write the name of a function of the language."""
        return name

    def choice(self, test: ast.expr, then: ast.expr, otherwise: ast.expr) -> tuple[str, int]:
        """Write `then` where `test` holds, else `otherwise`."""
        parts = [self.inside(part, _OR) for part in (test, then, otherwise)]
        return "{} ? {} : {}".format(*parts), _CHOICE

    def both(self, op: ast.boolop) -> tuple[str, int]:
        """Write `and` or `or`."""
        return ("&&", _AND) if isinstance(op, ast.And) else ("||", _OR)

    def comparison(self, op: ast.cmpop) -> str:
        """Write what compares two numbers."""
        return _COMPARISONS[type(op)]

    def negation(self) -> str:
        """Write `not`."""
        return "!"

    def inside(self, node: ast.expr, least: int) -> str:
        """Write an expression where only what binds as tight as `least` needs no parentheses."""
        text, binds = self.expression(node)
        return text if binds >= least else f"({text})"

    def expression(self, node: ast.expr) -> tuple[str, int]:
        """Write an expression, and say how tight it binds."""
        match node:
            case ast.Name(id=name):
                return self.name(name), _ATOM
            case ast.Constant(value=float() as value):
                return self.number(value), _ATOM
            case ast.BinOp(left=left, op=op, right=right):
                sign, binds = _OPERATORS[type(op)]
                # a - (b - c) keeps its parentheses, and a + (b + c) too: floats do not associate.
                return f"{self.inside(left, binds)} {sign} {self.inside(right, binds + 1)}", binds
            case ast.UnaryOp(op=ast.USub(), operand=operand):
                return f"-{self.inside(operand, _SIGN + 1)}", _SIGN
            case ast.UnaryOp(op=ast.Not(), operand=operand):
                return f"{self.negation()}{self.inside(operand, _ATOM)}", _SIGN
            case ast.Compare(left=left, ops=[op], comparators=[right]):
                sign = self.comparison(op)
                return f"{self.inside(left, _SUM)} {sign} {self.inside(right, _SUM)}", _COMPARE
            case ast.BoolOp(op=op, values=values):
                sign, binds = self.both(op)
                # With parentheses throughout: few know by heart which of these binds tighter.
                return f" {sign} ".join(self.inside(v, _SIGN) for v in values), binds
            case ast.IfExp(test=test, body=then, orelse=otherwise):
                return self.choice(test, then, otherwise)
            case ast.Call(func=ast.Name(id=name), args=arguments):
                given = ", ".join(self.inside(a, _CHOICE) for a in arguments)
                return f"{self.called(name)}({given})", _ATOM
            case _:
                raise TypeError(f"no formula holds {ast.dump(node)}")

    def broken(self, start: str, node: ast.expr, end: str = ";") -> list[str]:
        """Write `start`, the expression and `end`, over several lines where it is long."""
        line = f"{start}{self.inside(node, _CHOICE)}{end}"
        if len(line) <= WIDTH:
            return [line]
        match node:
            case ast.BinOp(left=left, op=op, right=right):
                sign, binds = _OPERATORS[type(op)]
                head = self.inside(left, binds)
                tail = f"{sign} {self.inside(right, binds + 1)}{end}"
                return [f"{start}{head}", f"        {tail}"]
            case _:
                return [line]

    def declared(self, step: Step, truths: frozenset[str]) -> list[str]:
        """Declare an intermediate result."""
        kind = self.truth if step.name in truths else self.real
        return self.broken(f"{kind} {self.name(step.name)} = ", step.value)

    def constant_line(self, name: str, value: float) -> str:
        """Declare a constant."""
        return f"{self.constant}{self.real} {name} = {self.number(value)};"

    def head(self, name: str, arguments: Sequence[str], colors: Sequence[str] | None) -> str:
        """Begin a function; of reals if `colors` is None, else of a color, as those arguments are."""
        kinds = [self.color if colors and a in colors else self.real for a in arguments]
        given = ", ".join(
            f"{kind} {self.name(a)}" for kind, a in zip(kinds, arguments, strict=True)
        )
        return f"{self.real if colors is None else self.color} {name}({given}) {{"

    def function(self, formula: Formula) -> list[str]:
        """Write one function."""
        truths = frozenset(
            step.name
            for step in formula.steps
            if isinstance(step.value, ast.Compare | ast.BoolOp)
            or (isinstance(step.value, ast.UnaryOp) and isinstance(step.value.op, ast.Not))
        )
        body = [self.constant_line(*constant) for constant in formula.constants.items()]
        for step in formula.steps:
            body += self.commented(step.comment)
            body += self.declared(step, truths)
        body += self.commented(formula.comment)
        body += self.broken("return ", formula.value)
        return [
            self.head(formula.name, formula.arguments, None),
            *(f"    {line}" for line in body),
            "}",
        ]

    def per_channel(
        self, formula: Formula, colors: Sequence[str], suffix: str = "_rgb"
    ) -> list[str]:
        """Write the function that takes colors and calls the formula once a channel."""
        calls = [
            "{}({})".format(
                formula.name,
                ", ".join(self.name(a) + (c if a in colors else "") for a in formula.arguments),
            )
            for c in self.rgb
        ]
        inner = ",\n".join(f"        {call}" for call in calls)
        head = self.head(f"{formula.name}{suffix}", formula.arguments, colors)
        return [head, f"    return {self.color}(\n{inner});", "}"]

    def commented(self, lines: Sequence[str]) -> list[str]:
        """Write comments, each wrapped."""
        return [
            f"{self.comment} {piece}" if piece else self.comment
            for line in lines
            for piece in textwrap.wrap(line, WIDTH - 3, subsequent_indent="  ") or [""]
        ]


class _Wgsl(Language):
    """WGSL: types after names, `let` for results, `select` for a choice."""

    def choice(self, test: ast.expr, then: ast.expr, otherwise: ast.expr) -> tuple[str, int]:
        parts = ", ".join(self.inside(part, _CHOICE) for part in (otherwise, then, test))
        return f"select({parts})", _ATOM

    def declared(self, step: Step, truths: frozenset[str]) -> list[str]:  # noqa: ARG002
        return self.broken(f"let {self.name(step.name)} = ", step.value)

    def constant_line(self, name: str, value: float) -> str:
        return f"const {name} = {self.number(value)};"

    def head(self, name: str, arguments: Sequence[str], colors: Sequence[str] | None) -> str:
        kinds = [self.color if colors and a in colors else self.real for a in arguments]
        given = ", ".join(
            f"{self.name(a)}: {kind}" for kind, a in zip(kinds, arguments, strict=True)
        )
        return f"fn {name}({given}) -> {self.real if colors is None else self.color} {{"


class _Glsl(Language):
    """GLSL: one name for both arctangents."""

    def called(self, name: str) -> str:
        return "atan" if name == "atan2" else name


class _JavaScript(Language):
    """JavaScript: numbers without types, in 64 bits."""

    def number(self, value: float) -> str:
        return "NaN" if math.isnan(value) else repr(value).removesuffix(".0")

    def comparison(self, op: ast.cmpop) -> str:
        return {ast.Eq: "===", ast.NotEq: "!=="}.get(type(op)) or super().comparison(op)

    def called(self, name: str) -> str:
        return f"Math.{name}" if name in _NUMPY else name

    def expression(self, node: ast.expr) -> tuple[str, int]:
        match node:
            case ast.Call(func=ast.Name(id="exp2"), args=[exponent]):
                return f"Math.pow(2, {self.inside(exponent, _CHOICE)})", _ATOM
            case ast.Call(func=ast.Name(id="clamp"), args=arguments):
                x, least, most = (self.inside(a, _CHOICE) for a in arguments)
                return f"Math.min(Math.max({x}, {least}), {most})", _ATOM
            case _:
                return super().expression(node)

    def declared(self, step: Step, truths: frozenset[str]) -> list[str]:  # noqa: ARG002
        return self.broken(f"const {self.name(step.name)} = ", step.value)

    def constant_line(self, name: str, value: float) -> str:
        return f"const {name} = {self.number(value)};"

    def head(self, name: str, arguments: Sequence[str], colors: Sequence[str] | None) -> str:  # noqa: ARG002
        return f"function {name}({', '.join(map(self.name, arguments))}) {{"

    def per_channel(
        self, formula: Formula, colors: Sequence[str], suffix: str = "_rgb"
    ) -> list[str]:
        given = ", ".join(
            f"{self.name(a)}[i]" if a in colors else self.name(a) for a in formula.arguments
        )
        head = self.head(f"{formula.name}{suffix}", formula.arguments, colors)
        return [head, f"    return [0, 1, 2].map((i) => {formula.name}({given}));", "}"]


class _Python(Language):
    """Python with NumPy, for numbers and arrays of any shape alike."""

    def number(self, value: float) -> str:
        return "np.nan" if math.isnan(value) else repr(value)

    def called(self, name: str) -> str:
        own = _NUMPY.get(name)
        return name if own is None else f"np.{own}"

    def choice(self, test: ast.expr, then: ast.expr, otherwise: ast.expr) -> tuple[str, int]:
        parts = ", ".join(self.inside(part, _CHOICE) for part in (test, then, otherwise))
        return f"np.where({parts})", _ATOM

    def both(self, op: ast.boolop) -> tuple[str, int]:
        # & and | bind tighter than comparisons, which have their parentheses anyway.
        return ("&" if isinstance(op, ast.And) else "|"), _COMPARE

    def negation(self) -> str:
        return "~"

    def broken(self, start: str, node: ast.expr, end: str = "") -> list[str]:  # noqa: ARG002
        lines = super().broken(start, node, "")
        if len(lines) == 1:
            return lines
        return [f"{start}(", f"    {lines[0].removeprefix(start)}", f"    {lines[1].strip()}", ")"]

    def declared(self, step: Step, truths: frozenset[str]) -> list[str]:  # noqa: ARG002
        return self.broken(f"{self.name(step.name)} = ", step.value)

    def constant_line(self, name: str, value: float) -> str:
        return f"{name} = {self.number(value)}"

    def head(self, name: str, arguments: Sequence[str], colors: Sequence[str] | None) -> str:  # noqa: ARG002
        return f"def {name}({', '.join(arguments)}):"

    def function(self, formula: Formula) -> list[str]:
        return super().function(formula)[:-1]

    def per_channel(
        self,
        formula: Formula,  # noqa: ARG002
        colors: Sequence[str],  # noqa: ARG002
        suffix: str = "_rgb",  # noqa: ARG002
    ) -> list[str]:
        return []  # arrays broadcast


_NUMPY = {written: name for name, written in FUNCTIONS.items()}

LANGUAGES: dict[str, Language] = {
    language.id: language
    for language in (
        _Glsl(
            id="glsl",
            title="GLSL",
            checked="run",
            checked_by="compiled by glslangValidator; run in Chromium's WebGL2 against Python",
        ),
        Language(
            id="hlsl",
            title="HLSL",
            checked="compiled",
            checked_by="compiled by glslangValidator; its numbers were not run",
            color="float3",
            constant="static const ",
            reserved=frozenset({"linear"}),
        ),
        _Wgsl(
            id="wgsl",
            title="WGSL",
            checked="run",
            checked_by="compiled and run in Chromium's WebGPU against Python",
            real="f32",
            color="vec3f",
        ),
        Language(
            id="osl",
            title="OSL",
            checked="untested",
            checked_by="no compiler of OSL is at hand to the tests",
            truth="int",
            color="color",
            constant="",
            rgb=("[0]", "[1]", "[2]"),
            reserved=frozenset({"normal", "point", "vector", "color", "matrix", "output"}),
        ),
        _JavaScript(
            id="javascript",
            title="JavaScript",
            checked="run",
            checked_by="run by Node.js against Python; the page draws from it while something moves",
            reserved=frozenset({"null", "in", "new", "var", "let", "this", "function", "default"}),
        ),
        _Python(
            id="python",
            title="Python",
            checked="run",
            checked_by="run by Python against the model itself",
            comment="#",
        ),
    )
}
