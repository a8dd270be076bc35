"""Tear along the end of the near part, for random users and views: both methods, two pairs of radii.

Rows of cities with occlusion separate the sources of tears: surfaces across r₂, surfaces visible to the user, each
object by itself, and the ground.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import maximum_filter

import nearfar as nf
from benchmarks.harness import scenes
from benchmarks.harness.report import start, table
from benchmarks.harness.views import Point, center_for
from nearfar._reduce.drawing import MorphKind

Positions = NDArray[np.float64]
Mask = NDArray[np.bool_]
Sums = NDArray[np.float64]
"""For both methods: number of pixels, sum of tears, sum of kinks."""

REACH = 8.0
"""Greatest distance of users from the centre, metres."""

DENSITY = 20.0
"""Density in pixels per degree where the camera looks, as in headsets."""

MIN_EDGE = 200
"""Least number of boundary pixels with both sides in view for a view to count."""

MAX_TRIES = 60


def cases(quick: bool) -> Iterator[tuple[str, nf.Scene, Point]]:
    """Yield the name, the scene and a centre of each available city."""
    for name, scene in scenes.present(*([] if quick else ["Tokyo core", "Manhattan core"])):
        yield name, scene, center_for(scene, 50.0)
    yield "procedural city", scenes.city(quick), nf.datasets.street_view()[0]


def views(center: Point, seed: int, reach: float = REACH) -> Iterator[nf.Camera]:
    """Yield views of users at random places within `reach` with random directions, slightly downwards."""
    draw = np.random.default_rng(seed)
    fov = nf.Fov.symmetric(60, 16 / 9)
    width = round(DENSITY * float(np.degrees(fov.right - fov.left)))
    for _ in range(MAX_TRIES):
        position_angle, azimuth = draw.uniform(0.0, 2.0 * np.pi, 2)
        distance = reach * np.sqrt(draw.uniform())
        user = np.add(center, (distance * np.cos(position_angle), 0.0, distance * np.sin(position_angle)))
        toward = np.add(user, (np.cos(azimuth), -0.05, np.sin(azimuth)))
        yield nf.Camera.look_at(user, toward, fov=fov, size=(width, round(width * 9 / 16)))


def pictures(reduced: nf.ReducedScene, camera: nf.Camera) -> list[nf.Frame]:
    """Positions of the conventional and of the continuous picture, with a far part of unlimited resolution."""
    methods: dict[MorphKind, Any] = {"none": "auto", "blend": "exact"}
    settings: dict[str, Any] = {"env": False, "channels": ("position", "object_id")}
    return [reduced.with_morph(morph).render(camera, method=method, **settings) for morph, method in methods.items()]


def places_of(frame: nf.Frame) -> Positions:
    """World positions (H, W, 3)."""
    return np.asarray(frame.require("position").astype(np.float64) + frame.origin)


def visible_mask(frame: nf.Frame, truth: nf.Frame) -> Mask:
    """Pixels (H, W) whose points are visible in the truth, to 1 % of their distance and a pixel to each side."""
    camera, points = frame.camera, places_of(frame)
    is_known = np.isfinite(points).all(axis=-1)
    distances = np.linalg.norm(places_of(truth) - camera.position, axis=-1)
    farthest = maximum_filter(np.where(np.isfinite(distances), distances, np.inf), 3, mode="nearest")
    height, width = is_known.shape
    pixels = camera.project(points[is_known])[:, :2]
    column, row = (np.nan_to_num(np.floor(values), nan=-1.0) for values in pixels.T)
    is_inside = (column >= 0) & (row >= 0) & (column < width) & (row < height)
    limit = np.full(len(pixels), np.inf)
    limit[is_inside] = farthest[row[is_inside].astype(int), column[is_inside].astype(int)]
    visible = np.zeros_like(is_known)
    visible[is_known] = np.linalg.norm(points[is_known] - camera.position, axis=1) <= 1.01 * limit
    return visible


def keep_pixels(frame: nf.Frame, kept: Mask) -> nf.Frame:
    """Return a frame with the positions of some pixels only."""
    return nf.Frame(frame.camera, frame.origin, position=np.where(kept[..., None], frame.require("position"), np.nan))


def parts(scene: nf.Scene, frame: nf.Frame, truth: nf.Frame, end: Mask) -> dict[str, list[tuple[nf.Frame, bool]]]:
    """Frames by row of the table, with a flag if only surfaces across r₂ count; `end` marks pixels beyond r₂."""
    numbers = frame.require("object_id")
    crossing = [n for n in np.unique(numbers[end]) if n >= 0 and (numbers[~end] == n).any()]
    ground = [n for n, name in enumerate(scene.object_names) if name.startswith("ground")]
    masks = {
        "whole boundary": [(frame, False)],
        "surfaces across r₂": [(frame, True)],
        "the same, as far as the user sees them": [(keep_pixels(frame, visible_mask(frame, truth)), True)],
        "each object by itself": [(keep_pixels(frame, numbers == n), True) for n in crossing],
    }
    if ground:
        masks["the ground by itself"] = [(keep_pixels(frame, np.isin(numbers, ground)), False)]
    return masks


def tears(name: str, scene: nf.Scene, center: Point, count: int, seed: int) -> str:
    """Table of both methods at 30 and 50 m, and at the chosen radii; means over all pixels of all views."""
    chosen_radii = nf.choose_radii(scene, center, r2=50.0, reach=REACH)
    rows = []
    for r1 in (30.0, chosen_radii.r1):
        reduced = nf.reduce(scene, center=center, r1=r1, r2=50.0, face_size=16, samples=1)
        cylinder: dict[str, Any] = {"center": reduced.center, "radius": reduced.r2}
        sums: dict[str, Sums] = {}
        view_count = 0
        for camera in views(center, seed):
            frames = pictures(reduced, camera)
            if not all(_count(nf.metrics.boundary_tear(frame, **cylinder)) >= MIN_EDGE for frame in frames):
                continue
            view_count += 1
            truth = nf.render(scene, camera, channels=("position",), backend="cpu")
            for method, frame in enumerate(frames):
                for part, each in parts(scene, frame, truth, _rho(frame, center) > reduced.r2).items():
                    added = sums.setdefault(part, np.zeros((2, 3)))
                    for one, surfaces in each:
                        added[method] += _sums(nf.metrics.boundary_tear(one, **cylinder, surfaces=surfaces))
            if view_count == count:
                break
        rows += [_row(r1, part, view_count, added) for part, added in sums.items()]
    header = "r₁, r₂, m {:.3g}, 50 | where | views | conventional, px {:.3g} | continuous, px {:.3g}"
    header += " | of which kink {:.2g} | ratio {:.3g}"
    return table(f"Tear along r₂, {name}, {DENSITY:g} pixels a degree", header, rows)


def _rho(frame: nf.Frame, center: Point) -> Positions:
    offsets = places_of(frame) - center
    return np.asarray(np.hypot(offsets[..., 0], offsets[..., 2]))


def _count(one: nf.metrics.BoundaryTear) -> float:
    return one.pixels * (one.shared or 0.0)


def _sums(one: nf.metrics.BoundaryTear) -> Positions:
    """Number of pixels, and sums of tears and kinks over them."""
    return _count(one) * np.array([1.0, one.tear or 0.0, one.kink or 0.0])


def _row(r1: float, part: str, views: int, sums: Sums) -> list[object]:
    if not (sums[:, 0] > 0.0).all():
        return [r1, part, views, *["–"] * 4]
    (conventional, _), (continuous, kink) = sums[:, 1:] / sums[:, :1]
    return [r1, part, views, conventional, continuous, kink, conventional / continuous]


def main() -> None:
    arguments = start(__doc__, "--quick", views=6, seed=7)
    for name, scene, center in cases(arguments.quick):
        print(tears(name, scene, center, 2 if arguments.quick else arguments.views, arguments.seed))


if __name__ == "__main__":
    main()
