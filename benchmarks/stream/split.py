"""Rings of the procedural city whole and split for clients that move vertices: triangles, bytes, seconds.

python -m benchmarks.stream.split [--quick]
"""

from __future__ import annotations

import argparse
import math
from functools import partial
from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness.timing import best, machine, table
from nearfar import _core
from nearfar.stream._radii import PUBLISHED
from nearfar.stream._split import stages

REACH, EYE_HEIGHT, STEP = 1.0, 1.3, 2.0**-10
"""Distance of users from the centre; height of the eyes in CloVR (2024); step of positions in files, metres."""
PIXELS = {"640 pixels and 90°": 1.0 / 320.0, "20 pixels a degree": math.radians(1.0 / 20.0)}
"""Angle of a pixel in the middle of the picture, radians."""


def encoded(scene: nf.Scene) -> int:
    """Bytes of a scene as a file of a bundle, without its images."""
    groups = np.zeros(len(scene.object_names) + 1, np.uint16)
    images: list[str | None] = [f"{number}.webp" for number in range(len(_core.scene_parts(scene._core)["textures"]))]
    export = _core.Export(scene._core, groups, 1, names=[], images=images, step=STEP, compressed=True)
    return len(export.glb(0, uris=[None] * len(export.shared()))[0])


def rows_of(scene: nf.Scene, center: tuple[float, float, float], pixel: float) -> list[list[str]]:
    rings = nf.stream.assign(scene, center=center, radii=PUBLISHED)
    rows, sums = [], [0, 0, 0, 0]
    for ring, radius in enumerate(PUBLISHED, 1):
        whole = scene.subset(objects=rings.objects(ring))
        settings: dict[str, Any] = {"center": center, "reach": REACH, "tolerance": pixel}
        job = partial(_core.tessellate_scene, whole._core, **stages(PUBLISHED, ring), **settings)
        core, counts = job()
        seconds = best(job, repeat=2).wall
        own = _core.tessellate_scene(whole._core, **stages(PUBLISHED[:ring], ring), **settings)[1]["after"]
        sizes = encoded(whole), encoded(whole._derived(core, whole._rest))
        numbers = (counts["before"], counts["after"], *sizes)
        sums = [total + number for total, number in zip(sums, numbers, strict=True)]
        rows.append([f"{radius:g}", *_row(*numbers), f"{counts['split']:,}", f"{own:,}", f"{seconds:.2f}"])
    return [*rows, ["all", *_row(*sums), "", "", ""]]


def _row(before: float, after: float, whole: float, split: float) -> list[str]:
    return [f"{before:,}", f"{after:,}", f"{whole / 1e3:,.0f}", f"{split / 1e3:,.0f}", f"{split / whole:.2f}"]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="a small city")
    city = nf.datasets.city(blocks=3, detail=0) if parser.parse_args().quick else nf.datasets.city(blocks=9, detail=3)
    (x, _, z), _ = nf.datasets.street_view()
    print(machine())
    header = ["ring, m", "triangles", "split", "kB", "split kB", "times", "faces split", "for its own growth", "s"]
    for name, pixel in PIXELS.items():
        title = f"Split to 1 pixel at {name}, users within {REACH:g} m, radii up to {PUBLISHED[-1]:g} m"
        print(table(title, header, rows_of(city, (x, EYE_HEIGHT, z), pixel)))


if __name__ == "__main__":
    main()
