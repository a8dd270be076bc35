"""Times and uploads of frames on graphics adapters, full and reduced, compared with the tracer and pyrender.

`python -m benchmarks.gpu.frames`. Without a GPU the adapters are software on the processor (lavapipe, llvmpipe). With
one, the last table gives the time of a headset's frames on it.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness import opengl, tokyo
from benchmarks.harness.compare import OURS, Case, compare, comparisons, print_limits
from benchmarks.harness.report import save_figure, start, subplots, table
from benchmarks.harness.timing import best, timed
from benchmarks.harness.views import center_for
from benchmarks.render.truth import view

SIZE = (1024, 1024)
EYE = (1832, 1920)
"""Width and height of a headset's eye, pixels."""
CHANNELS = ("color", "range", "object_id")
NEAR, FAR = 30.0, 50.0
AHEAD = (0.0, 2.0, -40.0)
"""Where pictures look, relative to the centre, metres."""


def adapters() -> list[str]:
    return [adapter.backend for adapter in nf.gpu.adapters() if adapter.usable]


def on_adapter(adapter: str, job: Callable[[], Any]) -> Callable[[], Any]:
    """Wrap a job so that it runs on an adapter."""

    def selected() -> Any:
        nf.gpu.select(adapter)
        return job()

    return selected


def pyrender_cases(scene: nf.Scene, camera: nf.Camera) -> list[Case]:
    """Time pyrender with lighting in one colour, and with depth alone, without the upload."""
    peer = opengl.pyrender()
    if peer is None:
        return []
    corners = scene.triangles()
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-20)
    mesh = peer.Mesh([peer.Primitive(positions=corners.reshape(-1, 3), normals=np.repeat(normals, 3, axis=0))])
    peer_scene = opengl.scene_of(mesh, camera, origin=scene.origin, ambient_light=(0.3, 0.3, 0.3))
    peer_scene.add(peer.DirectionalLight(intensity=3.0), pose=opengl.pose_of(camera, scene.origin))
    renderer = peer.OffscreenRenderer(*SIZE)
    both_sides = peer.RenderFlags.SKIP_CULL_FACES
    flags_of = {"lit": both_sides, "flat": both_sides | peer.RenderFlags.FLAT}
    flags_of["depth alone"] = both_sides | peer.RenderFlags.DEPTH_ONLY
    return [Case(f"pyrender, {name}", partial(renderer.render, peer_scene, flags)) for name, flags in flags_of.items()]


def frames(scene: nf.Scene, camera: nf.Camera, plots: Path | None) -> str:
    """Table of frames with colour, range and ids, including read-back; errors of range compared with the tracer's."""
    exact = nf.render(scene, camera, channels=("range", "face_id"), backend="cpu")

    def error(frame: nf.Frame) -> float:
        drawn = nf.render(scene, camera, channels=("range", "face_id"), backend="gpu")
        has_same_face = (exact.require("face_id") == drawn.require("face_id")) & np.isfinite(exact.require("range"))
        expected, got = exact.require("range")[has_same_face], frame.require("range")[has_same_face]
        return float(np.percentile(np.abs(got - expected) / expected, 99.9))

    job = partial(nf.render, scene, camera, channels=CHANNELS)
    cases = [Case(f"{OURS}, {name}", on_adapter(name, partial(job, backend="gpu")), error) for name in adapters()]
    cases.append(Case(f"{OURS}, traced", partial(job, backend="cpu")))
    title = f"Frames of {scene.triangle_count:,} triangles at {SIZE[0]} x {SIZE[1]}, colour, range and ids"
    text = compare(title, [*cases, *pyrender_cases(scene, camera)], repeat=3, unit="99.9 % of ranges")
    if plots is not None:
        draw(scene, camera, title, plots)
    return text


