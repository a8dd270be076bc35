"""Pictures of a tree on graphics adapters: frame times, splats per second, bytes of views, against the processor's.

An eye looks at the middle of the tree. The error of the cut is reduced until its views have the requested number of
splats, by default 25 million as in the paper. Adapters with 64-bit atomics are measured with 32-bit and with 64-bit
ones. Without a GPU the adapters are software on the processor (lavapipe, llvmpipe).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness.pictures import encode
from benchmarks.harness.report import start, table
from benchmarks.harness.timing import best, timed
from benchmarks.orthoview._sheets import save_panels
from benchmarks.orthoview.splats import eye
from nearfar import _core
from nearfar._camera.shot import Shot
from nearfar._render import backend as backends

SIZES = {"640x480": ((640, 480),), "2x1832x1920": ((1832, 1920), (1832, 1920))}
DIFFERENCE = 2e-3
"""Least difference of linear colours at which pixels count as different."""
MIN_ERROR_PX = 0.05
"""Least error of a cut, pixels."""


def main() -> None:
    options = start(
        __doc__,
        "tree",
        millions=(25.0, "splats of the views"),
        repeat=3,
        sizes={"nargs": "*", "choices": SIZES, "default": list(SIZES), "help": "sizes of the pictures"},
        picture=(Path, "file of both pictures and their differences"),
    )
    tree = nf.orthoview.open(options.tree)
    camera = eye(tree, 0.1)
    cut, splats = gather(tree, camera, options.millions * 1e6)
    count = sum(view.count for view in splats)
    print(f"{tree}: {len(cut)} cells, {len(splats)} views, {count / 1e6:.1f} million splats\n")
    print(sizes(splats))
    if options.picture is not None:
        save_pictures(options.picture, tree)
    for name in options.sizes:
        cameras = [replace(camera, fov=nf.Fov.symmetric(60, w / h), size=(w, h)) for w, h in SIZES[name]]
        for grid in (1, 4):
            print(frames(f"{name}, {grid} × {grid} samples", splats, cameras, grid, options.repeat))


def gather(
    tree: nf.orthoview.OrthoTree, camera: nf.Camera, min_splats: float
) -> tuple[nf.orthoview.OrthoCut, list[_core.OrthoSplats]]:
    """Find a cut whose views have at least `min_splats` splats, or else the cut of least error."""
    error = 4.0
    while True:
        cut = tree.cut(camera, geometry=False, error_px=error)
        splats = tree._viewer.views.get(cut.keys())
        if sum(view.count for view in splats) >= min_splats or error <= MIN_ERROR_PX:
            return cut, splats
        error *= 0.93


def sizes(splats: Sequence[_core.OrthoSplats]) -> str:
    """Bytes of views on the processor and on adapters, and of the formats that graphics cards decode."""
    count, views = sum(view.count for view in splats), len(splats)
    rows: dict[str, float] = {
        "on the processor": sum(view.bytes for view in splats),
        "on adapters, without loss": sum(view.compressed_bytes for view in splats),
        "BC1 colour, BC5 normal, R16 depth of non-empty pixels only, with loss": 3.5 * count,
    }
    header = "views | MB {:.1f} | kB a view {:.1f} | bytes a splat {:.2f}"
    return table("Memory", header, [(name, n / 1e6, n / views / 1e3, n / count) for name, n in rows.items()])


def frames(title: str, splats: list[_core.OrthoSplats], cameras: list[nf.Camera], grid: int, repeat: int) -> str:
    settings = [Shot(cameras=(camera,), channels=("color",)).settings for camera in cameras]

    def draw(device: _core.GpuDevice | None = None) -> list[dict[str, Any]]:
        return [
            _core.splat_orthoviews(splats, camera._core, shot, origin=(0.0, 0.0, 0.0), grid=grid, device=device)
            for camera, shot in zip(cameras, settings, strict=True)
        ]

    expected, timing = draw(), best(draw, repeat=repeat)
    splats_seen = sum(picture["stats"]["splats_seen"] for picture in expected)
    rows: list[list[object]] = [["processor", None, timing.ms, splats_seen / timing.wall / 1e6, "1", None]]
    for adapter in (adapter for adapter in nf.gpu.adapters() if adapter.usable):
        device = backends.open_device(adapter.backend)
        for long_atomics in (True, False):
            setting_before = device.allow_long_atomics(long_atomics)
            if long_atomics and not device.uses_long_atomics:
                continue
            pictures, first = timed(draw, device)
            time = best(partial(draw, device), repeat=repeat)
            device.allow_long_atomics(setting_before)
            seen = sum(picture["stats"]["splats_seen"] for picture in pictures)
            equal_shares = [
                np.isclose(a["color"], b["color"], atol=DIFFERENCE).all(-1).mean()
                for a, b in zip(pictures, expected, strict=True)
            ]
            rates = seen / time.wall / 1e6, timing.wall / time.wall
            name = f"{device.label}, {64 if long_atomics else 32} bits"
            rows.append([name, first.ms, time.ms, *rates, 100 * (1 - float(np.mean(equal_shares)))])
    header = "renderer | first ms {:.0f} | ms {:.1f} | million seen a second {:.1f} | × the processor {:.2f}"
    return table(title, header + " | pixels that differ {:.3f} %", rows)


def save_pictures(path: Path, tree: nf.orthoview.OrthoTree) -> None:
    """Save a picture by the processor, by an adapter, and the differing pixels in white."""
    camera = eye(tree, 0.1)
    settings: dict[str, Any] = {"samples": 16, "channels": ("color",), "geometry": False}
    cpu, gpu = (tree.render(camera, **settings, backend=name).require("color") for name in ("cpu", "gpu"))
    differs = np.abs(cpu - gpu).max(axis=-1, keepdims=True) > DIFFERENCE
    print(f"{100 * differs.mean():.3f} % of the pixels differ by more than {DIFFERENCE}\n")
    panels = {"by the processor": cpu, "by an adapter": gpu, "pixels that differ": np.repeat(differs, 3, axis=-1)}
    save_panels([(name, encode(rgb)) for name, rgb in panels.items()], len(panels), path)


if __name__ == "__main__":
    main()
