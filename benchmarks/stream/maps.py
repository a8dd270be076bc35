"""Maps of rings as changes and as whole maps: rays, seconds, bytes and PSNR."""

from __future__ import annotations

import zlib
from functools import partial
from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness.pictures import encode
from benchmarks.harness.report import start, table
from benchmarks.harness.timing import timed
from benchmarks.stream._near import large_city, street_center
from nearfar.stream import _map_files as codec
from nearfar.stream._decode import DecodeFile, Layout, decode_map
from nearfar.stream._encode import TILES_PER_ROW, encode_maps, scale_of
from nearfar.stream._manifest import names_of
from nearfar.stream._maps import TILE
from nearfar.stream._radii import PUBLISHED
from nearfar.stream._store import Files

QUALITY = 90
ERROR = 2.0**-11


def maps_table(rings: nf.stream.Rings, size: int, samples: int) -> tuple[str, nf.stream.RingMaps]:
    """Table of bytes and PSNR of each ring's map, as changes and whole, and the seconds and rays of all."""
    bake = partial(nf.stream.bake_maps, face_size=size, samples=samples)
    first, two_rings = timed(lambda: bake(nf.stream.assign(rings.scene, center=rings.center, radii=rings.radii[:1])))
    maps, every = timed(bake, rings)
    scale, files = scale_of(maps, ERROR), Files()
    entries = list(encode_maps(maps, files, quality=QUALITY, scale=scale))
    layout = Layout(size, TILE, TILES_PER_ROW, scale)
    rows: list[list[object]] = []
    totals = np.zeros(5)
    for ring, entry in enumerate(entries):
        env = maps.map(ring)
        assert env.range is not None
        codes = scale.codes(env.range)
        decoded, _ = decode_map(entries[: ring + 1], layout, file_decoder(files))
        color, ranges = (
            sum(len(files.content[name]) for name in names_of(entry.get(kind))) for kind in ("color", "range")
        )
        images = [codec.encode_color(face, QUALITY) for face in env.color]
        decoded_whole = np.stack([codec.decode_color(data, (size, size)) for data in images])
        tiles, sizes = 6 * (size // TILE) ** 2, np.array([color, ranges, sum(map(len, images)), 0, 0])
        if ring:
            tiles = len(entry["tiles"])
            sizes[3:] = len(encode_plainly(codes)), sum(len(whole_range(face, scale.step)) for face in codes)
            totals += sizes
        changed, kept = np.split(sizes / 1e3, [2])
        quality = decibels(decoded, env.color), decibels(decoded_whole, env.color)
        rows.append([rings.radii[ring - 1] if ring else None, tiles, *changed, quality[0], *kept, quality[1]])
    changed, kept = np.split(totals / 1e3, [2])
    rows.append(["after ring 0", None, *changed, None, *kept, None])
    header = "ring, m {:g} | tiles {:,} | colour, kB {:,.0f} | range, kB {:,.0f} | PSNR {:.2f} | whole: colour {:,.0f}"
    header += " | range, plain {:,.0f} | in planes {:,.0f} | PSNR {:.2f}"
    plain, planes = (totals[:2].sum() / (totals[2] + total) for total in totals[3:])
    title = (
        f"6 × {size}², {samples} samples: all rings {every.wall:.1f} s, rings 0 and 1 {two_rings.wall:.1f} s; "
        f"{maps.rays / first.rays:.2f} times the rays; after ring 0 {plain:.3f} of whole maps with plain "
        f"ranges, {planes:.3f} with planes"
    )
    return table(title, header, rows), maps


def file_decoder(files: Files) -> DecodeFile:
    return lambda name, decode: decode(files.content[name])


def codec_table(maps: nf.stream.RingMaps) -> str:
    """Table of seconds of all maps, and of the ranges of ring 1 against those of plain residuals."""
    scale, size, files = scale_of(maps, ERROR), maps.first.face_size, Files()
    env = maps.map(1)
    assert env.range is not None
    codes = scale.codes(env.range)
    entries, encoding = timed(lambda: list(encode_maps(maps, files, quality=QUALITY, scale=scale)))
    _, decoding = timed(decode_map, entries, Layout(size, TILE, TILES_PER_ROW, scale), file_decoder(files))
    settings: dict[str, Any] = {"count": 1, "size": size, "tile": TILE, "step": scale.step}
    planes, planes_time = timed(lambda: [whole_range(face, scale.step) for face in codes])
    plain, plain_time = timed(encode_plainly, codes)
    nothing = np.array([], np.int64)
    _, reading = timed(lambda: [codec.decode_ranges(data, None, **settings, tiles=nothing) for data in planes])
    decoded_codes, plain_reading = timed(decode_plainly, plain, codes.shape)
    assert (decoded_codes == codes).all()
    rows = [
        ["all maps, encoded", encoding.wall, None],
        ["all maps, decoded", decoding.wall, None],
        ["range of ring 1, encoded", planes_time.wall, planes_time.wall / plain_time.wall],
        ["range of ring 1, decoded", reading.wall, reading.wall / plain_reading.wall],
    ]
    return table("codec of maps", "job | seconds {:.2f} | times plain residuals {:.2f}", rows)


def whole_range(face: Any, step: float) -> bytes:
    """Encode all codes of a face."""
    none = np.zeros((1, *face.shape), bool)
    return codec.encode_ranges(face[None], None, none, np.array([], np.int64), tile=TILE, step=step)


def encode_plainly(codes: Any) -> bytes:
    """Predict by left + upper − upper left in 16 bits; fold residuals; high bytes before low bytes; zlib."""
    across = codes.copy()
    across[:, :, 1:] -= codes[:, :, :-1]
    residual = across.copy()
    residual[:, 1:] -= across[:, :-1]
    signed = residual.view(np.int16)
    folded = ((signed << 1) ^ (signed >> 15)).view(np.uint16).ravel()
    return zlib.compress(np.concatenate([folded >> 8, folded & 255]).astype(np.uint8).tobytes(), 6)


def decode_plainly(data: bytes, shape: tuple[int, ...]) -> Any:
    high, low = np.frombuffer(zlib.decompress(data), np.uint8).reshape(2, -1).astype(np.uint16)
    folded = (high << 8) | low
    residual: Any = ((folded >> 1) ^ (0 - (folded & 1))).reshape(shape)
    return np.cumsum(np.cumsum(residual, axis=1, dtype=np.uint16), axis=2, dtype=np.uint16)


def decibels(decoded: Any, truth: Any) -> float:
    """PSNR of two maps in sRGB codes."""
    return nf.psnr(*(encode(faces).reshape(-1, *truth.shape[2:]) for faces in (truth, decoded)), data_range=255)


def main() -> None:
    quick = start(__doc__, "--quick").quick
    scene = large_city(quick)
    print(f"{scene.triangle_count:,} triangles")
    rings = nf.stream.assign(scene, center=street_center(), radii=PUBLISHED)
    rows = [[row[name] for name in ("radius", "objects", "triangles", "stored")] for row in rings.summary()]
    print(table("rings", "radius, m {:g} | objects {:,} | triangles {:,} | stored {:,}", rows))
    text, maps = maps_table(rings, 256 if quick else 1024, 1)
    print(text)
    print(codec_table(maps))


if __name__ == "__main__":
    main()
