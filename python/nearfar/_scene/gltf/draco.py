"""Decodes primitives of glTF files compressed by Draco: KHR_draco_mesh_compression.

A separate process decodes streams within limits of time and memory; it serves all files.
"""

from __future__ import annotations

import atexit
import json
import math
import os
import re
import signal
import subprocess
import sys
import threading
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base.errors import UnusableError
from nearfar._base.glb import entry
from nearfar._scene.budget import Budget
from nearfar._scene.gltf.buffers import WIDTHS, component
from nearfar._scene.gltf.corners import TRIANGLES, mode
from nearfar._scene.gltf.draco_process import SHORT_OF_MEMORY

DRACO = "KHR_draco_mesh_compression"

_READ = re.compile("POSITION|NORMAL|COLOR_0|(TEXCOORD|JOINTS|WEIGHTS)_[0-9]+")
"""Names of supported attributes."""

_CORNERS, _FACE_BYTES = 3, 12
"""Corners and bytes of a face."""

_DECODER_FACTOR = 2
"""Bytes counted against the budget per decoded byte; Draco uses up to six while it decodes."""

_VERSION, _MESH, _SEQUENTIAL, _EDGEBREAKER = (2, 2), 1, 0, 1
_HAS_METADATA = 0x8000

_PROGRAM = Path(__file__).with_name("draco_process.py")

_SECONDS, _SECONDS_PER_FACE = 1.0, 1e-5
"""Limit of a stream's CPU time: a constant and a part per face, seconds. Valid streams take up to 1e-6 s per face."""

_MEMORY, _MEMORY_PER_BYTE = 64 << 20, 12
"""Limit of a stream's memory: a constant and a part per decoded byte. Valid streams take up to 6 per decoded byte."""

_WALL_CLOCK_FACTOR = 20.0
"""Wall-clock limit as a multiple of the CPU time limit, for busy machines."""


def needs_draco(primitive: dict[str, Any], header: dict[str, Any]) -> bool:
    """Whether an attribute of a primitive, or its indices, exist only in Draco's compressed form."""
    if DRACO not in primitive.get("extensions", {}):
        return False
    numbers = [*primitive.get("attributes", {}).values(), *([primitive["indices"]] if "indices" in primitive else [])]
    return any("bufferView" not in entry(header, "accessors", number) for number in numbers)


def prepare() -> None:
    """Start the decoder; UnusableError if it is not installed."""
    if not find_spec("DracoPy"):
        raise UnusableError(
            f'it needs the extension {DRACO}, which the Python package DracoPy decodes: pip install "nearfar[formats]"'
        )
    # Starting takes a while, so the process starts before it is needed.
    with _lock:
        _running_process()


@dataclass(frozen=True)
class DracoMesh:
    """A decoded stream or primitive."""

    faces: NDArray[np.uint32]
    """Corners (F, 3)."""
    rows: Mapping[int, NDArray[Any]]
    """Rows (V, K) of each attribute: for a stream by `unique_id`; for a primitive by accessor index, converted to the
    accessor's type or to fractions."""


def decode(header: dict[str, Any], primitive: dict[str, Any], data: bytes, budget: Budget) -> DracoMesh:
    """Decode a primitive's stream; UnusableError unless it has the triangles that the document states.

    COLLADA2GLTF states fewer vertices than its streams have, so the vertex count comes from the stream.
    """
    identities = primitive["extensions"][DRACO]["attributes"]
    attributes = primitive.get("attributes", {}).items()
    numbers = {name: number for name, number in attributes if name in identities and _READ.fullmatch(name)}
    if "POSITION" not in numbers:
        raise _flaw("has no POSITION")
    accessors = {name: entry(header, "accessors", number) for name, number in numbers.items()}
    face_count = _face_count(header, primitive, data)
    count = min(max(0, int(accessors["POSITION"]["count"])), _CORNERS * face_count)
    width = sum(component(item).itemsize * WIDTHS[item["type"]] for item in accessors.values())
    size = _FACE_BYTES * face_count + width * count
    budget.count_unpacked(_DECODER_FACTOR * size)
    stream = _decode_stream(data, size, face_count)
    if len(stream.faces) != face_count:
        raise _flaw(f"has {len(stream.faces)} triangles instead of the stated {face_count}")
    rows = {}
    for name, number in numbers.items():
        column = stream.rows.get(identities[name])
        if column is None:
            raise _flaw(f"lacks the attribute {identities[name]}, its {name}")
        if column.ndim not in (1, 2) or len(column) != len(stream.rows[identities["POSITION"]]):
            raise _flaw(f"has {len(column)} rows of {name}, but another number of rows of POSITION")
        rows[number] = _convert(name, column.reshape(len(column), -1), accessors[name])
    budget.count_arrays(max(0, sum(item.nbytes for item in rows.values()) - width * count))
    return DracoMesh(stream.faces, rows)


def _flaw(words: str) -> UnusableError:
    return UnusableError(f"a Draco stream of its meshes {words}")


