"""Tests of trees whose build is still running or was interrupted: what they show, and what they say is missing."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import ArrayLike, NDArray

import nearfar as nf
from nearfar.serve._server import Server
from nearfar.view._tree import tree_files
from tests.support import need
from tests.support.flight_cases import camera_at
from tests.support.orthoview_stores import CELL, SIZE, Counted, Interrupted, Partial, places
from tests.support.range_server import serve_folder

need("zarr")

Tree = nf.orthoview.OrthoTree
Place = tuple[int, int, int]

SETTINGS: dict[str, Any] = {"cell": CELL, "size": SIZE, "directions": 5}
ENDS = (1, 60, 200)
"""Numbers of the query at which builds end: before the first leaf, in the first subtree and in the second."""


class Recorded(Interrupted):
    """A source that notes the leaves that it was asked for."""

    def __init__(self, scene: nf.Scene, at: int) -> None:
        super().__init__(scene, at)
        self.boxes: list[NDArray[np.float64]] = []

    def query(self, aabb: ArrayLike, detail: Any = 0.0) -> nf.Scene:
        part = super().query(aabb, detail)
        self.boxes.append(np.asarray(aabb))
        return part


def interrupted(scene: nf.Scene, path: Path, at: int) -> Recorded:
    source = Recorded(scene, at)
    with pytest.raises(KeyboardInterrupt):
        nf.orthoview.build(source, path, **SETTINGS)
    return source


@pytest.mark.parametrize("at", ENDS)
def test_an_interrupted_build_shows_the_leaves_that_it_reached(
    few: nf.Scene, few_tree: Tree, tmp_path: Path, at: int
) -> None:
    """Finished cells are those of the whole tree; the picture is that of a world of the leaves asked for so far."""
    source = interrupted(few, tmp_path / "part.zarr", at)
    tree = nf.orthoview.open(tmp_path / "part.zarr")
    total = int(np.prod(few_tree.cells(0)))
    assert (tree.unbuilt, tree.is_complete, tree.failed) == (total - (at - 1), False, {})
    assert f"{tree.unbuilt:,} leaves are not built yet" in repr(tree)
    reached = {box.tobytes() for box in source.boxes}
    left = [leaf for leaf in places(tree.cells(0)) if tree.box(0, leaf).tobytes() not in reached]
    unfinished = {(level, tuple(n >> level for n in leaf)) for leaf in left for level in range(tree.levels)}
    for level in range(tree.levels):
        for place in places(tree.cells(level)):
            if (level, place) in unfinished:
                with pytest.raises(ValueError, match="is missing: the build has not ended"):
                    tree.view(level, place, 4)
                continue
            view, whole = tree.view(level, place, 4), few_tree.view(level, place, 4)
            assert (view is None) == (whole is None)
            if view is not None and whole is not None:
                np.testing.assert_array_equal(view.depth, whole.depth)
    # With an error far below a pixel leaves are drawn, however far away.
    part = nf.orthoview.build(Partial(few, source.boxes, is_empty_there=False), tmp_path / "only.zarr", **SETTINGS)
    finest: dict[str, Any] = {"error_px": 1e-3, "geometry": False}
    camera = camera_at(tree, 90)
    frame, expected = tree.render(camera, **finest), part.render(camera, **finest)
    np.testing.assert_array_equal(frame.require("color"), expected.require("color"))
    assert frame.stats["unbuilt"] == tree.cut(camera, **finest).unbuilt > 0
    assert expected.stats["unbuilt"] == 0
    # Far away the largest finished cells are drawn, since no coarser ones exist.
    far = camera_at(tree, 5000)
    coverage = tree.render(far, geometry=False, channels=("coverage",)).require("coverage")
    assert bool(coverage.any()) == bool(tree.held["cells"])
    if tree.held["cells"]:
        assert tree.preview().any()
    keys = tree.cut(far).keys()
    assert all(tree.view(*key) is not None for key in keys)
    if tree.held["cells"]:
        with tree.fly() as flight:
            flight.render(camera)
            assert flight.wait(60.0)
            flown = flight.render(camera)
        assert np.array_equal(flown.require("color"), tree.render(camera).require("color"))
        assert (flown.stats["missing"], flown.stats["unbuilt"]) == (0, tree.cut(camera).unbuilt)
        assert tree.near_scene(tree.bounds.mean(axis=0), 50.0) is not None
    if at == 60:
        counts = tree.export_splats(tmp_path / "part.spz")
        assert (counts["unbuilt"], counts["splats"] > 0) == (tree.unbuilt, True)
        assert counts["splats"] == part.export_splats(tmp_path / "only.spz")["splats"]
        tiles = tree.export_splats(tmp_path / "tiles")
        assert tiles["splats"] > counts["splats"] or tree.held["cells"] == tree.held["leaves"]
    files = tree.verify()
    assert (files > 0) == (tree.held["cells"] > 0)
    with pytest.raises(ValueError, match=rf"expected a complete tree, .*{tree.unbuilt:,} leaves not built yet"):
        tree.compact(tmp_path / "new.zarr")
    with pytest.raises(ValueError, match=rf"expected a complete tree, .*{tree.unbuilt:,} leaves not built yet"):
        tree.update(tree.bounds, few)


def test_a_flight_sees_a_running_build_grow(few: nf.Scene, few_tree: Tree, tmp_path: Path) -> None:
    path, unbuilt, colors = tmp_path / "world.zarr", [], []
    flights: list[Any] = []
    camera = camera_at(few_tree, 90)

    def draw(flight: Any) -> NDArray[np.float32]:
        flight.render(camera)
        assert flight.wait(60.0)
        frame = flight.render(camera)
        unbuilt.append(frame.stats["unbuilt"])
        return np.asarray(frame.require("color"))

    class Looking(Counted):
        """A source that looks at the tree while it is being built."""

        def query(self, aabb: ArrayLike, detail: Any = 0.0) -> nf.Scene:
            if self.queries == 100:
                flights.append(nf.orthoview.open(path).fly(prefetch=False))
                colors.append(draw(flights[0]))
                assert not flights[0].refresh()  # nothing new
            elif self.queries > 100 and self.queries % 80 == 0:
                assert flights[0].refresh()
                colors.append(draw(flights[0]))
            return super().query(aabb, detail)

    whole = nf.orthoview.build(Looking(few), path, **SETTINGS)
    with flights[0] as flight:
        assert flight.refresh()
        colors.append(draw(flight))
        assert not flight.refresh()
    assert len(colors) >= 4
    assert unbuilt[-1] == 0 < unbuilt[0]
    assert np.array_equal(colors[-1], whole.render(camera).require("color"))
    assert not np.array_equal(colors[0], colors[-1])


def test_failed_leaves_of_a_running_build_are_named(few: nf.Scene, tmp_path: Path) -> None:
    class Failing(Interrupted):
        def query(self, aabb: ArrayLike, detail: Any = 0.0) -> nf.Scene:
            part = super().query(aabb, detail)
            if self.queries in (20, 200):
                raise OSError("the disk is gone")
            return part

    path = tmp_path / "part.zarr"
    with pytest.raises(KeyboardInterrupt):
        nf.orthoview.build(Failing(few, 210), path, **SETTINGS)
    tree = nf.orthoview.open(path)
    assert list(tree.failed.values()) == ["OSError: the disk is gone"] * 2
    assert tree.render(camera_at(tree, 90)).stats["failed"] == 2
    nf.orthoview.build(few, path, **SETTINGS)
    assert nf.orthoview.open(path).failed == {}


def test_a_build_in_a_folder_is_served_as_it_is(few: nf.Scene, tmp_path: Path) -> None:
    """Subtrees of leaves in work are left out, since their files change; a file server has no list of records."""
    path = tmp_path / "part.zarr"
    interrupted(few, path, 250)
    local = nf.orthoview.open(path)
    with Server.of_bundle(path) as server:
        remote = nf.orthoview.open(server.url)
        camera = camera_at(local, 90)
        frame = remote.render(camera, geometry=False)
        assert 0 < frame.stats["unbuilt"] <= local.render(camera, geometry=False).stats["unbuilt"] + 512
        assert frame.require("color").any()
        assert remote.verify() > 0
    assert not any(name.endswith(".part") for name in tree_files(path))
    with serve_folder(tmp_path) as plain:
        listed = nf.orthoview.open(f"{plain.url}part.zarr")
        for call in (
            lambda: listed.cut(camera),
            lambda: listed.view(0, (0, 0, 0), 4),
            lambda: listed.leaf_glb((0, 0, 0)),
        ):
            with pytest.raises(ValueError, match=r"the build of .*part\.zarr has not ended; open its folder"):
                call()
