"""Views in notebooks: their interface, and the function that creates them."""

from __future__ import annotations

import importlib.util
from collections.abc import Callable
from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from nearfar._camera.camera import Camera


class View(Protocol):
    """A view in a notebook, an anywidget widget; it is shown as the last value of a cell.

    The user walks and looks around in the browser, and Python reads the pose; or Python moves the user.
    """

    camera: Camera
    """Camera of the picture. Setting it moves the user, without roll, and sets the vertical field of view; its size is
    ignored."""
    position: tuple[float, float, float]
    """World position of the user's eye, metres."""
    yaw: float
    """Turn about the vertical axis, radians; 0 looks along −z, positive to the left."""
    pitch: float
    """Radians, −1.5 to 1.5; positive looks up."""
    angle: float
    """Vertical field of view, degrees, 10 to 150."""

    @property
    def ring(self) -> int:
        """Number of the last ring shown; −1 for none."""

    @property
    def region(self) -> int:
        """Number of the region shown."""

    @property
    def radius(self) -> float:
        """Present radius of the morph, metres."""

    @property
    def strength(self) -> float:
        """Present strength of the morph, 0 to 1."""

    @property
    def problem(self) -> str:
        """Last error message of the browser, a sentence; empty if there was none."""


_make_view: Callable[..., View]


def set_maker(make_view: Callable[..., View]) -> None:
    """Set the function that makes views. The package calls it on import, because a later stage implements views."""
    global _make_view
    _make_view = make_view


def show(
    source: object, *, center: tuple[float, float, float], size: tuple[int, int], camera: Camera | None, strategy: str
) -> View:
    """Make the view of a bundle or a reduced scene; ImportError without anywidget."""
    if importlib.util.find_spec("anywidget") is None:
        raise ImportError("show needs anywidget: pip install anywidget")
    return _make_view(source, center=center, size=size, camera=camera, strategy=strategy)
