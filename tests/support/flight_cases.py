"""Cameras around a tree, and stores read under control of the test, for tests of flights."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar.orthoview._cut import GEOMETRY, Part
from nearfar.orthoview._layout import ViewKey
from nearfar.orthoview._near import Near
from nearfar.orthoview._views import Views

LONG = 120.0
"""Timeout of a test in seconds."""

FOV = nf.Fov.symmetric(50)
CHANNELS = ("color", "range", "albedo", "normal")


def camera_at(
    tree: nf.orthoview.OrthoTree, distance: float, angle: float = 0.3, size: tuple[int, int] = (64, 48)
) -> nf.Camera:
    """A view of the tree's middle from above."""
    middle = tree.bounds.mean(axis=0)
    toward = np.array([np.cos(angle), 0.6, np.sin(angle)])
    return nf.Camera.look_at(middle + distance * toward / np.linalg.norm(toward), middle, fov=FOV, size=size)


def parts_of(tree: nf.orthoview.OrthoTree, camera: nf.Camera, **settings: Any) -> list[Part]:
    """Geometry and views of the cut all around, in its order."""
    cut = tree.cut(camera, around=True, **settings)
    leaves = tree._viewer.cutter.with_guests(cut.leaf_places())
    return [*((0, place, GEOMETRY) for place in leaves), *cut.keys()]


def images_of(frame: nf.Frame) -> dict[str, NDArray[Any]]:
    return {name: frame.require(name) for name in frame.channels}


def is_same(one: nf.Frame, other: nf.Frame) -> bool:
    """Whether two frames have the same bytes."""
    pairs = zip(images_of(one).items(), images_of(other).items(), strict=True)
    return all(name == other and left.tobytes() == right.tobytes() for (name, left), (other, right) in pairs)


def there(frame: nf.Frame) -> NDArray[np.bool_]:
    """The pixels that show a surface."""
    is_there: NDArray[np.bool_] = np.isfinite(frame.require("range"))
    return is_there


def readers() -> set[threading.Thread]:
    """Threads that read for flights, including those of other tests' flights that were not closed."""
    return {thread for thread in threading.enumerate() if thread.name == "nearfar-flight"}


class Gate:
    """Blocks the threads that read views and geometry, and records what they read."""

    def __init__(self) -> None:
        self.views: list[ViewKey] = []
        self.leaves: list[tuple[int, int, int]] = []
        self._open = threading.Event()
        self._permits, self._done = threading.Semaphore(0), threading.Semaphore(0)
        self._open.set()

    def close(self) -> None:
        """Block all reads."""
        self._done = threading.Semaphore(0)
        self._open.clear()

    def open(self) -> None:
        """Let all reads pass."""
        self._open.set()
        self._permits.release(1000)

    def pass_some(self, count: int) -> None:
        """Let a number of reads pass, and wait for their end."""
        self._permits.release(count)
        for _ in range(count):
            assert self._done.acquire(timeout=LONG)

    def enter(self) -> None:
        """Enter the gate; the test's own thread always passes."""
        if not self._open.is_set() and threading.current_thread() is not threading.main_thread():
            assert self._permits.acquire(timeout=LONG)

    def leave(self) -> None:
        """Count a completed read."""
        if threading.current_thread() is not threading.main_thread():
            self._done.release()


@contextmanager
def gated(patch: pytest.MonkeyPatch) -> Iterator[Gate]:
    """Route all reads of flights within a block through a gate; it is open at first, and at the end."""
    gate, load, near = Gate(), Views.load, Near.load

    def load_views(views: Views, keys: Sequence[ViewKey]) -> None:
        gate.enter()
        if threading.current_thread() is not threading.main_thread():
            gate.views.extend(key for key in keys if key not in views.cache)
        load(views, keys)
        gate.leave()

    def load_leaves(own: Near, places: Sequence[tuple[int, int, int]]) -> None:
        gate.enter()
        if threading.current_thread() is not threading.main_thread():
            gate.leaves.extend(place for place in places if place not in own.cache)
        near(own, places)
        gate.leave()

    patch.setattr(Views, "load", load_views)
    patch.setattr(Near, "load", load_leaves)
    try:
        yield gate
    finally:
        gate.open()


def whole(flight: nf.orthoview.Flight, draw: Callable[[], Any]) -> Any:
    """Draw until nothing is missing, waiting in between."""
    draw()
    assert flight.wait(LONG)
    return draw()


def holes(frame: nf.Frame, truth: nf.Frame) -> float:
    """Share of the pixels that show a surface in truth and none in a frame."""
    is_hit = np.isfinite(truth.require("range"))
    return float((is_hit & np.isinf(frame.require("range"))).sum() / is_hit.sum())
