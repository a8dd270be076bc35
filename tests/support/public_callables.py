"""Finds every public callable of nearfar: functions, constructors and methods of `nearfar` and its public modules."""

from __future__ import annotations

import inspect
import types
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

from numpy.lib.mixins import NDArrayOperatorsMixin

import nearfar as nf

SPECIAL = ("__call__", "__getitem__")
"""Methods without a name that callers reach by syntax, with arguments of their own."""


@dataclass(frozen=True)
class PublicCallable:
    """A function, constructor or method that a caller reaches by public names."""

    name: str
    """Qualified public name, such as "nearfar.Scene.load"."""
    owner: str | None
    """Public name of the class whose instances have the method; None for what is called without an instance."""
    target: Callable[..., Any] | None
    """The function that is called; None for methods, which need an instance."""
    signature: inspect.Signature

    @property
    def parameters(self) -> tuple[str, ...]:
        """Names of the parameters, without the instance, and without ``*args`` and ``**kwargs``."""
        variable = (inspect.Parameter.VAR_POSITIONAL, inspect.Parameter.VAR_KEYWORD)
        return tuple(p.name for p in self.signature.parameters.values() if p.kind not in variable)

    def on(self, instance: object) -> Callable[..., Any]:
        """Return what is called, of an instance for methods."""
        if self.target is not None:
            return self.target
        method: Callable[..., Any] = getattr(instance, self.name.rpartition(".")[2])
        return method


def public_callables() -> dict[str, PublicCallable]:
    """Return all public callables by name, each under the first public name that it has."""
    return {entry.name: entry for entry in _module(nf, "nearfar", set())}


def _module(module: types.ModuleType, name: str, seen: set[int]) -> Iterator[PublicCallable]:
    for member in module.__all__:
        value, public = getattr(module, member), f"{name}.{member}"
        if id(value) in seen:
            continue
        seen.add(id(value))
        if isinstance(value, types.ModuleType):
            yield from _module(value, public, seen)
        elif inspect.isclass(value):
            yield from _class(value, public)
        elif callable(value) and not _is_instance_of_ours(value):
            yield PublicCallable(public, None, value, inspect.signature(value))


def _is_instance_of_ours(value: object) -> bool:
    """Whether a callable is a public instance of a public class, such as a lens, whose methods count by its class."""
    return not isinstance(value, types.FunctionType) and type(value).__module__.startswith("nearfar")


def _class(kind: type, name: str) -> Iterator[PublicCallable]:
    if getattr(kind, "_is_protocol", False):
        return  # its methods are tested on the classes that have them
    if not issubclass(kind, BaseException):
        yield PublicCallable(name, None, kind, inspect.signature(kind))
    for member in dir(kind):
        if member.startswith("_") and member not in SPECIAL:
            continue
        if member == "__getitem__" and issubclass(kind, NDArrayOperatorsMixin):
            continue  # it indexes as NumPy's arrays do, with their messages
        holder = next((base for base in kind.__mro__ if member in vars(base)), None)
        if holder is None or not holder.__module__.startswith("nearfar") or getattr(holder, "_is_protocol", False):
            continue  # what a protocol does for its classes is tested on those that do more
        static, public = vars(holder)[member], f"{name}.{member}"
        if isinstance(static, classmethod | staticmethod):
            bound = getattr(kind, member)
            yield PublicCallable(public, None, bound, inspect.signature(bound))
        elif isinstance(static, types.FunctionType):
            whole = inspect.signature(static)
            own = whole.replace(parameters=list(whole.parameters.values())[1:])
            yield PublicCallable(public, name, None, own)
