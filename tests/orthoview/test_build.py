"""Tests of building: what stores hold, and what is done once, again, or not at all."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from numpy.typing import ArrayLike, NDArray

import nearfar as nf
from nearfar import _core
from nearfar.orthoview._directions import directions_of
from nearfar.orthoview._grid import Grid
from tests.support import need
from tests.support.orthoview_stores import CELL, FORMAT, SIZE, Counted, Telling, contents, ended, of_cells, places

need("zarr")


@pytest.mark.slow
def test_zarr_reads_the_views_of_all_cells(world: nf.Scene, tree: nf.orthoview.OrthoTree) -> None:
    import zarr

    group = zarr.open_group(str(Path(tree.path)), mode="r")
    cells = of_cells(world)
    assert tree.is_complete
    assert {level for level, _ in cells} == set(range(tree.levels))
    shown = 0
    for level in range(tree.levels):
        for number, name in enumerate(tree._layout.names):
            arrays = [group[f"{level}/{name}/{channel}"] for channel in ("color", "depth", "normal")]
            whole = [np.asarray(array[:]) for array in arrays]
            assert arrays[0].shape == (*tree.cells(level), SIZE, SIZE, 3)
            for place in places(tree.cells(level)):
                color, depth, normal = (values[place] for values in whole)
                views = cells.get((level, place))
                if views is None:
                    assert not depth.any()
                    continue
                np.testing.assert_array_equal(color, views.colors()[number])
                np.testing.assert_array_equal(depth >> 4, views.depths()[number])
                np.testing.assert_array_equal(depth & 15, views.connected((4.0, 0.5, 0.7))[number])
                np.testing.assert_array_equal(normal, views.normals()[number])
                shown += bool(depth.any())
    assert shown > 500


def test_each_view_is_written_once_and_none_is_read(world: nf.Scene, tree: nf.orthoview.OrthoTree) -> None:
    cells = of_cells(world)
    leaves = sum(level == 0 for level, _ in cells)
    held = tree.held
    assert (held["cells"], held["leaves"]) == (len(cells), leaves)
    assert held["chunks"] == 3 * sum(5 - sum(views.empty()) for views in cells.values())
    done = tree.done
    assert (done["drawn"], done["composed"], done.get("reloaded", 0)) == (leaves, len(cells) - leaves, 0)
    files = {name: data for name, data in contents(Path(tree.path)).items() if not name.startswith("geometry/")}
    index = sum((16 * (1 << (3 - int(name.split("/")[0]) % 3)) ** 3 + 4) for name in files)
    assert sum(map(len, files.values())) == held["bytes"] + index
    assert not list(Path(tree.path).rglob("*.part"))
    assert not list((Path(tree.path) / "nearfar" / "journal").glob("*"))


@pytest.mark.slow
def test_empty_parts_are_passed_over(world: nf.Scene, tree: nf.orthoview.OrthoTree, tmp_path: Path) -> None:
    """Where nothing touches a cell above leaves, none of its leaves is asked for."""
    source = Counted(world)
    nf.orthoview.build(source, tmp_path / "all.zarr", cell=CELL, size=SIZE, directions=5)
    assert source.queries == np.prod(tree.cells(0))
    telling = Telling(world)
    told = nf.orthoview.build(telling, tmp_path / "told.zarr", cell=CELL, size=SIZE, directions=5)
    assert contents(Path(told.path)) == contents(Path(tree.path)) == contents(tmp_path / "all.zarr")
    assert tree.held["leaves"] <= telling.queries < 0.7 * source.queries
    # A world of 10⁸ leaves with something in two of them.
    corners = np.array([[1, 1, 1], [15, 3, 4], [4, 14, 15]], np.float32)
    far = nf.Scene.from_arrays(np.concatenate([corners, corners + 9980]), np.arange(6, dtype=np.uint32).reshape(2, 3))
    sparse = nf.orthoview.build(far, tmp_path / "sparse.zarr", cell=20.0, size=4, directions=5)
    assert sparse.cells(0) == (500, 500, 500)
    assert sparse.held["leaves"] == 2
    assert sparse.done["empty"] <= 8  # the tree of the scene is asked, whose boxes are larger than triangles


def test_points_of_views_lie_on_a_slope(tmp_path: Path) -> None:
    """Seen from above, half a step of depth and half a pixel's rise away at most, on all levels."""
    rise = 0.25
    corners = np.array([[0, 0, 0], [80, 80 * rise, 0], [80, 80 * rise, 80], [0, 0, 80]], np.float32)
    slope = nf.Scene.from_arrays(corners, np.array([[0, 2, 1], [0, 3, 2]], np.uint32))
    tree = nf.orthoview.build(slope, tmp_path / "slope.zarr", cell=CELL, size=SIZE, directions=5, normal_bits=24)
    seen = 0
    for level in range(tree.levels):
        for place in places(tree.cells(level)):
            view = tree.view(level, place, tree.directions.index((0, 1, 0)))
            if view is None:
                continue
            is_there = np.isfinite(view.depth)
            points, pixel = view.points()[is_there], view.extents[0] / SIZE
            # The least depth of a pixel's samples is that of its highest one, up to half a pixel along the slope.
            off = points[:, 1] - rise * points[:, 0]
            step = tree.cell * 2**level / 4092
            assert off.min() >= -step / 2 - 1e-5
            assert off.max() <= rise * pixel / 2 + step / 2 + 1e-5
            normal = np.array([-rise, 1, 0]) / np.hypot(rise, 1)
            assert np.degrees(np.arccos(view.normal[is_there] @ normal)).max() < 0.1
            assert np.isnan(view.normal[~is_there]).all()
            box = tree.box(level, place)
            assert (points >= box[0] - step).all()
            assert (points <= box[1] + step).all()
            inner = np.zeros((SIZE, SIZE), bool)
            inner[1:-1, 1:-1] = True
            whole = bool(is_there.all())
            assert not whole or view.surfel[inner].all()
            seen += whole
    assert seen > 50


