"""Options of commands, and groups of them: a parameter whose type is a dataclass stands for the dataclass's fields."""

from __future__ import annotations

import functools
import inspect
import re
from collections.abc import Callable, Iterator
from contextlib import suppress
from contextvars import ContextVar
from copy import copy
from dataclasses import MISSING, Field, dataclass, field, fields, is_dataclass
from typing import Annotated, Any, Literal, get_args, get_origin, get_type_hints

import typer
from typer.models import ArgumentInfo

import nearfar as nf
from nearfar._base import check

Command = Callable[..., None]

_given_names: ContextVar[frozenset[str] | None] = ContextVar("names of the options on the command line", default=None)


class Options:
    """Base of groups of options. Creating a group computes all its cached properties, which checks the options."""

    def __post_init__(self) -> None:
        for name, _ in inspect.getmembers(type(self), lambda member: isinstance(member, functools.cached_property)):
            getattr(self, name)

    def given_options(self) -> list[str]:
        """Return the names of the options that the command line contains, even if their values are the defaults."""
        given = _given_names.get()
        if given is not None:
            return [member.name for member in fields(self) if member.name in given]  # type: ignore[arg-type]
        return [member.name for member in fields(self) if getattr(self, member.name) != member.default]  # type: ignore[arg-type]

    def refuse(self, where: str) -> None:
        """Raise ValueError if an option was given; `where` says why the group has no meaning."""
        for name in self.given_options():
            raise ValueError(f"{name}: expected none {where}")


