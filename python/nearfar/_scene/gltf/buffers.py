"""Reads the buffers of a glTF file, also compressed by meshoptimizer, its images, and the arrays of its accessors."""

from __future__ import annotations

import base64
import json
import os
from typing import Any
from urllib.parse import unquote, unquote_to_bytes

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import check
from nearfar._base.errors import SceneError, UnusableError
from nearfar._base.glb import entry
from nearfar._scene.budget import Budget, TooLargeError
from nearfar._scene.gltf import ktx2
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
"""Extensions that provide alternative images for a texture, by the Pillow feature that decodes them."""

_SIGNATURES = {
    (b"\x89PNG\r\n\x1a\n", b""): "image/png",
    (b"\xff\xd8\xff", b""): "image/jpeg",
    (ktx2.SIGNATURE, b""): ktx2.KIND,
    (b"RIFF", b"WEBP"): "image/webp",
    (b"\0\0\0", b"ftyp"): "image/avif",
}
"""Media types of images, by the first bytes of a file and by bytes that occur at offsets 4 to 12."""

MESHOPT = ("EXT_meshopt_compression", "KHR_meshopt_compression")
"""Extensions that compress buffer views; the second one adds a filter and a codec version."""

_SAMPLER = ("magFilter", "minFilter", "wrapS", "wrapT")


def name_files(header: dict[str, Any], resolver: Any) -> None:
    """Decode percent escapes in the file names that a document refers to."""
    for item in [*header.get("buffers", []), *header.get("images", [])]:
        uri = item.get("uri", "")
        if "%" in uri and not uri.startswith("data:") and not os.path.exists(os.path.join(resolver.parent, uri)):
            item["uri"] = unquote(uri)


def _kind(data: bytes) -> str:
    """Media type of an image file; empty if unknown."""
    kinds = (kind for (start, name), kind in _SIGNATURES.items() if data.startswith(start) and name in data[4:12])
    return next(kinds, "")


