"""Times of 1080p frames of ground truth by channels and samples, compared with embreex (tracing only) and pyrender.

CPU seconds are those of all threads; error is against 256 samples, root mean square in linear light.
"""

from __future__ import annotations

import importlib.util
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness import opengl, scenes
from benchmarks.harness.report import start, table
from benchmarks.harness.timing import Timing, best

SIZE = (1920, 1080)
REPEAT = 3


def view(scene: nf.Scene, size: tuple[int, int]) -> nf.Camera:
    """A view over the roofs of the middle, with all distances from near to far."""
    low, high = scene.bounds
    middle, reach = (low + high) / 2, min(float(np.linalg.norm(high - low)), 2000.0)
    eye = middle + reach * np.array([0.12, 0.0, 0.25])
    eye[1] = low[1] + 0.12 * reach
    target = (middle[0], low[1], middle[2])
    return nf.Camera.look_at(eye, target, fov=nf.Fov.symmetric(60, size[0] / size[1]), size=size)


def row(name: str, timing: Timing, reference: Timing | None, error: float | None = None) -> list[object]:
    return [name, timing.ms, timing.cpu_ms, reference and timing.cpu / reference.cpu, error]


def ours(scene: nf.Scene, camera: nf.Camera, reference: Timing | None) -> list[list[object]]:
    channels = (("range",), ("object_id",), ("position", "normal"), ("color",), ("color", "range", "object_id"))
    times = {
        ", ".join(names): best(partial(nf.render, scene, camera, channels=names), repeat=REPEAT) for names in channels
    }
    return [row(name, timing, reference) for name, timing in times.items()]


def by_samples(scene: nf.Scene) -> list[list[object]]:
    """Table by samples, at a quarter of the picture's width and height, so that the exact one takes seconds."""
    draw = partial(nf.render, scene, view(scene, (SIZE[0] // 4, SIZE[1] // 4)), channels=["color"])
    exact = draw(samples=256).require("color")
    rows = []
    for samples in (1, 4, 16, 64):
        job = partial(draw, samples=samples)
        error = float(np.sqrt(np.mean((job().require("color") - exact) ** 2)))
        rows.append(row(f"color, {samples} samples", best(job, repeat=REPEAT), None, error))
    return rows


def embree(scene: nf.Scene, camera: nf.Camera) -> Timing | None:
    """Time the same primary rays, traced without shading, on one thread, because embreex supports no others."""
    if not importlib.util.find_spec("embreex"):
        return None
    from embreex import rtcore_scene
    from embreex.mesh_construction import TriangleMesh

    device_scene = rtcore_scene.EmbreeScene()
    starts, directions = camera.rays()
    # embreex has no type annotations.
    mesh: Any = TriangleMesh
    mesh(device_scene, scene.triangles())
    origins = (starts - scene.origin).reshape(-1, 3).astype(np.float32)
    flat_directions = directions.reshape(-1, 3).astype(np.float32)
    return best(lambda: device_scene.run(origins, flat_directions, output=True), repeat=REPEAT)


def pyrender(scene: nf.Scene, camera: nf.Camera) -> Timing | None:
    """Time depth only by OpenGL, in software if there is no GPU, without the upload."""
    peer = opengl.pyrender()
    if peer is None:
        return None
    mesh = peer.Mesh([peer.Primitive(positions=scene.triangles().reshape(-1, 3))])
    peer_scene = opengl.scene_of(mesh, camera, origin=scene.origin)
    renderer = peer.OffscreenRenderer(*SIZE)
    flags = peer.RenderFlags.DEPTH_ONLY | peer.RenderFlags.SKIP_CULL_FACES
    try:
        return best(lambda: renderer.render(peer_scene, flags), repeat=REPEAT)
    finally:
        renderer.delete()


def main() -> None:
    options = start(__doc__, files={"nargs": "*", "help": "scenes; by default the core of Tokyo or a city"})
    header = "job | wall ms {:.0f} | CPU ms {:.0f} | CPU of embreex' tracing {:.2f} | rms error {:.4f}"
    named = {Path(file).stem: nf.Scene.load(file) for file in options.files} or dict(scenes.present("Tokyo core"))
    for name, scene in (named or {"city": nf.datasets.city()}).items():
        camera = view(scene, SIZE)
        reference = embree(scene, camera)
        rows = ours(scene, camera, reference)
        rows += [row("embreex, tracing alone", reference, reference)] if reference else []
        peer_timing = pyrender(scene, camera)
        rows += [row("pyrender, depth alone", peer_timing, reference)] if peer_timing else []
        print(table(f"Ground truth, 1080p, {name}, {scene.triangle_count:,} triangles", header, rows))
        print(table(f"Anti-aliasing, 480x270, {name}", header, by_samples(scene)))


if __name__ == "__main__":
    main()
