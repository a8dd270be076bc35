"""Collects the distinct materials and textures of a scene that is being built."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from nearfar._scene.arrays import texture_of
from nearfar._scene.materials import BaseColor
from nearfar._scene.samplers import Sampler
from nearfar._scene.undrawn import GltfMaterial

NO_TEXTURE = -1
"""Index that means no texture."""


class Material(NamedTuple):
    """A material in the form that kernels take."""

    color: tuple[float, ...]
    texture: int
    cutoff: float | None
    emission: tuple[float, ...]
    emission_texture: int
    unlit: bool
    tag: int
    """Tag of the undrawn properties; 0 for none."""


class MaterialList:
    """Numbers materials and textures: equal materials share a number, as do textures of the same array and sampler."""

    def __init__(self) -> None:
        self._numbers: dict[Material, int] = {}
        self._textures: dict[tuple[int, Sampler], tuple[NDArray[np.uint8], NDArray[np.uint8], int]] = {}
        """Maps a texture's id and its sampler to the passed array, its converted form, and its number."""
        self.undrawn: dict[int, GltfMaterial] = {}
        """Undrawn properties of materials, by tag."""

    def __len__(self) -> int:
        return len(self._numbers)

    def add(self, material: BaseColor) -> int:
        """Add a checked material and return its number."""
        tag = 0 if material.undrawn is None else material.undrawn.tag
        if material.undrawn is not None:
            self.undrawn[tag] = material.undrawn
        color, emission = (np.array(numbers, np.float32) for numbers in (material.factor, material.emission))
        drawn = Material(
            tuple(color.tolist()),
            self._texture(material.texture, material.sampler),
            material.cutoff,
            tuple(emission.tolist()),
            self._texture(material.emission_texture, material.emission_sampler) if emission.any() else NO_TEXTURE,
            material.unlit,
            tag,
        )
        return self._numbers.setdefault(drawn, len(self._numbers))

    def _texture(self, texture: NDArray[np.uint8] | None, sampler: Sampler) -> int:
        if texture is None:
            return NO_TEXTURE
        key = (id(texture), sampler)
        if key not in self._textures:
            # The reference keeps the array alive, so that its id is not reused.
            self._textures[key] = (texture, texture_of("texture", texture), len(self._textures))
        return self._textures[key][-1]

    def arguments(self) -> dict[str, Any]:
        """Materials and textures as arguments of `_core.Scene`."""
        textures = [(texture, sampler) for (_, sampler), (_, texture, _) in self._textures.items()]
        return surface_arguments([*self._numbers], textures)


def surface_arguments(
    materials: Sequence[Material], textures: Sequence[tuple[NDArray[np.uint8], Sampler]]
) -> dict[str, Any]:
    """Materials, and textures with their samplers, as arguments of `_core.Scene`."""
    columns = zip(*materials, strict=True) if materials else [()] * len(Material._fields)
    colors, numbers, cutoffs, emissions, emission_numbers, unlit, tags = columns
    return {
        "material_colors": np.array(colors, np.float32).reshape(-1, 4),
        "material_textures": np.array(numbers, np.int32),
        "material_cutoffs": np.array([np.nan if cutoff is None else cutoff for cutoff in cutoffs], np.float32),
        "material_emissions": np.array(emissions, np.float32).reshape(-1, 3),
        "material_emission_textures": np.array(emission_numbers, np.int32),
        "material_unlit": np.array(unlit, bool),
        "material_tags": np.array(tags, np.uint64),
        "textures": [texture for texture, _ in textures],
        "texture_samplers": np.array([sampler for _, sampler in textures], np.uint32).reshape(-1, 3),
    }
