"""Public calls with little memory: each runs in children whose address space is limited to parts of its real need.

`python -m tests.support.short_memory STAGE [--small] [NAME ...]` prints for each call of a stage a line of JSON: its
name and the numbers of an `Outcome`.
"""

from __future__ import annotations

import contextlib
import functools
import json
import os
import re
import resource
import signal
import sys
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from tests.support import missing
from tests.support.valid_calls.calls import NAMES, arguments, callable_of, needs, target
from tests.support.valid_calls.objects import LARGE, Valid
from tests.support.verdict import attempt

FRACTIONS = (0.1, 0.3, 0.5, 0.8)
"""Parts of a call's need beyond `HEADROOM` that remain."""

HEADROOM = 64 << 20
"""Bytes without which kernels begin no work."""

RESULT, REFUSAL, FAULT = 0, 3, 4
"""Exit codes of children: the call returned, raised an exception about memory, raised something else."""

Call = Callable[[], BaseException | None]
"""A call, which returns its exception."""

SECONDS = 120
"""Time after which a child counts as hung; the longest takes a tenth."""

SHORTAGE = re.compile(r"[Mm]emory|[Aa]llocate|start new thread|Errno 12\b")
"""Parts of messages about memory of exceptions other than MemoryError."""

DRIVERS = ("adapter",)
"""Parts of the system whose libraries end the process themselves when memory is short."""

ENLARGED: dict[str, Any] = {
    "cells": (1500, 1500), "count": 3000, "face_size": 512, "height": 1024, "size": LARGE.size, "trees": 20_000,
}  # fmt: skip
"""Values of parameters in place of the small ones of valid calls."""


def enlarged(name: str, found: dict[str, Any]) -> dict[str, Any]:
    """Return the arguments of a call with larger pictures, maps and arrays."""
    changes: dict[str, Any] = {key: value for key, value in ENLARGED.items() if key in found}
    if isinstance(found.get("size"), int):
        changes["size"] = 1500
    rows = {key: np.resize(found[key], (LARGE.rows, *np.shape(found[key])[1:])) for key in ROWS.get(name, "").split()}
    return {**found, **changes, **rows, **OWN.get(name, {})}


ROWS = {
    "RadialLens.derivative": "r", "RadialLens.distort": "r", "RadialLens.undistort": "r",
    "RadialLens.distort_points": "points", "RadialLens.undistort_points": "points",
    "Camera.project": "points",
}  # fmt: skip
"""Arrays that calls get with `LARGE.rows` rows."""

OWN: dict[str, dict[str, Any]] = {}
"""Other arguments of single calls."""

LARGEST = {
    "bounds": "bounding_sphere bounding_spheres", "lens": "ChromaticLens.warp_mesh RadialLens.warp_mesh",
    "metrics": "metrics.discontinuity", "morph": "morph", "stream": "stream.export",
    "trace": "cast_rays nearest_points",
}  # fmt: skip
"""Calls of each stage that must need much memory, so that the inputs stay large enough."""


class Outcome(NamedTuple):
    """Memory that a call needs, and how it ended with less."""

    bytes_needed: int
    """Bytes beyond `HEADROOM`."""
    statuses: list[int]
    """Exit codes of children: with half of `HEADROOM`, and for large needs with `FRACTIONS` of it beyond `HEADROOM` and
    with twice of both, which suffices."""

    @property
    def needs_much(self) -> bool:
        """Whether the call's arrays are so large that parts of its need were tried."""
        return len(self.statuses) > 1


def outcome(call: Call) -> Outcome:
    """Run a call in children."""
    reader, writer = os.pipe()
    status = child_status(lambda: measured(call, writer))
    os.close(writer)
    bytes_needed = int(os.read(reader, 100) or 0)
    os.close(reader)
    if status:
        return Outcome(0, [status])
    rooms = [HEADROOM // 2]
    if bytes_needed > HEADROOM // 4:
        rooms += [HEADROOM + int(fraction * bytes_needed) for fraction in FRACTIONS]
        rooms.append(2 * (HEADROOM + bytes_needed))
    return Outcome(bytes_needed, [child_status(call, room) for room in rooms])


def measured(call: Call, writer: int) -> BaseException | None:
    """Run a call and write the number of bytes by which the address space grows beyond `HEADROOM`."""
    before = address_space("VmSize")
    error = call()
    os.write(writer, str(max(0, address_space("VmPeak") - before - HEADROOM)).encode())
    return error


def child_status(call: Call, room: int | None = None) -> int:
    """Run a call in a child that may allocate `room` bytes; returns its exit code, negative for a signal."""
    child = os.fork()
    if child:
        return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    status = FAULT
    try:
        signal.alarm(SECONDS)
        if room is not None:
            limit = address_space("VmSize") + room
            resource.setrlimit(resource.RLIMIT_AS, (limit, limit))
        error = call()
        status = RESULT if error is None else REFUSAL if is_shortage(error) else FAULT
        if status == FAULT:
            print(f"{type(error).__name__}: {error}", file=sys.stderr)
    except BaseException as error:
        print(f"{type(error).__name__}: {error}", file=sys.stderr)
    finally:
        os._exit(status)


def is_shortage(error: BaseException | None) -> bool:
    """Return whether an exception, or its cause, names a lack of memory."""
    if error is None:
        return False
    return isinstance(error, MemoryError) or SHORTAGE.search(str(error)) is not None or is_shortage(error.__cause__)


def address_space(name: str) -> int:
    """Return an entry of the process's status in bytes."""
    lines = Path("/proc/self/status").read_text(encoding="ascii").splitlines()
    return next(1024 * int(line.split()[1]) for line in lines if line.startswith(f"{name}:"))


def names_of(stage: str) -> list[str]:
    """Return the names of a stage's calls that this system can make."""
    names = [name for name in NAMES if callable_of(name).stage == stage and not {*DRIVERS} & {*needs(name)}]
    return [name for name in names if not any(map(missing, needs(name)))]


def calls(stage: str, folder: Path, *, is_large: bool) -> Iterator[tuple[str, Call]]:
    """Yield the calls of a stage with their names; files go to a folder."""
    small = Valid(folder / "small")
    valid = Valid(folder / "large", scale=LARGE) if is_large else small
    for name in names_of(stage):
        # Loads modules, which processes without memory cannot.
        attempt(target(name, small), arguments(name, small))
        given = arguments(name, valid)
        if is_large and "scene" in vars(valid):
            valid.scene.touches(valid.scene.bounds)  # Builds the trees once for all children.
        yield name, functools.partial(attempt, target(name, valid), enlarged(name, given) if is_large else given)


def main() -> None:
    """Print the outcomes of the calls of a stage, or of those that the arguments name."""
    stage, *options = sys.argv[1:]
    chosen = [option for option in options if option != "--small"]
    with tempfile.TemporaryDirectory() as folder, contextlib.chdir(folder):
        for valid_folder in ("small", "large"):
            Path(folder, valid_folder).mkdir()
        for name, call in calls(stage, Path(folder), is_large="--small" not in options):
            if not chosen or name in chosen:
                print(json.dumps([name, *outcome(call)]), flush=True)


if __name__ == "__main__":
    main()
