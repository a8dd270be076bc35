"""Tests of flights with network failures, damaged stores, and concurrent updates."""

from __future__ import annotations

import shutil
import threading
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import partial
from http.server import ThreadingHTTPServer
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar.orthoview import _loader
from tests.support import need
from tests.support.flight_cases import CHANNELS, LONG, Gate, camera_at, is_same, there, whole
from tests.support.orthoview_stores import CELL, SIZE, box_about, world_of
from tests.support.range_server import RangeHandler, running
from tests.support.shared_folders import make_once
from tests.support.waiting import wait_until

need("zarr")

Tree = nf.orthoview.OrthoTree

BOXES = range(12)
ADDED = 101


@dataclass
class Server:
    """A file server with failures controlled by the test."""

    url: str
    status: int = 0
    """Status sent instead of files; −1 closes the connection."""
    failures: int = 0
    goes_on: threading.Event = field(default_factory=threading.Event)
    """Event: whether requests are answered."""


@contextmanager
def serving(folder: Path) -> Iterator[Server]:
    class Handler(RangeHandler):
        def parse_request(self) -> bool:
            is_sound = super().parse_request()
            state.goes_on.wait(LONG)
            state.failures += state.status != 0
            if state.status > 0:
                self.send_error(state.status)
            self.close_connection |= state.status < 0
            return is_sound and state.status == 0

    with running(partial(Handler, directory=str(folder))) as url:
        state = Server(url)
        state.goes_on.set()
        try:
            yield state
        finally:
            state.goes_on.set()


@pytest.fixture
def server(tree: Tree, monkeypatch: pytest.MonkeyPatch) -> Iterator[Server]:
    need("fsspec")
    need("aiohttp")
    monkeypatch.setattr(ThreadingHTTPServer, "request_queue_size", 1024)
    monkeypatch.setattr(_loader, "FIRST_PAUSE", 0.01)
    monkeypatch.setattr(_loader, "MAX_PAUSE", 0.02)
    with serving(Path(tree.path).parent) as server:
        yield server


COARSE: dict[str, Any] = {"views": 1, "error_px": 4.0}
"""Settings of flights that read little."""


@pytest.mark.slow
def test_pictures_recover_after_server_failures(tree: Tree, server: Server) -> None:
    """Each outage raises one error; pictures continue, and are right again as soon as the server recovers."""
    errors: list[Exception] = []
    way = [camera_at(tree, 90 - 5 * number, 0.3 + 0.1 * number) for number in range(6)]
    with nf.orthoview.open(f"{server.url}world.zarr").fly(error_px=2.0, adapt=False, on_error=errors.append) as flight:
        for count, (status, cameras) in enumerate([(500, way[:1]), (-1, way[1:])], 1):
            server.status, before = status, server.failures
            for number, camera in enumerate(cameras):
                frame, right = flight.render(camera, time=100.0 * count + number), tree.render(camera, error_px=2.0)
                if count > 1:
                    assert (there(right) & ~there(frame)).sum() <= 0.02 * there(right).sum()
                    assert frame.stats["empty"] == 0
            wait_until(lambda before=before: server.failures > before + 3)  # type: ignore[misc]
            assert not flight.wait(LONG)
            frame = flight.render(camera, time=100.0 * count + 10)
            assert frame.stats["missing"] > 0
            assert len(errors) == count
            server.status = 0
            wait_until(lambda: flight._loader.wait(0.0))
            shown = whole(flight, lambda: flight.render(camera, time=100.0 * count + 50))  # noqa: B023
            assert is_same(shown, right)
        assert flight.errors == tuple(errors)
        assert all(isinstance(error, OSError) for error in errors)