class Buffers:
    """Reads the data that a glTF document, the `header`, refers to.

    `binary` is the content of a GLB's binary chunk, empty for none. Trimesh's `resolver` reads files beside the
    document. The `budget` counts copied bytes, because many parts may refer to the same data.
    """

    def __init__(self, header: dict[str, Any], binary: bytes | memoryview, resolver: Any, budget: Budget) -> None:
        self._header, self._binary, self._resolver, self._budget = header, binary, resolver, budget
        self._buffers: dict[int, memoryview] = {}
        self._blobs: dict[tuple[int, int, int], bytes] = {}
        self._decoded: dict[int, memoryview] = {}
        self._images: dict[int, bytes] = {}
        self._encoded: dict[bytes, EncodedImage | None] = {}
        self._textures: dict[int, TextureSource | None] = {}
        self._arrays: dict[int, NDArray[Any]] = {}

    def texture(self, number: int) -> TextureSource | None:
        """Return a texture, with its image if the image is of a known kind; None if it cannot be read."""
        if number not in self._textures:
            try:
                self._textures[number] = self._texture(number)
            except (TooLargeError, MemoryError):
                raise
            except Exception:  # textures are optional, and resolvers may raise any type
                self._textures[number] = None
        return self._textures[number]

    def _texture(self, number: int) -> TextureSource | None:
        data = self.picture(number)
        if data is None:
            return None
        texture = entry(self._header, "textures", number)
        sampler = entry(self._header, "samplers", texture["sampler"]) if "sampler" in texture else {}
        settings = {key: sampler[key] for key in _SAMPLER if isinstance(sampler.get(key), int)}
        # Equal images share one object, which caches its hash.
        if data not in self._encoded:
            self._encoded[data] = EncodedImage(data, kind) if (kind := _kind(data)) else None
        return TextureSource(self._encoded[data], json.dumps(settings) if settings else "")

    def picture(self, number: Any) -> bytes | None:
        """Bytes of a texture's image; None if there are none."""
        try:
            texture = entry(self._header, "textures", number)
            candidates = (texture, *texture.get("extensions", {}).values())
            return next((self._image(item["source"]) for item in candidates if "source" in item), None)
        except (TooLargeError, MemoryError):
            raise
        except Exception:  # textures are optional, and resolvers may raise any type
            return None

    def _image(self, number: int) -> bytes:
        if number not in self._images:
            image = entry(self._header, "images", number)
            is_inside = "bufferView" in image
            self._images[number] = self.blob(image["bufferView"]) if is_inside else self._file(image["uri"])
        return self._images[number]

    def _file(self, uri: str) -> bytes:
        if not uri.startswith("data:"):
            content: bytes = self._resolver.get(uri)
            return content
        kind, _, data = uri.partition(",")
        return base64.b64decode(data) if kind.endswith(";base64") else unquote_to_bytes(data)

    def blob(self, view: int) -> bytes:
        """Bytes of a buffer view; each range is copied once."""
        view_entry = entry(self._header, "bufferViews", view)
        key = _range(_stream(view_entry) or view_entry)
        if key not in self._blobs:
            data = self.view(view)
            self._budget.count_arrays(len(data))
            self._blobs[key] = bytes(data)
        return self._blobs[key]

    def view(self, number: int) -> memoryview:
        """Bytes of a buffer view; uncompressed data take precedence over a compressed copy."""
        view_entry = entry(self._header, "bufferViews", number)
        stream = _stream(view_entry)
        if stream is None or not self.is_packed(number):
            return self._bytes(*_range(view_entry))
        if number not in self._decoded:
            self._decoded[number] = _decode(number, view_entry, stream, self._bytes(*_range(stream)), self._budget)
        return self._decoded[number]

    def is_packed(self, view: int) -> bool:
        """Whether a view's data exist only in compressed form."""
        view_entry = entry(self._header, "bufferViews", view)
        if _stream(view_entry) is None:
            return False
        number = view_entry["buffer"]
        return _is_placeholder(entry(self._header, "buffers", number), number, has_binary=bool(self._binary))

    def _bytes(self, buffer: int, start: int, length: int) -> memoryview:
        data = self.bytes_of(buffer)
        if not 0 <= start <= start + length <= len(data):
            raise IndexError(f"bytes {start} to {start + length} of a buffer of {len(data)}")
        return data[start : start + length]

    def bytes_of(self, buffer: int) -> memoryview:
        """Bytes of a buffer."""
        if buffer not in self._buffers:
            source = entry(self._header, "buffers", buffer)
            self._buffers[buffer] = memoryview(self._file(source["uri"]) if "uri" in source else self._binary)
        return self._buffers[buffer]

    def replace(self, number: int, rows: NDArray[Any]) -> None:
        """Replace an accessor's data by rows decoded by an extension; the accessor's sparse changes still apply."""
        sparse = entry(self._header, "accessors", number).get("sparse")
        self._arrays[number] = self._apply_sparse(rows, sparse) if sparse else rows

    def raw(self, number: int) -> NDArray[Any]:
        """Rows (N, K) of an accessor, in the stored type."""
        if number not in self._arrays:
            self._arrays[number] = self._read(number)
        return self._arrays[number]

    def fractions(self, number: int, rows: NDArray[Any]) -> NDArray[Any]:
        """Convert rows of a normalised accessor to float32; others are returned unchanged (glTF 2.0, 3.11)."""
        if not entry(self._header, "accessors", number).get("normalized") or rows.dtype.kind == "f":
            return rows
        return np.maximum(rows.astype(np.float64) / np.iinfo(rows.dtype).max, -1).astype(np.float32)

    def _read(self, number: int) -> NDArray[Any]:
        accessor = entry(self._header, "accessors", number)
        kind, width, count = component(accessor), WIDTHS[accessor["type"]], int(accessor["count"])
        if "bufferView" in accessor:
            rows = self._rows(accessor["bufferView"], accessor.get("byteOffset", 0), kind, count, width)
        else:
            if count < 0:
                raise IndexError(f"{count} rows")
            self._budget.count_arrays(count * width * kind.itemsize)
            rows = np.zeros((count, width), kind)
        sparse = accessor.get("sparse")
        return self._apply_sparse(rows, sparse) if sparse else rows

    def _apply_sparse(self, rows: NDArray[Any], sparse: dict[str, Any]) -> NDArray[Any]:
        indices, values, count = sparse["indices"], sparse["values"], int(sparse["count"])
        changed = self._rows(indices["bufferView"], indices.get("byteOffset", 0), component(indices), count, 1)[:, 0]
        new_values = self._rows(values["bufferView"], values.get("byteOffset", 0), rows.dtype, count, rows.shape[1])
        if len(changed) and not 0 <= int(changed.min()) <= int(changed.max()) < len(rows):
            raise UnusableError(f"a sparse accessor changes a row that does not exist among its {len(rows)}")
        self._budget.count_arrays(rows.nbytes)
        rows = rows.copy()
        rows[changed] = new_values
        return rows

    def _rows(self, view: int, start: int, kind: np.dtype[Any], count: int, width: int) -> NDArray[Any]:
        data = self.view(view)
        size = kind.itemsize * width
        step = int(entry(self._header, "bufferViews", view).get("byteStride", size))
        if count < 0 or start < 0 or step < size or (count and start + (count - 1) * step + size > len(data)):
            raise IndexError(f"{count} rows from byte {start} of {len(data)}")
        shape, strides = (count, width), (step, kind.itemsize)
        return np.ndarray(shape, kind, data, start, strides) if count else np.zeros(shape, kind)


