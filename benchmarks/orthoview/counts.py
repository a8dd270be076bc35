"""Splats along a walk, and the effect of a continuous cut, a budget and a gaze on them.

The walk's counts are those of figure 10 of the paper: splats of the cut all around the viewer, splats that reach into
the picture, and splats that are not occluded. Leaves are splats at any distance.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any
from unittest import mock

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.report import save_figure, start, subplots, table
from benchmarks.harness.timing import best
from benchmarks.orthoview._leaves import DIRECTIONS
from benchmarks.orthoview.splats import FOV, HEIGHTS, SIZE, eye
from nearfar import _core
from nearfar._camera.shot import Shot
from nearfar.orthoview import _cut
from nearfar.orthoview._view import OrthoView

FRAMES, HEIGHT, SPEED = 200, 30.0, 15.0
"""Frames of the walk, its height in metres above the tree's lowest point, and metres per frame."""
NEAR = 5.0
"""Angle from the gaze that counts as near, degrees."""
STEPS = 40
"""Number of steps from an error to its double."""
BANDS = (0.05, 0.1, 0.25, 0.5)
BUDGETS = (400_000, 200_000, 100_000)
MAX_PIXELS_BEHIND = 4.0
"""Greatest distance of a child's splat behind the parent's surface, in the child's pixels, at which it belongs to
it."""
PITCH = 2**0.5 / 256
"""Width of a leaf's pixel in flat worlds, in leaves."""
HEADSET = nf.Fov.symmetric(100, 1.0), (1440, 1440)

Tree = nf.orthoview.OrthoTree


def main() -> None:
    options = start(__doc__, "tree", "--out", tables={"nargs": "*", "help": f"of {', '.join(TABLES)}; by default all"})
    tree = nf.orthoview.open(options.tree, cache_bytes=3 << 30)
    print(f"{_core.thread_count()} threads\n\n{tree}\n")
    for name in options.tables or TABLES:
        print(TABLES[name](tree, options.out), flush=True)


def path(tree: Tree, frames: int) -> Iterator[nf.Camera]:
    """Cameras of a walk past the middle of a tree, looking ahead and turning slowly."""
    low, high = tree.bounds
    middle = (low + high) / 2
    for frame in range(frames):
        metres_along = (frame - frames / 2) * SPEED
        place = np.array([middle[0] + metres_along, low[1] + HEIGHT, middle[2] + 0.3 * metres_along])
        turn = 0.6 * math.sin(2 * math.pi * frame / FRAMES)
        yield nf.Camera.look_at(place, place + np.array([math.cos(turn), -0.05, math.sin(turn)]), fov=FOV, size=SIZE)


def walk(tree: Tree, out: Path | None) -> str:
    counts = []
    for camera in path(tree, FRAMES):
        splats = tree._viewer.views.get(tree.cut(camera, geometry=False, around=True).keys())
        settings = Shot(cameras=(camera,), channels=("color",)).settings
        stats = _core.splat_orthoviews(splats, camera._core, settings, origin=(0.0, 0.0, 0.0), grid=1)["stats"]
        counts.append([stats[name] for name in ("splats", "splats_in_picture", "splats_seen")])
    table_of_counts = np.array(counts)
    if out is not None:
        save_counts(tree, table_of_counts, out / "orthoview_counts.png")
    rows = [
        [name, column.min(), np.median(column), column.max()]
        for name, column in zip(("in memory", "in the picture", "seen"), table_of_counts.T / 1e3, strict=True)
    ]
    return table(f"Thousand splats of {FRAMES} frames", "splats | least {:,.0f} | median {:,.0f} | most {:,.0f}", rows)