def draw(scene: nf.Scene, camera: nf.Camera, title: str, folder: Path) -> None:
    """Save a picture: a frame, the pixels whose faces differ from the tracer's, and the times."""
    traced, drawn = (nf.render(scene, camera, channels=("color", "face_id"), backend=name) for name in ("cpu", "gpu"))
    differ = traced.require("face_id") != drawn.require("face_id")
    figure, (left, middle, right) = subplots(1, 3, figsize=(13, 4.2))
    left.imshow(drawn.to_image())
    left.set_title(f"{scene.triangle_count:,} triangles, drawn")
    middle.imshow(drawn.to_image() // 3 + 160, alpha=0.5)
    rows, columns = np.nonzero(differ)
    middle.scatter(columns, rows, s=2, color="red")
    middle.set_title(f"{differ.sum()} of {differ.size:,} pixels show another face than the tracer's")
    times = {result.name: result.timing.ms for result in comparisons[title].results}
    lit = times.pop("pyrender, lit", None)
    right.barh([*times], [*times.values()])
    right.set_xlabel("ms a frame" + (f" (pyrender, lit: {lit:.0f})" if lit else ""))
    right.invert_yaxis()
    for axes in (left, middle):
        axes.axis("off")
    save_figure(figure, folder / "gpu.png", dpi=80)


def near_and_far(scene: nf.Scene) -> str:
    center = center_for(scene, FAR)
    fov = nf.Fov.symmetric(90)
    camera = nf.Camera.look_at(np.add(center, (2.0, 0.2, 1.0)), np.add(center, AHEAD), fov=fov, size=SIZE)
    rows = []
    for name in adapters():
        nf.gpu.select(name)
        job = partial(nf.render, scene, camera, backend="gpu")
        _, first = timed(job)
        before = nf.gpu.stats()["triangles"]
        full = best(job, repeat=3)
        drawn = (nf.gpu.stats()["triangles"] - before) // 4
        reduced = nf.reduce(scene, center=center, r1=NEAR, r2=FAR, channels=CHANNELS, backend="gpu")
        light = best(partial(reduced.render, camera, backend="gpu"), repeat=3)
        triangles = max(reduced.render(camera, backend="gpu").stats["frame_triangles"], 1)
        impostors = nf.reduce(scene, far="impostors", center=center, r2=FAR)
        quads = best(partial(nf.render, impostors, camera, backend="gpu"), repeat=3)
        times = [first.ms, full.ms, light.ms, full.wall / light.wall, quads.ms, quads.wall / light.wall]
        rows.append([name, *times, drawn, triangles, drawn / triangles])
    header = (
        "adapter | first ms {:.0f} | full ms {:.0f} | reduced ms {:.0f} | ratio {:.1f} | with impostors ms {:.0f} |"
        " to reduced {:.2f} | triangles in view {:,}"
    )
    title = f"Reduced frames (r2 = {FAR:g} m) of {scene.triangle_count:,} triangles"
    return table(title, header + " | reduced {:,} | ratio {:.0f}", rows)


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
    target, fov = np.add(center, AHEAD), nf.Fov.symmetric(95)
    eyes = [nf.Camera.look_at(np.add(center, (x, 0, 0)), target, fov=fov, size=EYE) for x in (-0.032, 0.032)]
    _, first = timed(nf.render, scene, eyes[0], channels=("color",), backend="gpu")
    bake = partial(nf.reduce, scene, center=center, r1=NEAR, r2=FAR, face_size=2048, backend="gpu")
    rows = []
    for name, source in (("full", scene), ("reduced", bake())):
        seconds = best(partial(walk, source, 10 * eyes), repeat=3).wall / 10
        read = 2 * best(nf.gpu.render(source, eyes[0], channels=("color",)).read, repeat=3).wall
        rows.append([name, 1e3 * seconds, 1 / seconds, 1e3 * (seconds - read), 1e3 * read])
    title = f"2 x {EYE[0]} x {EYE[1]} of {scene.triangle_count:,} triangles on {hardware[0].name}"
    header = " | ms {:.1f} | frames a second {:.0f} | of it drawing {:.1f} | of it reading {:.1f}"
    baked = best(bake, repeat=3).wall
    note = f"first frame with its upload {first.wall:.2f} s, map of 6 x 2048 x 2048 with 4 samples {baked:.2f} s"
    return f"{table(title, header, rows)}\n{note}\n"


def main() -> None:
    options = start(__doc__, "--plots")
    print_limits()
    scene = nf.datasets.city(blocks=10, detail=1)
    camera = view(scene, SIZE)
    print(frames(scene, camera, options.plots))
    city = tokyo.scene_of_buildings() or nf.datasets.city()
    print(near_and_far(city))
    print(headset(city))


if __name__ == "__main__":
    main()
