"""Reads Wavefront OBJ files."""

from __future__ import annotations

import codecs
import io
import re
from typing import Any

from nearfar import _core
from nearfar._base.errors import SceneError, UnusableError
from nearfar._scene import load_trimesh
from nearfar._scene.load_trimesh import parsed
from nearfar._scene.materials import Materials
from nearfar._scene.source import Source


def read(label: str, data: bytes, resolver: Any, materials: Materials) -> Source:
    """Read an OBJ with its materials; notes say which of them cannot be read."""
    data = _encoded(data)
    try:
        data = _core.plain_wavefront(data) or data
    except SceneError as error:
        raise UnusableError(str(error)) from None
    source = load_trimesh.read(label, _parsed(data, resolver), materials)
    source.notes += _losses(data, resolver)
    return source


def _encoded(data: bytes) -> bytes:
    """The text as UTF-8, whatever its encoding."""
    if data.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return data.decode("utf-16").encode()
    try:
        data.decode()
    except UnicodeDecodeError:
        return data.decode("latin-1").encode()  # decodes every byte; digits are the same in all 8-bit encodings
    return data.removeprefix(codecs.BOM_UTF8)


def _parsed(data: bytes, resolver: Any) -> Any:
    """Let trimesh read it; objects stay separate, faces keep their order, and vertices too if unambiguous."""
    # A vertex may have several texture coordinates or normals. With `maintain_order` trimesh would give it the median
    # of their indices.
    if re.search(rb"^[ \t]*v[nt][ \t]", data, re.MULTILINE):
        return parsed(data, "obj", resolver, split_objects=True)
    return parsed(data, "obj", resolver, split_objects=True, maintain_order=True)


def _losses(data: bytes, resolver: Any) -> list[str]:
    """Notes on the material file and textures that cannot be read; trimesh leaves them out without a warning."""
    from PIL import Image

    def named(keyword: bytes, text: bytes) -> list[str]:
        matches = re.findall(rb"^[ \t]*" + keyword + rb"[ \t]+(\S.*)", text, re.MULTILINE | re.IGNORECASE)
        return list(dict.fromkeys(name.decode(errors="replace").rstrip() for name in matches))

    losses = []
    for library in named(b"mtllib", data)[:1]:  # trimesh reads only the first
        try:
            materials = resolver.get(library)
        except Exception:  # resolvers and Pillow may raise any type
            return [f"material file '{library}' cannot be read, drawn without it"]
        for texture in named(b"map_kd", materials):
            try:
                Image.open(io.BytesIO(resolver.get(texture)))
            except Exception:
                losses.append(f"texture '{texture}' cannot be read, drawn without it")
    return losses
