"""Tests of the geometry of leaves: which triangles belong to a leaf, and the content of its file."""

from __future__ import annotations

import io
import tempfile
import textwrap
from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from PIL import Image

import nearfar as nf
from nearfar._base import glb
from nearfar.orthoview._geometry import IMAGES, MAX_STEP, Images, cell_glb, moving_glb, step_of
from nearfar.orthoview._grid import Grid
from nearfar.orthoview._owners import owned_mask
from tests.support import printed_by_threads
from tests.support.bundled_scenes import balls, farthest
from tests.support.geometry_cases import keys, parts, standing, world_triangles
from tests.support.orthoview_cases import boxes

PART, SMALL = [(-9.5, -8, -7), (12, 9, 10.5)], [(0.3, 0.3, 0.3), (0.4, 0.4, 0.4)]
FAR = np.array([123_456.7, 10.3, -98_765.4])


def soup(offset: Any = (0, 0, 0)) -> nf.Scene:
    """Triangles of all sizes about a box of 40 m, some of them in planes and along lines at whole metres."""
    rng = np.random.default_rng(7)
    sizes = rng.choice([0.1, 2.0, 30.0], 240)
    corners = rng.uniform(-20, 20, (240, 1, 3)) + rng.normal(size=(240, 3, 3)) * sizes[:, None, None]
    corners[:80, :, 0] = np.rint(corners[:80, :1, 0])
    corners[80:160] = np.rint(corners[80:160])
    corners[120:140, :, 1:] = corners[120:140, :1, 1:]
    return nf.Scene.from_arrays((corners + offset).reshape(-1, 3), np.arange(720).reshape(-1, 3))


def with_area(scene: nf.Scene) -> nf.Scene:
    a, b, c = np.moveaxis(scene.triangles().astype(np.float64), 1, 0)
    return scene.subset(triangles=np.linalg.norm(np.cross(b - a, c - a), axis=1) > 1e-3)


# what belongs to a leaf -----------------------------------------------------------------------------------------------
@pytest.mark.parametrize(
    ("offset", "cell", "part"),
    [*zip([(0, 0, 0), FAR] * 3, [20.0, 0.7 * 26, 7.0] * 2, [None, None, PART, PART, SMALL, SMALL], strict=True)],
)
def test_each_triangle_belongs_to_one_of_the_leaves_that_it_touches(offset: Any, cell: float, part: Any) -> None:
    world = soup(offset)
    grid = Grid.from_bounds(world.bounds if part is None else np.array(part) + offset, cell)
    touched, belongs = Counter[bytes](), Counter[bytes]()
    for place, found in parts(world, grid):
        mine = owned_mask(found, grid, place)
        touched.update(keys(found.triangles()))
        belongs.update(keys(found.triangles()[mine]))
    assert set(belongs) == set(touched)
    assert set(belongs.values()) == {1}
    assert max(touched.values()) > 1 or grid.counts == (1, 1, 1)
    assert (len(touched) == world.triangle_count) == (part is None)


def test_no_triangle_lies_between_cells() -> None:
    # A hundred times 0.07 rounds to more than 7, and 6.93 + 0.07 need not.
    grid = Grid((0.0, 0.0, 0.0), 0.07, (1000, 1, 1))
    ends = np.array([grid.box(0, (x, 0, 0))[:, 0] for x in range(1000)])
    np.testing.assert_array_equal(ends[:-1, 1], ends[1:, 0])
    parents = np.array([grid.box(3, (x, 0, 0))[:, 0] for x in range(125)])
    np.testing.assert_array_equal(parents, ends.reshape(125, 16)[:, [0, -1]])


def test_a_triangle_belongs_to_the_leaf_of_its_first_corner() -> None:
    grid = Grid((0.0, 0.0, 0.0), 10.0, (2, 1, 2))
    corners = np.array(
        [
            [(10, 1, 1), (9, 1, 1), (9, 2, 1)],  # On the face between two leaves.
            [(9, 1, 1), (10, 1, 1), (9, 2, 1)],
            [(20, 10, 20), (19, 9, 19), (19, 9, 18)],  # On the far faces of the last leaf.
            [(-1, 1, 1), (3, 1, 1), (13, 2, 1)],  # With its first corner outside.
        ],
        np.float32,
    )
    world = nf.Scene.from_arrays(corners.reshape(-1, 3), np.arange(12).reshape(-1, 3))
    mine = {place: owned_mask(found, grid, place) for place, found in parts(world, grid)}
    found = {place: set(keys(world.query(grid.box(0, place)).triangles()[flags])) for place, flags in mine.items()}
    first, second, last, third = keys(corners)
    assert found == {(0, 0, 0): {second, third}, (1, 0, 0): {first}, (1, 0, 1): {last}}


