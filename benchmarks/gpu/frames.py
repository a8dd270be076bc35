"""Times and uploads of frames on graphics adapters, full and reduced, compared with the tracer and pyrender.

`python -m benchmarks.gpu.frames`. Without a GPU the adapters are software on the processor (lavapipe, llvmpipe). With
one, the last table gives the time of a headset's frames on it.
"""

from __future__ import annotations

import importlib.util
import os
import time
import warnings
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness import tokyo
from benchmarks.harness.compare import FOLDER, Case, compare, comparisons, describe
from benchmarks.harness.timing import machine, table
from benchmarks.harness.views import center_for
from benchmarks.render.truth import view

SIZE = (1024, 1024)
EYE = (1832, 1920)
"""Width and height of a headset's eye, pixels."""
CHANNELS = ("color", "range", "object_id")
NEAR, FAR = 30.0, 50.0


def adapters() -> list[str]:
    return [adapter.backend for adapter in nf.gpu.adapters() if adapter.usable]


def on(adapter: str, job: Callable[[], Any]) -> Callable[[], Any]:
    """Wrap a job so that it runs on an adapter."""

    def selected() -> Any:
        nf.gpu.select(adapter)
        return job()

    return selected


def drawn_by_pyrender(scene: nf.Scene, camera: nf.Camera) -> list[Case]:
    """Time pyrender with lighting in one colour, and with depth alone, without the upload."""
    if not importlib.util.find_spec("pyrender"):
        return []
    os.environ.setdefault("PYOPENGL_PLATFORM", "egl")
    vars(np).setdefault("infty", np.inf)  # pyrender 0.1.45 was written for NumPy 1
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        import pyrender as peer

    corners = scene.triangles()
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-20)
    whole: Any = peer.Scene(ambient_light=(0.3, 0.3, 0.3))
    flat = corners.reshape(-1, 3)
    whole.add(peer.Mesh([peer.Primitive(positions=flat, normals=np.repeat(normals, 3, axis=0))]))
    rays = camera.rays()[1]
    pose = np.eye(4)
    right, down = rays[0, -1] - rays[0, 0], rays[-1, 0] - rays[0, 0]
    pose[:3, 0], pose[:3, 1] = right / np.linalg.norm(right), -down / np.linalg.norm(down)
    pose[:3, 2] = np.cross(pose[:3, 0], pose[:3, 1])
    pose[:3, 3] = np.array(camera.position) - scene.origin
    assert isinstance(camera.fov, nf.Fov)
    whole.add(peer.PerspectiveCamera(2 * np.arctan(camera.fov.up), 1.0, 1e4, SIZE[0] / SIZE[1]), pose=pose)
    whole.add(peer.DirectionalLight(intensity=3.0), pose=pose)
    renderer = peer.OffscreenRenderer(*SIZE)
    both_sides = peer.RenderFlags.SKIP_CULL_FACES
    ways = {"lit": both_sides, "flat": both_sides | peer.RenderFlags.FLAT}
    ways["depth alone"] = both_sides | peer.RenderFlags.DEPTH_ONLY
    return [Case(f"pyrender, {name}", partial(renderer.render, whole, flags)) for name, flags in ways.items()]


def frames(scene: nf.Scene, camera: nf.Camera) -> str:
    """Table of frames with colour, range and ids, including read-back; errors of range compared with the tracer's."""
    exact = nf.render(scene, camera, channels=("range", "face_id"), backend="cpu")

    def error(frame: nf.Frame) -> float:
        other = nf.render(scene, camera, channels=("range", "face_id"), backend="gpu")
        same = (exact.require("face_id") == other.require("face_id")) & np.isfinite(exact.require("range"))
        expected, got = exact.require("range")[same], frame.require("range")[same]
        return float(np.percentile(np.abs(got - expected) / expected, 99.9))

    job = partial(nf.render, scene, camera, channels=CHANNELS, backend="gpu")
    cases = [Case(f"nearfar, {name}", on(name, job), error, peer=False) for name in adapters()]
    traced = partial(nf.render, scene, camera, channels=CHANNELS, backend="cpu")
    cases.append(Case("nearfar, traced", traced, peer=False))
    title = f"Frames of {scene.triangle_count:,} triangles at {SIZE[0]} x {SIZE[1]}, colour, range and ids"
    text = compare(title, [*cases, *drawn_by_pyrender(scene, camera)], repeat=3, unit="99.9 % of ranges")
    draw(scene, camera, title)
    return text


