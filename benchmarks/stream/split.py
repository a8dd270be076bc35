"""Rings of the procedural city whole and split for clients that move vertices: triangles, bytes, seconds."""

from __future__ import annotations

import math
from functools import partial
from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness import scenes
from benchmarks.harness.report import start, table
from benchmarks.harness.timing import best
from benchmarks.stream._near import large_city, one_file, street_center
from nearfar import _core
from nearfar.stream._detail import stages
from nearfar.stream._radii import PUBLISHED

REACH = 1.0
"""Distance of users from the centre, metres."""
PIXELS = {"640 pixels and 90°": 1.0 / 320.0, "20 pixels a degree": math.radians(1.0 / 20.0)}
"""Angle of a pixel in the middle of the picture, radians."""


def rows_of(scene: nf.Scene, center: tuple[float, float, float], pixel: float) -> list[list[object]]:
    rings = nf.stream.assign(scene, center=center, radii=PUBLISHED)
    rows: list[list[object]] = []
    sums = np.zeros(4, np.int64)
    for ring, radius in enumerate(PUBLISHED, 1):
        ring_scene = scene.subset(objects=rings.objects(ring))
        settings: dict[str, Any] = {"center": center, "reach": REACH, "tolerance": pixel}
        job = partial(_core.tessellate_scene, ring_scene._core, stages(PUBLISHED, ring) | settings)
        core, counts = job()
        own_growth = _core.tessellate_scene(ring_scene._core, stages(PUBLISHED[:ring], ring) | settings)[1]["after"]
        parts = ring_scene, ring_scene._derived(core, ring_scene._load_placements)
        sizes = (len(one_file(part, images=True, compressed=True)) for part in parts)
        numbers = np.array([counts["before"], counts["after"], *sizes])
        sums += numbers
        rows.append([f"{radius:g}", *_row(*numbers), counts["split"], own_growth, best(job, repeat=2).wall])
    return [*rows, ["all", *_row(*sums), None, None, None]]


def _row(before: int, after: int, full: int, split: int) -> list[float]:
    return [before, after, full / 1e3, split / 1e3, split / full]


def main() -> None:
    city = scenes.city(quick=True) if start(__doc__, "--quick").quick else large_city(quick=False)
    header = "ring, m | triangles {:,} | split {:,} | kB {:,.0f} | split kB {:,.0f} | times {:.2f} | faces split {:,}"
    for name, pixel in PIXELS.items():
        title = f"Split to 1 pixel at {name}, users within {REACH:g} m, radii up to {PUBLISHED[-1]:g} m"
        print(table(title, header + " | for its own growth {:,} | s {:.2f}", rows_of(city, street_center(), pixel)))


if __name__ == "__main__":
    main()
