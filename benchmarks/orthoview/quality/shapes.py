"""Shapes of splats compared: a tree in front of a wall, drawn from 70° beside the direction of their view.

    python -m benchmarks.orthoview.quality.shapes --out FOLDER                   # one view of a cell of 10 m

Surfaces that the view does not show are ignored: shares are relative to the samples whose surface the view shows; PSNR
and SSIM include pixels if all of their samples show such surfaces or the sky.
"""

from __future__ import annotations

import itertools
import sys
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any
from unittest import mock

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.pictures import Picture, average, blocks, encode
from benchmarks.harness.report import start, table
from benchmarks.orthoview import _sheets, _splats
from benchmarks.orthoview._leaves import Leaf, axes_of, layout_of, metres_of
from benchmarks.orthoview._quality import Truth as TreeTruth, compare, mean, shown_by
from benchmarks.orthoview._worlds import World, forest, landscape, open_tree, tokyo
from benchmarks.orthoview.quality import _shapes
from nearfar import _core
from nearfar._camera.shot import Shot
from nearfar._scene.srgb import to_linear
from nearfar.datasets import _vegetation as vegetation
from nearfar.datasets._palette import material, materials
from nearfar.datasets._shapes import quads
from nearfar.datasets._stage import Stage
from nearfar.orthoview import _codec
from nearfar.orthoview._codec import CONNECTION_LIMITS
from nearfar.orthoview._layout import Layout

SIDE = 10.0
"""Side of the cell, metres."""
TURN = 70.0
"""Angle in degrees between the view's direction and the picture's."""
SIZE = (300, 264)
GRID = 4
"""Samples along each axis of a pixel."""
MIN_GAP = 0.25
"""Two surfaces differ if their depths differ by more than this, metres."""
FRONT = (0, 0, 1)

Bools = NDArray[np.bool_]
Floats = NDArray[np.float64]
Shape = Callable[[_splats.Pixels, nf.Camera], _shapes.Sides]


def main() -> None:
    options = start(__doc__, "--out", "--tiles", "--trees")
    if options.trees is not None:
        print(tree_table([tokyo(options.tiles), forest(), landscape()], options.trees))
        return
    leaf, layout = tree_and_wall(), layout_of()
    views, number = leaf.views(layout), layout.directions.index(FRONT)
    truth = Truth.trace(leaf, camera(leaf, layout), views, layout, number)
    pixels = _splats.pixels(leaf, views, layout, number)
    rows, panels = [], [(f"truth\nfrom {TURN:g}° beside the view", truth.picture)]
    for name, shape in shapes(views, number).items():
        color, depth = _shapes.rasterize(pixels, shape(pixels, truth.fine), truth.fine)
        measures = truth.measure(color, depth)
        rows.append([name, *measures.cells()])
        panels.append((f"{name}\n{measures.psnr:.1f} dB, {measures.holes:.1f} % holes", measures.picture))
    print(table(f"{len(pixels.middle):,} splats", f"shape | {HEADER.replace('%', '% {:.1f}')}", rows))
    kernel = truth.measure(*kernel_picture(leaf, views, number, truth.fine))
    ours = truth.measure(*_shapes.rasterize(pixels, shapes(views, number)["ours"](pixels, truth.fine), truth.fine))
    print(f"ours, by the kernel of tree.render: {', '.join(f'{value:.3g}' for value in kernel.cells())}")
    print(f"both pictures of ours: {nf.psnr(kernel.picture, ours.picture, data_range=255):.1f} dB\n")
    if options.out is not None:
        _sheets.save_panels(panels, 3, options.out / "orthoview_shapes.png", scale=2)


def tree_table(worlds: list[World], trees: Path) -> str:
    """Compare `tree.render` from the air with pictures in which all splats are surfels and borders are not enlarged."""
    rows = []
    for world in worlds:
        path = world.build(trees)
        truths = [TreeTruth(world, camera, nf.orthoview.open(path).bounds) for camera in world.from_air()]
        for views, (name, decoded) in itertools.product((1, 3), {"ours": _codec.decode, "ellipses": _surfels}.items()):
            # A newly opened tree has no decoded views.
            tree = open_tree(path, len(layout_of().directions))
            with mock.patch.object(_codec, "decode", decoded):
                quality = mean([compare(truth, tree, views) for truth in truths])
            shares = quality.holes, quality.through, quality.before, quality.false
            rows.append([f"{world.name}, air", views, name, quality.psnr, quality.ssim, *shares])
            print(rows[-1], file=sys.stderr, flush=True)
    return table("Pictures of trees", f"place | views | splats | {HEADER.replace('%', '% {:.2f}')}", rows)


def _surfels(*arguments: Any, decoded: Callable[..., Any] = _codec.decode) -> Any:
    """Decode views with all pixels connected."""
    return [(views, np.full_like(bits, 15)) for views, bits in decoded(*arguments)]


def tree_and_wall() -> Leaf:
    """Make a broadleaf tree in front of a brick wall, on a lawn."""
    stage, low = Stage(), np.array([-SIDE / 2, 0.0, -SIDE / 2])
    stage.once(vegetation.broadleaf(3, 4, 3), "tree")
    # The wall's squares have two materials in turn.
    bricks = np.array(materials("brick_red", "stone_pale"), np.int32)[np.indices((18, 24)).sum(axis=0).ravel() % 2]
    stage.once(quads(wall(np.array([-4.8, 0.0, -3.0]), (24, 18), (0.4, 0.4)), bricks), "wall")
    corners = np.array([[[-4.9, 0.05, 4.9], [4.9, 0.05, 4.9], [4.9, 0.05, -4.9], [-4.9, 0.05, -4.9]]])
    stage.once(quads(corners, material("lawn")), "ground")
    x, y, z = low.tolist()
    return Leaf("tree before a wall", stage.build(), (x, y, z), SIDE)


