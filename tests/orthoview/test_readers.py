"""Other programs read stores as in docs/orthoview.md: zarr-python over HTTP, and zarrita also from a folder."""

from __future__ import annotations

import base64
import json
import re
import subprocess
import sys
from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from numpy.typing import NDArray

import nearfar as nf
from tests.support import need
from tests.support.orthoview_oracle import decoded
from tests.support.orthoview_stores import places
from tests.support.range_server import serve_folder
from tests.support.reader_cases import FOLDER, SECONDS, node
from tests.support.shared_folders import make_once

PAGE = Path(__file__).resolve().parents[2] / "docs" / "orthoview.md"
CELL, SIZE, STEPS = 10.0, 16, 4092
NAMES = ("py", "px_py", "nz")
"""Directions along an axis and between two."""

Place = tuple[int, int, int]
Chunk = tuple[str, Place]
"""An array and an index in it."""


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A store of boxes near one another and one far away, so that shards between them are missing."""
    need("zarr")
    rng = np.random.default_rng(5)
    parts = []
    for x in (*rng.uniform(0, 30, 8), 175.0):
        turn = trimesh.transformations.random_rotation_matrix(rng.random(3))
        turn[:3, 3] = x, *rng.uniform(0, 20, 2)
        parts.append(trimesh.creation.box(rng.uniform(3, 12, 3)).apply_transform(turn))
        parts[-1].visual.vertex_colors = rng.integers(40, 256, 4)
    world = nf.Scene.from_trimesh(trimesh.util.concatenate(parts))
    settings: dict[str, Any] = {"cell": CELL, "size": SIZE, "directions": 9}
    return make_once(tmp_path_factory, "far.zarr", lambda path: nf.orthoview.build(world, path, **settings))


def layout_of(group: Any) -> dict[str, Any]:
    layout: dict[str, Any] = group.attrs["nearfar"]["layout"]
    return layout


def places_of(group: Any, level: int) -> list[Place]:
    return places(group[f"{level}/py"].shape[:3])


def check_views(tree: nf.orthoview.OrthoTree, group: Any, level: int, some: list[Place]) -> Counter[bool]:
    """Compare zarr-python's arrays with a tree's views; returns the numbers of non-empty and empty views."""
    found: Counter[bool] = Counter()
    for name in NAMES:
        number = layout_of(group)["names"].index(name)
        array = group[f"{level}/{name}"]
        for place in some:
            color, low, high, normal = np.split(array[place], np.cumsum([3, 1, 1]) * SIZE**2)
            view = tree.view(level, place, number)
            found[view is not None] += 1
            if view is None:
                assert not array[place].any()
                continue
            np.testing.assert_array_equal(color.reshape(SIZE, SIZE, 3), view.color)
            codes = (low + 256 * high.astype(int)).reshape(SIZE, SIZE) >> 4
            # The signs of a direction's axes are the parts of its name: a cell is √1, √2 or √3 sides deep.
            deep = CELL * 2**level * np.sqrt(len(name.split("_")))
            metres = np.where(codes > 0, (codes - 0.5) * deep / STEPS, np.inf)
            np.testing.assert_allclose(metres, view.depth, rtol=1e-6)
            vectors = decoded(normal.reshape(SIZE, SIZE, 2).astype(np.uint16), 8)[codes > 0]
            np.testing.assert_allclose(vectors, view.normal[codes > 0], atol=1e-5)
    return found


def test_zarr_python_reads_over_http(path: Path) -> None:
    import zarr

    need("fsspec")
    need("aiohttp")
    with serve_folder(path.parent) as server:
        group, tree = zarr.open_group(server.url + path.name, mode="r"), nf.orthoview.open(path)
        assert layout_of(group)["levels"] == tree.levels == 6
        for level in range(tree.levels):
            found = check_views(tree, group, level, places_of(group, level)[:: 16 if level == 0 else 3])
            assert found[True] > 2
            assert found[False] > 5 or level > 1
        shards = Counter({key: count for key, count in server.answers.items() if "/c/" in key[1]})
    assert {status for method, _, status in shards if method == "GET"} == {206, 404}


# zarrita -------------------------------------------------------------------------------------------------------------
def by_zarrita(place: str, chunks: list[Chunk]) -> tuple[dict[str, Any], list[dict[str, Any]]]:
    """The group's attributes and chunks, as zarrita reads them."""
    asked = [text for array, cell in chunks for text in (array, ",".join(map(str, cell)))]
    answer = node("orthoviews.mjs", [place, *asked])
    return answer["attributes"], answer["read"]


