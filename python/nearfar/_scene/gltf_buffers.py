"""Bytes of a glTF file's buffers and images, and the arrays that trimesh does not read."""

from __future__ import annotations

import base64
import json
import os
from typing import Any
from urllib.parse import unquote, unquote_to_bytes

import numpy as np
from numpy.typing import NDArray

from nearfar._base.errors import UnusableError
from nearfar._scene.undrawn import EncodedImage, TextureSource

COMPONENTS: dict[int, type[np.generic]] = {
    5120: np.int8,
    5121: np.uint8,
    5122: np.int16,
    5123: np.uint16,
    5125: np.uint32,
    5126: np.float32,
}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT2": 4, "MAT3": 9, "MAT4": 16}

IMAGE_EXTENSIONS = {"EXT_texture_webp": "webp", "EXT_texture_avif": "avif"}
"""Extensions that give a texture another image, by the feature of Pillow that decodes it."""

_SIGNATURES = {
    b"\x89PNG\r\n\x1a\n": "image/png",
    b"\xff\xd8\xff": "image/jpeg",
    b"\xabKTX 20\xbb\r\n\x1a\n": "image/ktx2",
}
_CONTAINERS = {(b"RIFF", b"WEBP"): "image/webp", (b"\0\0\0", b"ftyp"): "image/avif"}

_SAMPLER = ("magFilter", "minFilter", "wrapS", "wrapT")


def name_files(header: dict[str, Any], resolver: Any) -> bool:
    """Replace percent signs in the names of the files that a document refers to; returns whether there were any."""
    changed = False
    for entry in [*header.get("buffers", []), *header.get("images", [])]:
        uri = entry.get("uri", "")
        if "%" in uri and not uri.startswith("data:") and not os.path.exists(os.path.join(resolver.parent, uri)):
            entry["uri"] = unquote(uri)
            changed = True
    return changed


class Buffers:
    """Reads what a glTF document refers to.

    Parameters
    ----------
    header
        The document.
    binary
        Content of a GLB's second chunk; empty for none.
    resolver
        Trimesh's, which reads files beside the document.
    """

    def __init__(self, header: dict[str, Any], binary: bytes, resolver: Any) -> None:
        self._header, self._binary, self._resolver = header, binary, resolver
        self._buffers: dict[int, bytes] = {}
        self._textures: dict[int, TextureSource | None] = {}

    def texture(self, number: int) -> TextureSource | None:
        """The texture of a number with its image's bytes; None where it cannot be read."""
        if number not in self._textures:
            try:
                self._textures[number] = self._texture(number)
            except Exception:  # a texture is never needed, and resolvers may raise any type
                self._textures[number] = None
        return self._textures[number]

    def _texture(self, number: int) -> TextureSource | None:
        described = self._header["textures"][number]
        sampler = self._header["samplers"][described["sampler"]] if "sampler" in described else {}
        settings = {key: sampler[key] for key in _SAMPLER if isinstance(sampler.get(key), int)}
        others = [content["source"] for content in described.get("extensions", {}).values() if "source" in content]
        sources = [described["source"]] if "source" in described else others
        image = self._image(sources[0]) if sources else None
        return None if image is None else TextureSource(image, json.dumps(settings) if settings else "")

    def _image(self, number: int) -> EncodedImage | None:
        described = self._header["images"][number]
        in_buffer = "bufferView" in described
        data = bytes(self._view(described["bufferView"])) if in_buffer else self._file(described["uri"])
        kinds = [kind for start, kind in _SIGNATURES.items() if data.startswith(start)]
        kinds += [kind for (start, name), kind in _CONTAINERS.items() if data.startswith(start) and name in data[4:12]]
        return EncodedImage(data, kinds[0]) if kinds else None

    def _file(self, uri: str) -> bytes:
        if not uri.startswith("data:"):
            content: bytes = self._resolver.get(uri)
            return content
        kind, _, data = uri.partition(",")
        return base64.b64decode(data) if kind.endswith(";base64") else unquote_to_bytes(data)

    def _view(self, number: int) -> memoryview:
        described = self._header["bufferViews"][number]
        buffer = described["buffer"]
        if buffer not in self._buffers:
            entry = self._header["buffers"][buffer]
            self._buffers[buffer] = self._file(entry["uri"]) if "uri" in entry else self._binary
        start, length = described.get("byteOffset", 0), described["byteLength"]
        data = memoryview(self._buffers[buffer])
        if not 0 <= start <= start + length <= len(data):
            raise IndexError(f"bytes {start} to {start + length} of a buffer of {len(data)}")
        return data[start : start + length]

    def misread(self, attribute: str, number: int) -> bool:
        """Whether trimesh reads an attribute wrongly: rows that a sparse accessor changes, and quantised numbers.

        Of colours it passes the numbers on, and normals are brought to length 1 anyway. It computes 1 − v of texture
        coordinates in their own type.
        """
        accessor = self._header["accessors"][number]
        if "sparse" in accessor:
            return True
        is_whole = accessor["componentType"] != _FLOAT
        wrong = is_whole and (attribute == "TEXCOORD_0" or (attribute == "POSITION" and accessor.get("normalized")))
        if wrong and "bufferView" not in accessor:
            raise UnusableError(f"its {attribute} is quantised and compressed, which is not read: save it as floats")
        return bool(wrong)

    def array(self, number: int) -> NDArray[Any]:
        """Rows (N, K) of an accessor; whole numbers that stand for fractions become float32 (glTF 2.0, 3.11)."""
        described = self._header["accessors"][number]
        kind, width = np.dtype(COMPONENTS[described["componentType"]]), WIDTHS[described["type"]]
        count = int(described["count"])
        if "bufferView" in described:
            rows = self._rows(described["bufferView"], described.get("byteOffset", 0), kind, count, width)
        else:
            rows = np.zeros((count, width), kind)
        if sparse := described.get("sparse"):
            rows = self._changed(rows, sparse)
        if not described.get("normalized") or kind == np.float32:
            return rows
        fractions: NDArray[np.float32] = np.maximum(rows.astype(np.float64) / np.iinfo(kind).max, -1).astype(np.float32)
        return fractions

    def _changed(self, rows: NDArray[Any], sparse: dict[str, Any]) -> NDArray[Any]:
        places, values, count = sparse["indices"], sparse["values"], int(sparse["count"])
        kind = np.dtype(COMPONENTS[places["componentType"]])
        where = self._rows(places["bufferView"], places.get("byteOffset", 0), kind, count, 1)[:, 0]
        new = self._rows(values["bufferView"], values.get("byteOffset", 0), rows.dtype, count, rows.shape[1])
        if len(where) and int(where.max()) >= len(rows):
            raise UnusableError(f"a sparse accessor changes row {int(where.max())} of {len(rows)}")
        rows = rows.copy()
        rows[where] = new
        return rows

    def _rows(self, view: int, start: int, kind: np.dtype[Any], count: int, width: int) -> NDArray[Any]:
        data = self._view(view)
        size = kind.itemsize * width
        step = int(self._header["bufferViews"][view].get("byteStride", size))
        if count < 0 or start < 0 or step < size or (count and start + (count - 1) * step + size > len(data)):
            raise IndexError(f"{count} rows from byte {start} of {len(data)}")
        shape, strides = (count, width), (step, kind.itemsize)
        return np.ndarray(shape, kind, data, start, strides) if count else np.zeros(shape, kind)


_FLOAT = 5126
