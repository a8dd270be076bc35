"""Tests of adapter failures: each raises an error with a message, and the next picture is right."""

from __future__ import annotations

import threading
from pathlib import Path

import numpy as np
import pytest

import nearfar as nf
from nearfar._render import backend as backends
from tests.support import need
from tests.support.gpu_cases import ADAPTERS, adapter, crowd, program, view

CAMERA = view((0, 1.3, 1.0), (0, 0, -6), size=(96, 64))


@pytest.mark.parametrize("name", ADAPTERS)
def test_a_device_lost_between_frames_is_opened_again(name: str) -> None:
    scene = crowd()
    with adapter(name):
        before = nf.render(scene, CAMERA, backend="gpu")
        device = backends.open_device()
        device.lose()
        after = nf.render(scene, CAMERA, backend="gpu")
        np.testing.assert_array_equal(after.require("color"), before.require("color"))
        # A new device has no data, so the scene was uploaded again.
        assert nf.gpu.stats()["uploaded_bytes"] > 1000
        with pytest.raises(nf.DeviceError, match="the device was lost"):
            device.truth(scene._core, [CAMERA._core], nf.Shot(cameras=(CAMERA,), channels=("range",)).settings)


@pytest.mark.parametrize("name", ADAPTERS)
def test_a_device_lost_during_a_frame_suggests_a_remedy(name: str) -> None:
    scene = crowd()
    with adapter(name):
        label = nf.gpu.selected().label
        frames = nf.render_path(scene, [CAMERA] * 4, backend="gpu")
        first = next(frames)
        backends.open_device().lose()
        with pytest.raises(nf.DeviceError) as caught:
            next(frames)
        assert str(caught.value).startswith(label)
        assert "the next call opens it again, backend='cpu' needs none" in str(caught.value)
        with pytest.raises(StopIteration):
            next(frames)
        again = nf.render(scene, CAMERA, backend="gpu")
        np.testing.assert_array_equal(again.require("color"), first.require("color"))


@pytest.mark.parametrize("name", ADAPTERS)
def test_a_device_lost_in_another_thread_while_frames_are_drawn(name: str) -> None:
    """Frames are right or raise a DeviceError, at whatever moment the device is lost."""
    scene, stop = crowd(), threading.Event()
    drawn = lost = 0
    with adapter(name):
        right = nf.render(scene, CAMERA, backend="gpu").require("color")

        def lose() -> None:
            nonlocal lost
            pause = 0.03
            while not stop.wait(pause):
                backends.open_device().lose()
                lost += 1
                pause *= 1.0 if drawn else 1.1  # until a slow machine has drawn a frame

        thread = threading.Thread(target=lose)
        thread.start()
        try:
            while lost < 12 or not drawn:
                try:
                    frame = nf.render(scene, CAMERA, backend="gpu")
                except nf.DeviceError:
                    continue
                np.testing.assert_array_equal(frame.require("color"), right)
                drawn += 1
        finally:
            stop.set()
            thread.join()
        np.testing.assert_array_equal(nf.render(scene, CAMERA, backend="gpu").require("color"), right)


@pytest.mark.parametrize("name", ADAPTERS)
def test_two_threads_draw_one_scene_at_once(name: str) -> None:
    """The first upload must not wait for a lock that its own thread holds."""
    with adapter(name):
        for _ in range(5):
            scene = crowd()
            got: list[nf.Frame] = []

            def draw(scene: nf.Scene = scene, got: list[nf.Frame] = got) -> None:
                got.extend(nf.render(scene, CAMERA, backend="gpu") for _ in range(3))

            threads = [threading.Thread(target=draw) for _ in range(4)]
            for thread in threads:
                thread.start()
            for thread in threads:
                thread.join(60.0)
                assert not thread.is_alive()
            assert len(got) == 12
            for frame in got:
                np.testing.assert_array_equal(frame.require("color"), got[0].require("color"))


