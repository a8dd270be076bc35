"""The page's store, cut and decoding in Node beside Python's."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from threading import Thread
from typing import Any

import numpy as np
import pytest
import trimesh
from numpy.typing import NDArray

import nearfar as nf
from nearfar.orthoview import _codec
from nearfar.orthoview._layout import BEHIND, CHANNELS
from tests.support import need
from tests.support.orthoview_page import ViewKey, cameras, cases_of, in_node
from tests.support.range_server import served
from tests.support.web_cases import run

pytestmark = pytest.mark.slow

STEPS = ((1, 0), (0, 1), (1, 1), (-1, 1))
"""Columns and rows to the neighbours of a pixel's four bits."""


@pytest.fixture(scope="module", autouse=True)
def _parts() -> None:
    need("web")
    need("zarr")


@pytest.fixture(scope="module")
def changed(world: nf.Scene, tmp_path_factory: pytest.TempPathFactory) -> nf.orthoview.OrthoTree:
    """A tree of two layers and long normals, of which parts were taken away in two updates."""
    path = tmp_path_factory.mktemp("trees") / "changed.zarr"
    tree = nf.orthoview.build(world, path, cell=12, size=20, directions=9, layers=2, normal_bits=24, depth_bits=14)
    low, high = tree.bounds
    middle = (low + high) / 2
    tree.update(np.array([low, middle]), scene_of(world.triangles()[:40] + world.origin))
    return nf.orthoview.open(path).update(np.array([middle, high]), scene_of(world.triangles() + world.origin + 3.0))


def scene_of(triangles: NDArray[np.floating[Any]]) -> nf.Scene:
    corners = triangles.reshape(-1, 3)
    return nf.Scene.from_trimesh(trimesh.Trimesh(corners, np.arange(len(corners)).reshape(-1, 3), process=False))


def words_of(tree: nf.orthoview.OrthoTree, key: ViewKey) -> list[NDArray[np.uint32]]:
    """The words of a view's layers, row by row, from the chunks that Python reads."""
    level, place, direction = key
    layout = tree._layout
    found = []
    for prefix in ("", BEHIND)[: layout.layers]:
        names = [(level, place, layout.array(level, direction, prefix + channel)) for channel in CHANNELS]
        chunks = {
            (direction, name): chunk for name, chunk in zip(CHANNELS, tree._chunks.read(names), strict=True) if chunk
        }
        if not chunks:
            continue
        views, bits = _codec.decoded(chunks, layout, (direction,))
        arrays = (views.colors()[0], views.depths()[0, ..., 0], views.normals()[0], bits[0, ..., 0])
        found.append(words(*(np.asarray(array).astype(np.int64) for array in arrays)))
    return found


def words(color: Any, depth: Any, normal: Any, bits: Any) -> NDArray[np.uint32]:
    size = len(depth)
    rows = []
    for y, x in np.argwhere(depth > 0).tolist():
        near = 0
        for bit, (columns, lines) in enumerate(STEPS):
            ahead, behind = (x + columns, y + lines), (x - columns, y - lines)
            near += bits[y, x] >> bit & 1 if 0 <= ahead[0] < size and ahead[1] < size else 0
            is_in = 0 <= behind[0] < size and behind[1] >= 0
            near += bits[behind[1], behind[0]] >> bit & 1 if is_in else 0
        red, green, blue = color[y, x]
        u, v = normal[y, x]
        code = depth[y, x]
        rows.append(
            (
                red | green << 8 | blue << 16 | code >> 8 << 24,
                u | v << 12 | (code & 255) << 24,
                x | y << 12 | (near > 4) << 24 | (near == 8) << 25,
            )
        )
    return np.array(rows, np.uint32)


def in_rows(layer: dict[str, Any]) -> NDArray[np.uint32]:
    """The page's words of a layer, row by row; its parts have all of them, within their bounds."""
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


def check(tree: nf.orthoview.OrthoTree, folder: Path, url: str, count: int) -> None:
    some = cameras(tree, count, seed=3)
    cuts = [tree.cut(camera, geometry=False) for camera in some[:6]]
    keys = sorted({key for cut in cuts for key in cut.keys()})[:: max(count // 40, 1)]  # noqa: SIM118 - no mapping
    cases = cases_of(tree, some)
    assert len({cell[0] for case in cases for cell in case["cells"]}) >= tree.levels - 1
    assert sum(len(case["files"]) > len(case["leaves"]) > 0 for case in cases) >= len(cases) // 8
    layers = in_node(folder, url, cases, keys)
    assert len(layers) == len(keys) > 20
    for key, found in zip(keys, layers, strict=True):
        expected = words_of(tree, key)
        assert len(found) == len(expected)
        for layer, own in zip(found, expected, strict=True):
            np.testing.assert_array_equal(in_rows(layer), own)


def test_cuts_and_splats_are_those_of_python(tree: nf.orthoview.OrthoTree, tmp_path: Path) -> None:
    path = Path(tree.path)
    with served(path.parent) as server:
        check(tree, tmp_path, f"{server.url}{path.name}/", 120)
        asked = {(method, name.partition("?")[0]) for method, name, _ in server.answers}
    assert {method for method, _ in asked} == {"GET"}
    # Metadata of arrays follow from the layout.
    assert [name for _, name in asked if name.endswith("zarr.json")] == [f"{path.name}/zarr.json"]


def test_views_of_updates_are_read(changed: nf.orthoview.OrthoTree, tmp_path: Path) -> None:
    path = Path(changed.path)
    with served(path.parent) as server:
        check(changed, tmp_path, f"{server.url}{path.name}/", 40)
        asked = " ".join(name for _, name, _ in server.answers)
    assert "generations/1/" in asked
    assert "generations/2/" in asked


@contextmanager
def without_ranges(folder: Path) -> Iterator[str]:
    """A server that sends whole files, whatever is asked for."""

    class Handler(SimpleHTTPRequestHandler):
        def log_message(self, *_: Any) -> None:
            """Print nothing."""

    with ThreadingHTTPServer(("127.0.0.1", 0), partial(Handler, directory=str(folder))) as server:
        thread = Thread(target=server.serve_forever, args=(0.01,))
        thread.start()
        try:
            yield f"http://127.0.0.1:{server.server_port}/"
        finally:
            server.shutdown()
            thread.join()


def test_hosts_without_ranges_are_read(tmp_path: Path) -> None:
    # Shards above 64 kB, of which parts are asked for.
    rng = np.random.default_rng(4)
    corners = rng.uniform(0, 100, (1500, 1, 3)) + rng.uniform(-5, 5, (1500, 3, 3))
    tree = nf.orthoview.build(scene_of(corners), tmp_path / "large.zarr", cell=26, size=64, directions=5)
    assert max(path.stat().st_size for path in tmp_path.glob("large.zarr/0/py/*/c/0/0/0/0/0/0")) > 1 << 16
    with without_ranges(tmp_path) as url:
        check(tree, tmp_path, f"{url}large.zarr/", 12)
    shutil.rmtree(tmp_path / "tests")
    with served(tmp_path) as server:
        check(tree, tmp_path, f"{server.url}large.zarr/", 12)
        assert 206 in {status for _, _, status in server.answers}


def test_the_other_parts_in_node(tmp_path: Path) -> None:
    run("node", "build.mjs", "--tests", str(tmp_path))
    run("node", "--test", str(tmp_path / "orthoview_parts.test.mjs"))
