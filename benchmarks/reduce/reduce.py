"""Times of near–far reduction: bakes by size, and frames compared with the full scene."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness import scenes
from benchmarks.harness.report import start, table
from benchmarks.harness.timing import best
from benchmarks.harness.tokyo import load_arrays
from nearfar._reduce.drawing import MorphKind

R1, R2 = 30.0, 50.0


def city() -> tuple[str, nf.Scene, NDArray[np.float64]]:
    """Return the name of a city, the city, and a place in one of its streets."""
    for name, scene in scenes.present("Tokyo core"):
        return name, scene, np.array([275.0, 1.7, -60.7])
    scene = nf.datasets.city(blocks=12, seed=0, detail=2)
    low, high = scene.bounds
    return "procedural city", scene, np.array([(low[0] + high[0]) / 2, 1.7, (low[2] + high[2]) / 2])


def bakes(name: str, scene: nf.Scene, center: NDArray[np.float64], sizes: list[int]) -> str:
    """Table of the time of a bake by face size, one colour sample per texel, with trees already built."""
    rows = []
    for size in sizes:
        job = partial(nf.reduce, scene, center=center, r1=R1, r2=R2, face_size=size, samples=1)
        timing, stats = best(job, repeat=1), job().stats
        rows.append([f"6 × {size}²", timing.wall, stats["rays"] / 1e6 / timing.cpu, stats["map_bytes"] / 1e6])
    title = f"Bake of {name}, {scene.triangle_count:,} triangles, r₂ = {R2:g} m"
    return table(title, "faces | seconds {:.2f} | million rays a CPU-second {:.2f} | MB {:.0f}", rows)


def frames(name: str, scene: nf.Scene, center: NDArray[np.float64], size: tuple[int, int]) -> str:
    """Table of the time of one frame of colour by method, 9 m from the centre."""
    fov = nf.Fov.symmetric(90, size[0] / size[1])
    user = center + np.array([-7.5, 0, -5])
    camera = nf.Camera.look_at(user, user + np.array([1, 0.1, 0.3]), fov=fov, size=size)
    truth = best(lambda: nf.render(scene, camera, channels=("color",)), repeat=3)
    rows: list[list[object]] = [["truth", scene.triangle_count, truth.ms, 1.0, None]]
    exact = nf.render(scene, camera, channels=("color",)).require("color")
    jobs: list[tuple[str, MorphKind, dict[str, Any]]] = [
        ("conventional", "none", {}),
        ("blend, vertices as they are", "blend", {"tolerance_px": np.inf}),
        ("blend, edges within half a pixel", "blend", {}),
        ("cylinder, edges within half a pixel", "cylinder", {}),
        ("blend, bent rays within a tenth of a pixel", "blend", {"method": "exact"}),
        ("blend, bent rays within a fiftieth of a pixel", "blend", {"method": "exact", "tolerance_px": 0.02}),
        ("bent rays within a tenth without a map", "blend", {"method": "exact", "env": False}),
    ]
    for method, morph, how in jobs:
        reduced = nf.reduce(scene, center=center, r1=R1, r2=R2, face_size=512, samples=1, morph=morph)
        # The user moves before each frame, so that data cached for a static user is not reused.
        job = partial(_render_moving_user, reduced, camera, itertools.count(), channels=("color",), **how)
        timing, frame = best(job, repeat=3), job()
        error = np.sqrt(np.mean((frame.require("color") - exact) ** 2))
        traced = frame.stats["frame_triangles"] or reduced.stats["drawn"]
        rows.append([method, traced, timing.ms, timing.wall / truth.wall, error])
    title = f"Frames of {name}, {size[0]} × {size[1]}, 9 m from the centre"
    header = "method | triangles traced {:,} | ms {:.0f} | × truth {:.1f} | rms to truth (linear) {:.3f}"
    return table(title, header, rows)


def _render_moving_user(reduced: nf.ReducedScene, camera: nf.Camera, steps: Iterator[int], **settings: Any) -> nf.Frame:
    """Render a frame for a user who is a millimetre ahead of the last one."""
    x, y, z = camera.position
    return reduced.render(replace(camera, position=(x + 1e-3 * next(steps), y, z)), **settings)


def poses(size: tuple[int, int]) -> str:
    """Table of the time of posing a car of the procedural city, and of a frame, for a static user."""
    scene = nf.datasets.city(blocks=12, seed=0, detail=2)
    car = next(name for name in scene.object_names if name.startswith("car"))
    scene = scene.with_dynamic([car])
    eye, target = nf.datasets.street_view()
    user = np.add(eye, (4.0, 0.0, 3.0))
    camera = nf.Camera.look_at(user, np.add(target, (4.0, 0.0, 3.0)), fov=nf.Fov.symmetric(90, 16 / 9), size=size)
    reduced = nf.reduce(scene, center=eye, r1=R1, r2=R2, face_size=512, samples=1)
    pose = scene.transform(car)
    rows = []
    for method in ("vertex", "exact"):
        frame = partial(reduced.render, camera, channels=("color",), method=method)
        still = best(frame, repeat=3)
        number = iter(range(1000))

        def render_moving_car(frame: Callable[..., nf.Frame] = frame, number: Any = number) -> nf.Frame:
            pose[0, 3] += 0.1 * next(number)
            return frame(at={car: pose})

        timing = best(render_moving_car, repeat=3)
        rows.append([method, best(lambda: scene.at({car: pose}), repeat=3).ms, timing.ms, still.ms])
    title = f"One of the city's cars moves, {size[0]} × {size[1]}"
    return table(title, "method | posing, ms {:.2f} | frame after it, ms {:.0f} | frame without, ms {:.0f}", rows)


def main() -> None:
    quick = start(__doc__, "--quick").quick
    name, scene, center = city()
    scene._core.build()
    print(bakes(name, scene, center, [128, 256] if quick else [256, 512, 1024]))
    print(frames(name, scene, center, (480, 270) if quick else (1920, 1080)))
    print(poses((480, 270) if quick else (1920, 1080)))
    if not quick and (arrays := load_arrays()) is not None:
        scene = nf.Scene.from_arrays(*arrays)
        scene._core.build()
        print(bakes("the whole of Tokyo", scene, center, [1024]))


if __name__ == "__main__":
    main()
