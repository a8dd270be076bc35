"""Patterns of the tables of parameters, such as "lod.*.k", and how well they match a name."""

from __future__ import annotations

import fnmatch
import functools
import re


@functools.cache
def match_length(name: str, patterns: str) -> int:
    """Return the length of the longest pattern that matches "callable.parameter", or 0.

    A pattern without a full stop is the name of a parameter.
    """
    plain, dotted = _parsed(patterns)
    parameter = name.rpartition(".")[2]
    return max([len(parameter) * (parameter in plain), *(length for length, pattern in dotted if pattern.match(name))])


@functools.cache
def _parsed(patterns: str) -> tuple[frozenset[str], list[tuple[int, re.Pattern[str]]]]:
    """Return the names of parameters, and the other patterns with their lengths."""
    parts = patterns.split()
    dotted = [(len(text), re.compile(fnmatch.translate(text))) for text in parts if "." in text]
    return frozenset(parts), dotted
