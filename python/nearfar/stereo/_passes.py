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
from nearfar._render.motion import Viewpoint, motion
from nearfar._render.renderable import Images, Renderable
from nearfar._render.renderer import Renderer, View
from nearfar._render.settings import require_defaults
from nearfar._scene.levels import Leveled
from nearfar._scene.scene import Scene
from nearfar.hmd._hmd import EYES
from nearfar.hmd._stereo import StereoFrame
from nearfar.stereo._geometry import RigGeometry
from nearfar.stereo._moments import Moment, map_motion, shift_pixels
from nearfar.stereo._settings import UNUSED, HybridSettings

_BITS = {"left": 1, "right": 2, "center": 4}
"""Bit of each view in the masks of instances that `contents` returns."""


@dataclass
class Passes:
    """Passes of one frame of a rig; they add to `stats`."""

    rig: RigGeometry
    moment: Moment
    view: View
    device: _core.GpuDevice | None
    settings: HybridSettings
    previous: Moment | None = None
    """Moment that motion is relative to; None for `moment`."""
    jitter: tuple[float, float] = (0.0, 0.0)
    """Fraction of a pixel by which the pixels of all three pictures are shifted to the right and down."""
    stats: dict[str, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self._core = self.rig._core.jittered(self.jitter)
        self._views: NDArray[np.uint8] | None = None

    def draw(self) -> tuple[Images, Images, Images | None]:
        """Return the images of the left and the right eye, and the shared ones if anything lies beyond the plane."""
        self.stats |= {"seconds": {}, "pixels": {}}
        left, right, center = self._cameras(self.moment)
        with self._measure_time("culling"):
            has_near, has_far = self._has_near_and_far()
        with progress.bar("rendering") as self._report:
            if not has_far:
                return *self._draw_plain(left, right), None
            near = self._clip_between(self.settings.near, min(self.rig.planes[0], self.settings.far))
            eyes = [
                self._draw_picture(side, camera, near, near=True) if has_near else self._empty_images(camera)
                for side, camera in zip(EYES, (left, right), strict=True)
            ]
            shared = self._draw_shared(center, eyes)
            for side, camera, images in zip(EYES, (left, right), eyes, strict=True):
                with self._measure_time("assembly"):
                    self._assemble(side, camera, images, center, shared)
                if self._fills_gaps:
                    self._fill_gaps(side, camera, images)
        return eyes[0], eyes[1], shared

    def _draw_shared(self, camera: Camera, eyes: list[Images]) -> Images:
        """Draw the pixels of the third camera that an eye looks up."""
        mask = None
        if self.settings.cull != "frustum":
            with self._measure_time("culling"):
                samples = self.view.shot.samples if self.settings.assembly == "resolved" else 1
                mask = self._core.needed(eyes[0]["coverage"], eyes[1]["coverage"], samples)
        images = self._draw_picture(
            "center", camera, self._far_clip, mask=mask, faces=self.settings.assembly == "resolved"
        )
        if mask is not None and "color" in images:
            images["color"][~mask] = 0.0
        drawn_count = camera.width * camera.height if mask is None else int(mask.sum())
        self.stats["pixels"] |= {"center": drawn_count, "discarded": camera.width * camera.height - drawn_count}
        return images

    def _draw_picture(
        self,
        name: str,
        camera: Camera,
        clip: Clip,
        *,
        near: bool = False,
        mask: NDArray[np.bool_] | None = None,
        faces: bool = False,
        stage: str | None = None,
    ) -> Images:
        """Draw one picture; its seconds count for `stage`, by default the picture's name."""
        extra = ["coverage"] if near or self._fills_gaps else []
        if faces or (near and self._centered_channels):
            extra += ["face_id", "range"]  # surfaces other than triangles have a range only
        shot = self._shot(
            camera,
            channels=tuple(dict.fromkeys([*self.view.shot.channels, *extra])),
            clip=clip,
            mask=mask,
            bare=near,
            occlusion=self.settings.cull == "occlusion",
            instances=None if self._views is None else (self._views & _BITS[name]) > 0,
        )
        with self._measure_time(stage or name):
            if near and self.rig.has_zone:
                images = self._draw_zone(name, camera, shot)
            else:
                (images,) = self._draw_shot(shot)
        self._add_motion(name, camera, images, mask, near=near)
        if near:
            self.stats["pixels"][name] = int((images["coverage"] > 0.0).sum())
        return images

    def _draw_plain(self, left: Camera, right: Camera) -> tuple[Images, Images]:
        """Draw both eyes as plain stereo, at once if the adapter can."""
        clip = self._clip_between(self.settings.near, self.settings.far)
        with self._measure_time("eyes"):
            eyes = self._draw_shot(self._shot(left, right, channels=self.view.shot.channels, clip=clip))
        for name, camera, images in zip(EYES, (left, right), eyes, strict=True):
            self._add_motion(name, camera, images)
        return eyes[0], eyes[1]

    def _shot(self, *cameras: Camera, **settings: Any) -> Shot:
        samples, user = self.view.shot.samples, self.moment.head(self.rig)
        return Shot(cameras=cameras, samples=samples, user=user, **settings)

    def _draw_shot(self, shot: Shot) -> list[Images]:
        """Draw the pictures of a shot, one for each camera."""
        if self.device is None:
            return list(self.view.drawn.trace(shot, self._report))
        jobs = self.view.drawn.begin(self.device, shot, self._report)
        return [job.finish(self._report) for job in jobs]

    def _draw_zone(self, side: str, camera: Camera, shot: Shot) -> Images:
        """Draw an eye's own picture up to m₂, along rays that bend beyond m₁."""
        scene = self.view.drawn
        assert isinstance(scene, Scene)
        return self._core.render_zone(side, scene._core, camera._core, shot.settings, self._head, report=self._report)

    def _assemble(self, side: str, camera: Camera, images: Images, center: Camera, shared: Images) -> None:
        """Put the shared picture behind an eye's own, in place."""
        core, coverage = self._core, images["coverage"]
        if "color" in images:
            if self.settings.assembly == "resolved":
                settings = self._shot(center, channels=("color",), clip=self._far_clip).settings
                scene = self.view.drawn
                assert isinstance(scene, Scene)
                picture = (center._core, shared["color"], shared["face_id"])
                core.resolve(side, coverage, scene._core, settings, picture, images["color"])
            else:
                core.assemble(side, coverage, shared["color"], images["color"])
        if set(self.view.channels) == {"color"} and "coverage" not in shared:
            return
        nearest = core.nearest(side, coverage)
        if self._centered_channels:
            # These channels are sampled at the pixel's centre, where the eye's own surface takes precedence.
            is_open = np.isinf(images["range"])
            for name in self._centered_channels:
                values = shared[name].reshape(-1, *shared[name].shape[2:])[nearest[is_open]]
                if name == "range":
                    values = self._distances_to_eye(values, nearest[is_open], camera, center)
                elif name == "motion":
                    values = map_motion(core.homography(side), is_open, values)
                images[name][is_open] = values
        if "coverage" in shared:
            # The eye's own surfaces cover a share of the pixel, and the shared picture's surfaces a share of the rest.
            images["coverage"] = coverage + (1.0 - coverage) * shared["coverage"].reshape(-1)[nearest]

    def _fill_gaps(self, side: str, camera: Camera, images: Images) -> None:
        """Draw surfaces beyond the plane in narrow gaps of the assembled picture, in place.

        A surface that is seen edge-on, or crosses the plane beside the line of sight, shows one side to the eye and the
        other one to the third camera.
        """
        far_clip = self._clip_between(self.rig.planes[1], self.settings.far)
        covered, tried = images["coverage"] > 0.0, np.zeros(images["coverage"].shape, bool)
        self.stats["pixels"].setdefault("filled", 0)
        # Filling a gap may leave its neighbour as a narrow gap.
        while (holes := narrow_gaps(covered) & ~tried).any():
            far_images = self._draw_picture(side, camera, far_clip, mask=holes, stage="filling")
            filled = holes & (far_images["coverage"] > 0.0)
            for name in {*self.view.channels, "coverage"}:
                images[name][filled] = far_images[name][filled]
            covered, tried = covered | filled, tried | holes
            self.stats["pixels"]["filled"] += int(filled.sum())

    @property
    def _fills_gaps(self) -> bool:
        """Whether narrow gaps are filled: only by the tracer, whose cost is proportional to these pixels."""
        return self.device is None and not self.rig.has_zone

    @property
    def _centered_channels(self) -> list[str]:
        """Requested channels with one sample per pixel."""
        return [name for name in self.view.channels if name not in ("color", "coverage")]

    def _cameras(self, moment: Moment) -> list[Camera]:
        """Cameras of the eyes and the third one."""
        return [shift_pixels(camera, self.jitter) for camera in self.rig.cameras(moment.position, moment.orientation)]

    def _add_motion(
        self, name: str, camera: Camera, images: Images, mask: NDArray[np.bool_] | None = None, *, near: bool = False
    ) -> None:
        """Add the motion of each pixel's surface, if requested; NaN outside the mask or, with `near`, the surfaces."""
        if "motion" not in self.view.channels:
            return
        with self._measure_time("motion"):
            mask = np.isfinite(images["range"]) if near else mask
            before = self.moment if self.previous is None else self.previous
            origin = check.vector("origin", self.view.drawn.origin)
            frame = Frame(camera, origin, position=images["position"], object_id=images.get("object_id"))
            earlier = self._cameras(before)[(*EYES, "center").index(name)]
            now = Viewpoint(camera, self.view.drawn, self.moment.head(self.rig))
            images["motion"] = motion(frame, now, Viewpoint(earlier, before.source, before.head(self.rig)), mask)

    def _distances_to_eye(
        self, values: NDArray[np.float32], pixels: NDArray[np.uint32], camera: Camera, center: Camera
    ) -> NDArray[np.float32]:
        """Return distances from an eye to the points that pixels of the third camera show, `values` metres from it."""
        starts, directions = (rays.reshape(-1, 3)[pixels] for rays in center.rays())
        hit = np.isfinite(values)
        points = starts + directions * np.where(hit, values, 0.0)[:, None].astype(np.float64)
        distances = np.linalg.norm(points - np.array(camera.position), axis=1)
        return np.where(hit, distances, np.inf).astype(np.float32)

    def _empty_images(self, camera: Camera) -> Images:
        """Images of an eye without surfaces before the plane."""
        width, height = camera.size
        misses = {"face_id": np.int64(-1), "object_id": np.int32(-1), "range": np.float32(math.inf)}
        dark = {"color": np.float32(0.0), "coverage": np.float32(0.0)}
        empty: Images = {}
        for name in {*self.view.channels, "coverage", "face_id", "range"}:
            value = (misses | dark).get(name, np.float32(math.nan))
            components = (3,) if name in VECTORS else (2,) if name == "motion" else ()
            empty[name] = np.full((height, width, *components), value)
        return empty

    def _has_near_and_far(self) -> tuple[bool, bool]:
        """Whether anything is drawn before the plane, and beyond it; both if the source does not tell."""
        scene, has_zone = self.view.drawn, self.rig.has_zone
        if self.settings.far <= self.rig.planes[1] and not has_zone:
            return True, False
        if not isinstance(scene, Scene):
            return True, True
        views, near, far = self._core.contents(scene._core, self._head, self.device is None)
        triangles = np.diff(scene._core.triangle_offsets())
        in_view = {name: (views & bit) > 0 for name, bit in _BITS.items()}
        self.stats["instances"] = {"all": len(views)} | {name: int(mask.sum()) for name, mask in in_view.items()}
        self.stats["triangles"] = {"all": int(triangles.sum())} | {
            name: int(triangles[mask].sum()) for name, mask in in_view.items()
        }
        if self.device is not None and far:
            self._views = views
        # Rays bend in a zone, so that it needs its own pass even if nothing lies beyond it.
        return near, far or has_zone

    @property
    def _head(self) -> tuple[Any, Any, tuple[float, float]]:
        """Position and orientation of the head, and the nearest and the farthest drawn depth, as kernels take them."""
        return self.moment.position, self.moment.orientation, (self.settings.near, self.settings.far)

    @property
    def _far_clip(self) -> Clip:
        """Space that the third camera draws."""
        begin = max(self.settings.near, min(self.rig.planes[1], self.settings.far) - self.rig.overlap)
        return self._clip_between(begin, self.settings.far)

    def _clip_between(self, begin: float, end: float) -> Clip:
        return self.rig.clip(self.moment.position, self.moment.orientation, near=begin, far=end)

    @contextmanager
    def _measure_time(self, name: str) -> Iterator[None]:
        start = time.perf_counter()
        yield
        seconds = self.stats["seconds"]
        seconds[name] = seconds.get(name, 0.0) + time.perf_counter() - start


def narrow_gaps(covered: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Find pixels (H, W) in gaps of one or two pixels, across or down, between covered ones; outside counts as covered.

    A straight outline has no such pixels on its outer side, whatever its direction.
    """
    return ~covered & (_find_bridged(covered) | _find_bridged(covered.T).T)


def _find_bridged(covered: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Find pixels between covered pixels to the left and to the right that are at most three pixels apart."""
    padded = np.pad(covered, ((0, 0), (2, 2)), constant_values=True)
    previous_2, previous_1, next_1, next_2 = padded[:, :-4], padded[:, 1:-3], padded[:, 3:-1], padded[:, 4:]
    bridged: NDArray[np.bool_] = (previous_1 & next_1) | (previous_1 & next_2) | (previous_2 & next_1)
    return bridged


def check_near(rig: RigGeometry, near: float) -> None:
    """Raise ValueError unless the nearest drawn depth lies before m₁."""
    m = rig.planes[0]
    if not near < m:
        raise ValueError(f"near: expected less than the mono plane's {m:g} m, got {near:g}")


def render(
    rig: RigGeometry,
    renderer: Renderer,
    pose: tuple[ArrayLike, ArrayLike],
    *,
    at: Mapping[str, ArrayLike] | None,
    hybrid: HybridSettings,
    before: Moment | None = None,
    jitter: tuple[float, float] = (0.0, 0.0),
) -> tuple[StereoFrame, Moment]:
    """Check the arguments of `HybridRig.render`, and draw; `pose` is the head's pose, `at` has the objects' poses."""
    check_near(rig, hybrid.near)
    settings = renderer.settings
    require_defaults(settings, "a rig", *UNUSED)
    kind = type(renderer.source).__name__
    if hybrid.assembly == "resolved" and not isinstance(renderer.source, Scene):
        raise ValueError(f"assembly: expected 'bilinear' for {kind}, got 'resolved', which needs a scene's triangles")
    if rig.has_zone and not isinstance(renderer.source, Scene):
        raise ValueError(f"mono_plane: expected one plane for {kind}, got a zone, which only scenes support")
    device = None if rig.has_zone and settings.backend != "gpu" else renderer.device()
    if rig.has_zone and device is not None:
        raise ValueError("mono_plane: expected one plane on a graphics adapter, got a zone: backend='cpu' draws it")
    position, orientation = check.vector("position", pose[0]), quaternion(pose[1])
    left, right, center = rig.cameras(position, orientation)

    def draws(source: Renderable, leveled: Leveled) -> NDArray[np.uint8]:
        """Count the pictures that may draw each object at any level; all three of a source that is not culled."""
        if not isinstance(source, Scene):
            return np.full(len(leveled), len(_BITS), np.uint8)
        return rig._core.draws(source.level_boxes, (position, orientation, (hybrid.near, hybrid.far)))

    # Levels of detail are chosen for both eyes at once.
    view = renderer.view(renderer.shot([left, right]), at, draws=draws)
    moment = Moment(position, orientation, view.drawn)
    passes = Passes(rig, moment, view, device, hybrid, before, jitter)
    *images, shared = passes.draw()
    origin = check.vector("origin", view.drawn.origin)

    def frame(camera: Camera, drawn: Images | None) -> Frame:
        assert drawn is not None
        return Frame(camera, origin, **{name: drawn[name] for name in renderer.channels}, lod=view.shown)

    shared_frame = None if shared is None else frame(center, shared)
    return StereoFrame(rig.hmd, frame(left, images[0]), frame(right, images[1]), shared_frame, passes.stats), moment
