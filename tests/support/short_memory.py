"""Calls with little memory: each runs in children whose address space is limited to parts of its real need.

`python -m tests.support.short_memory [NAME ...]` prints for each call its name and the exit codes of its children.
"""

from __future__ import annotations

import os
import resource
import sys
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np

import nearfar as nf

FRACTIONS = (0.1, 0.35, 0.6, 0.85, 2.0)
"""Parts of a call's need that remain above `HEADROOM`; the last one suffices."""

HEADROOM = 64 << 20
"""Bytes without which kernels begin no work."""

SIDE = 1600
"""Width and height of pictures, and square root of the number of rays; each of their arrays takes 10 MB or more."""

RESULT, REFUSAL, FAULT = 0, 3, 4
"""Exit codes of children: the call returned, raised a MemoryError, raised something else."""

Call = Callable[[], Any]


def calls(folder: Path, side: int) -> Iterator[tuple[str, Call]]:
    """Yield calls with their names; pictures have a width and height of `side`, files go to a folder."""
    small, large = grid(4), grid(side // 2)
    view = nf.Camera((0, 2, 4), fov=nf.Fov.symmetric(90), size=(side, side))
    rows = np.random.default_rng(1).normal(size=(side * side, 3))
    picture = np.tile(np.linspace(0, 1, side, dtype=np.float32), (side, 1))
    frame = nf.render(small, view, channels=("color", "range", "position"))
    flags = np.arange(large.triangle_count) % 3 == 0
    yield "render", lambda: nf.render(small, view, channels=("color", "range", "position", "normal"))
    yield "cast_rays", lambda: nf.cast_rays(small, (0, 4, 0), rows)
    yield "nearest_points", lambda: nf.nearest_points(small, rows)
    yield "reduce", lambda: nf.reduce(small, center=(0, 1, 0), r1=0.2, r2=0.4, face_size=side // 2)
    yield "trees", lambda: nf.cast_rays(grid(side // 2), (0, 4, 0), [(0, -1, 0)])
    yield "Scene.subset", lambda: large.subset(triangles=flags)
    yield "metrics.discontinuity", lambda: nf.metrics.discontinuity(frame)
    yield "metrics.tear", lambda: nf.metrics.tear(frame)
    yield "ssim", lambda: nf.ssim(picture, picture, data_range=1.0, full=True)
    yield "Frame.save", lambda: frame.save(folder / f"{os.getpid()}.exr")
    yield "morph", lambda: nf.morph(rows, center=(0, 0, 0), user=(0.1, 0, 0), r1=1, r2=2)
    out: dict[str, Any] = {"center": (0, 1.7, 0), "radii": (0.1, 0.5), "face_size": side // 256 * 64}
    yield "stream.export", lambda: nf.stream.export(large, folder / f"out{os.getpid()}", **out)


def grid(size: int) -> nf.Scene:
    """Return a scene of about `size` x `size` triangles on an uneven ground."""
    cells = max(1, int(size / np.sqrt(2)))
    x, z = np.meshgrid(np.linspace(-1, 1, cells + 1), np.linspace(-1, 1, cells + 1))
    vertices = np.stack([x, 0.1 * np.sin(9 * x) * np.cos(7 * z), z], -1).reshape(-1, 3).astype(np.float32)
    corner = (np.arange(cells)[:, None] * (cells + 1) + np.arange(cells)).reshape(-1, 1)
    below = corner + cells + 1
    faces = np.concatenate([np.hstack([corner, below, corner + 1]), np.hstack([corner + 1, below, below + 1])])
    return nf.Scene.from_arrays(vertices, faces.astype(np.uint32))


def outcomes(call: Call) -> list[int]:
    """Return the exit code of a child for each room: half of `HEADROOM`, and parts of the call's need beyond it."""
    reader, writer = os.pipe()
    status = child_status(lambda: os.write(writer, str(need(call)).encode()))
    os.close(writer)
    bytes_needed = int(os.read(reader, 100) or 0)
    os.close(reader)
    if status:
        return [status]
    rooms = [HEADROOM // 2, *(HEADROOM + int(fraction * bytes_needed) for fraction in FRACTIONS)]
    return [child_status(call, room) for room in rooms]


def need(call: Call) -> int:
    """Return the number of bytes by which the address space grows during a call."""
    before = address_space("VmSize")
    call()
    return address_space("VmPeak") - before


def child_status(call: Call, room: int | None = None) -> int:
    """Run a call in a child that may allocate `room` bytes; returns its exit code, negative for a signal."""
    child = os.fork()
    if child:
        return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    status = FAULT
    try:
        if room is not None:
            limit = address_space("VmSize") + room
            resource.setrlimit(resource.RLIMIT_AS, (limit, limit))
        call()
        status = RESULT
    except MemoryError:
        status = REFUSAL
    except BaseException as error:
        print(f"{type(error).__name__}: {error}", file=sys.stderr)
    finally:
        os._exit(status)


def address_space(name: str) -> int:
    """Return an entry of the process's status in bytes."""
    lines = Path("/proc/self/status").read_text(encoding="ascii").splitlines()
    return next(1024 * int(line.split()[1]) for line in lines if line.startswith(f"{name}:"))


def main() -> None:
    """Print the faults of all calls, or of those that the arguments name."""
    with tempfile.TemporaryDirectory() as folder:
        for _, call in calls(Path(folder), 256):
            call()  # loads modules, which processes without memory cannot
        for name, call in calls(Path(folder), SIDE):
            if sys.argv[1:] and name not in sys.argv[1:]:
                continue
            print(name, *outcomes(call), flush=True)


if __name__ == "__main__":
    main()