@pytest.mark.parametrize("height", [0.0, -3.0, 5.0, 1.0])
@pytest.mark.parametrize("way", ["rays", "triangles"])
def test_ground_on_the_lowest_side_of_a_cell_is_seen(height: float, way: str) -> None:
    """A grid begins at a whole metre, where ground often lies."""
    corners = np.array([[-80, height, -80], [80, height, -80], [80, height, 80], [-80, height, 80]], np.float32)
    ground = nf.Scene.from_arrays(corners, np.array([[0, 2, 1], [0, 3, 2]], np.uint32))
    upper = [direction for direction in directions_of(13) if direction[1] == 1]
    for corner in [(-10.0, height, -10.0), (-80.0, height, -80.0), (3.7, height, 11.3)]:
        views = _core.OrthoViews.of_cell(ground._core, (corner, CELL), upper, FORMAT, way=way)
        shown = views.depths()[..., 0] > 0
        for direction, mask in zip(upper, shown, strict=True):
            axes, extents = _core.orthoview_axes(direction)
            place = (np.arange(2 * SIZE) + 0.5) / (2 * SIZE) - 0.5
            right, up, toward = (np.array(axis) for axis in axes)
            front = place[None, :, None] * extents[0] * right - place[:, None, None] * extents[1] * up
            along = (front[..., 1] + 0.5) / toward[1]
            on_ground = front - along[..., None] * toward
            hits = (np.abs(on_ground[..., (0, 2)]) < 0.5 - 1e-6).all(axis=-1)
            inside = hits.reshape(SIZE, 2, SIZE, 2).any(axis=(1, 3))
            assert mask[inside].all(), direction


def test_a_second_build_draws_nothing(world: nf.Scene, tree: nf.orthoview.OrthoTree) -> None:
    source, before = Counted(world), contents(Path(tree.path))
    again = nf.orthoview.build(source, Path(tree.path), cell=CELL, size=SIZE, directions=5)
    assert source.queries == 0
    assert again.is_complete
    assert (again.held, again.done) == (tree.held, tree.done)
    assert contents(Path(tree.path)) == before


