"""The shared picture as a compositor shows it: a rectangle in space."""

from __future__ import annotations

from typing import NamedTuple


class QuadLayer(NamedTuple):
    """A rectangle that faces the head and carries the shared picture, for the compositor of a headset.

    Drawn behind an eye's own picture, it shows what the homography of the mono plane shows. It goes into
    XrCompositionLayerQuad of OpenXR as it is; WebXR's XRQuadLayer takes half of the width and of the height.
    """

    position: tuple[float, float, float]
    """Its centre in head axes, metres; it is not turned against the head."""
    size: tuple[float, float]
    """Its width and height, metres."""
