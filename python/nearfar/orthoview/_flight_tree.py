"""Methods of a tree for moving viewers: flights and prefetch queues."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import SupportsFloat, SupportsIndex

import numpy as np
from numpy.typing import ArrayLike

from nearfar._base import check
from nearfar._camera.camera import Camera, Fov
from nearfar.orthoview._flight import THREADS, Flight
from nearfar.orthoview._pilot import MIN_SPEED, PrefetchSettings
from nearfar.orthoview._prefetch import Frustums, PrefetchQueue, offsets, queue, smallest_side
from nearfar.orthoview._renderable_tree import RenderableTree, settings_of

MARGIN = 5.0
"""Default margin around the picture within which flights prefetch, degrees."""


class FlightTree(RenderableTree):
    """A tree for moving viewers; for errors see `OrthoTree`."""

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
        threads: SupportsIndex = THREADS,
        on_error: Callable[[Exception], None] | None = None,
    ) -> Flight:
        """Begin a flight: pictures never wait for data, while threads read the parts that they need now and soon.

        Returns a `Renderable` with its own cache of `cache_bytes`; close it, or use it in a `with` block. Errors as in
        `cut`.

        Parameters
        ----------
        views, error_px, geometry, lift_deg
            As in `cut`.
        prefetch
            Whether to read parts that the viewer will need soon, after those of the picture.
        margin_deg
            Margin around the picture for prefetching, degrees, 0 to 180; None for all directions, for viewers that turn
            faster than views arrive.
        adapt
            Whether pictures become coarser when the viewer moves faster than `Flight.speed_limit`.
        threads
            Number of reading threads, 1 to 64. Each reads one part at a time: a view by one request, the geometry of a
            leaf file by file. So memory holds one part for each thread in addition to the cache.
        on_error
            Callback for read errors, called in the drawing thread; by default they are warnings.
        """
        settings = settings_of(views, error_px, geometry, lift_deg=lift_deg)
        margin = None if margin_deg is None else math.radians(check.in_range("margin_deg", margin_deg, 0.0, 180.0))
        ahead = PrefetchSettings(check.flag("prefetch", prefetch), margin, check.flag("adapt", adapt))
        return Flight(self._open_store(), settings, ahead, threads, on_error, self._movers)

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
        """Return the parts that a viewer at a position needs now and soon, in all directions.

        Parts needed soon are those of the cuts at positions ahead, which are as far away as the side of the present
        cut's smallest cell: until the viewer has moved that far, it needs no other parts. Returns the parts in the best
        order for reading; make a new queue after `renewed_after` metres. Errors as in `cut`.

        Parameters
        ----------
        position
            World position (3,) of the eye, metres.
        camera
            A view with the picture's size and field of view; 640 × 480 pixels and 60° by default.
        velocity
            World velocity (3,), metres a second: positions ahead lie along its direction. By default they lie along all
            axes, in both directions.
        views, error_px, geometry, lift_deg
            As in `cut`.
        """
        settings = settings_of(views, error_px, geometry, lift_deg=lift_deg)
        eye = check.vector("position", position)
        # By default the paper's picture size and field of view.
        paper = Camera(eye, fov=Fov.symmetric(60.0, 4 / 3), size=(640, 480))
        eye_camera = replace(paper if camera is None else check.instance("camera", camera, Camera), position=eye)
        speed = np.zeros(3) if velocity is None else np.array(check.vector("velocity", velocity))
        length = float(np.linalg.norm(speed))
        cutter = self._viewer.cutter
        ahead = smallest_side(cutter.complete_cut(eye_camera, settings, around=True), cutter.grid)
        places = np.array(eye) + offsets(ahead, speed / length if length > MIN_SPEED else None)
        cameras = [replace(eye_camera, position=check.vector("position", place)) for place in places]
        while True:
            parts = queue(cutter, settings, eye_camera, cameras, Frustums([eye_camera], None))
            if not parts.unknown:
                return parts
            for tier, place, _ in parts.unknown:
                cutter.read_record(tier, place)
