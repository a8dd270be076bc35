"""Maps of rings as changes and as whole maps: rays, seconds, bytes and PSNR.

python -m benchmarks.stream.maps [--quick]
"""

from __future__ import annotations

import argparse
import time
import zlib
from collections.abc import Callable
from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness.timing import machine, table
from nearfar import _core
from nearfar.stream import _map_files as codec
from nearfar.stream._decode import Decoded, Layout, decode_map
from nearfar.stream._encode import ACROSS, Files, encode_maps, scale_of
from nearfar.stream._manifest import names_of
from nearfar.stream._maps import TILE
from nearfar.stream._radii import PUBLISHED

QUALITY = 90
ERROR = 2.0**-11
EYE_HEIGHT = 1.3
"""Height of the user's eyes in CloVR (2024), metres."""


def maps_table(rings: nf.stream.Rings, size: int, samples: int) -> tuple[str, nf.stream.RingMaps]:
    """Table of bytes and PSNR of each ring's map, as changes and whole, and the seconds and rays of all."""
    start = time.perf_counter()
    first = nf.stream.bake_maps(
        nf.stream.assign(rings.scene, center=rings.center, radii=rings.radii[:1]), face_size=size, samples=samples
    )
    one = time.perf_counter() - start
    start = time.perf_counter()
    maps = nf.stream.bake_maps(rings, face_size=size, samples=samples)
    every = time.perf_counter() - start
    scale, files = scale_of(maps, ERROR), Files()
    listed = list(encode_maps(maps, files, quality=QUALITY, scale=scale))
    layout = Layout(size, TILE, ACROSS, scale)
    rows, totals = [], np.zeros(5)
    for ring, described in enumerate(listed):
        env = maps.map(ring)
        assert env.range is not None
        codes = scale.codes(env.range)
        shown, _ = decode_map(listed[: ring + 1], layout, decoded_from(files))
        color, ranges = (
            sum(len(files.content[name]) for name in names_of(described.get(kind))) for kind in ("color", "range")
        )
        whole = [codec.encode_color(face, QUALITY) for face in env.color]
        again = np.stack([codec.decode_color(data, (size, size)) for data in whole])
        tiles, sizes = 6 * (size // TILE) ** 2, [sum(map(len, whole)), 0, 0]
        if ring:
            tiles = len(described["tiles"])
            sizes[1:] = len(plainly_encoded(codes)), sum(len(whole_range(face, scale.step)) for face in codes)
            totals += (color, ranges, *sizes)
        radius = "" if ring == 0 else f"{rings.radii[ring - 1]:g}"
        rows.append([radius, f"{tiles:,}", *kilobytes(color, ranges), f"{decibels(shown, env.color):.2f}",
                     *kilobytes(*sizes), f"{decibels(again, env.color):.2f}"])  # fmt: skip
    rows.append(["after ring 0", "", *kilobytes(*totals[:2]), "", *kilobytes(*totals[2:]), ""])
    head = ["ring, m", "tiles", "colour, kB", "range, kB", "PSNR", "whole: colour", "range, plain", "in planes", "PSNR"]
    plain, planes = (totals[:2].sum() / (totals[2] + total) for total in totals[3:])
    title = (
        f"6 × {size}², {samples} samples: all rings {every:.1f} s, rings 0 and 1 {one:.1f} s; "
        f"{maps.rays / first.rays:.2f} times the rays; after ring 0 {plain:.3f} of whole maps with plain "
        f"ranges, {planes:.3f} with planes"
    )
    return table(title, head, rows), maps


def decoded_from(files: Files) -> Decoded:
    """Decode files just encoded."""
    return lambda name, decode: decode(files.content[name])


def codec_table(maps: nf.stream.RingMaps) -> str:
    """Table of seconds of all maps, and of the ranges of ring 1 against those of plain residuals."""
    scale, size, files = scale_of(maps, ERROR), maps.first.face_size, Files()
    env = maps.map(1)
    assert env.range is not None
    codes = scale.codes(env.range)
    seconds, listed = timed(lambda: list(encode_maps(maps, files, quality=QUALITY, scale=scale)))
    rows = [["all maps, encoded", f"{seconds:.2f}", ""]]
    layout = Layout(size, TILE, ACROSS, scale)
    rows.append(["all maps, decoded", f"{timed(lambda: decode_map(listed, layout, decoded_from(files)))[0]:.2f}", ""])
    nothing = np.array([], np.int64)
    planes_seconds, planes = timed(lambda: [whole_range(face, scale.step) for face in codes])
    plain_seconds, plain = timed(lambda: plainly_encoded(codes))
    rows.append(["range of ring 1, encoded", f"{planes_seconds:.2f}", f"{planes_seconds / plain_seconds:.2f}"])
    settings: dict[str, Any] = {"count": 1, "size": size, "tiles": nothing, "tile": TILE, "step": scale.step}
    planes_seconds, _ = timed(lambda: [codec.decode_ranges(data, None, **settings) for data in planes])
    plain_seconds, again = timed(lambda: plainly_decoded(plain, codes.shape))
    assert (again == codes).all()
    rows.append(["range of ring 1, decoded", f"{planes_seconds:.2f}", f"{planes_seconds / plain_seconds:.2f}"])
    return table("codec of maps", ["job", "seconds", "times plain residuals"], rows)


def timed(job: Callable[[], Any]) -> tuple[float, Any]:
    start = time.perf_counter()
    result = job()
    return time.perf_counter() - start, result


def whole_range(face: Any, step: float) -> bytes:
    """Encode all codes of a face."""
    none = np.zeros((1, *face.shape), bool)
    return codec.encode_ranges(face[None], None, none, np.array([], np.int64), tile=TILE, step=step)


def plainly_encoded(codes: Any) -> bytes:
    """Predict by left + upper − upper left in 16 bits; fold residuals; high bytes before low bytes; zlib."""
    across = codes.copy()
    across[:, :, 1:] -= codes[:, :, :-1]
    residual = across.copy()
    residual[:, 1:] -= across[:, :-1]
    signed = residual.view(np.int16)
    folded = ((signed << 1) ^ (signed >> 15)).view(np.uint16).ravel()
    return zlib.compress(np.concatenate([folded >> 8, folded & 255]).astype(np.uint8).tobytes(), 6)


def plainly_decoded(data: bytes, shape: tuple[int, ...]) -> Any:
    high, low = np.frombuffer(zlib.decompress(data), np.uint8).reshape(2, -1).astype(np.uint16)
    folded = (high << 8) | low
    residual: Any = ((folded >> 1) ^ (0 - (folded & 1))).reshape(shape)
    return np.cumsum(np.cumsum(residual, axis=1, dtype=np.uint16), axis=2, dtype=np.uint16)


def kilobytes(*counts: float) -> list[str]:
    return [f"{count / 1000:,.0f}" for count in counts]


def decibels(shown: Any, truth: Any) -> float:
    """PSNR of two maps in sRGB codes."""
    shape = (-1, *truth.shape[2:])
    codes = [_core.encode_srgb(np.ascontiguousarray(faces, np.float32)).reshape(shape) for faces in (truth, shown)]
    return nf.psnr(*codes, data_range=255)


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
    text, maps = maps_table(rings, 256 if quick else 1024, 1)
    print(text)
    print(codec_table(maps))


if __name__ == "__main__":
    main()
