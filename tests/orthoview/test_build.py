"""Tests of building: the content of stores, and which work is done once, repeated, or skipped."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from numpy.typing import NDArray

import nearfar as nf
from nearfar import _core
from nearfar.orthoview._grid import Grid, directions_of
from tests.support import need
from tests.support.orthoview_stores import (
    CELL,
    FORMAT,
    SIZE,
    Counted,
    Interrupted,
    Partial,
    Telling,
    contents,
    masks_of,
    of_cells,
    places,
)

need("zarr")


def channels_of(view: NDArray[np.uint8]) -> tuple[NDArray[np.uint8], NDArray[np.uint16], NDArray[np.uint8]]:
    """Colours, depths and normals from the bytes of a view."""
    color, low, high, normal = np.split(view, np.cumsum([3, 1, 1]) * SIZE**2)
    depth = low + 256 * high.astype(np.uint16)
    return color.reshape(SIZE, SIZE, 3), depth.reshape(SIZE, SIZE, 1), normal.reshape(SIZE, SIZE, 2)


def test_zarr_reads_the_views_of_all_cells(few: nf.Scene, few_tree: nf.orthoview.OrthoTree) -> None:
    import zarr

    tree, cells = few_tree, of_cells(few)
    group = zarr.open_group(str(Path(tree.path)), mode="r")
    assert tree.is_complete
    assert {level for level, _ in cells} == set(range(tree.levels))
    shown = 0
    for level in range(tree.levels):
        # All leaves that are not empty have views in two of the directions.
        for number, name in list(enumerate(tree._layout.names))[:: 4 if level == 0 else 1]:
            array = group[f"{level}/{name}"]
            assert array.shape == (*tree.cells(level), 7 * SIZE**2)
            whole = np.asarray(array[:])
            for place in places(tree.cells(level)):
                color, depth, normal = channels_of(whole[place])
                views = cells.get((level, place))
                if views is None:
                    assert not depth.any()
                    continue
                np.testing.assert_array_equal(color, views.colors()[number])
                np.testing.assert_array_equal(depth >> 4, views.depths()[number])
                np.testing.assert_array_equal(depth & 15, views.connected((4.0, 0.5, 0.7))[number])
                np.testing.assert_array_equal(normal, views.normals()[number])
                shown += bool(depth.any())
    assert shown > 200


def test_each_view_is_written_once_and_none_is_read(few: nf.Scene, few_tree: nf.orthoview.OrthoTree) -> None:
    tree, cells = few_tree, of_cells(few)
    leaves = sum(level == 0 for level, _ in cells)
    held = tree.held
    assert (held["cells"], held["leaves"]) == (len(cells), leaves)
    assert held["chunks"] == sum(5 - sum(views.empty()) for views in cells.values())
    done = tree.done
    assert (done["drawn"], done["composed"]) == (leaves, len(cells) - leaves)
    files = {name: data for name, data in contents(Path(tree.path)).items() if not name.startswith("geometry/")}
    index = sum((16 * (1 << (3 - int(name.split("/")[0]) % 3)) ** 3 + 4) for name in files)
    assert sum(map(len, files.values())) == held["bytes"] + index
    assert not list(Path(tree.path).rglob("*.part"))
    assert not list((Path(tree.path) / "nearfar" / "journal").glob("*"))


def test_empty_parts_are_skipped(few: nf.Scene, few_tree: nf.orthoview.OrthoTree, tmp_path: Path) -> None:
    """If nothing touches a cell above leaves, none of its leaves is queried."""
    telling = Telling(few)
    told = nf.orthoview.build(telling, tmp_path / "told.zarr", cell=CELL, size=SIZE, directions=5)
    assert contents(Path(told.path)) == contents(Path(few_tree.path))
    assert few_tree.held["leaves"] <= telling.queries < 0.7 * np.prod(few_tree.cells(0))
    # A world of 10⁸ leaves with something in two of them.
    corners = np.array([[1, 1, 1], [15, 3, 4], [4, 14, 15]], np.float32)
    far = nf.Scene.from_arrays(np.concatenate([corners, corners + 9980]), np.arange(6, dtype=np.uint32).reshape(2, 3))
    sparse = nf.orthoview.build(far, tmp_path / "sparse.zarr", cell=20.0, size=4, directions=5)
    assert sparse.cells(0) == (500, 500, 500)
    assert sparse.held["leaves"] == 2
    assert sparse.done["empty"] <= 8  # The scene's tree is asked, whose boxes are larger than triangles.


def test_removed_objects_leave_no_view(few: nf.Scene, copied_few: Path) -> None:
    """Removes the whole world."""
    tree = nf.orthoview.open(copied_few)
    held, masks = tree.held, masks_of(tree)
    emptied = tree.update(tree.bounds, Partial(few, [], is_empty_there=False))
    assert emptied.done == {"empty": np.prod(tree.cells(0))}
    assert emptied.held == dict.fromkeys(held, 0)
    assert masks_of(emptied) == {}
    assert all(emptied.leaf_glb(place) is None for place in places(tree.cells(0)))
    assert masks_of(tree) == masks != {}, "a tree opened before keeps its generation"


def test_points_of_views_lie_on_a_slope(tmp_path: Path) -> None:
    """Seen from above, points are at most half a depth step and half a pixel's rise away, on all levels."""
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
def test_ground_on_the_lowest_face_of_a_cell_is_drawn(height: float, way: str) -> None:
    """A grid begins at a whole metre, where ground often lies."""
    corners = np.array([[-80, height, -80], [80, height, -80], [80, height, 80], [-80, height, 80]], np.float32)
    ground = nf.Scene.from_arrays(corners, np.array([[0, 2, 1], [0, 3, 2]], np.uint32))
    upper = [direction for direction in directions_of(13) if direction[1] == 1]
    for corner in [(-10.0, height, -10.0), (-80.0, height, -80.0), (3.7, height, 11.3)]:
        views = _core.OrthoViews.of_cell(ground._core, (corner, CELL), upper, FORMAT, method=way)
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


