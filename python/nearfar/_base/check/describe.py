"""Describes wrong values in error messages, in few words and without fail."""

from __future__ import annotations

_LONGEST = 60
"""Greatest number of characters of a value in a message."""

_MOST_BITS = 192
"""Size of whole numbers that are written out; those of thousands of digits cannot even be converted to text."""


def described(value: object) -> str:
    """Return the type of a value, with the value itself if it is text or a number."""
    kind = type(value).__name__
    if not isinstance(value, str | bool | int | float):
        return kind
    if isinstance(value, int) and value.bit_length() > _MOST_BITS:
        return f"{kind} of {value.bit_length():,} bits"
    return f"{kind} {shortened(value)}"


def shortened(value: object) -> str:
    """Return the representation of a value, cut after a few words; text is escaped, so that any file can hold it."""
    text = repr(value[: _LONGEST + 1] if isinstance(value, str) else value)
    return text if len(text) <= _LONGEST else f"{text[: _LONGEST - 1]}…"
