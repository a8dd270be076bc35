"""Reads the materials of glTF documents and decodes the images that are drawn."""

from __future__ import annotations

import io
from collections.abc import Iterable
from types import SimpleNamespace
from typing import Any

from nearfar._base.errors import UnusableError
from nearfar._base.glb import entry
from nearfar._scene import coordinates
from nearfar._scene.budget import Budget, TooLargeError
from nearfar._scene.coordinates import Coordinates, base_texture
from nearfar._scene.emission import DARK, MAP, emission_of
from nearfar._scene.gltf import ktx2
from nearfar._scene.gltf.buffers import Buffers
from nearfar._scene.materials import BaseColor, MaterialEntry, Materials

NONE = -1
"""Index that means no material."""


class MaterialReader:
    """Reads the materials of one document, the `header`; each image is decoded once and only if it is drawn.

    `buffers` reads the images, `materials` converts materials to base colours, and `budget` counts decoded bytes.
    """

    def __init__(self, header: dict[str, Any], buffers: Buffers, materials: Materials, budget: Budget) -> None:
        self._header, self._buffers, self._materials, self._budget = header, buffers, materials, budget
        self._surfaces: dict[int, Any] = {}
        self._pictures: dict[bytes, Any] = {}
        self._coordinates: dict[int, Coordinates | None] = {NONE: None}

    def material(self, number: int) -> list[BaseColor]:
        """Return the material with an index, as a list of one."""
        material_entry = entry(self._header, "materials", number)
        material = self._material_with_images(number, material_entry)
        return self._materials.base_colors(material, entry=MaterialEntry(material_entry, self._buffers.texture))

    def decode(self, numbers: Iterable[int]) -> None:
        """Decode in parallel the images that materials draw, before `material` requests them one by one."""
        self._materials.decode(image for number in numbers for image in self._images(number))

    def _images(self, number: int) -> list[Any]:
        material_entry = entry(self._header, "materials", number)
        material = self._material_with_images(number, material_entry)
        emission = None if emission_of(material_entry) == DARK else material.emissiveTexture
        return [image for image in (material.baseColorTexture, emission) if image is not None]

    def coordinates(self, number: int) -> Coordinates | None:
        """Texture coordinates that a material uses, if any; also valid for `NONE`."""
        if number not in self._coordinates:
            self._coordinates[number] = coordinates.drawn_texture_coordinates(entry(self._header, "materials", number))
        return self._coordinates[number]

    def _material_with_images(self, number: int, material_entry: dict[str, Any]) -> Any:
        """Material whose images are opened but not decoded."""
        if number not in self._surfaces:
            self._surfaces[number] = self._surface(material_entry)
        return self._surfaces[number]

    def _surface(self, material_entry: dict[str, Any]) -> Any:
        # Stands for a material of trimesh; the base colour's factor is read from `material_entry`.
        names = ("baseColorFactor", "baseColorTexture", "emissiveTexture")
        drawn = {name: material_entry.get(name) for name in ("alphaMode", "alphaCutoff")}
        material = SimpleNamespace(**dict.fromkeys(names), **drawn)
        infos = {"baseColorTexture": base_texture(material_entry), "emissiveTexture": material_entry.get(MAP)}
        for name, info in infos.items():
            if coordinates.is_texture(name, info):
                setattr(material, name, self._picture(info["index"]))
        return material

    def _picture(self, number: Any) -> Any:
        """Image of a texture; None if it cannot be read."""
        from PIL import Image

        data = self._buffers.picture(number)
        if data is None:
            return None
        if data not in self._pictures:
            try:
                is_ktx2 = data.startswith(ktx2.SIGNATURE)
                picture = Image.fromarray(ktx2.decode(data, self._budget)) if is_ktx2 else Image.open(io.BytesIO(data))
            except (TooLargeError, MemoryError):
                raise
            except UnusableError as error:
                raise UnusableError(f"its texture {number}, a KTX 2 image, {error}") from None
            except Exception:  # Pillow's decoders raise errors of any type
                picture = None
            self._pictures[data] = picture
        return self._pictures[data]
