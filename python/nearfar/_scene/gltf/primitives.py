"""The primitives of glTF meshes as shapes, and their materials."""

from __future__ import annotations

import io
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base.errors import UnusableError
from nearfar._base.glb import entry
from nearfar._scene import coordinates
from nearfar._scene.budget import Budget, TooLargeError
from nearfar._scene.content import Shape
from nearfar._scene.gltf import draco, ktx2
from nearfar._scene.gltf.buffers import Buffers
from nearfar._scene.gltf.corners import faces, mode
from nearfar._scene.gltf.draco import DRACO
from nearfar._scene.gltf.extensions import needs_draco
from nearfar._scene.materials import Described, Materials, colors_of

_WIDTHS = {"POSITION": 3, "NORMAL": 3}
_UV_WIDTH = 2

_GLOSS = "KHR_materials_pbrSpecularGlossiness"
_GLOSS_BYTES = 128
"""Bytes for each texel while trimesh converts a material of that extension: four images, float64 RGBA."""


class Primitives:
    """Reads the primitives of one document.

    Parameters
    ----------
    header
        The document.
    buffers
        Its arrays.
    resolver
        Trimesh's, which reads images beside the document.
    materials
        Converts its materials.
    budget
        Counts the arrays that are made.
    """

    def __init__(
        self, header: dict[str, Any], buffers: Buffers, resolver: Any, materials: Materials, budget: Budget
    ) -> None:
        self._header, self._buffers, self._resolver = header, buffers, resolver
        self._materials, self._budget = materials, budget
        self._decoded: dict[Any, draco.Decoded] = {}
        self._pictures: dict[int, Any] = {}

    def shape(self, primitive: dict[str, Any], *, is_shared: bool) -> Shape:
        """Read a primitive; one that shares its vertices with others keeps those that it uses."""
        decoded = self._decoded_faces(primitive)
        numbers = primitive.get("attributes", {})
        if "POSITION" not in numbers:
            raise UnusableError("a primitive of its meshes has no POSITION")
        positions = self._buffers.raw(numbers["POSITION"])
        self._check_decoded(primitive, positions)
        count = len(positions)
        used: NDArray[np.int64] | slice = slice(None)
        triangles = self._faces(primitive, count) if decoded is None else decoded
        if is_shared and "indices" in primitive and decoded is None:
            used, triangles = _used(triangles, count)

        def of(number: int) -> NDArray[Any]:
            rows = self._buffers.raw(number)
            return rows[used] if len(rows) == count else rows

        rows = {
            name: self._attribute(name, width, numbers[name], of(numbers[name]))
            for name, width in _WIDTHS.items()
            if name in numbers
        }
        vertices = rows["POSITION"]
        shape = Shape(vertices, triangles)
        normals = rows.get("NORMAL")
        if normals is not None and normals.shape == vertices.shape:
            shape.normals = normals
        if "material" in primitive:
            number = primitive["material"]
            described = entry(self._header, "materials", number)
            shape.materials = self._materials.of(
                self._read_materials[number], described=Described(described, self._buffers.texture)
            )
            shown = coordinates.drawn(described)
            name = "" if shown is None else f"TEXCOORD_{shown.number}"
            if shown is not None and name in numbers:
                uvs = self._attribute(name, _UV_WIDTH, numbers[name], of(numbers[name]))
                # v points down in files.
                shape.uvs = np.column_stack([uvs[:, 0], 1 - uvs[:, 1]]) if shown.is_plain else shown.upwards(uvs)
        if "COLOR_0" in numbers:
            # COLOR_0 is linear (glTF 2.0, 3.7.2.1).
            shape.colors = colors_of(of(numbers["COLOR_0"]), len(vertices), linear=True)
        arrays = (shape.vertices, shape.faces, shape.normals, shape.uvs, shape.colors)
        self._budget.hold(sum(rows.nbytes for rows in arrays if rows is not None))
        return shape

    def _attribute(self, name: str, width: int, number: int, rows: NDArray[Any]) -> NDArray[Any]:
        """Rows of an attribute, which may be whole numbers with or without a unit (KHR_mesh_quantization)."""
        if rows.shape[1] != width:
            raise UnusableError(f"expected {width} numbers in each row of {name}, got {rows.shape[1]}")
        rows = self._buffers.fractions(number, rows)
        return rows.astype(np.float32) if width == _UV_WIDTH and rows.dtype.kind != "f" else rows

    def _faces(self, primitive: dict[str, Any], vertex_count: int) -> NDArray[Any]:
        is_indexed = "indices" in primitive
        corners = self._buffers.raw(primitive["indices"]).reshape(-1) if is_indexed else np.arange(vertex_count)
        return faces(mode(primitive), corners, is_indexed=is_indexed)

    def _decoded_faces(self, primitive: dict[str, Any]) -> NDArray[Any] | None:
        """The faces that Draco has compressed, whose vertices are decoded with them; None for plain ones."""
        if not needs_draco(primitive, self._header):
            return None
        view = primitive["extensions"][DRACO]["bufferView"]
        key = (view, *sorted(primitive["attributes"].items()))
        if key not in self._decoded:
            self._decoded[key] = draco.decoded(self._header, primitive, self._buffers.blob(view), self._budget)
        for number, rows in self._decoded[key].rows.items():
            self._buffers.replace(number, rows)
        return self._decoded[key].faces

    def _check_decoded(self, primitive: dict[str, Any], vertices: NDArray[Any]) -> None:
        """Refuse the zeros that stand where an extension was not decoded."""
        accessor = entry(self._header, "accessors", primitive["attributes"]["POSITION"])
        names = list(primitive.get("extensions", {}))
        if names and "bufferView" not in accessor and "sparse" not in accessor and not np.any(vertices):
            raise UnusableError(f"its extension {names[0]} was not decoded: save the model without it")

    @cached_property
    def _read_materials(self) -> list[Any]:
        from trimesh.exchange.gltf import _parse_materials

        for material in self._header.get("materials", []):
            if isinstance(material, dict) and _GLOSS in (material.get("extensions") or ()):
                self._count_gloss(material["extensions"][_GLOSS])
        materials: list[Any] = _parse_materials(self._header, _Views(self._buffers), self._resolver)
        for described, material in zip(self._header.get("materials", []), materials, strict=True):
            self._add_pictures(described, material)
        return materials

    def _add_pictures(self, described: dict[str, Any], material: Any) -> None:
        """Give a material those of its drawn textures that trimesh does not read."""
        surface = described.get("pbrMetallicRoughness", {})
        for owner, key in ((surface, "baseColorTexture"), (described, "emissiveTexture")):
            if coordinates.is_texture(key, owner.get(key)):
                picture = self._picture(owner[key]["index"])
                if picture is not None:
                    setattr(material, key, picture)

    def _picture(self, number: Any) -> Any:
        """The image of a texture that is a KTX 2 file; None for others."""
        from PIL import Image

        texture = self._buffers.texture(number)
        if texture is None or texture.image is None or texture.image.kind != ktx2.KIND:
            return None
        if id(texture.image) not in self._pictures:
            try:
                texels = ktx2.decode(texture.image.data, self._budget)
            except TooLargeError:
                raise
            except UnusableError as error:
                raise UnusableError(f"its texture {number}, a KTX 2 image, {error}") from None
            self._pictures[id(texture.image)] = Image.fromarray(texels)
        return self._pictures[id(texture.image)]

    def _count_gloss(self, described: dict[str, Any]) -> None:
        """Count what trimesh needs to convert a material's images."""
        from PIL import Image

        for key in ("diffuseTexture", "specularGlossinessTexture"):
            texture = self._buffers.texture(described[key]["index"]) if key in described else None
            if texture is not None and texture.image is not None:
                try:
                    with Image.open(io.BytesIO(texture.image.data)) as image:
                        size = image.size
                except Exception:  # Pillow's decoders raise errors of any type; trimesh draws without the image
                    continue
                self._budget.take(_GLOSS_BYTES * size[0] * size[1])


def _used(faces: NDArray[Any], count: int) -> tuple[NDArray[np.int64] | slice, NDArray[Any]]:
    """The vertices of `count` that faces use, and the faces between these; all of them where faces are damaged."""
    if not faces.size or int(faces.min()) < 0 or int(faces.max()) >= count:
        return slice(None), faces
    used, places = np.unique(faces, return_inverse=True)
    return (slice(None), faces) if len(used) == count else (used.astype(np.int64), places.reshape(-1, 3))


class _Views:
    """The buffer views of a document, as trimesh expects them; each is copied when it is asked for."""

    def __init__(self, buffers: Buffers) -> None:
        self._buffers = buffers

    def __getitem__(self, number: int) -> bytes:
        return self._buffers.blob(number)
