"""Compares pictures of trees with the truth."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.orthoview._worlds import World

SAMPLES = 16
"""Samples per pixel for comparisons of colours."""
SAME_SHARE, SAME_METRES = 0.02, 1.0
"""Two surfaces are the same if the farther distance is at most (1 + share) times the nearer one plus the metres."""

MAX_DEPTH_PIXELS = 2
"""A view shows a point if their depths differ by less than this many of the view's pixels."""

Floats = NDArray[np.float64]
Bools = NDArray[np.bool_]


@dataclass(frozen=True)
class Setting:
    """Settings for drawing a tree."""

    views: int = 3
    error_px: float = 1.0
    geometry: bool = True

    def render(self, tree: nf.orthoview.OrthoTree, camera: nf.Camera, *, samples: int = SAMPLES) -> nf.Frame:
        return tree.render(
            camera,
            views=self.views,
            error_px=self.error_px,
            geometry=self.geometry,
            samples=samples,
            channels=("color",) if samples > 1 else ("range",),
        )


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
        clip = nf.Clip(box=self.box)
        return nf.render(self.world.scene, self.camera, clip=clip, channels=channels, samples=samples)


@dataclass(frozen=True)
class Quality:
    """Measures of a picture; shares are relative to the pixels whose truth is a surface, unless stated otherwise."""

    psnr: float
    ssim: float
    holes: float
    """Pixels that show nothing."""
    inner_holes: float
    """Holes whose eight neighbours all show a surface in the truth."""
    through: float
    """Pixels that show a surface behind the true one."""
    inner_through: float
    """Pixels among them whose surface is also behind the true surfaces of all their neighbours."""
    before: float
    """Pixels that show a surface in front of the true one."""
    false: float
    """Pixels that show a surface instead of the sky, as a share of the whole picture."""
    read: float
    """Bytes that a client with an empty cache reads."""
    geometry: float
    """Bytes of geometry among them."""
    splats: float
    """Number of splats in the picture."""
    leaves: float
    """Number of leaves drawn as geometry."""


def compare(truth: Truth, tree: nf.orthoview.OrthoTree, setting: Setting) -> Quality:
    """Draw a tree, and compare the picture with the truth."""
    viewer = tree._viewer
    viewer.views.cache.trim((), 0)
    viewer.near.cache.trim((), 0)
    viewer.near._joined = (), None
    bytes_before = viewer.views.cache.read_bytes, viewer.near.cache.read_bytes
    frame = setting.render(tree, truth.camera, samples=1)
    views = viewer.views.cache.read_bytes - bytes_before[0]
    geometry = viewer.near.cache.read_bytes - bytes_before[1]
    holes, through, nearer, false = differences(truth.range, frame.require("range"))
    picture, surface = setting.render(tree, truth.camera).to_image(), np.isfinite(truth.range).sum()
    reference = truth.color.to_image()
    return Quality(
        nf.psnr(reference, picture, data_range=255),
        float(nf.ssim(reference, picture, data_range=255)),
        holes.sum() / surface,
        (holes & np.isfinite(farthest(truth.range))).sum() / surface,
        through.sum() / surface,
        (through & (frame.require("range") > next_surface_range(farthest(truth.range)))).sum() / surface,
        nearer.sum() / surface,
        float(false.mean()),
        views + geometry,
        geometry,
        frame.stats["splats_in_picture"],
        frame.stats["leaves"],
    )


def differences(truth: NDArray[np.float32], ranges: NDArray[np.float32]) -> tuple[Bools, Bools, Bools, Bools]:
    """Masks of pixels that are holes, that show surfaces behind, surfaces in front, and surfaces instead of the sky."""
    is_surface, is_drawn = np.isfinite(truth), np.isfinite(ranges)
    is_drawn_surface = is_surface & is_drawn
    return (
        is_surface & ~is_drawn,
        is_drawn_surface & (ranges > next_surface_range(truth)),
        is_drawn_surface & (truth > next_surface_range(ranges)),
        is_drawn & ~is_surface,
    )


def shown_by(points: NDArray[Any], axes: Floats, extents: Floats, center: Floats, depth: NDArray[Any]) -> Bools:
    """Whether a view shows world points (…, 3): one of nine pixels has the depth of the point.

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
    is_shown: Bools = is_alike & np.isfinite(points).all(axis=-1)
    return is_shown


def next_surface_range(ranges: NDArray[np.float32]) -> NDArray[np.float32]:
    """Distance beyond which a surface counts as another one, farther away."""
    farther: NDArray[np.float32] = ranges * np.float32(1 + SAME_SHARE) + np.float32(SAME_METRES)
    return farther


def farthest(ranges: NDArray[np.float32]) -> NDArray[np.float32]:
    """Greatest distance of a pixel and its eight neighbours."""
    padded = np.pad(ranges, 1, mode="edge")
    nine = np.lib.stride_tricks.sliding_window_view(padded, (3, 3))
    greatest: NDArray[np.float32] = nine.max(axis=(2, 3))
    return greatest


def mean(qualities: Sequence[Quality]) -> Quality:
    """Mean of several pictures."""
    names = Quality.__dataclass_fields__
    return Quality(**{name: float(np.mean([getattr(quality, name) for quality in qualities])) for name in names})