def flat_cells(side: int) -> _core.OrthoCells:
    """The cells of a flat world."""
    levels, subtree = side.bit_length(), 3
    cells = _core.OrthoCells((0.0, 0.0, 0.0), 1.0, levels, subtree)
    for tier in range(-(-levels // subtree)):
        lowest = tier * subtree
        count = -(-side // (1 << (lowest + subtree)))
        masks = []
        for level in range(lowest, min(lowest + subtree, levels)):
            cells_along = 1 << (subtree - level % subtree)
            mask = np.zeros((cells_along, cells_along, cells_along), np.uint32)
            shown_along = min(cells_along, max(side >> level, 1))
            mask[:shown_along, 0, :shown_along] = 511
            masks.append(mask.reshape(-1))
        for x in range(count):
            for z in range(count):
                cells.add(tier, (x, 0, z), masks)
    return cells


def flat_worlds() -> tuple[list[int], list[int]]:
    """Sides of flat worlds in leaves, and the number of cells of cuts in their middle."""
    sides, cells = [16, 32, 64, 128, 256, 512, 1024], []
    for side in sides:
        camera = nf.Camera((side / 2, 0.1, side / 2), fov=FOV, size=SIZE)
        rule = _core.OrthoRule(camera._core, pitch=PITCH, error=1.0)
        settings = {"directions": DIRECTIONS, "views": 3, "geometry": False, "around": True}
        arrays, *_ = flat_cells(side).cut(camera._core, rule, settings)
        cells.append(len(arrays["level"]))
    return sides, cells


def growth(tree: Tree, out: Path | None) -> str:
    rows = zip(*flat_worlds(), strict=True)
    return table("Cells of a cut around a viewer in a flat world", "leaves {}² | cells", rows)


def still(tree: Tree, out: Path | None) -> str:
    """Table of changes from picture to picture while the error of a static camera doubles."""
    errors = np.geomspace(1.0, 2.0, STEPS + 1)
    rows = []
    for height, band in itertools.product(HEIGHTS, (None, 0.1, _cut.BAND)):
        camera = eye(tree, height)
        with blending(band) as settings:
            pictures = (
                tree.render(camera, error_px=error, channels=("color",), **settings).to_image().astype(np.float64)
                for error in errors.tolist()
            )
            square = [((earlier - later) ** 2).mean() for earlier, later in itertools.pairwise(pictures)]
        changes = np.sqrt(square)
        rows.append([height, band or "–", changes.max(), np.median(changes), changes.mean()])
    title = f"RMS change of 8-bit pixel values from picture to picture, {STEPS} steps of the error from 1 to 2"
    return table(title, "height, tree widths {:g} | band | greatest {:.2f} | median {:.2f} | mean {:.2f}", rows)


@contextmanager
def blending(band: float | None) -> Iterator[dict[str, Any]]:
    """Yield settings of pictures whose levels blend in a band, or do not blend."""
    with mock.patch.object(_cut, "BAND", band or _cut.BAND):
        yield {"geometry": False, "continuous": band is not None}


def bands(tree: Tree, out: Path | None) -> str:
    rows = []
    for height, band in itertools.product(HEIGHTS, (None, *BANDS)):
        camera = eye(tree, height)
        with blending(band) as settings:
            stats = tree.render(camera, channels=("color",), **settings).stats
            timing = best(partial(tree.render, camera, channels=("color",), **settings), repeat=5)
        numbers = (stats[name] / 1e3 for name in ("splats", "splats_in_picture", "splats_seen"))
        rows.append([height, band or "–", stats["cells"], stats["views"], *numbers, timing.cpu_ms])
    header = "height, tree widths {:g} | band | cells | views | thousand splats {:,.0f} | in the picture {:,.0f}"
    return table("Continuous cuts", header + " | seen {:,.0f} | CPU ms {:.0f}", rows)


def gaze(tree: Tree, out: Path | None) -> str:
    """Table of splats saved by a gaze at the middle, and PSNR within 5° of it and beyond."""
    rows = []
    for height, (fov, size), error in itertools.product(HEIGHTS, ((FOV, SIZE), HEADSET), (1.0, 0.5)):
        camera = replace(eye(tree, height), fov=fov, size=size)
        draw = partial(tree.render, camera, geometry=False, channels=("color",), error_px=error)
        evenly, foveated = draw(), draw(gaze=(size[0] / 2, size[1] / 2))
        square = (evenly.to_image().astype(float) - foveated.to_image().astype(float)) ** 2
        is_near = degrees_from_middle(camera) < NEAR
        splats_evenly, splats_foveated = evenly.stats["splats"], foveated.stats["splats"]
        numbers = [error, splats_evenly / 1e3, splats_foveated / 1e3, 100 * (1 - splats_foveated / splats_evenly)]
        rows.append([height, size, *numbers, psnr(square[is_near]), psnr(square[~is_near])])
    header = "height, tree widths {:g} | picture {} × {} | error_px {:g} | thousand splats {:,.0f}"
    header += f" | with a gaze {{:,.0f}} | saved, % {{:.0f}} | PSNR within {NEAR:g}°, dB | beyond, dB"
    return table("A gaze at the middle", header, rows)


def degrees_from_middle(camera: nf.Camera) -> NDArray[np.float64]:
    """Angle of each pixel from the middle of a picture of an even size."""
    _, ahead = camera.rays()
    row, column = camera.height // 2, camera.width // 2
    sight = ahead[row - 1 : row + 1, column - 1 : column + 1].mean(axis=(0, 1))
    cosine = ahead @ sight / np.linalg.norm(ahead, axis=-1) / np.linalg.norm(sight)
    return np.asarray(np.degrees(np.arccos(np.clip(cosine, -1, 1))))


def psnr(square: NDArray[np.float64]) -> str:
    return "∞" if not square.any() else f"{10 * math.log10(255**2 / square.mean()):.1f}"


def budget(tree: Tree, out: Path | None) -> str:
    rows = []
    cameras = list(itertools.islice(path(tree, FRAMES), 0, None, 10))
    for continuous, limit in itertools.product((False, True), BUDGETS):
        settings = _cut.Settings(geometry=False, continuous=continuous, budget=limit)
        fits = [tree._viewer._fitter.fit(camera, settings) for camera in cameras]
        errors, splats = np.array([one.error_px for one in fits]), np.array([one.count for one in fits])
        timing = best(partial(tree._viewer._fitter.fit, cameras[0], settings), repeat=3)
        numbers = splats.max(), splats.mean(), (errors.min(), errors.max())
        rows.append(["yes" if continuous else "no", limit, *numbers, timing.cpu_ms])
    header = "continuous | budget {:,} | most splats {:,} | mean {:,.0f} | error_px {:.2f} to {:.2f}"
    return table(f"A budget, {len(cameras)} frames of the walk", header + " | CPU ms to choose {:.0f}", rows)


def swaps(tree: Tree, out: Path | None) -> str:
    """Table of distances between splats and the parent's splats that replace them."""
    rows = []
    for height in HEIGHTS:
        distances = swap_distances(tree, eye(tree, height))
        rows.append([height, len(distances), *np.quantile(distances, (0.5, 0.9, 0.99, 0.999, 1))])
    shares = (f"{name} {{:.2f}}" for name in ("median", "90 %", "99 %", "99.9 %", "most"))
    header = ["height, tree widths {:g}", "splats {:,}", *shares]
    return table("Pixels that splats move where levels change, error_px=1", header, rows)


def swap_distances(tree: Tree, camera: nf.Camera, error_px: float = 1.0) -> NDArray[np.float64]:
    """Distances in pixels between the middles of children's and their parents' splats, where the level changes.

    Parents are the cells of a cut, in the directions that are drawn. Children more than `MAX_PIXELS_BEHIND` behind
    their parent's surface do not belong to it and are not replaced.
    """
    cut, distances = tree.cut(camera, error_px=error_px, geometry=False), []
    keys = cut.keys()
    for level, place, number in keys:
        parent = tree.view(level, place, number) if level else None
        for octant in itertools.product((0, 1), repeat=3) if parent is not None else ():
            x, y, z = (2 * base + step for base, step in zip(place, octant, strict=True))
            is_inside = all(n < count for n, count in zip((x, y, z), tree.cells(level - 1), strict=True))
            child = tree.view(level - 1, (x, y, z), number) if is_inside else None
            if child is not None and parent is not None:
                distances.append(splat_distances(camera, parent, child, 2**level * cut.reach))
    return np.concatenate(distances)


def splat_distances(
    camera: nf.Camera, parent: OrthoView, child: OrthoView, swap_distance: float
) -> NDArray[np.float64]:
    """Distances in pixels between a child's splats in the picture and its parent's, from `swap_distance` metres."""
    points = child.points()[np.isfinite(child.depth)]
    size, offset = len(parent.depth), points - parent.center
    column = np.floor((offset @ parent.right / parent.extents[0] + 0.5) * size).astype(int)
    row = np.floor((0.5 - offset @ parent.up / parent.extents[1]) * size).astype(int)
    is_inside = (column >= 0) & (column < size) & (row >= 0) & (row < size)
    points, parent_points = points[is_inside], parent.points()[row[is_inside], column[is_inside]]
    behind = (parent_points - points) @ parent.toward
    is_replaced = behind <= MAX_PIXELS_BEHIND * max(parent.extents[:2]) / (2 * size)
    points, parent_points = points[is_replaced], parent_points[is_replaced]
    child_pixels, parent_pixels = camera.project(points)[:, :2], camera.project(parent_points)[:, :2]
    distance = np.linalg.norm(points - np.array(camera.position), axis=1)
    pixels = np.linalg.norm(child_pixels - parent_pixels, axis=1) * distance / swap_distance
    width, height = camera.size
    is_visible = ((child_pixels >= 0) & (child_pixels < (width, height))).all(axis=1) & np.isfinite(pixels)
    return np.asarray(pixels[is_visible])


def save_counts(tree: Tree, counts: NDArray[Any], file: Path) -> None:
    """Plot the three counts of each frame, and cells against distance and against the world's size."""
    figure, (left, right) = subplots(1, 2, figsize=(10, 3.8), width_ratios=(3, 2))
    left.plot(counts, label=["in memory: the cut all around", "in the picture", "seen: not hidden"])
    left.set(yscale="log", ylim=(counts.min() / 2, counts.max() * 8), xlabel="frame of the walk", ylabel="splats")
    left.legend(loc="upper right")
    middle = next(itertools.islice(path(tree, FRAMES), FRAMES // 2, None))
    distance = np.sort(tree.cut(middle, geometry=False, around=True).distance)
    cells = np.arange(1, len(distance) + 1)
    right.step(distance[distance > 0] / 1e3, cells[distance > 0], where="post", label="Tokyo: within this distance, km")
    right.plot(*flat_worlds(), "o-", label="flat worlds of this width, leaves")
    right.set(xscale="log", xlabel="distance or width", ylabel="cells of the cut")
    right.legend(loc="upper left")
    left.grid(alpha=0.3)
    right.grid(alpha=0.3)
    save_figure(figure, file, dpi=90)


TABLES = {each.__name__: each for each in (walk, growth, still, bands, gaze, budget, swaps)}


if __name__ == "__main__":
    main()
