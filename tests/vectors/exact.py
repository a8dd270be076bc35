"""Arithmetic of 50 digits for the oracles, and the format of their files.

It has a separate context: other users of mpmath may change the precision of the shared one.
"""

from __future__ import annotations

import json
import math
import struct
from collections.abc import Iterable, Sequence
from typing import Any

import mpmath

exact = mpmath.MPContext()
exact.dps = 50

Vector = Sequence[Any]
"""Three numbers: floats, or those of `exact`."""

STEP_64 = 2.0**-53
STEP_32 = 2.0**-24
"""Greatest relative errors of one rounding to float64 and float32."""


def vector(values: Iterable[Any]) -> list[Any]:
    """Floats as exact numbers, without loss."""
    return [exact.mpf(x) for x in values]


def add(a: Vector, b: Vector, factor: Any = 1) -> list[Any]:
    """a + factor · b."""
    return [x + factor * y for x, y in zip(a, b, strict=True)]


def dot(a: Vector, b: Vector) -> Any:
    """Scalar product."""
    return sum((x * y for x, y in zip(a, b, strict=True)), exact.mpf(0))


def length(a: Vector) -> Any:
    """Euclidean length."""
    return exact.sqrt(dot(a, a))


def horizontal(a: Vector) -> list[Any]:
    """The part of a vector across the vertical axis."""
    return [a[0], exact.mpf(0), a[2]]


def rounded(value: Any) -> Any:
    """The nearest float64 of a number, or of each number in nested lists."""
    if isinstance(value, list | tuple):
        return [rounded(x) for x in value]
    return float(value)


def single(value: float) -> float:
    """The nearest float32, so that kernels of both precisions get the same input."""
    return float(struct.unpack("f", struct.pack("f", value))[0])


def step_32(value: Any) -> float:
    """Distance between float32 numbers of this size."""
    return math.ldexp(1.0, math.frexp(float(value))[1] - 24)


def above(bound: Any) -> float:
    """A tolerance with two digits, at least a bound."""
    return float(f"{float(bound) * 1.05:.1e}")


def document(
    *, holds: str, units: str, source: str, tolerance: dict[str, str], **sections: list[dict[str, Any]]
) -> str:
    """The text of a file of vectors, with one field of a case on each line.

    Parameters
    ----------
    holds, units, source
        The vectors in a sentence, the units of their numbers, and where their formulas were published.
    tolerance
        For each consumer, in words, how the bounds in the cases follow from its arithmetic.
    **sections
        Lists of cases. Numbers are floats; `json` writes the shortest digits that give the same float again.
    """
    header = {
        "format": "nearfar.vectors",
        "version": 1,
        "generator": "python -m tests.vectors.write",
        "holds": holds,
        "units": units,
        "source": source,
    }
    lines = [f' "{name}": {_text(value)},' for name, value in header.items()]
    lines += [' "tolerance": {', ",\n".join(f'  "{name}": {_text(why)}' for name, why in tolerance.items()), " },"]
    cases = []
    for name, section in sections.items():
        fields = [",\n".join(f'   "{key}": {_text(value)}' for key, value in case.items()) for case in section]
        cases.append(f' "{name}": [\n' + ",\n".join(f"  {{\n{field}\n  }}" for field in fields) + "\n ]")
    return "{\n" + "\n".join(lines) + "\n" + ",\n".join(cases) + "\n}\n"


def _text(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False, allow_nan=False)