def test_a_second_build_draws_nothing(few: nf.Scene, few_tree: nf.orthoview.OrthoTree) -> None:
    tree, source, before = few_tree, Counted(few), contents(Path(few_tree.path))
    again = nf.orthoview.build(source, Path(tree.path), cell=CELL, size=SIZE, directions=5)
    assert source.queries == 0
    assert again.is_complete
    assert (again.held, again.done) == (tree.held, tree.done)
    assert contents(Path(tree.path)) == before


def test_invalid_input_of_build_is_named(world: nf.Scene, few_tree: nf.orthoview.OrthoTree, tmp_path: Path) -> None:
    tree = few_tree

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
    wrong("size: ", size=30)
    wrong("cell: .*leaves", cell=1e-9)
    wrong("quality: expected None with", quality=50)
    wrong("quality: ", color="webp", quality=101)
    wrong("begun with other values of .*cell", path=Path(tree.path), cell=20.0, directions=5)
    wrong("begun with other values of .*directions", path=Path(tree.path))
    (tmp_path / "other").mkdir()
    (tmp_path / "other" / "file").write_text("mine")
    wrong("holds other files", FileExistsError, path=tmp_path / "other")
    with pytest.raises(FileNotFoundError, match="no store of orthoviews"):
        nf.orthoview.open(tmp_path)
    with pytest.raises(ValueError, match="place"):
        tree.view(0, (0, 999, 0), 0)


def test_worlds_of_one_leaf_are_trees(tmp_path: Path) -> None:
    ball = trimesh.creation.icosphere(2, 4.0).apply_translation((5, 5, 5))
    scene = nf.Scene.from_trimesh(ball)
    tree = nf.orthoview.build(scene, tmp_path / "one.zarr", cell=10.0, size=SIZE, directions=26)
    assert (tree.levels, tree.cells(0)) == (1, (1, 1, 1))
    assert all(tree.view(0, (0, 0, 0), direction) is not None for direction in range(26))


