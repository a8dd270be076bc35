"""Reads OFF files.

Source: Geomview Manual, OFF Files.
"""

from __future__ import annotations

import re
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base.errors import UnusableError
from nearfar._scene.content import Content, Nodes, Shape
from nearfar._scene.materials import colors_of
from nearfar._scene.polygon_faces import triangulate
from nearfar._scene.report import count

_HEADER = re.compile(r"\s*(ST)?(C)?(N)?(4)?(n)?OFF\b[ \t]*(BINARY)?", re.ASCII)
"""Keyword of a file, with letters for the attributes of its vertices."""


def read(label: str, data: bytes) -> Content:
    """Read an OFF text with normals, texture coordinates, and colours of vertices or faces."""
    text = re.sub("#.*", "", data.decode("utf-8-sig", errors="replace"))
    header = _HEADER.match(text)
    if header is None:
        raise UnusableError("it does not begin like an OFF file")
    has_uvs, has_colors, has_normals, *others = map(bool, header.groups())
    if any(others):
        raise UnusableError(f"only OFF text of three dimensions is read, not {header[0].strip()}")
    lines = [line.split() for line in text[header.end() :].splitlines() if line and not line.isspace()]
    counts = np.array(lines[0] if lines else [], np.int64)
    if len(counts) < 2 or counts.min() < 0:
        raise UnusableError("it lacks the numbers of vertices and faces")
    vertex_count, face_count = counts[:2].tolist()
    vertex_end = 1 + vertex_count
    if vertex_end + face_count > len(lines):
        raise UnusableError("it is cut off")
    rows = np.array(lines[1:vertex_end], np.float64).reshape(vertex_count, -1 if vertex_count else 3)
    if rows.shape[1] < 3:
        raise UnusableError("a row of it has too few or too many numbers")
    face_lines = lines[vertex_end : vertex_end + face_count]
    sizes = np.array([line[0] for line in face_lines], np.int64)
    if sizes.size and sizes.min() < 0:
        raise UnusableError(f"it has a face of {sizes.min()} corners")
    sized = list(zip(face_lines, sizes.tolist(), strict=True))
    indices = np.array([word for line, size in sized for word in line[1 : 1 + size]], np.int64)
    if len(indices) != sizes.sum():
        raise UnusableError("a face of it has fewer corners than it states")
    notes = []
    if len(lines) > vertex_end + face_count:
        notes.append(f"{count(len(lines) - vertex_end - face_count, 'line')} after the faces ignored")
    triangles = triangulate(rows[:, :3], indices, np.concatenate([[0], np.cumsum(sizes)]))
    shape = Shape(rows[:, :3], indices[triangles.corners])
    _attributes(shape, rows[:, 3:], (has_normals, has_colors, has_uvs), notes)
    extras = [line[1 + size :] for line, size in sized]
    colors = _face_colors(extras, notes)
    if colors is not None and shape.colors is None:
        shape.color_faces(triangles.of_polygons(colors))
    nodes = Nodes.from_rows([("geometry", np.eye(4), "geometry")])
    return Content(label, {"geometry": shape}, nodes, notes + triangles.notes)


def _attributes(shape: Shape, rows: NDArray[Any], has: tuple[bool, bool, bool], notes: list[str]) -> None:
    """Split the numbers after the positions into normals, colours and texture coordinates."""
    has_normals, has_colors, has_uvs = has
    if has_normals:
        shape.normals, rows = rows[:, :3], rows[:, 3:]
    if has_uvs:
        shape.uvs, rows = rows[:, -2:], rows[:, :-2]
    if has_colors:
        shape.colors = colors_of(_bytes_or_units(rows[:, :4]), len(rows), linear=False)
    elif rows.shape[1]:
        notes.append(f"{rows.shape[1]} more numbers of each vertex ignored")


def _face_colors(extras: list[list[str]], notes: list[str]) -> NDArray[np.uint8] | None:
    """Colours of the faces as bytes; None if not all faces have one."""
    sizes = {len(words) for words in extras}
    if sizes <= {0}:
        return None
    if sizes in ({3}, {4}):
        return colors_of(_bytes_or_units(np.array(extras, np.float64)), len(extras), linear=False)
    notes.append("face colours ignored: not all faces have red, green and blue")
    return None


def _bytes_or_units(colors: NDArray[np.float64]) -> NDArray[np.float64]:
    """Colours from 0 to 1; files have these or bytes."""
    return colors / 255 if colors.size and colors.max() > 1 else colors
