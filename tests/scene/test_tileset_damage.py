"""Tests of damaged tilesets and tiles: an error that names file and place, in short time."""

from __future__ import annotations

import json
import struct
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from tests.support.tile_cases import QUAD, b3dm, cmpt, glb, i3dm, instanced, refusal, subtree, tile, tileset, write

CUBE = b3dm(glb())


def damage(data: bytes, at: int, value: int) -> bytes:
    return data[:at] + struct.pack("<I", value) + data[at + 4 :]


INSTANCES = instanced(glb(), 3, POSITION=np.zeros((3, 3), np.float32))


@pytest.mark.parametrize(
    ("name", "data", "words"),
    [
        ("a.b3dm", b"", "it is empty"),
        ("a.b3dm", b"b3dm\1\0", "it ends within its header"),
        ("a.b3dm", b"b3xm" + CUBE[4:], "it begins with b'b3xm'"),
        ("a.b3dm", damage(CUBE, 4, 2), "it is b3dm of version 2"),
        ("a.b3dm", damage(CUBE, 8, len(CUBE) + 1), f"states {len(CUBE) + 1:,} bytes, and it has {len(CUBE):,}"),
        ("a.b3dm", damage(CUBE, 8, 0), "its header states 0 bytes"),
        ("a.b3dm", CUBE[:-1], f"states {len(CUBE):,} bytes"),
        ("a.b3dm", damage(CUBE, 8, 20), "it ends within its header of 28 bytes"),
        ("a.b3dm", damage(CUBE, 12, 0xFFFFFFFF), "its header states tables of 4,294,967,295"),
        ("a.b3dm", damage(CUBE, 24, 0x7FFFFFFF), "2,147,483,647 bytes, and"),
        ("a.b3dm", damage(CUBE, 12, 4), "it cannot be read"),
        ("a.b3dm", b3dm(glb(), {"BATCH_LENGTH": 10**30}), "feature table, BATCH_LENGTH: expected a whole number"),
        ("a.b3dm", b3dm(glb(), {"BATCH_LENGTH": -1}), "feature table, BATCH_LENGTH: expected a whole number"),
        ("a.b3dm", b3dm(glb(), {"BATCH_LENGTH": {"byteOffset": 9}}), "feature table, BATCH_LENGTH.byteOffset"),
        (
            "a.b3dm",
            b3dm(glb(), {"RTC_CENTER": [1, 2]}),
            "feature table, RTC_CENTER: expected 3 numbers, got a list of 2",
        ),
        ("a.b3dm", b3dm(glb(), {"RTC_CENTER": [1e31, 0, 0]}), "RTC_CENTER: expected numbers within ±1e10, got 1e+31"),
        ("a.b3dm", b3dm(glb(), []), "its JSON is not an object"),
        ("a.b3dm", b3dm(b""), "it cannot be read"),
        ("a.b3dm", b3dm(glb(np.eye(3) * 1e31, [[0, 1, 2]])), "mesh 'mesh' has coordinates beyond 1e10"),
        ("a.i3dm", i3dm(glb(), {}), "feature table, INSTANCES_LENGTH: expected a whole number"),
        (
            "a.i3dm",
            instanced(glb(), 10**9, POSITION=np.zeros((1, 3), np.float32)),
            "1,000,000,000 rows take 12,000,000,000",
        ),
        ("a.i3dm", instanced(glb(), 2, POSITION=[0, 0, 0]), "expected 6 numbers, got 3"),
        (
            "a.i3dm",
            instanced(glb(), 1, POSITION=np.full((1, 3), 1e31, np.float32)),
            "POSITION: expected coordinates within",
        ),
        (
            "a.i3dm",
            instanced(glb(), 1, POSITION=np.full((1, 3), np.nan, np.float32)),
            "POSITION: expected coordinates within",
        ),
        (
            "a.i3dm",
            instanced(glb(), 1, POSITION=[0, 0, 0], SCALE=np.full(1, np.inf, np.float32)),
            "SCALE: expected factors",
        ),
        (
            "a.i3dm",
            instanced(glb(), 1, POSITION=[0, 0, 0], NORMAL_UP=[0, 0, 0], NORMAL_RIGHT=[1, 0, 0]),
            "axes of instance 0",
        ),
        (
            "a.i3dm",
            instanced(glb(), 1, POSITION_QUANTIZED=np.zeros((1, 3), np.uint16)),
            "QUANTIZED_VOLUME_OFFSET: expected 3",
        ),
        ("a.i3dm", damage(INSTANCES, 28, 7), "it states the format 7 of its model"),
        ("a.i3dm", instanced(b"missing.glb", 1, embedded=False, POSITION=[0, 0, 0]), "missing.glb"),
        ("a.i3dm", INSTANCES[:40], "bytes"),
        ("a.cmpt", damage(cmpt(CUBE), 12, 10**9), "it states 1,000,000,000 tiles, and ends after 1"),
        ("a.cmpt", cmpt(CUBE[:-9]), f"states {len(CUBE):,} bytes"),
        ("a.cmpt", cmpt()[:14] + bytes(2), "no triangles"),
    ],
)
def test_damaged_tiles(tmp_path: Path, name: str, data: bytes, words: str) -> None:
    assert words in refusal(write(tmp_path, {name: data}))
    if data:
        path = write(tmp_path, {"t.json": tileset(tile(0.0, name))})
        assert words in refusal(path)


