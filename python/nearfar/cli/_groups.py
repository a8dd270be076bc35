"""Options of commands, and groups of them: a parameter whose type is a dataclass stands for the dataclass's fields."""

from __future__ import annotations

import functools
import inspect
import re
from collections.abc import Callable, Iterator
from copy import copy
from dataclasses import MISSING, Field, dataclass, field, fields, is_dataclass
from typing import Annotated, Any, Literal, get_args, get_origin, get_type_hints

import typer

from nearfar._base import check

Command = Callable[..., None]


class Options:
    """Base of groups; values that a group derives from its options are computed, and so checked, when it is made."""

    def __post_init__(self) -> None:
        for name, _ in inspect.getmembers(type(self), lambda member: isinstance(member, functools.cached_property)):
            getattr(self, name)

    def changed_options(self) -> list[str]:
        """Return the names of options whose values differ from their defaults."""
        return [member.name for member in fields(self) if getattr(self, member.name) != member.default]  # type: ignore[arg-type]

    def refuse(self, where: str) -> None:
        """Raise ValueError if an option was given that has no meaning `where`."""
        for name in self.changed_options():
            raise ValueError(f"{name}: expected none {where}")


def option(default: Any, metavar: str | None, text: str, names: str = "") -> Any:
    """Describe an option, as the default of a parameter or of a group's field.

    `default` is the value without the option; `...` if it must be given. `metavar` is the placeholder for the value in
    the help; that of a `Literal` lists its values. `names` of the option are separated by spaces; by default the
    parameter's, as in --face-size for `face_size`.
    """
    info = typer.Option(*names.split(), metavar=metavar, help=text)
    return field(default=MISSING if default is ... else default, metadata={"info": info})


def choice(default: Any, text: str) -> Any:
    """Describe an option whose type is a `Literal`, or such a type and None."""
    return option(default, None, text)


def flag(name: str, text: str) -> Any:
    """Describe an option without a value, False by default: its name and its help text."""
    return option(False, None, text, name)


def expand(function: Command, **defaults: Any) -> Command:
    """Return a command with an option for each field of its groups, in their place among its parameters.

    The parameters of `function` are options, or groups of them. A group is made from its options before the function is
    called, so that it can check them. Values that a `Literal` type does not list are refused. Errors that begin with
    the name of a parameter or of a field begin with the name of its option instead. `defaults` are other defaults of
    options, by name.
    """
    groups: dict[str, list[str]] = {}
    options: dict[str, _Option] = {}
    hints = get_type_hints(function, include_extras=True)
    for parameter in inspect.signature(function).parameters.values():
        members = {option.name: option for option in _options(hints[parameter.name], parameter)}
        options |= members
        if is_dataclass(hints[parameter.name]):
            groups[parameter.name] = list(members)

    @functools.wraps(function)
    def command(**values: Any) -> None:
        try:
            for name, value in values.items():
                if options[name].values and value is not None:
                    check.choice(options[name].flag, value, options[name].values)
            arguments = {name: hints[name](**{key: values.pop(key) for key in keys}) for name, keys in groups.items()}
            function(**arguments, **values)
        except ValueError as error:
            begin = re.match(r"\w+(?=(\[\d+\])?: )", str(error))
            if begin is None or begin[0] not in options:
                raise
            raise ValueError(options[begin[0]].flag + str(error)[begin.end() :]) from None

    parameters = [option.parameter(defaults.get(name, option.default)) for name, option in options.items()]
    command.__signature__ = inspect.Signature(parameters)  # type: ignore[attr-defined]
    command.__annotations__ = {parameter.name: parameter.annotation for parameter in parameters}
    return command


@dataclass
class _Option:
    """An option of a command, for Typer."""

    name: str
    kind: Any
    """Its type, annotated with its description."""
    default: Any
    values: tuple[str, ...] = ()
    """Permitted values; empty for any."""

    def __post_init__(self) -> None:
        if isinstance(self.default, Field):
            self.kind, self.default = Annotated[self.kind, self.default.metadata["info"]], self.default.default
        kind, *infos = get_args(self.kind) if get_origin(self.kind) is Annotated else (self.kind,)
        for part in (kind, *get_args(kind)):
            if get_origin(part) is Literal:
                self.values = get_args(part)
                infos = [copy(info) for info in infos]
                infos[0].metavar = "|".join(self.values)
                self.kind = Annotated[str if part is kind else str | None, *infos]

    @property
    def flag(self) -> str:
        """Long name."""
        infos = getattr(self.kind, "__metadata__", ())
        names = [name for info in infos for name in info.param_decls or () if name.startswith("--")]
        return names[0].partition("/")[0] if names else f"--{self.name.replace('_', '-')}"

    def parameter(self, default: Any) -> inspect.Parameter:
        empty = inspect.Parameter.empty
        default = empty if default is MISSING else default
        return inspect.Parameter(self.name, inspect.Parameter.KEYWORD_ONLY, default=default, annotation=self.kind)


def _options(kind: Any, parameter: inspect.Parameter) -> Iterator[_Option]:
    """Yield the options of a parameter: itself, or the fields of its group."""
    if not is_dataclass(kind):
        yield _Option(parameter.name, kind, parameter.default)
        return
    hints = get_type_hints(kind, include_extras=True)
    for member in fields(kind):
        yield _Option(member.name, hints[member.name], member if member.metadata else member.default)
