"""Time of measuring one object's levels, compared with a script that uses pyrender and scikit-image.

`measure` does the whole job: 144 views, 16 distances, 10 levels. The whole job would take the script hours, so it
renders frames of base and level for only some views and distances, and its time is scaled. Curves are compared from all
views at those distances. For these the script renders only the object's boxes; a table shows that their scores equal
those of whole frames. Both programs take one sample a pixel and colour by face, so that their pictures are alike. The
object is a bumpy sphere of 100,488 triangles.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any
from unittest import mock

import numpy as np
from numpy.typing import NDArray
from skimage.color import rgb2gray
from skimage.metrics import structural_similarity

import nearfar as nf
from benchmarks.harness import opengl
from benchmarks.harness.report import start, table
from benchmarks.harness.timing import Timing, timed
from nearfar._scene.srgb import to_srgb
from nearfar.lod._measure import statistic
from nearfar.lod._measure.views import Orbit, Screen, turns
from nearfar.orthoview._gaussians import SUN, irradiance
from tests.support import lod_cases

Array = NDArray[np.float64]
RATIOS = (0.7, 0.5, 0.35, 0.25, 0.15, 0.1, 0.05, 0.03, 0.01, 0.005)
VIEWS, DISTANCES = 144, 16
PARTS = ("frames", "whole", "box")
MAX_CURVE_DIFFERENCE = 1e-3
"""Maximum difference in SSIM between nearfar's curves and the script's."""

FINE = 600
"""Approximate number of samples across a box; boxes of fewer pixels are supersampled."""

SSIM = {"gaussian_weights": True, "sigma": 1.5, "use_sample_covariance": False, "data_range": 255.0, "full": True}


# the script ----------------------------------------------------------------------------------------------------------
def face_colors(scene: nf.Scene) -> Array:
    """Shading of each face by nearfar's formula, seen from outside, as sRGB values from 0 to 1."""
    corners = scene.triangles().astype(np.float64)
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    length = np.linalg.norm(normals, axis=1, keepdims=True)
    normals = np.divide(normals, length, out=np.zeros_like(normals), where=length > 0)
    return to_srgb(0.8 * irradiance(normals.astype(np.float32), SUN))


@contextmanager
def one_sample() -> Iterator[Any]:
    """Yield pyrender with one sample a pixel instead of four."""
    peer, name = opengl.pyrender(), "glRenderbufferStorageMultisample"
    storage = getattr(peer.renderer, name)
    with mock.patch.object(peer.renderer, name, lambda kind, _, *rest: storage(kind, 0, *rest)):
        yield peer


@dataclass
class Frame:
    """Picture to compare."""

    luma: Array
    """Luma, 0 to 255."""
    is_object: NDArray[np.bool_]


