"""Tear along the end of the near part, for users and views chosen at random: both methods, two pairs of radii.

python -m benchmarks.reduce.tear [--quick]
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness.timing import machine, table
from benchmarks.harness.views import Point, center_for
from nearfar._base import data

REACH = 8.0
"""Greatest distance of users from the centre, metres."""

DENSITY = 20.0
"""Pixels for each degree where the camera looks, as a headset has them."""

LEAST_EDGE = {False: 200, True: 40}
"""Least number of boundary pixels with both sides in view, so that a view counts: of all, and of surfaces across r₂."""

MOST_TRIES = 60


def cases(quick: bool) -> Iterator[tuple[str, nf.Scene, Point]]:
    """Yield the name, the scene and a centre of each available city."""
    for name, file in (
        ("centre of Tokyo", "city/tokyo23/tokyo_core_lod1.glb"),
        ("Manhattan", "city/manhattan_deckgl/manhattan_core.glb"),
    ):
        if not quick and (path := data.find(file)) is not None:
            scene = nf.Scene.load(path)
            yield name, scene, center_for(scene, 50.0)
    city = nf.datasets.city(blocks=3, detail=0) if quick else nf.datasets.city()
    yield "procedural city", city, nf.datasets.street_view()[0]


def views(center: Point, seed: int) -> Iterator[nf.Camera]:
    """Yield views of users anywhere within `REACH` who look anywhere, slightly down."""
    draw = np.random.default_rng(seed)
    fov = nf.Fov.symmetric(60, 16 / 9)
    width = round(DENSITY * float(np.degrees(fov.right - fov.left)))
    for _ in range(MOST_TRIES):
        around, ahead = draw.uniform(0.0, 2.0 * np.pi, 2)
        away = REACH * np.sqrt(draw.uniform())
        user = np.add(center, (away * np.cos(around), 0.0, away * np.sin(around)))
        toward = np.add(user, (np.cos(ahead), -0.05, np.sin(ahead)))
        yield nf.Camera.look_at(user, toward, fov=fov, size=(width, round(width * 9 / 16)))


def pictures(reduced: nf.ReducedScene, camera: nf.Camera) -> list[nf.Frame]:
    """Positions of the conventional and of the continuous picture, with a far part of unlimited resolution."""
    frames = []
    for morph, method in (("none", "auto"), ("blend", "exact")):
        how: dict[str, Any] = {"method": method, "env": False, "channels": ("position",)}
        frames.append(reduced.with_morph(morph).render(camera, **how))
    return frames


def measured(reduced: nf.ReducedScene, frames: list[nf.Frame], *, surfaces: bool) -> list[nf.BoundaryTear] | None:
    """Tears of both pictures; None if too little of the boundary is in view."""
    where: dict[str, Any] = {"center": reduced.center, "radius": reduced.r2, "surfaces": surfaces}
    both = [nf.boundary_tear(frame, **where) for frame in frames]
    is_seen = all(one.tear is not None and _count(one) >= LEAST_EDGE[surfaces] for one in both)
    return both if is_seen else None


def tears(name: str, scene: nf.Scene, center: Point, count: int, seed: int) -> str:
    """Table of both methods at 30 and 50 m, and at the chosen radii; means over all pixels of all views."""
    chosen = nf.choose_radii(scene, center, r2=50.0, reach=REACH)
    rows = []
    for r1 in (30.0, chosen.r1):
        reduced = nf.reduce(scene, center=center, r1=r1, r2=50.0, face_size=16, samples=1)
        taken: dict[bool, list[list[nf.BoundaryTear]]] = {False: [], True: []}
        for camera in views(center, seed):
            frames = pictures(reduced, camera)
            for surfaces, found in taken.items():
                both = measured(reduced, frames, surfaces=surfaces)
                if both is not None:
                    found.append(both)
            if len(taken[False]) == count:
                break
        rows += [_row(r1, surfaces, found) for surfaces, found in taken.items()]
    header = ["r₁, r₂, m", "where", "views", "conventional, px", "continuous, px", "of which kink", "ratio"]
    return table(f"Tear along r₂, {name}, {DENSITY:g} pixels a degree", [*header, "ratio by view"], rows)


def _row(r1: float, surfaces: bool, taken: list[list[nf.BoundaryTear]]) -> list[str]:
    if not taken:
        return [f"{r1:.3g}, 50", _PLACES[surfaces], "0", *["–"] * 5]
    pixels, tear, kink = (np.array([[get(one) for one in both] for both in taken]) for get in _PARTS)
    mean = (tear * pixels).sum(axis=0) / pixels.sum(axis=0)
    bend = (kink * pixels).sum(axis=0) / pixels.sum(axis=0)
    shares = np.sort(tear[:, 0] / tear[:, 1])
    spread = f"{shares[0]:.2g} to {shares[-1]:.2g}"
    values = [f"{mean[0]:.3g}", f"{mean[1]:.3g}", f"{bend[1]:.2g}", f"{mean[0] / mean[1]:.3g}", spread]
    return [f"{r1:.3g}, 50", _PLACES[surfaces], f"{len(taken)}", *values]


def _count(one: nf.BoundaryTear) -> float:
    return one.pixels * (one.shared or 0.0)


def _tear(one: nf.BoundaryTear) -> float:
    return one.tear or 0.0


def _kink(one: nf.BoundaryTear) -> float:
    return one.kink or 0.0


_PARTS = (_count, _tear, _kink)
_PLACES = {False: "whole boundary", True: "surfaces across r₂"}


def main() -> None:
    """Print a table for each city."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="a small city only")
    parser.add_argument("--views", type=int, default=6)
    parser.add_argument("--seed", type=int, default=7)
    arguments = parser.parse_args()
    print(machine())
    for name, scene, center in cases(arguments.quick):
        print(tears(name, scene, center, 2 if arguments.quick else arguments.views, arguments.seed))


if __name__ == "__main__":
    main()
