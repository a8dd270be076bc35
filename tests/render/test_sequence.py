"""Tests of camera paths: equal to single calls, two frames in progress at a time, and clean ends."""

from __future__ import annotations

import itertools
import os
import signal
import threading
import time
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from tests.support import need
from tests.support.gpu_cases import ADAPTERS, adapter, crowd, view

CAMERAS = [view((0.2 * step, 1.3, 1.0), (0, 0, -6), size=(64 + 8 * (step % 2), 48)) for step in range(5)]
IMAGES = ("color", "range", "object_id")


def equal(one: nf.Frame, other: nf.Frame) -> None:
    assert one.camera == other.camera
    assert one.channels == other.channels
    for name in one.channels:
        np.testing.assert_array_equal(one.require(name), other.require(name))


def pose(x: float) -> np.ndarray:
    matrix = np.eye(4)
    matrix[:3, 3] = (x, 0.3, -3.0)
    return matrix


@pytest.fixture(params=["cpu", *ADAPTERS])
def backend(request: pytest.FixtureRequest) -> Iterator[str]:
    if request.param == "cpu":
        yield "cpu"
        return
    with adapter(request.param):
        yield "gpu"


def test_frames_of_a_path_equal_single_calls(backend: str) -> None:
    scene = crowd()
    frames = nf.render_path(scene, CAMERAS, backend=backend)
    for camera, frame in zip(CAMERAS, frames, strict=True):
        equal(frame, nf.render(scene, camera, backend=backend))
    (frame,) = nf.render_path(scene, iter(CAMERAS[:1]), channels=("range",), samples=4, backend=backend)
    equal(frame, nf.render(scene, CAMERAS[0], channels=("range",), samples=4, backend=backend))
    assert list(nf.render_path(scene, [], backend=backend)) == []


def test_objects_move_along_the_path(backend: str) -> None:
    scene = crowd(("one_7",))
    poses = [{"one_7": pose(0.3 * step)} for step in range(5)]
    frames = list(nf.render_path(scene, CAMERAS, at=iter(poses), backend=backend))
    for camera, placed, frame in zip(CAMERAS, poses, frames, strict=True):
        equal(frame, nf.render(scene.at(placed), camera, channels=IMAGES, backend=backend))
    fixed = list(nf.render_path(scene, CAMERAS, at=poses[3], backend=backend))
    equal(fixed[0], nf.render(scene.at(poses[3]), CAMERAS[0], backend=backend))


def test_a_pose_changed_in_place_is_a_new_pose(backend: str) -> None:
    matrix = pose(0.0)

    def walk() -> Iterator[dict[str, Any]]:
        for step in range(3):
            matrix[0, 3] = 0.5 * step
            yield {"one_7": matrix}

    frames = nf.render_path(crowd(("one_7",)), [CAMERAS[0]] * 3, at=walk(), backend=backend)
    assert len({frame.require("object_id").tobytes() for frame in frames}) == 3


def test_frames_before_an_invalid_camera_precede_the_error(backend: str) -> None:
    path = nf.render_path(crowd(), iter([*CAMERAS[:2], 3]), backend=backend)  # type: ignore[arg-type]
    assert [next(path).camera, next(path).camera] == CAMERAS[:2]
    with pytest.raises(TypeError, match="cameras: expected Cameras, got int as number 2"):
        next(path)


def test_one_camera_is_requested_ahead() -> None:
    asked = []

    def cameras() -> Iterator[nf.Camera]:
        for number, camera in enumerate(CAMERAS):
            asked.append(number)
            yield camera

    with adapter("vulkan"):
        frames = nf.render_path(crowd(), cameras(), backend="gpu")
        assert asked == []
        next(frames)
        assert asked == [0, 1]
        next(frames)
        assert asked == [0, 1, 2]
        assert len(list(frames)) == 3


def test_stopping_early_drops_frames_in_progress(backend: str) -> None:
    scene = crowd()
    frames = nf.render_path(scene, itertools.repeat(CAMERAS[0]), backend=backend)
    first = [next(frames) for _ in range(3)]
    frames.close()  # type: ignore[attr-defined]  # A generator.
    with pytest.raises(StopIteration):
        next(frames)
    equal(first[0], nf.render(scene, CAMERAS[0], backend=backend))


def test_items_of_iterators_are_checked_on_arrival(backend: str) -> None:
    scene = crowd(("one_7",))
    ahead = 2 if backend == "gpu" else 1
    for arguments, error, words in (
        ({"cameras": iter([*CAMERAS[:2], "here"])}, TypeError, "cameras: expected Cameras, got str as number 2"),
        ({"cameras": iter(CAMERAS), "at": iter([{}, {}])}, ValueError, "at: expected a pose for each camera, got 2"),
        ({"cameras": CAMERAS, "at": iter([{}, {}, {"abacus": pose(0)}])}, ValueError, "poses"),
    ):
        given: dict[str, Any] = dict(arguments)
        frames = nf.render_path(scene, given.pop("cameras"), backend=backend, **given)
        for _ in range(3 - ahead):
            next(frames)
        with pytest.raises(error, match=words):
            list(frames)


def interrupted(frames: Iterator[nf.Frame], seconds: float) -> float:
    """CPU seconds of this process from a Ctrl-C to its exception."""
    sent = []

    def press() -> None:
        sent.append(time.process_time())
        signal.raise_signal(signal.SIGINT) if os.name == "nt" else os.kill(os.getpid(), signal.SIGINT)

    timer = threading.Timer(seconds, press)
    timer.start()
    try:
        with pytest.raises(KeyboardInterrupt):
            for _ in frames:
                pass
        return time.process_time() - sent[0]
    finally:
        timer.join()


def test_a_long_path_ends_with_control_c(backend: str) -> None:
    need("linux")
    scene = crowd()
    # A frame of these takes some milliseconds; the path is endless.
    assert interrupted(nf.render_path(scene, itertools.repeat(CAMERAS[0]), backend=backend), 0.2) < 5.0
    equal(next(nf.render_path(scene, CAMERAS, backend=backend)), nf.render(scene, CAMERAS[0], backend=backend))


@pytest.mark.parametrize("name", ADAPTERS)
def test_a_long_frame_ends_with_control_c(name: str) -> None:
    need("linux")
    scene, camera = crowd(), view((0, 1.3, 1.0), (0, 0, -6), size=(960, 540))
    with adapter(name):
        nf.render(scene, camera, backend="gpu")
        frames = nf.render_path(scene, itertools.repeat(camera), samples=1024, channels=("color",), backend="gpu")
        # Signals are polled every 128 submissions: a software adapter spends a part of a CPU second on each.
        assert interrupted(frames, 0.4) < 20.0
        assert np.isfinite(nf.render(scene, CAMERAS[0], backend="gpu").require("color")).all()
