"""Reads Wavefront OBJ files; trimesh parses their materials."""

from __future__ import annotations

import codecs
import io
import re
from contextlib import suppress
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import check
from nearfar._base.errors import SceneError, UnusableError
from nearfar._scene.budget import Budget
from nearfar._scene.content import Content, Nodes, Shape
from nearfar._scene.materials import Materials, colors_of
from nearfar._scene.names import distinct
from nearfar._scene.polygon_faces import polygon_notes
from nearfar._scene.report import count, listing
from nearfar._scene.wavefront_maps import Placing, TextureFiles, parse_map, placing_of
from nearfar._scene.wavefront_materials import EMISSION_IMAGE, EMISSION_MAP


def read(label: str, data: bytes, resolver: Any, materials: Materials, budget: Budget) -> Content:
    """Read an OBJ with its materials; notes list materials that cannot be read."""
    try:
        columns, libraries, names, parts, skipped = _core.read_wavefront(_to_utf8(data))
    except SceneError as error:
        raise UnusableError(str(error)) from None
    library, notes = _library(list(dict.fromkeys(libraries)), TextureFiles(resolver))
    used_names = dict.fromkeys(names[material] for _, material, _, _ in parts if material is not None)
    missing = [name for name in used_names if name and name not in library]
    if missing and not any(note.startswith("material file") for note in notes):
        listed = listing([*map(check.shortened, missing)])
        notes.append(f"{count(len(missing), 'material')} defined nowhere, drawn without: {listed}")
    small, *elements, large, crossing = skipped
    notes += polygon_notes(small, large, crossing)
    notes += [f"{count(number, kind)} ignored" for number, kind in zip(elements, _SKIPPED, strict=True) if number]
    positions, colors, *_ = columns
    rgba = colors_of(colors, len(positions), linear=False) if len(colors) else None
    words = [
        [names[number] for number in (owner, material if len(library) > 1 else None) if number is not None]
        for owner, material, _, _ in parts
    ]
    budget.count_arrays(sum(len(word) for part_words in words for word in part_words))
    objects = distinct(["_".join(filter(None, part_words)) or resolver.file_name for part_words in words])
    shapes = {}
    for name, (_, material, rows, faces) in zip(objects, parts, strict=True):
        shape = shapes[name] = _shape(columns, rows, faces)
        library_material = None if material is None else library.get(names[material])
        if library_material is not None:
            shape.materials = materials.base_colors(library_material)
            _transform_uvs(shape, library_material)
        elif rgba is not None:
            shape.colors = rgba[rows[:, 0]]
    return Content(label, shapes, Nodes(objects, np.broadcast_to(np.eye(4), (len(objects), 4, 4)), objects), notes)


def _transform_uvs(shape: Shape, material: Any) -> None:
    """Apply the scale and the offset of a material's texture to the texture coordinates."""
    image = getattr(material, "image", None)
    placing = placing_of(material.kwargs.get(EMISSION_IMAGE) if image is None else image)
    if shape.uvs is not None and placing != Placing():
        shape.uvs = shape.uvs * placing.scale + placing.offset


def _shape(columns: tuple[NDArray[np.float64], ...], rows: NDArray[np.uint32], faces: NDArray[np.uint32]) -> Shape:
    """Gather a part's vertices by their rows; a missing texture coordinate or normal becomes zeros."""
    positions, _, uvs, normals = columns
    shape = Shape(positions[rows[:, 0]], faces)
    for kind, column, values in (("uvs", 1, uvs), ("normals", 2, normals)):
        numbers = rows[:, column]
        is_stated = numbers != _NONE
        if is_stated.all() and len(numbers):
            setattr(shape, kind, values[numbers])
        elif is_stated.any():
            setattr(shape, kind, np.where(is_stated[:, None], values[np.where(is_stated, numbers, 0)], 0.0))
    return shape


_SKIPPED = ("line element", "point element", "free-form curve or surface")

_NONE = np.iinfo(np.uint32).max
"""Row index for a missing attribute."""


def _to_utf8(data: bytes) -> bytes:
    """Convert the text to UTF-8 from any encoding."""
    if data.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return data.decode("utf-16").encode()
    try:
        data.decode()
    except UnicodeDecodeError:
        return data.decode("latin-1").encode()  # decodes every byte; digits are the same in all 8-bit encodings
    return data.removeprefix(codecs.BOM_UTF8)


def _library(names: list[str], files: TextureFiles) -> tuple[dict[str, Any], list[str]]:
    """Materials of trimesh by name, and notes on files and textures that cannot be read."""
    from PIL import Image
    from trimesh.exchange.obj import parse_mtl
    from trimesh.visual.material import SimpleMaterial

    library: dict[str, Any] = {}
    notes = []
    for name in names:
        try:
            text = files.open(name)
            material_entries = parse_mtl(text, resolver=files)
            for entries in material_entries.values():
                _add_emission(entries, files)
            new_materials = {key: SimpleMaterial(**entries) for key, entries in material_entries.items()}
        except MemoryError:
            raise
        except Exception:  # resolvers, trimesh and Pillow may raise any type
            notes.append(f"material file {check.shortened(name)} cannot be read, drawn without it")
            continue
        library = new_materials | library
        for texture in dict.fromkeys(_TEXTURE.findall(text)):
            statement = parse_map(texture.decode(errors="replace").strip())
            if statement.undrawn:
                notes.append(
                    f"options {' '.join(statement.undrawn)} of texture {check.shortened(statement.file)} ignored"
                )
            try:
                Image.open(io.BytesIO(files.open(statement.file)))
            except MemoryError:
                raise
            except Exception:
                notes.append(f"texture {check.shortened(statement.file)} cannot be read, drawn without it")
    return library, notes


def _add_emission(entries: dict[str, Any], files: TextureFiles) -> None:
    """Open a material's emission map, as trimesh opens the base colour's map.

    A map that cannot be read, or whose texture coordinates differ from the base colour's, stays unopened and is noted.
    """
    from PIL import Image

    if EMISSION_MAP in entries:
        statement = parse_map(" ".join(entries[EMISSION_MAP]))
        if "image" in entries and placing_of(entries["image"]) != statement.placing:
            return
        with suppress(Exception):  # resolvers and Pillow may raise any type
            image = entries[EMISSION_IMAGE] = Image.open(io.BytesIO(files.open(statement.file)))
            image.info["file_path"] = " ".join(entries[EMISSION_MAP])


_TEXTURE = re.compile(rb"^[ \t]*map_kd[ \t]+(\S.*)", re.MULTILINE | re.IGNORECASE)
