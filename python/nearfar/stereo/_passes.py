"""Draws a rig's three pictures and assembles the eyes: near geometry for each eye, one shared picture beyond."""

from __future__ import annotations

import math
import time
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check, progress
from nearfar._camera.camera import Camera, quaternion
from nearfar._camera.clip import Clip
from nearfar._camera.shot import Shot
from nearfar._render.channels import VECTORS
from nearfar._render.frame import Frame
from nearfar._render.renderable import Images
from nearfar._render.renderer import Renderer, View
from nearfar._scene.scene import Scene
from nearfar.hmd._eye import rotation
from nearfar.hmd._hmd import EYES
from nearfar.hmd._stereo import StereoFrame
from nearfar.stereo._geometry import RigGeometry

CULLS = ("frustum", "discard", "occlusion")
"""Ways of leaving out what no eye looks up in the shared picture, by name."""
ASSEMBLIES = ("bilinear", "resolved")
"""Ways of looking up the shared picture, by name."""


@dataclass
class Passes:
    """The passes of one frame of a rig; `stats` grows with them."""

    rig: RigGeometry
    position: tuple[float, float, float]
    orientation: tuple[float, float, float, float]
    view: View
    device: _core.GpuDevice | None
    cull: str
    assembly: str
    near: float
    far: float
    stats: dict[str, Any] = field(default_factory=dict)

    def draw(self) -> tuple[Images, Images, Images | None]:
        """Return the images of the left eye, the right eye, and the shared ones if anything lies beyond the plane."""
        self.stats |= {"seconds": {}, "pixels": {}}
        left, right, center = self.rig.cameras(self.position, self.orientation)
        has_near, has_far = self._has_near_and_far()
        with progress.bar("rendering") as self._report:
            if not has_far:
                whole = self._between(self.near, self.far)
                eyes = [self._pass(side, camera, whole) for side, camera in zip(EYES, (left, right), strict=True)]
                return eyes[0], eyes[1], None
            near = self._between(self.near, min(self.rig.planes[1], self.far))
            eyes = [
                self._pass(side, camera, near, near=True) if has_near else self._nothing(camera)
                for side, camera in zip(EYES, (left, right), strict=True)
            ]
            shared = self._shared(center, eyes)
            for side, camera, images in zip(EYES, (left, right), eyes, strict=True):
                with self._timed("assembly"):
                    self._assemble(side, camera, images, center, shared)
        return eyes[0], eyes[1], shared

    def _shared(self, camera: Camera, eyes: list[Images]) -> Images:
        """Draw the pixels of the third camera that an eye looks up."""
        mask = None
        if self.cull != "frustum":
            with self._timed("culling"):
                samples = self.view.shot.samples if self.assembly == "resolved" else 1
                mask = self.rig._core.needed(eyes[0]["coverage"], eyes[1]["coverage"], samples)
        images = self._pass("center", camera, self._beyond, mask=mask, faces=self.assembly == "resolved")
        drawn = camera.width * camera.height if mask is None else int(mask.sum())
        self.stats["pixels"] |= {"center": drawn, "discarded": camera.width * camera.height - drawn}
        return images

    def _pass(
        self,
        name: str,
        camera: Camera,
        clip: Clip,
        *,
        near: bool = False,
        mask: NDArray[np.bool_] | None = None,
        faces: bool = False,
    ) -> Images:
        extra = ["coverage"] if near else []
        if faces or (near and self._others):
            extra.append("face_id")
        channels = dict.fromkeys([*self.view.shot.channels, *extra])
        shot = Shot(
            cameras=(camera,),
            channels=tuple(channels),
            samples=self.view.shot.samples,
            user=self._head,
            clip=clip,
            mask=mask,
            bare=near,
            occlusion=self.cull == "occlusion",
        )
        with self._timed(name):
            if self.device is None:
                (images,) = self.view.drawn.trace(shot, self._report)
            else:
                (job,) = self.view.drawn.begin(self.device, shot, self._report)
                images = job.finish(self._report)
        if near:
            self.stats["pixels"][name] = int((images["coverage"] > 0.0).sum())
        return images

    def _assemble(self, side: str, camera: Camera, images: Images, center: Camera, shared: Images) -> None:
        """Put the shared picture behind an eye's own, in place."""
        core, coverage = self.rig._core, images["coverage"]
        if "color" in images:
            if self.assembly == "resolved":
                settings = Shot(
                    cameras=(center,), channels=("color",), samples=self.view.shot.samples, clip=self._beyond
                ).settings
                scene = self.view.drawn
                assert isinstance(scene, Scene)
                picture = (shared["color"], shared["face_id"])
                core.resolve(side, coverage, scene._core, center._core, settings, picture, images["color"])
            else:
                core.assemble(side, coverage, shared["color"], images["color"])
        if set(self.view.shot.channels) == {"color"}:
            return
        nearest = core.nearest(side, coverage)
        if self._others:
            # They are sampled at the pixel's centre, where the eye's own surface counts if there is one.
            far = images["face_id"] < 0
            for name in self._others:
                values = shared[name].reshape(-1, *shared[name].shape[2:])[nearest[far]]
                images[name][far] = self._range(values, nearest[far], camera, center) if name == "range" else values
        if "coverage" in shared:
            # The share of its own surfaces, and of the shared picture's behind the rest.
            images["coverage"] = coverage + (1.0 - coverage) * shared["coverage"].reshape(-1)[nearest]

    @property
    def _others(self) -> list[str]:
        """Wanted channels of one sample."""
        return [name for name in self.view.shot.channels if name not in ("color", "coverage")]

    def _range(
        self, values: NDArray[np.float32], pixels: NDArray[np.uint32], camera: Camera, center: Camera
    ) -> NDArray[np.float32]:
        """Distances from an eye to the points that pixels of the third camera show at these distances from it."""
        starts, ways = (rays.reshape(-1, 3)[pixels] for rays in center.rays())
        hit = np.isfinite(values)
        points = starts + ways * np.where(hit, values, 0.0)[:, None].astype(np.float64)
        away = np.linalg.norm(points - np.array(camera.position), axis=1)
        return np.where(hit, away, np.inf).astype(np.float32)

    def _nothing(self, camera: Camera) -> Images:
        """Images of an eye that has no surface before the plane."""
        width, height = camera.size
        misses = {"face_id": np.int64(-1), "object_id": np.int32(-1), "range": np.float32(math.inf)}
        dark = {"color": np.float32(0.0), "coverage": np.float32(0.0)}
        empty: Images = {}
        for name in {*self.view.shot.channels, "coverage", "face_id"}:
            value = (misses | dark).get(name, np.float32(math.nan))
            empty[name] = np.full((height, width, 3) if name in VECTORS else (height, width), value)
        return empty

    def _has_near_and_far(self) -> tuple[bool, bool]:
        """Whether anything is drawn before the plane, and beyond it; both where the source does not say."""
        scene = self.view.drawn
        if self.far <= self._begin:
            return True, False
        if not isinstance(scene, Scene):
            return True, True
        depths = (self.near, self.far)
        near, far = self.rig._core.reaches(scene._core, self.position, self.orientation, depths)
        return near, far

    @property
    def _head(self) -> tuple[float, float, float]:
        """World position of the middle between the eyes."""
        x, y, z = np.array(self.position) + rotation(self.orientation) @ np.array(self.rig._core.middle)
        return float(x), float(y), float(z)

    @property
    def _begin(self) -> float:
        """Depth from which on the third camera draws, metres."""
        return max(self.near, self.rig.planes[0] - self.rig.overlap)

    @property
    def _beyond(self) -> Clip:
        return self._between(self._begin, self.far)

    def _between(self, begin: float, end: float) -> Clip:
        return self.rig.clip(self.position, self.orientation, near=begin, far=end)

    @contextmanager
    def _timed(self, name: str) -> Iterator[None]:
        start = time.perf_counter()
        yield
        seconds = self.stats["seconds"]
        seconds[name] = seconds.get(name, 0.0) + time.perf_counter() - start


