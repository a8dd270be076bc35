"""The top view of a partition for notebooks: sampled triangles in the colours of their zones, and both circles."""

from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import card
from nearfar._scene.preview import sample_mask

Zone = Literal["near", "intermediate", "far"]
ZONES: dict[Zone, str] = {"near": card.COLORS[1], "intermediate": card.COLORS[0], "far": card.COLORS[7]}
"""Colours of the zones."""

SIZE = 360
"""Width and height of the picture in pixels."""

MAX_DRAWN = 6_000
"""Maximum number of drawn triangles of a zone: the largest in the picture, and some of the others."""

LARGEST = 1_000
"""Number of largest triangles among the drawn ones."""

MAX_MEASURED = 200_000
"""Maximum number of triangles of a zone, evenly spread, among which the largest are searched."""

MAX_LISTED = 5_000_000
"""Maximum number of triangles of a zone whose numbers are listed; larger zones are found in a sample of the scene."""

REACH = 1.4
"""Half the width of the picture, as a multiple of r2."""


def picture(
    core: _core.Partition, scene: _core.Scene, center: tuple[float, float, float], r1: float, r2: float
) -> NDArray[np.uint8]:
    """Draw the surroundings of the centre seen from above, −z up, (H, W, 4) with a transparent ground."""
    from PIL import Image, ImageDraw

    half_width = REACH * max(r2, 1e-9)
    canvas = Image.new("RGBA", (2 * SIZE, 2 * SIZE), (128, 128, 128, 0))
    draw, scale = ImageDraw.Draw(canvas), SIZE / half_width
    shift = np.array(scene.origin) - np.array(center)
    largest = [_largest_triangles(core, scene, zone, (r1, r2), shift, scale) for zone in ZONES]
    triangles = np.concatenate([flat for _, flat in largest])
    colors = np.repeat(list(ZONES.values()), [len(flat) for _, flat in largest])
    # Large triangles first, so that they do not hide others.
    for number in np.argsort(-np.concatenate([area for area, _ in largest]), kind="stable").tolist():
        draw.polygon([tuple(corner) for corner in triangles[number].tolist()], fill=str(colors[number]))
    for radius in (r1, r2):
        reach = radius * scale
        box = (SIZE - reach, SIZE - reach, SIZE + reach, SIZE + reach)
        draw.ellipse(box, outline=(255, 255, 255, 255), width=5)
        draw.ellipse(box, outline=(0, 0, 0, 255), width=3)
    for x, y in ((9, 0), (0, 9)):
        draw.line((SIZE - x, SIZE - y, SIZE + x, SIZE + y), fill=(0, 0, 0, 255), width=3)
    return np.asarray(canvas.resize((SIZE, SIZE), Image.Resampling.BOX))


def _largest_triangles(
    core: _core.Partition,
    scene: _core.Scene,
    zone: Zone,
    radii: tuple[float, float],
    shift: NDArray[np.float64],
    scale: float,
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return areas (N,) and corners (N, 3, 2) in pixels of a zone's largest triangles in the picture."""
    count = core.counts()[zone]
    if count <= MAX_LISTED:
        mask = np.zeros(scene.triangle_count, bool)
        mask[core.triangles(zone)[sample_mask(count, MAX_MEASURED)]] = True
        corners = scene.subset_of_triangles(mask).triangles() + shift
    else:
        sample = scene.subset_of_triangles(sample_mask(scene.triangle_count, MAX_MEASURED)).triangles() + shift
        distances = _core.triangle_radii(sample.reshape(-1, 3), None, (0.0, 0.0, 0.0))[:, 0]
        corners = sample[np.searchsorted(radii, distances) == list(ZONES).index(zone)]
    pixels = corners[:, :, [0, 2]] * scale + SIZE
    pixels = pixels[(pixels.max(axis=1) >= 0.0).all(axis=1) & (pixels.min(axis=1) <= 2 * SIZE).all(axis=1)]
    edge_1, edge_2 = pixels[:, 1] - pixels[:, 0], pixels[:, 2] - pixels[:, 0]
    area = np.abs(edge_1[:, 0] * edge_2[:, 1] - edge_1[:, 1] * edge_2[:, 0])
    order = np.argsort(-area, kind="stable")
    smaller = order[LARGEST:]
    order = np.concatenate([order[:LARGEST], smaller[sample_mask(len(smaller), MAX_DRAWN - LARGEST)]])
    return area[order], np.clip(pixels[order], -1e5, 1e5)
