"""Reads the materials of glTF documents and decodes those of their images that are drawn."""

from __future__ import annotations

import io
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from nearfar._base.errors import UnusableError
from nearfar._base.glb import entry
from nearfar._scene import coordinates
from nearfar._scene.budget import Budget, TooLargeError
from nearfar._scene.coordinates import Coordinates
from nearfar._scene.emission import DARK, emission_of
from nearfar._scene.gltf import ktx2
from nearfar._scene.gltf.buffers import Buffers
from nearfar._scene.materials import BaseColor, Described, Materials

NONE = -1
"""Index that means no material."""

_GLOSS = "KHR_materials_pbrSpecularGlossiness"
_GLOSS_BYTES = 128
"""Bytes per texel while trimesh converts a material of that extension: four images, float64 RGBA."""


@dataclass
class _Drawn:
    """Drawn part of a material, with trimesh's field names."""

    baseColorFactor: None = None  # noqa: N815 - full precision comes from the document
    baseColorTexture: Any = None  # noqa: N815
    emissiveTexture: Any = None  # noqa: N815
    alphaMode: Any = None  # noqa: N815
    alphaCutoff: Any = None  # noqa: N815


class MaterialReader:
    """Reads the materials of one document; each image is decoded once and only if it is drawn.

    Parameters
    ----------
    header
        The document.
    buffers
        Reads the document's images.
    resolver
        Trimesh's resolver, which reads images beside the document.
    materials
        Converts materials to base colours.
    budget
        Counts decoded bytes of images.
    """

    def __init__(
        self, header: dict[str, Any], buffers: Buffers, resolver: Any, materials: Materials, budget: Budget
    ) -> None:
        self._header, self._buffers, self._resolver = header, buffers, resolver
        self._materials, self._budget = materials, budget
        self._surfaces: dict[int, Any] = {}
        self._pictures: dict[bytes, Any] = {}
        self._coordinates: dict[int, Coordinates | None] = {NONE: None}

    def material(self, number: int) -> list[BaseColor]:
        """Return the material of an index, in a list."""
        described = entry(self._header, "materials", number)
        return self._materials.base_colors(
            self._material_with_images(number, described), described=Described(described, self._buffers.texture)
        )

    def decode(self, numbers: Iterable[int]) -> None:
        """Decode in parallel the images that materials draw, before `material` requests them one by one."""
        self._materials.decode(image for number in numbers for image in self._images(number))

    def _images(self, number: int) -> list[Any]:
        described = entry(self._header, "materials", number)
        if _GLOSS in (described.get("extensions") or ()):
            return []
        opened = self._material_with_images(number, described)
        images = [opened.baseColorTexture] + ([] if emission_of(described) == DARK else [opened.emissiveTexture])
        return [image for image in images if image is not None]

    def coordinates(self, number: int) -> Coordinates | None:
        """Texture coordinates that a material uses, if any; also valid for `NONE`."""
        if number not in self._coordinates:
            self._coordinates[number] = coordinates.drawn_texture_coordinates(entry(self._header, "materials", number))
        return self._coordinates[number]

    def _material_with_images(self, number: int, described: dict[str, Any]) -> Any:
        """Material whose images are open, but not decoded."""
        if number not in self._surfaces:
            self._surfaces[number] = self._surface(number, described)
        return self._surfaces[number]

    def _surface(self, number: int, described: dict[str, Any]) -> Any:
        surface = described.get("pbrMetallicRoughness", {})
        if _GLOSS in (described.get("extensions") or ()):
            read = self._converted[number]
        else:
            read = _Drawn(alphaMode=described.get("alphaMode"), alphaCutoff=described.get("alphaCutoff"))
        for owner, key in ((surface, "baseColorTexture"), (described, "emissiveTexture")):
            if coordinates.is_texture(key, owner.get(key)):
                picture = self._picture(owner[key]["index"])
                if picture is not None:
                    setattr(read, key, picture)
        return read

    def _picture(self, number: Any) -> Any:
        """Image of a texture; None if it cannot be read."""
        from PIL import Image

        data = self._buffers.picture(number)
        if data is None:
            return None
        if data not in self._pictures:
            try:
                is_packed = data.startswith(ktx2.SIGNATURE)
                picture = (
                    Image.fromarray(ktx2.decode(data, self._budget)) if is_packed else Image.open(io.BytesIO(data))
                )
            except TooLargeError:
                raise
            except UnusableError as error:
                raise UnusableError(f"its texture {number}, a KTX 2 image, {error}") from None
            except Exception:  # Pillow's decoders raise errors of any type
                picture = None
            self._pictures[data] = picture
        return self._pictures[data]

    @cached_property
    def _converted(self) -> list[Any]:
        """All materials as read by trimesh, which converts specular–glossiness ones."""
        from trimesh.exchange.gltf import _parse_materials

        for material in self._header.get("materials", []):
            if isinstance(material, dict) and _GLOSS in (material.get("extensions") or ()):
                self._count_gloss(material["extensions"][_GLOSS])
        converted: list[Any] = _parse_materials(self._header, _Views(self._buffers), self._resolver)
        return converted

    def _count_gloss(self, described: dict[str, Any]) -> None:
        """Count the memory that trimesh needs to convert a material's images."""
        from PIL import Image

        for key in ("diffuseTexture", "specularGlossinessTexture"):
            data = self._buffers.picture(described[key]["index"]) if key in described else None
            if data is not None:
                try:
                    with Image.open(io.BytesIO(data)) as image:
                        size = image.size
                except Exception:  # Pillow's decoders raise errors of any type; trimesh draws without the image
                    continue
                self._budget.take(_GLOSS_BYTES * size[0] * size[1])


class _Views:
    """Buffer views of a document, as trimesh expects them; each is copied on access."""

    def __init__(self, buffers: Buffers) -> None:
        self._buffers = buffers

    def __getitem__(self, number: int) -> bytes:
        return self._buffers.blob(number)
