"""Describes invalid values for error messages, briefly and without raising errors."""

from __future__ import annotations

import numpy as np

_MAX_LENGTH = 60
"""Greatest number of characters of a value in a message."""

_MAX_ITEMS = 4
"""Greatest length of number sequences that are written out."""

_MAX_BITS = 192
"""Greatest bit length of integers that are written out; with thousands of digits, conversion to text fails."""


def type_and_value(value: object) -> str:
    """Return the type of a value, with the value itself if it is text or a number."""
    kind = type(value).__name__
    return f"{kind} {shortened(value)}" if isinstance(value, str | bool | int | float) else kind


def value_or_type(value: object) -> str:
    """Return the value itself if it is text, a number or a short sequence of these, else its type."""
    plain = str | bool | int | float
    items = value if isinstance(value, tuple | list) and len(value) <= _MAX_ITEMS else (value,)
    is_short = all(isinstance(item, plain) and not _is_long(item) for item in items)
    return shortened(value) if is_short or isinstance(value, plain) else type(value).__name__


def _is_long(value: object) -> bool:
    return isinstance(value, int) and value.bit_length() > _MAX_BITS


def shortened(value: object) -> str:
    """Return a value's representation, cut after 60 characters; text is escaped, so that any file can hold it."""
    if isinstance(value, int) and _is_long(value):
        return f"a number of {value.bit_length():,} bits"
    if isinstance(value, np.generic):
        return shortened(value.item())
    try:
        text = repr(value[: _MAX_LENGTH + 1] if isinstance(value, str) else value)
    except RecursionError:
        return f"{type_and_value(value)} of many levels"
    return text if len(text) <= _MAX_LENGTH else f"{text[: _MAX_LENGTH - 1]}…"


def one_line(text: str, max_length: int | None = None) -> str:
    """Return printable text on one line, cut after `max_length` characters."""
    line = " ".join(printable(text).split())
    return line if max_length is None or len(line) <= max_length else f"{line[: max_length - 1]}…"


def printable(text: str) -> str:
    """Escape lone surrogates, which files and terminals cannot hold."""
    return text.encode("utf-8", "backslashreplace").decode()