def test_composites_within_each_other(tmp_path: Path) -> None:
    data = CUBE
    for _ in range(5000):
        data = cmpt(data)
    assert refusal(write(tmp_path, {"a.cmpt": data})) == "its parts are nested too deeply"


@pytest.mark.parametrize(
    ("root", "words"),
    [
        (None, "root: expected an object, got nothing"),
        ([], "root: expected an object, got list []"),
        ({}, "root.boundingVolume: expected an object, got nothing"),
        (tile(0.0, volume={}), "root.boundingVolume: expected a box, a region or a sphere, got nothing"),
        (tile(0.0, volume={"extensions": {"3DTILES_bounding_volume_S2": {}}}), "got 3DTILES_bounding_volume_S2"),
        (tile(0.0, volume={"box": [0] * 11}), "root.boundingVolume.box: expected 12 numbers, got a list of 11"),
        (tile(0.0, volume={"box": [0] * 11 + ["x"]}), "root.boundingVolume.box: expected 12 numbers"),
        (tile(0.0, volume={"box": [10**400] * 12}), "root.boundingVolume.box: expected numbers within ±1e10"),
        (tile(0.0, volume={"sphere": [0, 0, 0, -1]}), "root.boundingVolume.sphere: expected a radius"),
        (tile(0.0, volume={"region": [0, 1, 0, -1, 0, 0]}), "root.boundingVolume.region: expected west, south"),
        (tile(0.0, volume={"region": [0, 0, 1e31, 1, 0, 0]}), "root.boundingVolume.region: expected numbers within"),
        (tile(-1.0), "root.geometricError: expected a number of at least 0, got float -1.0"),
        (tile(0.0, refine="NEITHER"), "root.refine: expected ADD or REPLACE, got str 'NEITHER'"),
        (tile(0.0, children={}), "root.children: expected a list, got dict {}"),
        (tile(0.0, children=[{}]), "root.children[0].boundingVolume: expected an object, got nothing"),
        (tile(0.0, children=[tile(0, children=[3])]), "root.children[0].children[0]: expected an object, got int 3"),
        (tile(0.0, content=None, contents=[7]), "root.content: expected an object, got int 7"),
        (tile(0.0, contents=[{}]), "root.content.uri: expected a text, got nothing"),
        (tile(0.0, "a\0b"), "which names no file"),
        (tile(0.0, transform=[1] * 15), "root.transform: expected 16 numbers, got a list of 15"),
        (tile(0.0, transform=[1e31] * 16), "root.transform: expected numbers within ±1e10, got 1e+31"),
        (tile(0.0, transform=list(range(16))), "root.transform: expected an affine transform, got the last row"),
        (tile(0.0, "a", implicitTiling=[]), "implicitTiling: expected an object"),
        (
            tile(0.0, "a", implicitTiling=QUAD | {"subdivisionScheme": "KD"}),
            "expected QUADTREE or OCTREE, got str 'KD'",
        ),
        (
            tile(0.0, "a", implicitTiling=QUAD | {"subtreeLevels": 10**9}),
            "subtreeLevels: expected a whole number from 1 to 16",
        ),
        (
            tile(0.0, "a", implicitTiling=QUAD | {"availableLevels": 10**9}),
            "availableLevels: expected a whole number from 1",
        ),
        (
            tile(0.0, "a", implicitTiling=QUAD | {"availableLevels": 0}),
            "availableLevels: expected a whole number from 1",
        ),
        (tile(0.0, "a", implicitTiling=QUAD | {"subtrees": {}}), "root.implicitTiling.subtrees.uri: expected a text"),
        (
            tile(0.0, "a", {"sphere": [0, 0, 0, 1]}, implicitTiling=QUAD),
            "a box or a region, which can be divided, got a sphere",
        ),
        (tile(0.0), "no triangles"),
        (tile(0.0, "nowhere.b3dm"), "no triangles"),
    ],
)
def test_damaged_documents(tmp_path: Path, root: Any, words: str) -> None:
    assert words in refusal(write(tmp_path, {"t.json": tileset(root)}))
    # The same document, referred to by another one.
    if root is not None and "triangles" not in words:
        files = {"u.json": tileset(tile(0.0, "sub/t.json")), "sub/t.json": tileset(root)}
        assert f"sub/t.json: {words.split(':')[0]}" in refusal(write(tmp_path, files)) or words in refusal(
            tmp_path / "u.json"
        )


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"asset": 1}, "asset: expected an object"),
        ({"asset": {}}, "it is 3D Tiles None"),
        ({"asset": {"version": "2.0"}}, "it is 3D Tiles '2.0', and only 1.0 and 1.1 are read"),
        ({"asset": {"version": "1.0", "gltfUpAxis": "W"}}, "asset.gltfUpAxis: expected X or Y or Z"),
        ({"extensionsRequired": ["VENDOR_secret"]}, "it needs the extension 'VENDOR_secret', which is not read"),
        ({"extensionsRequired": 5}, "extensionsRequired: expected a list, got int 5"),
    ],
)
def test_unsupported_documents_are_refused(tmp_path: Path, changes: dict[str, Any], words: str) -> None:
    path = write(tmp_path, {"t.json": tileset(tile(0.0, "a.b3dm"), **changes), "a.b3dm": CUBE})
    assert refusal(path).startswith(words)