def test_a_triangle_across_a_partial_tree_belongs_to_its_central_leaf() -> None:
    grid = Grid((0.0, 0.0, 0.0), 10.0, (5, 1, 1))
    # The tree's box cuts this triangle down to the rectangle between x = 0 and 50, and z = 0 and 10.
    world = nf.Scene.from_arrays([(-100, 5, -100), (-100, 5, 200), (300, 5, 0)], [[0, 1, 2]])
    assert [place for place, found in parts(world, grid) if owned_mask(found, grid, place).any()] == [(2, 0, 0)]


# positions ------------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize(("world", "cell"), [("boxes", 8.0), ("far", 40.0), ("balls", 4.0)])
def test_positions_are_within_the_stated_error(world: str, cell: float) -> None:
    worlds = {
        "boxes": lambda: boxes(10, 40.0)[0],
        "far": lambda: with_area(soup(FAR)),
        "balls": balls,
    }
    scene = worlds[world]()
    grid = Grid.from_bounds(scene.bounds, cell)
    errors = []
    for place, part in parts(scene, grid):
        data = cell_glb(part, grid, place)
        mine = owned_mask(part, grid, place)[: part._core.standing_triangle_count]
        assert (data is None) == (not mine.any())
        if data is None:
            continue
        stated = glb.header(data)[0]["asset"]["extras"]
        found, expected = load_triangles(data), standing(part)[mine]
        assert stated["triangles"] == len(found) == len(expected)
        errors.append(farthest(found, expected))
        # The reader's own coordinates are float32.
        assert errors[-1] <= stated["error"] + np.abs(found).max() * 2.0**-24
        low, high = np.array(stated["box"])
        assert (low < found.min(axis=(0, 1))).all()
        assert (high > found.max(axis=(0, 1))).all()
        assert (low > found.min(axis=(0, 1)) - 4 * step_of(grid)).all()
    # Instances add another half step of error.
    assert 0.2 * step_of(grid) < max(errors) <= step_of(grid) * (1 if world == "balls" else 0.51)


def load_triangles(data: bytes) -> NDArray[np.float64]:
    """Triangles of a file, world, metres. They are exact relative to its first node, about which they are read."""
    document, _ = glb.header(data)
    origin = np.array(document["nodes"][0].pop("translation", (0.0, 0.0, 0.0)))
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "leaf.glb"
        path.write_bytes(glb.with_document(data, document))
        triangles = world_triangles(nf.Scene.load(path))
    moved: NDArray[np.float64] = triangles + origin
    return moved


@pytest.mark.parametrize("cell", [16.0, 7.0])
def test_shared_corners_are_rounded_equally_in_all_leaves(cell: float) -> None:
    # Half of all multiples of half a step lie between two steps.
    rng = np.random.default_rng(1)
    heights = rng.integers(-(2**11), 2**11, (40, 40))
    x, z = np.meshgrid(np.arange(40) + 2.0**-11, np.arange(40) - 3 * 2.0**-11, indexing="ij")
    corners = np.stack([x, heights * 2.0**-11, z], axis=-1).reshape(-1, 3)
    first = (np.arange(39)[:, None] * 40 + np.arange(39)).ravel()
    faces = np.concatenate([first[:, None] + [0, 1, 40], first[:, None] + [1, 41, 40]])
    world = nf.Scene.from_arrays(corners, faces)
    grid = Grid.from_bounds(world.bounds, cell)
    step = step_of(grid)
    assert step == (MAX_STEP if cell == 16 else 2.0**-12)
    files = [cell_glb(part, grid, place) for place, part in parts(world, grid)]
    found = np.concatenate([load_triangles(data) for data in files if data is not None]).reshape(-1, 3)
    expected = np.rint(corners / step) * step  # To the even step at ties.
    assert len(files) > 6
    assert set(keys(found + 0.0)) == set(keys(expected + 0.0))


def test_the_step_shrinks_with_small_leaves() -> None:
    def step(cell: float) -> float:
        return step_of(Grid((0.0, 0.0, 0.0), cell, (1, 1, 1)))

    assert [step(cell) for cell in (1e6, 16.0, 15.9, 8.0, 1.0)] == [2.0**-10, 2.0**-10, 2.0**-11, 2.0**-11, 2.0**-14]
    assert step(1e-12) == 2.0**-40


# content --------------------------------------------------------------------------------------------------------------
def test_meshes_of_several_placements_are_written_once() -> None:
    rng = np.random.default_rng(2)
    builder = nf.SceneBuilder()
    vertices = rng.normal(size=(300, 3)) * 0.2
    mesh = builder.mesh(vertices, np.arange(300).reshape(-1, 3))
    for number in range(50):
        matrix = np.eye(4)
        matrix[:3, 3] = rng.uniform(1, 9, 3)
        builder.instance(mesh, matrix, name=f"tree {number}")
    world = builder.build()
    grid = Grid((0.0, 0.0, 0.0), 10.0, (1, 1, 1))
    data = cell_glb(world, grid, (0, 0, 0))
    assert data is not None
    document, _ = glb.header(data)
    assert document["asset"]["extras"]["triangles"] == 5000
    assert document["accessors"][document["meshes"][0]["primitives"][0]["indices"]]["count"] == 300
    assert "EXT_mesh_gpu_instancing" in document["extensionsRequired"]
    assert "EXT_meshopt_compression" in document["extensionsRequired"]
    assert len(data) < 8 * 300 + 50 * 20 + 3000


