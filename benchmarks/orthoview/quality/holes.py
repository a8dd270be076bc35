"""Holes in pictures of Tokyo from the air: their places, their causes, and their number with other choices of views.

A hole is a pixel that shows nothing where the truth shows a surface. Its cause is found by searching for the surface in
the views of the cell that contains it.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.pictures import similarity
from benchmarks.harness.report import folder_or_temporary, start, table
from benchmarks.orthoview import _sheets
from benchmarks.orthoview._quality import SAMPLES, Truth, shown_by
from benchmarks.orthoview._worlds import World, forest, landscape, open_tree, tokyo
from nearfar._camera.shot import Shot
from nearfar.orthoview._cut import MAX_VIEWS, OrthoCut
from nearfar.orthoview._grid import Place
from nearfar.orthoview._viewer import Parts

VIEWS, DIRECTIONS = 3, 9
PLACES = 12
"""Number of random places in the air."""
CAUSES = {
    "no direction of 26": (120, 0, 140),
    "no direction of 9": (220, 40, 40),
    "a view that is not drawn": (255, 150, 0),
    "a view that is drawn": (30, 90, 230),
    "geometry, or no cell": (0, 150, 80),
}
"""Causes of holes by the views that show the surface, and their colours."""
SURFACES = ("walls", "roofs", "ground")
MIN_ROOF_UP = 0.7
"""Least upward component of a roof's normal."""
NUDGE = 0.01
"""Metres by which points move towards the viewer, so that a point on the face of two cells lies in the nearer cell."""

Bools = NDArray[np.bool_]
Choice = Callable[[nf.orthoview.OrthoTree, nf.Camera], OrthoCut]
"""Function that chooses the cut for a picture."""


def main() -> None:
    options = start(__doc__, "--tiles", "--trees", "--out", worlds=(["Tokyo", "forest", "landscape"], "of the choices"))
    city = tokyo(options.tiles)
    with folder_or_temporary(options.trees) as trees:
        print(causes_table(city, trees, options.out))
        title = f"Tokyo from {PLACES} random places, {VIEWS} views"
        header = "directions | raised by {}° | holes, % {:.2f} | at most {:.2f}"
        print(table(title, header, random_place_rows(city, trees)))
        worlds = [world for world in (city, forest(), landscape()) if world.name in options.worlds]
        rows = [row for world in worlds for row in choice_rows(world, trees)]
    header = "place | views | thousand splats {:.0f} | holes, % {:.2f} | PSNR, dB {:.1f} | SSIM {:.3f}"
    print(table("Choices of views", header, rows))