@pytest.mark.slow
def test_cells_that_a_source_does_not_give_are_named_and_come_later(
    world: nf.Scene, tree: nf.orthoview.OrthoTree, tmp_path: Path
) -> None:
    path = tmp_path / "world.zarr"
    first = nf.orthoview.build(Counted(world, {100, 333}), path, cell=CELL, size=SIZE, directions=5)
    assert not first.is_complete
    assert len(first.failed) == 2
    assert set(first.failed.values()) == {"OSError: the disk is gone"}
    assert "incomplete" in repr(first)
    # All others are there, but for the cells above the two.
    cells, seen = of_cells(world), 0
    for level, place in list(cells)[::9] + [key for key in cells if key[0] > 1]:
        if any(tuple(number >> level for number in leaf) == place for leaf in first.failed):
            with pytest.raises(ValueError, match="is missing: OSError: the disk is gone"):
                first.view(level, place, 4)
            continue
        one, other = (opened.view(level, place, 4) for opened in (first, tree))
        assert (one is None) == (other is None)
        seen += one is not None
    assert seen > 50
    source = Counted(world)
    second = nf.orthoview.build(source, path, cell=CELL, size=SIZE, directions=5)
    assert second.is_complete
    assert second.failed == {}
    assert source.queries == 2
    assert second.held == tree.held
    # Chunks of a shard come in the order in which they were made, so bytes differ where cells come later.
    for level, place in [(0, (3, 3, 3)), (1, (2, 2, 2)), (tree.levels - 1, (0, 0, 0))]:
        for direction in range(5):
            one, other = (opened.view(level, place, direction) for opened in (tree, second))
            assert (one is None) == (other is None)
            if one is not None and other is not None:
                np.testing.assert_array_equal(one.color, other.color)
                np.testing.assert_array_equal(one.depth, other.depth)


def within_query(number: int) -> str:
    return f"query = source.query\nsource.query = lambda box: die() if source.queries == {number} else query(box)"


@pytest.mark.slow
@pytest.mark.parametrize("after", [150, *(pytest.param(after, marks=pytest.mark.stress) for after in (1, 400, 513))])
def test_a_kill_costs_the_cell_under_work(
    world: nf.Scene, tree: nf.orthoview.OrthoTree, tmp_path: Path, after: int
) -> None:
    path = tmp_path / "world.zarr"
    ended(path, within_query(after))
    with pytest.raises(ValueError, match="is missing: the build has not ended"):
        nf.orthoview.open(path).view(tree.levels - 1, (0, 0, 0), 0)
    source = Counted(world)
    resumed = nf.orthoview.build(source, path, cell=CELL, size=SIZE, directions=5)
    assert resumed.is_complete
    assert source.queries == np.prod(tree.cells(0)) - after
    assert resumed.held == tree.held
    assert contents(path) == contents(Path(tree.path))


KILLS = {
    "while the store is made": "_layout.Layout.shard_side = lambda self, level: die()",
    "between two shards": """
finish, numbers = _shard.ShardWriter.finish, iter(range(1000))
_shard.ShardWriter.finish = lambda self: die() if next(numbers) == 11 else finish(self)
""",
    "before the record": "_subtree.formats.write_json = lambda *_: die()",
    "before the journal goes": """
remove = _subtree.Journal.remove
_subtree.Journal.remove = lambda self: die() if self.cells else remove(self)
""",
}


@pytest.mark.slow
@pytest.mark.parametrize("moment", KILLS)
def test_a_kill_leaves_a_store_that_can_be_completed(
    world: nf.Scene, tree: nf.orthoview.OrthoTree, tmp_path: Path, moment: str
) -> None:
    path = tmp_path / "world.zarr"
    ended(path, KILLS[moment])
    resumed = nf.orthoview.build(world, path, cell=CELL, size=SIZE, directions=5)
    assert resumed.is_complete
    assert contents(path) == contents(Path(tree.path))
    assert not list(path.rglob("*.part"))
    assert not list((path / "nearfar" / "journal").glob("*"))


@pytest.mark.slow
def test_what_the_system_lost_is_drawn_again(world: nf.Scene, tree: nf.orthoview.OrthoTree, tmp_path: Path) -> None:
    """After a power cut a shard may be shorter than its journal says, and a line of the journal may be none."""
    path = tmp_path / "world.zarr"
    ended(path, within_query(400))
    part = max(path.rglob("*.part"), key=lambda file: file.stat().st_size)
    part.write_bytes(part.read_bytes()[:-10])
    (journal,) = (path / "nearfar" / "journal").glob("0_*")
    journal.write_bytes(journal.read_bytes() + bytes(3) + b"\n")
    resumed = nf.orthoview.build(world, path, cell=CELL, size=SIZE, directions=5)
    assert resumed.is_complete
    assert contents(path) == contents(Path(tree.path))


