"""Client of the process that decodes Draco streams within limits of time and memory; one process serves all files."""

from __future__ import annotations

import atexit
import json
import math
import os
import signal
import subprocess
import sys
import threading
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base.errors import UnusableError

_PROGRAM = Path(__file__).with_name("draco_process.py")

_SECONDS, _SECONDS_PER_FACE = 1.0, 1e-5
"""CPU time that a stream may take, seconds. Valid streams take up to 1e-6 s per face."""

_MEMORY, _MEMORY_PER_BYTE = 64 << 20, 12
"""Bytes that a stream may take beside the program's own. Valid streams take up to 6 per decoded byte."""

_WALL_CLOCK_FACTOR = 20.0
"""Wall-clock limit as a multiple of the CPU time limit, for busy machines."""


@dataclass(frozen=True)
class Mesh:
    """A decoded stream."""

    faces: NDArray[np.uint32]
    """Corners (F, 3)."""
    attributes: Mapping[int, NDArray[Any]]
    """Rows (V, K) of each attribute by its `unique_id`."""


def start() -> None:
    """Start the process, unless it runs, so that it is ready when it is needed."""
    with _lock:
        _running()


def decode(data: bytes, size: int, face_count: int) -> Mesh:
    """Decode a stream; UnusableError if it is damaged or exceeds a limit.

    The expected bytes (`size`) and triangles (`face_count`) set the limits of memory and time.
    """
    seconds = _SECONDS + _SECONDS_PER_FACE * face_count
    request = {"bytes": len(data), "seconds": seconds, "memory": _MEMORY + _MEMORY_PER_BYTE * size}
    with _lock:
        # The process may just have ended after its idle timeout; then another one is asked.
        answer = _running().ask(request, data) or _running().ask(request, data)
    if answer is None:
        raise UnusableError("a process that decodes its Draco streams cannot be started")
    return answer


class _Process:
    """The decoding process."""

    def __init__(self) -> None:
        self.owner = os.getpid()
        self._child = subprocess.Popen(
            [sys.executable, "-P", _PROGRAM, json.dumps(sys.path)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            env=os.environ | {"OPENBLAS_NUM_THREADS": "1"},
            start_new_session=True,
        )

    @property
    def is_running(self) -> bool:
        """Whether the process runs and was started by this one: a fork must not share it."""
        return self.owner == os.getpid() and self._child.poll() is None

    def ask(self, request: dict[str, Any], data: bytes) -> Mesh | None:
        """Send a request and return the mesh; None if the process had ended before."""
        # On systems that cannot limit CPU time, the wall clock does.
        factor = _WALL_CLOCK_FACTOR if hasattr(signal, "setitimer") else 2.0
        watch = threading.Timer(factor * request["seconds"], self._child.kill)
        watch.daemon = True
        watch.start()
        try:
            return self._answer(request, data)
        except (OSError, EOFError):
            code = self._child.wait()
            if code in (0, 1):
                return None
            how = "takes too long" if -code in _TIME else f"ends its decoder (code {code})"
            raise UnusableError(f"a Draco stream of its meshes is damaged: it {how}") from None
        finally:
            watch.cancel()

    def _answer(self, request: dict[str, Any], data: bytes) -> Mesh:
        requests, answers = self._child.stdin, self._child.stdout
        assert requests is not None
        assert answers is not None
        requests.write(json.dumps(request).encode() + b"\n" + data)
        requests.flush()
        if not (line := answers.readline()):
            raise EOFError
        answer = json.loads(line)
        if "error" in answer:
            raise UnusableError(f"a Draco stream of its meshes is damaged: {answer['error']}")
        arrays = {number: (np.dtype(kind), tuple(shape)) for number, kind, shape in answer["attributes"]}

        def rows(kind: np.dtype[Any], shape: tuple[int, ...]) -> NDArray[Any]:
            size = kind.itemsize * math.prod(shape)
            if len(data := answers.read(size)) != size:
                raise EOFError
            return np.frombuffer(data, kind).reshape(shape)

        faces = rows(np.dtype(np.uint32), (answer["faces"], 3))
        return Mesh(faces, {number: rows(*type_and_shape) for number, type_and_shape in arrays.items()})

    def end(self) -> None:
        """Kill the process and close its pipes."""
        if self.owner != os.getpid():
            return
        self._child.kill()
        for stream in (self._child.stdin, self._child.stdout):
            assert stream is not None
            with suppress(OSError):  # data not written yet is not needed
                stream.close()
        self._child.wait()


_TIME = (getattr(signal, "SIGPROF", 0), getattr(signal, "SIGKILL", 0))
"""Signals that end a process that exceeds its time limit."""

_lock = threading.Lock()
_process: _Process | None = None


def _running() -> _Process:
    global _process
    if _process is None or not _process.is_running:
        if _process is not None:
            _process.end()
        _process = _Process()
    return _process


@atexit.register
def _end() -> None:
    if _process is not None:
        _process.end()
