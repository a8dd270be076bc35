"""Regions of a walk: their centres, their reduced scenes, made on demand or in advance, and changes between them."""

from __future__ import annotations

import math
from functools import partial
from typing import SupportsFloat

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check
from nearfar._base.recent import Recent
from nearfar._camera.camera import Camera
from nearfar._impostor.budget import BUDGET_ERROR_PX
from nearfar._impostor.settings import ImpostorSettings
from nearfar._reduce.baking import MapSettings
from nearfar._reduce.choose_radii import Radii
from nearfar._reduce.drawing import MORPHS, MorphKind
from nearfar._reduce.impostors import Impostors, reduce_to_impostors
from nearfar._reduce.reduce import reduce
from nearfar._reduce.reduced_scene import ReducedScene
from nearfar._reduce.walk.folds import error_in_pixels, predict_jump
from nearfar._reduce.walk.recentering import Recentering
from nearfar._reduce.walk.walker import Walk
from nearfar._scene.scene import Scene, core_of

Reduced = ReducedScene | Impostors
"""Reduction of a region."""

MAX_CACHED = 1 << 16
"""Maximum number of cached reduced scenes."""


class Regions:
    """Regions in which a user walks, each with its own centre and reduced scene; made by `regions`.

    A reduced scene is made on first use, or in advance in the background (`prefetch`). The most recently used ones are
    cached. All share the scene, with its meshes, search trees and textures; every second region of impostors uses quads
    of the region before it.
    """

    def __init__(
        self,
        scene: Scene,
        centers: ArrayLike,
        *,
        radii: Radii,
        hysteresis: SupportsFloat = 1.0,
        morph: MorphKind = "blend",
        baking: MapSettings | ImpostorSettings | None = None,
        keep: int = 3,
    ) -> None:
        core_of(scene)
        positions = check.array("centers", centers, dtype=np.float64, finite=True).copy()
        count = len(positions)
        if not count or np.abs(positions).max() > check.FARTHEST:
            raise ValueError(f"centers: expected at least one, and numbers up to {check.FARTHEST:g}, got {count}")
        positions.setflags(write=False)
        self._scene, self._centers, self._radii = scene, positions, check.instance("radii", radii, Radii)
        self._hysteresis = check_hysteresis(hysteresis, radii.reach)
        self._morph = check.choice("morph", morph, MORPHS)
        self._baking = MapSettings() if baking is None else baking
        if not isinstance(self._baking, MapSettings | ImpostorSettings):
            raise TypeError(f"baking: expected MapSettings or ImpostorSettings, got {check.type_and_value(baking)}")
        self._keep = check_keep(keep)
        self._cache: Recent[int, Reduced] = Recent()
        self._prefetched: tuple[int, Recentering[Reduced]] | None = None
        self._bytes = np.zeros(len(positions), np.int64)

    @property
    def centers(self) -> NDArray[np.float64]:
        """(K, 3) centres O of the regions, world metres; read-only."""
        return self._centers

    @property
    def radii(self) -> Radii:
        """Radii of all regions, with the reach R."""
        return self._radii

    @property
    def reach(self) -> float:
        """Greatest distance R in metres of a user from the centre of the region, horizontally."""
        return self._radii.reach

    @property
    def hysteresis(self) -> float:
        """Least distance b in metres between two changes."""
        return self._hysteresis

    @property
    def spacing(self) -> float:
        """Distance √3 (R − b) in metres of neighbouring centres."""
        return spacing_for(self.reach, self._hysteresis)

    @property
    def bytes(self) -> NDArray[np.int64]:
        """(K,) bytes in memory of each region's map or quads, and of near geometry; 0 for regions not made yet."""
        return self._bytes.copy()

    @property
    def memory(self) -> int:
        """Bytes of the cached regions."""
        return int(self._bytes[list(self._cache.values)].sum())

    def __len__(self) -> int:
        return len(self._centers)

    def index(self, position: ArrayLike, current: int | None = None) -> int:
        """Find the region of a user whose eye is at a world position (3,) in metres; its height does not matter.

        Returns the present region `current` as long as the user is within `reach` of its centre, else the region with
        the nearest centre. On the path or in the area the nearest centre is within R − b, so that the next change is at
        least b metres away.
        """
        eye = check.vector("position", position)
        region = None if current is None else self._check_number("current", current)
        distances = self._distances(eye)
        return region if region is not None and distances[region] <= self.reach else int(np.argmin(distances))

    def ready(self, i: int) -> bool:
        """Whether `reduced` returns region i without waiting."""
        number, prefetched = self._check_number("i", i), self._prefetched
        return number in self._cache or (prefetched is not None and prefetched[0] == number and prefetched[1].ready)

    def reduced(self, i: int) -> Reduced:
        """Return the reduced scene or impostors of region i, 0 to K − 1.

        If it is not cached, it is made now; if it is being made, this waits. ValueError and TypeError for invalid
        region numbers; DeviceError and MemoryError as in `reduce`.
        """
        number = self._check_number("i", i)
        if (reduced := self._cache.get(number)) is not None:
            return reduced
        if self._prefetched is not None and self._prefetched[0] == number:
            try:
                reduced = self._prefetched[1].result()
            except Exception:
                self._prefetched = None
                raise
            self._prefetched = None
        else:
            reduced = self._make(number)
        self._store(number, reduced)
        return reduced

    def prefetch(self, position: ArrayLike, velocity: ArrayLike, current: int | None = None) -> int | None:
        """Start making the region that a user walks towards, in the background.

        `position` and `current` are as in `index`; `velocity` (3,) is the user's in metres per second, and only its
        horizontal direction is used. Returns the region at the point where the user would leave the present one; None
        for a standing user, or if no other region follows. Only one region is made at a time: while another one is
        being made, a later call starts this one.
        """
        eye, direction = check.vector("position", position), check.vector("velocity", velocity)
        region = self.index(eye, current)
        next_region = self._next_region(eye, direction, region)
        self._collect(next_region)
        if next_region is not None and next_region not in self._cache and self._prefetched is None:
            self._prefetched = next_region, Recentering(self._centers[next_region], partial(self._make, next_region))
        return next_region

    def jump(self, i: int, j: int, camera: Camera, distance: float | None = None) -> float:
        """Predict the picture's jump at a hard cut from region i to region j.

        Returns f·|ΔO⊥|/ρ in pixels: f the focal length in pixels, ΔO⊥ the component of the step between the centres
        perpendicular to the line of sight. With R = 8 m, b = 0 and f = 480 px at most 133 px at 50 m. For impostors
        returns twice their greatest error, 8 px with a budget, because both regions are within it of the truth.

        Parameters
        ----------
        i, j
            Numbers of regions.
        camera
            The view; it must not have parallel rays.
        distance
            Distance ρ in metres from the centre of region i to the surface straight ahead, above 0; by default r2, at
            which jumps are largest.
        """
        start, end = (self._centers[self._check_number(name, value)] for name, value in (("i", i), ("j", j)))
        check.instance("camera", camera, Camera)
        if isinstance(self._baking, ImpostorSettings):
            baking = self._baking
            has_budget = baking.triangles is not None or baking.bytes is not None
            greatest = max(baking.error_px, BUDGET_ERROR_PX if has_budget else 0.0)
            return error_in_pixels(2.0 * greatest, camera)
        range_m = self._radii.r2 if distance is None else check.positive("distance", distance)
        return predict_jump(end - start, camera, range_m)

    def walk(self, *, fade: float = 0.5, transition: str = "fade", ahead: bool = True) -> Walk:
        """Begin a walk, whose pictures come from the region that the user is in.

        Parameters
        ----------
        fade
            Seconds of a cross-fade.
        transition
            "fade": both regions' pictures are blended for a while after a change. "cut": the picture jumps, by `jump`.
        ahead
            Whether the region that the user walks towards is made in the background.
        """
        return Walk(self, fade=fade, transition=transition, ahead=ahead)

    def _check_number(self, name: str, value: int) -> int:
        return check.integer(name, value, 0, len(self._centers) - 1)

    def _distances(self, eye: tuple[float, float, float]) -> NDArray[np.float64]:
        """Horizontal distances (K,) of the centres."""
        with np.errstate(over="ignore"):
            return np.asarray(np.hypot(self._centers[:, 0] - eye[0], self._centers[:, 2] - eye[2]))

    def _next_region(
        self, eye: tuple[float, float, float], velocity: tuple[float, float, float], region: int
    ) -> int | None:
        """Region at the point where a straight line leaves the present region's reach."""
        speed = math.hypot(velocity[0], velocity[2])
        if not 0.0 < speed < math.inf:
            return None
        dx, dz = velocity[0] / speed, velocity[2] / speed
        x, z = eye[0] - self._centers[region, 0], eye[2] - self._centers[region, 2]
        advance, offset = x * dx + z * dz, x * dz - z * dx
        # A user beyond the reach leaves the region at once.
        distance = math.sqrt(self.reach**2 - offset**2) - advance if abs(offset) < self.reach else 0.0
        distance = max(distance, 0.0)
        next_region = int(np.argmin(self._distances((eye[0] + distance * dx, eye[1], eye[2] + distance * dz))))
        return None if next_region == region else next_region

    def _make(self, number: int) -> Reduced:
        center, r1, r2 = self._centers[number], self._radii.r1, self._radii.r2
        if isinstance(self._baking, ImpostorSettings):
            place = check.vector("center", center)
            return reduce_to_impostors(self._scene, place, r2, self._baking, earlier=self._lender(number))
        return reduce(self._scene, center=center, r1=r1, r2=r2, morph=self._morph, settings=self._baking)

    def _lender(self, number: int) -> Impostors | None:
        """Impostors whose quads a region can use: those of the region before it, for every second one without a budget.

        The result does not depend on the route that users take.
        """
        baking, lender = self._baking, number - 1
        assert isinstance(baking, ImpostorSettings)
        if number % 2 == 0 or baking.triangles is not None or baking.bytes is not None:
            return None
        if math.dist(self._centers[number], self._centers[lender]) > 2.0 * self.reach:
            return None
        reduced = self._cache.get(lender)
        if reduced is None:
            if self._prefetched is not None and self._prefetched[0] == lender:
                reduced = self._prefetched[1].result()
            else:
                reduced = self._make(lender)
            self._store(lender, reduced)
        return reduced if isinstance(reduced, Impostors) else None

    def _collect(self, next_region: int | None) -> None:
        """Store a region made in the background.

        A region that failed is stored while it is the next one, so that `reduced` raises its error, and pictures do not
        retry it.
        """
        if self._prefetched is not None and self._prefetched[1].ready:
            number, recentering = self._prefetched
            try:
                self._store(number, recentering.result())
            except Exception:
                if number == next_region:
                    return
            self._prefetched = None

    def _store(self, number: int, reduced: Reduced) -> None:
        self._bytes[number] = reduced.nbytes
        self._cache.put(number, reduced)
        self._cache.trim((), self._keep)

    def __repr__(self) -> str:
        return (
            f"Regions({len(self)} within {self.reach:g} m of their centres, r1={self._radii.r1:.3g}, "
            f"r2={self._radii.r2:.3g}: {self._cache.size} kept, {self.memory:,} bytes)"
        )


def check_hysteresis(hysteresis: SupportsFloat, reach: float) -> float:
    """Return the hysteresis b in metres, 0 ≤ b < reach; ValueError or TypeError otherwise."""
    band = check.at_least_zero("hysteresis", hysteresis)
    if band >= reach:
        raise ValueError(f"hysteresis: expected less than the reach of {reach:g} m, got {band:g}")
    return band


def check_keep(keep: int) -> int:
    """Check the number of cached reduced scenes: at least 3, for the present, the previous and the next region."""
    return check.integer("keep", keep, 3, MAX_CACHED)


def spacing_for(reach: float, hysteresis: float) -> float:
    """Distance in metres of neighbouring centres, for which every point is within reach − hysteresis of one."""
    return math.sqrt(3.0) * (reach - hysteresis)
