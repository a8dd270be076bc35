"""Calls of every public callable with one argument replaced: by a hostile value, or by the same numbers."""

from __future__ import annotations

import functools
import zlib
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

import numpy as np

from tests.support.digest import digest
from tests.support.hostile import Hostile, constant, hostile_values, variants
from tests.support.name_patterns import match_length
from tests.support.parameters import Range, added_kinds, kinds_of, range_of
from tests.support.valid_calls import calls
from tests.support.valid_calls.objects import Valid
from tests.support.verdict import attempt, caught, outcome, result, strict_warnings, verdict
from tests.support.wrong_values import wrong_values

HARMLESS = frozenset(("none", "big", "flag", "scene", "camera", "frame", "model", "mesh", "lens", "hmd"))
"""Kinds of values that are not hostile where they are valid."""

ITEM_BY_ITEM = "render_path.cameras render_path.at *.visual_continuity.*"
"""Parameters that may be iterators, whose items are checked on arrival; others are checked at the call."""

PART = 4
"""Forwarded keywords are tried with one value in `PART`; the callable that declares them is tried with all."""


class Call:
    """A valid call, whose arguments are to be replaced."""

    def __init__(self, name: str, valid: Valid) -> None:
        self.name, self._valid = name, valid
        self._parameters = calls.parameters_of(name)
        self.arguments = calls.arguments(name, valid)
        self._valid_outcome = ""

    @property
    def parameters(self) -> tuple[str, ...]:
        """All parameters, including those whose default the call uses."""
        return tuple(self._parameters)

    @functools.cached_property
    def names(self) -> tuple[str, ...]:
        """Names that a message may contain: other arguments may no longer fit a changed one.

        "at" is excluded, because "at least" is in many messages.
        """
        others = tuple(name for name in self.parameters if name != "at")
        return (*others, "vertices") if "positions" in others else others

    def attempt(self, changes: Mapping[str, Any]) -> BaseException | None:
        """Call with changed arguments, and return the exception; warnings count as such."""
        with strict_warnings():
            return self.caught(changes)

    def caught(self, changes: Mapping[str, Any], *, begins: bool = True) -> BaseException | None:
        """Call with changed arguments, and return the exception; `begins` is that of `verdict.caught`."""
        return caught(calls.target(self.name, self._valid), {**self.arguments, **changes}, begins=begins)

    def attempt_valid(self) -> BaseException | None:
        """Call without changes, remember the digest of the result, and return the exception."""

        def call(**arguments: Any) -> None:
            self._valid_outcome = digest(result(calls.target(self.name, self._valid), arguments))

        return attempt(call, self.arguments)

    def outcome(self, **changes: Any) -> str:
        """Call with changed arguments, and return the digest of the result; an empty text for a refusal."""
        return outcome(calls.target(self.name, self._valid), {**self.arguments, **changes})

    def wrong_refusals(self) -> list[str]:
        """Describe each wrong outcome of calls with a value that the parameter must refuse."""
        with strict_warnings():
            return [*self._complaints(is_right=False)]

    def wrong_uses(self) -> list[str]:
        """Describe each wrong outcome of calls with a value that is unusual, and may be valid."""
        with strict_warnings():
            return [*self._complaints(is_right=True)]

    def _complaints(self, *, is_right: bool) -> Iterator[str]:
        before = digest(self.arguments)
        for parameter in self.parameters:
            begins = is_right or match_length(self._parameters[parameter][0], ITEM_BY_ITEM) > 0
            for value in self._values(parameter)[is_right]:
                error = self.caught({parameter: value.make()}, begins=begins)
                flaw = "nothing" if error is None and not is_right else verdict(error, parameter, self.names)
                if flaw is not None:
                    yield f"{self.name}({parameter}={value.name}) raised {flaw}"
        if digest(self.arguments) != before:
            yield f"{self.name} changed its arguments"

    def differences(self) -> Iterator[str]:
        """Describe each array argument whose layout in memory changes the result of `attempt_valid`."""
        arrays = {
            name: value
            for name, value in self.arguments.items()
            if isinstance(value, np.ndarray) and value.size > 1 and value.dtype.kind in "fiu"
        }
        for name, value in arrays.items():
            for layout, array in _layouts(value):
                if self.outcome(**{name: array}) != self._valid_outcome:
                    yield f"{self.name}({name}={layout}) gives another result"

    def refused_floats(self) -> Iterator[str]:
        """Describe each count, or pair of counts, that as a float gives another result than in `attempt_valid`."""
        counts = self._counts()
        # Most calls take all of their counts as floats at once; if not, those that are wrong are found one by one.
        given = {name: as_float(count) for name, count in counts.items() if self._everything()[name] is not None}
        if given and self.outcome(**given) == self._valid_outcome:
            counts = {name: count for name, count in counts.items() if name not in given}
        for name, count in counts.items():
            same = as_float(count)
            expected = self.outcome(**{name: count})
            # Results that contain times differ between equal calls; such a call must only be accepted.
            if self.outcome(**{name: same}) != expected and (
                self.outcome(**{name: count}) == expected or self.attempt({name: same}) is not None
            ):
                yield f"{self.name}({name}={same}) gives another result than {count}"

    def _counts(self) -> dict[str, Any]:
        """Return parameters that are a count or a pair of counts, each with a value."""
        found: dict[str, Any] = {}
        for name, (_, entry) in self._parameters.items():
            value = self.arguments.get(name, entry.default)
            # Parameters that also take arrays or slices are indices.
            kind = str(entry.annotation).removesuffix(" | None")
            if kind in ("int", "SupportsIndex") and (value is None or type(value) is int):
                found[name] = 4 if value is None else value
            elif kind == "tuple[int, int]" and (value is None or type(value) is tuple):
                found[name] = value or (16, 16)
        return found

    def _values(self, parameter: str) -> Sorted:
        name, entry = self._parameters[parameter]
        also = added_kinds(name) | added_kinds(f"{self.name}.{parameter}")
        kinds = kinds_of(entry)
        numeric = kinds & {"number", "whole"} - also
        limits = range_of(name, self._everything()) if numeric and "any" not in also else None
        own = _sort(variants(self.arguments.get(parameter)), kinds, also, limits)
        both = zip(_sorted_values(self._valid, kinds, also, limits), own, strict=True)
        wrong, right = (first + second for first, second in both)
        near = limits.outside(is_whole="whole" in numeric) if limits is not None else []
        wrong += (
            Hostile(f"{value!r:.40}", constant(value))
            for value in (*near, *wrong_values(name, f"{self.name}.{parameter}"))
        )
        forwarding = calls.callable_of(self.name)
        if parameter in forwarding.parameters:
            return wrong, right
        declaring = (calls.CALLABLES[receiver] for receiver in calls.receivers(forwarding.name))
        assert any(parameter in each.parameters for each in declaring), f"no call tries all values of {name}"
        first = zlib.crc32(f"{self.name}.{parameter}".encode()) % PART
        return wrong[first::PART], right[first::PART]

    def _everything(self) -> dict[str, Any]:
        """Arguments and defaults."""
        return {name: entry.default for name, (_, entry) in self._parameters.items()} | self.arguments


