"""Names of a scene's objects and their numbers."""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterable, Sequence
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from nearfar._base import check

_MAX_COMPARED = 20_000
"""Greatest number of names compared with a misspelt one; more would take seconds."""


def names_of(argument: str, names: Iterable[str]) -> list[str]:
    """Return distinct names as a list; ValueError if names repeat, TypeError if they are not a list of strings."""
    listed = check.texts(argument, names)
    repeated = len(listed) - len(set(listed))
    if repeated:
        raise ValueError(f"{argument}: expected distinct names, got {repeated} repetitions")
    return listed


MAX_OBJECTS = (1 << 31) - 1
"""Greatest number of objects: object numbers are int32."""


def distinct(names: Sequence[str]) -> list[str]:
    """Make names distinct: the first of equal ones keeps its name, the others get unused number suffixes."""
    used_names, next_suffixes = set(names), dict[str, int]()
    result = []
    for name in names:
        unique, suffix = name, next_suffixes.get(name, 0)
        if suffix:
            while (unique := f"{name}_{suffix}") in used_names:
                suffix += 1
            used_names.add(unique)
        next_suffixes[name] = suffix + 1
        result.append(unique)
    return result


_NAMELESS = re.compile(r"object_(0|[1-9][0-9]{0,17})")
"""Pattern of the names that nameless objects get, with the number as group."""


class Names:
    """Object names in the order of their numbers.

    Names of nameless objects are created on first use: a city may have 1.8 million of them.
    """

    def __init__(self, names: Sequence[str] | int) -> None:
        self.source = names
        """The names as passed, or the number of nameless objects."""

    def __len__(self) -> int:
        return self.source if isinstance(self.source, int) else len(self.source)

    @cached_property
    def as_tuple(self) -> tuple[str, ...]:
        """All names; nameless objects are called ``object_0``, ``object_1`` and so on."""
        if isinstance(self.source, int):
            return tuple(f"object_{number}" for number in range(self.source))
        return tuple(self.source)

    @cached_property
    def _numbers(self) -> dict[str, int]:
        return {name: number for number, name in enumerate(self.as_tuple)}

    def _number_of(self, name: str) -> int | None:
        if not isinstance(self.source, int):
            return self._numbers.get(name)
        match = _NAMELESS.fullmatch(name)
        return int(match[1]) if match and int(match[1]) < self.source else None

    def number(self, argument: str, name: str) -> int:
        """Return the number of an object; ValueError with similar names if there is none."""
        if not isinstance(name, str):
            raise TypeError(f"{argument}: expected names of objects, got {check.type_and_value(name)}")
        number = self._number_of(name)
        if number is None:
            raise ValueError(f"{argument}: the scene has no object {check.shortened(name)}{self._similar(name)}")
        return number

    def flags(self, argument: str, names: Iterable[str]) -> NDArray[np.bool_]:
        """Return flags (N,), true for each named object."""
        named = [names] if isinstance(names, str) else check.items(argument, names, str, "names of objects")
        flags = np.zeros(len(self), bool)
        flags[[self.number(argument, name) for name in named]] = True
        return flags

    def _similar(self, name: str) -> str:
        if isinstance(self.source, int):
            return f"; it has {self.source} objects" + (", such as 'object_0'" if self.source else "")
        candidates = self.as_tuple
        if len(candidates) > _MAX_COMPARED:
            candidates = tuple(other for other in candidates if other[:2] == name[:2])[:_MAX_COMPARED]
        close = difflib.get_close_matches(name, candidates)
        if close:
            return f"; did you mean {' or '.join(repr(other) for other in close)}?"
        return f"; it has {len(self)} objects" + (f", such as {candidates[0]!r}" if candidates else "")
