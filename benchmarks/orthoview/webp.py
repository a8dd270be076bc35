"""Colours of leaves by zstd, lossless WebP and lossy WebP: bytes, time and error; and accumulated errors over levels.

A parent's colours are computed from its children's. If these are lossy, a parent is composed of the decoded colours of
its children, so that a resumed build reads the same colours; the last table compares that with parents of exact ones.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterable
from dataclasses import dataclass

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
Seen = NDArray[np.bool_]


@dataclass(frozen=True)
class Way:
    """A way to store the colours of a view."""

    name: str
    encode: Callable[[Picture, Seen], bytes]
    decode: Callable[[bytes], Picture]


def main() -> None:
    start(__doc__)
    textured = helmet()
    every = [*leaves(), *([textured] if textured else [])]
    header = "leaf | colours | kB a view {:.1f} | of zstd 3 {:.2f} | all channels, kB {:.1f} | encode, ms {:.1f}"
    rows = [row for leaf in every for row in leaf_rows(leaf)]
    title = f"Colours of a view of {SIZE}² pixels; PSNR and SSIM of the pixels in which something is"
    print(table(title, header + " | decode, ms {:.1f} | PSNR, dB {:.1f} | SSIM {:.3f}", rows))
    deep = [leaf for leaf in every if leaf.name in ("forest, 80 m", "helmet, 0.75 m")]
    rows = [row for leaf in deep for row in level_rows(leaf, QUALITIES[-1])]
    header = "world | level | from exact children, dB {:.1f} | from children as they are stored, dB {:.1f}"
    print(table(f"Quality {QUALITIES[-1]} over levels: PSNR with a tree without losses", header, rows))


def ways() -> list[Way]:
    def by_zstd(level: int) -> Way:
        codec = Zstd(level=level)
        return Way(
            f"zstd {level}",
            lambda picture, _: bytes(codec.encode(picture)),
            lambda data: np.frombuffer(codec.decode(data), np.uint8).reshape(SIZE, SIZE, 3),
        )

    def decode(data: bytes) -> Picture:
        return _webp.decode(data, SIZE)

    def lossy(quality: int) -> Way:
        return Way(f"WebP {quality}", lambda picture, seen: _webp.encode(picture, quality, seen), decode)

    return [
        by_zstd(3),
        by_zstd(9),
        by_zstd(19),
        Way("WebP lossless", lambda picture, _: _webp.encode(picture), decode),
        *map(lossy, QUALITIES),
        Way("WebP 90, black about it", lambda picture, _: _webp.encode(picture, 90), decode),
    ]


def leaf_rows(leaf: Leaf) -> Iterable[list[object]]:
    layout = layout_of()
    views = leaf.views(layout)
    chunks = _codec.encode(views, layout)
    shown = sorted({number for number, _ in chunks})
    others = sum(len(chunk) for (_, channel), chunk in chunks.items() if channel != "color") / len(shown)
    pictures, seen = views.colors()[shown], views.depths()[shown, ..., 0] > 0
    first = 0.0
    for way in ways():
        files, writing = timed(lambda encode: [*map(encode, pictures, seen)], way.encode)
        decoded, reading = timed(lambda decode, files: np.array([*map(decode, files)]), way.decode, files)
        size = sum(map(len, files)) / len(shown)
        first = first or size
        sizes = size / 1e3, size / first, (size + others) / 1e3
        times = (time.ms / len(shown) for time in (writing, reading))
        yield [leaf.name, way.name, *sizes, *times, *picture_quality(pictures, decoded, seen)]


def picture_quality(right: Picture, decoded: Picture, seen: Seen) -> list[object]:
    if (right == decoded)[seen].all():
        return ["exact", "1"]
    pairs = zip(right, decoded, seen, strict=True)
    ssim = [nf.ssim(one, other, data_range=255, mask=mask, masking="windows") for one, other, mask in pairs]
    return [psnr(right, decoded, seen), np.mean(ssim)]


def psnr(right: Picture, decoded: Picture, seen: Seen) -> float:
    return nf.psnr(right[seen][:, None], decoded[seen][:, None], data_range=255)


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
        alone = {place: decode_stored(views, quality) for place, views in exact.items()}
        yield [world.name, level, cell_psnr(exact, alone), cell_psnr(exact, stored)]


def small_leaves(world: Leaf) -> Views:
    """Views of the leaves below a cell."""
    count = 1 << (LEVELS - 1)
    side = world.side / count
    found: Views = {}
    for column, layer, row in itertools.product(range(count), repeat=3):
        corner = np.add(world.corner, np.multiply((column, layer, row), side))
        x, y, z = corner.tolist()
        part = world.scene.query(np.array([corner, corner + side]))
        if part.triangle_count:
            views = Leaf("", part, (x, y, z), side).views(layout_of())
            if not all(views.empty()):
                found[column, layer, row] = views
    return found


def compose_parents(children: Views) -> Views:
    made: dict[Place, _core.OrthoParent] = {}
    for octant in OCTANTS:
        for (x, y, z), views in children.items():
            if octant == (x % 2, y % 2, z % 2):
                place = (x // 2, y // 2, z // 2)
                made.setdefault(place, _core.OrthoParent(DIRECTIONS, layout_of().format)).add(octant, views)
    return {place: parent.finish() for place, parent in made.items()}


def decode_stored(views: _core.OrthoViews, quality: int) -> _core.OrthoViews:
    """Decode the views as readers do."""
    colors, depths = views.colors(), views.depths()
    for picture, seen in zip(colors, depths[..., 0] > 0, strict=True):
        picture[:] = np.where(seen[..., None], _webp.decode(_webp.encode(picture, quality, seen), SIZE), 0)
    return _core.OrthoViews.from_arrays(DIRECTIONS, layout_of().format, colors, depths, views.normals())


def cell_psnr(exact: Views, other: Views) -> float:
    """PSNR of the non-empty pixels of all cells."""
    right, found = (np.concatenate([views[place].colors() for place in exact]) for views in (exact, other))
    seen = np.concatenate([exact[place].depths()[..., 0] > 0 for place in exact])
    return psnr(right, found, seen)


if __name__ == "__main__":
    main()
