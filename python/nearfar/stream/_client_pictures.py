"""Pictures of a partly loaded scene as a client shows it, and their measures: completeness and continuity."""

from __future__ import annotations

import math
from collections import OrderedDict
from dataclasses import dataclass, field, replace
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base import progress
from nearfar._camera.camera import Camera, CubeFace
from nearfar._partition.partition import partition
from nearfar._reduce.reduced_scene import ReducedScene
from nearfar._render import truth
from nearfar._render.frame import Frame, blend
from nearfar._scene.scene import Scene
from nearfar.metrics import _inputs as inputs
from nearfar.metrics._pixel_errors import object_completion
from nearfar.metrics._similarity import visual_continuity
from nearfar.stream._assign import Rings, assign
from nearfar.stream._bundle import Bundle
from nearfar.stream._by_footprint import Portions
from nearfar.stream._growth import PictureState
from nearfar.stream._manifest import NEAR_SHARE
from nearfar.stream._maps import RingMaps, bake_maps
from nearfar.stream._strategies import HeadPath
from nearfar.stream._timeline import Timeline

TEXELS = 3
"""Map texels along a pixel of a cube face; odd, so that a pixel's centre is also a texel's centre."""
MAX_CACHED = 4
"""Greatest number of cached pictures, and of cached client states; consecutive frames often share them."""
CHANNELS = ("color", "object_id")

Eye = tuple[float, float, float]


@dataclass(frozen=True, eq=False)
class Picture:
    """Luma, encoded as sRGB, and object numbers, (H, W) each; object −1 for none."""

    luma: NDArray[np.float64]
    objects: NDArray[np.int32]


@dataclass(eq=False)
class SceneParts:
    """A scene in rings, and their maps; shared by all strategies and user positions."""

    rings: Rings
    maps: RingMaps
    cameras: tuple[Camera, ...]
    """Views, which are moved to the user's eye."""
    max_cached: int = MAX_CACHED
    """Greatest number of cached states; the least recently used one is dropped."""
    reduced: OrderedDict[tuple[bool, int], ReducedScene] = field(default_factory=OrderedDict)
    """Cached states by (whether objects are ordered by footprint, number of the ring or portion)."""
    portions: Portions | None = None

    @classmethod
    def bake(cls, scene: Scene, bundle: Bundle, camera: Camera | None, size: int) -> SceneParts:
        """Bake the maps of a bundle's region anew; without a camera the views are six cube faces of `size`² pixels."""
        rings = assign(scene, center=bundle.center, radii=bundle.radii)
        if rings.rest <= rings.count:
            raise ValueError("scene: expected faces that all belong to objects, which are counted; name the objects")
        if camera is None:
            cameras = tuple(Camera(bundle.center, fov=CubeFace(face), size=(size, size)) for face in range(6))
            face_size = TEXELS * size
        else:
            cameras, face_size = (camera,), int(bundle._manifest["map"]["face_size"])
        return cls(rings, bake_maps(rings, face_size=face_size, samples=1, object_id=True), cameras)

    def state(self, number: int, *, by_footprint: bool) -> ReducedScene:
        """Return the scene of a client that has all rings, or portions by footprint, up to a number."""
        key = (by_footprint, number)
        if key not in self.reduced:
            self.reduced[key] = self._portion(number) if by_footprint else self._ring(number)
            if len(self.reduced) > self.max_cached:
                self.reduced.popitem(last=False)
        self.reduced.move_to_end(key)
        return self.reduced[key]

    def _ring(self, number: int) -> ReducedScene:
        names = [name for ring in range(number + 1) for name in self.rings.objects(ring)]
        return self._whole_objects(names, number, self.rings.radii[max(number, 1) - 1])

    def _portion(self, number: int) -> ReducedScene:
        """Return all objects up to a portion; after the last portion also the map."""
        scene, rings = self.rings.scene, self.rings
        if self.portions is None:
            self.portions = Portions.from_rings(rings, scene=scene)
        numbers = np.flatnonzero(self.portions.portion <= min(number, self.portions.count))
        names = [scene.object_names[index] for index in numbers]
        return self._whole_objects(names, rings.count if number > self.portions.count else None, rings.radii[-1])

    def _whole_objects(self, names: list[str], ring: int | None, radius: float) -> ReducedScene:
        """Return whole objects in front of a ring's map, or without a map."""
        scene, center = self.rings.scene.subset(objects=names), self.rings.center
        zones = partition(scene, center=center, r1=NEAR_SHARE * radius, r2=radius, unit="object")
        env = None if ring is None else self.maps.map(ring)
        settings: dict[str, Any] = {"morph": "cylinder", "boundary": "r2", "is_whole": False}
        return ReducedScene(zones.scene, zones, env, counts={**zones.summary(), "rays": 0}, **settings)