def test_a_source_that_always_fails_ends_the_build(world: nf.Scene, tmp_path: Path) -> None:
    source = Counted(world, range(10**6))
    with pytest.raises(nf.SceneError, match="it failed for 1,000 leaves, the last one with OSError: the disk is gone"):
        nf.orthoview.build(source, tmp_path / "world.zarr", cell=CELL, size=SIZE, directions=5)


def test_two_builds_into_one_store_are_refused(world: nf.Scene, tmp_path: Path) -> None:
    need("linux")
    path = tmp_path / "world.zarr"

    class Second(Counted):
        def query(self, aabb: ArrayLike, detail: Any = 0.0) -> nf.Scene:
            with pytest.raises(BlockingIOError, match="another build writes into"):
                nf.orthoview.build(world, path, cell=40.0, size=SIZE, directions=5)
            return super().query(aabb, detail)

    assert nf.orthoview.build(Second(world), path, cell=40.0, size=SIZE, directions=5).is_complete


def test_bad_input_is_named(world: nf.Scene, tree: nf.orthoview.OrthoTree, tmp_path: Path) -> None:
    def wrong(match: str, kind: type[Exception] = ValueError, **changed: Any) -> None:
        arguments: dict[str, Any] = {
            "source": world,
            "path": tmp_path / "new.zarr",
            "cell": CELL,
            "size": SIZE,
        } | changed
        with pytest.raises(kind, match=match):
            nf.orthoview.build(arguments.pop("source"), arguments.pop("path"), **arguments)
        assert not (tmp_path / "new.zarr").exists()

    wrong("directions: expected one of", directions=7)
    wrong("directions: expected one of", directions="all")
    wrong("size: ", size=30)
    wrong("cell: ", cell=0.0)
    wrong("cell: .*leaves", cell=1e-9)
    wrong("depth_bits: ", depth_bits=20)
    wrong("normal_bits: ", normal_bits=20)
    wrong("color: ", color="png")
    wrong("quality: expected None with", quality=50)
    wrong("quality: ", color="webp", quality=101)
    wrong("source: expected a source", TypeError, source=3)
    wrong("begun with other values of .*cell", path=Path(tree.path), cell=20.0, directions=5)
    wrong("begun with other values of .*directions", path=Path(tree.path))
    (tmp_path / "other").mkdir()
    (tmp_path / "other" / "file").write_text("mine")
    wrong("holds other files", FileExistsError, path=tmp_path / "other")
    with pytest.raises(FileNotFoundError, match="no store of orthoviews"):
        nf.orthoview.open(tmp_path)
    with pytest.raises(ValueError, match="level"):
        tree.view(tree.levels, (0, 0, 0), 0)
    with pytest.raises(ValueError, match="place"):
        tree.view(0, (0, 999, 0), 0)


def test_worlds_of_one_leaf_are_trees(tmp_path: Path) -> None:
    ball = trimesh.creation.icosphere(2, 4.0).apply_translation((5, 5, 5))
    scene = nf.Scene.from_trimesh(ball)
    tree = nf.orthoview.build(scene, tmp_path / "one.zarr", cell=10.0, size=SIZE, directions=26)
    assert (tree.levels, tree.cells(0)) == (1, (1, 1, 1))
    assert all(tree.view(0, (0, 0, 0), direction) is not None for direction in range(26))


def test_worlds_without_anything_are_refused(world: nf.Scene, tmp_path: Path) -> None:
    empty = world.query([world.bounds[0] - 9, world.bounds[0] - 8])
    with pytest.raises(ValueError, match="source: expected finite bounds"):
        nf.orthoview.build(empty, tmp_path / "none.zarr", cell=1.0, size=SIZE)


