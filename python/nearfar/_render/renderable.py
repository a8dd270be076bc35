"""The `Renderable` protocol: the interface of scenes, reduced scenes and other sources of pictures."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any, Protocol, Self, runtime_checkable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check
from nearfar._camera.shot import Shot
from nearfar._scene.levels import Leveled

Report = Callable[[int, int], None] | None
"""Callback that takes the finished and the total amount of work, or None."""

Images = dict[str, Any]
"""The images of a frame by channel, with shapes and types as in `Frame`, and its `stats`, if it has any."""


class Job(Protocol):
    """A picture that a device is drawing."""

    def finish(self, report: Report = None) -> Images:
        """Wait until the picture is drawn, and read it back."""


@runtime_checkable
class Renderable(Protocol):
    """Source of pictures for `nearfar.render` and `nearfar.render_path`.

    `Scene`, `ReducedScene` and `Impostors` are renderables. To write another, derive from this protocol and define
    `trace`, and `begin` for graphics adapters. The rest has defaults for sources in world coordinates that have only
    colours and in which nothing moves and nothing has levels of detail.
    """

    @property
    def origin(self) -> ArrayLike:
        """World position (3,) in metres that `Frame.position` is relative to."""
        return (0.0, 0.0, 0.0)

    @property
    def default_channels(self) -> tuple[str, ...]:
        """Images that are computed by default."""
        return ("color",)

    @property
    def backends(self) -> tuple[str, ...]:
        """Backends that can render this source, of "cpu" and "gpu"."""
        return ("cpu", "gpu")

    @property
    def triangle_count(self) -> int:
        """Number of triangles that a picture draws."""
        return 0

    @property
    def object_names(self) -> tuple[str, ...]:
        """Names of all objects, by number."""
        return ()

    @property
    def poses(self) -> dict[str, NDArray[np.float64]]:
        """Present poses (4, 4), object→world, of the objects that can move, as `at` takes them."""
        return {}

    def displayed(self, points: ArrayLike, user: ArrayLike) -> NDArray[np.float64]:
        """Return where world positions (N, 3) are displayed for a user at a world position (3,), metres."""
        return check.array("points", points, columns=3, dtype=np.float64)

    def at(self, poses: Mapping[str, ArrayLike]) -> Self:
        """Return the same source with dynamic objects in other poses; `poses` as in `Scene.at`."""
        raise ValueError(f"at: expected no poses for {type(self).__name__}, in which nothing moves")

    def at_levels(self, levels: ArrayLike | Mapping[str, int]) -> Self:
        """Return the same source with objects at these levels of detail; `levels` as in `Scene.at_levels`."""
        raise ValueError(f"lod: expected None for {type(self).__name__}, which has no levels")

    def shown_to(self, user: ArrayLike) -> Leveled | None:
        """Return the objects with levels as a user at a world position (3,) sees them; None if there are none."""
        return None

    def trace(self, shot: Shot, report: Report = None) -> Sequence[Images]:
        """Render the pictures of a shot on the CPU, one for each camera."""
        raise ValueError(f"backend: expected 'gpu' for {type(self).__name__}, which is not traced")

    def begin(self, device: _core.GpuDevice, shot: Shot, report: Report = None) -> Sequence[Job]:
        """Start the pictures of a shot on a device, one for each camera."""
        raise ValueError(f"backend: expected 'cpu' for {type(self).__name__}, which no graphics adapter draws")


def check_renderable(argument: str, source: object) -> None:
    """Raise TypeError for anything that is not a `Renderable`."""
    if not isinstance(source, Renderable):
        expected = "a Scene, a ReducedScene or another Renderable"
        raise TypeError(f"{argument}: expected {expected}, got {type(source).__name__}")
