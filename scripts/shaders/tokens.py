"""Splits WGSL into tokens, and refuses text that the translator does not support."""

from __future__ import annotations

import re
from dataclasses import dataclass

_TOKEN = re.compile(
    r"(?P<comment>//[^\n]*)|(?P<line>\n)|(?P<space>[ \t]+)"
    r"|(?P<number>(?:\d+\.\d*|\.\d+|\d+)(?:e[+-]?\d+)?u?(?![\w.]))|(?P<name>[A-Za-z_]\w*)"
    r"|(?P<sign>->|&&|\|\||[=!<>]=|[-+*/<>=!(){},;:.])"
)

_RESERVED = frozenset(
    re.findall(
        r"\w+",
        """
        active asm buffer cast centroid class column_major common compile const discard double enum export extern
        external filter fixed flat fract frac goto half highp in inline inout input interface invariant lerp line linear
        long lowp matrix mediump mix mod mul namespace noinline noise out output packed partition pass patch
        pixelfragment point precise precision private public register resource row_major sample sampler saturate shared
        short signed sizeof smooth snorm stage state static step string subroutine superp technique template texture
        this triangle typedef typename uniform union unorm unsigned using varying vector vertexfragment volatile while
        abs bool clamp cross distance dot float float2 float3 float4 int length max min normalize reflect sign sqrt uint
        vec2 vec3 vec4
        """,
    )
)
"""Reserved names of GLSL or HLSL."""


class RefusedError(ValueError):
    """WGSL that the translator does not support."""


@dataclass(frozen=True)
class Token:
    """A comment, end of line, number, name, sign, or end of the text."""

    kind: str
    text: str
    line: int


def tokens(text: str) -> list[Token]:
    """Split a text into tokens, without spaces."""
    found: list[Token] = []
    at, line = 0, 1
    while at < len(text):
        match = _TOKEN.match(text, at)
        if not match:
            raise RefusedError(f"line {line}: the translator does not know {text[at:].split(maxsplit=1)[0]!r}")
        kind = str(match.lastgroup)
        if kind != "space":
            found.append(Token(kind, match[0], line))
        line += kind == "line"
        at = match.end()
    return [*found, Token("end", "", line)]


class Reader:
    """A position in a text."""

    def __init__(self, text: str) -> None:
        self._tokens, self._at = tokens(text), 0

    def refused(self, what: str) -> RefusedError:
        """Return the error that names the position and the unsupported construct."""
        return RefusedError(f"line {self._tokens[self._at].line}: the translator does not know {what}")

    def _next(self) -> int:
        """Index of the next token after line ends, because statements may continue in the next line."""
        at = self._at
        while self._tokens[at].kind == "line":
            at += 1
        return at

    def peek(self) -> str:
        """Return the next sign, number, name or comment; "" at the end."""
        return self._tokens[self._next()].text

    def take(self, *expected: str) -> str:
        """Consume and return the next sign, number or name, which must be one of `expected` if any are given."""
        at = self._next()
        text = self._tokens[at].text
        if self._tokens[at].kind == "comment":
            raise self.refused("comments within a statement")
        if expected and text not in expected:
            raise self.refused(f"{text!r} where it expects {' or '.join(map(repr, expected))}")
        self._at = at + 1
        return text

    def takes(self, text: str) -> bool:
        """Consume a token if it comes next; return whether it did."""
        found = self.peek() == text
        if found:
            self.take()
        return found

    def defined(self) -> str:
        """Consume a name that is being defined."""
        name = self.take()
        if not re.fullmatch(r"[A-Za-z_]\w*", name) or "__" in name:
            raise self.refused(f"the name {name!r}")
        if name in _RESERVED:
            raise self.refused(f"another name for {name!r}, which GLSL or HLSL takes for itself")
        return name

    def between(self) -> list[str]:
        """Consume comments and empty lines before a declaration or a statement."""
        lines: list[str] = []
        while (token := self._tokens[self._at]).kind in ("comment", "line"):
            ends_a_line = self._at > 0 and self._tokens[self._at - 1].kind != "line"
            if token.kind == "comment":
                if ends_a_line:
                    raise self.refused("comments behind a statement")
                lines.append(token.text)
            elif not ends_a_line and self._at > 0:
                lines.append("")
            self._at += 1
        return lines
