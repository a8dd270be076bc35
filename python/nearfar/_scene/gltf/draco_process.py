"""Program of the process in which `draco.py` runs DracoPy; it imports nothing from nearfar.

Damaged streams can keep Draco busy for half a minute or make it allocate much memory, and neither can be stopped in a
process that does other work. Requests and responses are a line of JSON and bytes, on the standard streams.
"""

from __future__ import annotations

import json
import select
import signal
import sys
import time
from typing import Any, BinaryIO

IDLE = 30.0
"""Idle timeout after which the process ends, seconds."""

SHORT_OF_MEMORY = 3
"""Exit code of a process that has too little memory for a request or its answer."""


def main() -> None:
    """Answer requests until the input ends or the idle timeout has passed."""
    sys.path[:] = json.loads(sys.argv[1])
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    import DracoPy  # before the first limit, since it imports NumPy

    requests, answers = sys.stdin.buffer, sys.stdout.buffer
    while _is_ready(requests):
        if not (line := requests.readline()):
            return
        request = json.loads(line)
        data = requests.read(request["bytes"])
        limits = _Limits(request["seconds"], request["memory"])
        try:
            with limits:
                header, arrays = _header_and_arrays(DracoPy.decode(data))
        except MemoryError:
            # Only a limit that was set for this file blames the file; otherwise the machine is short of memory.
            header, arrays = {"error": "it takes too much memory", "short": not limits.limits_memory}, []
        except Exception as error:  # DracoPy raises errors of several types
            header, arrays = {"error": str(error)}, []
        answers.write(json.dumps(header).encode() + b"\n")
        for array in arrays:
            answers.write(array.data)
        answers.flush()


def _is_ready(stream: BinaryIO) -> bool:
    """Wait for a request; systems without `select` on pipes wait in `readline`."""
    try:
        return bool(select.select([stream], [], [], IDLE)[0])
    except OSError:
        return True


class _Limits:
    """Context that limits CPU time and memory.

    The timer of the CPU time ends the process, but only at a tick of the clock. Work that exceeds the limit and still
    ends before a tick raises a TimeoutError.
    """

    def __init__(self, seconds: float, memory: int) -> None:
        self._seconds, self._memory, self._begin = seconds, memory, 0.0
        self.limits_memory = False

    def __enter__(self) -> None:
        if hasattr(signal, "setitimer"):
            signal.signal(signal.SIGPROF, signal.SIG_DFL)
            signal.setitimer(signal.ITIMER_PROF, self._seconds)
        self.limits_memory = self._limit(self._memory)
        self._begin = time.process_time()

    def __exit__(self, error: object, *_: object) -> None:
        if hasattr(signal, "setitimer"):
            signal.setitimer(signal.ITIMER_PROF, 0)
        self._limit(None)
        if error is None and time.process_time() - self._begin > self._seconds:
            raise TimeoutError("it takes too long")

    @staticmethod
    def _limit(memory: int | None) -> bool:
        """Limit memory, or remove the limit; returns whether the system allows this limit."""
        try:
            import resource

            with open("/proc/self/statm") as file:
                used = int(file.read().split()[0]) * resource.getpagesize()
            max_bytes = resource.getrlimit(resource.RLIMIT_AS)[1]
            resource.setrlimit(resource.RLIMIT_AS, (max_bytes if memory is None else used + memory, max_bytes))
        except (ImportError, OSError, ValueError):
            return False  # not Linux, or the system's own limit is lower
        return True


def _header_and_arrays(mesh: Any) -> tuple[dict[str, Any], list[Any]]:
    import numpy as np

    faces = np.ascontiguousarray(getattr(mesh, "faces", np.zeros((0, 3))), np.uint32)
    arrays = {item["unique_id"]: np.ascontiguousarray(item["data"]) for item in mesh.attributes}
    descriptions = [[number, rows.dtype.str, list(rows.shape)] for number, rows in arrays.items()]
    return {"faces": len(faces), "attributes": descriptions}, [faces, *arrays.values()]


if __name__ == "__main__":
    try:
        main()
    except MemoryError:
        sys.exit(SHORT_OF_MEMORY)
