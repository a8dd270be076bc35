"""The `TemporalAntialiasing` class: pictures of a rig that gather detail and smooth edges from one to the next."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check
from nearfar._render.frame import Frame
from nearfar._render.level_choice import Lod
from nearfar._render.renderable import Renderable
from nearfar._render.renderer import Renderer
from nearfar.hmd._hmd import EYES
from nearfar.hmd._stereo import StereoFrame
from nearfar.stereo._moments import Moment
from nearfar.stereo._passes import render
from nearfar.stereo._rig import HybridRig

_GOLDEN = 0.5 * (math.sqrt(5.0) - 1.0)


class TemporalAntialiasing:
    """Renders the pictures of a rig one after another, and mixes each with what those before it have gathered.

    The pixels of each picture lie beside those of the picture before by a part of a pixel, the same one for all three
    cameras. What was gathered is looked up where each surface was before, and held within the colours of the pixels
    around, so that it does not trail behind what moves. In a still picture, n frames are nearly as smooth as one frame
    with n samples.

    Parameters
    ----------
    share
        Weight of a new picture, above 0 to 1, once 1/`share` of them are gathered; before that, all weigh the same.
    offsets
        Number of different places of the pixels, 1 to 1024.

    Raises
    ------
    ValueError, TypeError
        For values out of range.

    References
    ----------
    Karis (2014): High-quality temporal supersampling. Fink et al. (2019), who apply it to hybrid pictures.
    """

    def __init__(self, *, share: float = 0.1, offsets: int = 8) -> None:
        self._share = check.within("share", share, 1e-6, 1.0)
        self._offsets = _in_turn(check.integer("offsets", offsets, 1, 1024))
        self.restart()

    def restart(self) -> None:
        """Forget all pictures; for a change of scene."""
        self._gathered: dict[str, NDArray[np.float32]] = {}
        self._before: Moment | None = None
        self._rig: HybridRig | None = None
        self._count = 0

    @property
    def count(self) -> int:
        """Number of pictures since the start."""
        return self._count

    def render(
        self,
        rig: HybridRig,
        source: Renderable,
        position: ArrayLike,
        orientation: ArrayLike = (0.0, 0.0, 0.0, 1.0),
        *,
        at: Mapping[str, ArrayLike] | None = None,
        channels: Iterable[str] | None = None,
        samples: int = 1,
        lod: Lod | None = None,
        backend: str | None = None,
        cull: str = "occlusion",
        assembly: str = "bilinear",
        near: float = 0.1,
        far: float = math.inf,
    ) -> StereoFrame:
        """Render the next picture.

        Parameters
        ----------
        rig
            The rig. Its plane may change from picture to picture; with other eyes or another size, gathering starts
            again.
        source, position, orientation, at, channels, samples, lod, backend, cull, assembly, near, far
            As in `HybridRig.render`. "motion" is that since the picture before, 0 in the first one.

        Returns
        -------
        StereoFrame
            As from `HybridRig.render`; the colours of `left` and `right` are what has been gathered. All other images
            are those of the new picture, whose pixels lie beside the frame's by a part of a pixel.

        Raises
        ------
        ValueError, TypeError, DeviceError
            As in `HybridRig.render`.
        """
        check.instance("rig", rig, HybridRig)
        wanted = Renderer(source, channels, samples, lod)
        renderer = Renderer(source, {*wanted.channels, "color", "motion", "range"}, samples, lod)
        if self._rig is None or (self._rig.left, self._rig.right, self._rig.size) != (rig.left, rig.right, rig.size):
            self.restart()
        frame, moment = render(
            rig,
            renderer,
            (position, orientation),
            at=at,
            backend=backend,
            cull=cull,
            assembly=assembly,
            depths=(near, far),
            before=self._before,
            jitter=self._offsets[self._count % len(self._offsets)],
        )
        self._count, self._rig, self._before = self._count + 1, rig, moment
        left, right = (_only(wanted.channels, self._mixed(side, getattr(frame, side))) for side in EYES)
        center = None if frame.center is None else _only(wanted.channels, frame.center)
        return replace(frame, left=left, right=right, center=center)

    def _mixed(self, side: str, frame: Frame) -> Frame:
        """The frame with the colours that were gathered up to it."""
        color, share = frame.require("color"), max(self._share, 1.0 / self._count)
        if side in self._gathered:
            moved, away = frame.require("motion"), frame.require("range")
            color = _core.gather_frames(color, moved, away, self._gathered[side], share)
        self._gathered[side] = color
        return replace(frame, color=color)


def _only(channels: Iterable[str], frame: Frame) -> Frame:
    """The frame without images that nobody asked for."""
    dropped: dict[str, Any] = {name: None for name in frame.channels if name not in set(channels)}
    return replace(frame, **dropped)


def _in_turn(count: int) -> list[tuple[float, float]]:
    """Places of the pixels' samples, in an order in which those that follow each other lie apart."""
    places = [(x - 0.5, y - 0.5) for x, y in _core.sample_offsets(count)]
    step = next(n for n in range(max(round(count * _GOLDEN), 1), count + 1) if math.gcd(n, count) == 1)
    return [places[n * step % count] for n in range(count)]
