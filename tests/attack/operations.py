"""Calls of public callables whose results are compared between threads and processes, and after interruptions."""

from __future__ import annotations

import functools
import tempfile
from collections.abc import Iterable
from pathlib import Path

from tests.support import missing
from tests.support.hostile_calls import Call
from tests.support.valid_calls.calls import NAMES, needs
from tests.support.valid_calls.objects import BUSY, Valid

APART = (
    "gpu.", "stream.client.", "stream.collect.play", "orthoview.Flight.", "orthoview.build",
    "orthoview.OrthoTree.update",
    "datasets.factory", "view.", "write_tiles", "Recentering", "stream.simulate @seen", "Walk", "Regions.",
)  # fmt: skip
"""Prefixes of calls that change shared state, or take long."""

WRITERS = (
    ".save",
    ".export",
    ".begin",
    ".plot",
    ".show",
    ".explore",
    ".compact",
    ".to_json",
    "_equirectangular",
    "_splats",
)
"""Parts of names of calls that write files or draw on adapters and pages."""


@functools.cache
def operations() -> dict[str, Call]:
    """Return the deterministic calls by name."""
    valid = Valid(Path(tempfile.mkdtemp()), scale=BUSY)
    names = [name for name in NAMES if not name.startswith(APART) and not any(part in f".{name}" for part in WRITERS)]
    return {name: Call(name, valid) for name in names if not any(map(missing, needs(name)))}


def result(name: str) -> str:
    """Run an operation; returns the digest of its result."""
    return operations()[name].outcome()


@functools.cache
def expected(name: str) -> str:
    """Return the digest of an operation's result, from its first call in this process."""
    return result(name)


def wrong(names: Iterable[str], digests: Iterable[str]) -> list[str]:
    """Return names of operations whose results differ from the expected ones."""
    return [name for name, got in zip(names, digests, strict=True) if got != expected(name)]
