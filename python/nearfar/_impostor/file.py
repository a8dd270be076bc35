"""Writes the quads of impostors, alone or with near geometry, as a GLB that any engine shows without a shader."""

from __future__ import annotations

import json
from dataclasses import dataclass
from functools import partial
from typing import Any, Literal, get_args

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import glb
from nearfar._base.version import __version__
from nearfar._impostor import packing
from nearfar._impostor.bake import Region
from nearfar._impostor.quads import MATERIAL, Quads
from nearfar._scene.emission import UNLIT
from nearfar._scene.scene import Scene

Textures = Literal["webp", "png"]
"""Kind of image in a file of impostors."""
Geometry = Literal["meshopt", "plain"]
"""Encoding of geometry: packed by `EXT_meshopt_compression`, or arrays that need no extension."""

TEXTURES: tuple[Textures, ...] = get_args(Textures)
GEOMETRIES: tuple[Geometry, ...] = get_args(Geometry)

QUALITY = 80
"""Quality of WebP, 0 to 100."""
_PNG_LEVEL = 9

EXTRAS_KEY = "nearfar"
_NAME = "impostors"
_WEBP = "EXT_texture_webp"
_MAX_SHORT = 65535
"""Greatest number of vertices of 16-bit corners: some interfaces reserve the last index."""


@dataclass(frozen=True)
class EncodedFile:
    """A GLB and its measures."""

    data: bytes
    error_px: float
    """Greatest error by which rounded positions of quads are seen in the region, pixels of 1/20 degree."""
    uv_error: float
    """Greatest error of the quads' rounded texture coordinates, texels."""
    near_error: float
    """Greatest error of a rounded near position along an axis, metres."""
    draw_calls: int
    """Number of primitives."""
    lost: tuple[str, ...]
    """Properties of the near geometry that the file cannot show."""


def encode(
    quads: Quads | None,
    region: Region,
    *,
    near: Scene | None = None,
    textures: Textures = "webp",
    geometry: Geometry = "meshopt",
) -> EncodedFile:
    """Encode quads, near geometry or both about the centre O of their region as one GLB; equal input gives equal bytes.

    Quads are at most six meshes, one for each sector about O, with an opaque and a `MASK` primitive each. They share
    one texture, which is clamped, filtered and without mipmaps. Static near geometry has a primitive for each texture;
    its materials are unlit, and its vertex colours have nearfar's light. Dynamic objects are nodes with their names.
    The data are empty if there is nothing to show. ValueError for a texture too large for WebP.
    """
    # Imported here: only files need an imaging library.
    from nearfar._impostor.near import embed_images, encode_near
    from nearfar._scene import glb_surfaces

    encode_image = partial(glb_surfaces.png, level=_PNG_LEVEL) if textures == "png" else glb_surfaces.webp(QUALITY)
    is_packed = geometry == "meshopt"
    encoded = None
    if near is not None and near.triangle_count:
        encoded = encode_near(near, region.center, region.reach, compressed=is_packed, encode_image=encode_image)
    writer = glb.Writer()
    document: dict[str, Any] = {}
    if encoded is not None:
        writer, document = glb.Writer.adding_to(encoded.data)
        embed_images(writer, document, encoded)
    packed = None
    if quads is not None and len(quads):
        packed = packing.pack(quads, region.reach, region.error_px)
        _FarWriter(writer, document, is_packed=is_packed).add(packed, encode_image(quads.atlas))
    elif encoded is None:
        return EncodedFile(b"", 0.0, 0.0, 0.0, 0, ("the whole geometry: it is empty or smaller than its rounding",))
    center = list(region.center)
    extras = {"center": center, "origin": center, "reach": region.reach, "r2": region.r2, "error_px": region.error_px}
    if packed is not None:
        extras["rounding_px"] = packed.error_px
    roots = [0] if encoded is not None else []
    roots += [len(document["nodes"]) - 1] if packed is not None else []
    document |= {
        "asset": {"version": "2.0", "generator": f"nearfar {__version__}"},
        "scene": 0,
        "scenes": [{"nodes": roots, "extras": {EXTRAS_KEY: extras}}],
    }
    return EncodedFile(
        data=writer.encode(document, spaces=False),
        error_px=0.0 if packed is None else packed.error_px,
        uv_error=0.0 if packed is None else packed.uv_error,
        near_error=0.0 if encoded is None else encoded.error_m,
        draw_calls=sum(len(mesh["primitives"]) for mesh in document["meshes"]),
        lost=() if encoded is None else encoded.lost,
    )


