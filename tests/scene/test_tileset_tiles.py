"""Tests of the tiles of a tileset: external documents, transforms, implicit trees, and selection of tiles."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar._scene.tileset.tileset import Tileset
from tests.support.tile_cases import b3dm, box, glb, levels, subtree, tile, tileset, write

CUBE = b3dm(glb())


def shift(x: float, y: float = 0.0, z: float = 0.0) -> list[float]:
    return np.array([[1.0, 0, 0, x], [0, 1, 0, y], [0, 0, 1, z], [0, 0, 0, 1]]).T.ravel().tolist()


def sized(triangles: int) -> bytes:
    """A tile of that many triangles."""
    corners = np.random.default_rng(triangles).uniform(-1, 1, (3 * triangles, 3))
    return b3dm(glb(corners, np.arange(3 * triangles).reshape(-1, 3)))


def names(path: Path, **how: Any) -> set[str]:
    return set(nf.Scene.load(path, **how).object_names)


def test_external_tilesets_and_transforms(tmp_path: Path) -> None:
    turned = [0.0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 5, 0, 0, 1]  # x to y, and then 5 m along x.
    inner = tileset(tile(0.0, "cube.b3dm", transform=shift(2)), asset={"version": "1.0", "gltfUpAxis": "Z"})
    outer = tile(
        9.0, "parts/inner.json", transform=turned, children=[tile(0.0, "other.b3dm", transform=shift(0, 0, 7))]
    )
    files = {"tileset.json": tileset(outer), "parts/inner.json": inner, "parts/cube.b3dm": CUBE, "other.b3dm": CUBE}
    scene = nf.Scene.load(write(tmp_path, files))
    assert set(scene.object_names) == {"parts/cube", "other"}
    # 2 m along x of the inner tileset are 2 m along y of the outer one, and −z of the scene.
    np.testing.assert_allclose(scene.transform("parts/cube")[:3, 3], [5, 0, -2], atol=1e-12)
    np.testing.assert_allclose(scene.transform("other")[:3, 3], [5, 7, 0], atol=1e-12)


def test_several_contents(tmp_path: Path) -> None:
    both = tile(0.0, contents=[{"uri": "a.b3dm"}, {"url": "b.glb"}])
    extension = tile(0.0, extensions={"3DTILES_multiple_contents": {"content": [{"uri": "c.b3dm"}]}})
    root = tile(9.0, children=[both, extension])
    files = {"t.json": tileset(root, extensionsRequired=["3DTILES_multiple_contents"]), "a.b3dm": CUBE, "c.b3dm": CUBE}
    assert names(write(tmp_path, files | {"b.glb": glb()})) == {"a", "b", "c"}


@pytest.fixture
def quadtree(tmp_path: Path) -> Path:
    """Replacing tiles of three levels below the root; one of 4ⁿ has 10·4⁻ⁿ + 10 triangles."""
    files = {"tileset.json": tileset(levels(3, lambda _, key: f"t{key}.b3dm"))}
    for level in range(4):
        for number in range(4**level):
            key = np.base_repr(number, 4).zfill(level) if level else ""
            files[f"t{key}.b3dm"] = sized(10 + 4 ** (3 - level))
    return write(tmp_path, files)


def test_detail_follows_the_error(quadtree: Path) -> None:
    for error, length in ((None, 3), (0, 3), (15.9, 3), (16, 2), (32, 1), (63.9, 1), (64, 0), (1e9, 0)):
        found = names(quadtree, error=error)
        assert len(found) == 4**length, error
        assert {len(name) for name in found} == {length + 1}


def test_detail_follows_the_number_of_triangles(quadtree: Path) -> None:
    one, four, most = 74, 4 * 26, 64 * 11
    for triangles in (one, one + 29, four, four + 30, most - 1, most, 10 * most):
        scene = nf.Scene.load(quadtree, triangles=triangles)
        assert scene.triangle_count <= triangles
        # Refining one more tile of each level would exceed the budget: from 26 to 4 · 14, from 14 to 4 · 11.
        assert scene.triangle_count > triangles - 31 or triangles >= most
    with pytest.raises(nf.SceneError, match="its coarsest tiles have 74 triangles, more than 73"):
        nf.Scene.load(quadtree, triangles=73)


def test_large_errors_are_refined_first(tmp_path: Path) -> None:
    children = [
        tile(error, f"{name}.b3dm", refine="REPLACE", children=[tile(0.0, f"{name}{n}.b3dm") for n in range(2)])
        for name, error in (("a", 4.0), ("b", 8.0), ("c", 2.0))
    ]
    files = {"t.json": tileset(tile(16.0, children=children))}
    files |= {f"{name}{suffix}.b3dm": sized(10) for name in "abc" for suffix in ("", "0", "1")}
    path = write(tmp_path, files)
    assert names(path, triangles=30) == {"a", "b", "c"}
    assert names(path, triangles=49) == {"a", "b0", "b1", "c"}
    assert names(path, triangles=50) == {"a0", "a1", "b0", "b1", "c"}
    assert names(path, triangles=60) == {"a0", "a1", "b0", "b1", "c0", "c1"}


def test_tiles_are_added_to_those_above(tmp_path: Path) -> None:
    root = tile(8.0, "a.b3dm", refine="add", children=[tile(4.0, "b.b3dm", children=[tile(0.0, "c.b3dm")])])
    path = write(tmp_path, {"t.json": tileset(root), **{f"{name}.b3dm": sized(10) for name in "abc"}})
    assert names(path) == {"a", "b", "c"}
    assert names(path, error=4) == names(path, triangles=20) == {"a", "b"}
    assert names(path, error=8) == names(path, triangles=19) == {"a"}


def test_a_missing_child_keeps_its_parent(quadtree: Path) -> None:
    (quadtree.parent / "t012.b3dm").unlink()
    for triangles in (None, 10**6):
        scene = nf.Scene.load(quadtree, triangles=triangles)
        found = set(scene.object_names)
        assert "t01" in found
        assert not any(name.startswith("t01") and name != "t01" for name in found)
        assert len(found) == 64 - 4 + 1
        assert any("t012.b3dm is missing" in note for note in scene.report.notes)


def test_a_missing_parent_is_skipped(quadtree: Path) -> None:
    (quadtree.parent / "t.b3dm").unlink()
    assert len(names(quadtree)) == len(names(quadtree, triangles=10**6)) == 64
    assert names(quadtree, triangles=4 * 26) == {"t0", "t1", "t2", "t3"}


def test_many_missing_files_are_counted(tmp_path: Path) -> None:
    children = [tile(0.0, f"{n}.b3dm") for n in range(9)]
    path = write(
        tmp_path, {"t.json": tileset(tile(9.0, "a.b3dm", children=[*children, tile(1.0, "x.json")])), "a.b3dm": CUBE}
    )
    report = nf.Scene.load(path).report
    assert (
        "10 files of tiles left out: 0.b3dm is missing, 1.b3dm is missing, 2.b3dm is missing and 7 more" in report.notes
    )
    assert "1 tile of 3D Tiles" in report.used


@pytest.mark.parametrize("binary", [True, False])
@pytest.mark.parametrize("scheme", ["QUADTREE", "OCTREE"])
def test_implicit_trees_of_several_subtrees(tmp_path: Path, scheme: str, binary: bool) -> None:
    """Random availability of five levels in subtrees of two, compared with sets of cells."""
    axes = 2 if scheme == "QUADTREE" else 3
    rng = np.random.default_rng(axes)
    there: set[tuple[int, ...]] = {(0,) * (axes + 1)}
    for level in range(1, 5):
        cells = np.stack(np.meshgrid(*[np.arange(2**level)] * axes, indexing="ij"), -1).reshape(-1, axes)
        for cell in cells.tolist():
            if (level - 1, *(c // 2 for c in cell)) in there and rng.random() < 0.5:
                there.add((level, *cell))
    full = {cell for cell in there if rng.random() < 0.7} | {(0,) * (axes + 1)}

    def ordered(depth: int, base: tuple[int, ...], top: int) -> list[tuple[int, ...]]:
        """Cells of a level of a subtree by their Morton numbers, bit by bit."""
        cells = []
        for number in range(1 << axes * depth):
            steps = [sum((number >> axes * bit + axis & 1) << bit for bit in range(depth)) for axis in range(axes)]
            cells.append((top + depth, *(b * 2**depth + s for b, s in zip(base, steps, strict=True))))
        return cells

    template = "/".join(["{level}", "{x}", "{y}", "{z}"][: axes + 1])
    tiling = {
        "subdivisionScheme": scheme,
        "subtreeLevels": 2,
        "availableLevels": 5,
        "subtrees": {"uri": f"s/{template}/s.subtree"},
    }
    root = tile(16.0, f"c/{template}.b3dm", box((0, 0, 0), (16, 16, 16)), refine="ADD", implicitTiling=tiling)
    files = {"tileset.json": tileset(root)}
    for top in (0, 2, 4):
        for level, *rest in (cell for cell in there if cell[0] == top):
            base = tuple(rest)
            inner = [cell for depth in (0, 1) for cell in ordered(depth, base, level)]
            below = ordered(2, base, level)
            data, other = subtree(
                [cell in there for cell in inner],
                [cell in full for cell in inner],
                [cell in there for cell in below],
                binary=binary,
            )
            name = "s/" + "/".join(map(str, (level, *base)))
            files[f"{name}/s.subtree"] = data
            files |= {f"{name}/bits.bin": other} if not binary else {}
    for place in full:
        files["c/" + "/".join(map(str, place)) + ".b3dm"] = CUBE
    path = write(tmp_path, files)
    assert names(path) == {"c/" + "/".join(map(str, cell)) for cell in full}
    assert names(path, error=4) == {"c/" + "/".join(map(str, cell)) for cell in full if cell[0] <= 2}
    opened = Tileset.open(path)
    for low in rng.uniform(0, 14, (20, 3)):
        # The scene's z is −y of tiles.
        high = low + rng.uniform(0, 2, 3)
        part = np.array([[low[0], low[2], -high[1]], [high[0], high[2], -low[1]]])
        found = set(opened.read(box=part).nodes.objects)

        def meets(cell: tuple[int, ...], low: Any = low, high: Any = high) -> bool:
            size = 16 / 2 ** cell[0]
            return all(c * size <= h and (c + 1) * size >= lo for c, lo, h in zip(cell[1:], low, high, strict=False))

        assert found == {"c/" + "/".join(map(str, cell)) for cell in full if meets(cell)}


def test_regions_of_implicit_tiles_hold_their_content() -> None:
    """The bounds of a tileset are the union of its tiles' volumes."""
    from tests.support import data

    path = data("wild/cesium-native/Cesium3DTilesSelection/test/data/ImplicitTileset/tileset_1.1.json")
    opened = Tileset.open(path)
    (root,) = opened.root.children
    scene = nf.Scene.load(path)
    assert (opened.bounds[0] <= scene.bounds[0]).all()
    assert (opened.bounds[1] >= scene.bounds[1]).all()
    for child in root.children:
        low, high = child.bounds(opened.frame.to_scene)
        assert (low >= opened.bounds[0] - 0.01).all()
        assert (high <= opened.bounds[1] + 0.01).all()


