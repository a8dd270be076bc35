"""Pictures of trees against ray-traced truth: losses by directions, views, error, geometry and layers.

    python -m benchmarks.orthoview.pictures sets cuts errors geometry layers sheet wide --tiles FOLDER --out FOLDER

Trees of 26 directions are built once and stored in --trees; those of fewer directions are their first views. Each
table gives the mean of two places on the ground and of two in the air. Without --tiles, Tokyo is another part, its
core, which is in one file.
"""

from __future__ import annotations

import itertools
import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness.report import folder_or_temporary, start, table
from benchmarks.orthoview import _sheets
from benchmarks.orthoview._quality import Quality, Setting, Truth, compare, mean
from benchmarks.orthoview._worlds import ALL, PICTURE, SIZE, World, forest, landscape, open_tree, tokyo
from nearfar.orthoview._grid import directions_of, widest

SETS = (5, 9, 13, 26)
VIEWS = (2, 3, 5)
ERRORS = (0.5, 1.0, 2.0, 4.0)
DIRECTIONS = 9
"""Number of directions in tables that do not vary it."""
PARTS = {"Tokyo": 500.0, "forest": 40.0, "landscape": 250.0}
"""Worlds, and sides of the parts with second layers, which take longer to build."""
QUALITY = (
    "PSNR, dB {:.1f} | SSIM {:.3f} | holes, % {:.2f} | within surfaces, % {:.2f} | too far, % {:.2f}"
    " | beyond edges, % {:.2f} | too near, % {:.2f} | false, % {:.2f}"
)
"""Columns of `cells`."""
AMOUNTS = "MB read {:.2f} | of geometry {:.2f} | thousand splats {:.0f}"
"""Columns of `amounts`."""


def main() -> None:
    given = start(
        __doc__,
        "--tiles",
        "--trees",
        "--out",
        tables={"nargs": "*", "help": f"of {', '.join(TABLES)}; by default all"},
        worlds=(["Tokyo", "forest"], f"of {', '.join(PARTS)}"),
    )
    worlds = [world for world in (tokyo(given.tiles), forest(), landscape()) if world.name in given.worlds]
    print(f"pictures of {PICTURE[0]} × {PICTURE[1]} pixels, views of {SIZE}²\n")
    with folder_or_temporary(given.trees) as folder:
        for name in given.tables or TABLES:
            TABLES[name](worlds, folder, given.out)


def places(world: World) -> Iterator[tuple[str, list[nf.Camera]]]:
    """Yield cameras of a world by their location."""
    yield f"{world.name}, ground", world.from_ground()
    yield f"{world.name}, air", world.from_air()


def truths(world: World, cameras: list[nf.Camera], tree: nf.orthoview.OrthoTree) -> list[Truth]:
    return [Truth(world, camera, tree.bounds) for camera in cameras]


def by_sets(worlds: list[World], trees: Path, out: Path | None) -> None:
    """Table of sets of directions and numbers of views."""
    rows = []
    for world in worlds:
        path = world.build(trees)
        trees_by_count = {count: open_tree(path, count) for count in SETS}
        for place, cameras in places(world):
            true_pictures = truths(world, cameras, trees_by_count[ALL])
            for count, views in itertools.product(SETS, VIEWS):
                quality = mean([compare(truth, trees_by_count[count], Setting(views)) for truth in true_pictures])
                rows.append(print_row([place, count, views, *cells(quality), quality.leaves]))
    print(table("Directions and views", f"place | directions | views | {QUALITY} | leaves {{:.0f}}", rows))


def by_cuts(worlds: list[World], trees: Path, out: Path | None) -> None:
    """Table of sets of directions with equal cuts: sets whose widest view is wider are allowed as much more error."""
    rows = []
    for world in worlds:
        path = world.build(trees)
        for (place, cameras), count in itertools.product(places(world), SETS):
            tree = open_tree(path, count)
            setting = Setting(error_px=widest(tree.directions) / widest(directions_of(DIRECTIONS)), geometry=False)
            quality = mean([compare(truth, tree, setting) for truth in truths(world, cameras, tree)])
            rows.append(print_row([place, count, *amounts(quality), *cells(quality)]))
    title = "Directions with equal cuts, 3 views, no geometry"
    print(table(title, f"place | directions | {AMOUNTS} | {QUALITY}", rows))