def wall(low: Floats, count: tuple[int, int], side: tuple[float, float]) -> Floats:
    """Corners (N, 4, 3) of the squares of a wall that faces the viewer."""
    y, x = (axis.ravel() for axis in np.indices(count[::-1]))
    flat = (np.stack([x, y], axis=1)[:, None] + np.array([(0, 0), (1, 0), (1, 1), (0, 1)])) * side
    return np.asarray(low + np.concatenate([flat, np.zeros((*flat.shape[:2], 1))], axis=2))


def camera(leaf: Leaf, layout: Layout) -> nf.Camera:
    """Camera beside the view's direction, for which a pixel of the view is as wide as one of the picture."""
    turn, fov = np.radians(TURN), nf.Fov.symmetric(24, SIZE[0] / SIZE[1])
    distance = leaf.side / layout.size / (2 * fov.right / SIZE[0])
    middle = leaf.box.mean(axis=0)
    eye = middle + distance * np.array([np.sin(turn), 0.0, np.cos(turn)])
    return nf.Camera.look_at(eye, middle, fov=fov, size=SIZE)


def shapes(views: _core.OrthoViews, number: int) -> dict[str, Shape]:
    depth, slope, _ = CONNECTION_LIMITS
    shapes_by_name: dict[str, Shape] = {
        "circle": _shapes.circle,
        "warped circle": _shapes.warped_circle,
        "ellipse": _shapes.ellipse,
    }
    for name, bounds in (("ours, no test of sphericity", (depth, slope, -1.0)), ("ours", CONNECTION_LIMITS)):
        bits = views.connected(bounds)
        is_surfel = _core.orthoview_surfels(bits)[number, ..., 0]
        shapes_by_name[name] = _shapes.mixed(is_surfel, _shapes.inner(bits[number, ..., 0]))
    return shapes_by_name


@dataclass(frozen=True)
class Measures:
    """Measures of a picture; shares in percent of the samples whose surfaces the view shows."""

    picture: NDArray[np.uint8]
    psnr: float
    ssim: float
    holes: float
    too_far: float
    too_near: float
    false: float
    """Samples of the sky that show a splat, in percent of the samples whose surfaces the view shows."""

    def cells(self) -> tuple[float, ...]:
        """Cells of a table below `HEADER`."""
        return self.psnr, self.ssim, self.holes, self.too_far, self.too_near, self.false


HEADER = "PSNR, dB {:.1f} | SSIM {:.3f} | holes, % | too far, % | too near, % | false, %"


@dataclass(frozen=True)
class Truth:
    """The leaf as seen by the camera, with a ray for each sample."""

    fine: nf.Camera
    """Camera with a pixel for each sample."""
    frame: nf.Frame
    sky: NDArray[np.float32]
    shown: Bools
    """Mask of samples whose surfaces the view shows."""

    @classmethod
    def trace(cls, leaf: Leaf, pixel_camera: nf.Camera, views: _core.OrthoViews, layout: Layout, number: int) -> Truth:
        """Trace the truth."""
        fine = replace(pixel_camera, size=(GRID * SIZE[0], GRID * SIZE[1]))
        frame = nf.render(leaf.scene, fine, clip=nf.Clip(box=leaf.box), channels=("color", "range", "position"))
        points = frame.require("position") + np.array(frame.origin)
        empty = nf.render(leaf.scene, fine, t_max=1e-6, channels=("color",)).require("color")
        axes, extents = axes_of(layout.directions[number], leaf.side)
        metres = metres_of(views, number, layout, leaf.side)
        return cls(fine, frame, empty, shown_by(points, axes, extents, leaf.box.mean(axis=0), metres))

    @property
    def picture(self) -> NDArray[np.uint8]:
        """Picture of averaged samples, sRGB."""
        return average(self.frame.require("color"), GRID)

    def measure(self, color: NDArray[np.uint8], depth: Floats) -> Measures:
        """Compare a picture of the same samples."""
        is_drawn = np.isfinite(depth)
        picture = average(np.where(is_drawn[..., None], to_linear(color / 255.0), self.sky), GRID)
        _, rays = self.fine.rays()
        truth = self.frame.require("range") * (rays @ _shapes.ahead_of(self.fine))
        with np.errstate(invalid="ignore"):
            behind = depth - truth
        shares = (~is_drawn, is_drawn & (behind > MIN_GAP), behind < -MIN_GAP)
        holes, far, near = (100 * float(share[self.shown].mean()) for share in shares)
        sky = ~np.isfinite(truth)
        false = 100 * float((sky & is_drawn).sum() / self.shown.sum())
        is_compared = blocks(self.shown | sky, GRID).all(axis=(1, 3))
        reference = self.picture
        ssim = float(nf.ssim(reference, picture, data_range=255, mask=is_compared))
        psnr = nf.psnr(reference[is_compared][:, None], picture[is_compared][:, None], data_range=255)
        return Measures(picture, psnr, ssim, holes, far, near, false)


def kernel_picture(leaf: Leaf, views: _core.OrthoViews, number: int, fine: nf.Camera) -> tuple[Picture, Floats]:
    """Picture of one view by the kernel of `tree.render`."""
    splats = _core.OrthoSplats(views, number, views.connected(CONNECTION_LIMITS), (leaf.corner, leaf.side))
    settings = Shot(cameras=(fine,), channels=("color", "range")).settings
    images = _core.splat_orthoviews([splats], fine._core, settings, origin=(0.0, 0.0, 0.0), grid=1)
    _, rays = fine.rays()
    return encode(images["color"]), images["range"] * (rays @ _shapes.ahead_of(fine))


if __name__ == "__main__":
    main()
