"""The four strategies that CloVR (2024) compares: order of a client's requests, and when files are shown.

The order is that of `web/src/show/loader.ts`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal, get_args

from nearfar.stream._manifest import EMPTY_RING, geometry_files, names_of

Strategy = Literal["vis0", "vis1", "clovr", "clovrd"]
STRATEGIES: tuple[Strategy, ...] = get_args(Strategy)


@dataclass(frozen=True)
class Step:
    """Files that are requested together; the next step begins when they are decoded."""

    ring: int | None
    """Ring that is complete after the step; None for dynamic objects."""
    map: tuple[str, ...] | None
    """Files of the map; None if the map stays."""
    geometry: tuple[str, ...]
    """Files of the geometry."""
    triangles: int = 0
    """Triangles that the step adds to the picture."""
    is_ahead: bool = False
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

    @property
    def triangles(self) -> int:
        """Number of static triangles in all rings."""
        return sum(step.triangles for step in self.steps if step.ring is not None)


def plan_of(strategy: Strategy, region: Mapping[str, Any], number: int, dynamic: Mapping[str, Any] | None) -> Plan:
    """Order the files of a region, given its manifest entry."""
    rings = _by_footprint(region, number) if strategy in ("vis0", "vis1") else region["rings"]
    moving = [] if dynamic is None else [Step(None, None, geometry_files(dynamic), dynamic["triangles"])]
    first, *later = (
        Step(ring_number, _map(ring["map"]), geometry_files(ring), ring["triangles"], is_ahead=ring_number > 1)
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