def test_a_box_reads_only_touching_tiles(tmp_path: Path) -> None:
    children = [tile(0.0, f"{n}.b3dm", box((10 * n, 0, 0), (10 * n + 9, 9, 9))) for n in range(20)]
    path = write(tmp_path, {"t.json": tileset(tile(9.0, None, box((0, 0, 0), (200, 9, 9)), children=children))})
    for n in range(20):
        if n != 7:  # Never requested.
            (tmp_path / f"{n}.b3dm").write_bytes(CUBE)
    opened = Tileset.open(path)
    content = opened.read(box=np.array([[99.0, 0, -9], [110, 9, 0]]))
    assert content.nodes.objects == ["9", "10", "11"]
    assert not any("missing" in note for note in content.notes)
    np.testing.assert_allclose(opened.bounds, [[0, 0, -9], [200, 9, 0]])


def test_detail_requires_a_tileset(tmp_path: Path) -> None:
    path = write(tmp_path, {"a.glb": glb(), "b.json": json.dumps({"a": 1}).encode()})
    values: dict[str, Any] = {"error": 1.0, "triangles": 10, "origin": (0, 0, 0)}
    for name, value in values.items():
        with pytest.raises(ValueError, match=f"^{name}: expected none with .*a.glb, which is no tileset"):
            nf.Scene.load(path, **{name: value})
    with pytest.raises(ValueError, match="triangles: expected None if error is given"):
        nf.Scene.load(path, error=1, triangles=1)
    with pytest.raises(nf.SceneError, match="nor GeoJSON, nor a tileset of 3D Tiles"):
        nf.Scene.load(tmp_path / "b.json")


