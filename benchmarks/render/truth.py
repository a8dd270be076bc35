"""Times of 1080p frames of ground truth by channels and samples, compared with embreex (tracing only) and pyrender.

`python -m benchmarks.render.truth [file …]`; without files the core of Tokyo, or the procedural city without data. CPU
seconds are those of all threads; error is against 256 samples, root mean square in linear light.
"""

from __future__ import annotations

import importlib.util
import os
import sys
import warnings
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness.timing import Timing, best, machine, table
from nearfar._base import data

SIZE = (1920, 1080)
CORE = "city/tokyo23/tokyo_core_lod1.glb"
REPEAT = 3


def scenes(files: list[str]) -> dict[str, nf.Scene]:
    paths = [Path(file) for file in files] or [path for path in [data.find(CORE)] if path]
    loaded = {path.stem: nf.Scene.load(path) for path in paths}
    return loaded or {"city": nf.datasets.city()}


def view(scene: nf.Scene, size: tuple[int, int]) -> nf.Camera:
    """A view over the roofs of the middle, with all distances from near to far."""
    low, high = scene.bounds
    middle, reach = (low + high) / 2, min(float(np.linalg.norm(high - low)), 2000.0)
    eye = middle + reach * np.array([0.12, 0.0, 0.25])
    eye[1] = low[1] + 0.12 * reach
    target = (middle[0], low[1], middle[2])
    return nf.Camera.look_at(eye, target, fov=nf.Fov.symmetric(60, size[0] / size[1]), size=size)


def row(name: str, timing: Timing, reference: Timing | None, error: str = "") -> list[str]:
    ratio = f"{timing.cpu / reference.cpu:.2f}" if reference else ""
    return [name, f"{1e3 * timing.wall:.0f}", f"{1e3 * timing.cpu:.0f}", ratio, error]


def ours(scene: nf.Scene, camera: nf.Camera, reference: Timing | None) -> list[list[str]]:
    rows = []
    for channels in (("range",), ("object_id",), ("position", "normal"), ("color",), ("color", "range", "object_id")):
        timing = best(partial(nf.render, scene, camera, channels=channels), repeat=REPEAT)
        rows.append(row(", ".join(channels), timing, reference))
    return rows


def by_samples(scene: nf.Scene) -> list[list[str]]:
    """Table by samples, at a quarter of the picture's width and height, so that the exact one takes seconds."""
    camera = view(scene, (SIZE[0] // 4, SIZE[1] // 4))
    exact = nf.render(scene, camera, samples=256, channels=["color"]).require("color")
    rows = []
    for samples in (1, 4, 16, 64):
        job = partial(nf.render, scene, camera, samples=samples, channels=["color"])
        error = float(np.sqrt(np.mean((job().require("color") - exact) ** 2)))
        rows.append(row(f"color, {samples} samples", best(job, repeat=REPEAT), None, f"{error:.4f}"))
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
    flat = directions.reshape(-1, 3).astype(np.float32)
    return best(lambda: device_scene.run(origins, flat, output=True), repeat=REPEAT)


def pyrender(scene: nf.Scene, camera: nf.Camera) -> Timing | None:
    """Time depth only by OpenGL, in software if there is no GPU, without the upload."""
    if not importlib.util.find_spec("pyrender"):
        return None
    os.environ.setdefault("PYOPENGL_PLATFORM", "egl")
    vars(np).setdefault("infty", np.inf)  # pyrender 0.1.45 was written for NumPy 1
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        import pyrender as peer

        corners = scene.triangles().reshape(-1, 3)
        whole: Any = peer.Scene()
        whole.add(peer.Mesh([peer.Primitive(positions=corners)]))
        rays = camera.rays()[1]
        pose = np.eye(4)
        right, down = rays[0, -1] - rays[0, 0], rays[-1, 0] - rays[0, 0]
        pose[:3, 0], pose[:3, 1] = right / np.linalg.norm(right), -down / np.linalg.norm(down)
        pose[:3, 2] = np.cross(pose[:3, 0], pose[:3, 1])
        pose[:3, 3] = np.array(camera.position) - scene.origin
        assert isinstance(camera.fov, nf.Fov)
        whole.add(peer.PerspectiveCamera(2 * np.arctan(camera.fov.up), 1.0, 1e4, SIZE[0] / SIZE[1]), pose=pose)
        renderer = peer.OffscreenRenderer(*SIZE)
        flags = peer.RenderFlags.DEPTH_ONLY | peer.RenderFlags.SKIP_CULL_FACES
        try:
            return best(lambda: renderer.render(whole, flags), repeat=REPEAT)
        finally:
            renderer.delete()


def main() -> None:
    header = ["job", "wall ms", "CPU ms", "CPU of embreex' tracing", "rms error"]
    print(machine())
    for name, scene in scenes(sys.argv[1:]).items():
        camera = view(scene, SIZE)
        reference = embree(scene, camera)
        rows = ours(scene, camera, reference)
        rows += [row("embreex, tracing alone", reference, reference)] if reference else []
        drawn = pyrender(scene, camera)
        rows += [row("pyrender, depth alone", drawn, reference)] if drawn else []
        print(table(f"Ground truth, 1080p, {name}, {scene.triangle_count:,} triangles", header, rows))
        print(table(f"Anti-aliasing, 480x270, {name}", header, by_samples(scene)))


if __name__ == "__main__":
    main()
