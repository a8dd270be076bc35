"""Describes wrong values in error messages, in few words and without fail."""

from __future__ import annotations

import numpy as np

_LONGEST = 60
"""Greatest number of characters of a value in a message."""

_MOST_ITEMS = 4
"""Length of sequences of numbers that are written out."""

_MOST_BITS = 192
"""Size of whole numbers that are written out; those of thousands of digits cannot even be converted to text."""


def described(value: object) -> str:
    """Return the type of a value, with the value itself if it is text or a number."""
    kind = type(value).__name__
    return f"{kind} {shortened(value)}" if isinstance(value, str | bool | int | float) else kind


def shown(value: object) -> str:
    """Return the value itself if it is text, a number or a few of them, else its type."""
    plain = str | bool | int | float
    items = value if isinstance(value, tuple | list) and len(value) <= _MOST_ITEMS else (value,)
    is_short = all(isinstance(item, plain) and not _is_long(item) for item in items)
    return shortened(value) if is_short or isinstance(value, plain) else type(value).__name__


def _is_long(value: object) -> bool:
    return isinstance(value, int) and value.bit_length() > _MOST_BITS


def shortened(value: object) -> str:
    """Return the representation of a value, cut after 60 characters; text is escaped, so that any file can hold it."""
    if isinstance(value, int) and _is_long(value):
        return f"a number of {value.bit_length():,} bits"
    if isinstance(value, np.generic):
        return shortened(value.item())
    try:
        text = repr(value[: _LONGEST + 1] if isinstance(value, str) else value)
    except RecursionError:
        return f"{described(value)} of many levels"
    return text if len(text) <= _LONGEST else f"{text[: _LONGEST - 1]}…"


def one_line(text: str, most: int | None = None) -> str:
    """Return printable text on one line, cut after `most` characters."""
    line = " ".join(printable(text).split())
    return line if most is None or len(line) <= most else f"{line[: most - 1]}…"


def printable(text: str) -> str:
    """Escape lone surrogates, which no file and no terminal can hold."""
    return text.encode("utf-8", "backslashreplace").decode()
