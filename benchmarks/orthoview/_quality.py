"""Compares pictures of trees with the truth."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import astuple, dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import maximum_filter

import nearfar as nf
from benchmarks.harness.pictures import similarity
from benchmarks.orthoview._worlds import World

SAMPLES = 16
"""Samples per pixel for comparisons of colours."""
SAME_SHARE, SAME_METRES = 0.02, 1.0
"""Two ranges near ≤ far are of the same surface if far ≤ (1 + `SAME_SHARE`) near + `SAME_METRES`."""

MAX_DEPTH_PIXELS = 2
"""A view shows a point if their depths differ by less than this many of the view's pixels."""

Floats = NDArray[np.float64]
Bools = NDArray[np.bool_]


@dataclass(frozen=True)
class Truth:
    """A world as a camera sees it, ray by ray."""

    world: World
    camera: nf.Camera
    box: Floats
    """The tree's box, beyond which nothing is visible."""

    @cached_property
    def color(self) -> nf.Frame:
        return self._render(("color",), SAMPLES)

    @cached_property
    def range(self) -> NDArray[np.float32]:
        """Distances (H, W) in metres from the camera."""
        return self._render(("range",), 1).require("range")

    def _render(self, channels: tuple[str, ...], samples: int) -> nf.Frame:
        return nf.render(self.world.scene, self.camera, clip=nf.Clip(box=self.box), channels=channels, samples=samples)


@dataclass(frozen=True)
class Quality:
    """Measures of a picture; shares in percent of the pixels whose truth is a surface, unless stated otherwise."""

    psnr: float
    ssim: float
    holes: float
    """Pixels that show nothing."""
    inner_holes: float
    """Holes whose eight neighbours all show a surface in the truth."""
    through: float
    """Pixels that show a surface behind the true one."""
    inner_through: float
    """Pixels that show a surface behind the true surfaces of the pixel and all of its neighbours."""
    before: float
    """Pixels that show a surface in front of the true one."""
    false: float
    """Pixels that show a surface instead of the sky, in percent of the whole picture."""
    leaves: float
    """Number of leaves drawn as geometry."""


def render(tree: nf.orthoview.OrthoTree, camera: nf.Camera, views: int = 3, *, samples: int = SAMPLES) -> nf.Frame:
    """Render the colours of a tree, or its ranges with one sample a pixel."""
    return tree.render(camera, views=views, samples=samples, channels=("color",) if samples > 1 else ("range",))


def compare(truth: Truth, tree: nf.orthoview.OrthoTree, views: int) -> Quality:
    """Draw a tree, and compare the picture with the truth."""
    frame = render(tree, truth.camera, views, samples=1)
    true, drawn, farthest_true = truth.range, frame.require("range"), farthest(truth.range)
    is_surface, is_drawn = np.isfinite(true), np.isfinite(drawn)
    holes, is_drawn_surface = is_surface & ~is_drawn, is_surface & is_drawn
    through = is_drawn_surface & (drawn > next_surface_range(true))
    masks = (
        holes,
        holes & np.isfinite(farthest_true),
        through,
        through & (drawn > next_surface_range(farthest_true)),
        is_drawn_surface & (true > next_surface_range(drawn)),
    )
    picture = render(tree, truth.camera, views).to_image()
    measures = [*similarity(truth.color.to_image(), picture), *(100 * mask.sum() / is_surface.sum() for mask in masks)]
    measures += [100 * float((is_drawn & ~is_surface).mean()), frame.stats["leaves"]]
    return Quality(*measures)


def shown_by(points: NDArray[Any], axes: Floats, extents: Floats, center: Floats, depth: NDArray[Any]) -> Bools:
    """Whether a view shows world points (…, 3): one of the 3 × 3 pixels around each has about its depth.

    Parameters
    ----------
    points
        NaN for none.
    axes, extents, center, depth
        As for an `OrthoView`: unit vectors to the right, upwards and to the viewer (3, 3), the extents along them, the
        cell's middle, and metres behind the front, infinite for empty pixels.
    """
    local = np.nan_to_num((points - center) @ axes.T)
    size = np.array(depth.shape[::-1])
    pixel = ((np.array([1, -1]) * local[..., :2] / extents[:2] + 0.5) * size).astype(int)
    x, y = np.moveaxis(np.clip(pixel, 0, size - 1), -1, 0)
    padded, behind = np.pad(depth, 1, constant_values=np.inf), extents[2] / 2 - local[..., 2]
    differences = [np.abs(padded[y + dy, x + dx] - behind) for dy in range(3) for dx in range(3)]
    is_alike = np.min(differences, axis=0) < MAX_DEPTH_PIXELS * (extents[:2] / size).max()
    return np.asarray(is_alike & np.isfinite(points).all(axis=-1))


def next_surface_range(ranges: NDArray[np.float32]) -> NDArray[np.float32]:
    """Greatest ranges of the same surfaces: points beyond belong to other surfaces."""
    return np.asarray(ranges * np.float32(1 + SAME_SHARE) + np.float32(SAME_METRES))


def farthest(ranges: NDArray[np.float32]) -> NDArray[np.float32]:
    """Greatest distance of a pixel and its eight neighbours."""
    return np.asarray(maximum_filter(ranges, 3, mode="nearest"))


def mean(qualities: Sequence[Quality]) -> Quality:
    return Quality(*np.mean([astuple(quality) for quality in qualities], axis=0).tolist())
