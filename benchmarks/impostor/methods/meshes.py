"""Meshes with few triangles: what is visible, simplified by two libraries, and the surface of a map with range."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, Literal, get_args

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.views import Point
from benchmarks.impostor.methods import maps, place as places
from benchmarks.impostor.methods.place import Place, fill
from nearfar import _core
from nearfar._base import webp
from nearfar.lod._simplify.meshopt import MeshoptSimplifier
from nearfar.lod._simplify.quadrics import QuadricSimplifier
from nearfar.lod._simplify.surface import Base, Surface, first_alike

Library = Literal["fast-simplification", "meshoptimizer"]
LIBRARIES: tuple[Library, ...] = get_args(Library)

APART = 4.0
"""Distance between shells in the space in which they are simplified, where they begin at a distance of 1."""


def file_bytes(scene: nf.Scene, place: Place) -> int:
    """Bytes of a scene's GLB with meshopt compression, and of its textures as WebP.

    Positions are rounded by at most a quarter of a pixel of a user at the end of reach.
    """
    step = 0.5 * (place.r2 - place.reach) / places.PIXELS_PER_RADIAN
    core = scene._core
    texels = _core.scene_parts(core)["textures"]
    names: list[str | None] = [f"{number}.webp" for number in range(len(texels))]
    export = _core.Export(core, np.zeros(1, np.uint16), 1, names=[], images=names, encoding=_encoding(step))
    data, _ = export.glb(0, uris=[None] * len(export.shared()))
    return len(data) + sum(len(_webp(picture)) for picture in texels)


def _encoding(step: float) -> dict[str, Any]:
    return {"step": step, "compressed": True}


def _webp(texels: NDArray[np.uint8]) -> bytes:
    is_opaque = bool((texels[..., 3] == 255).all())
    return webp.encode(texels[..., :3] if is_opaque else texels, maps.QUALITY)


@dataclass(frozen=True, eq=False)
class Mesh:
    """Scene of triangles in place of the far part."""

    mesh: nf.Scene
    bytes: int
    setting: str
    baked_from: Point | None = None
    """Where its colours were baked from, if they were."""

    @property
    def triangles(self) -> int:
        """Number of triangles that are drawn for the far part."""
        return self.mesh.triangle_count

    def picture(self, place: Place, user: nf.Camera) -> tuple[nf.Frame, NDArray[np.bool_]]:
        """Draw near and far part; see `Method`."""
        frame = places.draw_scene(self.mesh, user)
        points = places.points_of(frame)
        is_baked = self.baked_from is not None
        if self.baked_from is not None:
            points = places.baked_at(place.far, points, self.baked_from)
        far = places.Far(frame.require("color"), frame.require("range"), points)
        return place.compose(user, far, moved=not is_baked)


class Visible:
    """Far triangles that probes see, as one surface in shells about the centre that are scaled to one size.

    Both libraries bound errors by distances. In these shells, whose radii double, an error is an angle up to a factor
    of two. Each shell is moved aside; its borders are kept in place by the libraries' treatment of open edges.
    """

    def __init__(self, place: Place, triangles: NDArray[np.bool_] | None = None) -> None:
        self._place = place
        self._base = Base(place.visible if triangles is None else place.scene.subset(triangles=triangles), "far")
        whole = self._base.surface
        center = np.subtract(place.center, place.scene.origin)
        corners = whole.positions[whole.faces].astype(np.float64) - center
        nearest = np.linalg.norm(corners, axis=2).min(axis=1)
        shell = np.maximum(np.floor(np.log2(np.maximum(nearest, 1e-6) / place.r2)), 0.0).astype(np.int64)
        # A vertex on a border is in both shells.
        keys, faces = np.unique(shell[:, None] * len(whole.positions) + whole.faces, return_inverse=True)
        vertex, vertex_shell = keys % len(whole.positions), keys // len(whole.positions)
        self._center = center
        # Both libraries keep the materials of faces, so materials also number the shells.
        self._material_count = int(whole.materials.max()) + 1
        materials = whole.materials + self._material_count * shell
        scaled = (whole.positions[vertex] - center) / self._radius(vertex_shell)
        scaled[:, 0] += APART * vertex_shell
        surface = whole.with_vertices(vertex, faces, materials.astype(np.int32))
        self._whole = replace(surface, positions=np.ascontiguousarray(scaled, np.float32))
        self._places = first_alike(self._whole.positions)
        self.count = len(whole.faces)

    def _radius(self, shell: NDArray[np.int64]) -> NDArray[np.float64]:
        return np.asarray(self._place.r2 * 2.0 ** shell[:, None])

    def simplifier(self, library: Library) -> QuadricSimplifier | MeshoptSimplifier:
        """Prepare the surface for a library."""
        return (QuadricSimplifier if library == "fast-simplification" else MeshoptSimplifier)(self._whole, self._places)

    def scene_of(self, surface: Surface) -> nf.Scene:
        """Put a simplified surface back into its place."""
        shell = np.zeros(len(surface.positions), np.int64)
        shell[surface.faces] = (surface.materials // self._material_count)[:, None]
        positions = surface.positions.astype(np.float64)
        positions[:, 0] -= APART * shell
        world = (positions * self._radius(shell) + self._center).astype(np.float32)
        materials = surface.materials % self._material_count
        return self._base.scene_of(replace(surface, positions=world, materials=materials))


def simplified(place: Place, visible: Visible, library: Library, triangles: int, budget: int | None = None) -> Mesh:
    """Simplify what is visible to a number of triangles, or with a budget to as many as keep it."""
    simplifier = visible.simplifier(library)

    def make(count: float) -> Mesh:
        scene = visible.scene_of(simplifier.level(round(count)))
        return Mesh(scene, file_bytes(scene, place), f"{visible.count:,} visible triangles")

    if budget is None:
        return make(min(triangles, visible.count))
    return fill(make, lambda made: made.bytes, budget, 100, visible.count)  # type: ignore[no-any-return]


def relief_mesh(place: Place, *, triangles: int, budget: int, size: int) -> maps.Reprojected:
    """Simplify the surface of a map with range; its colours are projected from the centre.

    The surface is a connected sheet over each face, open towards the sky. It is simplified in the coordinates u, v and
    reach / z of the face, in which planes stay planes and distances are angles that users see.
    """
    shape = maps.relief(place, size)
    corner = np.arange(shape.depth.size).reshape(shape.depth.shape)
    quads = np.stack([corner[:, :-1, :-1], corner[:, 1:, :-1], corner[:, 1:, 1:], corner[:, :-1, 1:]], axis=-1)
    faces = quads[(shape.quads > 0).all(axis=-1)][:, [[0, 1, 2], [0, 2, 3]]].reshape(-1, 3)
    used, numbers = np.unique(faces, return_inverse=True)
    face, row, column = np.unravel_index(used, shape.depth.shape)
    flat = np.column_stack(
        [2.0 * column / size - 1.0 + APART * face, 2.0 * row / size - 1.0, place.reach * shape.depth.ravel()[used]]
    ).astype(np.float32)
    surface = Surface(flat, numbers.reshape(-1, 3).astype(np.uint32), np.zeros(len(faces), np.int32))
    simple = QuadricSimplifier(surface, first_alike(flat)).level(triangles)
    face = np.rint(simple.positions[:, 0] / APART).astype(np.int64)
    u, v = simple.positions[:, 0] - APART * face, simple.positions[:, 1]
    z = place.reach / np.maximum(simple.positions[:, 2].astype(np.float64), 1e-9)
    world = maps.direction(face, u, v) * z[:, None] + place.center
    mesh = nf.Scene.from_arrays(world.astype(np.float32), simple.faces)
    geometry = file_bytes(mesh, place)

    def make(edge: float) -> tuple[NDArray[np.float32], int]:
        return maps.compress(maps.bake_color(place, round(edge)))

    color, count = fill(make, lambda made: float(made[1]), budget - geometry, maps.SMALLEST, maps.LARGEST)
    text = f"surface of 6 × {size}² texels, {geometry / 1e3:.0f} kB; colours of 6 × {color.shape[1]}²"
    return maps.Reprojected(mesh, color, np.zeros((0, 3), np.float32), count + geometry, text)
