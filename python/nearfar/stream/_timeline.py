"""Timelines: the files, states and drawn triangles of a simulated client, with their times."""

from __future__ import annotations

import json
import math
import os
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check, files, plot
from nearfar.stream._loading import Course
from nearfar.stream._strategies import ClientSettings, Plan, Strategy
from nearfar.stream._transport import Transport

if TYPE_CHECKING:
    from matplotlib.axes import Axes

FRAME_COLUMNS = ("time", "ring", "radius", "strength", "share", "triangles", "seconds")


@dataclass(frozen=True, eq=False, repr=False)
class Timeline:
    """Timeline of a client that loads a region by a strategy, on a virtual clock that starts at the manifest's request.

    Arrays of frames have an entry for each frame whose state differs from the previous frame. Times are seconds.
    """

    strategy: Strategy
    """Name of the strategy."""
    radii: tuple[float, ...]
    """Radii in metres of the loaded rings 1 to n. For vis0 and vis1 the rings are portions of objects and finally the
    map, all with the radius of the last ring."""
    files: tuple[str, ...]
    """Names of the files in the order of their arrival."""
    file_times: NDArray[np.float64]
    """(F,) arrival time of each file."""
    ring_times: NDArray[np.float64]
    """(n + 1,) time from which each ring could be shown; infinite for rings that did not arrive in time."""
    ring_triangles: NDArray[np.int64]
    """(n + 1,) number of static triangles that each ring adds."""
    received: NDArray[np.float64]
    """(M, 2) times and bytes received until then, to be interpolated linearly."""
    frames: dict[str, NDArray[Any]] = field(default_factory=dict)
    """Arrays by name with an entry for each frame: `time`; shown `ring` (−1 for blank); `radius` in metres and
    `strength` of the morph; `share` of the next ring's picture in a cross-fade; `triangles` drawn; `seconds` of
    drawing."""
    pictures: dict[str, NDArray[np.float64]] = field(default_factory=dict)
    """Measures by name, if a scene was given, with an entry for each measured frame: `time`; `ovc` and `ofc`, as
    `nearfar.metrics.object_completion` measures them against the truth for the user; `continuity`, the similarity to
    the previous frame."""
    renders: int = 0
    """Number of pictures rendered for the measures; all views together count as one."""

    @classmethod
    def _build(cls, plan: Plan, course: Course, transport: Transport, client: ClientSettings) -> Timeline:
        """Build the arrays; a frame takes constant seconds, plus seconds for each triangle."""
        ring_times, frames = course
        rows = [(f.time, f.state.ring, f.state.radius, f.state.strength, f.state.share) for f in frames]
        columns = dict(zip(FRAME_COLUMNS, np.array(rows, np.float64).T, strict=False))
        columns["ring"] = columns["ring"].astype(np.int64)
        columns["triangles"] = np.array([frame.triangles for frame in frames], np.int64)
        seconds_per_triangle = 1.0 / (client.triangles_per_second or math.inf)
        columns["seconds"] = client.frame_ms / 1e3 + seconds_per_triangle * columns["triangles"]
        return cls(
            strategy=client.strategy,
            radii=plan.radii,
            files=tuple(transport.arrived),
            file_times=np.array(list(transport.arrived.values()), np.float64),
            ring_times=np.array([ring_times.get(ring, math.inf) for ring in range(len(plan.radii) + 1)]),
            ring_triangles=np.array([step.triangles for step in plan.steps if step.ring is not None], np.int64),
            received=np.array(transport.curve, np.float64),
            frames=columns,
        )

    @property
    def picture(self) -> float:
        """Time of the first complete picture: ring 0 for clovr and clovrd, the last map for the others."""
        return float(self.ring_times[0 if self.strategy.startswith("clovr") else -1])

    @property
    def first_ring(self) -> float:
        """Time from which near geometry could be shown: ring 1 or the first portion; for vis0 all of it."""
        return float(self.ring_times[-1 if self.strategy == "vis0" else 1])

    @property
    def total(self) -> float:
        """Time of the last arrival."""
        return float(self.ring_times.max())

    @property
    def grown(self) -> float:
        """Time of the last change of a frame."""
        return float(self.frames["time"][-1])

    def bytes_at(self, time: ArrayLike) -> Any:
        """Return the number of bytes received until a time or each of several times, in seconds."""
        times = check.array("time", time, columns=None, dtype=np.float64, finite=True)
        if (times < 0.0).any():
            raise ValueError(f"time: expected times of at least 0, got {times.min():g}")
        received = np.interp(times, *self.received.T)
        return float(received) if received.ndim == 0 else received

    @property
    def geometry_share(self) -> NDArray[np.float64]:
        """Share of all rings' triangles that had arrived at each frame, 0 to 1."""
        has_arrived = self.ring_times[None, :] <= self.frames["time"][:, None]
        return np.asarray(has_arrived @ self.ring_triangles / max(int(self.ring_triangles.sum()), 1))

    def to_dict(self) -> dict[str, Any]:
        """Return all fields as numbers, strings and lists; infinite times become None."""
        arrivals = zip(self.files, self.file_times.tolist(), strict=True)
        rings = zip(_numbers(self.ring_times), self.ring_triangles.tolist(), strict=True)
        picture, first_ring, total = _numbers(np.array([self.picture, self.first_ring, self.total]))
        return {
            "strategy": self.strategy,
            "radii": list(self.radii),
            "picture": picture,
            "first_ring": first_ring,
            "total": total,
            "files": [{"name": name, "time": time} for name, time in arrivals],
            "rings": [{"time": time, "triangles": count} for time, count in rings],
            "received": self.received.tolist(),
            "pictures": {name: _numbers(values) for name, values in self.pictures.items()},
            "renders": self.renders,
            "frames": {name: _numbers(values) for name, values in self.frames.items()},
        }

    def to_json(self, path: str | os.PathLike[str]) -> None:
        """Write `to_dict` as a JSON file, atomically."""
        with files.atomic_file(check.path("path", path)) as temporary:
            temporary.write_text(json.dumps(self.to_dict(), allow_nan=False) + "\n", encoding="utf-8")

    def plot(self, ax: Axes | None = None, *, value: str = "bytes") -> Axes:
        """Plot one value over time, in given or new axes of matplotlib.

        `value` is "bytes" received, or the name of an array of `frames` or `pictures`, such as "radius" or "ovc".
        ImportError without matplotlib.
        """
        arrays = {**self.frames, **self.pictures}
        check.choice("value", value, ["bytes", *(name for name in arrays if name != "time")])
        if value == "bytes":
            return plot.over_time(ax, self.received[:, 0], self.received[:, 1], value, steps=False)
        rows = self.pictures if value in self.pictures else self.frames
        return plot.over_time(ax, rows["time"], rows[value], value, steps=True)

    def __repr__(self) -> str:
        return (
            f"Timeline({self.strategy}: picture {self.picture:.2f} s, first ring {self.first_ring:.2f} s, "
            f"all {self.total:.2f} s, {self.received[-1, 1]:,.0f} bytes)"
        )


def _numbers(values: NDArray[Any]) -> list[Any]:
    """Return values for JSON; None for infinite numbers and NaN."""
    return [value if math.isfinite(value) else None for value in values.tolist()]