class Script:
    """Renders frames of base and level, and computes their similarity where either shows the object."""

    def __init__(self, levels: nf.lod.Levels, orbit: Orbit, pyrender: Any) -> None:
        self.flags = pyrender.RenderFlags.FLAT
        self.renderer = pyrender.OffscreenRenderer(*orbit.screen.size)
        self.orbit = orbit

        class View(pyrender.Camera):  # type: ignore[misc]  # pyrender has no types
            """Camera of any part of a screen."""

            fov = nf.Fov.symmetric(90)

            def get_projection_matrix(self, width: int | None = None, height: int | None = None) -> Array:
                left, right, down, up = self.fov.left, self.fov.right, self.fov.down, self.fov.up
                near, far = 0.1 * levels.radius, 100 * levels.radius
                x = [2 / (right - left), 0, (right + left) / (right - left), 0]
                y = [0, 2 / (up - down), (up + down) / (up - down), 0]
                z = [0, 0, -(far + near) / (far - near), -2 * far * near / (far - near)]
                return np.array([x, y, z, [0, 0, -1, 0]])

        self.view = View()
        self.scenes, self.nodes = [], []
        for level in levels:
            corners = level.scene.triangles().reshape(-1, 3)
            colors = np.repeat(np.c_[face_colors(level.scene), np.ones(level.triangle_count)], 3, axis=0)
            scene = pyrender.Scene(bg_color=(0.0, 0.0, 0.0, 0.0))
            scene.add(pyrender.Mesh([pyrender.Primitive(positions=corners, color_0=colors.astype(np.float32))]))
            self.nodes.append(scene.add(self.view))
            self.scenes.append(scene)
            self.renderer.render(scene, self.flags)  # sends the mesh
        self.empty_scene = nf.Scene.from_arrays(levels.center + 1e-9 * levels.radius * np.eye(3), [[0, 1, 2]])

    def full_camera(self, number: int, turn: Any) -> nf.Camera:
        """Return the camera of the whole screen, at the position from which `measure` renders only a box of it."""
        width, height = self.orbit.screen.size
        x, y = width / 2 * self.orbit.screen.pixel, height / 2 * self.orbit.screen.pixel
        boxed = self.orbit.camera(number, turn)
        return nf.Camera(boxed.position, boxed.orientation, fov=nf.Fov(-x, x, -y, y), size=(width, height))

    def frame(self, level: int, camera: nf.Camera, sky: NDArray[np.uint8], finer: int = 1) -> Frame:
        """Draw a level in front of the sky, with the middle one of `finer` samples along each axis of a pixel."""
        assert isinstance(camera.fov, nf.Fov)
        self.view.fov = camera.fov
        self.renderer.viewport_width, self.renderer.viewport_height = camera.width * finer, camera.height * finer
        self.scenes[level].set_pose(self.nodes[level], opengl.pose_of(camera))
        images = self.renderer.render(self.scenes[level], self.flags)
        color, depth = (image[finer // 2 :: finer, finer // 2 :: finer] for image in images)
        is_object = depth > 0
        return Frame(255.0 * rgb2gray(np.where(is_object[..., None], color, sky)), is_object)

    def sky(self, camera: nf.Camera) -> NDArray[np.uint8]:
        """Return nearfar's background, which pyrender lacks; its time is not counted."""
        return nf.render(self.empty_scene, camera, channels=["color"], backend="cpu").to_image()


def similarity(base: Frame, test: Frame) -> float:
    either = base.is_object | test.is_object
    return float(structural_similarity(base.luma, test.luma, **SSIM)[1][either].mean())


def crop_to_box(base: Frame, test: Frame) -> tuple[Frame, Frame]:
    either = base.is_object | test.is_object
    rows, columns = np.flatnonzero(either.any(axis=1)), np.flatnonzero(either.any(axis=0))
    box = np.s_[max(0, rows[0] - 5) : rows[-1] + 6, max(0, columns[0] - 5) : columns[-1] + 6]
    return Frame(base.luma[box], base.is_object[box]), Frame(test.luma[box], test.is_object[box])


Seconds = dict[str, Array]
"""Wall and CPU seconds of parts of the script."""


def by_whole_frames(script: Script, count: int, views: list[Any], numbers: list[int]) -> tuple[Array, Seconds]:
    """Scores (2, K, D, V) of the whole frame and of the object's box in it, one pair of frames after the other."""
    scores, seconds = np.ones((2, count, len(numbers), len(views))), {part: np.zeros(2) for part in PARTS}

    def run(part: str, job: Callable[..., Any], *arguments: Any) -> Any:
        result, time = timed(job, *arguments)
        seconds[part] += time.wall, time.cpu
        return result

    for (d, number), (v, turn) in itertools.product(enumerate(numbers), enumerate(views)):
        camera = script.full_camera(number, turn)
        sky = script.sky(camera)
        for level in range(1, count):
            base, test = (run("frames", script.frame, each, camera, sky) for each in (0, level))
            scores[0, level, d, v] = run("whole", similarity, base, test)
            scores[1, level, d, v] = run("box", lambda base, test: similarity(*crop_to_box(base, test)), base, test)
    return scores, seconds


def by_boxes(script: Script, count: int, views: list[Any], numbers: list[int]) -> Array:
    """Compute scores (K, D, V) of many views, in pictures of boxes.

    Rasterisers round corners to 1/256 of a pixel; nearfar does not. Where triangles are much smaller than a pixel, some
    pixels therefore show another triangle. Small boxes are supersampled, so that the rounding matters less.
    """
    scores = np.ones((count, len(numbers), len(views)))
    for d, number in enumerate(numbers):
        for v, turn in enumerate(views):
            camera = script.orbit.camera(number, turn)
            sky, finer = script.sky(camera), max(1, FINE // camera.width // 2 * 2 - 1)
            base = script.frame(0, camera, sky, finer)
            for level in range(1, count):
                scores[level, d, v] = similarity(base, script.frame(level, camera, sky, finer))
    return scores


def main() -> None:
    distances = {"type": int, "nargs": "+", "default": [1, 2, 4, 8, 16]}
    arguments = start(__doc__, views=3, distances=distances, file={"nargs": "?"})
    levels = nf.lod.simplify(nf.Scene.load(arguments.file) if arguments.file else lod_cases.scene(159), RATIOS)
    print(levels, flush=True)
    options: dict[str, Any] = {"hmd": nf.hmd.RIFT_S, "samples": 1, "backend": "cpu", "cache": False}
    options |= {"views": VIEWS, "distances": DISTANCES, "spacing": "published", "standard_error": 0.0}
    options |= {"step": None, "saturated": None}
    ours, time = timed(nf.lod.measure, levels, **options)
    assert ours.samples is not None
    assert ours.samples.views is not None

    screen = Screen.from_arguments(nf.hmd.RIFT_S, None, None)
    orbit = Orbit.of_levels(levels, screen, screen.sines("published", DISTANCES))
    distinct_turns, turn_of_view = turns(VIEWS, "even")
    view_numbers = np.linspace(1, VIEWS - 1, arguments.views).round().astype(int)
    with one_sample() as pyrender:
        script = Script(levels, orbit, pyrender)
        sampled_scores, seconds = by_whole_frames(
            script, len(levels), [distinct_turns[turn_of_view[v]] for v in view_numbers], arguments.distances
        )
        boxed_scores = by_boxes(script, len(levels), distinct_turns, arguments.distances)[..., turn_of_view]
    print(times(time, seconds, sampled_scores[0, 1:].size, (len(levels) - 1) * VIEWS * DISTANCES, levels))

    indices = np.array(arguments.distances) - 1
    measured, sigma = ours.samples.views[:, indices], ours.samples.sigma[indices]
    scores = [statistic.of_views(view_scores, 25.0) for view_scores in (measured, boxed_scores)]
    curves = [nf.lod.fit_4pl(sigma, score[1:])(np.geomspace(sigma[-1], sigma[0], 100)) for score in scores]
    differences_of = {
        "whole frames and their boxes, single views": np.abs(sampled_scores[0] - sampled_scores[1]).max(axis=(0, 2)),
        "whole frames and ours, single views": np.abs(sampled_scores[0] - measured[..., view_numbers]).max(axis=(0, 2)),
        f"percentiles of {VIEWS} views": np.abs(scores[0] - scores[1]).max(axis=0),
    }
    header = ["what", *(f"distance {n} {{:.1e}}" for n in arguments.distances), "all {:.1e}"]
    rows = [[name, *differences, differences.max()] for name, differences in differences_of.items()]
    print(table("Differences of scores", header, rows))
    greatest = float(np.abs(curves[0] - curves[1]).max())
    is_close = greatest <= MAX_CURVE_DIFFERENCE
    print(f"curves of {VIEWS} views differ by {greatest:.1e}; at most {MAX_CURVE_DIFFERENCE}: {is_close}")


def times(time: Timing, parts: Seconds, scored: int, total: int, levels: nf.lod.Levels) -> str:
    ours = np.array([time.wall, time.cpu])
    rows_of = {
        "nearfar": (ours, total),
        "pyrender, scikit-image": (parts["frames"] + parts["whole"], scored),
        "the same, SSIM of the object's box": (parts["frames"] + parts["box"], scored),
        "pyrender's frames alone": (parts["frames"], scored),
    }
    rows = [[name, *spent, (count, total), *(spent / count * total / ours)] for name, (spent, count) in rows_of.items()]
    header = "program | wall s {:.1f} | CPU s {:.1f} | scores {:,} of {:,} | × ours, whole job {:.0f} | × CPU {:.0f}"
    title = f"{levels[0].triangle_count:,} triangles, {len(levels) - 1} levels, {VIEWS} views, {DISTANCES} distances"
    return table(title, header, rows)


if __name__ == "__main__":
    main()
