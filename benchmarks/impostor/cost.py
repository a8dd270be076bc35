"""Cost of baking impostors by the number of the scene's triangles and of texels: processor seconds and memory.

Each row is a process of its own. The scene's trees are built before by a small bake, and memory is what the process
needs beyond that.
"""

from __future__ import annotations

import multiprocessing
import time
from pathlib import Path
from typing import Any

import nearfar as nf
from benchmarks.harness import tokyo
from benchmarks.harness.report import save_figure, start, subplots, table
from benchmarks.harness.views import Point, center_for
from benchmarks.impostor.quality import CITY, R2, bake

CITIES = ((2, 1), (6, 1), (12, 1), (8, 2), (12, 2), (24, 2))
"""Blocks and level of detail: 0.05 to 29 million triangles."""


def memory(name: str) -> int:
    """Return memory of this process in bytes: VmRSS now, or VmHWM, the greatest since `reset_peak` (on Linux)."""
    lines = Path("/proc/self/status").read_text().splitlines()
    return 1024 * int(next(line for line in lines if line.startswith(name)).split()[1])


def reset_peak() -> None:
    """Start to measure the greatest memory anew: loading a scene may take more than baking."""
    Path("/proc/self/clear_refs").write_text("5")


def place(name: str, blocks: int, detail: int) -> tuple[nf.Scene, Point] | None:
    """Load or make a scene, and choose a centre; None if its data are missing."""
    if name == CITY:
        return nf.datasets.city(blocks=blocks, detail=detail), nf.datasets.street_view()[0]
    if (arrays := tokyo.load_arrays()) is None:
        return None
    scene = nf.Scene.from_arrays(*arrays)
    return scene, center_for(scene, R2)


def row(name: str, blocks: int, detail: int, size: int) -> list[Any] | None:
    """Bake seven centres of a scene; None if its data are missing."""
    if (found := place(name, blocks, detail)) is None:
        return None
    scene, center = found
    bake(scene, center, R2, nf.ImpostorSettings(face_size=64, centers=1))
    reset_peak()
    before, since = memory("VmRSS"), time.process_time()
    baked = bake(scene, center, R2, nf.ImpostorSettings(face_size=size, centers=7))
    seconds, growth = time.process_time() - since, memory("VmHWM") - before
    stats = baked.stats
    return [name, scene.triangle_count / 1e6, size, stats["texels"] / 1e6, stats["triangles"], seconds, growth / 1e6]


HEADER = (
    "scene | scene's triangles, 10⁶ {:.2f} | face | texels shown, 10⁶ {:.2f} | quads' triangles {:,} | CPU, s {:.1f} |"
    " MB beyond the scene {:.0f}"
)


def main() -> None:
    arguments = start(__doc__, "--quick", "--plots", sizes=[512, 1024])
    cities, sizes = (CITIES[:2], [64]) if arguments.quick else (CITIES, arguments.sizes)
    rows = []
    places = [(CITY, *parameters) for parameters in cities] + (
        [] if arguments.quick else [("the whole of Tokyo", 0, 0)]
    )
    for parameters in places:
        for size in sizes:
            with multiprocessing.get_context("spawn").Pool(1) as pool:
                found = pool.apply(row, (*parameters, size))
            if found is not None:
                rows.append(found)
                print(*found, flush=True)
    print(table("Baking impostors from seven centres", HEADER, rows))
    if arguments.plots is not None:
        figure, axes = subplots()
        for size in sizes:
            millions, seconds = zip(
                *((one[1], one[5]) for one in rows if one[0] == CITY and one[2] == size), strict=True
            )
            axes.plot(millions, seconds, "o-", label=f"{size}² texels a face")
        axes.set(xscale="log", xlabel="million triangles", ylabel="processor seconds", ylim=(0, None))
        axes.legend()
        save_figure(figure, arguments.plots / "impostor_cost.svg")


if __name__ == "__main__":
    main()
