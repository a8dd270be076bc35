"""Prefetching: finds the parts that a viewer will need soon from cuts at positions ahead."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from nearfar._camera.camera import Camera, Fov
from nearfar._camera.rotation import rotation
from nearfar.orthoview._cut import Cutter, OrthoCut, Part, Settings, leaf_parts, records_of
from nearfar.orthoview._grid import Grid, Place, places_of

RENEWED_AFTER = 0.1
"""Share of the look-ahead distance after which the queue is renewed."""

_AXES = np.array([[-1, 0, 0], [1, 0, 0], [0, -1, 0], [0, 1, 0], [0, 0, -1], [0, 0, 1]], np.float64)
"""Directions to the positions ahead of a resting viewer."""

SIDEWAYS = math.tan(math.radians(15.0))
"""Tangent of the angle between a viewer's course and the directions to the outer positions ahead."""


@dataclass(frozen=True, eq=False)
class PrefetchQueue:
    """Parts that a viewer needs now and soon, in the best order for reading."""

    needed: list[Part]
    """Parts of the cut at the position, nearest first: (level, place, direction) of views, (0, place, −1) of leaves'
    geometry."""
    soon: list[Part]
    """Further parts of the cuts at the positions ahead, position by position, by distance and level."""
    positions: NDArray[np.float64]
    """World positions ahead (N, 3), metres."""
    ahead: float
    """Distance of the positions ahead, metres: the side of the smallest cell of the cut."""
    unknown: list[Part] = field(default_factory=list, repr=False)
    """Records of subtrees that have not been read; their cells are not queued. Empty in queues from
    `OrthoTree.prefetch_queue`."""

    @property
    def renewed_after(self) -> float:
        """Metres that the viewer may move before the queue should be renewed: a tenth of the look-ahead."""
        return RENEWED_AFTER * self.ahead

    def __len__(self) -> int:
        """Number of parts needed now or soon."""
        return len(self.needed) + len(self.soon)


class Frustums:
    """Frustum test for several cameras: finds cells in any of their pictures, each widened by a margin on all sides.

    The margin is in radians; None accepts cells in all directions.
    """

    def __init__(self, cameras: Iterable[Camera], margin: float | None) -> None:
        self._planes: list[NDArray[np.float64]] = []
        """Inward normals (4, 3) of each frustum's sides, without sides at more than a right angle from the axis; empty
        if all cells are accepted."""
        for camera in cameras:
            if margin is None or not isinstance(camera.fov, Fov):
                self._planes = []
                return
            self._planes.append(_sides(camera, camera.fov, margin))

    def overlap(
        self, eye: NDArray[np.float64], corners: NDArray[np.float64], sides: NDArray[np.float64]
    ) -> NDArray[np.bool_]:
        """Whether cells, given by least corners (N, 3) and sides (N,), reach into any of the frustums (N,)."""
        if not self._planes:
            return np.ones(len(corners), bool)
        half_side = sides[:, None] / 2.0
        to_center = corners + half_side - eye
        # The corner farthest along the plane's normal decides.
        reaches = (to_center @ planes.T + half_side * np.abs(planes).sum(axis=1) for planes in self._planes)
        return np.asarray(np.any([(reach >= 0.0).all(axis=1) for reach in reaches], axis=0))


def _sides(camera: Camera, fov: Fov, margin: float) -> NDArray[np.float64]:
    """Inward normals of a frustum's sides, widened by a margin in radians."""
    right, up, back = rotation(camera.orientation).T
    normals = []
    for axis, ends in ((right, (fov.left, fov.right)), (up, (fov.down, fov.up))):
        angles = [math.atan(-sign * tangent) + margin for sign, tangent in zip((1.0, -1.0), ends, strict=True)]
        for sign, angle in zip((1.0, -1.0), angles, strict=True):
            if angle < math.pi / 2.0 and sum(angles) < math.pi:  # half a turn or more is no half-space
                normals.append(sign * math.cos(angle) * axis - math.sin(angle) * back)
    return np.array(normals).reshape(-1, 3)


def smallest_side(cut: OrthoCut, grid: Grid) -> float:
    """Side of the smallest cell of a cut, metres; for an empty cut, of the root's cell."""
    if len(cut.leaves):
        return grid.cell
    return grid.side(int(cut.level.min()) if len(cut) else grid.levels - 1)


def offsets(ahead: float, course: NDArray[np.float64] | None) -> NDArray[np.float64]:
    """Offsets (N, 3) from the viewer to positions ahead, metres: along and beside its course, or along all axes."""
    if course is None:
        return ahead * _AXES
    sideways = np.cross(course, _AXES[np.abs(course).argmin() * 2])
    sideways /= np.linalg.norm(sideways)
    upwards = np.cross(course, sideways)
    outer = [course + SIDEWAYS * side for side in (sideways, -sideways, upwards, -upwards)]
    return ahead * np.array([0.5 * course, course, *(direction / np.linalg.norm(direction) for direction in outer)])


def queue(
    cutter: Cutter, settings: Settings, present_camera: Camera, ahead: Sequence[Camera], frustums: Frustums
) -> PrefetchQueue:
    """Collect the parts of the cuts at a position and at positions ahead, for cells in any frustum."""
    present_cut = cutter.cut(present_camera, settings, around=True)
    needed = seen_parts(cutter, present_cut, present_camera, frustums)
    unknown = dict.fromkeys(records_of(present_cut))
    later: dict[Part, tuple[int, float, int]] = {}
    eye = np.array(present_camera.position)
    for stage, camera in enumerate(ahead):
        cut = cutter.cut(camera, settings, around=True)
        unknown |= dict.fromkeys(records_of(cut))
        for part in seen_parts(cutter, cut, camera, frustums):
            if part not in needed and part not in later:
                level, place, _ = part
                later[part] = stage, _distance(cutter.grid, level, place, eye), level
    soon = sorted(later, key=later.__getitem__)
    positions = np.array([camera.position for camera in ahead]).reshape(-1, 3)
    return PrefetchQueue(list(needed), soon, positions, smallest_side(present_cut, cutter.grid), list(unknown))


def seen_parts(cutter: Cutter, cut: OrthoCut, camera: Camera, frustums: Frustums) -> dict[Part, None]:
    """Parts of a cut for the cells in any frustum: geometry, then views, the nearest cells first."""
    grid, eye = cutter.grid, np.array(camera.position)
    origin = np.array(grid.origin)
    leaves = origin + cut.leaves * grid.cell
    is_near = frustums.overlap(eye, leaves, np.full(len(leaves), grid.cell)) | cut.leaf_in_picture
    parts: dict[Part, None] = dict.fromkeys(leaf_parts(places_of(cut.leaves[is_near]), cutter))
    sides = grid.cell * np.exp2(cut.level.astype(np.float64))
    is_seen = frustums.overlap(eye, origin + cut.place * sides[:, None], sides) | cut.in_picture
    rows = zip(cut.level[is_seen].tolist(), cut.place[is_seen].tolist(), cut.directions[is_seen].tolist(), strict=True)
    for level, (x, y, z), directions in rows:
        parts |= {(level, (x, y, z), direction): None for direction in directions if direction >= 0}
    return parts


def _distance(grid: Grid, level: int, place: Place, eye: NDArray[np.float64]) -> float:
    """Distance of the nearest point of a cell, metres."""
    low = np.array(grid.corner(level, place))
    return float(np.linalg.norm(eye - np.clip(eye, low, low + grid.side(level))))
