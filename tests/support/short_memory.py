"""Public calls with little memory: each runs in children whose address space is limited to parts of its real need.

`python -m tests.support.short_memory STAGE [NAME ...]` prints for each call of a stage a line of JSON: its name and the
numbers of an `Outcome`. The stage "growing" has the calls of `growing_memory`, of all stages.
"""

from __future__ import annotations

import contextlib
import functools
import json
import os
import re
import resource
import shutil
import signal
import sys
import tempfile
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from tests.support import growing_memory, missing
from tests.support.valid_calls.calls import NAMES, arguments, callable_of, needs, target
from tests.support.valid_calls.objects import LARGE, ZONES, Valid
from tests.support.verdict import attempt

FRACTIONS = (0.1, 0.3, 0.5, 0.8)
"""Parts of a call's need beyond `HEADROOM` that remain."""

HEADROOM = 64 << 20
"""Bytes without which kernels begin no work."""

RESULT, REFUSAL, SHORTAGE, LEFTOVER, FAULT = 0, 3, 4, 5, 6
"""Exit codes of children: the call returned, raised MemoryError with a size, raised another exception about memory,
left files although it raised an exception, raised an exception about something else."""

Call = Callable[[], BaseException | None]
"""A call, which returns its exception."""

SECONDS = 300
"""CPU time after which a child counts as hung, and a tenth of the wall time for children that wait; the longest takes a
tenth of it."""

SIZE = re.compile(
    r"needs \d+ bytes|takes [\d.]+ GB|simplifying [\d,]+ triangles needs|Unable to allocate [\d.]+ [KMG]iB"
)
"""Sizes in messages of kernels, of Python code about a result or a package, and of NumPy."""

ABOUT_MEMORY = re.compile(r"[Mm]emory|[Aa]llocate|start new thread|Errno 12\b")
"""Parts of messages about memory of exceptions other than MemoryError."""

NOT_TRIED = {
    "Recentering.result": "the work runs in a thread of the parent, so its need depends on when the child begins",
    "metrics.flip": "the package flip-evaluator, which is not ours, ends the process itself without memory",
}
"""Calls that are not made, with the reasons."""

DRIVERS = ("adapter",)
"""Parts of the system whose libraries end the process themselves when memory is short."""

RESUMED = ("orthoview.build", "orthoview.OrthoTree.update")
"""Calls whose files remain after an exception, because a repeated call resumes the work."""

ENLARGED: dict[str, Any] = {
    "cells": (1500, 1500), "count": 3000, "face_size": 512, "height": 1024, "size": LARGE.size, "trees": 20_000,
}  # fmt: skip
"""Values of parameters in place of the small ones of valid calls."""


def enlarged(name: str, found: dict[str, Any]) -> dict[str, Any]:
    """Return the arguments of a call with larger pictures, maps and arrays."""
    changes: dict[str, Any] = {key: value for key, value in ENLARGED.items() if key in found}
    if isinstance(found.get("size"), int):
        changes["size"] = 1500
    if name in BENT:
        changes["method"] = "vertex"
    if name == "ReducedScene.trace":  # has no method, but rays of a user at the centre are straight
        changes["shot"] = replace(found["shot"], user=ZONES["center"])
    rows = {key: np.resize(found[key], (LARGE.rows, *np.shape(found[key])[1:])) for key in ROWS.get(name, "").split()}
    return {**found, **changes, **rows}


ROWS = {
    "RadialLens.derivative": "r", "RadialLens.distort": "r", "RadialLens.undistort": "r",
    "RadialLens.distort_points": "points", "RadialLens.undistort_points": "points",
    "Camera.project": "points",
}  # fmt: skip
"""Arrays that calls get with `LARGE.rows` rows."""

BENT = ("ReducedScene.render", "ReducedScene.render @levels", "Walk.render")
"""Calls that get a method, because by default they bend every ray of a user so far from the centre: minutes for a large
picture."""

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
    """Exit codes of children: with half of `HEADROOM`, and for large needs with fractions of it beyond `HEADROOM` and
    with twice of both, which suffices."""

    @property
    def needs_much(self) -> bool:
        """Whether the call's arrays are so large that parts of its need were tried."""
        return len(self.statuses) > 1


