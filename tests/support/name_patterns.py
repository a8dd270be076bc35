"""Patterns of the tables of parameters, such as "lod.*.k", and how well they match a name."""

from __future__ import annotations

import functools
from fnmatch import fnmatchcase


@functools.cache
def match_length(name: str, patterns: str) -> int:
    """Return the length of the longest pattern that matches "callable.parameter", or 0.

    A pattern without a full stop is the name of a parameter.
    """
    parameter = name.rpartition(".")[2]
    found = (text for text in patterns.split() if text == parameter or ("." in text and fnmatchcase(name, text)))
    return max(map(len, found), default=0)
