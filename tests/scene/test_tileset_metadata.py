"""Bounding boxes of implicit tiles in metadata: they replace the parts of the tiling's volume."""

from __future__ import annotations

import json
import struct
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, strategies as st

import nearfar as nf
from nearfar._scene.tileset.subtree import Bits
from nearfar._scene.tileset.tileset import Tileset
from tests.support.tile_cases import b3dm, bits, box, glb, refusal, tile, tileset, write

TILING = {
    "subdivisionScheme": "QUADTREE",
    "subtreeLevels": 2,
    "availableLevels": 2,
    "subtrees": {"uri": "{level}.subtree"},
}
BOXES = [((-5, -5, -5), (30, 30, 30)), ((0, 0, 0), (9, 1, 1)), ((20, 20, 20), (21, 21, 21))]
"""Boxes of the root, of its first child and of its last one; z up."""


def schema(component: str = "FLOAT64", **changes: Any) -> dict[str, Any]:
    stated = {"type": "SCALAR", "componentType": component, "array": True, "count": 12, "semantic": "TILE_BOUNDING_BOX"}
    other = {"type": "SCALAR", "componentType": "UINT8"}
    return {"id": "s", "classes": {"kind": {"properties": {"n": other, "b": stated | changes}}}}


def write_tileset(
    folder: Path, *, rows: Any = None, component: str = "FLOAT64", count: int = 3, **changes: Any
) -> Path:
    """A tileset whose root has the tile's box of 16 m, and whose children's boxes lie elsewhere."""
    numbers = np.array([box(*pair)["box"] for pair in BOXES]) if rows is None else rows
    data = np.asarray(numbers, "<f4" if component == "FLOAT32" else "<f8").tobytes()
    flags = bits([True, True, False, False, True])
    document = {
        "tileAvailability": {"bitstream": 0, "availableCount": 3},
        "contentAvailability": [{"bitstream": 0}],
        "childSubtreeAvailability": {"constant": 0},
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": 1},
            {"buffer": 0, "byteOffset": 8, "byteLength": len(data)},
        ],
        "buffers": [{"byteLength": 8 + len(data)}],
        "tileMetadata": 0,
        "propertyTables": [{"class": "kind", "count": count, "properties": {"n": {"values": 0}, "b": {"values": 1}}}],
    }
    text = json.dumps(document | changes).encode()
    text += b" " * (-len(text) % 8)
    subtree = struct.pack("<4sIQQ", b"subt", 1, len(text), 8 + len(data)) + text + flags + data
    root = tile(8.0, "{level}.{x}.{y}.b3dm", box((0, 0, 0), (16, 16, 16)), refine="ADD", implicitTiling=TILING)
    contents = {f"{name}.b3dm": b3dm(glb()) for name in ("0.0.0", "1.0.0", "1.1.1")}
    files = {"t.json": tileset(root, schema=schema(component)), "0.subtree": subtree}
    return write(folder, files | contents)


@pytest.mark.parametrize("component", ["FLOAT32", "FLOAT64"])
def test_boxes_decide_which_tiles_touch(component: str, tmp_path: Path) -> None:
    opened = Tileset.open(write_tileset(tmp_path, component=component))

    def touched(low: Any, high: Any) -> set[str]:
        """Tiles that touch a box, z up; the scene's z is −y of tiles."""
        part = np.array([[low[0], low[2], -high[1]], [high[0], high[2], -low[1]]], float)
        return {name.split("#")[0].removesuffix(".b3dm") for name in opened.read(box=part).nodes.objects}

    # The volume's parts would be the 8 m cubes at (0, 0, 0) and up to (16, 16, 16).
    assert touched((8.5, 0.5, 0.5), (9, 1, 1)) == {"0.0.0", "1.0.0"}
    assert touched((9.5, 0, 0), (15, 15, 15)) == {"0.0.0"}
    assert touched((2, 2, 2), (15, 15, 15)) == {"0.0.0"}
    assert touched((0, 0, 0), (20, 20, 20)) == {"0.0.0", "1.0.0", "1.1.1"}


def test_metadata_of_other_classes_is_ignored(tmp_path: Path) -> None:
    table = [{"class": "other", "count": 1, "properties": {}}]
    assert nf.Scene.load(write_tileset(tmp_path, propertyTables=table)).triangle_count == 3 * 12
    assert nf.Scene.load(write_tileset(tmp_path, tileMetadata=None)).triangle_count == 3 * 12


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"count": 4}, "propertyTables[0].count: expected 3, the number of available tiles, got 4"),
        ({"rows": np.zeros((2, 12))}, "expected 12 numbers for each of 3 tiles, got 192 bytes"),
        ({"rows": np.full((3, 12), np.nan)}, "expected finite numbers"),
        ({"tileMetadata": 1}, "tileMetadata: expected a whole number from 0 to 0"),
        ({"tileMetadata": 0, "propertyTables": {}}, "propertyTables: expected a list"),
        ({"propertyTables": [{"class": "kind", "count": 3}]}, "propertyTables[0].properties: expected an object"),
        (
            {"propertyTables": [{"class": "kind", "count": 3, "properties": {"b": {"values": 7}}}]},
            "expected the index of one of 2, got 7",
        ),
    ],
)
def test_damaged_metadata_is_refused(changes: dict[str, Any], words: str, tmp_path: Path) -> None:
    assert words in refusal(write_tileset(tmp_path, **changes))


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"componentType": "INT8"}, "properties.'b'.componentType: expected FLOAT32 or FLOAT64"),
        ({"count": 6}, "properties.'b'.count: expected a whole number from 12 to 12, got int 6"),
    ],
)
def test_boxes_of_another_type_are_refused(changes: dict[str, Any], words: str, tmp_path: Path) -> None:
    path = write_tileset(tmp_path)
    document = json.loads(path.read_text())
    path.write_text(json.dumps(document | {"schema": schema(**changes)}))
    assert words in refusal(path)


@given(st.lists(st.booleans(), min_size=1, max_size=100))
def test_bits_are_decoded_and_counted(values: list[bool]) -> None:
    stored = Bits(len(values), bits(values))
    assert [stored.bit(n) for n in range(len(values))] == stored.unpack().tolist() == values
    assert [stored.rank(n) for n in range(len(values) + 1)] == [sum(values[:n]) for n in range(len(values) + 1)]
    assert [Bits(9, None, constant).rank(5) for constant in (False, True)] == [0, 5]