def _range(view: dict[str, Any]) -> tuple[int, int, int]:
    """Buffer, first byte and length of a view or of its compressed stream."""
    return view["buffer"], view.get("byteOffset", 0), view["byteLength"]


def component(accessor: dict[str, Any]) -> np.dtype[Any]:
    """Component type of an accessor."""
    if accessor["componentType"] not in COMPONENTS:
        raise UnusableError(f"its accessors have the unknown type {check.shortened(accessor['componentType'])}")
    return np.dtype(COMPONENTS[accessor["componentType"]])


def _stream(view: dict[str, Any]) -> dict[str, Any] | None:
    """Extension entry of a compressed view, with place and layout of its bytes; None for an uncompressed view."""
    extensions = view.get("extensions", {})
    return next((extensions[name] for name in MESHOPT if name in extensions), None)


def _is_placeholder(buffer: dict[str, Any], number: int, *, has_binary: bool) -> bool:
    """Whether a buffer is only a placeholder for decoded bytes."""
    is_fallback = any(buffer.get("extensions", {}).get(name, {}).get("fallback") for name in MESHOPT)
    return "uri" not in buffer and (is_fallback or number > 0 or not has_binary)


def _decode(number: int, view: dict[str, Any], stream: dict[str, Any], data: memoryview, budget: Budget) -> memoryview:
    """Decode a view's compressed bytes; `stream`, the extension's entry, states their layout.

    The view and its number are for error messages; `budget` counts the decoded bytes before they are allocated.
    """
    count, stride = int(stream["count"]), int(stream["byteStride"])
    if count < 0 or stride < 0:
        raise UnusableError(f"its buffer view {number} has {count} rows of {stride} bytes")
    if view.get("byteStride", stride) != stride:
        raise UnusableError(f"its buffer view {number} has rows of {view['byteStride']} bytes, and {stride} compressed")
    budget.count_unpacked(count * stride)
    try:
        words = _core.decode_meshopt(
            np.frombuffer(data, np.uint8), count, stride, stream["mode"], stream.get("filter", "NONE")
        )
    except (SceneError, ValueError) as error:
        raise UnusableError(f"its buffer view {number} cannot be decoded: {error}") from None
    return words.view(np.uint8)[: count * stride].data