def test_worlds_that_end_with_a_cell_have_no_cell_beyond() -> None:
    bounds = np.array([[0.0, 0.0, -30.0], [80.0, 20.0, 50.0]])
    assert Grid.over(bounds, 10.0).counts == (8, 2, 8)
    assert Grid.over(bounds + 1e-6, 10.0).counts == (9, 3, 9)
    rng = np.random.default_rng(0)
    for cell in (0.7, 1.1, 10.0):
        low = np.round(rng.uniform(-2000, 2000, (5000, 3)) * 4) / 4
        assert all((np.array(Grid.over(np.array([place, place + 1]), cell).origin) <= place).all() for place in low)


def test_a_part_of_a_world_without_end_is_built(world: nf.Scene, tree: nf.orthoview.OrthoTree, tmp_path: Path) -> None:
    class Endless(Counted):
        @property
        def bounds(self) -> NDArray[np.float64]:
            return np.array([[-np.inf] * 3, [np.inf] * 3])

    low = np.array(tree.box(0, (3, 3, 3))[0])
    part = np.array([low, low + 3 * CELL])
    built = nf.orthoview.build(Endless(world), tmp_path / "part.zarr", cell=CELL, size=SIZE, directions=5, aabb=part)
    assert built.cells(0) == (3, 3, 3)
    for place in places((3, 3, 3)):
        x, y, z = place
        one, other = built.view(0, place, 4), tree.view(0, (x + 3, y + 3, z + 3), 4)
        assert (one is None) == (other is None)
        if one is not None and other is not None:
            np.testing.assert_array_equal(one.depth, other.depth)
    with pytest.raises(ValueError, match="source: expected finite bounds"):
        nf.orthoview.build(Endless(world), tmp_path / "new.zarr", cell=CELL)
    with pytest.raises(ValueError, match="aabb: expected a finite part of the source"):
        nf.orthoview.build(world, tmp_path / "new.zarr", cell=CELL, aabb=part + 10**6)


def test_the_size_of_views_is_that_of_a_display() -> None:
    # 1,000 pixels over 90° at 50 m: 100 m, of which a cell of 40 m takes 400 pixels.
    display: dict[str, Any] = {"cell": 40.0, "distance": 50.0, "fov": np.pi / 2}
    assert nf.orthoview.size_for(1000, **display, directions=5) == 400
    assert nf.orthoview.size_for(1000, **display, directions=5, angle=np.pi / 3) == 800
    assert nf.orthoview.size_for(1000, **display) == 568  # 400 · √2 = 565.7
    assert nf.orthoview.size_for(1000, **display, directions=26) == 656  # 400 · 1.633 = 653.2
    with pytest.raises(ValueError, match="4096 pixels are enough"):
        nf.orthoview.size_for(1000, cell=1e308, distance=50.0, fov=1.0)
    with pytest.raises(ValueError, match="4096 pixels are enough"):
        nf.orthoview.size_for(1000, cell=1.0, distance=50.0, fov=5e-324)
    assert nf.orthoview.size_for(1, cell=0.1, distance=50.0, fov=1.0) == 4
    with pytest.raises(ValueError, match="angle"):
        nf.orthoview.size_for(1000, cell=40.0, distance=50.0, fov=1.0, angle=np.pi / 2)
    with pytest.raises(ValueError, match="fov"):
        nf.orthoview.size_for(1000, cell=40.0, distance=50.0, fov=4.0)


@pytest.mark.slow
@pytest.mark.parametrize("quality", [None, 80])
def test_colours_as_webp(world: nf.Scene, tree: nf.orthoview.OrthoTree, tmp_path: Path, quality: int | None) -> None:
    """Lossless ones are equal. Of lossy ones parents are composed, so a build that goes on writes the same bytes."""
    settings: dict[str, Any] = {"cell": CELL, "size": SIZE, "directions": 5, "color": "webp", "quality": quality}
    path = tmp_path / "world.zarr"
    made = nf.orthoview.build(world, path, **settings)
    differences = []
    for place in places(made.cells(1)):
        one, other = made.view(1, place, 4), tree.view(1, place, 4)
        if one is not None and other is not None:
            np.testing.assert_array_equal(one.depth, other.depth)
            assert not one.color[~np.isfinite(one.depth)].any()
            differences.append(np.abs(one.color.astype(int) - other.color).max())
    assert len(differences) > 30
    assert (max(differences) > 0) == (quality is not None)

    class Interrupted(Counted):
        def query(self, aabb: ArrayLike, detail: Any = 0.0) -> nf.Scene:
            if self.queries == 300:
                raise KeyboardInterrupt
            return super().query(aabb, detail)

    other_path = tmp_path / "other.zarr"
    with pytest.raises(KeyboardInterrupt):
        nf.orthoview.build(Interrupted(world), other_path, **settings)
    nf.orthoview.build(world, other_path, **settings)
    assert contents(other_path) == contents(path)


