"""Near geometry and far map of a tree around a centre, for `nearfar.reduce`."""

from __future__ import annotations

import itertools
import math
from functools import partial
from typing import Any, SupportsFloat, SupportsIndex, Unpack

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check
from nearfar._base.settings import gather
from nearfar._camera.camera import Camera, CubeFace
from nearfar._camera.shot import Shot
from nearfar._cubemap.envmap import EnvMap, to_half
from nearfar._reduce.baking import MapKeywords, MapSettings, require_cpu
from nearfar._reduce.stages import NearFarSource
from nearfar._render.bake import bake
from nearfar._scene.joined import join_scenes
from nearfar._scene.scene import Scene
from nearfar.orthoview._cut import OrthoCut, grid_of
from nearfar.orthoview._flight_tree import FlightTree
from nearfar.orthoview._grid import Place
from nearfar.orthoview._renderable_tree import settings_of

FACES = 6

CHANNELS = ("color", "range")
"""Channels available for a map of a tree."""


class NearFarTree(FlightTree, NearFarSource):
    """A tree that `nearfar.reduce` accepts like a scene; for errors see `OrthoTree`."""

    def near_scene(self, center: ArrayLike, radius: SupportsFloat) -> Scene | None:
        """Read the moving objects, and the geometry of all leaves that reach within a radius of a vertical axis.

        `center` is the world position (3,) of a point on the axis; it and the radius are in metres. Returns None if
        there is neither. ValueError for values out of range, or a tree without geometry; FormatError and OSError for
        damaged or unreadable files.
        """
        axis_point, reach = np.array(check.vector("center", center)), check.positive("radius", radius)
        if not self._layout.geometry:
            raise ValueError(f"{self.path}: expected a tree with geometry, see nearfar.orthoview.build")
        viewer = self._viewer
        leaves = self._leaves_within(axis_point, reach)
        self._learn_records(leaves)
        leaves = viewer.cutter.with_guests(leaves)
        parts = [scene for scene in (viewer.near.scene(leaves), self._movers) if scene is not None]
        return join_scenes(parts) if parts else None

    def far_map(
        self,
        center: ArrayLike,
        radius: SupportsFloat,
        *,
        views: SupportsIndex = 3,
        error_px: SupportsFloat = 1.0,
        settings: MapSettings | None = None,
        **keywords: Unpack[MapKeywords],
    ) -> EnvMap:
        """Render an environment map of the world beyond a radius of the vertical axis through a centre.

        Leaves near the centre are baked as geometry; farther cells are drawn from views. Moving objects are left out.
        ValueError for values out of range; FormatError and OSError for damaged or unreadable parts of the store.

        Parameters
        ----------
        center
            World position O (3,), metres.
        radius
            Radius, metres.
        views, error_px
            As in `cut`.
        settings
            Size, samples (on a grid: 1, 4, 9 … 64) and channels, as `nearfar.MapSettings`; without "object_id", on the
            CPU.
        keywords
            Fields of `settings`, which they replace.
        """
        x, y, z = check.vector("center", center)
        reach = check.positive("radius", radius)
        baking = gather(MapSettings, settings, keywords)
        require_cpu(baking, type(self).__name__)
        size, channels = baking.face_size, tuple(baking.channels)
        grid = grid_of(check.integer("samples", baking.samples, 1, 64))
        if unknown := set(channels) - set(CHANNELS):
            raise ValueError(f"channels: expected names of {', '.join(CHANNELS)}, got {', '.join(sorted(unknown))}")
        view_settings, viewer = settings_of(views, error_px, True), self._viewer
        cameras = [Camera((x, y, z), fov=CubeFace(face), size=(size, size)) for face in range(FACES)]
        cuts = [viewer.cutter.complete_cut(camera, view_settings) for camera in cameras]
        near_leaves = viewer.near.scene(viewer.cutter.with_guests([leaf for cut in cuts for leaf in cut.leaf_places()]))
        splats = [self._far_splats(camera, cut, reach) for camera, cut in zip(cameras, cuts, strict=True)]
        render_faces = partial(self._faces, cameras, splats, near_leaves, reach)
        if grid == 1 or "range" not in channels:
            images = render_faces(("color", *({"range"} & {*channels})), grid)
        else:  # range is sampled at the texels' centres only
            images = render_faces(("color",), grid) | render_faces(("range",), 1)
        if baking.half and "range" in images:
            images["range"] = to_half(images["range"])
        return EnvMap((x, y, z), images["color"], images.get("range"))

    def _faces(
        self,
        cameras: list[Camera],
        splats_by_face: list[list[_core.OrthoSplats]],
        near_leaves: Scene | None,
        radius: float,
        channels: tuple[str, ...],
        grid: int,
    ) -> dict[str, NDArray[Any]]:
        """Render images (6, S, S, …) of all faces, with `grid` samples along each axis of a texel."""
        origin, geometry = self.origin.tolist(), None
        if near_leaves is not None:  # baked beyond the radius
            settings: dict[str, Any] = {"samples": 1, "channels": CHANNELS, "half": False, "device": None}
            env, _ = bake(near_leaves, cameras[0].position, radius, size=cameras[0].size[0] * grid, **settings)
            geometry = {"color": env.color, "range": np.asarray(env.range, np.float32)}
        faces = [
            _core.splat_orthoviews(
                splats,
                camera._core,
                Shot(cameras=(camera,), channels=channels).settings,
                origin=(origin[0], origin[1], origin[2]),
                grid=grid,
                before=None if geometry is None else {name: image[face] for name, image in geometry.items()},
            )
            for face, (camera, splats) in enumerate(zip(cameras, splats_by_face, strict=True))
        ]
        return {name: np.stack([face[name] for face in faces]) for name in channels}

    def _far_splats(self, camera: Camera, cut: OrthoCut, radius: float) -> list[_core.OrthoSplats]:
        views, center = self._viewer.views, np.array(camera.position)
        keys = cut.keys()
        views.load(keys)
        far_splats: list[_core.OrthoSplats] = []
        for key in keys:
            level, place, _ = key
            layers = views.cached_layers(key)
            if _distance_from_axis(self._layout.grid.box(level, place), center) < radius:
                layers = tuple(splats.outside_cylinder(camera.position, radius) for splats in layers)
            far_splats += layers
        views.trim(set(keys))
        return far_splats

    def _learn_records(self, leaves: list[Place]) -> None:
        """Read the records of the leaves' subtrees, which list the leaves' guests, unless a cut has read them."""
        cutter, side = self._viewer.cutter, self._layout.shard_side(0)
        for x, y, z in dict.fromkeys((x // side, y // side, z // side) for x, y, z in leaves):
            if not cutter.knows(0, (x, y, z)):
                cutter.read_record(0, (x, y, z))

    def _leaves_within(self, center: NDArray[np.float64], radius: float) -> list[Place]:
        """Places of leaves that reach within a radius of the vertical axis through a point, empty ones included."""
        grid = self._layout.grid
        ranges = []
        for axis in (0, 2):
            low, high = (center[axis] + sign * radius - grid.origin[axis] for sign in (-1.0, 1.0))
            first, last = math.floor(low / grid.cell), math.floor(high / grid.cell)
            ranges.append(range(max(first, 0), min(last + 1, grid.counts[axis])))
        columns, rows = ranges
        places = itertools.product(columns, range(grid.counts[1]), rows)
        return [place for place in places if _distance_from_axis(grid.box(0, place), center) <= radius]


def _distance_from_axis(box: NDArray[np.float64], center: NDArray[np.float64]) -> float:
    """Least distance of a box from the vertical axis through a point, metres."""
    nearest = np.clip(center, box[0], box[1]) - center
    return math.hypot(nearest[0], nearest[2])