def some_chunks(group: Any) -> list[Chunk]:
    """Chunks of some directions and all levels, empty and non-empty."""
    return [
        (f"{level}/{name}", place)
        for level in range(layout_of(group)["levels"])
        for name in NAMES
        for place in places_of(group, level)[:: 29 if level == 0 else 5]
    ]


def check_chunks(group: Any, chunks: list[Chunk], read: list[dict[str, Any]]) -> Counter[bool]:
    """Compare zarrita's chunks with zarr-python's arrays; returns the numbers of non-empty and empty chunks."""
    found: Counter[bool] = Counter()
    for (name, place), got in zip(chunks, read, strict=True):
        array = group[name]
        expected = array[place]
        assert got["shape"] == list(array.shape)
        assert got["type"] == array.dtype.name
        assert got["chunk"] == [1, 1, 1, *expected.shape]
        assert base64.b64decode(got["bytes"]) == expected.tobytes()
        found[bool(expected.any())] += 1
    return found


@pytest.mark.slow
def test_zarrita_reads_chunks_and_fills_missing_ones(path: Path) -> None:
    """Reads from a folder and over HTTP."""
    import zarr

    need("node")
    group = zarr.open_group(str(path), mode="r")
    chunks = some_chunks(group)
    local, read = by_zarrita(str(path), chunks)
    with serve_folder(path.parent) as server:
        remote, again = by_zarrita(server.url + path.name, chunks)
        shards = Counter({key: count for key, count in server.answers.items() if "/c/" in key[1]})
    assert local == remote == dict(group.attrs)
    assert read == again
    found = check_chunks(group, chunks, read)
    assert min(found.values()) > 20
    # The index of a shard is read once for each opened array, an existing chunk once, a missing one never.
    parts = sum(count for (method, _, status), count in shards.items() if (method, status) == ("GET", 206))
    heads = sum(count for (method, _, status), count in shards.items() if (method, status) == ("HEAD", 200))
    assert parts == found[True] + heads
    assert {(method, status) for method, _, status in shards} == {("GET", 206), ("HEAD", 200), ("HEAD", 404)}


SIDE = 32
"""Pixels of views in this test; the page's example has more."""


# docs/orthoview.md ---------------------------------------------------------------------------------------------------
def blocks(language: str) -> list[str]:
    return re.findall(rf"```{language}\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)


@pytest.fixture(scope="module")
def city(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder in which the page's first example has run, with fewer blocks and smaller views."""
    need("zarr")
    code = blocks("python")[0]
    for large, small in (("blocks=4", "blocks=2"), ("size=256", f"size={SIDE}")):
        assert large in code
        code = code.replace(large, small)

    def make(folder: Path) -> None:
        folder.mkdir()
        run([sys.executable, "-W", "error", "-c", code], folder)

    return make_once(tmp_path_factory, "page", make)


def run(command: list[str], folder: Path) -> str:
    process = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=SECONDS, check=False)
    assert process.returncode == 0, process.stderr
    return process.stdout


@pytest.mark.slow
def test_the_pages_python_and_javascript_read_its_leaf(city: Path, tmp_path: Path) -> None:
    code = blocks("python")[1]
    assert "nearfar " not in code
    more = f"\nnp.savez({str(tmp_path / 'read.npz')!r}, color=color, metres=metres)"
    run([sys.executable, "-W", "error", "-c", code + more], city)
    with np.load(tmp_path / "read.npz") as read:
        check_leaf(city, read["color"], read["metres"])
    need("node")
    (tmp_path / "city.zarr").symlink_to(city / "city.zarr")
    (tmp_path / "node_modules").symlink_to(FOLDER / "node_modules")
    # JSON has no infinity.
    more = "\nconsole.log(JSON.stringify([Array.from(color), metres.map((m) => (m === Infinity ? null : m))]));"
    *_, printed = run(["node", "--input-type=module", "-e", blocks("js")[0] + more], tmp_path).splitlines()
    color, metres = json.loads(printed)
    shape = (SIDE, SIDE)
    check_leaf(
        city,
        np.array(color, np.uint8).reshape(*shape, 3),
        np.array([np.inf if m is None else m for m in metres]).reshape(shape),
    )


def check_leaf(city: Path, color: NDArray[np.uint8], metres: NDArray[np.float64]) -> None:
    view = nf.orthoview.open(city / "city.zarr").view(0, (4, 0, 4), 4)
    assert view is not None
    assert np.isfinite(view.depth).mean() > 0.5
    np.testing.assert_array_equal(color, view.color)
    np.testing.assert_allclose(metres, view.depth, rtol=1e-6)
