"""The top view of a partition for notebooks: sampled triangles in the colours of their zones, and both circles."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import card

if TYPE_CHECKING:
    from PIL import Image

ZONES = {"near": card.COLORS[1], "intermediate": card.COLORS[0], "far": card.COLORS[7]}
"""Colours of the zones."""

SIZE = 360
"""Width and height of the picture in pixels."""

MOST_DRAWN = 6_000
"""Greatest number of triangles that are drawn of a zone."""

MOST_LISTED = 5_000_000
"""Greatest number of triangles of a zone whose numbers are listed; of larger zones none are drawn."""

REACH = 1.4
"""Half the width of the picture, as a multiple of r2."""


def picture(
    core: _core.Partition, scene: _core.Scene, center: tuple[float, float, float], r1: float, r2: float
) -> NDArray[np.uint8]:
    """Draw the surroundings of the centre seen from above, −z up, (H, W, 4) with a transparent ground."""
    from PIL import Image, ImageDraw

    half = REACH * max(r2, 1e-9)
    canvas = Image.new("RGBA", (2 * SIZE, 2 * SIZE), (128, 128, 128, 0))
    draw, scale = ImageDraw.Draw(canvas), SIZE / half
    for color, corners in _largest_first(core, scene):
        flat = (corners[:, [0, 2]] + np.array(scene.origin)[[0, 2]] - np.array(center)[[0, 2]]) * scale + SIZE
        if (flat.max(axis=0) >= 0.0).all() and (flat.min(axis=0) <= 2 * SIZE).all():
            draw.polygon([tuple(corner) for corner in np.clip(flat, -1e5, 1e5).tolist()], fill=color)
    for radius in (r1, r2):
        reach = radius * scale
        box = (SIZE - reach, SIZE - reach, SIZE + reach, SIZE + reach)
        draw.ellipse(box, outline=(255, 255, 255, 255), width=5)
        draw.ellipse(box, outline=(0, 0, 0, 255), width=3)
    for x, y in ((9, 0), (0, 9)):
        draw.line((SIZE - x, SIZE - y, SIZE + x, SIZE + y), fill=(0, 0, 0, 255), width=3)
    return np.asarray(_half(canvas))


def _half(canvas: Image.Image) -> Image.Image:
    from PIL import Image

    return canvas.resize((SIZE, SIZE), Image.Resampling.BOX)


def _largest_first(core: _core.Partition, scene: _core.Scene) -> list[tuple[str, NDArray[np.float64]]]:
    """Colours and corners (3, 3) of sampled triangles of all zones; large ones first, so that they hide no others."""
    colors: list[str] = []
    parts: list[NDArray[np.float32]] = []
    counts = core.counts()
    for zone, color in ZONES.items():
        if 0 < counts[zone] <= MOST_LISTED:
            numbers = core.triangles(zone)
            chosen = np.zeros(scene.triangle_count, bool)
            chosen[numbers[:: max(1, -(-len(numbers) // MOST_DRAWN))]] = True
            parts.append(scene.subset_of_triangles(chosen).triangles())
            colors += [color] * len(parts[-1])
    if not parts:
        return []
    corners = np.concatenate(parts).astype(np.float64)
    one, other = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    area = np.abs(one[:, 0] * other[:, 2] - one[:, 2] * other[:, 0])
    return [(colors[number], corners[number]) for number in np.argsort(-area, kind="stable")]
