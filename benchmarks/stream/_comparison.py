"""Experiment 1 of CloVR (2024): the view of twenty users while each strategy loads, and significance tests."""

from __future__ import annotations

import math
import warnings
from dataclasses import dataclass, replace
from itertools import combinations
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from nearfar.stream._client_pictures import SceneParts, measure
from nearfar.stream._strategies import STRATEGIES, HeadPath

USERS, USER_DISTANCE = 20, 2.0
"""Number of users, and their distance in metres from the centre."""
ALPHA = 0.05 / 6
"""Significance level of each of six comparisons, for a total of 5 % (Bonferroni)."""

ALL_STATES = 64
"""Number of client states, more than exist: all users see the same ones."""

Point = tuple[float, float, float]


def users(center: Point, seed: int = 1) -> list[tuple[Point, float]]:
    """Pseudo-random places and directions (degrees about the vertical) of users."""
    turns = np.random.default_rng(seed).uniform(0.0, 2.0 * np.pi, (USERS, 2))
    x, y, z = center
    return [
        ((x + USER_DISTANCE * math.cos(angle), y, z + USER_DISTANCE * math.sin(angle)), look) for angle, look in turns
    ]


def camera_of(eye: Point, look: float, size: tuple[int, int]) -> nf.Camera:
    """A level view of 90°."""
    target = (eye[0] + math.cos(look), eye[1], eye[2] + math.sin(look))
    return nf.Camera.look_at(eye, target, fov=nf.Fov.symmetric(90.0, size[0] / size[1]), size=size)


def quality(
    bundle: nf.stream.Bundle, parts: SceneParts, link: nf.stream.Link, size: tuple[int, int]
) -> dict[str, NDArray[np.float64]]:
    """(users, strategies) means of OVC and OFC, from the request until the slowest strategy has all of its files."""
    lines = {name: nf.stream.simulate(bundle, link=link, strategy=name) for name in STRATEGIES}
    end = max(lines[name].total for name in ("vis0", "vis1", "clovrd"))
    means: dict[str, list[list[float]]] = {"ovc": [], "ofc": []}
    for eye, look in users(bundle.center):
        user_parts = replace(parts, cameras=(camera_of(eye, look, size),), max_cached=ALL_STATES)
        path = HeadPath.parse(eye, bundle.center)
        rows = []
        for name in STRATEGIES:
            line = nf.stream.simulate(bundle, link=link, strategy=name, head_path=eye, duration=end)
            rows.append(fill(line, measure_pictures(thin(line), user_parts, path, every=end)))
        for kind, values in means.items():
            values.append([mean_over_time(row["time"], row[kind], end) for row in rows])
    return {kind: np.array(values) for kind, values in means.items()}


def mean_over_time(times: NDArray[np.float64], values: NDArray[np.float64], end: float) -> float:
    """Return the mean from 0 to `end` of a step function whose values hold until the next time."""
    bounds = np.minimum(np.append(times, end), end)
    return float(np.diff(bounds) @ values / end)


def thin(line: nf.stream.Timeline) -> nf.stream.Timeline:
    """Keep of vis1 the first two states, every fourth portion, and the last two states (last portion and map)."""
    if line.strategy != "vis1":
        return line
    count = len(line.frames["time"])
    keep = sorted({0, 1, *range(4, count, 4), count - 2, count - 1})
    return replace(line, frames={name: values[keep] for name, values in line.frames.items()})


def fill(line: nf.stream.Timeline, pictures: dict[str, Any]) -> dict[str, Any]:
    """Interpolate the omitted portions linearly in their numbers."""
    if line.strategy != "vis1":
        return pictures
    times = line.frames["time"]
    numbers, known = np.arange(len(times)), np.searchsorted(times, pictures["time"])
    return {name: np.interp(numbers, known, values) for name, values in pictures.items()} | {"time": times}


def measure_pictures(line: nf.stream.Timeline, parts: SceneParts, path: HeadPath, *, every: float) -> dict[str, Any]:
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", "the picture folds")
        return measure(line, parts, path, every=every, rate=72.0, end=math.inf).pictures


@dataclass(frozen=True)
class Pair:
    """Two strategies compared by Wilcoxon's test of signed ranks."""

    names: tuple[str, str]
    z: float
    p: float


def significance(values: NDArray[np.float64]) -> tuple[float, float, list[Pair]]:
    """Friedman's χ² and p, and the tests of all pairs."""
    from scipy import stats

    chi, p = stats.friedmanchisquare(*values.T)
    pairs = []
    for (first, a), (second, b) in combinations(zip(STRATEGIES, values.T, strict=True), 2):
        pair_p = float(stats.wilcoxon(a, b, method="asymptotic").pvalue)
        # The statistic is symmetric; the sign is that of the difference.
        z = float(np.sign(np.median(a - b)) * abs(stats.norm.isf(pair_p / 2.0)))
        pairs.append(Pair((first, second), z, pair_p))
    return float(chi), float(p), pairs