def test_empty_worlds_are_refused(world: nf.Scene, tmp_path: Path) -> None:
    empty = world.query([world.bounds[0] - 9, world.bounds[0] - 8])
    with pytest.raises(ValueError, match="source: expected finite bounds"):
        nf.orthoview.build(empty, tmp_path / "none.zarr", cell=1.0, size=SIZE)


def test_worlds_that_end_at_a_cell_border_have_no_further_cell() -> None:
    bounds = np.array([[0.0, 0.0, -30.0], [80.0, 20.0, 50.0]])
    assert Grid.from_bounds(bounds, 10.0).counts == (8, 2, 8)
    assert Grid.from_bounds(bounds + 1e-6, 10.0).counts == (9, 3, 9)
    rng = np.random.default_rng(0)
    for cell in (0.7, 1.1, 10.0):
        low = np.round(rng.uniform(-2000, 2000, (5000, 3)) * 4) / 4
        assert all(
            (np.array(Grid.from_bounds(np.array([place, place + 1]), cell).origin) <= place).all() for place in low
        )


def test_a_part_of_an_infinite_world_is_built(few: nf.Scene, few_tree: nf.orthoview.OrthoTree, tmp_path: Path) -> None:
    class Endless(Counted):
        @property
        def bounds(self) -> NDArray[np.float64]:
            return np.array([[-np.inf] * 3, [np.inf] * 3])

    low, seen = np.array(few_tree.box(0, (5, 0, 6))[0]), 0
    part = np.array([low, low + 3 * CELL])
    built = nf.orthoview.build(Endless(few), tmp_path / "part.zarr", cell=CELL, size=SIZE, directions=5, aabb=part)
    assert built.cells(0) == (3, 3, 3)
    for place in places((3, 3, 3)):
        x, y, z = place
        one, other = built.view(0, place, 4), few_tree.view(0, (x + 5, y, z + 6), 4)
        assert (one is None) == (other is None)
        if one is not None and other is not None:
            np.testing.assert_array_equal(one.depth, other.depth)
            seen += 1
    assert seen > 9
    with pytest.raises(ValueError, match="source: expected finite bounds"):
        nf.orthoview.build(Endless(few), tmp_path / "new.zarr", cell=CELL)
    with pytest.raises(ValueError, match="aabb: expected a finite part of the source"):
        nf.orthoview.build(few, tmp_path / "new.zarr", cell=CELL, aabb=part + 10**6)


def test_the_size_of_views_follows_the_display() -> None:
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


def test_second_layers_are_kept_if_they_reveal_hidden_surfaces(tmp_path: Path) -> None:
    """Covers walls behind walls, and isolated blocks."""
    parts = [trimesh.creation.box((0.3, 6, 18)).apply_translation((2 + 3 * n, 5, 10)) for n in range(4)]
    parts += [trimesh.creation.box((5, 7, 4)).apply_translation((9 * n, 20 - 4 * n, 27 - 6 * n)) for n in range(4)]
    scene = nf.Scene.from_trimesh(trimesh.util.concatenate(parts))
    settings: dict[str, Any] = {"cell": CELL, "size": SIZE, "directions": 5, "geometry": False}
    one = nf.orthoview.build(scene, tmp_path / "one.zarr", **settings)
    two = nf.orthoview.build(scene, tmp_path / "two.zarr", **settings, layers=2)
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
                # A pixel of a layer is composed of four, some of which may show the first layer only.
                assert (behind.depth[shown] > first.depth[shown] - 1e-3).mean() > 0.99
    assert kept > 2
    assert without > 50
    with pytest.raises(ValueError, match="layer: "):
        one.view(0, (0, 0, 0), 0, layer=1)

    with pytest.raises(KeyboardInterrupt):
        nf.orthoview.build(Interrupted(scene, 20), tmp_path / "again.zarr", **settings, layers=2)
    resumed = nf.orthoview.build(scene, tmp_path / "again.zarr", **settings, layers=2)
    assert contents(tmp_path / "again.zarr") == contents(Path(two.path))
    part = np.array([scene.bounds[0], scene.bounds.mean(axis=0)])
    updated = resumed.update(part, scene).compact(tmp_path / "compact.zarr")
    assert contents(Path(updated.path)) == contents(Path(two.path))
