"""Maps of rings as changes against whole maps: rays, seconds, bytes and PSNR; what is seen of objects, ring by ring.

python -m benchmarks.stream.maps [--quick]
"""

from __future__ import annotations

import argparse
import time
from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness.timing import machine, table
from nearfar import _core
from nearfar.stream import _map_files as codec
from nearfar.stream._encode import ACROSS, scale_of
from nearfar.stream._maps import TILE
from nearfar.stream._radii import PUBLISHED

QUALITY = 90
ERROR = 2.0**-11
EYE_HEIGHT = 1.3
"""Height of the user's eyes in CloVR (2024), metres."""


def maps_table(rings: nf.stream.Rings, size: int, samples: int) -> tuple[str, nf.stream.RingMaps]:
    """Bytes and PSNR of each ring's map, as changes and whole, and the seconds and rays of all."""
    start = time.perf_counter()
    first = nf.stream.bake_maps(
        nf.stream.assign(rings.scene, center=rings.center, radii=rings.radii[:1]), face_size=size, samples=samples
    )
    one = time.perf_counter() - start
    start = time.perf_counter()
    maps = nf.stream.bake_maps(rings, face_size=size, samples=samples)
    every = time.perf_counter() - start
    scale = scale_of(maps, ERROR)
    rows, totals, shown = [], np.zeros(4), np.zeros((6, size, size, 3), np.float32)
    for ring in range(rings.count + 1):
        env = maps.map(ring)
        assert env.range is not None
        codes = scale.codes(env.range)
        whole = [codec.encode_color(face, QUALITY) for face in env.color]
        whole_range = len(codec.encode_codes(codes)) if ring else 0
        if ring == 0:
            color, ranges, tiles = sum(map(len, whole)), 0, 6 * (size // TILE) ** 2
            shown[:] = [codec.decode_color(data, (size, size)) for data in whole]
        else:
            changed = np.flatnonzero(maps.changed_tiles(ring))
            tiles = len(changed)
            color = ranges = 0
            if tiles:
                data = codec.encode_color(codec.sheet_of(codec.tiles_of(env.color, changed, TILE), ACROSS), QUALITY)
                color, ranges = len(data), len(codec.encode_codes(codec.tiles_of(codes, changed, TILE)))
                sheet = codec.decode_color(data, (ACROSS * TILE, -(-tiles // ACROSS) * TILE))
                codec.put_tiles(shown, changed, codec.tiles_of_sheet(sheet, tiles, TILE))
            ranges = whole_range if ring == 1 else ranges
            totals += (color, ranges, sum(map(len, whole)), whole_range)
        decoded = np.stack([codec.decode_color(data, (size, size)) for data in whole])
        quality = [decibels(picture, env.color) for picture in (shown, decoded)]
        radius = "" if ring == 0 else f"{rings.radii[ring - 1]:g}"
        rows.append([radius, f"{tiles:,}", *kilobytes(color, ranges), f"{quality[0]:.1f}",
                     *kilobytes(sum(map(len, whole)), whole_range), f"{quality[1]:.1f}"])  # fmt: skip
    rows.append(["after ring 0", "", *kilobytes(*totals[:2]), "", *kilobytes(*totals[2:]), ""])
    head = ["ring, m", "tiles", "colour, kB", "range, kB", "PSNR", "whole: colour", "range", "PSNR"]
    share = totals[:2].sum() / totals[2:].sum()
    title = (
        f"6 × {size}², {samples} samples: all rings {every:.1f} s, rings 0 and 1 {one:.1f} s; "
        f"{maps.rays / first.rays:.2f} times the rays; after ring 0 {share:.2f} of whole maps"
    )
    return table(title, head, rows), maps


def kilobytes(*counts: float) -> list[str]:
    return [f"{count / 1000:,.0f}" for count in counts]


def decibels(shown: Any, truth: Any) -> float:
    """PSNR of two maps in sRGB codes."""
    shape = (-1, *truth.shape[2:])
    codes = [_core.encode_srgb(np.ascontiguousarray(faces, np.float32)).reshape(shape) for faces in (truth, shown)]
    return nf.psnr(*codes, data_range=255)


def seen_table(scene: nf.Scene, center: tuple[float, float, float], size: int, away: float) -> str:
    """OVC and OFC over all directions, of a user beside the centre: the truth from O, and each ring's picture."""
    user = (center[0] - away, center[1], center[2])
    truth = faces_of(scene, user)
    rows = []
    ovc, ofc = nf.object_completion(truth, faces_of(scene, center))
    rows.append(["truth at O", f"{ovc:.3f}", f"{ofc:.3f}"])
    ovc, ofc = nf.object_completion(truth, faces_of(first_picture(scene, center, size), user))
    rows.append(["ring 0", f"{ovc:.3f}", f"{ofc:.3f}"])
    for radius in PUBLISHED:
        reduced = nf.reduce(scene, center=center, r1=0.7 * radius, r2=radius, unit="object", morph="cylinder",
                            channels=("color", "range", "object_id"), face_size=size, samples=1)  # fmt: skip
        ovc, ofc = nf.object_completion(truth, faces_of(reduced, user))
        rows.append([f"ring to {radius:g} m", f"{ovc:.3f}", f"{ofc:.3f}"])
    return table(f"objects seen by a user {away:g} m beside O, all directions", ["picture", "OVC", "OFC"], rows)


def first_picture(scene: nf.Scene, center: tuple[float, float, float], size: int) -> nf.ReducedScene:
    """The map of ring 0 with object numbers, behind what moves."""
    rings = nf.stream.assign(scene, center=center, radii=PUBLISHED)
    maps = nf.stream.bake_maps(rings, face_size=size, object_id=True)
    moving = scene.subset(objects=rings.objects(0))
    zones = nf.partition(moving, center=center, r1=0.7 * PUBLISHED[0], r2=PUBLISHED[0])
    counts = {**zones.summary(), "rays": 0}
    reduced = nf.ReducedScene(moving, zones, maps.first, morph="cylinder", boundary="r2", counts=counts, is_whole=False)
    return reduced.with_growth(0.0)


def faces_of(source: Any, eye: tuple[float, float, float]) -> Any:
    """Object numbers in all directions from a point, (6 S, S)."""
    views = [nf.Camera(eye, fov=nf.CubeFace(face), size=(256, 256)) for face in range(6)]
    return np.concatenate([nf.render(source, view, channels=("object_id",)).require("object_id") for view in views])


def main() -> None:
    parse = argparse.ArgumentParser(description=__doc__)
    parse.add_argument("--quick", action="store_true", help="a smaller city and smaller maps")
    quick = parse.parse_args().quick
    scene = nf.datasets.city(blocks=3, detail=1) if quick else nf.datasets.city(blocks=9, detail=3)
    eye, _ = nf.datasets.street_view()
    center = (eye[0], EYE_HEIGHT, eye[2])
    print(machine())
    print(f"{scene.triangle_count:,} triangles")
    rings = nf.stream.assign(scene, center=center, radii=PUBLISHED)
    rows = [[f"{row['radius']:g}", f"{row['objects']:,}", f"{row['triangles']:,}", f"{row['stored']:,}"]
            for row in rings.summary()]  # fmt: skip
    print(table("rings", ["radius, m", "objects", "triangles", "stored"], rows))
    print(maps_table(rings, 256 if quick else 1024, 1)[0])
    for away in (1.0, 2.0):
        print(seen_table(scene, center, 256 if quick else 1024, away))


if __name__ == "__main__":
    main()
