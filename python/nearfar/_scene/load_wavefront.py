"""Reads Wavefront OBJ files."""

from __future__ import annotations

import codecs
import io
import re
from typing import Any

from nearfar._scene import load_trimesh
from nearfar._scene.load_trimesh import parsed
from nearfar._scene.source import Source


def read(label: str, data: bytes, resolver: Any) -> Source:
    """Read an OBJ with its materials; notes say which of them cannot be read."""
    source = load_trimesh.read(label, _parsed(data, resolver), fresh=True)
    source.notes += _losses(data, resolver)
    return source


def _parsed(data: bytes, resolver: Any) -> Any:
    """Read an OBJ of any encoding; objects stay separate, faces keep their order, and vertices too if unambiguous."""
    if data.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        data = data.decode("utf-16").encode()
    else:
        try:
            data.decode()
        except UnicodeDecodeError:
            data = data.decode("latin-1").encode()  # decodes every byte; digits are the same in all 8-bit encodings
    # A vertex may have several texture coordinates or normals. With `maintain_order` trimesh would give it the median
    # of their indices.
    if re.search(rb"^[ \t]*v[nt][ \t]", data, re.MULTILINE):
        return parsed(data, "obj", resolver, split_objects=True)
    try:
        return parsed(data, "obj", resolver, split_objects=True, maintain_order=True)
    except IndexError:
        # `maintain_order` does not support negative indices.
        return parsed(data, "obj", resolver, split_objects=True)


def _losses(data: bytes, resolver: Any) -> list[str]:
    """Notes on the material file and textures that cannot be read; trimesh leaves them out without a warning."""
    from PIL import Image

    def named(keyword: bytes, text: bytes) -> list[str]:
        matches = re.findall(rb"^[ \t]*" + keyword + rb"[ \t]+(.*\S)", text, re.MULTILINE | re.IGNORECASE)
        return list(dict.fromkeys(name.decode(errors="replace") for name in matches))

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
