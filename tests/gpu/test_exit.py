"""Tests of processes that end while an adapter works: they end cleanly, whatever work is pending."""

from __future__ import annotations

import pytest

import nearfar as nf
from tests.support import need
from tests.support.gpu_cases import ADAPTERS, adapter, crowd, program, view

BEGIN = """
import os, sys
nf.gpu.select({name!r})
from nearfar._render import backend as backends
large = nf.Camera((0, 1.3, 1), fov=nf.Fov.symmetric(60), size=(800, 800))
settings = nf.Shot(cameras=(large,), channels=("color", "position", "normal")).settings
device = backends.open_device()
jobs = [job for _ in range({count}) for job in device.truth(scene._core, [large._core], settings)]
"""

ENDS = {
    "jobs under way": "",
    "jobs that were dropped": "jobs.clear()",
    "a frame on the device": "frame = nf.gpu.render(scene, camera)",
    "a lost device": "device.lose()",
    "an interrupt": "import signal; signal.raise_signal(signal.SIGINT)",
    "a render in another handler": "import atexit; atexit.register(nf.render, scene, camera, backend='gpu')",
    "no handlers": "os._exit(0)",
}


@pytest.mark.parametrize(
    ("name", "end"),
    [
        *((ADAPTERS[0], end) for end in ENDS),
        *((ADAPTERS[1], end) for end in ENDS if end.startswith(("jobs under", "a "))),
    ],
)
def test_processes_end_cleanly(name: str, end: str) -> None:
    need(name)
    process = program(BEGIN.format(name=name, count=4 if not ENDS[end] else 1) + ENDS[end] + "\n")
    assert process.returncode in ((1, -2, 130) if end == "an interrupt" else (0,)), process.stderr[-2000:]
    assert process.stderr.splitlines()[-1:] == (["KeyboardInterrupt"] if end == "an interrupt" else [])


@pytest.mark.parametrize("name", ADAPTERS)
def test_a_closed_device_is_replaced(name: str) -> None:
    """The next call opens another one."""
    from nearfar import _core

    scene, camera = crowd(), view((0, 1.3, 1.0), (0, 0, -6), size=(96, 64))
    with adapter(name):
        frame = nf.gpu.render(scene, camera)
        before = frame.read().require("color")
        _core.gpu_close()
        with pytest.raises(nf.DeviceError, match="the device was lost"):
            frame.read()
        assert (nf.render(scene, camera, backend="gpu").require("color") == before).all()