def wrong_subtree(**changes: Any) -> bytes:
    """A JSON subtree of two levels with external bits, and changed entries."""
    data, _ = subtree([True] * 5, [True] * 5, [False] * 16, binary=False)
    return json.dumps(json.loads(data) | changes).encode()


@pytest.mark.parametrize(
    ("data", "stored", "words"),
    [
        (b"subt", b"", "it ends within its header"),
        (struct.pack("<4sIQQ", b"subt", 2, 0, 0), b"", "it is a subtree of version 2"),
        (struct.pack("<4sIQQ", b"subt", 1, 1 << 60, 0), b"", "it states"),
        (subtree([True] * 5, True, False)[0][:-8], b"", "it states"),
        (b"[]", b"", "its JSON is not an object"),
        (wrong_subtree(), b"", "bufferViews[0].byteLength"),
        (
            wrong_subtree(tileAvailability={"constant": 2}),
            bytes(24),
            "tileAvailability.constant: expected a whole number from 0 to 1",
        ),
        (
            wrong_subtree(tileAvailability={"bitstream": 9}),
            bytes(24),
            "tileAvailability.bitstream: expected the index of one of 3",
        ),
        (wrong_subtree(tileAvailability={}), bytes(24), "tileAvailability.bitstream"),
        (wrong_subtree(tileAvailability=None), bytes(24), "tileAvailability: expected an object, got nothing"),
        (wrong_subtree(), bytes(24), "tileAvailability: availableCount is 5, but 0 bits are set"),
        (
            wrong_subtree(bufferViews=[{"buffer": 0, "byteLength": 0}] * 3),
            bytes(24),
            "tileAvailability: expected 5 bits, got 0",
        ),
        (
            wrong_subtree(bufferViews=[{"buffer": 7, "byteLength": 1}] * 3),
            bytes(24),
            "bufferViews[0].buffer: expected the index",
        ),
        (wrong_subtree(buffers=[{"uri": "../x"}]), bytes(24), "which lies outside its folder"),
        (
            subtree([False, True, False, False, False], False, False)[0],
            b"",
            "tile 0 of its level 1 as available, but not its parent",
        ),
        (
            subtree([True, False, True, True, True], [True] * 5, False)[0],
            b"",
            "the content of tile 1 as available, but not the tile",
        ),
        (
            subtree([True] * 4 + [False], False, [True] * 16)[0],
            b"",
            "subtree 12 as available, but not the tile above it",
        ),
    ],
)
def test_damaged_subtrees(tmp_path: Path, data: bytes, stored: bytes, words: str) -> None:
    root = tile(9.0, "a.b3dm", implicitTiling=QUAD)
    path = write(tmp_path / "in", {"t.json": tileset(root), "s.subtree": data, "bits.bin": stored, "a.b3dm": CUBE})
    reason = refusal(path)
    assert reason.startswith("s.subtree: ")
    assert words in reason


def test_missing_subtrees_are_named(tmp_path: Path) -> None:
    root = tile(9.0, "a.b3dm", children=[tile(1.0, "{level}.b3dm", implicitTiling=QUAD)])
    scene = nf.Scene.load(write(tmp_path, {"t.json": tileset(root), "a.b3dm": CUBE}))
    assert "1 file of tiles left out: s.subtree is missing" in scene.report.notes
