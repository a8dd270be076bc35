"""Finds every public callable of nearfar: functions, constructors and methods of `nearfar` and its public modules.

Constructors of results are excluded: records that accept anything, because only the package makes them.
"""

from __future__ import annotations

import inspect
import types
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

from numpy.lib.mixins import NDArrayOperatorsMixin

import nearfar as nf

SPECIAL = ("__call__", "__getitem__")
"""Methods without a name that callers reach by syntax, with their own arguments."""


@dataclass(frozen=True)
class PublicCallable:
    """A function, constructor or method that a caller reaches by public names."""

    name: str
    """Public name without the package's, such as "Scene.load"."""
    stage: str
    """Name of the stage that it belongs to."""
    owner: str | None
    """Public name of the class whose instances have the method; None for functions without an instance."""
    target: Callable[..., Any] | None
    """The called function; None for methods, which need an instance."""
    signature: inspect.Signature

    @property
    def parameters(self) -> dict[str, inspect.Parameter]:
        """The parameters by name, without the instance, and without ``*args`` and ``**kwargs``."""
        variable = (inspect.Parameter.VAR_POSITIONAL, inspect.Parameter.VAR_KEYWORD)
        return {p.name: p for p in self.signature.parameters.values() if p.kind not in variable}

    def on(self, instance: object) -> Callable[..., Any]:
        """Return the callable, bound to an instance for methods."""
        if self.target is not None:
            return self.target
        method: Callable[..., Any] = getattr(instance, self.name.rpartition(".")[2])
        return method


def public_callables() -> dict[str, PublicCallable]:
    """Return all public callables by name, each under its first public name."""
    return {entry.name: entry for entry in _module(nf, "", set())}


def _stage(value: Any) -> str:
    """The stage of a class or a function."""
    stage: str = value.__module__.split(".")[1]
    return stage.lstrip("_")


def _module(module: types.ModuleType, name: str, seen: set[int]) -> Iterator[PublicCallable]:
    for member in module.__all__:
        value, public = getattr(module, member), f"{name}{member}"
        if id(value) in seen:
            continue
        seen.add(id(value))
        if isinstance(value, types.ModuleType):
            yield from _module(value, f"{public}.", seen)
        elif inspect.isclass(value):
            yield from _class(value, public)
        elif callable(value) and not _is_instance_of_ours(value):
            yield PublicCallable(public, _stage(value), None, value, inspect.signature(value))


def _is_instance_of_ours(value: object) -> bool:
    """Whether a callable is a public instance of a public class, such as a lens, whose methods count by its class."""
    return not isinstance(value, types.FunctionType) and type(value).__module__.startswith("nearfar")


def _is_record(kind: type) -> bool:
    """Whether a class is a tuple, or a dataclass whose constructor checks nothing."""
    settings = getattr(kind, "__dataclass_params__", None)
    is_plain = settings is not None and settings.init and not hasattr(kind, "__post_init__")
    return is_plain or issubclass(kind, tuple)


def _class(kind: type, name: str) -> Iterator[PublicCallable]:
    if getattr(kind, "_is_protocol", False):
        return  # Its methods are tested on the classes that have them.
    if not issubclass(kind, BaseException) and not _is_record(kind):
        yield PublicCallable(name, _stage(kind), None, kind, inspect.signature(kind))
    for member in dir(kind):
        if member.startswith("_") and member not in SPECIAL:
            continue
        if member == "__getitem__" and issubclass(kind, NDArrayOperatorsMixin):
            continue  # It indexes like NumPy's arrays, with their messages.
        holder = next((base for base in kind.__mro__ if member in vars(base)), None)
        if holder is None or not holder.__module__.startswith("nearfar") or getattr(holder, "_is_protocol", False):
            continue  # Default methods of a protocol are tested on classes that override others.
        static, public = vars(holder)[member], f"{name}.{member}"
        if isinstance(static, classmethod | staticmethod):
            bound = getattr(kind, member)
            yield PublicCallable(public, _stage(kind), None, bound, inspect.signature(bound))
        elif isinstance(static, types.FunctionType):
            whole = inspect.signature(static)
            own = whole.replace(parameters=list(whole.parameters.values())[1:])
            yield PublicCallable(public, _stage(kind), name, None, own)
