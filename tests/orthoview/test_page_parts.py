"""The page's store, cut and decoding in Node compared with Python's."""

from __future__ import annotations

from http.server import SimpleHTTPRequestHandler
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from numpy.typing import NDArray

import nearfar as nf
from nearfar.orthoview import _codec
from nearfar.orthoview._grid import Place
from nearfar.serve._server import Server
from tests.support import need
from tests.support.orthoview_page import Damage, Store, ViewKey, cameras, cases_of, in_node
from tests.support.orthoview_stores import CELL, SIZE, Interrupted, masks_of
from tests.support.range_server import RangeHandler, serve_folder
from tests.support.shared_folders import make_once
from tests.support.web_cases import web_tests

pytestmark = pytest.mark.slow

STEPS = ((1, 0), (0, 1), (1, 1), (-1, 1))
"""Column and row offsets of the neighbours of a pixel's four bits."""


@pytest.fixture(scope="module", autouse=True)
def _parts() -> None:
    need("web")
    need("zarr")


@pytest.fixture(scope="module")
def updated_tree(few: nf.Scene, tmp_path_factory: pytest.TempPathFactory) -> nf.orthoview.OrthoTree:
    """A tree of two layers and 24-bit normals, of which parts were removed in two updates."""

    def make(path: Path) -> None:
        tree = nf.orthoview.build(few, path, cell=12, size=20, directions=9, layers=2, normal_bits=24, depth_bits=14)
        low, high = tree.bounds
        middle = (low + high) / 2
        tree.update(np.array([low, middle]), scene_of(few.triangles()[:40] + few.origin))
        nf.orthoview.open(path).update(np.array([middle, high]), scene_of(few.triangles() + few.origin + 3.0))

    return nf.orthoview.open(make_once(tmp_path_factory, "changed.zarr", make))


@pytest.fixture(scope="module")
def large(tmp_path_factory: pytest.TempPathFactory) -> nf.orthoview.OrthoTree:
    """A tree with large shards, of which the page requests parts."""
    rng = np.random.default_rng(4)
    corners = rng.uniform(0, 100, (700, 1, 3)) + rng.uniform(-5, 5, (700, 3, 3))
    settings: dict[str, Any] = {"cell": 26, "size": 48, "directions": 5}
    path = make_once(
        tmp_path_factory, "large.zarr", lambda path: nf.orthoview.build(scene_of(corners), path, **settings)
    )
    assert max(shard.stat().st_size for shard in path.glob("0/py/c/0/0/0/0")) > 1 << 16
    return nf.orthoview.open(path)


def scene_of(triangles: NDArray[np.floating[Any]]) -> nf.Scene:
    corners = triangles.reshape(-1, 3)
    return nf.Scene.from_trimesh(trimesh.Trimesh(corners, np.arange(len(corners)).reshape(-1, 3), process=False))


def words_of(tree: nf.orthoview.OrthoTree, key: ViewKey) -> list[NDArray[np.uint32]]:
    """The words of a view's layers, row by row, from the chunks that Python reads."""
    level, place, direction = key
    chunks = tree._chunks.read_views(level, place, (direction,))
    found = []
    for views, bits in _codec.decode(chunks, tree._layout, (direction,)):
        arrays = (views.colors()[0], views.depths()[0, ..., 0], views.normals()[0], bits[0, ..., 0])
        found.append(words(*(np.asarray(array).astype(np.int64) for array in arrays)))
    return found