@dataclass(eq=False)
class Pictures:
    """Rendered pictures of a strategy, and their number."""

    parts: SceneParts
    by_footprint: bool
    renders: int = 0

    def __post_init__(self) -> None:
        self.picture = lru_cache(MAX_CACHED)(self._render)

    def _render(self, state: PictureState | None, eye: Eye) -> Picture:
        """Render the picture of a client in a state, or of the full scene for None."""
        views = [replace(camera, position=eye) for camera in self.parts.cameras]
        if state is not None and state.ring < 0:
            blank = np.concatenate([np.zeros(view.size[::-1]) for view in views])
            return Picture(blank, np.full(blank.shape, -1, np.int32))
        frames = [self._frame(state, view) for view in views]
        self.renders += 1 if state is None or state.share == 0.0 else 2
        objects = np.concatenate([frame.require("object_id") for frame in frames])
        return Picture(np.concatenate([inputs.luma(frame) for frame in frames]), objects)

    def _frame(self, state: PictureState | None, view: Camera) -> Frame:
        if state is None:
            return truth.render(self.parts.rings.scene, view, channels=CHANNELS)
        frame = self._ring_frame(state, state.ring, view)
        if state.share == 0.0:
            return frame
        blended = blend(frame, self._ring_frame(state, state.ring + 1, view), state.share)
        # Object numbers are taken from the picture with the greater share of the colour.
        return blended if state.share >= 0.5 else replace(blended, object_id=frame.object_id)

    def _ring_frame(self, state: PictureState, ring: int, view: Camera) -> Frame:
        reduced = self.parts.state(ring, by_footprint=self.by_footprint)
        frame = reduced.with_growth(state.radius, state.strength).render(view, channels=CHANNELS)
        if reduced.env is not None:
            return frame
        # The page shows black until the map has arrived.
        is_near = frame.require("object_id") >= 0
        return replace(frame, color=frame.require("color") * is_near[..., None])


def measure(line: Timeline, parts: SceneParts, path: HeadPath, *, every: float, rate: float, end: float) -> Timeline:
    """Add `pictures` to a timeline: at each change of the ring or of a cross-fade, and every `every` seconds."""
    pictures = Pictures(parts, by_footprint=line.strategy in ("vis0", "vis1"))
    moments = _moments(line, path, every, min(end, max(line.grown, float(path.times[-1]))))
    rows = []
    with progress.bar("client pictures") as report:
        for number, time in enumerate(moments, 1):
            eye, state = path.position(time), _state_at(line, time)
            now = pictures.picture(state, eye)
            ovc, ofc = object_completion(pictures.picture(None, eye).objects, now.objects)
            before = pictures.picture(_state_at(line, time - 1.0 / rate), path.position(time - 1.0 / rate))
            rows.append((time, ovc, ofc, next(visual_continuity([before.luma, now.luma], data_range=1.0))))
            report(number, len(moments))
    columns = np.array(rows, np.float64).reshape(-1, 4).T
    names = ("time", "ovc", "ofc", "continuity")
    return replace(line, pictures=dict(zip(names, columns, strict=True)), renders=pictures.renders)


def _moments(line: Timeline, path: HeadPath, every: float, end: float) -> list[float]:
    """Choose the times of the measured frames."""
    frames = line.frames
    is_jump = np.ones(len(frames["time"]), bool)
    if line.strategy == "clovr":
        is_jump[1:-1] = ((np.diff(frames["ring"]) != 0) | (np.diff(frames["share"] > 0.0)))[:-1]
    steps = np.arange(1, math.floor(end / every) + 1) * every
    if len(path.times) == 1:
        # A still user's picture does not change after the last growth.
        steps = steps[steps < line.grown]
    return sorted({*frames["time"][is_jump].tolist(), *steps.tolist()})


def _state_at(line: Timeline, time: float) -> PictureState:
    frames = line.frames
    # Times of frames are rounded; the tolerance is far below half a frame of a fast display.
    index = max(int(np.searchsorted(frames["time"], time + 1e-6, side="right")) - 1, 0)
    values: dict[str, Any] = {name: float(frames[name][index]) for name in ("radius", "strength", "share")}
    return PictureState(ring=int(frames["ring"][index]), **values)