def causes_table(city: World, trees: Path, out: Path | None) -> str:
    """Table of holes by cause and surface, and a picture of them."""
    tree, tree_of_26 = (open_tree(city.build(trees), count) for count in (DIRECTIONS, 26))
    counts = np.zeros((len(CAUSES), len(SURFACES)))
    surfaces, panels = 0, []
    for number, camera in enumerate(city.from_air()):
        channels = ("color", "range", "position", "normal")
        truth = nf.render(city.scene, camera, clip=nf.Clip(box=tree.bounds), channels=channels)
        cause, kind = causes(tree, tree_of_26, truth, render_choice(tree, camera, raise_direction(0)))
        surfaces += int(np.isfinite(truth.require("range")).sum())
        for n in range(len(CAUSES)):
            counts[n] += [((cause == n) & (kind == k)).sum() for k in range(len(SURFACES))]
        picture = (128 + truth.to_image() // 2).astype(np.uint8)
        for n, color in enumerate(CAUSES.values()):
            picture[cause == n] = color
        panels.append((f"Tokyo, from the air {number + 1}", picture))
    if out is not None:
        _sheets.save_panels(panels, 2, out / "orthoview_holes.png")
    shares = 100 * np.vstack([counts, counts.sum(axis=0)]) / surfaces
    rows = [[name, *row, row.sum()] for name, row in zip((*CAUSES, "all"), shares, strict=True)]
    header = ["shown by", *(f"{name} {{:.2f}}" for name in (*SURFACES, "all"))]
    return table("Holes, % of surfaces, by what shows them", header, rows)


def render_choice(tree: nf.orthoview.OrthoTree, camera: nf.Camera, choose: Choice, samples: int = 1) -> nf.Frame:
    """Draw a tree from the views of a choice."""
    viewer, cut = tree._viewer, choose(tree, camera)
    keys = cut.keys()
    near_leaves = viewer.near.scene(viewer.cutter.with_guests(cut.leaf_places()))
    parts = Parts(viewer.views.get(keys), near_leaves, None, {"views": len(keys)})
    channels = ("color", "range") if samples == 1 else ("color",)
    images = viewer.picture(camera, Shot(cameras=(camera,), channels=channels, samples=samples), parts)
    return nf.Frame(camera, **images)


def causes(
    tree: nf.orthoview.OrthoTree, tree_of_26: nf.orthoview.OrthoTree, truth: nf.Frame, frame: nf.Frame
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Numbers (H, W) of the causes of holes, −1 elsewhere, and of surfaces."""
    camera = frame.camera
    holes = np.isfinite(truth.require("range")) & ~np.isfinite(frame.require("range"))
    points = truth.require("position")[holes] + np.array(truth.origin)
    toward = np.array(camera.position) - points
    points += NUDGE * toward / np.linalg.norm(toward, axis=1, keepdims=True)
    grid, cut = tree._viewer.cutter.grid, tree.cut(camera, views=VIEWS)
    causes_of_holes = np.full(len(points), list(CAUSES).index("geometry, or no cell"))
    places: Iterator[Place] = map(tuple, cut.place.tolist())
    for level, place, directions in zip(cut.level.tolist(), places, cut.directions.tolist(), strict=True):
        low, high = grid.box(level, place)
        indices = np.flatnonzero(((points >= low) & (points < high)).all(axis=1))
        if not len(indices):
            continue
        cause = np.zeros(len(indices), int)
        for direction, steps in enumerate(tree_of_26.directions):
            view = tree_of_26.view(level, place, direction)
            if view is not None:
                rank = 3 if direction in directions else 2 if steps in tree.directions else 1
                axes = np.stack([view.right, view.up, view.toward])
                is_shown = shown_by(points[indices], axes, view.extents, view.center, view.depth)
                cause[is_shown] = np.maximum(cause[is_shown], rank)
        causes_of_holes[indices] = cause
    numbers = np.full(holes.shape, -1)
    numbers[holes] = causes_of_holes
    up = truth.require("normal")[..., 1]
    is_ground = truth.require("position")[..., 1] + truth.origin[1] < 0
    return numbers, np.where(is_ground, 2, np.where(np.nan_to_num(up) > MIN_ROOF_UP, 1, 0))


def raise_direction(degrees: float, views: int = VIEWS) -> Choice:
    """Return the choice of the views nearest to the viewer's direction, raised by an angle."""
    return lambda tree, camera: tree.cut(camera, views=views, lift_deg=degrees)


def with_top(tree: nf.orthoview.OrthoTree, camera: nf.Camera) -> OrthoCut:
    """Choose the two nearest views, and that from above."""
    cut = tree.cut(camera, views=MAX_VIEWS)
    top = tree.directions.index((0, 1, 0))
    rows = []
    for row in cut.directions.tolist():
        others = [direction for direction in row if direction != top]
        rows.append([*others[: VIEWS - 1], top] if top in row else others[:VIEWS])
    return replace(cut, directions=np.array(rows, np.int8))


def choice_rows(world: World, trees: Path) -> list[list[object]]:
    tree = open_tree(world.build(trees), DIRECTIONS)
    rows: list[list[object]] = []
    for place, cameras in (("air", world.from_air()), ("ground", world.from_ground())):
        truths = [Truth(world, camera, tree.bounds) for camera in cameras]
        for name, choose in CHOICES.items():
            mean_quality = np.mean([measure(tree, truth, choose) for truth in truths], axis=0)
            rows.append([f"{world.name}, {place}", name, *mean_quality])
            print(rows[-1], file=sys.stderr, flush=True)
    return rows


CHOICES: dict[str, Choice] = {
    "3 nearest": raise_direction(0),
    **{f"3 nearest to {angle}° higher": raise_direction(angle) for angle in (10, 20, 30, 45)},
    "2 nearest, and the top": with_top,
    **{f"{views} nearest": raise_direction(0, views) for views in (4, 5, MAX_VIEWS)},
}


def random_place_rows(world: World, trees: Path) -> list[list[float]]:
    """Rows of holes from random places in the air, by number of directions and by the angle of `raise_direction`."""
    rng = np.random.default_rng(0)
    eyes, targets = (rng.uniform(0, 1, (PLACES, 3)) for _ in range(2))
    low = world.box[0]
    eyes = low + eyes * [world.side, 300.0, world.side] + [0.0, 0.3 * world.height, 0.0]
    targets = low + targets * [world.side, 0.0, world.side]
    cameras = [world.camera(eye, target) for eye, target in zip(eyes, targets, strict=True)]
    rows: list[list[float]] = []
    for directions in (DIRECTIONS, 13):
        tree = open_tree(world.build(trees), directions)
        truths = [Truth(world, camera, tree.bounds) for camera in cameras]
        for angle in (0, 20, 30, 45):
            shares = []
            for truth in truths:
                ranges = render_choice(tree, truth.camera, raise_direction(angle)).require("range")
                is_surface = np.isfinite(truth.range)
                shares.append(100 * float((is_surface & ~np.isfinite(ranges)).sum() / max(is_surface.sum(), 1)))
            rows.append([directions, angle, float(np.mean(shares)), max(shares)])
            print(rows[-1], file=sys.stderr, flush=True)
    return rows


def measure(tree: nf.orthoview.OrthoTree, truth: Truth, choose: Choice) -> list[float]:
    """Thousands of splats in the picture, holes in percent of the surfaces, PSNR and SSIM."""
    frame = render_choice(tree, truth.camera, choose)
    is_surface = np.isfinite(truth.range)
    holes = 100 * float((is_surface & ~np.isfinite(frame.require("range"))).sum() / is_surface.sum())
    picture = render_choice(tree, truth.camera, choose, SAMPLES).to_image()
    return [frame.stats["splats_in_picture"] / 1e3, holes, *similarity(truth.color.to_image(), picture)]


if __name__ == "__main__":
    main()
