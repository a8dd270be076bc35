"""Parts of the benchmark of walks: ways through cities, jumps of far points at changes, and drawings."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.report import save_figure, subplots

Array = NDArray[np.float64]

FOV, SIZE = nf.Fov.symmetric(90, 16 / 9), (960, 540)
"""Views in which jumps are measured; the focal length is 480 px."""
FOCAL = 480.0

_TURNS = np.radians(np.arange(0.0, 360.0, 2.0))
_MARGIN = 3.0
"""Distance in metres that a way keeps from the wall ahead."""


@dataclass(frozen=True)
class Change:
    """A change from one region to the next, and the far points that both show."""

    step: float
    """Metres between the centres."""
    ranges: Array
    """(N,) metres from the old centre to each point."""
    measured: Array
    """(N,) pixels by which the point moves in the new picture."""
    predicted: Array
    """(N,) f·|ΔO⊥|/ρ, the prediction of first order."""
    exact: Array
    """(N,) f·|ΔO⊥|/(ρ − ΔO·d), where the new centre is nearer by the part of the step along the line of sight d."""


def free_way(scene: nf.Scene, start: Sequence[float], length: float) -> Array:
    """Way (N, 3) of a given length from a place: straight on until a wall, then in the freest direction, not back."""
    path, heading, remaining = [np.array(start, np.float64)], None, length
    while remaining > 0.1 and len(path) < 20:
        forward = np.column_stack([np.cos(_TURNS), np.zeros(len(_TURNS)), np.sin(_TURNS)])
        side = np.column_stack([-forward[:, 2], forward[:, 1], forward[:, 0]])
        free = np.min(
            [nf.cast_rays(scene, path[-1] + offset * side, forward).t_hit for offset in (-1.0, 0.0, 1.0)], axis=0
        )
        if heading is not None:
            free = np.where(forward @ heading < -0.5, 0.0, free)
        index = int(np.argmax(np.minimum(free, remaining + _MARGIN)))
        step = min(float(free[index]) - _MARGIN, remaining)
        if step <= 0.0:
            break
        path.append(path[-1] + step * forward[index])
        heading, remaining = forward[index], remaining - step
    return np.array(path)


def at_distance(path: Array, metres: float) -> tuple[Array, Array]:
    """Place on a path after some metres, and the direction of the way there."""
    steps = np.diff(path, axis=0)
    lengths = np.linalg.norm(steps, axis=1)
    starts = np.concatenate([[0.0], np.cumsum(lengths)])
    piece = min(int(np.searchsorted(starts, metres, side="right")) - 1, len(steps) - 1)
    return path[piece] + (metres - starts[piece]) / lengths[piece] * steps[piece], steps[piece] / lengths[piece]


def measure(old: nf.ReducedScene, new: nf.ReducedScene, position: Array, stride: int = 30) -> Change:
    """Find far points of the old pictures in the new ones, by their positions in the scene.

    The range of a map defines the scene point of a far pixel. Displacements are converted to pixels of the middle of a
    picture, whose focal length is `FOCAL`: f·tan of the angle between the two directions.
    """
    from scipy.spatial import cKDTree

    step = np.subtract(new.center, old.center)
    rows: list[Array] = []
    for ahead in np.array([(1, 0, 0), (0, 0, 1), (-1, 0, 0), (0, 0, -1)]):
        camera = nf.Camera.look_at(position, position + ahead, fov=FOV, size=SIZE)
        frames = [reduced.render(camera, channels=("position",), method="exact") for reduced in (old, new)]
        old_points, new_points = (frame.require("position").astype(np.float64) + frame.origin for frame in frames)
        rays = camera.rays()[1].reshape(-1, 3)
        points = old_points[stride // 2 :: stride, stride // 2 :: stride].reshape(-1, 3)
        numbers = np.arange(SIZE[0] * SIZE[1]).reshape(SIZE[1], SIZE[0])
        pixels = numbers[stride // 2 :: stride, stride // 2 :: stride].ravel()
        new_points = new_points.reshape(-1, 3)
        surface_pixels = np.flatnonzero(np.isfinite(new_points).all(axis=1))
        # Pixels without a surface are NaN, which compares as false.
        is_far = np.all([np.hypot(*(points - each.center)[:, (0, 2)].T) > each.r2 + 1.0 for each in (old, new)], axis=0)
        if not len(surface_pixels) or not is_far.any():
            continue
        errors, nearest = cKDTree(new_points[surface_pixels]).query(points[is_far])
        sight = points[is_far] - old.center
        reach = np.linalg.norm(sight, axis=1)
        # If the nearest point is farther away than a pixel is wide, this one is occluded in the new picture.
        is_visible = errors <= reach / FOCAL
        turned = np.linalg.norm(np.cross(rays[pixels[is_far]], rays[surface_pixels[nearest]]), axis=1)
        step_across = np.linalg.norm(np.cross(step, sight / reach[:, None]), axis=1)
        measured = FOCAL * np.tan(np.arcsin(turned))
        nearer = reach - sight @ step / reach
        predicted, exact = FOCAL * step_across / reach, FOCAL * step_across / nearer
        rows.append(np.column_stack([reach, measured, predicted, exact])[is_visible])
    return Change(float(np.linalg.norm(step)), *np.concatenate(rows or [np.empty((0, 4))]).T)


def draw(
    name: str, path: Array, regions: nf.Regions, changes: Sequence[Change], frames: Sequence[nf.Frame], file: Path
) -> None:
    """Draw a strip of frames, the centres along the way from above, and measured by predicted jumps."""
    figure, empty = subplots(figsize=(13.0, 7.6))
    empty.remove()
    upper, lower = figure.subfigures(2, 1, height_ratios=(1.0, 1.1))
    for axes, frame in zip(upper.subplots(2, 6).flat, frames, strict=False):
        axes.imshow(frame.to_image())
        stats = frame.stats
        fade = "" if stats["fade"] == 1.0 else f", fade {100 * stats['fade']:.0f} %"
        axes.set_title(f"region {stats['region']}{fade}", fontsize=9)
        axes.set(xticks=[], yticks=[])
    left, axes = lower.subplots(1, 2)
    _draw_map(left, path, regions)
    measured, predicted = (np.concatenate([getattr(c, field) for c in changes]) for field in ("measured", "predicted"))
    axes.plot(predicted, measured, ".", markersize=2, color="#c8102e", alpha=0.4, rasterized=True)
    maximum = float(predicted.max(initial=1.0))
    axes.plot([0.0, maximum], [0.0, maximum], color="0.3", linewidth=0.8)
    axes.set(xlabel="predicted jump f·|ΔO⊥|/ρ, px", ylabel="measured jump, px", title="far points at the changes")
    axes.grid(alpha=0.3)
    figure.suptitle(name)
    save_figure(figure, file, dpi=70, pil_kwargs={"quality": 82} if file.suffix == ".jpg" else None)


def _draw_map(axes: Any, path: Array, regions: nf.Regions) -> None:
    """Draw the way, the centres, and how far each region reaches."""
    from matplotlib.patches import Circle

    for number, (x, _, z) in enumerate(regions.centers):
        axes.add_patch(Circle((x, z), regions.reach, facecolor="#2a6f97", alpha=0.12, edgecolor="#2a6f97"))
        axes.annotate(str(number), (x, z), xytext=(3, 3), textcoords="offset points", fontsize=7)
    axes.plot(regions.centers[:, 0], regions.centers[:, 2], "o", color="#2a6f97", markersize=3)
    axes.plot(path[:, 0], path[:, 2], color="#c8102e")
    axes.set(aspect="equal", xlabel="x, m", ylabel="z, m", title="way, centres, and the reach of each region")
    axes.invert_yaxis()
    axes.grid(alpha=0.3)
