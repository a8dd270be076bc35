"""The `TemporalAntialiasing` class: pictures of a rig that accumulate detail and smooth edges over time."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Any, Unpack

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check
from nearfar._base.settings import gather, split
from nearfar._render.frame import Frame
from nearfar._render.renderable import Renderable
from nearfar._render.renderer import Renderer
from nearfar._render.settings import RenderSettings
from nearfar.hmd._hmd import EYES
from nearfar.hmd._stereo import StereoFrame
from nearfar.stereo._moments import Moment
from nearfar.stereo._passes import render
from nearfar.stereo._rig import HybridRig
from nearfar.stereo._settings import HybridOptions, HybridSettings

_GOLDEN = 0.5 * (math.sqrt(5.0) - 1.0)


class TemporalAntialiasing:
    """Renders successive pictures of a rig, and blends each with the accumulated previous ones.

    Each picture is shifted from the previous one by a fraction of a pixel, the same for all three cameras. Accumulated
    colour is looked up at each surface's previous place, and clamped to the colours of the surrounding pixels, so that
    moving objects leave no trail. In a still picture, n frames are nearly as smooth as one frame with n samples.

    ValueError and TypeError for values out of range. Sources: Karis (2014), High-quality temporal supersampling; Fink
    et al. (2019), who apply it to hybrid pictures.

    Parameters
    ----------
    share
        Weight of a new picture, above 0 and at most 1, once 1/`share` pictures are accumulated; before that, all have
        equal weights.
    offsets
        Number of different shifts, 1 to 1024.
    """

    def __init__(self, *, share: float = 0.1, offsets: int = 8) -> None:
        self._share = check.in_range("share", share, 1e-6, 1.0)
        self._offsets = _spread_offsets(check.integer("offsets", offsets, 1, 1024))
        self.restart()

    def restart(self) -> None:
        """Discard all accumulated pictures; for a change of scene."""
        self._accumulated: dict[str, NDArray[np.float32]] = {}
        self._last_moment: Moment | None = None
        self._rig: HybridRig | None = None
        self._count = 0

    @property
    def count(self) -> int:
        """Number of pictures since the last restart."""
        return self._count

    def render(
        self,
        rig: HybridRig,
        source: Renderable,
        position: ArrayLike,
        orientation: ArrayLike = (0.0, 0.0, 0.0, 1.0),
        *,
        at: Mapping[str, ArrayLike] | None = None,
        settings: RenderSettings | None = None,
        hybrid: HybridSettings | None = None,
        **keywords: Unpack[HybridOptions],
    ) -> StereoFrame:
        """Render the next picture; arguments, result and errors are those of `HybridRig.render`.

        The rig's plane may change between pictures; other eyes or another size restart the accumulation. The channel
        "motion" is relative to the previous picture, 0 in the first one. The colours of `left` and `right` are the
        accumulated ones; all other images are those of the new picture, which is shifted by a fraction of a pixel.
        """
        check.instance("rig", rig, HybridRig)
        render_keywords, hybrid_keywords = split(HybridSettings, keywords)
        requested = Renderer(source, gather(RenderSettings, settings, render_keywords))
        needed = replace(requested.settings, channels=(*requested.channels, "color", "motion", "range"))
        renderer = Renderer(source, needed)
        if self._rig is None or (self._rig.left, self._rig.right, self._rig.size) != (rig.left, rig.right, rig.size):
            self.restart()
        frame, moment = render(
            rig,
            renderer,
            (position, orientation),
            at=at,
            hybrid=gather(HybridSettings, hybrid, hybrid_keywords, argument="hybrid"),
            before=self._last_moment,
            jitter=self._offsets[self._count % len(self._offsets)],
        )
        self._count, self._rig, self._last_moment = self._count + 1, rig, moment
        left, right = (self._accumulate(side, getattr(frame, side)) for side in EYES)
        left, right = _with_channels(requested.channels, left), _with_channels(requested.channels, right)
        center = None if frame.center is None else _with_channels(requested.channels, frame.center)
        return replace(frame, left=left, right=right, center=center)

    def _accumulate(self, side: str, frame: Frame) -> Frame:
        """Return the frame with accumulated colours."""
        color, weight = frame.require("color"), max(self._share, 1.0 / self._count)
        if side in self._accumulated:
            motions, distances = frame.require("motion"), frame.require("range")
            color = _core.gather_frames(color, motions, distances, self._accumulated[side], weight)
        self._accumulated[side] = color
        return replace(frame, color=color)


def _with_channels(channels: Iterable[str], frame: Frame) -> Frame:
    """Return the frame without channels that were not requested."""
    dropped: dict[str, Any] = {name: None for name in frame.channels if name not in set(channels)}
    return replace(frame, **dropped)


def _spread_offsets(count: int) -> list[tuple[float, float]]:
    """Shifts of the pixels, ordered so that successive ones are far apart."""
    offsets = [(x - 0.5, y - 0.5) for x, y in _core.sample_offsets(count)]
    step = next(n for n in range(max(round(count * _GOLDEN), 1), count + 1) if math.gcd(n, count) == 1)
    return [offsets[n * step % count] for n in range(count)]
