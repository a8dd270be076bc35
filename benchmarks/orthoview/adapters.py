"""Pictures of a tree on graphics adapters: frame times, splats per second, bytes of views, against the processor's.

    python -m benchmarks.orthoview.adapters TREE

An eye looks at the middle of the tree. The error of the cut is reduced until its views have the requested number of
splats, 25 million as in the paper. Both kinds of atomic integers are measured if an adapter supports those of 64 bits.
Without a GPU the adapters are software on the processor (lavapipe, llvmpipe).
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Sequence
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness.timing import best, machine, table
from benchmarks.orthoview._sheets import save_panels
from benchmarks.orthoview.splats import eye
from nearfar import _core
from nearfar._camera.shot import Shot
from nearfar._render import backend as backends

SIZES = {"640x480": ((640, 480),), "2x1832x1920": ((1832, 1920), (1832, 1920))}
DIFFERENCE = 2e-3
"""Least difference of linear colours at which pixels count as different."""
MIN = 0.05
"""Least error of a cut, pixels."""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("tree", type=Path, help="store that nf.orthoview.build wrote")
    parser.add_argument("--millions", type=float, default=25.0, help="splats of the views")
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--sizes", nargs="*", choices=SIZES, default=list(SIZES), help="sizes of the pictures")
    parser.add_argument("--picture", type=Path, help="file of both pictures and their differences")
    given = parser.parse_args()
    print(machine(), "\n")
    tree = nf.orthoview.open(given.tree)
    camera = eye(tree, 0.1)
    cut, splats = gathered(tree, camera, given.millions * 1e6)
    count = sum(view.count for view in splats)
    print(f"{tree}: {len(cut)} cells, {len(splats)} views, {count / 1e6:.1f} million splats\n")
    print(sizes(splats))
    if given.picture is not None:
        save_pictures(given.picture, tree)
    for name in given.sizes:
        cameras = [
            nf.Camera(camera.position, camera.orientation, fov=fov_of_size(shape), size=shape) for shape in SIZES[name]
        ]
        for grid in (1, 4):
            print(frames(f"{name}, {grid} × {grid} samples", splats, cameras, grid, given.repeat))


def fov_of_size(shape: tuple[int, int]) -> nf.Fov:
    return nf.Fov.symmetric(60, shape[0] / shape[1])


def gathered(
    tree: nf.orthoview.OrthoTree, camera: nf.Camera, wanted: float
) -> tuple[nf.orthoview.OrthoCut, list[_core.OrthoSplats]]:
    """Find a cut whose views have the wanted number of splats, or the finest one."""
    error = 4.0
    while True:
        cut = tree.cut(camera, geometry=False, error_px=error)
        splats = tree._viewer.views.get(cut.keys())
        if sum(view.count for view in splats) >= wanted or error <= MIN:
            return cut, splats
        error *= 0.93


def sizes(splats: Sequence[_core.OrthoSplats]) -> str:
    """Bytes of views on the processor and on adapters, and of the formats that graphics cards decode."""
    count, views = sum(view.count for view in splats), len(splats)
    on_adapters = sum(view.compressed_bytes for view in splats)
    rows: list[tuple[str, float]] = [
        ("on the processor", sum(view.bytes for view in splats)),
        ("on adapters, without loss", on_adapters),
        ("BC1 colour, BC5 normal, R16 depth of shown pixels alone, with loss", 3.5 * count),
    ]
    header = ["views", "MB", "kB a view", "bytes a splat"]
    return table(
        "Memory", header, [[name, f"{n / 1e6:.1f}", f"{n / views / 1e3:.1f}", f"{n / count:.2f}"] for name, n in rows]
    )


def frames(
    title: str, splats: Sequence[_core.OrthoSplats], cameras: Sequence[nf.Camera], grid: int, repeat: int
) -> str:
    """Table of the times of the pictures of all cameras."""
    settings = [Shot(cameras=(camera,), channels=("color",)).settings for camera in cameras]

    def draw(device: _core.GpuDevice | None = None) -> list[dict[str, Any]]:
        return [
            _core.splat_orthoviews(splats, camera._core, own, origin=(0.0, 0.0, 0.0), grid=grid, device=device)
            for camera, own in zip(cameras, settings, strict=True)
        ]

    right, rows = draw(), []
    seen = sum(picture["stats"]["splats_seen"] for picture in right)
    timing = best(draw, repeat=repeat)
    rows.append(["processor", "", f"{timing.wall * 1e3:.1f}", f"{seen / timing.wall / 1e6:.1f}", "1", ""])
    for adapter in nf.gpu.adapters():
        if not adapter.usable:
            continue
        device = backends.open_device(adapter.backend)
        for allowed in (True, False):
            before = device.allow_long_atomics(allowed)
            if allowed and not device.uses_long_atomics:
                continue
            start = time.perf_counter()
            pictures = draw(device)
            first = time.perf_counter() - start
            wall = best(partial(draw, device), repeat=repeat).wall
            device.allow_long_atomics(before)
            drawn = sum(picture["stats"]["splats_seen"] for picture in pictures)
            same = [
                np.isclose(a["color"], b["color"], atol=DIFFERENCE).all(-1).mean()
                for a, b in zip(pictures, right, strict=True)
            ]
            rows.append(
                [
                    f"{device.label}, {64 if allowed else 32} bits",
                    f"{first * 1e3:.0f}",
                    f"{wall * 1e3:.1f}",
                    f"{drawn / wall / 1e6:.1f}",
                    f"{timing.wall / wall:.2f}",
                    f"{100 * (1 - float(np.mean(same))):.3f} %",
                ]
            )
    header = ["way", "first ms", "ms", "million seen a second", "× the processor", "pixels that differ"]
    return table(title, header, rows)


def save_pictures(path: Path, tree: nf.orthoview.OrthoTree) -> None:
    """Save a picture by the processor, by an adapter, and the differing pixels in white."""
    camera = eye(tree, 0.1)
    settings: dict[str, Any] = {"samples": 16, "channels": ("color",), "geometry": False}
    one, other = (tree.render(camera, **settings, backend=name).require("color") for name in ("cpu", "gpu"))
    differs = np.abs(one - other).max(axis=-1, keepdims=True) > DIFFERENCE
    print(f"{100 * differs.mean():.3f} % of the pixels differ by more than {DIFFERENCE}\n")
    panels = [
        ("by the processor", one),
        ("by an adapter", other),
        ("pixels that differ", np.repeat(differs, 3, axis=-1)),
    ]
    codes = [
        (title, _core.encode_srgb(np.float32(picture).ravel()).reshape(picture.shape)) for title, picture in panels
    ]
    save_panels(codes, len(codes), path)


if __name__ == "__main__":
    main()