def words(color: Any, depth: Any, normal: Any, bits: Any) -> NDArray[np.uint32]:
    """Three words of each non-empty pixel, row by row."""
    y, x = np.indices(depth.shape)
    near = np.zeros(depth.shape, int)
    for bit, (columns, lines) in enumerate(STEPS):
        ahead = (x + columns >= 0) & (x + columns < len(depth)) & (y + lines < len(depth))
        joined = (bits >> bit & 1) * ahead
        near += joined + np.roll(joined, (lines, columns), (0, 1))
    red, green, blue = np.moveaxis(color, -1, 0)
    u, v = np.moveaxis(normal, -1, 0)
    found = (
        red | green << 8 | blue << 16 | depth >> 8 << 24,
        u | v << 12 | (depth & 255) << 24,
        x | y << 12 | (near > 4).astype(int) << 24 | (near == 8).astype(int) << 25,
    )
    pixels: NDArray[np.uint32] = np.stack(found, axis=-1)[depth > 0].astype(np.uint32)
    return pixels


def in_rows(layer: dict[str, Any]) -> NDArray[np.uint32]:
    """The page's words of a layer, row by row; checks that its parts contain all of them, within their bounds."""
    found = np.array(layer["words"], np.uint32).reshape(-1, 3)
    end = 0
    for part in layer["parts"]:
        assert part["first"] == end
        end += part["count"]
        own = found[part["first"] : end].astype(np.int64)
        at = np.stack([own[:, 2] & 4095, own[:, 2] >> 12 & 4095, own[:, 0] >> 24 << 8 | own[:, 1] >> 24], axis=1)
        at[:, 2] -= 1
        assert at.min(axis=0).tolist() == part["low"]
        assert (at.max(axis=0) + 1).tolist() == part["high"]
    assert end == len(found)
    return found[np.lexsort((found[:, 2] & 4095, found[:, 2] >> 12 & 4095))]


