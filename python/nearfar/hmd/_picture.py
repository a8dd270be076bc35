"""The fields of view of both eyes of a headset, drawn for notebooks."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nearfar._base import card
from nearfar.hmd._eye import Eye, TotalFov

SIZE = (420, 300)
"""Width and height of the drawing."""
EDGE = 16
"""Number of points along each edge of a view; straight edges become curves over angles."""


def fields(left: Eye, right: Eye, total: TotalFov) -> str:
    """Draw the outlines of both views over the angles to the side and up, in degrees."""
    outlines = [_outline(eye) for eye in (left, right)]
    reach = np.maximum(np.abs(np.concatenate(outlines)).max(axis=0), 1.0) * 1.12
    scale = min((SIZE[0] - 8) / (2 * reach[0]), (SIZE[1] - 8) / (2 * reach[1]))
    parts = [_grid(float(scale))]
    for color, outline in zip(card.COLORS, outlines, strict=False):
        points = " ".join(f"{x:.1f},{y:.1f}" for x, y in np.array(SIZE) / 2.0 + outline * (scale, -scale))
        style = f'fill="{color}" fill-opacity=".25" stroke="{color}" stroke-width="2"'
        parts.append(f'<polygon points="{points}" {style}/>')
    alt = f"fields of view of both eyes, {total.horizontal_deg:.0f}° across in all"
    return card.svg(SIZE, "".join(parts), alt, [(card.COLORS[0], "left eye"), (card.COLORS[1], "right eye")])


def _outline(eye: Eye) -> NDArray[np.float64]:
    """Return angles to the right and up of points along the edge of a view, degrees (4 · EDGE, 2)."""
    corners = eye.corners
    fraction = (np.arange(EDGE) / EDGE)[None, :, None]
    edge = (corners[:, None] * (1.0 - fraction) + np.roll(corners, -1, axis=0)[:, None] * fraction).reshape(-1, 3)
    right, up = np.arctan2(edge[:, 0], -edge[:, 2]), np.arctan2(edge[:, 1], np.hypot(edge[:, 0], edge[:, 2]))
    return np.asarray(np.degrees(np.column_stack([right, up])))


def _grid(scale: float) -> str:
    """Draw lines every 30 degrees, with their angles."""
    width, height = SIZE
    parts = []
    for angle in range(-180, 181, 30):
        x, y = width / 2 + angle * scale, height / 2 - angle * scale
        strong = ".45" if angle == 0 else ".15"
        style = f'stroke="currentColor" stroke-opacity="{strong}"'
        label = f'fill="currentColor" fill-opacity=".7" font-size="11">{angle}°</text>'
        if 0 < x < width:
            parts.append(f'<path d="M{x:.1f} 0V{height}" {style}/><text x="{x + 3:.1f}" y="{height - 3}" {label}')
        if 0 < y < height:
            # The label of 0 degrees is below the vertical line.
            text = f'<text x="3" y="{y - 3:.1f}" {label}' if angle else ""
            parts.append(f'<path d="M0 {y:.1f}H{width}" {style}/>{text}')
    return "".join(parts)
