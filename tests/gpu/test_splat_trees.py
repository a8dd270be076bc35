"""Trees and flights drawn by adapters: splats, geometry, moving objects, and views loaded in the background."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar import _core
from nearfar._render import backend as backends
from tests.support import need
from tests.support.flight_cases import camera_at, whole
from tests.support.gpu_cases import adapter
from tests.support.orthoview_stores import layered_tree, world_of

need("zarr")

CHANNELS = ("color", "coverage", "range", "object_id", "position", "normal", "albedo")
Tree = nf.orthoview.OrthoTree


@pytest.fixture(scope="module")
def tree(tmp_path_factory: pytest.TempPathFactory) -> Tree:
    return layered_tree(tmp_path_factory)


@pytest.fixture(autouse=True)
def vulkan() -> Iterator[None]:
    with adapter("vulkan"):
        yield


def check(got: nf.Frame, right: nf.Frame, least: float = 0.99) -> None:
    assert got.channels == right.channels
    for name in right.channels:
        close = np.isclose(got.require(name), right.require(name), rtol=1e-3, atol=1e-3, equal_nan=True)
        assert close.mean() >= least, (name, close.mean())


@pytest.mark.parametrize(("distance", "leaves"), [(25.0, True), (120.0, False)])
def test_adapters_draw_trees(tree: Tree, distance: float, leaves: bool) -> None:
    camera = camera_at(tree, distance)
    right = tree.render(camera, channels=CHANNELS, backend="cpu")
    assert (right.stats["leaves"] > 0) == leaves
    got = tree.render(camera, channels=CHANNELS, backend="gpu")
    check(got, right)
    same = ("cells", "views", "leaves", "error_px", "splats", "splats_in_picture")
    assert {name: got.stats[name] for name in same} == {name: right.stats[name] for name in same}
    # The function that renders scenes renders trees.
    again = nf.render(tree, camera, channels=CHANNELS, backend="gpu")
    for name in CHANNELS:
        assert again.require(name).tobytes() == got.require(name).tobytes()


def test_trees_are_drawn_with_samples_and_limits(tree: Tree) -> None:
    camera = camera_at(tree, 60)
    settings: dict[str, Any] = {"samples": 9, "t_min": 20.0, "channels": ("color", "range", "coverage")}
    check(tree.render(camera, **settings, backend="gpu"), tree.render(camera, **settings, backend="cpu"), 0.97)


def test_moving_objects_are_drawn_with_trees(tree: Tree) -> None:
    middle = tree.bounds.mean(axis=0)
    corners = middle + np.array([[-9.0, 40, -9], [9, 40, -9], [0, 40, 9]])
    own, camera = tree.with_dynamic(nf.Scene.from_arrays(corners, [[0, 1, 2]])), camera_at(tree, 120)
    right = own.render(camera, channels=CHANNELS, backend="cpu")
    assert (right.require("object_id") == 0).any()
    check(own.render(camera, channels=CHANNELS, backend="gpu"), right)


def test_auto_selects_the_cpu_if_adapters_are_software(tree: Tree) -> None:
    camera = camera_at(tree, 90)
    chosen, right = tree.render(camera), tree.render(camera, backend="cpu")
    assert backends.open_device().kind == "software"
    assert chosen.require("color").tobytes() == right.require("color").tobytes()


def test_flights_upload_views_before_pictures_show_them(tree: Tree, monkeypatch: pytest.MonkeyPatch) -> None:
    brought: list[_core.OrthoSplats] = []
    drawn: list[_core.OrthoSplats] = []
    keep, draw = _core.gpu_keep_orthoviews, _core.splat_orthoviews

    def keeping(device: _core.GpuDevice, views: list[_core.OrthoSplats]) -> None:
        keep(device, views)
        brought.extend(views)

    def drawing(
        views: list[_core.OrthoSplats], *more: Any, device: _core.GpuDevice | None = None, **settings: Any
    ) -> dict[str, Any]:
        if device is not None:
            drawn[:] = views
        return draw(views, *more, device=device, **settings)

    monkeypatch.setattr(_core, "gpu_keep_orthoviews", keeping)
    monkeypatch.setattr(_core, "splat_orthoviews", drawing)
    near, far = camera_at(tree, 60), camera_at(tree, 60, angle=3.4)
    with nf.orthoview.open(tree.path).fly(adapt=False) as flight:
        first = whole(flight, lambda: flight.render(near, time=0, backend="gpu"))
        check(first, tree.render(near, backend="cpu"))
        flight.look(far, time=1)
        assert flight.wait()
        before = set(map(id, brought))
        last = flight.render(far, time=2, backend="gpu")
        check(last, tree.render(far, backend="cpu"))
        assert last.stats["missing"] == 0
        assert set(map(id, drawn)) <= before
        assert len(drawn) > 10
    count = len(brought)
    with nf.orthoview.open(tree.path).fly(adapt=False) as flight:
        whole(flight, lambda: flight.render(near, time=0, backend="cpu"))
        assert len(brought) == count


def test_both_eyes_of_a_tree_are_drawn(tree: Tree) -> None:
    camera, eyes = camera_at(tree, 90), {}
    for backend in ("cpu", "gpu"):
        settings: dict[str, Any] = {"size": (48, 48), "orientation": camera.orientation, "backend": backend}
        eyes[backend] = nf.render_eyes(tree, nf.hmd.QUEST_2, camera.position, **settings)
    check(eyes["gpu"].left, eyes["cpu"].left)
    check(eyes["gpu"].right, eyes["cpu"].right)


def test_pages_of_a_tree_are_freed_with_it(tree: Tree, tmp_path: Path) -> None:
    own = nf.orthoview.build(world_of(range(4)), tmp_path / "own.zarr", cell=20, size=32, directions=5)
    own.render(camera_at(own, 120), backend="gpu")
    device = backends.open_device()
    held = _core.gpu_orthoview_bytes(device)
    assert held > 0
    del own
    _core.gpu_keep_orthoviews(device, [])
    assert _core.gpu_orthoview_bytes(device) < held