class Trial:
    """A call with its name, made in children that write files only to the current folder."""

    def __init__(self, name: str, call: Call) -> None:
        self._name, self._call = name, call

    def outcome(self, fractions: tuple[float, ...], least_bytes: int) -> Outcome:
        """Measure the call's need and run it with fractions of it if it is large enough."""
        reader, writer = os.pipe()
        with tempfile.TemporaryDirectory(dir=Path.cwd().parent) as backup:
            shutil.copytree(".", backup, copy_function=os.link, dirs_exist_ok=True)
            status = self._run(lambda: _measure(self._call, writer), Path(backup))
            os.close(writer)
            bytes_needed = int(os.read(reader, 100) or 0)
            os.close(reader)
            if status:
                return Outcome(0, [status])
            rooms = [HEADROOM // 2]
            if bytes_needed > least_bytes:
                rooms += [HEADROOM + int(fraction * bytes_needed) for fraction in fractions]
                rooms.append(2 * (HEADROOM + bytes_needed))
            return Outcome(bytes_needed, [self._run(self._call, Path(backup), room) for room in rooms])

    def _run(self, call: Call, backup: Path, room: int | None = None) -> int:
        """Run a call in a child that may allocate `room` bytes; returns its exit code, negative for a signal.

        The folder's files are then those of the backup again, so that each child begins with the same ones.
        """
        status = self._status(call, room)
        changed = [path for path in _files(Path()) if not _is_same(path, backup / path)]
        if changed and status in (REFUSAL, SHORTAGE) and not self._name.startswith(RESUMED):
            print(f"{self._name}: left {changed[0]} and {len(changed) - 1} more", file=sys.stderr)
            status = LEFTOVER
        for path in changed:
            path.unlink()
        for path in _files(backup):
            if not (here := path.relative_to(backup)).exists():
                here.parent.mkdir(parents=True, exist_ok=True)
                os.link(path, here)
        for folder in sorted((path for path in Path().rglob("*") if path.is_dir()), reverse=True):
            if not (backup / folder).exists():
                folder.rmdir()
        return status

    def _status(self, call: Call, room: int | None) -> int:
        child = os.fork()
        if child:
            return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
        status = FAULT
        try:
            signal.setitimer(signal.ITIMER_PROF, SECONDS)
            signal.alarm(10 * SECONDS)
            if room is not None:
                limit = address_space("VmSize") + room
                resource.setrlimit(resource.RLIMIT_AS, (limit, limit))
            error = call()
            status = RESULT if error is None else _status_of(error)
            if error is not None:
                place = "" if room is None else f" with {room >> 20} MiB"
                print(f"{self._name}{place}: {type(error).__name__}: {error}", file=sys.stderr)
        except BaseException as error:
            print(f"{self._name}: {type(error).__name__}: {error}", file=sys.stderr)
        finally:
            sys.stderr.flush()
            os._exit(status)


def _files(folder: Path) -> list[Path]:
    """Return the files in a folder and its folders."""
    return [path for path in folder.rglob("*") if not path.is_dir()]


def _is_same(path: Path, other: Path) -> bool:
    """Return whether two paths are one file; files are written aside and renamed, so that changed ones are new."""
    return other.exists() and path.samefile(other)


def _measure(call: Call, writer: int) -> BaseException | None:
    """Run a call and write the number of bytes by which the address space grows beyond `HEADROOM`."""
    before = address_space("VmSize")
    error = call()
    os.write(writer, str(max(0, address_space("VmPeak") - before - HEADROOM)).encode())
    return error


def _status_of(error: BaseException) -> int:
    """Return the exit code for an exception."""
    if isinstance(error, MemoryError) and SIZE.search(str(error)):
        return REFUSAL
    return SHORTAGE if _is_shortage(error) else FAULT


def _is_shortage(error: BaseException | None) -> bool:
    """Return whether an exception, or its cause, names a lack of memory."""
    if error is None:
        return False
    return (
        isinstance(error, MemoryError) or ABOUT_MEMORY.search(str(error)) is not None or _is_shortage(error.__cause__)
    )


def address_space(name: str) -> int:
    """Return an entry of the process's status in bytes."""
    lines = Path("/proc/self/status").read_text(encoding="ascii").splitlines()
    return next(1024 * int(line.split()[1]) for line in lines if line.startswith(f"{name}:"))


def names_of(stage: str) -> list[str]:
    """Return the names of a stage's calls that this system can make."""
    names = [name for name in NAMES if callable_of(name).stage == stage and name not in NOT_TRIED]
    names = [name for name in names if not {*DRIVERS} & {*needs(name)}]
    return [name for name in names if not any(map(missing, needs(name)))]


def trials(stage: str, chosen: list[str]) -> Iterator[tuple[str, Trial]]:
    """Yield the calls of a stage, or those chosen of them, with their names; files go to the current folder."""
    folder = Path.cwd()
    small = Valid(folder / "small")
    valid = Valid(folder / "large", scale=LARGE)
    is_growing = stage == "growing"
    for name in growing_memory.CALLS if is_growing else names_of(stage):
        if chosen and name not in chosen:
            continue
        plain = name.partition(" @")[0] if is_growing else name
        # Loads modules, which processes without memory cannot.
        attempt(target(plain, small), arguments(plain, small))
        found = arguments(plain, valid)
        found = {**found, **growing_memory.CALLS[name](valid)} if is_growing else enlarged(name, found)
        if "scene" in vars(valid):
            valid.scene.touches(valid.scene.bounds)  # Builds the trees once for all children.
        yield name, Trial(name, functools.partial(attempt, target(plain, valid), found))


def main() -> None:
    """Print the outcomes of the calls of a stage, or of those that the arguments name."""
    stage, *chosen = sys.argv[1:]
    with tempfile.TemporaryDirectory() as top, contextlib.chdir(top):
        Path("work").mkdir()
        os.chdir("work")
        for name in ("small", "large", "temporary"):
            Path(name).mkdir()
        tempfile.tempdir = str(Path("temporary").resolve())
        of_growing = (growing_memory.FRACTIONS, growing_memory.LEAST_BYTES)
        settings = of_growing if stage == "growing" else (FRACTIONS, HEADROOM // 4)
        for name, trial in trials(stage, chosen):
            print(json.dumps([name, *trial.outcome(*settings)]), flush=True)


if __name__ == "__main__":
    main()
