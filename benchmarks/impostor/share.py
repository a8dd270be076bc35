"""Quads that neighbouring regions of a walk share: bytes for each metre, time and quality, with and without sharing."""

from __future__ import annotations

import time
from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness import scenes
from benchmarks.harness.pictures import similarity
from benchmarks.harness.report import start, table
from benchmarks.impostor.quality import R2, SAMPLES, misplaced, ring
from nearfar._impostor import file

REGIONS = 6
"""Number of regions along a street; every second one uses quads of the one before it."""


def size_of(impostors: nf.Impostors, *, new_only: bool) -> int:
    """Return the bytes of `far.glb`, with all quads or with those that the region before doesn't have."""
    quads = impostors._quads
    assert quads is not None
    if new_only:
        quads = quads.select(np.arange(len(quads)) >= quads.shared)
    return len(file.encode(quads, impostors._region).data)


def quality(scene: nf.Scene, impostors: nf.Impostors, users: list[nf.Camera]) -> list[float]:
    """Return the mean PSNR and SSIM, and the shares in percent of missing pixels and of those at another depth."""
    rows = []
    for user in users:
        truth, frame = (
            nf.render(source, user, samples=SAMPLES, channels=("color", "range")) for source in (scene, impostors)
        )
        rows.append([*similarity(truth, frame), *misplaced(truth, frame, impostors.reach)])
    return [float(value) for value in np.mean(rows, axis=0)]


def rows_of(scene: nf.Scene, reach: float, settings: dict[str, Any], size: tuple[int, int], count: int) -> list[Any]:
    """Make the regions of a street, and every second one also by itself; return a row for each kind."""
    eye, _ = nf.datasets.street_view()
    hysteresis = min(1.0, 0.25 * reach)
    length = REGIONS * np.sqrt(3.0) * (reach - hysteresis)
    street = np.add(eye, [(0.0, 0.0, 0.0), (length - reach, 0.0, 0.0)])
    regions = nf.regions(
        scene, street, far="impostors", reach=reach, hysteresis=hysteresis, r2=R2, keep=REGIONS, **settings
    )
    found: dict[str, list[list[float]]] = {"first": [], "alone": [], "shared": []}
    for number in range(REGIONS):
        made: dict[str, tuple[nf.Impostors, float]] = {}
        since = time.perf_counter()
        region = regions.reduced(number)
        assert isinstance(region, nf.Impostors)
        made["first" if number % 2 == 0 else "shared"] = region, time.perf_counter() - since
        if number % 2:
            since = time.perf_counter()
            alone = nf.reduce(scene, center=region.center, r2=R2, far="impostors", settings=region.settings)
            made["alone"] = alone, time.perf_counter() - since
        users = ring(scene, region.center, reach, size, count)
        for name, (impostors, seconds) in made.items():
            stats = impostors.stats
            counts = [stats["triangles"], 100.0 * stats["shared_quads"] / stats["quads"]]
            sizes = [size_of(impostors, new_only=new_only) / 1e3 for new_only in (False, True)]
            found[name].append([seconds, *counts, *sizes, *quality(scene, impostors, users)])
    means = {name: np.mean(values, axis=0).tolist() for name, values in found.items()}
    first = means["first"][4]
    return [
        [reach, name, (first + means[name][4]) / (2.0 * regions.spacing), *means[name]] for name in ("alone", "shared")
    ]


HEADER = (
    "reach, m {:g} | every second region | kB/m {:.1f} | its bake, s {:.1f} | triangles {:,.0f} | shared, % {:.0f}"
    " | kB {:.0f} | new kB {:.0f} | PSNR, dB {:.1f} | SSIM {:.3f} | missing, % {:.3f} | off, % {:.2f}"
)


def main() -> None:
    arguments = start(__doc__, "--quick", users=(6, "users of each region"), reaches=[8.0, 4.0])
    size = (240, 136) if arguments.quick else (960, 540)
    settings: dict[str, Any] = {"face_size": 128, "centers": 3} if arguments.quick else {}
    city, rows = scenes.city(arguments.quick), list[list[Any]]()
    for reach in arguments.reaches[:1] if arguments.quick else arguments.reaches:
        rows += rows_of(city, reach, settings, size, arguments.users)
        print(*rows[-2:], sep="\n", flush=True)
    print(table(f"Regions of a street, {size[0]} × {size[1]}, {SAMPLES} samples", HEADER, rows))


if __name__ == "__main__":
    main()