class _FarWriter:
    """Adds quads to a document: a node with a child for each sector."""

    def __init__(self, writer: glb.Writer, document: dict[str, Any], *, is_packed: bool) -> None:
        self._writer, self._document, self._is_packed = writer, document, is_packed

    def add(self, packed: packing.Packed, image: Any) -> None:
        """Add the quads with the image of their texture."""
        materials = self._add_materials(self._add_texture(image))
        arrays = {
            "POSITION": _Array(packed.steps, packed.exponents),
            "TEXCOORD_0": _Array(packed.uv_steps, packed.uv_exponents),
        }
        views = {name: self._view(array) for name, array in arrays.items()}
        children: list[int] = []
        for sector in packed.sectors:
            attributes = {}
            for name, array in arrays.items():
                rows = array.values[sector.vertices]
                extent = [rows.min(axis=0), rows.max(axis=0)] if name == "POSITION" else None
                start = sector.vertices.start
                attributes[name] = self._writer.accessor(views[name], rows, start, extent=extent)
            indices = self._corners(sector)
            primitives = [
                {"attributes": attributes, "indices": accessor, "material": materials[is_masked]}
                for (is_masked, _), accessor in zip(sector.parts, indices, strict=True)
            ]
            mesh = self._append("meshes", {"primitives": primitives})
            children.append(self._append("nodes", {"name": f"{_NAME}_{len(children)}", "mesh": mesh}))
        self._append("nodes", {"name": _NAME, "children": children})

    def _view(self, array: _Array) -> int:
        values = array.values
        if not self._is_packed:
            return self._writer.view(values, "vertices")
        data = _core.encode_meshopt_rows(array.words)
        count, stride = len(values), values.itemsize * values.shape[1]
        return self._writer.packed_view(data, "vertices", count=count, stride=stride, exponential=True)

    def _corners(self, sector: packing.Sector) -> list[int]:
        """Add the corners of a sector's faces; return the accessor of each primitive."""
        faces = np.concatenate([part for _, part in sector.parts])
        count = sector.vertices.stop - sector.vertices.start
        corners = faces.ravel().astype(np.uint16 if count <= _MAX_SHORT else np.uint32)
        if self._is_packed:
            data = _core.encode_meshopt_triangles(faces, count)
            view = self._writer.packed_view(data, "faces", count=len(corners), stride=corners.itemsize)
        else:
            view = self._writer.view(corners, "faces")
        ends = np.cumsum([3 * len(part) for _, part in sector.parts]).tolist()
        starts = [0, *ends[:-1]]
        return [self._writer.accessor(view, corners[start:end], start) for start, end in zip(starts, ends, strict=True)]

    def _add_texture(self, image: Any) -> int:
        source = self._append("images", {"bufferView": self._writer.view(image.data), "mimeType": image.media_type})
        texture: dict[str, Any] = {"source": source}
        if image.media_type == "image/webp":
            texture = {"extensions": {_WEBP: texture}}
            self._use(_WEBP, is_required=True)
        texture["sampler"] = self._append("samplers", json.loads(MATERIAL.textures[0].sampler))
        return self._append("textures", texture)

    def _add_materials(self, texture: int) -> tuple[int, int]:
        """Add an opaque and a masked material."""
        self._use(UNLIT, is_required=False)
        opaque = json.loads(json.dumps(MATERIAL.material))
        opaque["pbrMetallicRoughness"]["baseColorTexture"]["index"] = texture
        return self._append("materials", opaque), self._append("materials", opaque | {"alphaMode": "MASK"})

    def _use(self, extension: str, *, is_required: bool) -> None:
        for key in ("extensionsUsed", *(["extensionsRequired"] if is_required else [])):
            self._document[key] = sorted({*self._document.get(key, []), extension})

    def _append(self, section: str, entry: dict[str, Any]) -> int:
        entries: list[dict[str, Any]] = self._document.setdefault(section, [])
        entries.append(entry)
        return len(entries) - 1


@dataclass(frozen=True)
class _Array:
    """Rows of numbers, each a whole number of steps."""

    steps: packing.Steps
    exponents: packing.Steps
    """(N,) a step of a row is 2 to this power."""

    @property
    def values(self) -> NDArray[np.float32]:
        return np.ldexp(self.steps, self.exponents[:, None]).astype(np.float32)

    @property
    def words(self) -> NDArray[np.uint32]:
        """The numbers as the EXPONENTIAL filter packs them: an exponent of 8 bits above a mantissa of 24."""
        words = (self.exponents[:, None] << 24) | (self.steps & 0xFFFFFF)
        return np.ascontiguousarray((words & 0xFFFFFFFF).astype(np.uint32))