def draw(scene: nf.Scene, camera: nf.Camera, title: str) -> None:
    """Save a picture: a frame, the pixels whose faces differ from the tracer's, and the times."""
    folder = os.environ.get(FOLDER)
    if not folder:
        return
    import matplotlib as mpl

    mpl.use("Agg")
    from matplotlib import pyplot as plt

    traced, drawn = (
        nf.render(scene, camera, channels=("color", "face_id"), backend=backend) for backend in ("cpu", "gpu")
    )
    differ = traced.require("face_id") != drawn.require("face_id")
    figure, (left, middle, right) = plt.subplots(1, 3, figsize=(13, 4.2), layout="constrained")
    left.imshow(drawn.to_image())
    left.set_title(f"{scene.triangle_count:,} triangles, drawn")
    middle.imshow(drawn.to_image() // 3 + 160, alpha=0.5)
    rows, columns = np.nonzero(differ)
    middle.scatter(columns, rows, s=2, color="red")
    middle.set_title(f"{differ.sum()} of {differ.size:,} pixels show another face than the tracer's")
    results = [result for result in comparisons[title].results if result.name != "pyrender, lit"]
    right.barh([result.name for result in results], [1e3 * result.timing.wall for result in results])
    lit = [result.timing.wall for result in comparisons[title].results if result.name == "pyrender, lit"]
    right.set_xlabel("ms a frame" + "".join(f" (pyrender, lit: {1e3 * wall:.0f})" for wall in lit))
    right.invert_yaxis()
    for axes in (left, middle):
        axes.axis("off")
    figure.savefig(Path(folder) / "gpu.png", dpi=80)
    plt.close(figure)


def seconds(job: Callable[[], Any], rounds: int = 3) -> float:
    """Least time of some rounds in seconds, after one that uploads data."""
    job()
    timings = []
    for _ in range(rounds):
        started = time.perf_counter()
        job()
        timings.append(time.perf_counter() - started)
    return min(timings)


def whole_city() -> nf.Scene:
    """Tokyo, or the procedural city if there is no data."""
    arrays = tokyo.with_buildings()
    return nf.datasets.city() if arrays is None else nf.Scene.from_arrays(arrays[0], arrays[1], face_object=arrays[2])


def near_and_far(scene: nf.Scene) -> str:
    """Table of times and triangles of a reduced and a full frame of a scene."""
    center = center_for(scene, FAR)
    camera = nf.Camera.look_at(
        np.add(center, (2.0, 0.2, 1.0)), np.add(center, (0.0, 2.0, -40.0)), fov=nf.Fov.symmetric(90), size=SIZE
    )
    rows = []
    for name in adapters():
        nf.gpu.select(name)
        started = time.perf_counter()
        nf.render(scene, camera, backend="gpu")
        first = time.perf_counter() - started
        before = nf.gpu.stats()["triangles"]
        full = seconds(partial(nf.render, scene, camera, backend="gpu"))
        drawn = (nf.gpu.stats()["triangles"] - before) // 4
        reduced = nf.reduce(scene, center=center, r1=NEAR, r2=FAR, channels=CHANNELS, backend="gpu")
        light = seconds(partial(reduced.render, camera, backend="gpu"))
        triangles = max(reduced.render(camera, backend="gpu").stats["frame_triangles"], 1)
        rows.append(
            [
                *(name, *(f"{1e3 * value:.0f}" for value in (first, full, light)), f"{full / light:.1f}"),
                *(f"{drawn:,}", f"{triangles:,}", f"{drawn / triangles:.0f}"),
            ]
        )
    header = ["adapter", "first ms", "full ms", "reduced ms", "ratio", "triangles in view", "reduced", "ratio"]
    return table(f"Reduced frames (r2 = {FAR:g} m) of {scene.triangle_count:,} triangles", header, rows)


def path(scene: nf.Scene, camera: nf.Camera, count: int = 20) -> str:
    """Table of frames one by one and as a path (the next starts before one is read), with allocations and uploads."""
    x, y, z = camera.position
    cameras = [
        nf.Camera((x + 0.05 * i, y, z), camera.orientation, fov=camera.fov, size=camera.size) for i in range(count)
    ]
    rows = []
    for name in adapters():
        nf.gpu.select(name)
        alone = seconds(partial(one_by_one, scene, cameras), 2) / count
        walk(scene, cameras)
        before = nf.gpu.stats()
        ahead = seconds(partial(walk, scene, cameras), 2) / count
        after = nf.gpu.stats()
        allocations = after["allocations"] - before["allocations"]
        sent = (after["uploaded_bytes"] - before["uploaded_bytes"]) / (3 * count)
        rows.append([name, f"{1e3 * alone:.0f}", f"{1e3 * ahead:.0f}", str(allocations), f"{sent:.0f}"])
    header = ["adapter", "ms a frame", "ms in a path", f"buffers made in {3 * count} frames", "bytes sent a frame"]
    return table(f"Paths of {scene.triangle_count:,} triangles", header, rows)


def one_by_one(scene: nf.Scene, cameras: list[nf.Camera]) -> None:
    for camera in cameras:
        nf.render(scene, camera, channels=("color",), backend="gpu")


def walk(source: nf.Scene | nf.ReducedScene, cameras: list[nf.Camera]) -> int:
    """Draw and read colour along a path; returns the number of frames."""
    return sum(1 for _ in nf.render_path(source, cameras, channels=("color",), backend="gpu"))


def headset(scene: nf.Scene) -> str:
    """Table for both eyes of a headset, full and reduced, and a map of 6 x 2048 x 2048, if there is a GPU."""
    hardware = [adapter for adapter in nf.gpu.adapters() if adapter.usable and adapter.kind != "software"]
    if not hardware:
        return "No GPU: a headset's frames are not timed on the processor.\n"
    nf.gpu.select(hardware[0].backend)
    center = center_for(scene, FAR)
    target = np.add(center, (0.0, 2.0, -40.0))
    eyes = [
        nf.Camera.look_at(np.add(center, (x, 0.0, 0.0)), target, fov=nf.Fov.symmetric(95), size=EYE)
        for x in (-0.032, 0.032)
    ]
    started = time.perf_counter()
    nf.render(scene, eyes[0], channels=("color",), backend="gpu")
    first = time.perf_counter() - started
    reduced = nf.reduce(scene, center=center, r1=NEAR, r2=FAR, face_size=2048, backend="gpu")
    rows = []
    for name, source in (("full", scene), ("reduced", reduced)):
        both = seconds(partial(walk, source, 10 * eyes)) / 10
        frame = nf.gpu.render(source, eyes[0], channels=("color",))
        read = 2 * seconds(frame.read)
        rows.append([name, f"{1e3 * both:.1f}", f"{1 / both:.0f}", f"{1e3 * (both - read):.1f}", f"{1e3 * read:.1f}"])
    bake = seconds(lambda: nf.reduce(scene, center=center, r1=NEAR, r2=FAR, face_size=2048, backend="gpu"))
    text = table(
        f"2 x {EYE[0]} x {EYE[1]} of {scene.triangle_count:,} triangles on {hardware[0].name}",
        ["", "ms", "frames a second", "of it drawing", "of it reading"],
        rows,
    )
    return f"{text}\nfirst frame with its upload {first:.2f} s, map of 6 x 2048 x 2048 with 4 samples {bake:.2f} s\n"


def main() -> None:
    print(machine())
    print(describe())
    scene = nf.datasets.city(blocks=10, detail=1)
    camera = view(scene, SIZE)
    print(frames(scene, camera))
    print(path(scene, camera))
    city = whole_city()
    print(near_and_far(city))
    print(headset(city))


if __name__ == "__main__":
    main()