def check_depths(rig: RigGeometry, near: float, far: float) -> tuple[float, float]:
    """Return the depths between which surfaces are drawn; ValueError unless 0 ≤ near < far and near is before m₁."""
    begin, end = check.at_least_zero("near", near), check.number("far", far, finite=False)
    m = rig.planes[0]
    if not begin < m:
        raise ValueError(f"near: expected less than the mono plane's {m:g} m, got {begin:g}")
    if not end > begin:
        raise ValueError(f"far: expected more than near, {begin:g} m, got {end:g}")
    return begin, end


def render(
    rig: RigGeometry,
    renderer: Renderer,
    scene: tuple[ArrayLike, ArrayLike, Mapping[str, ArrayLike] | None],
    *,
    backend: str | None,
    cull: str,
    assembly: str,
    depths: tuple[float, float],
) -> StereoFrame:
    """Check the arguments of `HybridRig.render`, and draw; `scene` has the head's pose and those of objects."""
    check.choice("cull", cull, CULLS)
    check.choice("assembly", assembly, ASSEMBLIES)
    m, end = rig.planes
    if end > m:
        raise ValueError(f"mono_plane: expected one plane for drawing, got the zone from {m:g} to {end:g} m")
    near, far = check_depths(rig, *depths)
    device = renderer.device(backend)
    if assembly == "resolved":
        if not isinstance(renderer.source, Scene):
            kind = type(renderer.source).__name__
            raise ValueError(
                f"assembly: expected 'bilinear' for {kind}, whose triangles are not looked up, got 'resolved'"
            )
        if device is not None:
            raise ValueError(
                "assembly: expected 'bilinear' on a graphics adapter, got 'resolved': backend='cpu' takes both"
            )
    place, way = check.vector("position", scene[0]), quaternion(scene[1])
    left, right, center = rig.cameras(place, way)
    # Levels of detail are chosen for both eyes at once.
    view = renderer.view(renderer.shot([left, right]), scene[2])
    passes = Passes(rig, place, way, view, device, cull, assembly, near, far)
    *images, shared = passes.draw()
    origin = check.vector("origin", view.drawn.origin)

    def frame(camera: Camera, drawn: Images | None) -> Frame:
        assert drawn is not None
        return Frame(camera, origin, **{name: drawn[name] for name in renderer.channels}, lod=view.shown)

    behind = None if shared is None else frame(center, shared)
    return StereoFrame(rig.hmd, frame(left, images[0]), frame(right, images[1]), behind, passes.stats)
