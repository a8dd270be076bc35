"""Textured quads of a far part: their arrays, the least visible ones dropped, and a scene of them."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from nearfar._scene.builder import SceneBuilder
from nearfar._scene.emission import UNLIT
from nearfar._scene.materials import BaseColor
from nearfar._scene.samplers import CLAMP, REPEATED, Sampler
from nearfar._scene.scene import Scene
from nearfar._scene.undrawn import GltfMaterial, TextureSource

Point = tuple[float, float, float]

CUTOFF = 0.5
"""Least alpha of a masked quad's texel that is drawn."""

_NAME = "impostors"
"""Name of the quads' object, unless the scene has such an object."""

_ONE = np.float32(1)
_LINEAR = REPEATED[2]
"""Filter that interpolates between texels."""
_SAMPLER: Sampler = (CLAMP, CLAMP, _LINEAR)


@dataclass(frozen=True, eq=False)
class Quads:
    """Quads as triangles that share one texture."""

    vertices: NDArray[np.float32]
    """(V, 3) metres, relative to the centre O."""
    uvs: NDArray[np.float32]
    """(V, 2) texture coordinates, v pointing up."""
    faces: NDArray[np.uint32]
    """(F, 3) vertex numbers."""
    owners: NDArray[np.int32]
    """(F,) quad of each face."""
    objects: NDArray[np.int32]
    """(Q,) number of the object of most of each quad's texels; −1 without one."""
    masked: NDArray[np.bool_]
    """(Q,) whether each quad has transparent texels."""
    atlas: NDArray[np.uint8]
    """(H, W, 4) sRGB and alpha, row 0 on top."""
    layers: tuple[tuple[Point, int], ...]
    """Centre of each layer relative to O, and its number of quads; quads are in the order of their layers."""
    shared: int = 0
    """Number of quads of an earlier bake, which are the first."""

    @classmethod
    def from_kernel(cls, baked: dict[str, Any]) -> Self:
        """Take the quads of `_core.bake_impostors`."""
        layers = tuple((tuple(center), count) for center, count in baked["layers"])
        arrays = {name: baked[name] for name in ("vertices", "faces", "objects", "masked", "atlas")}
        # Rounded so that 1 − v is exact: files have v downwards.
        uvs = np.column_stack([baked["uv"][:, 0], _ONE - (_ONE - baked["uv"][:, 1])])
        return cls(**arrays, uvs=uvs, owners=baked["quads"], layers=layers, shared=baked["shared"])

    def __len__(self) -> int:
        return len(self.masked)

    @property
    def nbytes(self) -> int:
        """Bytes of geometry and texture in memory."""
        return self.vertices.nbytes + self.uvs.nbytes + self.faces.nbytes + self.atlas.nbytes

    @cached_property
    def rectangles(self) -> NDArray[np.int64]:
        """Left, top, right and bottom edge (Q, 4) of each quad's texels in the atlas."""
        height, width = self.atlas.shape[:2]
        edges = np.rint(self.uvs.astype(np.float64) * (width, height)).astype(np.int64)
        edges[:, 1] = height - edges[:, 1]
        owner = np.zeros(len(self.vertices), np.int64)
        owner[self.faces] = self.owners[:, None]
        low, high = np.full((len(self), 2), max(width, height)), np.zeros((len(self), 2), np.int64)
        np.minimum.at(low, owner, edges)
        np.maximum.at(high, owner, edges)
        return np.column_stack([low, high])

    @cached_property
    def texels(self) -> NDArray[np.int64]:
        """Number of texels (Q,) that each quad shows."""
        shown = self.atlas[..., 3] >= 255.0 * CUTOFF
        sums = np.pad(shown.cumsum(0, np.int64).cumsum(1), ((1, 0), (1, 0)))
        left, top, right, bottom = self.rectangles.T
        inside: NDArray[np.int64] = sums[bottom, right] - sums[top, right] - sums[bottom, left] + sums[top, left]
        return inside

    def keep_largest(self, triangles: int) -> Self:
        """Drop the quads that show fewest texels until at most so many triangles are left; their texels are cleared."""
        if len(self.faces) <= triangles:
            return self
        sizes = np.bincount(self.owners, minlength=len(self))
        order = np.argsort(-self.texels, kind="stable")
        is_kept = np.zeros(len(self), np.bool_)
        is_kept[order[np.cumsum(sizes[order]) <= triangles]] = True
        return self.select(is_kept)

    def select(self, is_kept: NDArray[np.bool_]) -> Self:
        """Return the quads that a mask (Q,) keeps; the texels of the others are cleared."""
        chosen = is_kept[self.owners]
        rows, corners = np.unique(self.faces[chosen], return_inverse=True)
        numbers = np.cumsum(is_kept) - 1
        atlas = self.atlas.copy()
        for left, top, right, bottom in self.rectangles[~is_kept].tolist():
            # A ring of one texel around each quad repeats its border.
            atlas[max(top - 1, 0) : bottom + 1, max(left - 1, 0) : right + 1] = 0
        ends = np.cumsum([count for _, count in self.layers])
        parts = np.split(is_kept, ends[:-1])
        return replace(
            self,
            vertices=self.vertices[rows],
            uvs=self.uvs[rows],
            faces=corners.reshape(-1, 3).astype(np.uint32),
            owners=numbers[self.owners[chosen]].astype(np.int32),
            objects=self.objects[is_kept],
            masked=self.masked[is_kept],
            atlas=atlas,
            layers=tuple((at, int(part.sum())) for (at, _), part in zip(self.layers, parts, strict=True)),
            shared=int(is_kept[: self.shared].sum()),
        )

    def scene(self, center: Point, origin: NDArray[np.float64], names: Sequence[str] = ()) -> Scene:
        """Make a scene of the quads about a centre, with two materials.

        `names` are those of the objects by number; a quad without a number belongs to an object with another name.
        Without names all quads are one object.
        """
        build = SceneBuilder()
        opaque = BaseColor(texture=self.atlas, unlit=True, sampler=_SAMPLER, undrawn=MATERIAL)
        opaque_number, masked_number = (
            build._materials.add(replace(opaque, cutoff=cutoff)) for cutoff in (None, CUTOFF)
        )
        is_masked = self.masked[self.owners]
        order = np.argsort(is_masked, kind="stable")
        materials = np.where(is_masked, masked_number, opaque_number)[order]
        owners: NDArray[np.intp] | None = None
        if names:
            numbers, objects = np.unique(self.objects, return_inverse=True)
            build.objects([names[number] if number >= 0 else _free_name(names) for number in numbers.tolist()])
            owners = objects[self.owners[order]]
        mesh = build.mesh(
            self.vertices, self.faces[order], material=materials, uvs=self.uvs, face_object=owners, copy=True
        )
        place = np.eye(4)
        place[:3, 3] = center
        build.instance(mesh, place, name=None if names else _NAME)
        return Scene(**build._assemble(origin=origin))


def _free_name(taken: Sequence[str]) -> str:
    name, number = _NAME, 1
    while name in taken:
        number += 1
        name = f"{_NAME}_{number}"
    return name


def _material() -> GltfMaterial:
    """Return the material of the quads in files; without mipmaps, which would mix neighbours in the texture."""
    sampler = {"wrapS": CLAMP, "wrapT": CLAMP, "magFilter": _LINEAR, "minFilter": _LINEAR}
    surface = {"metallicFactor": 0.0, "baseColorTexture": {"index": 0}}
    material = {"pbrMetallicRoughness": surface, "doubleSided": True, "extensions": {UNLIT: {}}}
    return GltfMaterial(material, (TextureSource(sampler=json.dumps(sampler)),))


MATERIAL = _material()
