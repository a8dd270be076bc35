"""Pictures as drawn by the page, and the errors of their pixels."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

import nearfar as nf
from nearfar._scene.srgb import to_srgb

ANGLE = 75.0
"""Vertical field of view of the page, degrees."""


def camera(eye: ArrayLike, yaw: float, pitch: float, size: tuple[int, int], angle: float = ANGLE) -> nf.Camera:
    """The page's camera for a pose."""
    ahead = np.array([-np.sin(yaw) * np.cos(pitch), np.sin(pitch), -np.cos(yaw) * np.cos(pitch)])
    across = np.degrees(2 * np.arctan(np.tan(np.radians(angle) / 2) * size[0] / size[1]))
    fov = nf.Fov.symmetric(float(across), aspect=size[0] / size[1])
    return nf.Camera.look_at(eye, np.add(eye, ahead), fov=fov, size=size)


def of_one_face(faces: NDArray[Any]) -> NDArray[np.bool_]:
    """Pixels whose eight neighbours show the same face."""
    same = np.ones(faces.shape, bool)
    for rows in (-1, 0, 1):
        for columns in (-1, 0, 1):
            same &= np.roll(faces, (rows, columns), (0, 1)) == faces
    same[[0, -1]] = same[:, [0, -1]] = False
    return same


def off(frame: nf.Frame, found: NDArray[np.uint8]) -> NDArray[Any]:
    """Differences of a picture's pixels from those of a frame, of 255."""
    expected = np.rint(to_srgb(np.clip(frame.require("color"), 0, 1)) * 255)
    worst: NDArray[Any] = np.abs(expected - found).max(axis=-1)
    return worst


def continuity(pictures: Iterable[ArrayLike]) -> NDArray[np.float64]:
    """Visual continuity of consecutive pictures in sRGB codes, by their luma."""
    grays = [np.asarray(picture, float) @ np.array([0.2126, 0.7152, 0.0722]) for picture in pictures]
    return np.array(list(nf.metrics.visual_continuity(grays, data_range=255.0)))