@pytest.mark.slow
def test_a_build_that_goes_on_keeps_the_directions_that_were_chosen(tmp_path: Path) -> None:
    class Bounded(Counted):
        bounds = np.array([[-60.0, -9.0, -60.0], [59.0, 100.0, 59.0]])

    class Interrupted(Bounded):
        def query(self, aabb: ArrayLike, detail: Any = 0.0) -> nf.Scene:
            if (path / "zarr.json").exists():
                raise KeyboardInterrupt
            return super().query(aabb, detail)

    corners = np.array([[-99, 0, -99], [-99, 0, 99], [99, 0, 99], [99, 0, -99]], np.float32)
    ground = nf.Scene.from_arrays(corners, np.array([[0, 1, 2], [0, 2, 3]], np.uint32))
    city = nf.datasets.city(blocks=2)
    path = tmp_path / "world.zarr"
    settings: dict[str, Any] = {"cell": 40.0, "size": SIZE, "geometry": False}
    with pytest.raises(KeyboardInterrupt):
        nf.orthoview.build(Interrupted(ground), path, directions="auto", **settings)
    assert len(nf.orthoview.open(path).directions) == 5
    assert len(nf.orthoview.build(Bounded(city), path, directions="auto", **settings).directions) == 5
    fresh = nf.orthoview.build(Bounded(city), tmp_path / "fresh.zarr", directions="auto", **settings)
    assert len(fresh.directions) > 5


@pytest.mark.slow
def test_second_layers_are_kept_where_they_show_what_is_hidden(world: nf.Scene, tmp_path: Path) -> None:
    settings: dict[str, Any] = {"cell": 20.0, "size": SIZE, "directions": 5, "geometry": False}
    one = nf.orthoview.build(world, tmp_path / "one.zarr", **settings)
    two = nf.orthoview.build(world, tmp_path / "two.zarr", **settings, layers=2)
    assert (one.layers, two.layers) == (1, 2)
    kept = without = 0
    for level in range(two.levels):
        for place in places(two.cells(level)):
            for direction in range(5):
                first, same, behind = (
                    two.view(level, place, direction),
                    one.view(level, place, direction),
                    two.view(level, place, direction, layer=1),
                )
                assert (first is None) == (same is None)
                if first is None or same is None:
                    assert behind is None
                    continue
                np.testing.assert_array_equal(first.depth, same.depth)
                np.testing.assert_array_equal(first.color, same.color)
                if behind is None:
                    without += 1
                    continue
                kept += 1
                shown = np.isfinite(behind.depth)
                assert shown.any()
                # A pixel of a layer is made of four, of which some may show the first layer only.
                assert (behind.depth[shown] > first.depth[shown] - 1e-3).mean() > 0.99
    assert kept > 2
    assert without > 100
    with pytest.raises(ValueError, match="layer: "):
        one.view(0, (0, 0, 0), 0, layer=1)

    class Interrupted(Counted):
        def query(self, aabb: ArrayLike, detail: Any = 0.0) -> nf.Scene:
            if self.queries == 60:
                raise KeyboardInterrupt
            return super().query(aabb, detail)

    path = tmp_path / "again.zarr"
    with pytest.raises(KeyboardInterrupt):
        nf.orthoview.build(Interrupted(world), path, **settings, layers=2)
    resumed = nf.orthoview.build(world, path, **settings, layers=2)
    assert contents(path) == contents(Path(two.path))
    part = np.array([world.bounds[0], world.bounds.mean(axis=0)])
    updated = resumed.update(part, world).compact(tmp_path / "compact.zarr")
    assert contents(Path(updated.path)) == contents(Path(two.path))
