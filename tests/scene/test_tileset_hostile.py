"""Tests of hostile and mutated tilesets: an error that names file and place, in short time and little memory."""

from __future__ import annotations

import gzip
import json
import random
import struct
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import nearfar as nf
from nearfar._scene import budget
from nearfar._scene.tileset import select
from tests.attack import mutate
from tests.support import PEAK, need
from tests.support.tile_cases import (
    LONGEST,
    QUAD,
    b3dm,
    box,
    cmpt,
    glb,
    instanced,
    refusal,
    subtree,
    tile,
    tileset,
    write,
)

CUBE = b3dm(glb())


def test_tilesets_that_refer_to_themselves(tmp_path: Path) -> None:
    path = write(tmp_path, {"a.json": tileset(tile(0.0, "a.json"))})
    assert refusal(path) == "root: it refers to itself, through a.json"
    files = {"b.json": tileset(tile(0.0, "c/c.json")), "c/c.json": tileset(tile(0.0, "d.json"))}
    path = write(tmp_path, files | {"c/d.json": tileset(tile(0.0, "../b.json?again#here"))})
    assert refusal(path) == "c/d.json: root: it refers to itself, through b.json and c/c.json and c/d.json"
    (tmp_path / "round").symlink_to(tmp_path)
    path = write(tmp_path, {"e.json": tileset(tile(0.0, "round/e.json"))})
    assert "it refers to itself" in refusal(path)


@pytest.fixture
def few_tiles(monkeypatch: pytest.MonkeyPatch) -> None:
    """Allow a hundredth of the tiles; each takes 10 µs."""
    monkeypatch.setattr(select, "MAX_TILES", 1000)


def test_tilesets_that_refer_to_each_other_many_times(few_tiles: None, tmp_path: Path) -> None:
    """Thirty documents, each with two references to the next one, have a billion tiles."""
    both = [tile(1.0, "{}.json"), tile(1.0, "{}.json")]
    files = {
        f"{n}.json": tileset(json.loads(json.dumps(tile(1.0, children=both)).replace("{}", str(n + 1))))
        for n in range(30)
    }
    path = write(tmp_path, files | {"30.json": tileset(tile(0.0, "a.b3dm")), "a.b3dm": CUBE})
    assert refusal(path).startswith("more than 1,000 tiles")


@pytest.mark.parametrize(
    "uri",
    [
        "../secret.b3dm",
        "x/../../secret.b3dm",
        "%2e%2e/secret.b3dm",
        "..%2fsecret.b3dm",
        "link/secret.b3dm",
        "{outside}/secret.b3dm",
        "file://{outside}/secret.b3dm",
        "http://localhost:1/secret.b3dm",
        "//localhost/secret.b3dm",
        "s3://bucket/secret.b3dm",
        "../secret.json",
        "\\\\server\\secret.b3dm",
    ],
)
def test_references_outside_the_folder(tmp_path: Path, uri: str) -> None:
    outside = tmp_path / "outside"
    write(outside, {"secret.b3dm": CUBE, "secret.json": tileset(tile(0.0, "secret.b3dm"))})
    folder = outside / "inside"
    path = write(folder, {"t.json": tileset(tile(0.0, uri.format(outside=outside)))})
    (folder / "x").mkdir()
    (folder / "link").symlink_to(outside)
    assert "which lies outside its folder" in refusal(path)
    # Also from within a tile, and from a subtree.
    body = uri.format(outside=outside).encode()
    path = write(
        folder,
        {"u.json": tileset(tile(0.0, "a.i3dm")), "a.i3dm": instanced(body, 1, embedded=False, POSITION=[0, 0, 0])},
    )
    assert "a.i3dm: it refers to" in refusal(path)
    tiling = {
        "subdivisionScheme": "QUADTREE",
        "subtreeLevels": 1,
        "availableLevels": 1,
        "subtrees": {"uri": body.decode()},
    }
    path = write(folder, {"v.json": tileset(tile(0.0, "a", implicitTiling=tiling))})
    assert "which lies outside its folder" in refusal(path)


def test_textures_and_buffers_outside_the_folder_are_not_read(tmp_path: Path) -> None:
    write(tmp_path, {"secret.bin": bytes(1000)})
    document = glb()
    size = struct.unpack_from("<I", document, 12)[0]
    text = document[20 : 20 + size].replace(b'"byteLength": 240}]', b'"byteLength": 240, "uri": "../secret.bin"}]')
    path = write(tmp_path / "in", {"t.json": tileset(tile(0.0, "a.gltf")), "a.gltf": text})
    assert "which lies outside its folder" in refusal(path)


def test_absurd_trees(few_tiles: None, tmp_path: Path) -> None:
    """Billions of tiles, by constant bits and by subtrees that are all the same file."""
    everything = subtree(True, True, True)[0]
    for name, levels in (("wide.json", (16, 16)), ("deep.json", (1, 64)), ("both.json", (16, 64))):
        tiling = QUAD | {"subtreeLevels": levels[0], "availableLevels": levels[1]}
        root = tile(9.0, "{level}.{x}.{y}.b3dm", implicitTiling=tiling)
        path = write(tmp_path, {name: tileset(root), "s.subtree": everything})
        assert refusal(path).startswith("more than")
    # A part of them, or a coarse view, is accepted.
    (tmp_path / "0.0.0.b3dm").write_bytes(CUBE)
    assert nf.Scene.load(path, error=9).triangle_count == 12
    octree = tile(
        9.0, "a.b3dm", implicitTiling=QUAD | {"subdivisionScheme": "OCTREE", "subtreeLevels": 10, "availableLevels": 10}
    )
    assert refusal(write(tmp_path, {"t.json": tileset(octree)})).startswith("more than")


