"""The methods of a tree for viewers that move: flights, and what to read ahead of one."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import SupportsFloat, SupportsIndex

import numpy as np
from numpy.typing import ArrayLike

from nearfar._base import check
from nearfar._camera.camera import Camera, Fov
from nearfar.orthoview._flight import Flight
from nearfar.orthoview._pilot import LEAST_SPEED, Ahead
from nearfar.orthoview._prefetch import Outlook, PrefetchQueue, offsets, queue, smallest
from nearfar.orthoview._shown import ShownTree, settings_of

MARGIN = 5.0
"""Degrees around the picture within which flights read ahead by default."""


class FlownTree(ShownTree):
    """A tree for viewers that move; `OrthoTree` tells what it raises."""

    def fly(
        self,
        *,
        views: SupportsIndex = 3,
        error_px: SupportsFloat = 1.0,
        geometry: bool = True,
        lift_deg: SupportsFloat = 0.0,
        prefetch: bool = True,
        margin_deg: SupportsFloat | None = MARGIN,
        adapt: bool = True,
        threads: SupportsIndex = 2,
        on_error: Callable[[Exception], None] | None = None,
    ) -> Flight:
        """Begin a flight: pictures that never wait, while threads read what they need now and soon.

        Parameters
        ----------
        views, error_px, geometry, lift_deg
            As in `cut`.
        prefetch
            Whether what the viewer needs soon is read, besides what the picture shows.
        margin_deg
            Degrees around the picture within which it is, 0 to 180; None for all around, for viewers that turn faster
            than views arrive.
        adapt
            Whether pictures become coarser when the viewer moves faster than `Flight.speed_limit`.
        threads
            Number of threads that read, 1 to 64.
        on_error
            Is called with errors of reading, in the thread that draws; by default they are warnings.

        Returns
        -------
        Flight
            A `Renderable` with views of its own in `cache_bytes` of memory; close it, or use it in a `with` block.

        Raises
        ------
        ValueError
            Values out of range; a tree that is not complete.
        TypeError
            Values of a wrong kind.
        FormatError, OSError
            Documents of the store that are damaged, or that cannot be read.

        References
        ----------
        Chaudhuri et al., A System for View-Dependent Rendering of Very Large Scenes Using Orthoviews, section 4.
        """
        settings = settings_of(views, error_px, geometry, lift_deg=lift_deg)
        margin = None if margin_deg is None else math.radians(check.within("margin_deg", margin_deg, 0.0, 180.0))
        ahead = Ahead(check.flag("prefetch", prefetch), margin, check.flag("adapt", adapt))
        return Flight(self._opened(), settings, ahead, threads, on_error, self._movers)

    def prefetch_queue(
        self,
        position: ArrayLike,
        *,
        camera: Camera | None = None,
        velocity: ArrayLike | None = None,
        views: SupportsIndex = 3,
        error_px: SupportsFloat = 1.0,
        geometry: bool = True,
        lift_deg: SupportsFloat = 0.0,
    ) -> PrefetchQueue:
        """Return what a viewer at a position needs now and soon, all around it.

        Positions ahead are as far away as the smallest cell of the cut is long: the cut cannot change more until the
        viewer has gone there.

        Parameters
        ----------
        position
            World position (3,) of the eye, metres.
        camera
            A view with the picture's size and field of view; 640 × 480 pixels and 60° by default.
        velocity
            World velocity (3,), metres a second: positions ahead are along its direction. By default they are ahead
            along all axes.
        views, error_px, geometry, lift_deg
            As in `cut`.

        Returns
        -------
        PrefetchQueue
            The parts in the order in which they are best read; ask anew after `renewed_after` metres.

        Raises
        ------
        ValueError, TypeError, FormatError, OSError
            As in `cut`.

        References
        ----------
        Chaudhuri et al., A System for View-Dependent Rendering of Very Large Scenes Using Orthoviews, section 4.3.
        """
        settings = settings_of(views, error_px, geometry, lift_deg=lift_deg)
        eye = check.vector("position", position)
        model = _paper(eye) if camera is None else check.instance("camera", camera, Camera)
        speed = np.zeros(3) if velocity is None else np.array(check.vector("velocity", velocity))
        length = float(np.linalg.norm(speed))
        here, cutter = _at(model, np.array(eye)), self._viewer.cutter
        ahead = smallest(cutter.whole(here, settings, around=True), cutter.grid)
        places = np.array(eye) + offsets(ahead, speed / length if length > LEAST_SPEED else None)
        cameras = [_at(model, place) for place in places]
        while True:
            found = queue(cutter, settings, here, cameras, Outlook([here], None))
            if not found.unknown:
                return found
            for tier, place, _ in found.unknown:
                cutter.learn(tier, place)


def _paper(eye: tuple[float, float, float]) -> Camera:
    """The paper's picture."""
    return Camera(eye, fov=Fov.symmetric(60.0, 4 / 3), size=(640, 480))


def _at(camera: Camera, place: np.ndarray[tuple[int], np.dtype[np.float64]]) -> Camera:
    x, y, z = place.tolist()
    return Camera((x, y, z), camera.orientation, fov=camera.fov, size=camera.size)
