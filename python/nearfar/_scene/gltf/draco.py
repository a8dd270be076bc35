"""Decodes primitives of glTF files compressed by Draco: KHR_draco_mesh_compression."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from importlib.util import find_spec
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base.errors import UnusableError
from nearfar._base.glb import entry
from nearfar._scene.budget import Budget
from nearfar._scene.gltf import draco_client
from nearfar._scene.gltf.buffers import WIDTHS, component
from nearfar._scene.gltf.corners import TRIANGLES, mode

DRACO = "KHR_draco_mesh_compression"

_READ = re.compile("POSITION|NORMAL|TEXCOORD_[0-9]+|COLOR_0")
"""Names of supported attributes."""

_CORNERS, _FACE_BYTES = 3, 12
"""Corners and bytes of a face."""

_DECODER_FACTOR = 2
"""Bytes to count per decoded byte: Draco uses up to six while it decodes."""

_VERSION, _MESH, _SEQUENTIAL, _EDGEBREAKER = (2, 2), 1, 0, 1
_HAS_METADATA = 0x8000


def prepare() -> None:
    """Start the decoder; UnusableError if it is not installed."""
    if not find_spec("DracoPy"):
        raise UnusableError(
            f'it needs the extension {DRACO}, which the Python package DracoPy decodes: pip install "nearfar[formats]"'
        )
    draco_client.start()


@dataclass(frozen=True)
class Decoded:
    """A decoded stream."""

    faces: NDArray[np.uint32]
    """Corners (F, 3)."""
    rows: Mapping[int, NDArray[Any]]
    """Rows (V, K) of attributes by accessor index, in the accessor's type or as fractions."""


def decoded(header: dict[str, Any], primitive: dict[str, Any], data: bytes, budget: Budget) -> Decoded:
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
    budget.take(_DECODER_FACTOR * size)
    mesh = draco_client.decode(data, size, face_count)
    if len(mesh.faces) != face_count:
        raise _flaw(f"has {len(mesh.faces)} triangles, and {face_count} are stated")
    rows = {}
    for name, number in numbers.items():
        column = mesh.attributes.get(identities[name])
        if column is None:
            raise _flaw(f"lacks the attribute {identities[name]}, its {name}")
        if column.ndim not in (1, 2) or len(column) != len(mesh.attributes[identities["POSITION"]]):
            raise _flaw(f"has {len(column)} rows of {name}, and others of POSITION")
        rows[number] = _typed(name, column.reshape(len(column), -1), accessors[name])
    budget.hold(max(0, sum(item.nbytes for item in rows.values()) - width * count))
    return Decoded(mesh.faces, rows)


def _flaw(words: str) -> UnusableError:
    return UnusableError(f"a Draco stream of its meshes {words}")


def _face_count(header: dict[str, Any], primitive: dict[str, Any], data: bytes) -> int:
    """Expected number of triangles: the primitive's; the stream's header must agree with it."""
    if not data.startswith(b"DRACO") or len(data) < 12:
        raise _flaw("does not begin like one")
    stated_count = _stated_faces(data)
    if "indices" not in primitive or mode(primitive) != TRIANGLES:
        if stated_count is None:
            raise _flaw("states no number of triangles")
        return stated_count
    corners = int(entry(header, "accessors", primitive["indices"])["count"])
    if corners < 0 or corners % 3 or stated_count not in (None, corners // 3):
        raise _flaw(f"has {stated_count} triangles, and {corners / 3:g} are stated")
    return corners // 3


def _stated_faces(data: bytes) -> int | None:
    """Number of triangles in a stream's header; None if it is not at its start (Draco Bitstream Specification, 5)."""
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
    """Decode a variable-length integer of 7 bits a byte; also return the place after it."""
    value = 0
    for shift in range(0, 35, 7):
        if offset >= len(data):
            raise _flaw("is cut off")
        value |= (data[offset] & 0x7F) << shift
        offset += 1
        if not data[offset - 1] & 0x80:
            return value, offset
    raise _flaw("states a number of more than 32 bits")


def _typed(name: str, rows: NDArray[Any], accessor: dict[str, Any]) -> NDArray[Any]:
    """Convert rows to an accessor's type. DracoPy makes signed integers float32, and normalised ones fractions."""
    kind = component(accessor)
    if rows.shape[1] != WIDTHS[accessor["type"]]:
        raise _flaw(f"has {rows.shape[1]} numbers in each row of {name}, and {WIDTHS[accessor['type']]} are stated")
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
