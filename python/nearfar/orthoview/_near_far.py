"""The near and the far part of a tree about a centre, as `nearfar.reduce` takes them."""

from __future__ import annotations

import itertools
import math
from collections.abc import Collection
from dataclasses import dataclass
from typing import Any, SupportsFloat, SupportsIndex

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check
from nearfar._camera.camera import Camera, CubeFace
from nearfar._camera.shot import Shot
from nearfar._cubemap.envmap import EnvMap
from nearfar._reduce.stages import Divided
from nearfar._render.bake import bake
from nearfar._scene.joined import joined
from nearfar._scene.scene import Scene
from nearfar.orthoview._cut import OrthoCut, grid_of
from nearfar.orthoview._flown import FlownTree
from nearfar.orthoview._grid import Place
from nearfar.orthoview._shown import settings_of

FACES = 6

CHANNELS = ("color", "range")
"""Channels that a map of a tree may have."""


@dataclass(frozen=True)
class _FarParts:
    """The parts of a map."""

    cameras: list[Camera]
    """Of its faces."""
    splats: list[list[_core.OrthoSplats]]
    """That each face shows."""
    near: Scene | None
    """Leaves that are drawn as geometry."""
    radius: float

    def baked(self, grid: int) -> dict[str, NDArray[Any]] | None:
        """Images of the geometry beyond the radius, with some samples along each axis of a texel."""
        if self.near is None:
            return None
        how: dict[str, Any] = {"samples": 1, "channels": CHANNELS, "half": False, "device": None}
        size = self.cameras[0].size[0] * grid
        env, _ = bake(self.near, self.cameras[0].position, self.radius, size=size, **how)
        return {"color": env.color, "range": np.asarray(env.range, np.float32)}


class NearFarTree(FlownTree, Divided):
    """A tree that near–far reduction takes like a scene; `OrthoTree` tells what it raises."""

    def near_scene(self, center: ArrayLike, radius: SupportsFloat) -> Scene | None:
        """Read the geometry of all leaves that reach within a radius of a vertical axis, with what moves.

        Parameters
        ----------
        center
            World position (3,) of a point on the axis, metres.
        radius
            Metres.

        Returns
        -------
        Scene or None
            None where there is nothing.

        Raises
        ------
        ValueError
            Values out of range, a tree without geometry or one that is not complete.
        FormatError, OSError
            Files that are damaged, or that cannot be read.
        """
        at, reach = np.array(check.vector("center", center)), check.positive("radius", radius)
        if not self._layout.geometry:
            raise ValueError(f"{self.path}: expected a tree with geometry, see nearfar.orthoview.build")
        viewer = self._viewer
        leaves = self._leaves_within(at, reach)
        self._know(leaves)
        leaves = viewer.cutter.with_guests(leaves)
        parts = [scene for scene in (viewer.near.scene(leaves), self._movers) if scene is not None]
        return joined(parts) if parts else None

    def far_map(
        self,
        center: ArrayLike,
        radius: SupportsFloat,
        *,
        face_size: SupportsIndex = 1024,
        samples: SupportsIndex = 4,
        channels: Collection[str] = ("color",),
        views: SupportsIndex = 3,
        error_px: SupportsFloat = 1.0,
    ) -> EnvMap:
        """Draw an environment map of what lies beyond a radius of the vertical axis through a centre.

        Leaves near the centre are baked as geometry, what is farther is drawn from views. What moves is not in it.

        Parameters
        ----------
        center
            World position O (3,), metres.
        radius
            Metres.
        face_size
            Number of texels across each face, 1 to 16,384.
        samples
            Number of colour samples of a texel, on a grid: 1, 4, 9 … 64.
        channels
            "color" always, "range" if named.
        views, error_px
            As in `cut`.

        Raises
        ------
        ValueError
            Values out of range; a tree that is not complete.
        FormatError, OSError
            Parts of the store that are damaged, or that cannot be read.
        """
        x, y, z = check.vector("center", center)
        reach = check.positive("radius", radius)
        size, grid = check.integer("face_size", face_size, 1, 16384), grid_of(check.integer("samples", samples, 1, 64))
        if unknown := set(check.texts("channels", channels)) - set(CHANNELS):
            raise ValueError(f"channels: expected names of {', '.join(CHANNELS)}, got {', '.join(sorted(unknown))}")
        settings, viewer = settings_of(views, error_px, True), self._viewer
        cameras = [Camera((x, y, z), fov=CubeFace(face), size=(size, size)) for face in range(FACES)]
        cuts = [viewer.cutter.whole(camera, settings) for camera in cameras]
        near = viewer.near.scene(viewer.cutter.with_guests([leaf for cut in cuts for leaf in cut.leaf_places()]))
        splats = [self._far_splats(camera, cut, reach) for camera, cut in zip(cameras, cuts, strict=True)]
        parts = _FarParts(cameras, splats, near, reach)
        if grid == 1 or "range" not in channels:
            images = self._faces(parts, ("color", *({"range"} & {*channels})), grid)
        else:  # range is that of texels' middles
            images = self._faces(parts, ("color",), grid) | self._faces(parts, ("range",), 1)
        return EnvMap((x, y, z), images["color"], images.get("range"))

    def _faces(self, parts: _FarParts, channels: tuple[str, ...], grid: int) -> dict[str, NDArray[Any]]:
        """Images (6, S, S, …) of all faces, with some samples along each axis of a texel."""
        origin = self.origin.tolist()
        before = parts.baked(grid)
        faces = [
            _core.splat_orthoviews(
                splats,
                camera._core,
                Shot(cameras=(camera,), channels=channels).settings,
                origin=(origin[0], origin[1], origin[2]),
                grid=grid,
                before=None if before is None else {name: image[face] for name, image in before.items()},
            )
            for face, (camera, splats) in enumerate(zip(parts.cameras, parts.splats, strict=True))
        ]
        return {name: np.stack([face[name] for face in faces]) for name in channels}

    def _far_splats(self, camera: Camera, cut: OrthoCut, radius: float) -> list[_core.OrthoSplats]:
        views, center = self._viewer.views, np.array(camera.position)
        keys = cut.keys()
        views.load(keys)
        found: list[_core.OrthoSplats] = []
        for key in keys:
            level, place, _ = key
            own = views.kept(key)
            if _from_axis(self._layout.grid.box(level, place), center) < radius:
                own = tuple(splats.beyond(camera.position, radius) for splats in own)
            found += own
        views.trim(set(keys))
        return found

    def _know(self, leaves: list[Place]) -> None:
        """Read the records that tell of leaves' guests, where no cut has done so."""
        cutter, side = self._viewer.cutter, self._layout.shard_side(0)
        for x, y, z in dict.fromkeys((x // side, y // side, z // side) for x, y, z in leaves):
            if not cutter.knows(0, (x, y, z)):
                cutter.learn(0, (x, y, z))

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
        return [place for place in places if _from_axis(grid.box(0, place), center) <= radius]


def _from_axis(box: NDArray[np.float64], center: NDArray[np.float64]) -> float:
    """Least distance of a box from the vertical axis through a point, metres."""
    nearest = np.clip(center, box[0], box[1]) - center
    return math.hypot(nearest[0], nearest[2])