def test_deep_documents(tmp_path: Path) -> None:
    text = b'{"asset":{"version":"1.0"},"root":' + b'{"children":[' * 100_000 + b"]}" * 100_000 + b"}"
    assert "nested too deeply" in refusal(write(tmp_path, {"t.json": text}))


def test_packed_bombs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(budget, "FREE", 1 << 20)
    bomb = gzip.compress(b" " * (2 << 20), 1)
    path = write(tmp_path, {"t.json": tileset(tile(0.0, "a.b3dm")), "a.b3dm": bomb})
    assert "a.b3dm: it unpacks to more than" in refusal(path)
    path = write(tmp_path, {"u.json": tileset(tile(0.0, "t.json")), "t.json": bomb})
    assert "t.json: it unpacks to more than" in refusal(path)


def sound(folder: Path) -> dict[str, bytes]:
    """Files of a valid tileset with every feature."""
    tiling = QUAD | {"availableLevels": 2}
    children = [
        tile(0.0, "a.b3dm", box((0, 0, 0), (1, 1, 1))),
        tile(0.0, "b.i3dm", {"sphere": [0, 0, 0, 9]}),
        tile(0.0, "c.cmpt", {"region": [0, 0, 0.1, 0.1, 0, 9]}),
        tile(1.0, "d.json", transform=np.eye(4).ravel().tolist()),
        tile(1.0, "{level}.{x}.{y}.glb", implicitTiling=tiling),
    ]
    rows: dict[str, Any] = {
        "POSITION": np.eye(3, dtype=np.float32),
        "SCALE": np.ones(3, np.float32),
        "RTC_CENTER": [1, 2, 3],
    }
    return {
        "t.json": tileset(tile(9.0, "a.b3dm", refine="REPLACE", children=children)),
        "d.json": tileset(tile(0.0, "a.b3dm"), "1.0"),
        "a.b3dm": b3dm(glb(), {"BATCH_LENGTH": 1, "RTC_CENTER": [1, 2, 3]}, batch={"id": [7]}),
        "b.i3dm": instanced(glb(), 3, **rows),
        "c.cmpt": cmpt(b3dm(glb()), instanced(glb(), 3, **rows)),
        "s.subtree": subtree([True] * 5, [True, True, False, False, True], [False] * 16)[0],
        "0.0.0.glb": glb(),
        "1.0.0.glb": glb(),
        "1.1.1.glb": glb(),
    }


def test_a_valid_tileset_loads(tmp_path: Path) -> None:
    scene = nf.Scene.load(write(tmp_path, sound(tmp_path)))
    # The first tile of the implicit tiling is replaced by its children.
    assert scene.triangle_count == 12 * (1 + 3 + 4 + 1 + 2)
    assert not any("left out" in note for note in scene.report.notes)


@pytest.mark.slow
@given(seed=st.integers(0, 2**32 - 1))
@settings(max_examples=100)
def test_any_mutation_gives_a_scene_or_a_message(tmp_path_factory: pytest.TempPathFactory, seed: int) -> None:
    chance = random.Random(seed)
    folder = tmp_path_factory.getbasetemp() / "mutated"
    files = sound(folder)
    name = chance.choice(list(files))
    path = write(folder, files | {name: mutate.damaged(files[name], chance)})
    start = time.process_time()
    for how in ({}, {"triangles": 50}, {"on_invalid": "drop", "error": 1}):
        sentence = ""
        try:
            scene = nf.Scene.load(path, **how)
        except nf.SceneError as error:
            sentence = str(error)
        assert (sentence.startswith(f"{path}: ") and "\n" not in sentence) or np.isfinite(scene.bounds).all()
    assert time.process_time() - start < 3 * LONGEST


ABSURD = """
import nearfar as nf, sys
{peak}
before = peak()
for path in sys.argv[1:]:
    try:
        nf.Scene.load(path)
        raise SystemExit(path)
    except nf.SceneError as error:
        pass
print(peak() - before)
"""


@pytest.mark.slow
def test_bad_files_take_little_memory(tmp_path: Path) -> None:
    need("linux")
    root = tile(9.0, "{level}.b3dm", implicitTiling=QUAD | {"subtreeLevels": 16, "availableLevels": 64})
    files = {
        "t.json": tileset(root),
        "s.subtree": subtree(True, True, True)[0],
        "a.i3dm": instanced(glb(), 10**9, POSITION=np.zeros((1, 3), np.float32)),
        "b.b3dm": gzip.compress(b" " * (300 << 20), 1),
    }
    write(tmp_path, files)
    paths = [str(tmp_path / name) for name in ("t.json", "a.i3dm", "b.b3dm")]
    ran = subprocess.run(
        [sys.executable, "-c", ABSURD.format(peak=PEAK), *paths], capture_output=True, text=True, timeout=120
    )
    assert ran.returncode == 0, ran.stderr
    assert int(ran.stdout) < 1e9
