"""Trees as splats for other viewers: sizes and times, the width of Gaussians, and Spark's pictures against ours.

    python -m benchmarks.orthoview.export sizes|sigma|pictures STORE --level N --out FOLDER

STORE is a tree; `sigma` uses the cell of a level with the most splats, `pictures` the cells drawn by `tree.render`,
from the same cameras. Pictures need a browser and `npm ci --prefix tests/readers`.
"""

from __future__ import annotations

import argparse
import tempfile
from pathlib import Path
from typing import Any
from unittest import mock

import numpy as np
from numpy.typing import NDArray
from PIL import Image

import nearfar as nf
from benchmarks.harness.pictures import similarity
from benchmarks.harness.report import folder_or_temporary, start, table
from benchmarks.harness.timing import timed
from nearfar.orthoview import _gaussians, _spz
from nearfar.orthoview._splat_cells import Cells
from nearfar.orthoview._splat_export import sun_of
from tests.support.splat_pages import Look, spark

EVERYWHERE = np.array([[-np.inf] * 3, [np.inf] * 3])
SIGMAS = (0.4, 0.5, 0.55, 0.6, 0.7, 0.85)
SIZE = (480, 320)
VIEWS = 8
"""Greatest number of views of a cell that `tree.render` draws; exported splats are from all views."""
Array = NDArray[np.float64]


def main() -> None:
    options = start(
        __doc__,
        "--out",
        name={"choices": TABLES},
        store={"help": "a tree"},
        level=(2, "level of the cells"),
        error=(2.0, "error_px of the pictures"),
    )
    TABLES[options.name](nf.orthoview.open(options.store), options)


def sizes(tree: nf.orthoview.OrthoTree, options: argparse.Namespace) -> None:
    """Table of splats before and after thinning, bytes, and CPU seconds."""
    rows = []
    with folder_or_temporary() as folder:
        for name, compression in (("one.spz", None), ("one.glb", None), ("packed.glb", "spz")):
            counts, time = timed(tree.export_splats, folder / name, level=options.level, compression=compression)
            cells, pixels, splats = counts["cells"], counts["pixels"], counts["splats"]
            figures = pixels / cells, splats / cells, pixels / splats, counts["bytes"] / splats
            rows.append([name, cells, *figures, 1e6 * time.cpu / splats])
    held, views = tree.held, tree.held["chunks"] / 3
    print(f"the store: {held['bytes']:,} bytes, {held['bytes'] / views:,.0f} a view\n")
    header = "file | cells | pixels a cell {:,.0f} | splats a cell {:,.0f} | ratio {:.2f} | bytes a splat {:.1f}"
    print(table(f"{Path(tree.path).name}, level {options.level}", header + " | CPU s a million splats {:.1f}", rows))


def sigma(tree: nf.orthoview.OrthoTree, options: argparse.Namespace) -> None:
    """Compare one cell by Spark and by `tree.render`, for several widths of Gaussians."""
    cells = cells_of(tree)
    key = max(cells.cells_of_level(options.level), key=lambda cell: cells.read(*cell).pixels)
    box = tree.box(*key)
    x, y, z = box.mean(axis=0).tolist()
    side = box[1, 0] - box[0, 0]
    # A pixel of a view is about as wide as one of the picture.
    look = Look((x, y + 0.7 * side, z + 1.9 * side), (x, y - 0.4 * side, z), 30.0, (320, 240))
    ours = tree.render(look.camera, samples=16, geometry=False, clip=nf.Clip(box=box), channels=("color", "coverage"))
    rows, files = [], []
    with tempfile.TemporaryDirectory() as folder:
        for number, width in enumerate(SIGMAS):
            with mock.patch.object(_gaussians, "SIGMA", width):
                files.append(write_spz(cells.read(*key), Path(folder, f"{number}.spz")))
        _, pictures = spark(files, [(look, [number]) for number in range(len(SIGMAS))])
    cover = np.asarray(ours.coverage)
    for width, picture in zip(SIGMAS, pictures, strict=True):
        alpha = picture[..., 3]
        is_covered, grey = cover > 0.999, np.full((*cover.shape, 3), 0.5)
        picture_on_grey = np.where(is_covered[..., None], picture[..., :3] + (1 - alpha[..., None]) * 0.5, grey)
        reference = np.where(is_covered[..., None], ours.to_image() / 255.0, grey)
        shares = 100 * (alpha[is_covered] < 0.9).mean(), 100 * alpha[cover == 0].mean()
        rows.append([width, *similarity(reference, picture_on_grey), *shares])
    header = "σ, pixels {:g} | PSNR, dB {:.1f} | SSIM {:.3f} | surface with alpha < 0.9, % {:.1f}"
    header += " | mean alpha beside the surface, % {:.2f}"
    print(table(f"{Path(tree.path).name}, cell {key}", header, rows))