def test_missing_files_are_read_again_after_a_refresh(tree: Tree, server: Server) -> None:
    """A store with missing files is damaged, so they are not requested again."""
    errors: list[Exception] = []
    camera = camera_at(tree, 90)
    with nf.orthoview.open(f"{server.url}world.zarr").fly(**COARSE, on_error=errors.append) as flight:
        server.status = 404
        flight.render(camera)
        assert not flight.wait(LONG)
        assert not there(flight.render(camera)).any()
        assert [type(error) for error in errors] == [nf.FormatError]
        server.status, failures = 0, server.failures
        flight.render(camera)
        assert not flight.wait(LONG)
        assert server.failures == failures
        assert not flight.refresh()
        assert is_same(whole(flight, lambda: flight.render(camera)), tree.render(camera, **COARSE))
        assert len(errors) == 1


def test_pictures_do_not_wait_for_a_slow_server(tree: Tree, server: Server) -> None:
    opened = nf.orthoview.open(f"{server.url}world.zarr")
    camera = camera_at(tree, 90)
    with opened.fly(**COARSE) as flight:
        server.goes_on.clear()
        for number in range(20):
            flight.render(camera, time=float(number))
        assert flight.bytes_read == 0 < flight.waiting
        assert not flight.wait(0.0)
        server.goes_on.set()
        assert is_same(whole(flight, lambda: flight.render(camera, time=50.0)), tree.render(camera, **COARSE))
        assert flight.errors == ()


def damage(path: Path, tree: Tree, key: Any) -> None:
    """Overwrite the chunk of a view."""
    opened = tree._open_store()
    (chunk,) = opened.chunks.locate([opened.layout.key(key)])
    assert chunk is not None
    file = path / chunk.file
    content = bytearray(file.read_bytes())
    content[chunk.first : chunk.first + chunk.length] = bytes(chunk.length)
    file.write_bytes(bytes(content))


def test_a_damaged_view_keeps_the_coarser_picture(tree: Tree, copied: Path) -> None:
    camera = camera_at(tree, 60)
    cut = tree.cut(camera)
    key = cut.keys(in_picture=True)[4]  # it covers pixels
    damage(copied, tree, key)
    right = tree.render(camera)
    with nf.orthoview.open(copied).fly() as flight:
        flight.render(camera)
        assert not flight.wait(LONG)
        with pytest.warns(RuntimeWarning, match=r"FormatError: .*copy\.zarr") as told:
            frame = flight.render(camera)
        assert len(told) == len(flight.errors) == 1
        assert frame.stats["missing"] == 1
        assert frame.stats["empty"] == 0
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            frame = flight.render(camera)
        assert not flight.wait(LONG)
        assert len(flight.errors) == 1
    low, high = tree.box(*key[:2])
    _, directions = camera.rays()
    middle = np.array(camera.position)
    places = middle + directions * np.where(there(right), right.require("range"), 0.0)[..., None]
    reach = tree.cell * 2.0 ** key[0]  # of the coarser splats
    is_apart = ((places < low - reach) | (places > high + reach)).any(axis=2) & there(right)
    assert is_apart.sum() > 0.3 * there(right).sum()
    same = frame.require("range") == right.require("range")
    assert same[is_apart].mean() > 0.97
    assert (there(right) & ~there(frame)).sum() <= 0.02 * there(right).sum()
    assert not is_same(frame, right)


@pytest.fixture(scope="module")
def small_shards(tmp_path_factory: pytest.TempPathFactory) -> Tree:
    """A tree with small shards, only some of which an update rewrites."""

    def make(path: Path) -> None:
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr("nearfar.orthoview._build.SUBTREE", 2)
            nf.orthoview.build(world_of(BOXES), path, cell=CELL, size=SIZE, directions=5)

    return nf.orthoview.open(make_once(tmp_path_factory, "small_shards.zarr", make))


def updated(tree: Tree) -> Tree:
    return tree.update(box_about([ADDED]), world_of([*BOXES, ADDED]))


