"""Objects visible to a user beside the centre, ring by ring, and as geometry by falling footprint (vis1), by bytes.

python -m benchmarks.stream.seen [--quick] [--plots out/bench]
"""

from __future__ import annotations

import argparse
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness.timing import machine, table
from benchmarks.stream.maps import whole_range
from nearfar import _core
from nearfar.stream import _map_files as codec
from nearfar.stream._encode import scale_of
from nearfar.stream._radii import PUBLISHED

EYE_HEIGHT = 1.3
"""Height of the user's eyes in CloVR (2024), metres."""
TEXELS = 3
"""Texels of maps along a pixel of the pictures in which objects are counted: odd, so that a pixel's centre is a texel's
centre. Between texels, the outlines of all objects would move by half a texel."""
PARTS = 8
"""Number of parts of the geometry, with equal numbers of objects, after which vis1 is counted."""
STEP = 2.0**-10
"""Step of positions in metres, as in bundles."""

Point = tuple[float, float, float]
Row = tuple[str, int, float, float]
"""Picture, bytes that it needs, OVC and OFC."""


def faces_of(source: Any, eye: Point, size: int) -> Any:
    """Object numbers in all directions from a point, (6 S, S)."""
    views = [nf.Camera(eye, fov=nf.CubeFace(face), size=(size, size)) for face in range(6)]
    return np.concatenate([nf.render(source, view, channels=("object_id",)).require("object_id") for view in views])


def in_front_of_map(near: nf.Scene, env: nf.EnvMap, center: Point, morph: str) -> nf.ReducedScene:
    """Return whole objects in front of a map."""
    zones = nf.partition(near, center=center, r1=0.7 * PUBLISHED[-1], r2=PUBLISHED[-1])
    counts = {**zones.summary(), "rays": 0}
    return nf.ReducedScene(near, zones, env, morph=morph, boundary="r2", counts=counts, is_whole=False)


def clovr(scene: nf.Scene, maps: nf.stream.RingMaps, sent: list[int], size: int, user: Point) -> Iterator[Row]:
    """Yield the rows of ring after ring."""
    center = maps.rings.center
    truth = faces_of(scene, user, size)
    moving = scene.subset(objects=maps.rings.objects(0))
    still = in_front_of_map(moving, maps.map(0), center, "cylinder").with_growth(0.0)
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
    names = list(scene.object_names)
    nothing: list[str | None] = [None] * len(_core.scene_parts(scene._core)["textures"])
    export = _core.Export(scene._core, groups, PARTS + 1, names=names, images=nothing, step=STEP, compressed=True)
    shared = export.shared()
    uris: list[str | None] = [f"{number}.bin" for number in range(len(shared))]
    first = [min(users - {0}, default=0) for users in (set(groups) for _, groups, _ in shared)]
    sent = 0
    for number in range(1, PARTS + 1):
        sent += len(export.glb(number, uris=uris)[0])
        sent += sum(len(data) for (data, _, _), group in zip(shared, first, strict=True) if group == number)
        shown = scene.subset(objects=[scene.object_names[place] for place in order[part < number]])
        yield (
            f"vis1, {number}/{PARTS} of geometry",
            sent,
            *nf.metrics.object_completion(truth, faces_of(shown, user, size)),
        )
    whole = in_front_of_map(shown, maps.map(last), center, "none")
    picture = faces_of(whole, user, size)
    yield "vis1 with its map", sent + map_bytes, *nf.metrics.object_completion(truth, picture)


def sent_by_ring(bundle: nf.stream.Bundle) -> list[int]:
    """Bytes of rings and maps received up to each ring, without dynamic objects."""
    each = [row["geometry"] + row["color"] + row["range"] for row in bundle.summary()]
    return [sum(each[: ring + 1]) for ring in range(len(each))]


def map_bytes(maps: nf.stream.RingMaps, size: int) -> int:
    """Bytes of the last map as a whole, with range."""
    env = nf.stream.bake_maps(maps.rings, face_size=size).map(maps.rings.count)
    assert env.range is not None
    scale = scale_of(maps, 2.0**-11)
    ranges = sum(len(whole_range(face, scale.step)) for face in scale.codes(env.range))
    return ranges + sum(len(codec.encode_color(face, 90)) for face in env.color)


def draw(path: Path, found: dict[float, tuple[list[Row], list[Row]]]) -> None:
    """Draw OVC and OFC against bytes, a column for each place of the user."""
    import matplotlib as mpl

    mpl.use("agg")
    from matplotlib import pyplot as plt

    figure, grid = plt.subplots(2, len(found), figsize=(4.6 * len(found), 6), layout="constrained", squeeze=False)
    for column, (away, listed) in enumerate(found.items()):
        for rows, name, marker in zip(listed, ("rings", "vis1"), "os", strict=True):
            for axes, place in zip(grid[:, column], (2, 3), strict=True):
                axes.plot([row[1] / 1e6 for row in rows], [row[place] for row in rows], marker=marker, label=name)
        grid[0, column].set(title=f"user {away:g} m beside the centre", ylabel="OVC" if not column else "")
        grid[1, column].set(xlabel="MB received", ylabel="OFC" if not column else "")
    grid[0, 0].legend()
    figure.savefig(path, dpi=90)
    plt.close(figure)


def main() -> None:
    """Print the tables and draw the plot."""
    parse = argparse.ArgumentParser(description=__doc__)
    parse.add_argument("--quick", action="store_true", help="a smaller city and smaller pictures")
    parse.add_argument("--plots", type=Path, help="folder for plots")
    arguments = parse.parse_args()
    quick, size = arguments.quick, 128 if arguments.quick else 512
    scene = nf.datasets.city(blocks=3, detail=1) if quick else nf.datasets.city(blocks=9, detail=3)
    eye, _ = nf.datasets.street_view()
    center = (eye[0], EYE_HEIGHT, eye[2])
    print(machine())
    print(f"{scene.triangle_count:,} triangles, objects in all directions, 6 × {size}² pixels")
    with tempfile.TemporaryDirectory() as folder:
        bundle = nf.stream.export(scene, Path(folder) / "bundle", center=center, radii=PUBLISHED)
        sent = sent_by_ring(bundle)
    rings = nf.stream.assign(scene, center=center, radii=PUBLISHED)
    maps = nf.stream.bake_maps(rings, face_size=TEXELS * size, object_id=True)
    last = map_bytes(maps, 1024)
    found = {}
    for away in (1.0, 2.0):
        user = (center[0] - away, center[1], center[2])
        truth = nf.metrics.object_completion(faces_of(scene, user, size), faces_of(scene, center, size))
        found[away] = list(clovr(scene, maps, sent, size, user)), list(vis1(scene, maps, last, size, user))
        rows = [["truth at O", "", *(f"{share:.3f}" for share in truth)]]
        for name, count, ovc, ofc in (*found[away][0], *found[away][1]):
            rows.append([name, f"{count / 1e6:.2f}", f"{ovc:.3f}", f"{ofc:.3f}"])
        print(table(f"a user {away:g} m beside O", ["picture", "MB", "OVC", "OFC"], rows))
    if arguments.plots:
        arguments.plots.mkdir(parents=True, exist_ok=True)
        draw(arguments.plots / "stream_seen.png", found)


if __name__ == "__main__":
    main()