def pictures(tree: nf.orthoview.OrthoTree, options: argparse.Namespace) -> None:
    """Compare the cells of a cut by Spark, by `tree.render` and by rays."""
    scene = nf.Scene.load(Path(tree.path, "geometry", "tileset.json"))
    rows, sheet = [], []
    for name, look in looks(tree).items():
        camera = look.camera
        cut = tree.cut(camera, error_px=options.error, geometry=False)
        rows_of_cut = zip(cut.level.tolist(), cut.place.tolist(), cut.in_picture, strict=True)
        keys = [(level, tuple(place)) for level, place, is_in_picture in rows_of_cut if is_in_picture]
        ours = tree.render(camera, views=VIEWS, samples=16, geometry=False, error_px=options.error, channels=("color",))
        truth = nf.render(scene, camera, samples=16, channels=("color", "coverage"))
        rgba, count = by_spark(tree, look, keys)
        sky = tree.render(camera, t_max=1e-3, channels=("color",)).to_image() / 255.0
        spark_picture = rgba[..., :3] + (1 - rgba[..., 3:]) * sky
        reference = truth.to_image() / 255.0
        solid = np.asarray(truth.coverage) > 0.999
        tree_picture, holes = ours.to_image() / 255.0, (rgba[..., 3] < 0.5) & solid
        splats, hole_share = count / 1e6, 100 * holes.sum() / solid.sum()
        for program, count_of, pair, holes_of in (
            ("tree.render against rays", None, (reference, tree_picture), None),
            ("Spark against rays", splats, (reference, spark_picture), hole_share),
            ("Spark against tree.render", splats, (tree_picture, spark_picture), None),
        ):
            rows.append([name, program, len(keys), count_of, *similarity(*pair), holes_of])
        sheet.append(np.concatenate([tree_picture, spark_picture], axis=1))
    header = "camera | program | cells | million splats {:.2f} | PSNR, dB {:.1f} | SSIM {:.3f} | holes, % {:.2f}"
    print(table(f"{Path(tree.path).name}, error_px = {options.error:g}, {VIEWS} views, no geometry", header, rows))
    if options.out is not None:
        codes = np.rint(255 * np.concatenate(sheet).clip(0, 1)).astype(np.uint8)
        Image.fromarray(codes).quantize(128).save(options.out / "orthoview_splats.png", optimize=True)


def by_spark(tree: nf.orthoview.OrthoTree, look: Look, keys: list[tuple[int, tuple[int, ...]]]) -> tuple[Array, int]:
    """Spark's picture of some cells, and the number of their splats."""
    cells, count, files = cells_of(tree), 0, []
    with tempfile.TemporaryDirectory() as folder:
        for number, (level, (x, y, z)) in enumerate(keys):
            cell = cells.read(level, (x, y, z))
            files.append(write_spz(cell, Path(folder, f"{number}.spz")))
            count += len(cell.gaussians)
        _, (picture,) = spark(files, [(look, range(len(files)))])
    return picture, count


def write_spz(cell: Any, path: Path) -> tuple[Path, Any]:
    """Write the splats of a cell; return the file and the cell's centre."""
    path.write_bytes(_spz.encode(cell.gaussians))
    return path, cell.center


def cells_of(tree: nf.orthoview.OrthoTree) -> Cells:
    return Cells(tree._files, tree._layout, tree.generation, EVERYWHERE, sun_of("sun"))


def looks(tree: nf.orthoview.OrthoTree) -> dict[str, Look]:
    (x, low, z), (_, _, _), side = tree.bounds[0], tree.bounds[1], float(np.ptp(tree.bounds[:, 0]))
    middle = (x + side / 2, low, z + side / 2)
    return {
        "high": Look((x + 0.5 * side, low + 0.45 * side, z + 1.35 * side), middle, 40.0, SIZE),
        "low": Look((x + 0.25 * side, low + 0.15 * side, z + 1.4 * side), middle, 30.0, SIZE),
    }


TABLES = {each.__name__: each for each in (sizes, sigma, pictures)}

if __name__ == "__main__":
    main()
