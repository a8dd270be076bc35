"""Tests of adapter failures, after which the next picture is right, and of processes that end during work."""

from __future__ import annotations

import ast
import threading
from pathlib import Path

import numpy as np
import pytest

import nearfar as nf
from nearfar import _core
from nearfar._render import backend as backends
from tests.support import need
from tests.support.gpu_cases import ADAPTERS, crowd, program, view

CAMERA = view((0, 1.3, 1.0), (0, 0, -6), size=(96, 64))


def test_a_device_lost_between_frames_is_opened_again(backend: str) -> None:
    scene = crowd()
    before = nf.render(scene, CAMERA, backend="gpu")
    device = backends.open_device()
    device.lose()
    after = nf.render(scene, CAMERA, backend="gpu")
    np.testing.assert_array_equal(after.require("color"), before.require("color"))
    # A new device has no data, so the scene was uploaded again.
    assert nf.gpu.stats()["uploaded_bytes"] > 1000
    with pytest.raises(nf.DeviceError, match="the device was lost"):
        device.truth(scene._core, [CAMERA._core], nf.Shot(cameras=(CAMERA,), channels=("range",)).settings)


def test_a_device_lost_during_a_frame_suggests_a_remedy(backend: str) -> None:
    scene = crowd()
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


def test_a_device_lost_in_another_thread_while_frames_are_drawn(backend: str) -> None:
    """Frames are right or raise a DeviceError, at whatever moment the device is lost."""
    scene, stop = crowd(), threading.Event()
    drawn = lost = 0
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
        while lost < 8 or not drawn:
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


def test_two_threads_draw_one_scene_at_once(backend: str) -> None:
    """The first upload must not wait for a lock that its own thread holds."""
    for _ in range(3):
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
import multiprocessing, os, sys, time
from concurrent.futures import ProcessPoolExecutor
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
if {name!r} == "gl":  # Its driver is loaded in half the time.
    with ProcessPoolExecutor(1, multiprocessing.get_context("spawn")) as pool:
        spawned = pool.submit(nf.render, scene, camera, backend="gpu").result()
    np.testing.assert_array_equal(spawned.color, before.color)
"""


@pytest.mark.parametrize("name", ADAPTERS)
def test_a_forked_child_is_refused_and_a_spawned_one_draws(name: str, tmp_path: Path) -> None:
    need("fork")
    need(name)
    process = program(FORK.format(name=name), NEARFAR_ADAPTER=name, NEARFAR_CACHE=str(tmp_path / "cache"))
    assert process.returncode == 0, process.stderr
    sentences = process.stdout.splitlines()
    assert len(sentences) == 3
    for sentence in sentences:
        assert "graphics drivers do not survive a fork" in sentence
        assert "'spawn' or 'forkserver', or use backend='cpu'" in sentence
    # "auto" logs the same once before it uses the CPU.
    assert process.stderr.startswith("rendering on the CPU: graphics drivers do not survive a fork")


# Processes that end while an adapter works ----------------------------------------------------------------------------
BEGIN = """
nf.gpu.select({name!r})
from nearfar._render import backend as backends
large = nf.Camera((0, 1.3, 1), fov=nf.Fov.symmetric(60), size=(500, 500))
settings = nf.Shot(cameras=(large,), channels=("color", "position", "normal")).settings
device = backends.open_device()
jobs = [job for _ in range({count}) for job in device.truth(scene._core, [large._core], settings)]
"""

ENDS = {
    "jobs under way": "",
    "a frame on the device, after jobs that were dropped": "jobs.clear(); frame = nf.gpu.render(scene, camera)",
    "a lost device": "device.lose()",
    "an interrupt": "import signal; signal.raise_signal(signal.SIGINT)",
    "a render in another handler": "import atexit; atexit.register(nf.render, scene, camera, backend='gpu')",
    "no handlers": "os._exit(0)",
}

FORK_ENDS = """
import os, sys
for end, code in {ends!r}.items():
    read, write = os.pipe()
    child = os.fork()
    if child == 0:
        os.dup2(write, 2)
        os.close(read), os.close(write)
        exec(code)  # and the process ends after the last line of the program
        break
    os.close(write)
    with open(read) as errors:
        said = errors.read().splitlines()
    # A buffer with earlier lines would be inherited by the next child, which prints them, too.
    print((end, os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), said), flush=True)
"""
"""Forks a process for each end, before anything loads a driver, and prints how it ended: such children may draw."""


@pytest.mark.parametrize("name", ADAPTERS)
def test_processes_end_cleanly(name: str) -> None:
    need(name)
    need("fork")
    chosen = [end for end in ENDS if name == ADAPTERS[0] or end.startswith(("jobs under", "a "))]
    codes = {end: BEGIN.format(name=name, count=1 if ENDS[end] else 4) + ENDS[end] for end in chosen}
    process = program(FORK_ENDS.format(ends=codes))
    assert (process.returncode, process.stderr) == (0, "")
    found = [ast.literal_eval(line) for line in process.stdout.splitlines()]
    assert [end for end, *_ in found] == chosen
    for end, status, said in found:
        assert status in ((1, -2, 130) if end == "an interrupt" else (0,)), (end, said)
        assert said[-1:] == (["KeyboardInterrupt"] if end == "an interrupt" else []), end


def test_a_closed_device_is_replaced(backend: str) -> None:
    """The next call opens another one."""
    scene, camera = crowd(), view((0, 1.3, 1.0), (0, 0, -6), size=(96, 64))
    frame = nf.gpu.render(scene, camera)
    before = frame.read().require("color")
    _core.gpu_close()
    with pytest.raises(nf.DeviceError, match="the device was lost"):
        frame.read()
    assert (nf.render(scene, camera, backend="gpu").require("color") == before).all()