def option(default: Any, metavar: str | None, text: str, names: str = "") -> Any:
    """Describe an option, as the default of a parameter or of a group's field.

    `default` is the value without the option; `...` makes the option required. `metavar` is the placeholder for the
    value in the help; for a `Literal` it lists the values. `names` of the option are separated by spaces; by default
    the name follows from the parameter's, as in --face-size for `face_size`.
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
    """Return a command in which each group among the parameters is replaced by an option for each of its fields.

    The parameters of `function` are options or groups of options. Groups are created before the function is called, so
    that they can check their options. Values that a `Literal` type does not list are refused. In error messages, the
    name of a parameter or field at the beginning, and name='value', are replaced by the option. The value of --input
    can also be the command's argument, unless the command has another one. `defaults` override defaults of options, by
    name.
    """
    groups: dict[str, list[str]] = {}
    options: dict[str, _Option] = {}
    hints = get_type_hints(function, include_extras=True)
    for parameter in inspect.signature(function).parameters.values():
        members = {option.name: option for option in _options(hints[parameter.name], parameter)}
        options |= members
        if is_dataclass(hints[parameter.name]):
            groups[parameter.name] = list(members)

    has_argument = any(isinstance(info, ArgumentInfo) for option in options.values() for info in option.infos)
    source = next((option for option in options.values() if option.flag == "--input" and not has_argument), None)

    @functools.wraps(function)
    def command(*, context: typer.Context, **values: Any) -> None:
        sources = {name: context.get_parameter_source(name) for name in values}
        given = (name for name, place in sources.items() if place is not None and place.name != "DEFAULT")
        token = _given_names.set(frozenset(given))
        try:
            if source is not None:
                values[source.name] = source.choose_input(values.pop(_ARGUMENT), values[source.name])
            for name, value in values.items():
                if options[name].values and value is not None:
                    check.choice(options[name].flag, value, options[name].values)
            arguments = {name: hints[name](**{key: values.pop(key) for key in keys}) for name, keys in groups.items()}
            function(**arguments, **values)
        except (ValueError, nf.Error) as error:
            error.args = (_with_flags(str(error), {name: option.flag for name, option in options.items()}),)
            raise
        finally:
            _given_names.reset(token)

    if source is not None:
        source.default = defaults.get(source.name, source.default)
        defaults = defaults | {source.name: None}
    parameters = [source.argument()] if source is not None else []
    parameters += [option.parameter(defaults.get(name, option.default)) for name, option in options.items()]
    parameters.append(inspect.Parameter("context", inspect.Parameter.KEYWORD_ONLY, annotation=typer.Context))
    command.__signature__ = inspect.Signature(parameters)  # type: ignore[attr-defined]
    command.__annotations__ = {parameter.name: parameter.annotation for parameter in parameters}
    return command


def _with_flags(message: str, flags: dict[str, str]) -> str:
    """Replace parameters by options, given by name: at the beginning before a colon, and in name=value and name=.

    A path before the first colon stays as it is, and so do values that no option takes.
    """

    def replace(found: re.Match[str]) -> str:
        if found["name"] not in flags or found["value"] == "False":
            return found[0]
        value = found["value"].strip("'\"")
        return flags[found["name"]] + ("" if value in ("", "True") else f" {value}") + found["end"]

    message = re.sub(r"^(?P<name>\w+)(?P<value>)(?P<end>(\[\d+\])?: )", replace, message)
    start, colon, rest = message.partition(": ")
    if "/" not in start or not colon:
        start, colon, rest = "", "", message
    value = r"(?P<value>(?>'[^']*'|\"[^\"]*\"|[\w.+-]*\w|))(?P<end>)(?![\w(\[])"
    assigned = rf"(?<![^\s(])(?<!\w\()(?P<name>[a-z]\w*)={value}"
    return start + colon + re.sub(assigned, replace, rest)


_NO_DEFAULTS = (MISSING, inspect.Parameter.empty, None)

_ARGUMENT = "input_argument"
"""Parameter of commands for the argument that stands for --input."""


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
            elif part is int and infos:
                infos = [copy(info) for info in infos]
                infos[0].parser = whole_number
                self.kind = Annotated[kind, *infos]

    @property
    def infos(self) -> tuple[Any, ...]:
        """Typer's descriptions of the option."""
        return getattr(self.kind, "__metadata__", ())

    @property
    def flag(self) -> str:
        """Long name."""
        names = [name for info in self.infos for name in info.param_decls or () if name.startswith("--")]
        return names[0].partition("/")[0] if names else f"--{self.name.replace('_', '-')}"

    def argument(self) -> inspect.Parameter:
        """Return the parameter of a command's argument that stands for this option."""
        (info,) = self.kind.__metadata__
        text = info.help if self.default in _NO_DEFAULTS else f"{info.help} By default {self.default}."
        kind = Annotated[str | None, typer.Argument(metavar=info.metavar, help=text, show_default=False)]
        option_info = copy(info)
        option_info.help = "The same as the argument."
        self.kind = Annotated[str | None, option_info]
        return inspect.Parameter(_ARGUMENT, inspect.Parameter.KEYWORD_ONLY, default=None, annotation=kind)

    def choose_input(self, argument: str | None, value: str | None) -> str | None:
        """Return the input, from the argument or the option; BadParameter for both, or for none if one is required."""
        if argument is not None and value is not None:
            raise typer.BadParameter(f"expected one of {argument} and {value}", param_hint="--input")
        chosen = value if argument is None else argument
        if chosen is None and self.default in (MISSING, inspect.Parameter.empty):
            raise typer.BadParameter("expected a file or one of the built-in scenes", param_hint="--input")
        return self.default if chosen is None else chosen

    def parameter(self, default: Any) -> inspect.Parameter:
        empty = inspect.Parameter.empty
        default = empty if default is MISSING else default
        return inspect.Parameter(self.name, inspect.Parameter.KEYWORD_ONLY, default=default, annotation=self.kind)


def whole_number(text: str | int) -> int:
    """Convert a text such as 1000000 or 1e6 to a whole number, as Python arguments are; BadParameter otherwise."""
    try:
        return int(text)
    except ValueError:
        with suppress(ValueError):
            if (number := float(text)).is_integer():
                return int(number)
    raise typer.BadParameter(f"{text!r} is not a valid integer.")


def _options(kind: Any, parameter: inspect.Parameter) -> Iterator[_Option]:
    """Yield the options of a parameter: itself, or the fields of its group."""
    if not is_dataclass(kind):
        yield _Option(parameter.name, kind, parameter.default)
        return
    hints = get_type_hints(kind, include_extras=True)
    for member in fields(kind):
        yield _Option(member.name, hints[member.name], member if member.metadata else member.default)
