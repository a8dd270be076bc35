"""Blocking work on the page's main thread when rings arrive."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar.serve._server import Server
from tests.support import main_thread
from tests.support.browser import SMALL, open_page, wait_for_ring, wait_until
from tests.support.stepped_page import SteppedPage

pytestmark = pytest.mark.slow

MAX_BYTES = 2**18
"""Bytes that one call may send to the GPU, those of a step: `STEP_BYTES` of web/src/show/uploads.ts."""


@pytest.mark.stress
def test_no_call_sends_much_to_the_gpu(chromium: Any, tmp_path: Path) -> None:
    scene, center = nf.datasets.city(blocks=2, detail=0), (3.0, 1.7, -2.0)
    nf.stream.export(scene, tmp_path / "bundle", center=center, radii=(10.0, 22.0), face_size=1024)
    with Server.of_bundle(tmp_path / "bundle") as server, open_page(chromium, *SMALL) as page:
        main_thread.count(page)
        page.goto(f"{server.url}?aa=0")
        SteppedPage(page)
        main_thread.drive(page, {"position": list(center), "yaw": 0.0, "pitch": 0.0})
        assert wait_for_ring(page, 2) == ""
        counts = main_thread.read_counters(page)
        assert page.printed == []
    sent = [frame["bytes"] for frame in counts["frames"]]
    assert sum(sent) > 6 * 1024**2 * 4
    assert 0 < counts["mostBytes"] <= MAX_BYTES


LINKS = """
  const gl = WebGL2RenderingContext.prototype;
  const { linkProgram, useProgram, fenceSync, getSyncParameter } = gl;
  const linked = new Map();
  const made = new Map();
  let now = 0;
  let done = 0;
  window.uses = [];
  gl.linkProgram = function (program) {
    linked.set(program, (now += 1));
    return linkProgram.call(this, program);
  };
  gl.fenceSync = function (...given) {
    const sync = fenceSync.apply(this, given);
    made.set(sync, (now += 1));
    return sync;
  };
  gl.getSyncParameter = function (sync, name) {
    const status = getSyncParameter.call(this, sync, name);
    if (status === this.SIGNALED) done = Math.max(done, made.get(sync));
    return status;
  };
  gl.useProgram = function (program) {
    if (linked.has(program)) {
      const kind = this.getAttribLocation(program, 'normal') >= 0 ? 'smooth' : 'other';
      window.uses.push([kind, linked.get(program) < done]);
      linked.delete(program);
    }
    return useProgram.call(this, program);
  };
"""
"""Records for each program, at its first use, whether the GPU had completed all commands up to its linking."""


def test_no_frame_waits_for_shader_compilation(chromium: Any, tmp_path: Path) -> None:
    builder = nf.SceneBuilder()
    corners, faces = [[-3, 0, -3], [3, 0, -3], [0, 0, 3]], [[0, 2, 1]]
    for number, normals in enumerate((None, [[0.0, 1, 0]] * 3)):
        mesh = builder.mesh(np.add(corners, (0, number, 0)), faces, normals=normals)
        builder.instance(mesh, name=f"floor {number}")
    nf.stream.export(builder.build(), tmp_path / "b", center=(0, 1.7, 0), radii=(5.0,), face_size=64, samples=1)
    with Server.of_bundle(tmp_path / "b") as server, open_page(chromium, *SMALL) as page:
        page.add_init_script(LINKS)
        page.goto(f"{server.url}?aa=0")
        assert wait_for_ring(page, 1) == ""
        wait_until(page, lambda: any(kind == "smooth" for kind, _ in page.evaluate("() => window.uses")))
        uses = page.evaluate("() => window.uses")
        assert page.printed == []
    assert [is_done for kind, is_done in uses if kind == "smooth"] == [True]
    # All except that of the map, which the first picture needs.
    assert [is_done for _, is_done in uses].count(False) <= 1
    assert len(uses) >= 3
