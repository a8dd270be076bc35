"""Blending with the previous picture, and warps to poses, by the definition: pixel after pixel, point after point."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

import nearfar as nf

Image = NDArray[np.float64]
FAR = 1e9
"""Distance of the sky in metres: less than a millionth of a pixel from infinity."""


def point(start: Image, way: Image, distance: float) -> Image:
    return start + way * min(distance, FAR)


def project(camera: nf.Camera, at: Image, distance: float = 0.0) -> Image:
    """Position of a point in the picture; NaN behind the camera, and for the sky along parallel rays."""
    if math.isinf(distance) and isinstance(camera.fov, nf.Orthographic):
        return np.full(2, np.nan)
    return camera.project(at[None])[0, :2]


def cubic(t: float) -> Image:
    """Weights of four pixels by Catmull and Rom's matrix."""
    matrix = 0.5 * np.array([[0, -1, 2, -1], [2, 0, -5, 3], [0, 1, 4, -3], [0, 0, -1, 1]])
    return np.asarray(matrix @ np.array([1.0, t, t * t, t**3]))


def taps(place: Image, size: tuple[int, int]) -> tuple[list[list[tuple[int, int]]], Image]:
    """Rows of four by four pixels (y, x) about a position, and its fractions between the middle ones."""
    first = np.floor(place - 0.5).astype(int)
    columns = np.clip(first[0] + np.arange(-1, 3), 0, size[0] - 1).tolist()
    rows = np.clip(first[1] + np.arange(-1, 3), 0, size[1] - 1).tolist()
    return [[(y, x) for x in columns] for y in rows], place - 0.5 - first


def sampled(color: Image, place: Image) -> Image:
    height, width = color.shape[:2]
    pixels, between = taps(place, (width, height))
    across, down = cubic(between[0]), cubic(between[1])
    terms = [down[j] * across[i] * color[pixels[j][i]] for j in range(4) for i in range(4)]
    return np.asarray(np.sum(terms, axis=0))


def looked_up(color: Image, place: Image, agrees: list[list[bool]]) -> Image | None:
    """The colour at a position, from the pixels that agree."""
    height, width = color.shape[:2]
    pixels, (x, y) = taps(place, (width, height))
    middle = [(1, 1), (1, 2), (2, 1), (2, 2)]
    if all(itertools.chain(*agrees)):
        around = np.array([color[pixels[j][i]] for j, i in middle])
        return np.clip(sampled(color, place), around.min(axis=0), around.max(axis=0))
    shares = {(1, 1): (1 - x) * (1 - y), (1, 2): x * (1 - y), (2, 1): (1 - x) * y, (2, 2): x * y}
    used = [at for at in middle if agrees[at[0]][at[1]]]
    total = sum(shares[at] for at in used)
    if total < 0.25:
        return None
    return np.asarray(sum(shares[j, i] * color[pixels[j][i]] for j, i in used) / total)


def blended(past: nf.Frame, now: nf.Frame, fade: tuple[float, float]) -> tuple[Image, NDArray[np.bool_]]:
    """The picture mixed with the previous one, and where both show the same surfaces.

    With motion, which gives a surface's earlier position, distances must agree within 2 %; without it a surface that is
    found there must be near the pixel now.
    """
    (width, height), (starts, ways) = now.camera.size, now.camera.rays()
    before, fresh = past.require("color").astype(float), now.require("color").astype(float)
    mixed, agrees = fresh.copy(), np.zeros((height, width), bool)
    eye = np.array(past.camera.position)
    is_parallel, forward = isinstance(past.camera.fov, nf.Orthographic), past.camera.rays()[1][0, 0]
    for row, column in itertools.product(range(height), range(width)):
        distance = float(now.require("range")[row, column])
        there = point(starts[row, column], ways[row, column], distance)
        here = np.array([column + 0.5, row + 0.5])
        motion = None if now.motion is None else now.motion[row, column].astype(float)
        place = project(past.camera, there, distance) if motion is None else here - motion
        if not (np.isfinite(place).all() and (place >= 0).all() and (place <= past.camera.size).all()):
            continue
        depth = past.camera.project(there[None])[0, 2]
        length = depth if is_parallel else float(np.linalg.norm(there - eye))
        toward = forward if is_parallel else (there - eye) / length
        foot = there - length * toward
        exponent = fade[0] + (fade[1] - fade[0]) * min(float(np.linalg.norm(place - here)) / 0.1, 1.0)

        def holds(
            found: float,
            *,
            motion: Image | None = motion,
            distance: float = distance,
            length: float = length,
            foot: Image = foot,
            toward: Image = toward,
            here: Image = here,
            exponent: float = exponent,
        ) -> bool:
            if motion is not None:
                return found == distance if math.isinf(distance) else abs(length / found - 1) <= 0.02
            at = project(now.camera, foot + min(found, FAR) * toward, found)
            return bool(np.linalg.norm(at - here) <= min(exponent, 0.5))

        pixels, _ = taps(place, past.camera.size)
        tests = [[holds(float(past.require("range")[at])) for at in line] for line in pixels]
        color = looked_up(before, place, tests)
        if color is not None:
            agrees[row, column] = True
            mixed[row, column] += (color - mixed[row, column]) * math.exp(-exponent)
    return mixed, agrees


def averaged(frame: nf.Frame, poses: Sequence[nf.Camera]) -> Image:
    """The picture averaged over poses."""
    (width, height), (starts, ways) = frame.camera.size, frame.camera.rays()
    color = frame.require("color").astype(float)
    total, count = np.zeros_like(color), np.zeros((height, width))
    for pose in poses:
        nearest: dict[tuple[int, int], tuple[float, Image]] = {}
        for row, column in itertools.product(range(height), range(width)):
            distance = float(frame.require("range")[row, column])
            there = point(starts[row, column], ways[row, column], distance)
            place = project(pose, there, distance)
            if not (np.isfinite(place).all() and (place >= 0).all() and (place < (width, height)).all()):
                continue
            away = math.inf if math.isinf(distance) else float(np.linalg.norm(there - pose.position))
            if isinstance(pose.fov, nf.Orthographic):
                away = float(pose.project(there[None])[0, 2])
            target = int(place[1]), int(place[0])
            beside = np.array([target[1] + 0.5, target[0] + 0.5]) - place
            if target not in nearest or np.float32(away) < np.float32(nearest[target][0]):
                nearest[target] = away, np.array([column + 0.5, row + 0.5]) + beside
        for target, (_, place) in nearest.items():
            total[target] += np.maximum(sampled(color, place), 0.0)
            count[target] += 1
    return np.where(count[..., None] > 0, total / np.maximum(count, 1)[..., None], color)