def test_triangles_without_area_are_omitted_and_empty_leaves_have_no_file() -> None:
    grid = Grid((0.0, 0.0, 0.0), 16.0, (2, 1, 1))
    corners = np.array([[(1, 1, 1), (1.0001, 1, 1), (1, 1.0001, 1)], [(17, 1, 1), (18, 1, 1), (17, 2, 1)]])
    world = nf.Scene.from_arrays(corners.reshape(-1, 3), [[0, 1, 2], [3, 4, 5]])
    small, large = (cell_glb(world.query(grid.box(0, (x, 0, 0))), grid, (x, 0, 0)) for x in (0, 1))
    assert small is None
    assert large is not None
    np.testing.assert_array_equal(load_triangles(large), corners[1:])


def test_leaves_share_texture_files(tmp_path: Path) -> None:
    builder = nf.SceneBuilder()
    rng = np.random.default_rng(0)
    shown, hidden = (np.full((8, 16, 4), 255, np.uint8) for _ in range(2))
    shown[..., :3] = np.linspace(0, 255, 16)[None, :, None]
    hidden[..., :3] = rng.integers(0, 256, (8, 16, 3))
    square, faces, uvs = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [[0, 1, 2], [0, 2, 3]], rng.random((4, 2))
    for number, texels in enumerate((hidden, shown, shown)):
        matrix = np.eye(4)
        matrix[:3, 3] = 1 + 10 * number, 1, 1
        mesh = builder.mesh(square, faces, uvs=uvs, material=builder.material(texture=texels))
        builder.instance(mesh, matrix, name=f"square {number}")
    world = builder.build()
    grid = Grid((0.0, 0.0, 0.0), 10.0, (3, 1, 1))
    images = Images(tmp_path / "images")
    uris = []
    for x in (1, 2):
        data = cell_glb(world.query(grid.box(0, (x, 0, 0))), grid, (x, 0, 0), images)
        assert data is not None
        uris += [image["uri"] for image in glb.header(data)[0]["images"]]
    (file,) = (tmp_path / "images").iterdir()
    assert uris == 2 * [f"{IMAGES}/{file.name}"]
    with Image.open(io.BytesIO(file.read_bytes())) as image:
        assert np.abs(np.asarray(image.convert("RGB")).astype(int) - shown[..., :3]).mean() < 8
    plain = cell_glb(world.query(grid.box(0, (1, 0, 0))), grid, (1, 0, 0))
    assert plain is not None
    assert "images" not in glb.header(plain)[0]


def test_textures_that_exceed_the_image_format_are_halved(tmp_path: Path) -> None:
    name = Images(tmp_path).add(np.full((4, 16384, 4), 255, np.uint8))
    with Image.open(tmp_path / name) as image:
        assert image.size == (8192, 2)


def test_moving_objects_have_separate_files(tmp_path: Path) -> None:
    turn = np.eye(4)
    turn[:3, 3] = 1.5, 0.25, 3.0
    world = balls().at({"ball 1": turn})
    grid = Grid.from_bounds(world.bounds, 4.0)
    moving, rows = [], Counter[str]()
    for place, part in parts(world, grid):
        data = moving_glb(part, grid, place)
        if data is None:
            continue
        document, _ = glb.header(data)
        described = document["asset"]["extras"]["moving"]
        path = tmp_path / "a.glb"
        path.write_bytes(data)
        scene = nf.Scene.load(path)
        assert [row["object"] for row in described] == [node["name"] for node in document["nodes"][1:]]
        assert set(scene.object_names) == {row["object"] for row in described}
        for row in described:
            rows[row["object"]] += 1
            np.testing.assert_array_equal(row["transform"], world.transform(row["object"]))
            assert ("rest" in row) == (row["object"] == "ball 1")
        moving.append(world_triangles(scene))
    assert set(rows) == {"ball 0", "ball 1"}
    expected = world_triangles(world)[world._core.standing_triangle_count :]
    assert farthest(np.concatenate(moving), expected) <= MAX_STEP


def test_bytes_do_not_depend_on_threads_or_runs() -> None:
    code = """
        import hashlib, nearfar
        from nearfar.orthoview._geometry import cell_glb, moving_glb
        from nearfar.orthoview._grid import Grid
        world = nearfar.datasets.city(blocks=2, detail=0)
        grid = Grid((-40.0, -9.0, -40.0), 40.0, (2, 1, 2))
        for x in range(2):
            part = world.query(grid.box(0, (x, 0, 1)))
            for encode in (cell_glb, moving_glb):
                print(hashlib.sha256(encode(part, grid, (x, 0, 1)) or b"").hexdigest())
    """
    printed = printed_by_threads(textwrap.dedent(code))
    assert len(printed) == 1
    assert len(set(printed.pop().split())) > 2
