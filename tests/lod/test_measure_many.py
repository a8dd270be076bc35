"""Many objects measured at once: the same bytes over processes and clusters; Ctrl-C keeps finished scores."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from tests.support import need
from tests.support.lod_cases import SMALL, assert_same, checkered, levels

pytestmark = pytest.mark.usefixtures("fresh_cache")


@pytest.fixture(scope="module")
def objects() -> dict[str, nf.lod.Levels]:
    textured = nf.lod.Levels([nf.lod.Level(scene=checkered(12)), nf.lod.Level(scene=checkered(6))], name="board")
    return {"ball": levels(12, 8, 4), "board": textured, "alone": levels(5, name="alone")}


def test_many_objects_are_returned_in_their_container(objects: dict[str, nf.lod.Levels]) -> None:
    by_name = nf.lod.measure(objects, **SMALL)
    in_a_row = nf.lod.measure(list(objects.values()), **SMALL)
    assert list(by_name) == list(objects)
    for one, other, own in zip(by_name.values(), in_a_row, objects.values(), strict=True):
        assert_same(one, other)
        assert_same(one, nf.lod.measure(own, **SMALL))
    assert nf.lod.measure({}, **SMALL) == {}
    assert nf.lod.measure([], **SMALL, workers=2) == []


def test_processes_give_the_same_bytes(objects: dict[str, nf.lod.Levels]) -> None:
    here = nf.lod.measure(objects, **SMALL, cache=False)
    there = nf.lod.measure(objects, **SMALL, cache=False, workers=2)
    for name in objects:
        assert_same(here[name], there[name])
        assert there[name].measured == here[name].measured
        own = there[name].levels
        assert own is not None
        assert own[0].scene is objects[name][0].scene


@pytest.mark.slow
def test_a_cluster_gives_the_same_bytes(objects: dict[str, nf.lod.Levels]) -> None:
    need("distributed")
    from distributed import Client, LocalCluster

    here = nf.lod.measure(objects, **SMALL, cache=False)
    with LocalCluster(n_workers=1, threads_per_worker=1, dashboard_address=":0") as cluster, Client(cluster) as client:
        there = nf.lod.measure(objects, **SMALL, cache=False, client=client)
        for name in objects:
            assert_same(here[name], there[name])
        nothing = nf.lod.Levels([nf.lod.Level(scene=nf.Scene.from_arrays(np.zeros((3, 3)), [[0, 1, 2]]))])
        with pytest.raises(ValueError, match="more than a point"):
            nf.lod.measure([objects["ball"], nothing], **SMALL, client=client)


def test_an_object_that_fails_in_a_process_is_named(objects: dict[str, nf.lod.Levels]) -> None:
    nothing = nf.lod.Levels([nf.lod.Level(scene=nf.Scene.from_arrays(np.zeros((3, 3)), [[0, 1, 2]]))])
    with pytest.raises(ValueError, match="more than a point"):
        nf.lod.measure([nothing, objects["ball"]], **SMALL, workers=1)


STOPPED = """
import nearfar as nf
from nearfar.lod._measure import score_cache, score_table
from tests.support.lod_cases import levels

# Workers import this module as well.
score_table.MAX_BLOCK_PIXELS, score_cache.SAVE_INTERVAL_S = 10_000, 0.1

if __name__ == "__main__":
    objects = [levels(40, 20 - n) for n in range(4)]
    nf.lod.measure(objects, fov=nf.Fov.symmetric(90), size=(256, 256), views=10_000, workers=2, step=None, samples=1)
"""


def children(process: int) -> list[int]:
    found = subprocess.run(["ps", "-o", "pid=", "--ppid", str(process)], capture_output=True, text=True, check=False)
    return [int(number) for number in found.stdout.split()]


@pytest.mark.slow
def test_ctrl_c_ends_processes_and_keeps_their_scores(tmp_path: Path) -> None:
    need("linux")
    script = tmp_path / "many.py"
    script.write_text(STOPPED)
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(sys.path), "NEARFAR_NUM_THREADS": "1"}
    program = subprocess.Popen([sys.executable, str(script)], env=environment, stderr=subprocess.PIPE, text=True)

    def until(reached: Any) -> bool:
        deadline = time.monotonic() + 600
        while not reached() and time.monotonic() < deadline:
            time.sleep(0.05)
        return bool(reached())

    def cached_files() -> list[Path]:
        return list((tmp_path / "cache").glob("??/*.npy"))

    try:
        assert until(lambda: len(cached_files()) >= 2 or program.poll() is not None)
        assert program.poll() is None, program.communicate()[1]
        workers = children(program.pid)
        assert len(workers) >= 2
        program.send_signal(signal.SIGINT)
        message = program.communicate(timeout=600)[1]
        last, note = message.splitlines()[-2:]
        assert last == "KeyboardInterrupt"
        assert until(lambda: not any(Path(f"/proc/{worker}").exists() for worker in workers))
        scores = np.concatenate([np.load(path).ravel() for path in cached_files()])
        assert 0 < np.isfinite(scores).sum() < scores.size
        assert note.startswith(f"measure: {np.isfinite(scores).sum():,} of at most ")
    finally:
        program.kill()
        program.communicate()