@pytest.mark.parametrize("origin", [(200, 91, 0), (0, 0), (0, 0, np.inf), "here", (1e9, 0, 0)])
def test_an_origin_must_be_a_place_on_the_earth(tmp_path: Path, origin: Any) -> None:
    path = write(tmp_path, {"t.json": tileset(tile(0.0, "a.b3dm")), "a.b3dm": CUBE})
    with pytest.raises((ValueError, TypeError), match=r"^origin: expected"):
        nf.Scene.load(path, origin=origin)
    with pytest.raises(nf.SceneError, match=r"t\.json: it is not on the Earth"):
        nf.Scene.load(path, origin=(0, 0, 0))


def test_the_whole_earth_needs_an_origin(tmp_path: Path) -> None:
    root = tile(1e6, "a.b3dm", {"sphere": [0, 0, 0, 7e6]})
    path = write(tmp_path, {"t.json": tileset(root), "a.b3dm": b3dm(glb(), {"RTC_CENTER": [6378137.0, 0, 0]})})
    with pytest.raises(nf.SceneError, match="it covers the whole Earth: state the place"):
        nf.Scene.load(path)
    scene = nf.Scene.load(path, origin=(0, 0, 0))
    np.testing.assert_allclose(scene.bounds, [[-0.5] * 3, [0.5] * 3], atol=1e-6)
