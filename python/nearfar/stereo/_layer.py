"""Placement of the shared picture for compositors: a rectangle in space."""

from __future__ import annotations

from typing import NamedTuple


class QuadLayer(NamedTuple):
    """A rectangle parallel to the head's image plane with the shared picture, for a headset's compositor.

    Drawn behind an eye's own picture, it gives the same result as the homography of the mono plane. Its values are
    those of XrCompositionLayerQuad in OpenXR; WebXR's XRQuadLayer takes half of the width and of the height.
    """

    position: tuple[float, float, float]
    """Centre in head axes, metres; the rectangle is not rotated relative to the head."""
    size: tuple[float, float]
    """Width and height, metres."""