def _face_count(header: dict[str, Any], primitive: dict[str, Any], data: bytes) -> int:
    """Number of triangles that the primitive states; the stream's header must agree."""
    if not data.startswith(b"DRACO") or len(data) < 12:
        raise _flaw("does not begin like one")
    stated_count = _stated_faces(data)
    if "indices" not in primitive or mode(primitive) != TRIANGLES:
        if stated_count is None:
            raise _flaw("states no number of triangles")
        return stated_count
    corners = int(entry(header, "accessors", primitive["indices"])["count"])
    if corners < 0 or corners % 3:
        raise _flaw(f"is used with {corners} indices, expected three for each triangle")
    if stated_count not in (None, corners // 3):
        raise _flaw(f"has {stated_count} triangles instead of the stated {corners // 3}")
    return corners // 3


def _stated_faces(data: bytes) -> int | None:
    """Number of triangles in a stream's header; None if its place varies (Draco Bitstream Specification, 5)."""
    version, kind, method, flags = (data[5], data[6]), data[7], data[8], int.from_bytes(data[9:11], "little")
    if kind != _MESH or method not in (_SEQUENTIAL, _EDGEBREAKER):
        raise _flaw("holds no mesh")
    if version != _VERSION or flags & _HAS_METADATA:
        return None
    offset = 11
    if method == _EDGEBREAKER:
        _, offset = _varint(data, offset + 1)  # skip the number of vertices, after the kind of traversal
    return _varint(data, offset)[0]


def _varint(data: bytes, offset: int) -> tuple[int, int]:
    """Decode a variable-length integer of 7 bits a byte; also return the offset after it."""
    value = 0
    for shift in range(0, 35, 7):
        if offset >= len(data):
            raise _flaw("is cut off")
        value |= (data[offset] & 0x7F) << shift
        offset += 1
        if not data[offset - 1] & 0x80:
            return value, offset
    raise _flaw("states a number of more than 32 bits")


def _convert(name: str, rows: NDArray[Any], accessor: dict[str, Any]) -> NDArray[Any]:
    """Convert rows to an accessor's type. DracoPy returns signed integers as float32, normalised ones as fractions."""
    kind = component(accessor)
    if rows.shape[1] != WIDTHS[accessor["type"]]:
        raise _flaw(f"has {rows.shape[1]} numbers in each row of {name} instead of {WIDTHS[accessor['type']]}")
    if kind.kind == "f":
        return rows.astype(np.float32, copy=False)
    if rows.dtype.kind == "f":
        if accessor.get("normalized") and np.abs(rows).max(initial=0) <= 1:
            return rows
        rows = np.rint(rows)
    limits = np.iinfo(kind)
    if rows.size and not limits.min <= rows.min() <= rows.max() <= limits.max:
        raise _flaw(f"has numbers of {name} that do not fit into {kind.name}")
    return rows.astype(kind, copy=False)


def _decode_stream(data: bytes, size: int, face_count: int) -> DracoMesh:
    """Decode a stream; UnusableError if it is damaged or exceeds a limit, MemoryError if the system has too little.

    The expected bytes (`size`) and triangles (`face_count`) set the limits of memory and time.
    """
    seconds = _SECONDS + _SECONDS_PER_FACE * face_count
    request = {"bytes": len(data), "seconds": seconds, "memory": _MEMORY + _MEMORY_PER_BYTE * size}
    with _lock:
        # The process may just have ended after its idle timeout; the second request starts another.
        try:
            answer = _running_process().ask(request, data) or _running_process().ask(request, data)
        except MemoryError:
            raise MemoryError(f"decoding a Draco stream of its meshes needs {len(data) + size} bytes") from None
    if answer is None:
        raise UnusableError("a process that decodes its Draco streams cannot be started")
    return answer


class _Process:
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

    def ask(self, request: dict[str, Any], data: bytes) -> DracoMesh | None:
        """Send a request and return the mesh; None if the process had ended before."""
        # On systems that cannot limit CPU time, the wall clock does.
        factor = _WALL_CLOCK_FACTOR if hasattr(signal, "setitimer") else 2.0
        timer = threading.Timer(factor * request["seconds"], self._child.kill)
        timer.daemon = True
        timer.start()
        try:
            return self._answer(request, data)
        except (OSError, EOFError):
            code = self._child.wait()
            if code in (0, 1):
                return None
            if code == SHORT_OF_MEMORY:
                raise MemoryError from None
            failure = "takes too long" if -code in _TIMEOUT_SIGNALS else f"ends its decoder (code {code})"
            raise UnusableError(f"a Draco stream of its meshes is damaged: it {failure}") from None
        except (MemoryError, KeyboardInterrupt):
            # The rest of the answer would be read as the next one.
            self.end()
            raise
        finally:
            timer.cancel()

    def _answer(self, request: dict[str, Any], data: bytes) -> DracoMesh:
        requests, answers = self._child.stdin, self._child.stdout
        assert requests is not None
        assert answers is not None
        requests.write(json.dumps(request).encode() + b"\n" + data)
        requests.flush()
        if not (line := answers.readline()):
            raise EOFError
        answer = json.loads(line)
        if answer.get("short"):
            raise MemoryError
        if "error" in answer:
            raise UnusableError(f"a Draco stream of its meshes is damaged: {answer['error']}")
        arrays = {number: (np.dtype(kind), tuple(shape)) for number, kind, shape in answer["attributes"]}

        def rows(kind: np.dtype[Any], shape: tuple[int, ...]) -> NDArray[Any]:
            size = kind.itemsize * math.prod(shape)
            if len(data := answers.read(size)) != size:
                raise EOFError
            return np.frombuffer(data, kind).reshape(shape)

        faces = rows(np.dtype(np.uint32), (answer["faces"], 3))
        return DracoMesh(faces, {number: rows(*type_and_shape) for number, type_and_shape in arrays.items()})

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


_TIMEOUT_SIGNALS = (getattr(signal, "SIGPROF", 0), getattr(signal, "SIGKILL", 0))
"""Signals that end a process that exceeds its time limit."""

_lock = threading.Lock()
_process: _Process | None = None


def _running_process() -> _Process:
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
