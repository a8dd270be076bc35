"""Translates a subset of WGSL to GLSL and HLSL; names, order and comments stay.

The subset: constants, structures and functions of numbers and vectors, with `let`, `var`, assignments, `if` and
`return`. Everything else is refused with a message, so that no text changes its meaning in translation.
"""

from __future__ import annotations

from scripts.shaders.expressions import Expressions, Language, Names, Value
from scripts.shaders.tokens import Reader

_LONGEST = 120
"""Maximum number of characters of a line."""


def translate(text: str, language: Language) -> str:
    """Translate a program to another language.

    Raises
    ------
    RefusedError
        Text that the translator does not support.
    """
    return _Program(text, language).translated()


class _Program:
    def __init__(self, text: str, language: Language) -> None:
        self._reader, self._names, self._language = Reader(text), Names(), language
        self._values = Expressions(self._reader, self._names, language)
        self._lines: list[str] = []

    def translated(self) -> str:
        declarations = {"const": self._constant, "struct": self._struct, "fn": self._function}
        self._copy(0)
        while word := self._reader.take():
            if word not in declarations:
                raise self._reader.refused(f"{word!r} outside functions")
            declarations[word]()
            self._copy(0)
        return "\n".join(self._lines).strip("\n") + "\n"

    def _add(self, depth: int, line: str) -> None:
        self._lines.append(("    " * depth + line).rstrip())

    def _copy(self, depth: int) -> None:
        for line in self._reader.between():
            self._add(depth, line)

    def _define(self) -> str:
        """Consume the name of a definition, which must be unused: in HLSL, `x` in `let x = x` would be the new one."""
        name = self._reader.defined()
        if name in {**self._names.structs, **self._names.functions, **self._names.variables}:
            raise self._reader.refused(f"a second {name!r}")
        return name

    def _typed(self) -> tuple[str, str]:
        name = self._define()
        self._reader.take(":")
        return name, self._values.type()

    def _constant(self) -> None:
        name, kind = self._typed()
        self._reader.take("=")
        value = self._values.of_type(kind)
        self._reader.take(";")
        self._names.variables[name] = kind
        self._add(0, f"{'static ' * (self._language == 'hlsl')}const {self._values.written(kind)} {name} = {value};")

    def _struct(self) -> None:
        name = self._define()
        self._reader.take("{")
        self._add(0, f"struct {name} {{")
        members: dict[str, str] = {}
        self._copy(1)
        while not self._reader.takes("}"):
            member, kind = self._typed()
            members[member] = kind
            self._add(1, f"{self._values.written(kind)} {member};")
            if self._reader.peek() != "}":
                self._reader.take(",")
            self._copy(1)
        self._add(0, "};")
        self._names.structs[name] = members
        if self._language == "hlsl":
            written = [f"{self._values.written(kind)} {member}" for member, kind in members.items()]
            self._lines += ["", f"{name} make_{name}({', '.join(written)}) {{", f"    {name} made;"]
            self._lines += [*(f"    made.{member} = {member};" for member in members), "    return made;", "}"]

    def _function(self) -> None:
        name = self._define()
        parameters: dict[str, str] = {}
        self._reader.take("(")
        while not self._reader.takes(")"):
            parameter, kind = self._typed()
            parameters[parameter] = kind
            if self._reader.peek() != ")":
                self._reader.take(",")
        self._reader.take("->")
        result = self._values.type()
        self._head(name, parameters, result)
        outside = self._names.variables
        self._names.variables = outside | parameters
        self._block(1, result)
        self._add(0, "}")
        self._names.variables = outside
        self._names.functions[name] = list(parameters.values()), result

    def _head(self, name: str, parameters: dict[str, str], result: str) -> None:
        written = [f"{self._values.written(kind)} {parameter}" for parameter, kind in parameters.items()]
        start = f"{self._values.written(result)} {name}("
        line = f"{start}{', '.join(written)}) {{"
        if len(line) <= _LONGEST:
            self._add(0, line)
            return
        # Neither language allows a comma after the last parameter.
        self._add(0, start)
        for part in written[:-1]:
            self._add(1, f"{part},")
        self._add(1, written[-1])
        self._add(0, ") {")

    def _block(self, depth: int, result: str) -> None:
        outside = self._names.variables
        self._names.variables = dict(outside)
        self._reader.take("{")
        self._copy(depth)
        while not self._reader.takes("}"):
            self._statement(depth, result)
            self._copy(depth)
        self._names.variables = outside

    def _statement(self, depth: int, result: str) -> None:
        word = self._reader.take()
        if word == "if":
            self._branch(depth, result)
            return
        if word in ("let", "var"):
            name = self._define()
            kind = self._values.type() if self._reader.takes(":") else None
            self._reader.take("=")
            value = self._values.value() if kind is None else Value(self._values.of_type(kind), kind)
            self._names.variables[name] = value.type
            self._add(depth, f"{self._values.written(value.type)} {name} = {value.text};")
        elif word == "return":
            self._add(depth, f"return {self._values.of_type(result)};")
        elif word in self._names.variables:
            target = Value(word, self._names.variables[word])
            while self._reader.takes("."):
                target = self._values.member(target)
            self._reader.take("=")
            self._add(depth, f"{target.text} = {self._values.of_type(target.type)};")
        else:
            raise self._reader.refused(f"the statement {word!r}")
        self._reader.take(";")

    def _branch(self, depth: int, result: str, start: str = "if") -> None:
        self._add(depth, f"{start} ({self._values.of_type('bool')}) {{")
        self._block(depth + 1, result)
        if self._reader.takes("else"):
            if self._reader.takes("if"):
                self._branch(depth, result, "} else if")
                return
            self._add(depth, "} else {")
            self._block(depth + 1, result)
        self._add(depth, "}")
