"""Measures of a simulated client: how much of the scene it shows, and how continuous its pictures are."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base import progress
from nearfar.metrics._pixel_errors import object_completion
from nearfar.metrics._similarity import visual_continuity
from nearfar.stream._client_pictures import Pictures, SceneParts
from nearfar.stream._head_path import HeadPath
from nearfar.stream._stage import Shown
from nearfar.stream._timeline import Timeline


def measured(
    line: Timeline, parts: SceneParts, path: HeadPath, *, every: float, rate: float, duration: float
) -> Timeline:
    """Add `pictures` to a timeline: at each change of the ring or of a cross-fade, and every `every` seconds."""
    pictures = Pictures(parts, by_footprint=line.strategy in ("vis0", "vis1"))
    moments = _moments(line, path, every, min(duration, max(line.grown, float(path.times[-1]))))
    rows = []
    with progress.bar("client pictures") as report:
        for number, time in enumerate(moments, 1):
            eye, shown = path.position(time), _shown_at(line, time)
            now = pictures.client_picture(shown, eye)
            ovc, ofc = object_completion(pictures.truth(eye).objects, now.objects)
            before = pictures.client_picture(_shown_at(line, time - 1.0 / rate), path.position(time - 1.0 / rate))
            rows.append((time, ovc, ofc, next(visual_continuity([before.luma, now.luma], data_range=1.0))))
            report(number, len(moments))
    columns = np.array(rows, np.float64).reshape(-1, 4).T
    names = ("time", "ovc", "ofc", "continuity")
    return replace(line, pictures=dict(zip(names, columns, strict=True)), renders=pictures.renders)


def _moments(line: Timeline, path: HeadPath, every: float, end: float) -> list[float]:
    """Choose the times of the measured frames."""
    frames = line.frames
    is_jump = np.ones(len(frames["time"]), bool)
    if line.strategy == "clovr":
        is_jump[1:-1] = ((np.diff(frames["ring"]) != 0) | (np.diff(frames["share"] > 0.0)))[:-1]
    steps = np.arange(1, math.floor(end / every) + 1) * every
    if len(path.times) == 1:
        # A still user's picture does not change after the last growth.
        steps = steps[steps < line.grown]
    return sorted({*frames["time"][is_jump].tolist(), *steps.tolist()})


def _shown_at(line: Timeline, time: float) -> Shown:
    frames = line.frames
    # Times of frames are rounded; the tolerance is far below half a frame of a fast display.
    index = max(int(np.searchsorted(frames["time"], time + 1e-6, side="right")) - 1, 0)
    values: dict[str, Any] = {name: float(frames[name][index]) for name in ("radius", "strength", "share")}
    return Shown(ring=int(frames["ring"][index]), **values)


def mean_over_time(times: NDArray[np.float64], values: NDArray[np.float64], end: float) -> float:
    """Return the mean from 0 to `end` of a step function whose values hold until the next time."""
    bounds = np.minimum(np.append(times, end), end)
    return float(np.diff(bounds) @ values / end)
