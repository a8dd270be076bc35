"""Flights through a tree: pictures show the data read so far, while background threads read more."""

from __future__ import annotations

import contextlib
import math
import threading
import time as clock
import warnings
from collections import defaultdict
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Self, SupportsFloat, SupportsIndex, Unpack

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check
from nearfar._base.errors import DeviceError
from nearfar._base.settings import gather
from nearfar._camera.camera import Camera
from nearfar._camera.shot import Shot
from nearfar._render.frame import Frame
from nearfar._render.renderable import Images, Renderable, Report
from nearfar._render.renderer import Renderer
from nearfar._render.settings import RenderKeywords, RenderSettings
from nearfar._scene.scene import Scene
from nearfar.orthoview._cut import GEOMETRY, RECORD, Part, Settings, kind
from nearfar.orthoview._loader import Loader
from nearfar.orthoview._meter import LinkTotals
from nearfar.orthoview._pilot import Pilot, Plan, PrefetchSettings
from nearfar.orthoview._standins import Cell, PartsByCell, PicturePieces, Piece, StandIns
from nearfar.orthoview._viewer import OpenStore, OrthoRenderable, Parts, Viewer

THREADS, MAX_THREADS = 16, 64
"""Default and maximum number of reading threads; each has one request at a time."""

Listener = Callable[[Exception], None]
"""Callback for errors of the background threads."""


