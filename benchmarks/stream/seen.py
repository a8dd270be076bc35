"""Objects visible to a user beside the centre, ring by ring, and as geometry by falling footprint (vis1), by bytes."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness.report import folder_or_temporary, save_figure, start, subplots, table
from benchmarks.stream._near import exporter, in_front_of_map, large_city, street_center
from benchmarks.stream.maps import whole_range
from nearfar.stream import _map_files as codec
from nearfar.stream._encode import scale_of
from nearfar.stream._radii import PUBLISHED

TEXELS = 3
"""Texels of maps per pixel side of the pictures in which objects are counted: odd, so that a pixel's centre is a
texel's centre. Otherwise all outlines would move by half a texel."""
PARTS = 8
"""Number of parts with equal numbers of objects; objects visible by vis1 are counted after each part."""

Point = tuple[float, float, float]
Row = tuple[str, int, float, float]
"""Picture, bytes that it needs, OVC and OFC."""


def faces_of(source: Any, eye: Point, size: int) -> Any:
    """Object numbers in all directions from a point, (6 S, S)."""
    views = [nf.Camera(eye, fov=nf.CubeFace(face), size=(size, size)) for face in range(6)]
    return np.concatenate([nf.render(source, view, channels=("object_id",)).require("object_id") for view in views])


def clovr(scene: nf.Scene, maps: nf.stream.RingMaps, sent: list[int], size: int, user: Point) -> Iterator[Row]:
    """Yield the rows of ring after ring."""
    center = maps.rings.center
    truth = faces_of(scene, user, size)
    still = in_front_of_map(scene.subset(objects=maps.rings.objects(0)), maps.map(0)).with_growth(0.0)
    yield "ring 0", sent[0], *nf.metrics.object_completion(truth, faces_of(still, user, size))
    for ring, radius in enumerate(maps.rings.radii, 1):
        reduced = nf.reduce(scene, center=center, r1=0.7 * radius, r2=radius, unit="object", morph="cylinder",
                            channels=("color", "range", "object_id"), face_size=TEXELS * size, samples=1)  # fmt: skip
        picture = faces_of(reduced, user, size)
        yield f"ring {ring}, to {radius:g} m", sent[ring], *nf.metrics.object_completion(truth, picture)


def vis1(scene: nf.Scene, maps: nf.stream.RingMaps, map_bytes: int, size: int, user: Point) -> Iterator[Row]:
    """Yield the rows of near objects visible from O, by falling footprint and without a morph; the map comes last."""
    center, last = maps.rings.center, maps.rings.count
    truth = faces_of(scene, user, size)
    weights = nf.stream.footprints(scene, center=center)
    near = np.flatnonzero((maps.rings.ring >= 1) & (maps.rings.ring <= last) & (weights > 0.0))
    order = near[np.argsort(-weights[near], kind="stable")]
    part = np.arange(len(order)) * PARTS // len(order)
    groups = np.zeros(len(scene.object_names) + 1, np.uint16)
    groups[order] = part + 1
    export = exporter(scene, groups, PARTS + 1, named=True, images=False, compressed=True)
    shared = export.shared()
    uris: list[str | None] = [f"{number}.bin" for number in range(len(shared))]
    first = [min(users - {0}, default=0) for users in (set(groups) for _, groups, _ in shared)]
    sent = 0
    for number in range(1, PARTS + 1):
        sent += len(export.glb(number, uris=uris)[0])
        sent += sum(len(data) for (data, _, _), group in zip(shared, first, strict=True) if group == number)
        sent_scene = scene.subset(objects=[scene.object_names[place] for place in order[part < number]])
        completion = nf.metrics.object_completion(truth, faces_of(sent_scene, user, size))
        yield f"vis1, {number}/{PARTS} of geometry", sent, *completion
    picture = faces_of(in_front_of_map(sent_scene, maps.map(last), "none"), user, size)
    yield "vis1 with its map", sent + map_bytes, *nf.metrics.object_completion(truth, picture)


def map_bytes(maps: nf.stream.RingMaps, size: int) -> int:
    """Bytes of the last map as a whole, with range."""
    env = nf.stream.bake_maps(maps.rings, face_size=size, samples=1).map(maps.rings.count)
    assert env.range is not None
    scale = scale_of(maps, 2.0**-11)
    ranges = sum(len(whole_range(face, scale.step)) for face in scale.codes(env.range))
    return ranges + sum(len(codec.encode_color(face, 90)) for face in env.color)


def draw(path: Path, results: dict[float, tuple[list[Row], list[Row]]]) -> None:
    figure, grid = subplots(2, len(results), figsize=(4.6 * len(results), 6), squeeze=False)
    for column, (distance, strategies) in enumerate(results.items()):
        for rows, name, marker in zip(strategies, ("rings", "vis1"), "os", strict=True):
            for axes, place in zip(grid[:, column], (2, 3), strict=True):
                axes.plot([row[1] / 1e6 for row in rows], [row[place] for row in rows], marker=marker, label=name)
        grid[0, column].set(title=f"user {distance:g} m beside the centre", ylabel="OVC" if not column else "")
        grid[1, column].set(xlabel="MB received", ylabel="OFC" if not column else "")
    grid[0, 0].legend()
    save_figure(figure, path, dpi=90)


def main() -> None:
    options = start(__doc__, "--quick", "--plots")
    scene, center, size = large_city(options.quick), street_center(), 128 if options.quick else 512
    print(f"{scene.triangle_count:,} triangles, objects in all directions, 6 × {size}² pixels")
    with folder_or_temporary() as folder:
        bundle = nf.stream.export(scene, folder / "bundle", center=center, radii=PUBLISHED)
        # Bytes of rings and maps received up to each ring, without dynamic objects.
        sent = np.cumsum([row["geometry"] + row["color"] + row["range"] for row in bundle.summary()]).tolist()
    rings = nf.stream.assign(scene, center=center, radii=PUBLISHED)
    maps = nf.stream.bake_maps(rings, face_size=TEXELS * size, samples=1, object_id=True)
    last = map_bytes(maps, 1024)
    results = {}
    for distance in (1.0, 2.0):
        user = (center[0] - distance, center[1], center[2])
        truth = nf.metrics.object_completion(faces_of(scene, user, size), faces_of(scene, center, size))
        results[distance] = list(clovr(scene, maps, sent, size, user)), list(vis1(scene, maps, last, size, user))
        pictures = (*results[distance][0], *results[distance][1])
        rows: list[list[object]] = [["truth at O", None, *truth]]
        rows += [[name, count / 1e6, ovc, ofc] for name, count, ovc, ofc in pictures]
        print(table(f"a user {distance:g} m beside O", "picture | MB {:.2f} | OVC {:.3f} | OFC {:.3f}", rows))
    if options.plots:
        draw(options.plots / "stream_seen.png", results)


if __name__ == "__main__":
    main()
