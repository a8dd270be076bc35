"""Estimates a viewer's motion and extrapolates it."""

from __future__ import annotations

import math
from collections import deque
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from nearfar._camera.camera import Camera
from nearfar._camera.rotation import compose_rotations

WINDOW = 0.25
"""Seconds over which speed is measured."""

FARTHEST_TURN = math.pi / 2
"""Greatest extrapolated turn, radians."""


class Motion:
    """Velocity and turn rate of a viewer, from its last cameras."""

    def __init__(self) -> None:
        self._seen: deque[tuple[float, Camera]] = deque()

    def add(self, camera: Camera, time: float) -> None:
        """Add the viewer's camera at a time; a time that is not later restarts the measurement."""
        if self._seen and time <= self._seen[-1][0]:
            self._seen.clear()
        self._seen.append((time, camera))
        while len(self._seen) > 2 and self._seen[1][0] <= time - WINDOW:
            self._seen.popleft()

    @property
    def velocity(self) -> NDArray[np.float64]:
        """Velocity (3,), metres a second."""
        if len(self._seen) < 2:
            return np.zeros(3)
        (begin, first), (end, last) = self._seen[0], self._seen[-1]
        moved: NDArray[np.float64] = np.subtract(last.position, first.position) / (end - begin)
        return moved

    @property
    def turn(self) -> NDArray[np.float64]:
        """Angular velocity about the world axes (3,), radians a second."""
        if len(self._seen) < 2:
            return np.zeros(3)
        (begin, first), (end, last) = self._seen[0], self._seen[-1]
        i, j, k, real = first.orientation
        x, y, z, w = compose_rotations((-i, -j, -k, real), last.orientation)
        axis = np.array([x, y, z]) * (1.0 if w >= 0.0 else -1.0)
        length = float(np.linalg.norm(axis))
        angle = 2.0 * math.atan2(length, abs(w))
        return axis * (angle / length / (end - begin)) if length > 0.0 else np.zeros(3)

    def extrapolate(self, seconds: float, offset: NDArray[np.float64]) -> Camera:
        """Extrapolate the camera by some seconds of the present turn, and move it by an offset in metres."""
        camera = self._seen[-1][1]
        turn = self.turn * seconds
        angle = float(np.linalg.norm(turn))
        if angle > FARTHEST_TURN:
            turn *= FARTHEST_TURN / angle
            angle = FARTHEST_TURN
        x, y, z = (turn * (math.sin(angle / 2.0) / angle)).tolist() if angle > 0.0 else (0.0, 0.0, 0.0)
        px, py, pz = (np.array(camera.position) + offset).tolist()
        return replace(
            camera,
            position=(px, py, pz),
            orientation=compose_rotations(camera.orientation, (x, y, z, math.cos(angle / 2.0))),
        )
