"""Tests that public names exist, have documentation and few positional arguments, and that the stub contains every
binding."""

from __future__ import annotations

import ast
import inspect
import re
import types
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import nearfar as nf
from nearfar import _core

STUB = Path(__file__).resolve().parents[2] / "python" / "nearfar" / "_core"


def public() -> Iterator[tuple[str, Any]]:
    """Yield all names of `nearfar.__all__` and the public methods of its classes."""
    for name in nf.__all__:
        value = getattr(nf, name)
        yield name, value
        if inspect.isclass(value):
            for member, attribute in vars(value).items():
                if not member.startswith("_") and (
                    callable(attribute) or isinstance(attribute, classmethod | property)
                ):
                    yield f"{name}.{member}", getattr(value, member)


def test_all_names_exist_once_and_in_order() -> None:
    assert len(set(nf.__all__)) == len(nf.__all__)
    assert [name for name in nf.__all__ if not hasattr(nf, name)] == []


@pytest.mark.parametrize(("name", "value"), [item for item in public() if item[0] != "__version__"])
def test_public_names_are_documented(name: str, value: Any) -> None:
    text = inspect.getdoc(value)
    assert text, name
    # Functions document each argument; methods and named constructors may use a sentence or two.
    if isinstance(value, types.FunctionType) and "." not in name:
        arguments = list(inspect.signature(value).parameters)
        assert "\nParameters\n" in text, f"{name}: expected a section Parameters"
        section = text.partition("\nParameters\n")[2]
        missing = [a for a in arguments if not re.search(rf"(?<!\w){re.escape(a)}(?!\w)", section)]
        assert missing == [], f"{name}: says nothing of {missing}"


@pytest.mark.parametrize("name", nf.__all__)
def test_most_arguments_are_keyword_only(name: str) -> None:
    """Arguments after the first two or three are keyword-only, so that a call names its numbers."""
    value = getattr(nf, name)
    if isinstance(value, types.FunctionType):
        kinds = [p.kind for p in inspect.signature(value).parameters.values()]
        positional = kinds.count(inspect.Parameter.POSITIONAL_OR_KEYWORD)
        assert positional <= 3, f"{name} takes {positional} positional arguments"


def test_every_binding_is_in_the_stub() -> None:
    parts = [ast.parse(path.read_text(encoding="utf-8")) for path in STUB.glob("*.pyi")]
    named = {node.name for part in parts for node in part.body if isinstance(node, ast.FunctionDef | ast.ClassDef)}
    assert {name for name in dir(_core) if not name.startswith("__")} == named
