"""The four loading strategies that CloVR (2024) compares, and the settings of a simulated client.

Files are requested in the order of `web/src/show/loader.ts`.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal, TypedDict, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check
from nearfar._base.settings import set_fields
from nearfar._camera.camera import Camera
from nearfar.stream._link import check_ascending
from nearfar.stream._manifest import EMPTY_RING, geometry_files, names_of

Strategy = Literal["vis0", "vis1", "clovr", "clovrd"]
STRATEGIES: tuple[Strategy, ...] = get_args(Strategy)

RATE = 72.0
"""Frames per second of the headset in CloVR (2024)."""


@dataclass(frozen=True)
class Step:
    """Files that are requested together; the next step begins when they are decoded."""

    ring: int | None
    """Ring that is complete after the step; None for dynamic objects."""
    map: tuple[str, ...] | None
    """Files of the map; None if the previous map stays."""
    geometry: tuple[str, ...]
    """Files of the geometry."""
    triangles: int = 0
    """Triangles that the step adds to the picture."""
    may_be_prefetched: bool = False
    """Whether its files are requested when the previous step begins."""

    @property
    def files(self) -> tuple[str, ...]:
        """Files in the order of requests ahead."""
        return self.geometry + (self.map or ())

    @property
    def requests(self) -> tuple[str, ...]:
        """Files in the order of the step's own requests."""
        return (self.map or ()) + self.geometry


@dataclass(frozen=True)
class Plan:
    """Steps of a strategy for a bundle's region."""

    steps: tuple[Step, ...]
    radii: tuple[float, ...]
    """Radii of the rings 1 to n in this strategy; portions of vis0 and vis1 all have the last radius."""
    is_smooth: bool
    is_whole: bool
    """Whether nothing is shown before the last ring."""


def plan_of(strategy: Strategy, region: Mapping[str, Any], number: int, dynamic: Mapping[str, Any] | None) -> Plan:
    """Order the files of a region, given its manifest entry."""
    rings = _by_footprint(region, number) if strategy in ("vis0", "vis1") else region["rings"]
    moving = [] if dynamic is None else [Step(None, None, geometry_files(dynamic), dynamic["triangles"])]
    first, *later = (
        Step(ring_number, _map(ring["map"]), geometry_files(ring), ring["triangles"], may_be_prefetched=ring_number > 1)
        for ring_number, ring in enumerate(rings)
    )
    radii = tuple(float(ring["radius"]) for ring in rings[1:])
    return Plan((first, *moving, *later), radii, strategy == "clovr", strategy == "vis0")


def _by_footprint(region: Mapping[str, Any], number: int) -> list[dict[str, Any]]:
    """Convert portions to rings; the last ring has only the map."""
    entry = region["by_footprint"]
    if entry is None:
        expected = "expected objects by footprint, got none: export the scene with by_footprint=True"
        raise ValueError(f"bundle: regions[{number}].by_footprint: {expected}")
    radius = region["rings"][-1]["radius"]
    portions = [{**portion, "radius": radius, "map": None} for portion in entry["portions"]]
    return [{**EMPTY_RING, "map": None}, *portions, {**EMPTY_RING, "radius": radius, "map": entry["map"]}]


def _map(entry: Mapping[str, Any] | None) -> tuple[str, ...] | None:
    return None if entry is None else tuple(names_of(entry.get("color")) + names_of(entry.get("range")))


@dataclass(frozen=True)
class HeadPath:
    """Positions of the user's eye over time, linearly interpolated."""

    times: NDArray[np.float64]
    """(N,) seconds, ascending."""
    positions: NDArray[np.float64]
    """(N, 3) world metres."""
    center: tuple[float, float, float]
    """The centre O."""

    @classmethod
    def parse(cls, path: ArrayLike | None, center: tuple[float, float, float]) -> HeadPath:
        """Check the caller's positions; None stands for the centre."""
        values = np.array(center) if path is None else check.plain("head_path", path)
        if values.ndim == 1:
            return cls(np.zeros(1), np.array([check.vector("head_path", values)]), center)
        rows = check.array("head_path", values, columns=4, dtype=np.float64, finite=True)
        if not len(rows):
            raise ValueError("head_path: expected at least one row, got none")
        if np.abs(rows).max() > check.FARTHEST:
            raise ValueError(f"head_path: expected numbers up to {check.FARTHEST:g}, got {np.abs(rows).max():g}")
        check_ascending("head_path", rows[:, 0])
        return cls(rows[:, 0], rows[:, 1:], center)

    def position(self, time: float) -> tuple[float, float, float]:
        """Return the position of the eye at a time."""
        x, y, z = (float(np.interp(time, self.times, column)) for column in self.positions.T)
        return x, y, z

    def axis_distance(self, time: float) -> float:
        """Return the distance in metres from the vertical axis through the centre at a time."""
        x, _, z = self.position(time)
        return math.hypot(x - self.center[0], z - self.center[2])


@dataclass(frozen=True, kw_only=True, eq=False)
class ClientSettings:
    """Settings of the client that `simulate` simulates.

    Parameters
    ----------
    strategy
        "clovr": rings fade in, and the morph grows. "clovrd": the same rings without transitions. "vis0": the picture
        is blank until the near objects visible from the centre and the last map have arrived. "vis1": shows these
        objects in order of arrival, and the map last. The last two need `export(by_footprint=True)`.
    head_path
        Position of the user's eye: one position in world metres, or rows (N, 4) of a time in seconds and a position.
        Between rows the position is interpolated linearly; before and after it is constant. Default: the centre.
    camera
        View for the measurement, moved to the user's eye; by default all directions, as six cube faces.
    rate
        Frames per second, 1 to 1000.
    decode_mbs
        Decoding speed of each of the two workers, for maps and for geometry, in megabytes per second; None for no
        decoding time.
    frame_ms, triangles_per_second
        Drawing time of a frame: fixed milliseconds, and triangles drawn per second; None for no time.
    """

    strategy: Strategy = "clovr"
    head_path: ArrayLike | None = None
    camera: Camera | None = None
    rate: float = RATE
    decode_mbs: float | None = None
    frame_ms: float = 0.0
    triangles_per_second: float | None = None

    def __post_init__(self) -> None:
        check.choice("strategy", self.strategy, get_args(Strategy))
        megabytes, speed = self.decode_mbs, self.triangles_per_second
        checked: dict[str, Any] = {
            "rate": check.in_range("rate", self.rate, 1.0, 1000.0),
            "decode_mbs": None if megabytes is None else check.in_range("decode_mbs", megabytes, 1e-6, 1e9),
            "frame_ms": check.in_range("frame_ms", self.frame_ms, 0.0, 1e9),
            "triangles_per_second": None if speed is None else check.in_range("triangles_per_second", speed, 1.0, 1e15),
        }
        if self.head_path is not None:
            HeadPath.parse(self.head_path, (0.0, 0.0, 0.0))
            checked["head_path"] = np.array(self.head_path, np.float64)
            checked["head_path"].setflags(write=False)
        if self.camera is not None:
            check.instance("camera", self.camera, Camera)
        set_fields(self, **checked)

    @property
    def seconds_per_byte(self) -> float:
        """Decoding time of a byte in a worker, seconds."""
        return 0.0 if self.decode_mbs is None else 1e-6 / self.decode_mbs


class ClientKeywords(TypedDict, total=False):
    """Fields of `ClientSettings` as keywords of `simulate`; a test compares both."""

    strategy: Strategy
    head_path: ArrayLike | None
    camera: Camera | None
    rate: float
    decode_mbs: float | None
    frame_ms: float
    triangles_per_second: float | None