OUT_OF_MEMORY = """
import resource, sys
nf.gpu.select({name!r})
small = nf.render(scene, camera, backend="gpu")
large = nf.Camera((0, 0, 0), fov=nf.Fov.symmetric(60), size=(4096, 4096))
count = 2_000_000
points = np.random.default_rng(0).random((count, 3), dtype=np.float32)
faces = (np.arange(3 * count, dtype=np.uint32) % count).reshape(-1, 3)
heavy = nf.Scene.from_arrays(points, faces)
# Software drivers compile for each kind of picture and end the process if they fail, so compile now.
nf.render(scene, camera, channels=("range",), samples=4, backend="gpu")
used = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
caught = 0
for room in range(0, 420, 30):
    resource.setrlimit(resource.RLIMIT_AS, (used + (room << 20), resource.RLIM_INFINITY))
    try:
        if {what!r} == "image":
            nf.render(scene, large, channels=("range",), samples=4, backend="gpu")
        else:
            nf.render(heavy, camera, backend="gpu")
    except (nf.DeviceError, MemoryError) as error:
        caught += 1
    resource.setrlimit(resource.RLIMIT_AS, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
    again = nf.render(scene, camera, backend="gpu")
    np.testing.assert_array_equal(again.color, small.color)
print(caught)
"""


@pytest.mark.slow
@pytest.mark.parametrize("name", ADAPTERS)
@pytest.mark.parametrize("what", ["image", "scene"])
def test_without_memory_there_is_an_error_and_the_next_frame_is_right(name: str, what: str) -> None:
    need("linux")
    need(name)
    process = program(OUT_OF_MEMORY.format(name=name, what=what))
    assert process.returncode == 0, process.stderr[-2000:]
    assert int(process.stdout) >= 3


FORK = """
import os, sys, time
nf.gpu.select({name!r})
before = nf.render(scene, camera, backend="gpu")
frames = nf.render_path(scene, [camera] * 3, backend="gpu")
next(frames)
child = os.fork()
if child == 0:
    for call in (lambda: next(frames), lambda: nf.render(scene, camera, backend="gpu"), nf.gpu.adapters):
        try:
            call()
            print("drawn", flush=True)
        except nf.DeviceError as error:
            print(error, flush=True)
    nf.render(scene, camera, backend="auto")
    # Runs the exit handlers of everything that the parent had loaded.
    sys.exit(7)
for _ in range(600):
    ended, status = os.waitpid(child, os.WNOHANG)
    if ended:
        break
    time.sleep(0.1)
else:
    os.kill(child, 9)
    raise SystemExit("the child hangs")
assert os.waitstatus_to_exitcode(status) == 7, status
# The parent continues.
assert len(list(frames)) == 2
np.testing.assert_array_equal(nf.render(scene, camera, backend="gpu").color, before.color)
"""


@pytest.mark.parametrize("name", ADAPTERS)
def test_a_forked_child_is_refused_and_ends(name: str, tmp_path: Path) -> None:
    need("fork")
    need(name)
    process = program(FORK.format(name=name), NEARFAR_CACHE=str(tmp_path / "cache"))
    assert process.returncode == 0, process.stderr
    sentences = process.stdout.splitlines()
    assert len(sentences) == 3
    for sentence in sentences:
        assert "graphics drivers do not survive a fork" in sentence
        assert "'spawn' or 'forkserver', or use backend='cpu'" in sentence
    # "auto" logs the same once before it uses the CPU.
    assert process.stderr.startswith("rendering on the CPU: graphics drivers do not survive a fork")


@pytest.mark.slow
def test_a_spawned_child_draws() -> None:
    need("vulkan")
    code = """
import multiprocessing
from tests.gpu.test_faults import drawn_in_a_child
if __name__ == "__main__":
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        print(pool.apply(drawn_in_a_child))
"""
    process = program(code)
    assert process.stdout.strip() == "True", process.stderr


def drawn_in_a_child() -> bool:
    nf.gpu.select("vulkan")
    return bool(np.isfinite(nf.render(crowd(), CAMERA, backend="gpu").require("range")).any())


def test_a_child_forked_before_draws() -> None:
    """A child that was forked before any library was loaded draws."""
    need("fork")
    need("vulkan")
    code = """
import os
child = os.fork()
nf.gpu.select("vulkan")
nf.render(scene, camera, backend="gpu")
raise SystemExit(0 if child == 0 else os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
"""
    process = program(code)
    assert process.returncode == 0, process.stderr
