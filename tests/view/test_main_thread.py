"""What a page does at once on its main thread for rings that arrive."""

from __future__ import annotations

from pathlib import Path

import pytest

import nearfar as nf
from nearfar.view._server import Server
from tests.support import main_thread, need
from tests.support.browser import opened, started, wait_for_ring
from tests.support.stepped_page import SteppedPage

pytestmark = pytest.mark.slow

MOST_BYTES = 2**21
"""Bytes that one call may send to the GPU: about a megabyte of a map, or an array of 32,768 triangles."""


def test_no_call_sends_much_to_the_gpu(tmp_path: Path) -> None:
    need("browser")
    scene, center = nf.datasets.city(blocks=2, detail=0), (3.0, 1.7, -2.0)
    nf.stream.export(scene, tmp_path / "bundle", center=center, radii=(10.0, 22.0), face_size=1024)
    with started() as program, Server(tmp_path / "bundle") as server, opened(program, 96, 60) as page:
        main_thread.count(page)
        page.goto(f"{server.url}?aa=0")
        SteppedPage(page)
        main_thread.drive(page, {"position": list(center), "yaw": 0.0, "pitch": 0.0})
        assert wait_for_ring(page, 2) == ""
        counts = main_thread.counted(page)
        assert page.printed == []
    sent = [frame["bytes"] for frame in counts["frames"]]
    assert sum(sent) > 6 * 1024**2 * 4
    assert 0 < counts["mostBytes"] <= MOST_BYTES
