"""Near geometry for engines: light in vertex colours, unlit materials, and one GLB of few primitives.

The quads show the far part in nearfar's light, so the near part has the same light, which files of glTF cannot describe
otherwise. Colours of materials without a texture join the light, and their faces one primitive.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import glb
from nearfar._impostor.quads import Point
from nearfar._scene.glb_surfaces import ImageEncoder
from nearfar._scene.scene import Scene
from nearfar._scene.srgb import to_linear

STEP = 2.0**-11
"""Step of near positions, metres: off by at most a quarter of a millimetre along each axis."""

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class NearFile:
    """A GLB of near geometry about O, whose images are named by the numbers of its textures."""

    data: bytes
    images: Callable[[str], Any]
    """Returns the encoded image of a name."""
    error_m: float
    """Greatest error of a position along an axis, metres."""
    lost: tuple[str, ...]
    """Properties of the scene that the file cannot show."""


def encode_near(
    near: Scene, center: Point, reach: float, *, compressed: bool, encode_image: ImageEncoder
) -> NearFile | None:
    """Encode near geometry about O as a GLB; None if rounding leaves no face with an area."""
    parts, lost = _lit_parts(near, np.array(center), reach)
    core = _core.Scene(parts)
    suffix = "png" if encode_image(np.zeros((1, 1, 4), np.uint8)).media_type == "image/png" else "webp"
    names: list[str | None] = [f"{number}.{suffix}" for number in range(core.texture_count)]
    encoding: dict[str, Any] = {"step": STEP, "compressed": compressed}
    group = np.zeros(1, np.uint16)  # of all objects
    export = _core.Export(core, group, 1, names=list(near.object_names), images=names, encoding=encoding)
    data, facts = export.glb(0, uris=[None] * len(export.shared()))
    if not facts["drawn"]:
        return None
    textures = parts["textures"]
    return NearFile(data, lambda name: encode_image(textures[names.index(name)]), facts["position_error"], tuple(lost))


def embed_images(writer: glb.Writer, document: dict[str, Any], near: NearFile) -> None:
    """Store the images of near geometry in its file."""
    for entry in document.get("images", []):
        image = near.images(entry.pop("uri"))
        entry |= {"bufferView": writer.view(image.data), "mimeType": image.media_type}


def _lit_parts(near: Scene, center: Floats, reach: float) -> tuple[dict[str, Any], list[str]]:
    """Return the parts of a scene about O with unlit materials and light in vertex colours, and what is lost."""
    parts = _core.scene_parts(near._core)
    parts["placements"] = parts["placements"].copy()
    parts["placements"][:, :, 3] += np.array(parts["origin"]) - center
    parts["origin"] = (0.0, 0.0, 0.0)
    surfaces = _Surfaces(parts)
    placed = zip(parts["meshes"], parts["placements"], strict=True)
    parts["meshes"] = [_lit_mesh(mesh, placement, surfaces, reach) for mesh, placement in placed]
    return parts | surfaces.unlit(), surfaces.lost()


class _Surfaces:
    """Materials of a scene with a last one, white, for faces without a material."""

    def __init__(self, parts: dict[str, Any]) -> None:
        def with_last(name: str, last: Any) -> NDArray[Any]:
            values = parts[name]
            return np.concatenate([values, np.full((1, *values.shape[1:]), last, values.dtype)])

        self.colors = with_last("material_colors", 1.0).astype(np.float64)
        self.textures = with_last("material_textures", -1)
        self.cutoffs = with_last("material_cutoffs", np.nan)
        self.emissions = with_last("material_emissions", 0.0).astype(np.float64)
        self.emission_textures = with_last("material_emission_textures", -1)
        self.is_unlit = with_last("material_unlit", False)
        self._tags = with_last("material_tags", 0)

    def unlit(self) -> dict[str, Any]:
        """Return the materials that remain: textures and cut-out alpha."""
        colors = np.ones((len(self.colors), 4), np.float32)
        is_cut = ~np.isnan(self.cutoffs)
        colors[is_cut, 3] = self.colors[is_cut, 3]
        return {
            "material_colors": colors,
            "material_textures": self.textures,
            "material_cutoffs": self.cutoffs,
            "material_emissions": np.zeros((len(colors), 3), np.float32),
            "material_emission_textures": np.full(len(colors), -1, np.int32),
            "material_unlit": np.ones(len(colors), np.bool_),
            "material_tags": np.zeros_like(self._tags),
        }

    def is_glowing(self) -> NDArray[np.bool_]:
        """Whether materials emit light that vertex colours can show: without textures."""
        return self.emissions.any(axis=1) & (self.textures < 0) & (self.emission_textures < 0)

    def lost(self) -> list[str]:
        count = int((self.emissions.any(axis=1) & ~self.is_glowing()).sum())
        return [f"emission of {count} textured materials"] if count else []


def _lit_mesh(mesh: _core.Mesh, placement: Floats, surfaces: _Surfaces, reach: float) -> _core.Mesh:
    """Return a mesh whose corners have their own vertices, coloured by material and light.

    Its faces are in the order of their colours, which saves two fifths of the colours' bytes.
    """
    parts = _core.mesh_parts(mesh)
    faces = parts["faces"]
    rows = faces.ravel()
    material = np.where(parts["materials"] < 0, len(surfaces.colors) - 1, parts["materials"])
    normals = _normals(parts, placement, reach).reshape(-1, 3)
    light = _core.irradiance(np.ascontiguousarray(normals, np.float32)).astype(np.float64).reshape(-1, 3, 3)
    light[surfaces.is_unlit[material]] = 1.0
    color = surfaces.colors[material][:, None, :3] * light
    alpha = np.full((len(rows), 1), 255, np.uint8)
    if parts["colors"] is not None:
        vertex_colors = parts["colors"][rows]
        color *= to_linear(vertex_colors[:, :3] / 255.0).reshape(-1, 3, 3)
        alpha = vertex_colors[:, 3:]
    color += np.where(surfaces.is_glowing()[material, None], surfaces.emissions[material], 0.0)[:, None]
    codes = _core.encode_srgb(np.clip(color, 0.0, 1.0).astype(np.float32).ravel()).reshape(-1, 3)
    order = np.lexsort(codes[::3].T[::-1])
    corners = (3 * order[:, None] + np.arange(3)).ravel()
    return _core.Mesh(
        np.ascontiguousarray(parts["positions"][rows[corners]]),
        np.arange(len(rows), dtype=np.uint32).reshape(-1, 3),
        uvs=None if parts["uvs"] is None else np.ascontiguousarray(parts["uvs"][rows[corners]]),
        colors=np.ascontiguousarray(np.concatenate([codes, alpha], axis=1)[corners]),
        objects=np.ascontiguousarray(parts["objects"][order]),
        materials=np.ascontiguousarray(material[order], np.int32),
    )


def _normals(parts: dict[str, Any], placement: Floats, reach: float) -> Floats:
    """Return the unit normals (F, 3, 3) with which corners are lit, relative to O.

    A face is lit on the side of O if all users are on that side of its plane. Faces whose planes cross the region are
    lit on the side of their normals, or of their winding if they have none.
    """
    points = parts["positions"].astype(np.float64) @ placement[:, :3].T + placement[:, 3]
    a, b, c = (points[parts["faces"][:, corner]] for corner in range(3))
    axes = placement[:, :3].T
    mirror = -1.0 if np.linalg.det(axes) < 0.0 else 1.0
    face = _unit(mirror * np.cross(b - a, c - a))
    stated = None if parts["normals"] is None else parts["normals"][parts["faces"]].astype(np.float64)
    if stated is not None:
        # Cofactors: the inverse transpose times the determinant, which flat placements have, too.
        stated = _unit(mirror * stated @ np.cross(np.roll(axes, -1, axis=0), np.roll(axes, -2, axis=0)))
        total = stated.sum(axis=1)
        face[np.einsum("fi,fi->f", total, face) < 0.0] *= -1.0
    height = -np.einsum("fi,fi->f", face, a)
    face[height < -reach] *= -1.0
    corners = np.repeat(face[:, None], 3, axis=1)
    if stated is not None:
        side = np.where(np.einsum("fi,fi->f", total, face) < 0.0, -1.0, 1.0)[:, None, None]
        corners = np.where(stated.any(axis=2, keepdims=True), stated * side, corners)
        corners[~total.any(axis=1)] = face[~total.any(axis=1), None]
    return corners


def _unit(vectors: Floats) -> Floats:
    """Scale vectors to length 1; zero stays."""
    length = np.linalg.norm(vectors, axis=-1, keepdims=True)
    return np.asarray(vectors / np.where(length > 0.0, length, 1.0))
