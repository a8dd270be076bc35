"""Scenes seen through a headset, drawn at each level, and the score of each object on the panel."""

from __future__ import annotations

import functools
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.lod._objects import Crowd, Headset, crowd

LUMA = np.array([0.2126, 0.7152, 0.0722])
"""Rec. 709 weights of red, green and blue."""
LEAST_PIXELS = 16
"""Pixels of an object below which it is not scored: a mean over fewer pixels than two rows of a window is noise."""
VIEWS = 2
"""Directions of the camera in a scene."""

Levels = NDArray[np.int32]


@dataclass(frozen=True)
class Case:
    """A scene, a headset, and the views that are compared."""

    models: list[nf.lod.LodModel]
    crowd: Crowd
    headset: Headset
    cameras: list[nf.Camera]

    @classmethod
    def of(cls, models: list[nf.lod.LodModel], headset: Headset, size: int, count: int) -> Case:
        """As in the thesis, seen from the middle."""
        cameras = [headset.camera(2 * np.pi * n / VIEWS) for n in range(VIEWS)]
        return cls(models, crowd(models, size=size, count=count, seed=size * count), headset, cameras)

    @functools.cached_property
    def scene(self) -> nf.Scene:
        """With all levels."""
        return nf.lod.place(self.models, self.crowd.model_index, self.crowd.transforms)

    @functools.cached_property
    def truths(self) -> list[View]:
        """Pictures at full detail."""
        return [View.of(self, camera, self.in_full(camera)) for camera in self.cameras]

    @functools.cached_property
    def scores(self) -> list[NDArray[np.float64]]:
        """Score of each object at each level, for each view (K, N): all objects are drawn at that level at once."""
        most, last = max(map(len, self.models)), np.array([len(model) - 1 for model in self.models])
        of_views = []
        for camera, truth in zip(self.cameras, self.truths, strict=True):
            full, rows = self.in_full(camera), [np.ones(len(self.crowd.radii))]
            for level in range(1, most):
                levels = np.where(full < 0, full, np.minimum(level, last[self.crowd.model_index])).astype(np.int32)
                rows.append(scores(truth, View.of(self, camera, levels), len(levels)))
            rows[0] = np.where(np.isfinite(rows[1]), rows[0], np.nan)
            of_views.append(np.array(rows))
        return of_views

    @property
    def spheres(self) -> tuple[list[nf.lod.LodModel], NDArray[np.int64], NDArray[np.float64], NDArray[np.float64]]:
        """Arguments of `select`."""
        return self.models, self.crowd.model_index, self.crowd.centers, self.crowd.radii

    def in_full(self, camera: nf.Camera) -> Levels:
        """Level 0 of all that is in view."""
        return np.minimum(nf.lod.select(*self.spheres, camera=camera, mode="depth").level, 0)

    def screen_errors(self, camera: nf.Camera) -> NDArray[np.float64]:
        """Pixels that the geometric error of each level (K, N) covers at the sphere's nearest point; +inf for none."""
        distance = np.linalg.norm(self.crowd.centers - camera.position, axis=1) - self.crowd.radii
        scale = self.headset.size[1] / (self.headset.fov.up - self.headset.fov.down) / np.maximum(distance, 1e-6)
        errors = np.full((max(map(len, self.models)), len(distance)), np.inf)
        for number, model in enumerate(self.models):
            mine = self.crowd.model_index == number
            errors[: len(model), mine] = np.outer(model.errors, self.crowd.radii[mine] / model.radius * scale[mine])
        return errors

    def triangles(self, levels: Levels) -> int:
        """Triangles in view."""
        return sum(
            int(self.models[m].triangles[n]) for m, n in zip(self.crowd.model_index, levels, strict=True) if n >= 0
        )


@dataclass(frozen=True)
class View:
    """Picture on the panel of a headset."""

    luma: NDArray[np.float64]
    """8-bit steps."""
    objects: NDArray[np.int32]

    @staticmethod
    def of(case: Case, camera: nf.Camera, levels: Levels) -> View:
        """Draw and warp a view, so that the lens puts it right."""
        frame = nf.render(case.scene, camera, lod=levels, samples=4, channels=("color", "object_id"))
        luma, numbers = frame.to_image()[..., :3] @ LUMA, np.asarray(frame.object_id)
        warp = functools.partial(case.headset.lens.warp, inverse=True, fov=case.headset.fov)
        height, width = luma.shape
        rows, columns = np.mgrid[:height, :width].astype(np.float64)
        places = warp(np.stack([rows, columns], axis=-1), fill=-1.0)
        inside = np.all(places >= 0, axis=-1)
        at = np.rint(np.where(inside[..., None], places, 0)).astype(np.int64)
        objects = np.where(inside, numbers[at[..., 0], at[..., 1]], -1)
        return View(np.where(inside, warp(luma), 0.0), objects.astype(np.int32))


def scores(truth: View, test: View, count: int) -> NDArray[np.float64]:
    """Masked SSIM of each object (N,): over all pixels that show it in either view; NaN for few."""
    _, local = nf.ssim(truth.luma, test.luma, data_range=255, full=True)
    sums, pixels = np.zeros(count), np.zeros(count)
    either = [
        (truth.objects, truth.objects >= 0),
        (test.objects, (test.objects >= 0) & (test.objects != truth.objects)),
    ]
    for objects, chosen in either:
        sums += np.bincount(objects[chosen], local[chosen], minlength=count)
        pixels += np.bincount(objects[chosen], minlength=count)
    means: NDArray[np.float64] = np.divide(sums, pixels, out=np.full(count, np.nan), where=pixels >= LEAST_PIXELS)
    return means
