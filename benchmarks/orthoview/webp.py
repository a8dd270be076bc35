"""Colours of leaves by zstd, lossless WebP and lossy WebP: bytes, time and error; and accumulated errors over levels.

A parent's colours are computed from its children's decoded colours, because a resumed build reads those from the store.
With lossy files errors accumulate over levels; the last table compares with parents of exact children.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterable

import numpy as np
from numcodecs.zstd import Zstd
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.report import start, table
from benchmarks.harness.timing import timed
from benchmarks.orthoview._leaves import DIRECTIONS, SIZE, Leaf, helmet, layout_of, leaves
from nearfar import _core
from nearfar.orthoview import _codec, _webp
from nearfar.orthoview._grid import OCTANTS, Place

LEVELS = 3
QUALITIES = (80, 90)

Picture = NDArray[np.uint8]
Mask = NDArray[np.bool_]


ColorCodec = tuple[str, Callable[[Picture, Mask], bytes], Callable[[bytes], Picture]]
"""Name, encoder and decoder of the colours of a view."""


def main() -> None:
    start(__doc__)
    textured = helmet()
    every = [*leaves(), *([textured] if textured else [])]
    header = "leaf | colours | kB a view {:.1f} | of zstd 3 {:.2f} | all channels, kB {:.1f} | encode, ms {:.1f}"
    rows = [row for leaf in every for row in leaf_rows(leaf)]
    title = f"Colours of a view of {SIZE}² pixels; PSNR and SSIM of non-empty pixels"
    print(table(title, header + " | decode, ms {:.1f} | PSNR, dB {:.1f} | SSIM {:.3f}", rows))
    deep = [leaf for leaf in every if leaf.name in ("forest, 80 m", "helmet, 0.75 m")]
    rows = [row for leaf in deep for row in level_rows(leaf, QUALITIES[-1])]
    header = "world | level | from exact children, dB {:.1f} | from stored children, dB {:.1f}"
    print(table(f"Quality {QUALITIES[-1]} over levels: PSNR against a tree without losses", header, rows))


def color_codecs() -> list[ColorCodec]:
    def by_zstd(level: int) -> ColorCodec:
        codec = Zstd(level=level)
        return (
            f"zstd {level}",
            lambda picture, _: bytes(codec.encode(picture)),
            lambda data: np.frombuffer(codec.decode(data), np.uint8).reshape(SIZE, SIZE, 3),
        )

    def decode(data: bytes) -> Picture:
        (picture,) = _webp.decode(data, SIZE)
        return np.asarray(picture)

    def lossy(quality: int) -> ColorCodec:
        return f"WebP {quality}", lambda picture, mask: _webp.encode(picture[None], quality, mask[None]), decode

    return [
        *map(by_zstd, (3, 9, 19)),
        ("WebP lossless", lambda picture, _: _webp.encode(picture[None]), decode),
        *map(lossy, QUALITIES),
        ("WebP 90, empty pixels black", lambda picture, _: _webp.encode(picture[None], 90), decode),
    ]


def leaf_rows(leaf: Leaf) -> Iterable[list[object]]:
    layout = layout_of()
    views = leaf.views(layout)
    chunks = _codec.encode(views, layout)
    directions = sorted(chunks)
    colors, plain = views.colors(), Zstd(level=3)
    color_bytes = sum(len(plain.encode(np.ascontiguousarray(colors[number]))) for number in directions)
    other_bytes = (sum(map(len, chunks.values())) - color_bytes) / len(directions)
    pictures, is_shown = views.colors()[directions], views.depths()[directions, ..., 0] > 0
    first_size = 0.0
    for name, encode, decode in color_codecs():
        files, encoding = timed(lambda encode: [*map(encode, pictures, is_shown)], encode)
        decoded, decoding = timed(lambda decode, files: np.array([*map(decode, files)]), decode, files)
        size = sum(map(len, files)) / len(directions)
        first_size = first_size or size
        sizes = size / 1e3, size / first_size, (size + other_bytes) / 1e3
        times = (time.ms / len(directions) for time in (encoding, decoding))
        yield [leaf.name, name, *sizes, *times, *picture_quality(pictures, decoded, is_shown)]


def picture_quality(expected: Picture, decoded: Picture, is_shown: Mask) -> list[object]:
    if (expected == decoded)[is_shown].all():
        return ["exact", "1"]
    pairs = zip(expected, decoded, is_shown, strict=True)
    ssim = [nf.ssim(one, other, data_range=255, mask=mask, masking="windows") for one, other, mask in pairs]
    return [psnr(expected, decoded, is_shown), np.mean(ssim)]


def psnr(expected: Picture, decoded: Picture, is_shown: Mask) -> float:
    return nf.psnr(expected[is_shown][:, None], decoded[is_shown][:, None], data_range=255)


# Levels --------------------------------------------------------------------------------------------------------------
Views = dict[Place, _core.OrthoViews]


def level_rows(world: Leaf, quality: int) -> Iterable[list[object]]:
    """Errors of a tree whose root is the world's cell."""
    exact = small_leaves(world)
    stored = {place: decode_stored(views, quality) for place, views in exact.items()}
    for level in range(LEVELS):
        if level:
            exact = compose_parents(exact)
            stored = {place: decode_stored(views, quality) for place, views in compose_parents(stored).items()}
        from_exact = {place: decode_stored(views, quality) for place, views in exact.items()}
        yield [world.name, level, cell_psnr(exact, from_exact), cell_psnr(exact, stored)]


def small_leaves(world: Leaf) -> Views:
    """Views of the leaves below a cell."""
    count = 1 << (LEVELS - 1)
    side = world.side / count
    views_by_place: Views = {}
    for column, layer, row in itertools.product(range(count), repeat=3):
        corner = np.add(world.corner, np.multiply((column, layer, row), side))
        x, y, z = corner.tolist()
        part = world.scene.query(np.array([corner, corner + side]))
        if part.triangle_count:
            views = Leaf("", part, (x, y, z), side).views(layout_of())
            if not all(views.empty()):
                views_by_place[column, layer, row] = views
    return views_by_place


def compose_parents(children: Views) -> Views:
    parents: dict[Place, _core.OrthoParent] = {}
    for octant in OCTANTS:
        for (x, y, z), views in children.items():
            if octant == (x % 2, y % 2, z % 2):
                place = (x // 2, y // 2, z // 2)
                parents.setdefault(place, _core.OrthoParent(DIRECTIONS, layout_of().format)).add(octant, views)
    return {place: parent.finish() for place, parent in parents.items()}


def decode_stored(views: _core.OrthoViews, quality: int) -> _core.OrthoViews:
    """Decode the views as readers do."""
    colors, depths = views.colors(), views.depths()
    for picture, is_shown in zip(colors, depths[..., 0] > 0, strict=True):
        (decoded,) = _webp.decode(_webp.encode(picture[None], quality, is_shown[None]), SIZE)
        picture[:] = np.where(is_shown[..., None], decoded, 0)
    return _core.OrthoViews.from_arrays(DIRECTIONS, layout_of().format, colors, depths, views.normals())


def cell_psnr(exact: Views, other: Views) -> float:
    exact_colors, colors = (np.concatenate([views[place].colors() for place in exact]) for views in (exact, other))
    return psnr(exact_colors, colors, np.concatenate([exact[place].depths()[..., 0] > 0 for place in exact]))


if __name__ == "__main__":
    main()
