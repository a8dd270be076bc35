"""Translates WGSL's expressions of numbers and vectors. Types are inferred, because GLSL and HLSL need them."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import Literal

from scripts.shaders.tokens import Reader

Language = Literal["glsl", "hlsl"]

SCALARS = {"f32": "float", "u32": "uint", "bool": "bool"}
_VECTOR = re.compile(r"vec([234])<f32>")
_PLAIN = ("abs", "clamp", "max", "min", "normalize", "sqrt")
"""Functions with the same name and meaning in all languages. Arguments and result have one type, f32 or a vector."""
_TO_NUMBER = ("dot", "length")
"""Such functions from vectors to a number."""
_STEPS = (("||",), ("&&",), ("==", "!=", "<", ">", "<=", ">="), ("+", "-"), ("*", "/"))
"""Operators by increasing precedence."""


@dataclass(frozen=True)
class Value:
    """A translated expression and its WGSL type."""

    text: str
    type: str


@dataclass
class Names:
    """Names visible at a place of the program, with WGSL types."""

    variables: dict[str, str] = field(default_factory=dict)
    structs: dict[str, dict[str, str]] = field(default_factory=dict)
    functions: dict[str, tuple[list[str], str]] = field(default_factory=dict)
    """Types of the parameters and of the result."""


def is_real(kind: str) -> bool:
    """Whether a type is a number or vector of float32."""
    return kind == "f32" or bool(_VECTOR.fullmatch(kind))


class Expressions:
    """Translates expressions at a reader's position."""

    def __init__(self, reader: Reader, names: Names, language: Language) -> None:
        self.reader, self.names, self.language = reader, names, language

    def type(self) -> str:
        """Read a type in WGSL."""
        name = self.reader.take()
        if re.fullmatch(r"vec\d", name):
            self.reader.take("<")
            name = f"{name}<{self.reader.take()}>"
            self.reader.take(">")
        if name not in SCALARS and name not in self.names.structs and not _VECTOR.fullmatch(name):
            raise self.reader.refused(f"the type {name!r}")
        return name

    def written(self, kind: str) -> str:
        """Translate a type to the other language."""
        if vector := _VECTOR.fullmatch(kind):
            return f"{'vec' if self.language == 'glsl' else 'float'}{vector[1]}"
        return SCALARS.get(kind, kind)

    def of_type(self, kind: str) -> str:
        """Read an expression of a given type."""
        value = self.value()
        if value.type != kind:
            raise self.reader.refused(f"how to make {kind} of {value.text!r}, which is {value.type}")
        return value.text

    def value(self, step: int = 0) -> Value:
        """Read an expression whose operators have at least the given precedence."""
        if step == len(_STEPS):
            return self._unary()
        left = self.value(step + 1)
        while (sign := self.reader.peek()) in _STEPS[step]:
            self.reader.take()
            right = self.value(step + 1)
            left = Value(f"{left.text} {sign} {right.text}", self._type_of(left, sign, right))
        return left

    def _type_of(self, left: Value, sign: str, right: Value) -> str:
        kinds = {left.type, right.type}
        if sign in ("&&", "||"):
            if kinds == {"bool"}:
                return "bool"
        elif sign in "+-*/":
            if kinds == {"u32"} or (len(kinds) == 1 and is_real(left.type)):
                return left.type
            if len(kinds) == 2 and "f32" in kinds and all(map(is_real, kinds)):
                return (kinds - {"f32"}).pop()
        elif len(kinds) == 1 and left.type in ("f32", "u32"):
            return "bool"
        raise self.reader.refused(f"{left.type} {sign} {right.type}")

    def _unary(self) -> Value:
        sign = self.reader.peek()
        if sign not in ("-", "!"):
            return self._with_members(self._primary())
        self.reader.take()
        value = self._unary()
        # `--` has another meaning in the other languages.
        if value.text[0] == sign or not (is_real(value.type) if sign == "-" else value.type == "bool"):
            raise self.reader.refused(f"{sign} before {value.type}")
        return Value(sign + value.text, value.type)

    def member(self, of: Value) -> Value:
        """Read a value's member or swizzle, after the dot."""
        name = self.reader.take()
        vector = _VECTOR.fullmatch(of.type)
        if vector and len(name) <= 4 and set(name) <= set("xyzw"[: int(vector[1])]):
            return Value(f"{of.text}.{name}", "f32" if len(name) == 1 else f"vec{len(name)}<f32>")
        if name not in self.names.structs.get(of.type, {}):
            raise self.reader.refused(f"{name!r} of {of.type}")
        return Value(f"{of.text}.{name}", self.names.structs[of.type][name])

    def _with_members(self, value: Value) -> Value:
        while self.reader.takes("."):
            value = self.member(value)
        return value

    def _primary(self) -> Value:
        name = self.reader.peek()
        if self.reader.takes("("):
            inner = self.value()
            self.reader.take(")")
            return Value(f"({inner.text})", inner.type)
        if re.match(r"[.\d]", name):
            self.reader.take()
            if not re.search(r"[.eu]", name):
                raise self.reader.refused(f"the type of the number {name}; write {name}.0 or {name}u")
            return Value(name, "u32" if name.endswith("u") else "f32")
        if name in ("true", "false"):
            return Value(self.reader.take(), "bool")
        if name in self.names.variables:
            return Value(self.reader.take(), self.names.variables[name])
        if name in self.names.structs or re.fullmatch(r"vec\d", name):
            return self._constructor(self.type())
        return self._called(self.reader.take())

    def _arguments(self) -> list[Value]:
        self.reader.take("(")
        found: list[Value] = []
        while not self.reader.takes(")"):
            found.append(self.value())
            if self.reader.peek() != ")":
                self.reader.take(",")
        return found

    def _constructor(self, kind: str) -> Value:
        """Read the constructor of a vector or structure. HLSL needs functions for structures, from `declarations`."""
        arguments = self._arguments()
        kinds = [value.type for value in arguments]
        if kind in self.names.structs:
            fits = kinds == list(self.names.structs[kind].values())
            name = f"make_{kind}" if self.language == "hlsl" else kind
        else:
            sizes = [1 if kind == "f32" else int(kind[3]) for kind in kinds if is_real(kind)]
            # HLSL has no vectors of one number.
            fits = len(sizes) == len(kinds) > 1 and sum(sizes) == int(kind[3])
            name = self.written(kind)
        if not fits:
            raise self.reader.refused(f"{kind} of {', '.join(kinds) or 'nothing'}")
        return Value(f"{name}({', '.join(value.text for value in arguments)})", kind)

    def _called(self, name: str) -> Value:
        if self.reader.peek() != "(":
            raise self.reader.refused(f"{name!r} here")
        arguments = self._arguments()
        kinds = [value.type for value in arguments]
        text = f"{name}({', '.join(value.text for value in arguments)})"
        same = len(set(kinds)) == 1 and is_real(kinds[0])
        if name in self.names.functions and kinds == self.names.functions[name][0]:
            return Value(text, self.names.functions[name][1])
        if name in _PLAIN and same:
            return Value(text, kinds[0])
        if name in _TO_NUMBER and same:
            return Value(text, "f32")
        if name == "select" and len(kinds) == 3 and kinds[0] == kinds[1] and kinds[2] == "bool":
            no, yes, condition = (value.text for value in arguments)
            return Value(f"(({condition}) ? {yes} : {no})", kinds[0])
        raise self.reader.refused(f"the function {name}({', '.join(kinds)}), or it is declared further down")
