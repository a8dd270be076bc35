"""Scenes seen through a headset, drawn at each level, and the score of each object on the panel."""

from __future__ import annotations

import functools
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.pictures import average
from benchmarks.lod._objects import Crowd, Headset, crowd
from nearfar.metrics._inputs import LUMA

MIN_PIXELS = 16
"""Least number of pixels of a scored object: a mean over fewer pixels is noise."""
FINER = 2
"""Supersampling factor along each side of a displayed pixel, so that warping does not blur."""
TURNS = 2
"""Number of directions of the camera in a scene."""

Levels = NDArray[np.int32]


@dataclass(frozen=True)
class Case:
    """A scene, a headset, and the views that are compared."""

    models: list[nf.lod.LodModel]
    crowd: Crowd
    headset: Headset
    cameras: list[nf.Camera]

    @classmethod
    def in_sphere(
        cls, models: list[nf.lod.LodModel], headset: Headset, size: int, count: int, *, turns: int = TURNS
    ) -> Case:
        """Make a case as in the thesis, seen from the middle."""
        cameras = [headset.camera(2 * np.pi * n / turns) for n in range(turns)]
        return cls(models, crowd(models, size=size, count=count, seed=size * count), headset, cameras)

    @functools.cached_property
    def scene(self) -> nf.Scene:
        return nf.lod.place(self.models, self.crowd.model_index, self.crowd.transforms)

    @functools.cached_property
    def truths(self) -> list[View]:
        """Pictures at full detail, one for each view."""
        return [View.render(self, camera, self.full_levels(camera)) for camera in self.cameras]

    @property
    def fine_size(self) -> tuple[int, int]:
        """Width and height of the pictures before warping."""
        return FINER * self.headset.size[0], FINER * self.headset.size[1]

    def warp(self, picture: nf.Frame | NDArray[np.float64], **settings: Any) -> NDArray[Any]:
        return self.headset.lens.warp(picture, inverse=True, output_fov=self.headset.panel_fov, **settings)

    @functools.cached_property
    def places(self) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.bool_]]:
        """Row and column of the fine picture that each pixel of the panel shows (H, W), and whether it shows one."""
        width, height = self.fine_size
        rows, columns = np.mgrid[:height, :width].astype(np.float64)
        size = self.headset.panel_size
        places = self.warp(np.stack([rows, columns], axis=-1), fov=self.headset.fov, size=size, fill=-1.0)
        inside = np.all(places >= 0, axis=-1)
        nearest = np.rint(np.where(inside[..., None], places, 0)).astype(np.int64)
        return nearest[..., 0], nearest[..., 1], inside

    def scores(self, number: int, levels: Levels) -> NDArray[np.float64]:
        """Score of each object (N,) in a view with given levels; NaN for objects with too few visible pixels."""
        return self.compare(number, levels)[1]

    def compare(self, number: int, levels: Levels) -> tuple[float, NDArray[np.float64]]:
        """SSIM of the picture of a view with given levels, and the score of each object (N,)."""
        return compare(self.truths[number], View.render(self, self.cameras[number], levels), len(levels))

    @property
    def index_and_spheres(self) -> tuple[NDArray[np.int64], NDArray[np.float64], NDArray[np.float64]]:
        return self.crowd.model_index, self.crowd.centers, self.crowd.radii

    def with_pixels_of(self, camera: nf.Camera, mode: str) -> nf.Camera:
        """Return a view in the pixels of a mode: those of the panel, or those that a headset renders."""
        return replace(camera, size=self.headset.panel_size) if mode == "panel" else camera

    def full_levels(self, camera: nf.Camera) -> Levels:
        """Return level 0 for objects in view, −1 for the others."""
        return np.minimum(nf.lod.select(self.models, *self.index_and_spheres, camera=camera, mode="depth").level, 0)

    def screen_errors(self, camera: nf.Camera) -> NDArray[np.float64]:
        """Pixels covered by the geometric error of each level (K, N) at the sphere's nearest point; +inf for none."""
        distance = np.linalg.norm(self.crowd.centers - camera.position, axis=1) - self.crowd.radii
        scale = self.headset.size[1] / (self.headset.fov.up - self.headset.fov.down) / np.maximum(distance, 1e-6)
        errors = np.full((max(map(len, self.models)), len(distance)), np.inf)
        for number, model in enumerate(self.models):
            is_of_model = self.crowd.model_index == number
            errors[: len(model), is_of_model] = np.outer(
                model.errors, self.crowd.radii[is_of_model] / model.radius * scale[is_of_model]
            )
        return errors

    def triangles(self, levels: Levels) -> int:
        return sum(
            int(self.models[m].triangles[n]) for m, n in zip(self.crowd.model_index, levels, strict=True) if n >= 0
        )


@dataclass(frozen=True)
class View:
    """Picture on the panel of a headset."""

    luma: NDArray[np.float64]
    """Luma in 8-bit steps."""
    objects: NDArray[np.int32]

    @staticmethod
    def render(case: Case, camera: nf.Camera, levels: Levels) -> View:
        """Draw a view in fine pixels, warp it to cancel the lens's distortion, and average to the panel's pixels."""
        width, height = case.headset.panel_size
        frame = nf.render(case.scene, replace(camera, size=case.fine_size), lod=levels, channels=("color", "object_id"))
        color = case.warp(frame, size=(FINER * width, FINER * height))
        rows, columns, inside = case.places
        objects = np.where(inside, np.asarray(frame.object_id)[rows, columns], -1)
        return View(average(color, FINER) @ np.array(LUMA), objects.astype(np.int32))


def compare(truth: View, test: View, count: int) -> tuple[float, NDArray[np.float64]]:
    """SSIM of the picture with its background, and of each object (N,) where a view shows it; NaN for few pixels."""
    picture, local = nf.ssim(truth.luma, test.luma, data_range=255, full=True)
    sums, pixels = np.zeros(count), np.zeros(count)
    added = (test.objects >= 0) & (test.objects != truth.objects)
    for objects, mask in ((truth.objects, truth.objects >= 0), (test.objects, added)):
        sums += np.bincount(objects[mask], local[mask], minlength=count)
        pixels += np.bincount(objects[mask], minlength=count)
    return float(picture), np.divide(sums, pixels, out=np.full(count, np.nan), where=pixels >= MIN_PIXELS)
