"""Reads OFF files.

Source: Geomview Manual, OFF Files.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base.errors import UnusableError
from nearfar._scene.content import Content, Shape
from nearfar._scene.materials import colors_of
from nearfar._scene.polygon_faces import triangulate
from nearfar._scene.report import count

_GREY = 231 / 255
"""sRGB of `PLAIN`, for rows without a colour."""

_HEADER = re.compile(r"\s*(ST)?(C)?(N)?(4)?(n)?OFF\b[ \t]*(BINARY)?", re.ASCII)
"""Keyword that begins a file; its letters state the attributes of vertices."""


def read(label: str, data: bytes) -> Content:
    """Read an OFF text with normals, texture coordinates, and colours of vertices or faces."""
    text = re.sub("#.*", "", data.decode("utf-8-sig", errors="replace"))
    header = _HEADER.match(text)
    if header is None:
        raise UnusableError("it does not begin like an OFF file")
    has_uvs, has_colors, has_normals, *unsupported = map(bool, header.groups())
    if any(unsupported):
        raise UnusableError(f"only OFF text of three dimensions is read, not {header[0].strip()}")
    lines = [line.split() for line in text[header.end() :].splitlines() if line and not line.isspace()]
    counts = np.array(lines[0] if lines else [], np.int64)
    if len(counts) < 2 or counts.min() < 0:
        raise UnusableError("it lacks the numbers of vertices and faces")
    vertex_count, face_count = counts[:2].tolist()
    vertex_end = 1 + vertex_count
    if vertex_end + face_count > len(lines):
        raise UnusableError("it is cut off")
    vertex_lines = lines[1:vertex_end]
    lengths = np.array([len(line) for line in vertex_lines], np.int64)
    if vertex_count and lengths.min() < 3:
        raise UnusableError("one of its rows has too few or too many numbers")
    rows = _parse_padded(vertex_lines, lengths)
    face_lines = lines[vertex_end : vertex_end + face_count]
    sizes = np.array([line[0] for line in face_lines], np.int64)
    if sizes.size and sizes.min() < 0:
        raise UnusableError(f"it has a face of {sizes.min()} corners")
    sized = list(zip(face_lines, sizes.tolist(), strict=True))
    indices = np.array([word for line, size in sized for word in line[1 : 1 + size]], np.int64)
    if len(indices) != sizes.sum():
        raise UnusableError("one of its faces has fewer corners than it states")
    notes = []
    if len(lines) > vertex_end + face_count:
        notes.append(f"{count(len(lines) - vertex_end - face_count, 'line')} after the faces ignored")
    triangles = triangulate(rows[:, :3], indices, np.concatenate([[0], np.cumsum(sizes)]))
    shape = Shape(rows[:, :3], indices[triangles.corners])
    is_even = not vertex_count or bool((lengths == lengths[0]).all())
    if has_uvs and not is_even:
        # Colours have three or four numbers, so the number after three may belong to either.
        notes.append("texture coordinates ignored: not all vertices have equally many numbers")
        rows = rows[:, : 6 + 3 * has_normals]
    _attributes(shape, rows[:, 3:], (has_normals, has_colors, has_uvs and is_even), notes)
    extras = [line[1 + size :] for line, size in sized]
    colors = _face_colors(extras, notes)
    if colors is not None and shape.colors is None:
        shape.color_faces(triangles.per_triangle(colors))
    return Content.of_shape(label, shape, notes + triangles.notes)


def _attributes(shape: Shape, rows: NDArray[Any], has: tuple[bool, bool, bool], notes: list[str]) -> None:
    """Split the numbers after the positions into normals, colours and texture coordinates."""
    has_normals, has_colors, has_uvs = has
    if has_normals:
        shape.normals, rows = rows[:, :3], rows[:, 3:]
    if has_uvs:
        shape.uvs, rows = rows[:, -2:], rows[:, :-2]
    if has_colors:
        shape.colors = _colors(rows[:, :4], "vertex", "vertices", notes)
    elif rows.shape[1]:
        notes.append(f"{rows.shape[1]} more numbers of each vertex ignored")


def _face_colors(extras: list[list[str]], notes: list[str]) -> NDArray[np.uint8] | None:
    """Colours of the faces as bytes; None if no face has one."""
    # A single number is an index into a list that is not in the file.
    words = [row if len(row) in (3, 4) else [] for row in extras]
    if any(words):
        return _colors(_parse_padded(words, np.array([*map(len, words)])), "face", "faces", notes)
    if any(extras):
        notes.append("face colours ignored: no face has red, green and blue")
    return None


def _colors(rows: NDArray[np.float64], noun: str, plural: str, notes: list[str]) -> NDArray[np.uint8] | None:
    """Colours (N, 3 or 4) as bytes, light grey for rows with NaN in red, green or blue; None without three columns."""
    if rows.shape[1] < 3:
        return None
    lacks_color = np.isnan(rows[:, :3]).any(axis=1)
    if lacks_color.any():
        notes.append(f"{count(int(lacks_color.sum()), noun, plural)} without red, green and blue drawn light grey")
    units = rows / (255 if np.nanmax(rows, initial=0.0) > 1 else 1)  # files have bytes, or fractions up to 1
    units[lacks_color, :3] = _GREY
    units[:, 3:] = np.nan_to_num(units[:, 3:], nan=1.0)
    return colors_of(units, len(units), linear=False)


def _parse_padded(lines: Sequence[Sequence[str]], lengths: NDArray[np.int64]) -> NDArray[np.float64]:
    """Parse lines to rows (N, K) of at least three numbers; NaN fills up short lines."""
    rows = np.full((len(lines), int(lengths.max(initial=3))), np.nan)
    rows[np.arange(rows.shape[1]) < lengths[:, None]] = np.array([word for line in lines for word in line], np.float64)
    return rows