Sorted = tuple[list[Hostile], list[Hostile]]
"""Values that a parameter must refuse, and those that it may accept."""


@functools.cache
def _sorted_values(valid: Valid, *expected: Any) -> Sorted:
    return _sort(hostile_values(valid), *expected)


def _sort(values: Iterable[Hostile], kinds: frozenset[str], also: frozenset[str], limits: Range | None) -> Sorted:
    """Sort values for a parameter that takes some kinds by its annotation, others by its name, and a range."""
    numeric = kinds & {"number", "whole"} - also
    wrong: list[Hostile] = []
    right: list[Hostile] = []
    for value in values:
        fits = value.kinds & (kinds | also)
        is_fit = "any" in also or bool(fits)
        if limits is not None and value.kinds & numeric:
            is_fit = float(value.make()) in limits
        if not fits & HARMLESS:
            (right if is_fit else wrong).append(value)
    return wrong, right


def as_float(count: Any) -> Any:
    """The same numbers as floats."""
    return tuple(map(float, count)) if isinstance(count, tuple) else float(count)


def _layouts(array: Any) -> Iterator[tuple[str, Any]]:
    """Yield the same numbers at other addresses and in another byte order."""
    every = tuple(slice(None, None, 2) for _ in array.shape)
    spread = np.zeros([2 * side for side in array.shape], array.dtype)
    spread[every] = array
    yield "every other number", spread[every]
    yield "columns first", np.asfortranarray(array)
    yield "bytes swapped", array.astype(array.dtype.newbyteorder())
