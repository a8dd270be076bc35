"""Renderings of orthoview octrees against ray-traced truth: losses by the numbers of directions and views.

    python -m benchmarks.orthoview.pictures sets sheet wide --tiles FOLDER --out FOLDER

Octrees of 26 directions are built once and stored in --trees; octrees of fewer directions use the first of these. A
cell has a view from each direction; only those nearest to the viewer's direction are drawn. The table gives the mean of
two places on the ground and of two in the air. Without --tiles, Tokyo is another part of the city, its core, which is
in one file.
"""

from __future__ import annotations

import itertools
import sys
from collections.abc import Iterator
from dataclasses import astuple, replace
from pathlib import Path

import numpy as np

import nearfar as nf
from benchmarks.harness.report import folder_or_temporary, start, table
from benchmarks.orthoview import _sheets
from benchmarks.orthoview._quality import Truth, compare, mean, render
from benchmarks.orthoview._worlds import ALL, PICTURE, SIZE, World, forest, landscape, open_tree, tokyo

DIRECTION_COUNTS = (5, 9, 13, 26)
"""Numbers of directions of an octree."""
VIEWS = (2, 3, 5)
"""Numbers of views that are drawn for each cell."""
DIRECTIONS = 9
"""Number of directions in the drawn pictures."""
WORLDS = ("Tokyo", "forest", "landscape")
QUALITY = (
    "PSNR, dB {:.1f} | SSIM {:.3f} | holes, % {:.2f} | holes off edges, % {:.2f} | too far, % {:.2f}"
    " | too far off edges, % {:.2f} | too near, % {:.2f} | surface instead of sky, % {:.2f} | leaves {:.0f}"
)
"""Columns of a `Quality`."""


def main() -> None:
    options = start(
        __doc__,
        "--tiles",
        "--trees",
        "--out",
        tables={"nargs": "*", "help": f"of {', '.join(TABLES)}; by default all"},
        worlds=(["Tokyo", "forest"], f"of {', '.join(WORLDS)}"),
    )
    worlds = [world for world in (tokyo(options.tiles), forest(), landscape()) if world.name in options.worlds]
    print(f"pictures of {PICTURE[0]} × {PICTURE[1]} pixels, views of {SIZE}²\n")
    with folder_or_temporary(options.trees) as folder:
        for name in options.tables or TABLES:
            TABLES[name](worlds, folder, options.out)


def places(world: World) -> Iterator[tuple[str, list[nf.Camera]]]:
    yield f"{world.name}, ground", world.from_ground()
    yield f"{world.name}, air", world.from_air()


def by_sets(worlds: list[World], trees: Path, out: Path | None) -> None:
    rows = []
    for world in worlds:
        path = world.build(trees)
        trees_by_count = {count: open_tree(path, count) for count in DIRECTION_COUNTS}
        for place, cameras in places(world):
            true_pictures = [Truth(world, camera, trees_by_count[ALL].bounds) for camera in cameras]
            for count, views in itertools.product(DIRECTION_COUNTS, VIEWS):
                quality = mean([compare(truth, trees_by_count[count], views) for truth in true_pictures])
                rows.append([place, count, views, *astuple(quality)])
                print(rows[-1], file=sys.stderr, flush=True)
    print(table("Directions and views", f"place | directions | views | {QUALITY}", rows))


def sheet(worlds: list[World], trees: Path, out: Path | None) -> None:
    """Draw the truth and 2, 3, 5 views with their errors, from the ground and from the air."""
    if out is None:
        return
    rows = []
    for world in worlds:
        tree = open_tree(world.build(trees), DIRECTIONS)
        for name, cameras in places(world):
            camera = replace(cameras[0], size=_sheets.PICTURE_SIZE)
            rows.append((name, Truth(world, camera, tree.bounds), [render(tree, camera, views) for views in VIEWS]))
    name = "pictures" if len(worlds) > 1 else worlds[0].name
    _sheets.save_sheet(rows, [f"{views} of {DIRECTIONS} views" for views in VIEWS], out / f"orthoview_{name}.png")


def wide(worlds: list[World], trees: Path, out: Path | None) -> None:
    """Draw Tokyo from the air: the truth on the left, orthoviews on the right."""
    if out is None:
        return
    world = worlds[0]
    tree = open_tree(world.build(trees), DIRECTIONS)
    eye_and_target = world.box[0] + world.side * np.array([(0.5, 0.28, -0.22), (0.5, 0.0, 0.5)])
    fov = nf.Fov.symmetric(60, _sheets.WIDE[0] / _sheets.WIDE[1])
    camera = nf.Camera.look_at(*eye_and_target, fov=fov, size=_sheets.WIDE)
    truth = Truth(world, camera, tree.bounds)
    _sheets.save_halves(truth.color.to_image(), render(tree, camera).to_image(), out / "orthoview_tokyo.png")


TABLES = {"sets": by_sets, "sheet": sheet, "wide": wide}


if __name__ == "__main__":
    main()
