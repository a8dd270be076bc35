"""Reads PLY files."""

from __future__ import annotations

import io
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base import check
from nearfar._base.errors import UnusableError
from nearfar._scene.content import Content, Shape
from nearfar._scene.materials import Materials, colors_of
from nearfar._scene.ply_elements import Element, Lists, parse
from nearfar._scene.polygon_faces import triangulate
from nearfar._scene.report import count

_INDICES = ("vertex_indices", "vertex_index")
_POSITION, _NORMAL, _COLOR = ("x", "y", "z"), ("nx", "ny", "nz"), ("red", "green", "blue")
_UVS = (("texture_u", "texture_v"), ("u", "v"), ("s", "t"))
"""Names of texture coordinates of vertices."""
_CORNER_UVS = "texcoord"
"""Name of a face's list of texture coordinates, two for each corner."""


def read(label: str, data: bytes, resolver: Any, materials: Materials) -> Content:
    """Read a PLY file; notes name ignored elements and properties."""
    ply = parse(data)
    vertex, face = (ply.elements.get(name, Element(name, 0)) for name in ("vertex", "face"))
    notes = [
        f"{count(element.count, 'row')} of element {check.shortened(element.name)} ignored"
        for element in ply.elements.values()
        if element not in (vertex, face) and element.count
    ]
    vertices = _columns(vertex, _POSITION)
    if vertices is None:
        raise UnusableError("its vertices lack x, y or z")
    name = next((name for name in _INDICES if name in face.lists), None)
    # The only list contains the indices, whatever its name.
    name = next(iter(face.lists)) if name is None and len(face.lists) == 1 else name
    used = {*_POSITION, *_NORMAL, *_COLOR, "alpha", *sum(_UVS, ()), name, _CORNER_UVS}
    notes += [
        f"{element.name} property {prop.name} ignored"
        for element in (vertex, face)
        for prop in element.properties
        if prop.name not in used
    ]
    if name is None or not face.count:
        notes += [f"{count(vertex.count, 'point')} without faces ignored"] if vertex.count else []
        return Content.of_shape(label, Shape(vertices, np.zeros((0, 3), np.int64)), notes)
    polygons = face.lists[name]
    indices = polygons.values.astype(np.int64) if polygons.values.dtype.kind == "f" else polygons.values
    triangles = triangulate(vertices, indices, polygons.offsets)
    notes += triangles.notes
    shape = Shape(vertices, indices[triangles.corners])
    shape.normals = _columns(vertex, _NORMAL)
    shape.uvs = next((uvs for names in _UVS if (uvs := _columns(vertex, names)) is not None), None)
    colors, face_colors = _colors(vertex), _colors(face)
    corner_uvs = face.lists.get(_CORNER_UVS)
    if corner_uvs is not None and (np.diff(corner_uvs.offsets) != 2 * np.diff(polygons.offsets)).any():
        notes.append("texture coordinates of faces ignored: their number differs from that of the corners")
        corner_uvs = None
    if ply.texture and (shape.uvs is not None or corner_uvs is not None):
        image = _image(ply.texture, resolver, notes)
        if image is not None:
            from trimesh.visual.material import SimpleMaterial

            shape.materials = materials.base_colors(SimpleMaterial(image=image))
            notes += ["colours beside the texture ignored"] if colors is not None or face_colors is not None else []
            colors = face_colors = None
    if colors is not None:
        shape.colors = colors
        notes += ["face colours beside vertex colours ignored"] if face_colors is not None else []
    elif face_colors is not None:
        shape.color_faces(triangles.per_triangle(face_colors))
    if corner_uvs is not None:
        _split_vertices(shape, corner_uvs, triangles.corners)
    return Content.of_shape(label, shape, notes)


def _columns(element: Element, names: Sequence[str]) -> NDArray[Any] | None:
    """Scalar properties side by side; None if one is missing."""
    if any(name not in element.scalars for name in names):
        return None
    return np.stack([element.scalars[name] for name in names], axis=-1)


def _colors(element: Element) -> NDArray[np.uint8] | None:
    """Colours of the rows as sRGB bytes, None if there are none. Each channel is scaled by the range of its type."""
    if not element.count or any(name not in element.scalars for name in _COLOR):
        return None
    channels = [element.scalars[name] for name in (*_COLOR, "alpha") if name in element.scalars]
    if len({channel.dtype for channel in channels}) == 1 and channels[0].dtype == np.uint8:
        return colors_of(np.stack(channels, axis=-1), element.count, linear=False)
    # Some programs write bytes as integers of 32 bits.
    wide = [channel for channel in channels if _is_wide(channel.dtype)]
    has_bytes = all(channel.min() >= 0 and channel.max() <= 255 for channel in wide)

    def full_scale(kind: np.dtype[Any]) -> float:
        if kind.kind == "f":
            return 1.0
        return 255.0 if has_bytes and _is_wide(kind) else float(np.iinfo(kind).max)

    fractions = [channel.astype(np.float64) / full_scale(channel.dtype) for channel in channels]
    return colors_of(np.stack(fractions, axis=-1), element.count, linear=False)


def _is_wide(kind: np.dtype[Any]) -> bool:
    """Return whether numbers are integers of more than 16 bits."""
    return kind.kind != "f" and kind.itemsize > 2


def _image(name: str, resolver: Any, notes: list[str]) -> Any:
    """Image of the texture; None, with a note, if it cannot be read."""
    from PIL import Image

    try:
        return Image.open(io.BytesIO(resolver.get(name)))
    except MemoryError:
        raise
    except Exception:  # resolvers and Pillow may raise any type
        notes.append(f"texture {check.shortened(name)} cannot be read, drawn without it")
        return None


def _split_vertices(shape: Shape, uvs: Lists, corners: NDArray[Any]) -> None:
    """Split vertices whose corners differ in texture coordinates, so that each vertex has one pair."""
    numbers, rows = shape.faces.ravel(), uvs.values.reshape(-1, 2)[corners.ravel()]
    order = np.lexsort((rows[:, 1], rows[:, 0], numbers))
    is_new = np.ones(len(order), bool)
    is_new[1:] = (np.diff(numbers[order]) != 0) | (np.diff(rows[order], axis=0) != 0).any(axis=1)
    faces = np.empty(len(order), np.int64)
    faces[order] = np.cumsum(is_new) - 1
    first = order[is_new]
    old, vertex_count = numbers[first], len(shape.vertices)
    if len(old) and (old.min() < 0 or old.max() >= vertex_count):
        # Some vertices do not exist. They are reported later, by these numbers.
        return
    shape.faces, shape.uvs, shape.vertices = faces.reshape(-1, 3), rows[first], shape.vertices[old]
    shape.normals = None if shape.normals is None else shape.normals[old]
    shape.colors = None if shape.colors is None else shape.colors[old]
