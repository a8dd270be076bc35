"""NumPy splats that blend instead of occluding one another: by their opacity, and by their directions."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.pictures import blocks
from benchmarks.orthoview._splats import Pixels
from nearfar._scene.srgb import to_linear
from nearfar.orthoview._gaussians import MIN_COSINE, SUN, irradiance
from nearfar.orthoview._view import OrthoView

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

SURFEL_SCALE, SQUARED_RADIUS = 1.27, 0.5
"""Size of a surfel relative to its pixel, so that its faded border overlaps the next; |q|² at the edge of a splat."""
SHARPNESS = 4.0
"""Opacity at q within a splat is e^(−`SHARPNESS` |q|²)."""
LAYER = 0.01
"""Splats at one sample blend with the nearest one if they are at most this share of its distance behind it."""
REACH = 3
"""Maximum distance of a sample from a splat's middle, samples."""
MIN_AXES_SINE = 1e-4
"""Least sine of the angle between an ellipse's axes in the picture; flatter ellipses are left out."""
VIEWS, GRID = 3, 2
"""Drawn views of a cell; samples along each axis of a pixel."""


@dataclass(frozen=True)
class Blend:
    """Blending of splats at one sample."""

    opacity: bool = False
    """Whether splats close behind the nearest one are weighted by opacity; otherwise only the nearest one is drawn."""
    directions: bool = False
    """Whether splats are weighted by direction, with weights that fall to 0 where a direction is no longer chosen."""


@dataclass(frozen=True)
class _Splats:
    point: Floats
    u: Floats
    v: Floats
    light: Floats
    """Displayed linear RGB (N, 3)."""
    weight: Floats
    """Weights of their directions (N,)."""


def render_blended(tree: nf.orthoview.OrthoTree, camera: nf.Camera, blend: Blend, sky: nf.Frame) -> nf.Frame:
    """Render a tree's views without geometry; `sky` is a picture of the background with the same size."""
    width, height = camera.size
    fine = replace(camera, size=(width * GRID, height * GRID))
    nearest = np.zeros(width * height * GRID**2)
    total, weights = np.zeros((len(nearest), 3)), np.zeros(len(nearest))
    splats = _splats(tree, camera)
    for sample, nearness, _, _ in _samples(splats, fine):
        np.maximum.at(nearest, sample, nearness)
    for sample, nearness, opacity, splat in _samples(splats, fine):
        is_shown = nearness >= nearest[sample] / (1 + LAYER) if blend != Blend() else nearness == nearest[sample]
        weight = np.where(is_shown, 1.0, 0.0)
        weight *= opacity if blend.opacity else 1.0
        weight *= splats.weight[splat] + 1e-6 if blend.directions else 1.0
        np.add.at(weights, sample, weight)
        np.add.at(total, sample, weight[:, None] * splats.light[splat])
    behind = sky.require("color").repeat(GRID, axis=0).repeat(GRID, axis=1).reshape(-1, 3)
    color_of_sample = np.where(weights[:, None] > 0, total / np.maximum(weights, 1e-30)[:, None], behind)
    color = blocks(color_of_sample.reshape(*fine.size[::-1], 3), GRID).mean(axis=(1, 3)).astype(np.float32)
    return nf.Frame(camera, color=color)


def _samples(splats: _Splats, camera: nf.Camera) -> Iterator[tuple[Ints, Floats, Floats, Ints]]:
    """Yield samples covered by splats: their numbers, nearness (1/depth) and opacity there, and the splats' numbers."""
    width, height = camera.size
    projected = camera.project(splats.point)
    # The derivative, by a step that is small compared with a splat.
    axes = [camera.project(splats.point + 1e-3 * axis) - projected for axis in (splats.u, splats.v)]
    (ux, uy, uw), (vx, vy, vw) = (axis.T * 1e3 for axis in axes)
    determinant = ux * vy - uy * vx
    x, y, depth = projected.T
    with np.errstate(invalid="ignore"):
        is_flat = np.abs(determinant) < MIN_AXES_SINE * np.hypot(ux, uy) * np.hypot(vx, vy)
        usable = np.flatnonzero((depth > 1.0) & ~is_flat & (x > -REACH) & (x < width + REACH))
    x, y, depth, determinant = x[usable], y[usable], depth[usable], determinant[usable]
    ux, uy, uw, vx, vy, vw = (value[usable] for value in (ux, uy, uw, vx, vy, vw))
    column, row = np.floor(x).astype(int), np.floor(y).astype(int)
    for down in range(-REACH, REACH + 1):
        for across in range(-REACH, REACH + 1):
            dx, dy = column + across + 0.5 - x, row + down + 0.5 - y
            q0, q1 = (vy * dx - vx * dy) / determinant, (ux * dy - uy * dx) / determinant
            squared = q0**2 + q1**2
            is_in = (squared <= SQUARED_RADIUS) | ((across == 0) & (down == 0))
            is_in &= (column + across >= 0) & (column + across < width) & (row + down >= 0) & (row + down < height)
            n = np.flatnonzero(is_in)
            sample = (row[n] + down) * width + column[n] + across
            sample_depth = depth[n] + np.clip(q0[n], -1, 1) * uw[n] + np.clip(q1[n], -1, 1) * vw[n]
            opacity = np.exp(-SHARPNESS * np.minimum(squared[n], SQUARED_RADIUS))
            yield sample, 1.0 / np.maximum(sample_depth, 1.0), opacity, usable[n]


def _splats(tree: nf.orthoview.OrthoTree, camera: nf.Camera) -> _Splats:
    """Splats of a cut. Their weight is the cosine of their view minus that of the first view that is not drawn."""
    cut = tree.cut(camera, views=VIEWS + 1, geometry=False)
    units = np.array(tree.directions) / np.linalg.norm(tree.directions, axis=1, keepdims=True)
    parts = []
    for level, place, numbers in zip(cut.level.tolist(), cut.place.tolist(), cut.directions, strict=True):
        chosen_directions = numbers[numbers >= 0]
        toward = np.array(camera.position) - tree.box(level, tuple(place)).mean(axis=0)
        cosines = units[chosen_directions] @ (toward / np.linalg.norm(toward))
        excluded_cosine = cosines[VIEWS] if len(chosen_directions) > VIEWS else -1.0
        for number, cosine in zip(chosen_directions[:VIEWS].tolist(), cosines[:VIEWS].tolist(), strict=True):
            view = tree.view(level, tuple(place), number)
            if view is not None:
                parts.append(_splats_of_view(view, max(cosine - excluded_cosine, 0.0)))
    return _Splats(*(np.concatenate([getattr(part, name) for part in parts]) for name in _Splats.__dataclass_fields__))


def _splats_of_view(view: OrthoView, weight: float) -> _Splats:
    is_shown = np.isfinite(view.depth)
    normal, surfel = view.normal[is_shown], view.surfel[is_shown][:, None]
    axes, sides = np.stack([view.right, view.up, view.toward]), view.extents[:2] / len(view.depth)
    pixels = Pixels(view.points()[is_shown], normal.astype(float), view.color[is_shown], axes, sides, is_shown)
    u, v = pixels.tangents(MIN_COSINE)
    ball_radius = np.hypot(*sides) / 2 / np.sqrt(SQUARED_RADIUS)
    light = to_linear(pixels.color / 255) * irradiance(normal, SUN)
    return _Splats(
        pixels.middle,
        np.where(surfel, SURFEL_SCALE * u, ball_radius * view.right),
        np.where(surfel, SURFEL_SCALE * v, ball_radius * view.up),
        light,
        np.full(len(light), weight),
    )