def by_errors(worlds: list[World], trees: Path, out: Path | None) -> None:
    """Table of allowed errors."""
    rows = []
    lines: dict[str, list[Quality]] = {}
    for world in worlds:
        tree = open_tree(world.build(trees), DIRECTIONS)
        for place, cameras in places(world):
            true_pictures = truths(world, cameras, tree)
            for error in ERRORS:
                quality = mean([compare(truth, tree, Setting(error_px=error)) for truth in true_pictures])
                lines.setdefault(place, []).append(quality)
                rows.append(print_row([place, error, *amounts(quality), *cells(quality)]))
    print(table(f"Error, 3 of {DIRECTIONS} views", f"place | error_px {{:g}} | {AMOUNTS} | {QUALITY}", rows))
    if out is not None:
        _sheets.plot_errors(lines, ERRORS, out / "orthoview_errors.png")


def by_geometry(worlds: list[World], trees: Path, out: Path | None) -> None:
    """Table of near leaves with and without geometry."""
    rows = []
    for world in worlds:
        tree = open_tree(world.build(trees), DIRECTIONS)
        for (place, cameras), geometry in itertools.product(places(world), (True, False)):
            setting = Setting(geometry=geometry)
            quality = mean([compare(truth, tree, setting) for truth in truths(world, cameras, tree)])
            rows.append(print_row([place, "on" if geometry else "off", *amounts(quality), *cells(quality)]))
    print(table(f"Geometry, 3 of {DIRECTIONS} views", f"place | geometry | {AMOUNTS} | {QUALITY}", rows))


def by_layers(worlds: list[World], trees: Path, out: Path | None) -> None:
    """Table of one and two layers, without geometry."""
    rows = []
    for world in worlds:
        part = world.part(PARTS[world.name])
        path = part.build(trees, DIRECTIONS, layers=2)
        for (place, cameras), views, layers in itertools.product(places(part), VIEWS, (1, 2)):
            tree = open_tree(path, DIRECTIONS, layers)
            setting = Setting(views, geometry=False)
            quality = mean([compare(truth, tree, setting) for truth in truths(part, cameras, tree)])
            rows.append(print_row([place, views, layers, *amounts(quality), *cells(quality)]))
    header = f"place | views | layers | {AMOUNTS} | {QUALITY}"
    print(table(f"Layers, {DIRECTIONS} directions, no geometry", header, rows))


def print_row(row: list[object]) -> list[object]:
    """Print a row, because the whole table takes long."""
    print(row, file=sys.stderr, flush=True)
    return row


def sheet(worlds: list[World], trees: Path, out: Path | None) -> None:
    """Draw the truth and 2, 3, 5 views with their errors, from the ground and from the air."""
    if out is None:
        return
    rows: list[list[Any]] = []
    for world in worlds:
        tree = open_tree(world.build(trees), DIRECTIONS)
        for name, cameras in places(world):
            camera = replace(cameras[0], size=_sheets.SMALL)
            truth = Truth(world, camera, tree.bounds)
            rows.append([name, truth, [Setting(views).render(tree, camera) for views in VIEWS]])
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
    _sheets.save_halves(truth.color.to_image(), Setting().render(tree, camera).to_image(), out / "orthoview_tokyo.png")


def amounts(quality: Quality) -> list[float]:
    """Bytes read, and the number of splats drawn."""
    return [quality.read / 1e6, quality.geometry / 1e6, quality.splats / 1e3]


def cells(quality: Quality) -> list[float]:
    """Similarity, and shares of wrong pixels in per cent."""
    names = ("holes", "inner_holes", "through", "inner_through", "before", "false")
    return [quality.psnr, quality.ssim, *(100 * getattr(quality, name) for name in names)]


TABLES = {
    "sets": by_sets,
    "cuts": by_cuts,
    "errors": by_errors,
    "geometry": by_geometry,
    "layers": by_layers,
    "sheet": sheet,
    "wide": wide,
}


if __name__ == "__main__":
    main()
