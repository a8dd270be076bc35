"""Settings of a simulated client: its strategy, its display and its speed."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, TypedDict, get_args

import numpy as np
from numpy.typing import ArrayLike

from nearfar._base import check
from nearfar._camera.camera import Camera
from nearfar.stream._head_path import HeadPath
from nearfar.stream._strategies import Strategy

RATE = 72.0
"""Frames per second of the headset in CloVR (2024)."""


@dataclass(frozen=True, kw_only=True, eq=False)
class ClientSettings:
    """Settings of the client that `simulate` simulates.

    Parameters
    ----------
    strategy
        "clovr": rings fade in, and the morph grows. "clovrd": the same rings without transitions. "vis0": blank until
        the near objects visible from the centre and the last map have arrived. "vis1": these objects in order of
        arrival, the map last. The last two need `export(by_footprint=True)`.
    head_path
        Position of the user's eye: one position in world metres, or rows of a time in seconds and a position, (N, 4),
        interpolated linearly and constant before and after. Default: the centre.
    camera
        View for the measurement, moved to the user's eye; by default all directions, as six cube faces.
    rate
        Frames per second, 1 to 1000.
    decode_mbs
        Megabytes per second that a worker decodes, one worker for maps and one for geometry; None for no decoding time.
    frame_ms, triangles_per_second
        Drawing time of a frame: fixed milliseconds, and triangles drawn per second; None for no time.

    Raises
    ------
    ValueError, TypeError
        Settings out of range or of another type.
    """

    strategy: Strategy = "clovr"
    head_path: ArrayLike | None = None
    camera: Camera | None = None
    rate: float = RATE
    decode_mbs: float | None = None
    frame_ms: float = 0.0
    triangles_per_second: float | None = None

    def __post_init__(self) -> None:
        check.choice("strategy", self.strategy, get_args(Strategy))
        decode, drawn = self.decode_mbs, self.triangles_per_second
        checked: dict[str, Any] = {
            "rate": check.in_range("rate", self.rate, 1.0, 1000.0),
            "decode_mbs": None if decode is None else check.in_range("decode_mbs", decode, 1e-6, 1e9),
            "frame_ms": check.in_range("frame_ms", self.frame_ms, 0.0, 1e9),
            "triangles_per_second": None if drawn is None else check.in_range("triangles_per_second", drawn, 1.0, 1e15),
        }
        if self.head_path is not None:
            HeadPath.parse(self.head_path, (0.0, 0.0, 0.0))
            checked["head_path"] = np.array(self.head_path, np.float64)
            checked["head_path"].setflags(write=False)
        if self.camera is not None:
            check.instance("camera", self.camera, Camera)
        for name, value in checked.items():
            object.__setattr__(self, name, value)

    @property
    def seconds_per_byte(self) -> float:
        """Decoding time of a byte in a worker, seconds."""
        return 0.0 if self.decode_mbs is None else 1e-6 / self.decode_mbs

    @property
    def seconds_per_triangle(self) -> float:
        """Drawing time of a triangle, seconds."""
        return 0.0 if self.triangles_per_second is None else 1.0 / self.triangles_per_second


class ClientKeywords(TypedDict, total=False):
    """Fields of `ClientSettings` as keywords of `simulate`; a test compares both."""

    strategy: Strategy
    head_path: ArrayLike | None
    camera: Camera | None
    rate: float
    decode_mbs: float | None
    frame_ms: float
    triangles_per_second: float | None
