"""Calls of every public callable in which one argument at a time is replaced by a hostile value."""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import Any

from tests.support import missing
from tests.support.hostile_values import Hostile, attempt, verdict
from tests.support.public_callables import PublicCallable, public_callables
from tests.support.valid_calls import NEED_ADAPTER, NEEDS, has_adapter, instances, valid_arguments
from tests.support.valid_objects import Valid

OBJECTS = (
    "scene", "camera", "frame", "reduced", "env", "lens", "hmd", "model", "levels", "shot", "mesh", "stereo",
)  # fmt: skip
"""Attributes of `Valid` that are hostile where another kind of object is expected."""


@dataclass(frozen=True)
class Case:
    """A valid call, whose arguments are to be replaced."""

    name: str
    """Name of the callable, followed by " @" and a word if it is another call of the same."""
    callable: Callable[[], Callable[..., Any]]
    """Makes what is called; methods get a new instance where calls change it."""
    arguments: dict[str, Any]
    parameters: tuple[str, ...]
    """All parameters, also those whose default the valid call uses."""

    def attempt(self, **changes: Any) -> BaseException | None:
        """Call with changed arguments, and return the exception."""
        return attempt(self.callable(), {**self.arguments, **changes})

    def complaints(self, values: Iterable[Hostile]) -> Iterator[str]:
        """Describe each wrong exception of the calls in which one value replaces one argument."""
        for value in values:
            for parameter in self.parameters:
                flaw = verdict(self.attempt(**{parameter: value.make()}), parameter, self.parameters)
                if flaw is not None:
                    yield f"{self.name}({parameter}={value.name}) raised {flaw}"


def _made(entry: PublicCallable, maker: Callable[[], Any]) -> Callable[..., Any]:
    return entry.on(maker())


def cases(valid: Valid) -> dict[str, Case]:
    """Return a case for every public callable that runs on this machine, by its name."""
    callables, makers = public_callables(), instances(valid)
    found = {}
    for name, arguments in valid_arguments(valid).items():
        if (name in NEEDS and missing(NEEDS[name])) or (name.startswith(NEED_ADAPTER) and not has_adapter()):
            continue
        entry = callables[name.partition(" @")[0]]
        maker = makers.get(name) or makers.get(entry.owner or "", lambda: None)
        found[name] = Case(
            name,
            functools.partial(_made, entry, maker),
            arguments,
            tuple(dict.fromkeys([*entry.parameters, *arguments])),
        )
    return found
