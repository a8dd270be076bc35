"""What renderers take: scenes, reduced scenes, and whatever else shows itself to cameras."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any, Protocol, Self, runtime_checkable

from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._camera.shot import Shot
from nearfar._scene.levels import Leveled

Report = Callable[[int, int], None] | None
"""Takes how much is done and how much there is."""

Images = dict[str, NDArray[Any]]
"""The images of a frame by channel, as `Frame` has them."""


class Job(Protocol):
    """A picture that a device is drawing."""

    def finish(self, report: Report = None) -> Images:
        """Wait for the picture and read it back."""


@runtime_checkable
class Renderable(Protocol):
    """What `nearfar.render` and `nearfar.render_path` take.

    `Scene` and `ReducedScene` are renderables. A class of your own becomes one by deriving from this and defining
    `origin`, `default_channels` and `trace`, and `begin` for graphics adapters; the other methods say that nothing
    moves and that nothing has levels of detail.
    """

    @property
    def origin(self) -> ArrayLike:
        """World position (3,) in metres that `Frame.position` is relative to."""
        return (0.0, 0.0, 0.0)

    @property
    def default_channels(self) -> tuple[str, ...]:
        """Images that are computed where nobody says which."""
        return ("color",)

    @property
    def backends(self) -> tuple[str, ...]:
        """Where pictures can be made: "cpu", "gpu"."""
        return ("cpu", "gpu")

    @property
    def triangle_count(self) -> int:
        """Triangles that a picture draws."""
        return 0

    def at(self, poses: Mapping[str, ArrayLike]) -> Self:
        """Return the same with dynamic objects in other places; `poses` are those of `Scene.at`."""
        raise ValueError(f"at: expected no poses for {type(self).__name__}, in which nothing moves")

    def at_levels(self, levels: ArrayLike | Mapping[str, int]) -> Self:
        """Return the same with objects at these levels of detail, as `Scene.at_levels` takes them."""
        raise ValueError(f"lod: expected None for {type(self).__name__}, which has no levels")

    def shown_to(self, user: ArrayLike) -> Leveled | None:
        """Objects that have levels, where a user at a world position (3,) sees them; None where none has any."""
        return None

    def trace(self, shot: Shot, report: Report = None) -> Sequence[Images]:
        """Make the pictures of a shot on the CPU, one for each camera."""
        raise ValueError(f"backend: expected 'gpu' for {type(self).__name__}, which is not traced")

    def begin(self, device: _core.GpuDevice, shot: Shot, report: Report = None) -> Sequence[Job]:
        """Begin the pictures of a shot on a device, one for each camera."""
        raise ValueError(f"backend: expected 'cpu' for {type(self).__name__}, which no graphics adapter draws")


def check_renderable(argument: str, source: object) -> None:
    """Refuse what can't be rendered: TypeError."""
    if not isinstance(source, Renderable):
        expected = "a Scene, a ReducedScene or another Renderable"
        raise TypeError(f"{argument}: expected {expected}, got {type(source).__name__}")