@pytest.mark.slow
def test_a_store_is_updated_during_a_flight(small_shards: Tree, tmp_path: Path, gate: Gate) -> None:
    some: dict[str, Any] = {"views": 1, "error_px": 1.5}
    path = Path(shutil.copytree(small_shards.path, tmp_path / "flown.zarr"))
    camera = camera_at(small_shards, 60)
    with nf.orthoview.open(path).fly(**some) as flight:
        old = whole(flight, lambda: flight.render(camera, time=0.0, channels=CHANNELS))
        assert not flight.refresh()
        files = set(path.rglob("*"))
        now = updated(nf.orthoview.open(path))
        written = set(path.rglob("*")) - files
        right = now.render(camera, **some, channels=CHANNELS)
        assert not is_same(right, old)
        # The flight continues with its generation, even for new reads.
        assert is_same(flight.render(camera, time=1.0, channels=CHANNELS), old)
        moved = camera_at(small_shards, 80, 0.9)
        shown = whole(flight, lambda: flight.render(moved, time=100.0, channels=CHANNELS))
        assert is_same(shown, small_shards.render(moved, **some, channels=CHANNELS))
        whole(flight, lambda: flight.render(camera, time=200.0))
        held = set(flight._viewer.views.cache.values)
        gate.close()
        gate.views.clear()
        assert flight.refresh()
        assert not flight.refresh()
        # Until the new views are loaded, the picture is unchanged.
        assert is_same(flight.render(camera, time=300.0, channels=CHANNELS), old)
        gate.open()
        assert is_same(whole(flight, lambda: flight.render(camera, time=400.0, channels=CHANNELS)), right)
        changed = {key for key in held if differs(small_shards, now, key)}
        assert changed & set(gate.views)
        again = held & set(gate.views)
        assert not (held - again) & changed & set(flight._pilot.plan(flight._has).order)
        # An update rewrites whole shards.
        anew = {
            key for key in held if any(file.as_posix().endswith(f"/{shard_of(small_shards, key)}") for file in written)
        }
        assert changed <= anew
        assert again <= anew < held
        assert flight.errors == ()


def differs(one: Tree, other: Tree, key: Any) -> bool:
    left, right = one.view(*key), other.view(*key)
    if left is None or right is None:
        return left is not right
    pairs = [(getattr(left, name), getattr(right, name)) for name in ("color", "depth", "normal")]
    return any(not np.array_equal(one, other, equal_nan=one.dtype.kind == "f") for one, other in pairs)


def shard_of(tree: Tree, key: Any) -> str:
    """Path of the shard that contains a view."""
    layout = tree._open_store().layout
    return layout.shard_path(layout.key(key))


def test_a_damaged_part_is_read_again_after_an_update(small_shards: Tree, tmp_path: Path) -> None:
    path = Path(shutil.copytree(small_shards.path, tmp_path / "flown.zarr"))
    camera = camera_at(small_shards, 60)
    key = small_shards.cut(camera).keys(in_picture=True)[0]
    sound = {file: file.read_bytes() for file in path.rglob("*") if file.is_file()}
    damage(path, small_shards, key)
    errors: list[Exception] = []
    with nf.orthoview.open(path).fly(on_error=errors.append) as flight:
        flight.render(camera)
        assert not flight.wait(LONG)
        flight.render(camera)
        assert len(errors) == 1
        for file, content in sound.items():
            file.write_bytes(content)
        assert not flight.wait(LONG)
        assert not flight.refresh()
        assert is_same(whole(flight, lambda: flight.render(camera)), small_shards.render(camera))
        assert len(errors) == 1


def test_another_tree_in_the_same_place_is_refused(small_shards: Tree, tmp_path: Path) -> None:
    path = Path(shutil.copytree(small_shards.path, tmp_path / "flown.zarr"))
    camera = camera_at(small_shards, 60)
    with nf.orthoview.open(path).fly() as flight:
        old = whole(flight, lambda: flight.render(camera))
        first = nf.orthoview.build(world_of(BOXES), tmp_path / "other.zarr", cell=2 * CELL, size=SIZE, directions=5)
        updated(first)
        path.rename(tmp_path / "was.zarr")
        Path(first.path).rename(path)
        with pytest.raises(nf.FormatError, match="the folder now holds another tree"):
            flight.refresh()
        assert is_same(flight.render(camera), old)
        path.rename(first.path)
        with pytest.raises((OSError, nf.FormatError), match=r"flown\.zarr"):
            flight.refresh()
        assert is_same(flight.render(camera), old)