def sample(tree: nf.orthoview.OrthoTree, url: str, count: int) -> Store:
    """Cuts of a tree and views of some of them, for Node to compare and read."""
    some = cameras(tree, count, seed=3)
    cuts = [tree.cut(camera, geometry=False) for camera in some[:6]]
    keys = sorted({key for cut in cuts for key in cut.keys()})  # noqa: SIM118 - no mapping
    cases = cases_of(tree, some)
    assert len({cell[0] for case in cases for cell in case["cells"]}) >= tree.levels - 1
    assert sum(len(case["files"]) > len(case["leaves"]) > 0 for case in cases) >= len(cases) // 10
    return Store(url, cases, keys[:: len(keys) // 30 + 1])


def check(tree: nf.orthoview.OrthoTree, store: Store, layers: list[list[dict[str, Any]]]) -> None:
    """Compare the splats that Node has read with Python's."""
    assert len(layers) == len(store.views) > 10
    for key, found in zip(store.views, layers, strict=True):
        expected = words_of(tree, key)
        assert len(found) == len(expected)
        for layer, own in zip(found, expected, strict=True):
            np.testing.assert_array_equal(in_rows(layer), own)


class WithoutRanges(RangeHandler):
    """Ignores ranges and sends whole files."""

    do_GET = SimpleHTTPRequestHandler.do_GET  # noqa: N815 - the base class's name


def damage_store(path: Path) -> list[Damage]:
    """Alter and remove files of a store; returns the errors that Node should report."""
    tree = nf.orthoview.open(path)
    of_leaves = [key for key in views_of(tree) if key[0] == 0]
    (altered, array, chunk), (lost, _, gone) = (
        (key, *chunk_of(tree, key)) for key in (of_leaves[0], next(key for key in of_leaves if key[2] == 0))
    )
    assert chunk.file != gone.file
    content = bytearray((path / chunk.file).read_bytes())
    content[chunk.first + chunk.length - 2] ^= 1  # in the frame's checksum
    (path / chunk.file).write_bytes(content)
    (path / gone.file).unlink()
    first, second, *_ = sorted((path / "geometry" / "content").rglob("*.glb"))
    first.write_bytes(first.read_bytes()[:-3] + b"abc")
    second.unlink()
    return [
        Damage(altered, "damaged", [array, "checksum"]),
        Damage(lost, "gone", [gone.file]),
        Damage((0, place_of(first), -1), "damaged", [first.name, "record"]),
        Damage((0, place_of(second), -1), "gone", [second.name]),
    ]


def views_of(tree: nf.orthoview.OrthoTree) -> list[ViewKey]:
    masks = masks_of(tree).items()
    count = len(tree.directions)
    return [(*cell, number) for cell, mask in masks for number in reversed(range(count)) if mask >> number & 1]


def chunk_of(tree: nf.orthoview.OrthoTree, key: ViewKey) -> tuple[str, Any]:
    """The array of a view, and its chunk."""
    own = tree._layout.key(key)
    (chunk,) = tree._chunks.locate([own])
    assert chunk is not None
    return own[2], chunk


def place_of(file: Path) -> Place:
    x, y, z = map(int, file.with_suffix("").parts[-3:])
    return x, y, z


def test_stores_are_read_as_in_python(
    tree: nf.orthoview.OrthoTree,
    updated_tree: nf.orthoview.OrthoTree,
    large: nf.orthoview.OrthoTree,
    copied_few: Path,
    tmp_path: Path,
    tmp_path_factory: pytest.TempPathFactory,
) -> None:
    """Covers a tree, one with updates, one with large shards with and without ranges, and a damaged one."""
    folder = Path(tree.path).parent
    with serve_folder(folder) as server, serve_folder(folder, WithoutRanges) as whole, serve_folder(tmp_path) as other:
        trees = [tree, updated_tree, large, large]
        urls = [f"{url}{Path(own.path).name}/" for own, url in zip(trees, [server.url] * 3 + [whole.url], strict=True)]
        stores = [sample(own, url, count) for own, url, count in zip(trees, urls, (60, 40, 12, 12), strict=True)]
        few = nf.orthoview.open(copied_few)
        cases = cases_of(few, cameras(few, 1, seed=3))
        stores.append(Store(f"{other.url}{copied_few.name}/", cases, [], damage_store(copied_few)))
        layers = in_node(web_tests(tmp_path_factory), tmp_path, stores)
    for own, store, found in zip(trees, stores, layers, strict=False):
        check(own, store, found)
    requests = {(method, name.partition("?")[0], status) for method, name, status in server.answers}
    assert {method for method, _, _ in requests} == {"GET"}
    # Metadata of arrays follow from the layout.
    documents = [name for _, name, _ in requests if name.endswith("zarr.json")]
    assert sorted(documents) == sorted(f"{Path(own.path).name}/zarr.json" for own in (tree, updated_tree, large))
    names = " ".join(name for _, name, _ in requests)
    assert all(f"changed.zarr/nearfar/generations/{number}/" in names for number in (1, 2))
    # Each view is one request for a part of a shard, whose index is never read.
    chunks = [(status, count) for (_, name, status), count in server.answers.items() if "/c/" in name]
    assert {status for status, _ in chunks} == {206}
    assert sum(count for _, count in chunks) == sum(len(store.views) for store in stores[:3])


def test_node_reads_a_tree_whose_build_has_not_ended(
    few: nf.Scene, tmp_path: Path, tmp_path_factory: pytest.TempPathFactory
) -> None:
    path = tmp_path / "part.zarr"
    with pytest.raises(KeyboardInterrupt):
        nf.orthoview.build(Interrupted(few, 250), path, cell=CELL, size=SIZE, directions=5)
    with Server.of_bundle(path) as server:
        served = nf.orthoview.open(server.url)
        some = cameras(served, 30, seed=5)
        cases = cases_of(served, some)
        assert {case["unbuilt"] > 0 for case in cases} == {False, True}
        cuts = [served.cut(camera, geometry=False) for camera in some]
        keys = sorted({key for cut in cuts for key in cut.keys()})  # noqa: SIM118 - no mapping
        assert {0, 1, 2} <= {level for level, _, _ in keys}
        store = Store(server.url, cases, keys[:: len(keys) // 30 + 1])
        (layers,) = in_node(web_tests(tmp_path_factory), tmp_path, [store])
        check(served, store, layers)