class Flight(OrthoRenderable):
    """A viewer that moves through a tree and never waits.

    A picture is drawn from the data read so far. Where views of the cut are missing, it keeps the content of the
    previous picture, or shows parts of coarser views. Threads read the missing parts, the nearest first, then parts
    that the viewer will need soon. `OrthoTree.fly` begins a flight; `close` or its `with` block ends it.
    """

    def __init__(
        self,
        opened: OpenStore,
        settings: Settings,
        ahead: PrefetchSettings,
        threads: SupportsIndex,
        on_error: Listener | None,
        movers: Scene | None = None,
    ) -> None:
        self._opened = check.instance("opened", opened, OpenStore, "what OrthoTree.fly passes")
        view_settings = check.instance("settings", settings, Settings, "what OrthoTree.fly passes")
        if on_error is not None and not callable(on_error):
            raise TypeError(f"on_error: expected a function or None, got {check.type_and_value(on_error)}")
        count = check.integer("threads", threads, 1, MAX_THREADS)
        self._on_error = on_error
        self._viewer: Viewer = opened.viewer
        prefetch_settings = check.instance("ahead", ahead, PrefetchSettings, "what OrthoTree.fly passes")
        self._pilot = Pilot(self._viewer.cutter, view_settings, prefetch_settings)
        self._stand_ins = StandIns(opened.grid, opened.units, self._has, self._drawable, view_settings.views)
        self._movers = None if movers is None else check.instance("movers", movers, Scene)
        self._previous: defaultdict[int, PicturePieces] = defaultdict(PicturePieces)
        """Pieces of the previous pictures, by number of the picture in its shot."""
        self._clipped: dict[Piece, list[_core.OrthoSplats]] = {}
        self._device: _core.GpuDevice | None = None
        """Graphics adapter that draws; threads upload views to it as soon as they arrive."""
        self._lock = threading.RLock()
        self._had_requests = False
        self._errors: list[Exception] = []
        self._loader = Loader(self._read, self._has, count)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *error: object) -> None:
        self.close()

    def close(self) -> None:
        """Stop reading. Data read so far can still be drawn."""
        self._loader.close()

    @property
    def origin(self) -> NDArray[np.float64]:
        """World position (3,) in metres that `Frame.position` is relative to."""
        return self._viewer.origin

    @property
    def errors(self) -> tuple[Exception, ...]:
        """Read errors so far: one for each damaged part, and the first one of each outage of the store."""
        self._collect_errors()
        return tuple(self._errors)

    @property
    def waiting(self) -> int:
        """Number of parts that are being read or queued."""
        return self._loader.waiting

    @property
    def bytes_read(self) -> int:
        """Bytes of views and geometry received."""
        return self._received().bytes

    @property
    def speed_limit(self) -> float:
        """Greatest speed of the viewer at which the link keeps up, metres a second; above it, pictures are coarser.

        Infinite until the viewer moves and something has been read.
        """
        return self._pilot.speed_limit

    def look(self, camera: Camera, time: SupportsFloat | None = None) -> None:
        """Set the viewer's camera and read the parts that it needs, without drawing.

        `time` is in seconds of any monotonic clock, by default the computer's own. ValueError and TypeError for a value
        that is not a camera, or a time that is not finite.
        """
        viewer_camera = check.instance("camera", camera, Camera)
        seconds = clock.monotonic() if time is None else check.number("time", time)
        with self._lock:
            self._trim(self._plan([viewer_camera], seconds))

    def render(
        self,
        camera: Camera,
        *,
        time: SupportsFloat | None = None,
        settings: RenderSettings | None = None,
        **keywords: Unpack[RenderKeywords],
    ) -> Frame:
        """Draw the data read so far, without waiting for more. Errors as in `OrthoTree.render`.

        The frame's `stats` has the counts of `OrthoTree.render`; `missing`, the number of cells of the cut that lack a
        view or their geometry plus the number of subtrees whose records have not been read; `empty`, the number of
        these cells and subtrees in whose place nothing is drawn; and `error_px` of the picture.

        Parameters
        ----------
        camera
            The view.
        time
            Seconds of any monotonic clock, for the viewer's speed; the computer's own by default.
        settings
            Samples, channels, limits and backend, as `nearfar.RenderSettings`. The background threads upload views to
            the adapter.
        keywords
            Fields of `settings`, which they replace.
        """
        seconds = None if time is None else check.number("time", time)
        render_settings = gather(RenderSettings, settings, keywords)
        renderer = Renderer(_PosedFlight(self, seconds, self._movers), render_settings, argument="flight")
        (frame,) = renderer.frames(renderer.shot([camera]), None, renderer.device(self))
        return frame

    def at(self, poses: Mapping[str, ArrayLike]) -> Renderable:  # type: ignore[override]
        """Return the same flight with moving objects in other poses; `poses` as in `Scene.at`."""
        if self._movers is None:
            return super().at(poses)
        return _PosedFlight(self, None, self._movers.at(poses))

    def _pictures(self, shot: Shot, device: _core.GpuDevice | None, report: Report) -> list[Images]:
        return self._draw(shot, None, self._movers, device, report)

    def _draw(
        self, shot: Shot, time: float | None, movers: Scene | None, device: _core.GpuDevice | None, report: Report
    ) -> list[Images]:
        """Draw the pictures of a shot at a time, with moving objects."""
        self._device = device
        seconds = clock.monotonic() if time is None else time
        with self._lock:
            plan = self._plan(shot.cameras, seconds)
            pictures_to_draw = zip(shot.cameras, (plan.wanted, *plan.further_pictures), plan.unknown, strict=True)
            pieces_by_picture = [self._choose_pieces(n, *picture) for n, picture in enumerate(pictures_to_draw)]
            self._trim(plan)
            parts_by_picture = [self._parts(pieces, movers) for pieces in pieces_by_picture]
        self._report_errors()
        pictures = []
        for camera, parts, unbuilt in zip(shot.cameras, parts_by_picture, plan.unbuilt, strict=True):
            pictures.append(self._viewer.picture(camera, shot, parts, report, device))
            pictures[-1]["stats"] |= {"error_px": plan.error_px, "unbuilt": unbuilt}
        return pictures

    def wait(self, seconds: SupportsFloat | None = None) -> bool:
        """Wait until all parts have been read that the last picture and the positions ahead need.

        Waits at most `seconds`; None is no limit. Returns False after a timeout, or if a part cannot be read now.
        """
        limit = None if seconds is None else check.in_range("seconds", seconds, 0.0, 1e9)
        ends = math.inf if limit is None else clock.monotonic() + limit
        while self._loader.wait(max(ends - clock.monotonic(), 0.0) if limit is not None else None):
            with self._lock:
                camera = self._pilot.camera
                if camera is None:
                    return True
                # Records that arrived may add parts to the plan.
                plan = self._pilot.plan(self._has)
                if all(map(self._has, plan.order)):
                    return True
                waiting = self._loader.waiting
                self._loader.want(plan.order)
                if not waiting and not self._loader.waiting:  # the remaining parts are damaged
                    return False
        return False

    def refresh(self) -> bool:
        """Switch to the newest generation of the store; return whether there was a newer one.

        If the store is still being built, switch to the cells that have been built by now.

        Pictures keep the views that the update did not change, and show old versions of changed views until the new
        ones have arrived. Damaged parts are read again. FormatError and OSError for damaged or unreadable documents of
        the store; then the flight keeps its state.
        """
        newer = self._opened.newer()
        with self._lock:
            self._loader.forget()
            if newer is None:
                return False
            if self._pilot.camera is not None:  # read the subtrees of the current picture before switching
                newer.viewer.cutter.complete_cut(self._pilot.camera, self._pilot.settings)
            self._opened = newer
            self._viewer = newer.viewer
            self._pilot.switch_to(newer.viewer.cutter)
            return True

    def _plan(self, cameras: Sequence[Camera], time: float) -> Plan:
        self._pilot.meter.note(time, self._received(), had_requests=self._had_requests)
        self._pilot.look(cameras[0], time, cameras[1:])
        plan = self._pilot.plan(self._has)
        self._loader.want(plan.order)
        self._had_requests = self._loader.waiting > 0
        return plan

    def _choose_pieces(self, number: int, camera: Camera, parts_by_cell: PartsByCell, unknown: int) -> PicturePieces:
        """Choose the pieces for picture `number` of a shot; `unknown` is the picture's entry in `Plan.unknown`."""
        pieces = self._stand_ins.choose_pieces(parts_by_cell, self._previous[number], np.array(camera.position))
        self._previous[number] = pieces
        is_root_unknown = unknown > 0 and not parts_by_cell
        return replace(pieces, missing=pieces.missing + unknown, empty=pieces.empty + is_root_unknown)

    def _parts(self, picture: PicturePieces, movers: Scene | None) -> Parts:
        splats = [layer for pieces in picture.cells.values() for piece in pieces for layer in self._splats(piece)]
        leaves = {part[1] for parts in picture.leaves.values() for part in parts}
        views = sum(len(pieces) for pieces in picture.cells.values())
        counts: dict[str, float] = {"cells": len(picture.cells), "views": views, "leaves": len(picture.leaves)}
        counts |= {"missing": picture.missing, "empty": picture.empty}
        return Parts(splats, self._viewer.near.cached_scene(sorted(leaves)), movers, counts)

    def _splats(self, piece: Piece) -> Sequence[_core.OrthoSplats]:
        if piece.within is None:
            return self._viewer.views.cached_layers(piece.part)
        if piece not in self._clipped:
            level, place, _ = piece.part
            (low, high), sides = self._opened.grid.box(*piece.within), self._opened.grid.box(level, place)
            # Rounded depths may lie beyond the view's own sides, so its sides do not clip.
            low, high = np.where(low == sides[0], -np.inf, low), np.where(high == sides[1], np.inf, high)
            ends = low.tolist(), high.tolist()
            self._clipped[piece] = [layer.crop_to_box(*ends) for layer in self._viewer.views.cached_layers(piece.part)]
        return self._clipped[piece]

    def _trim(self, plan: Plan) -> None:
        """Evict unused views and leaves until the caches fit their size; drop clipped pieces that no picture shows."""
        pieces = {piece for picture in self._previous.values() for cell in picture.cells.values() for piece in cell}
        self._clipped = {piece: splats for piece, splats in self._clipped.items() if piece in pieces}
        needed = {*plan.order, *(part for picture in self._previous.values() for part in picture.parts())}
        self._viewer.views.trim(needed)
        self._viewer.near.trim({place for _, place, direction in needed if direction == GEOMETRY})

    def _has(self, part: Part) -> bool:
        viewer, (level, place, _) = self._viewer, part
        if kind(part) == RECORD:
            return viewer.cutter.knows(level, place)
        return place in viewer.near.cache if kind(part) == GEOMETRY else part in viewer.views.cache

    def _drawable(self, cell: Cell) -> frozenset[int]:
        level, place = cell
        views = self._viewer.views.cached_directions(level, place)
        return views | {GEOMETRY} if level == 0 and place in self._viewer.near.cache.values else views

    def _read(self, part: Part) -> bool:
        """Read a part; return whether it is in the store, and not an empty leaf, which is known without a request."""
        viewer, (level, place, _) = self._viewer, part
        if kind(part) == GEOMETRY:
            return viewer.near.load([place])
        if kind(part) == RECORD:
            viewer.cutter.read_record(level, place)
        else:
            viewer.views.load([part])
            self._upload(part)
        return True

    def _upload(self, part: Part) -> None:
        """Upload a view to the drawing adapter, before a picture shows it."""
        if (device := self._device) is None:
            return
        splats = list(self._viewer.views.cached_layers(part))
        with contextlib.suppress(DeviceError, MemoryError):  # the next picture that shows the view tries again
            _core.gpu_keep_orthoviews(device, splats)

    def _received(self) -> LinkTotals:
        views, near = self._viewer.views.cache, self._viewer.near.cache
        return LinkTotals(views.reads, views.read_bytes, near.reads, near.read_bytes)

    def _collect_errors(self) -> list[Exception]:
        """Add the background errors since the last call to `errors`, and return them."""
        errors = self._loader.errors()
        self._errors += errors
        return errors

    def _report_errors(self) -> None:
        """Report background errors to `on_error`, or as warnings."""
        for error in self._collect_errors():
            if self._on_error is not None:
                self._on_error(error)
            else:
                warnings.warn(f"{type(error).__name__}: {error}", RuntimeWarning, stacklevel=2)


class _PosedFlight(OrthoRenderable):
    """A flight at one time, with moving objects in given poses."""

    def __init__(self, flight: Flight, time: float | None, movers: Scene | None) -> None:
        self._flight, self._time, self._movers = flight, time, movers

    @property
    def origin(self) -> NDArray[np.float64]:
        return self._flight.origin

    def _pictures(self, shot: Shot, device: _core.GpuDevice | None, report: Report) -> list[Images]:
        return self._flight._draw(shot, self._time, self._movers, device, report)
