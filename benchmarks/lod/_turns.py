"""Triangles of a full turn of the camera in the middle of a ball of objects, over draws of the objects' places."""

from __future__ import annotations

import functools
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.lod._objects import Crowd, Headset, crowd

FRAMES = 250
"""Number of frames of a turn: every tenth of the thesis' 2,500."""
DRAWS = 20
"""Number of balls with different object places."""
RADIUS = 0.5
"""Radius of an object, metres."""


@dataclass(frozen=True)
class Draws:
    """Balls of objects, and the turn of the camera in each."""

    size: float
    """Radius of the ball, metres."""
    count: int
    """Number of objects in the ball."""
    radius: float = RADIUS
    """Radius of an object, metres."""
    draws: int = DRAWS
    frames: int = FRAMES


@dataclass(frozen=True)
class Spread:
    """Mean over draws and its standard error."""

    mean: float
    error: float

    @staticmethod
    def from_values(values: Sequence[float]) -> Spread:
        """Compute the spread of one value for each draw."""
        return Spread(float(np.mean(values)), float(np.std(values, ddof=1) / np.sqrt(len(values))))

    def __str__(self) -> str:
        """Format with one decimal."""
        return f"{self.mean:.1f} ± {self.error:.1f}"


@dataclass(frozen=True)
class Turns:
    """Triangles of a mean frame by draw (D,): at full detail, and by the name of each selection method."""

    off: NDArray[np.float64]
    drawn: dict[str, NDArray[np.float64]]

    def saved(self, way: str, over: str | None = None) -> Spread:
        """Percentage of triangles that a method saves relative to another one, or to full detail."""
        before = self.off if over is None else self.drawn[over]
        return Spread.from_values((100 * (1 - self.drawn[way] / before)).tolist())


def turns(
    models: Sequence[nf.lod.LodModel],
    headset: Headset,
    ways: dict[str, nf.lod.Selector],
    how: Draws,
) -> Turns:
    """Choose levels in every frame of every draw; objects out of view are not drawn."""
    counts = np.zeros((len(models), max(map(len, models))))
    for n, model in enumerate(models):
        counts[n, : len(model)] = model.triangles
    cameras = [headset.camera(2 * np.pi * frame / how.frames) for frame in range(how.frames)]
    scatter = functools.partial(crowd, models, size=how.size, count=how.count, radius=how.radius)
    # Without size and radius in the seed, a ball twice as large of objects twice as large is the same scene.
    balls = [scatter(seed=(draw, round(how.size), round(1000 * how.radius))) for draw in range(how.draws)]
    every = [_turn(models, counts, ball, cameras, ways) for ball in balls]
    return Turns(
        np.array([off for off, _ in every]),
        {name: np.array([drawn[name] for _, drawn in every]) for name in ways},
    )


def _turn(
    models: Sequence[nf.lod.LodModel],
    counts: NDArray[np.float64],
    scene: Crowd,
    cameras: Sequence[nf.Camera],
    ways: dict[str, nf.lod.Selector],
) -> tuple[float, dict[str, float]]:
    """Triangles of a mean frame at full detail, and by each method."""
    off, drawn = 0.0, dict.fromkeys(ways, 0.0)
    for camera in cameras:
        for name, way in ways.items():
            levels = way.select(models, scene.model_index, scene.centers, scene.radii, camera=camera).level
            drawn[name] += _triangles(counts, scene, levels)
        off += _triangles(counts, scene, np.minimum(levels, 0))
    return off / len(cameras), {name: sum_ / len(cameras) for name, sum_ in drawn.items()}


def _triangles(counts: NDArray[np.float64], scene: Crowd, levels: NDArray[np.int32]) -> float:
    """Number of triangles in view."""
    seen = levels >= 0
    return float(counts[scene.model_index[seen], levels[seen]].sum())
