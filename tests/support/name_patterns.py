"""Patterns of the tables of parameters, such as "lod.*.k", and how well they match a name."""

from __future__ import annotations

import fnmatch
import functools
import re
from collections import defaultdict
from collections.abc import Callable


def match_length(name: str, patterns: str) -> int:
    """Return the length of the longest pattern that matches "callable.parameter", or 0.

    A pattern without a full stop is the name of a parameter.
    """
    parsed = _parsed(patterns)
    candidates = parsed.get(name.rpartition(".")[2], []) + parsed[""]
    return max([length for length, is_match in candidates if is_match(name)], default=0) if candidates else 0


@functools.cache
def _parsed(patterns: str) -> dict[str, list[tuple[int, Callable[[str], object]]]]:
    """Return the lengths and tests of patterns by their parameter, or "" if that is a pattern too."""
    parsed: dict[str, list[tuple[int, Callable[[str], object]]]] = defaultdict(list, {"": []})
    for text in patterns.split():
        before, _, parameter = text.rpartition(".")
        is_match: Callable[[str], object] = re.compile(fnmatch.translate(text)).match if before else lambda _: True
        parsed[parameter if parameter.isidentifier() else ""].append((len(text), is_match))
    return dict(parsed)
