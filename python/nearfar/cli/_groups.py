"""Groups of options: a command's parameter whose type is a dataclass stands for the dataclass's fields."""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable, Iterator
from dataclasses import fields, is_dataclass
from typing import Any, get_type_hints

Command = Callable[..., None]


class Options:
    """Base of groups; values that a group derives from its options are computed, and so checked, when it is made."""

    def __post_init__(self) -> None:
        for name, _ in inspect.getmembers(type(self), lambda member: isinstance(member, functools.cached_property)):
            getattr(self, name)


def expand(function: Command, **defaults: Any) -> Command:
    """Return a command with an option for each field of its groups, in their place among its parameters.

    Parameters
    ----------
    function
        A function whose parameters are options, or groups of them. A group is made from its options before the
        function is called, so that it can check them.
    defaults
        Other defaults of options, by name.
    """
    groups: dict[str, list[str]] = {}
    parameters: list[inspect.Parameter] = []
    hints = get_type_hints(function, include_extras=True)
    for parameter in inspect.signature(function).parameters.values():
        options = list(_options(hints[parameter.name], parameter))
        parameters += [option.replace(default=defaults.get(option.name, option.default)) for option in options]
        if is_dataclass(hints[parameter.name]):
            groups[parameter.name] = [option.name for option in options]

    @functools.wraps(function)
    def command(**values: Any) -> None:
        made = {name: hints[name](**{key: values.pop(key) for key in keys}) for name, keys in groups.items()}
        function(**made, **values)

    command.__signature__ = inspect.Signature(parameters)  # type: ignore[attr-defined]
    command.__annotations__ = {parameter.name: parameter.annotation for parameter in parameters}
    return command


def _options(kind: Any, parameter: inspect.Parameter) -> Iterator[inspect.Parameter]:
    """Yield the options of a parameter: itself, or the fields of its group."""
    if not is_dataclass(kind):
        yield parameter.replace(annotation=kind, kind=inspect.Parameter.KEYWORD_ONLY)
        return
    hints = get_type_hints(kind, include_extras=True)
    for field in fields(kind):
        yield inspect.Parameter(
            field.name, inspect.Parameter.KEYWORD_ONLY, default=field.default, annotation=hints[field.name]
        )
