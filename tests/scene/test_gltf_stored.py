"""Meshes that the core reads as they lie in a file are those that are read array by array."""

from __future__ import annotations

import json
import struct
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, strategies as st
from numpy.typing import NDArray

import nearfar as nf
from nearfar import _core
from nearfar._base import data as data_files
from nearfar._base.errors import SceneError
from nearfar._scene import load
from nearfar._scene.budget import Budget
from nearfar._scene.gltf import document
from tests.support import need

FILES = (
    "objects/gltf/Duck.glb",
    "objects/gltf/FlightHelmet/FlightHelmet.gltf",
    "interior/garage/garage.gltf",
    "city/manhattan_deckgl/manhattan_core.glb",
    "city/tokyo23/tokyo_core_lod1.glb",
)


def both(path: Path, patch: pytest.MonkeyPatch, **how: Any) -> tuple[nf.Scene, nf.Scene]:
    """A scene whose meshes the core reads, and the same one read array by array."""
    stored = nf.Scene.load(path, **how)
    with patch.context() as within:
        within.setattr(load, "read_gltf", partial(document.read, stores=False))
        return stored, nf.Scene.load(path, **how)


def faces_of(scene: nf.Scene) -> NDArray[np.float64]:
    """Faces as rows (F, K) of all that their corners have, in a fixed order."""
    parts, mesh = _core.scene_parts(scene._core), _core.mesh_parts(scene._core.merged())
    faces, count = mesh["faces"], len(mesh["faces"])
    owners, materials = mesh["objects"], mesh["materials"]
    colors = np.asarray(parts["material_colors"])
    textures = np.asarray(parts["material_textures"])
    names = np.array([sorted(scene.object_names).index(name) for name in scene.object_names])
    columns = [scene.origin + mesh["positions"][faces].astype(np.float64), names[owners], colors[materials]]
    columns.append((textures >= 0)[materials])
    columns += [mesh[name][faces] for name in ("uvs", "colors", "normals") if mesh[name] is not None]
    rows = np.column_stack([np.asarray(column, np.float64).reshape(count, -1) for column in columns])
    return rows[np.lexsort(rows.T[::-1])]


def assert_alike(stored: nf.Scene, slow: nf.Scene) -> None:
    assert stored.object_names == slow.object_names
    np.testing.assert_array_equal(stored.origin, slow.origin)
    # Normals are made unit in float32 by one reader and in float64 by the other.
    np.testing.assert_allclose(faces_of(stored), faces_of(slow), rtol=0, atol=2.0**-22)
    assert (stored._frames is None) == (slow._frames is None)
    if stored._frames is not None:
        np.testing.assert_array_equal(stored._frames, slow._frames)


# files ---------------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("name", FILES)
def test_real_files_are_read_alike(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    need("data")
    path = data_files.find(name)
    assert path is not None
    stored, slow = both(path, monkeypatch)
    assert_alike(stored, slow)
    assert stored._notes == slow._notes
    assert stored.report.instances <= slow.report.instances
    content = load._read(str(path), path, path.read_bytes(), Budget())
    assert (content.shapes, content.stored is None) == ({}, False)


@pytest.mark.slow
def test_files_in_the_wild_are_read_alike(monkeypatch: pytest.MonkeyPatch) -> None:
    need("data")
    folder = data_files.find("wild")
    assert folder is not None
    scenes = 0
    for path in sorted(path for path in folder.rglob("*") if path.suffix in (".glb", ".gltf")):
        stored = loaded(path)
        with monkeypatch.context() as within:
            within.setattr(load, "read_gltf", partial(document.read, stores=False))
            slow = loaded(path)
        if isinstance(stored, nf.Scene) and isinstance(slow, nf.Scene):
            assert_alike(stored, slow)
            assert stored._notes == slow._notes
            scenes += 1
        else:
            assert stored == slow
    assert scenes > 30


def loaded(path: Path) -> nf.Scene | str:
    """The scene of a file, or why there is none."""
    try:
        return nf.Scene.load(path)
    except SceneError as error:
        return str(error)


# random files --------------------------------------------------------------------------------------------------------
CODES = {np.int8: 5120, np.uint8: 5121, np.int16: 5122, np.uint16: 5123, np.uint32: 5125, np.float32: 5126}
KINDS = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4"}


class Writer:
    """Collects arrays of random layouts in the buffer of a GLB."""

    def __init__(self, rng: np.random.Generator) -> None:
        self.rng, self.data = rng, b""
        self.accessors: list[dict[str, Any]] = []
        self.views: list[dict[str, Any]] = []

    def rows(self, kind: type, count: int, width: int, *, tight: bool = False) -> int:
        """Random rows with a gap after each, unless `tight`; returns the accessor's number."""
        is_float = kind is np.float32
        info = None if is_float else np.iinfo(kind)
        values = (
            self.rng.integers(-40, 40, (count, width)).astype(kind) / kind(8)
            if info is None
            else self.rng.integers(info.min, info.max, (count, width), kind, endpoint=True)
        )
        normalized = not is_float and (width != 3 or bool(self.rng.integers(2)))
        return self.add(np.asarray(values, kind), normalized=normalized, tight=tight)

    def add(self, values: NDArray[Any], *, normalized: bool = False, tight: bool = True) -> int:
        size = values.itemsize * values.shape[1]
        gap = 0 if tight else int(self.rng.integers(3)) * 4 + -size % 4
        self.data += bytes(-len(self.data) % 4)
        view: dict[str, Any] = {"buffer": 0, "byteOffset": len(self.data)}
        self.data += b"".join(row.tobytes() + bytes(gap) for row in values)
        view["byteLength"] = len(self.data) - view["byteOffset"]
        if gap:
            view["byteStride"] = size + gap
        self.views.append(view)
        accessor = {"bufferView": len(self.views) - 1, "componentType": CODES[values.dtype.type]}
        self.accessors.append(
            accessor | {"count": len(values), "type": KINDS[values.shape[1]], "normalized": normalized}
        )
        return len(self.accessors) - 1

    def glb(self, **document: Any) -> bytes:
        self.data += bytes(-len(self.data) % 4)
        whole = {"asset": {"version": "2.0"}, "accessors": self.accessors, "bufferViews": self.views, **document}
        text = json.dumps(whole | {"buffers": [{"byteLength": len(self.data)}]}).encode()
        text += b" " * (-len(text) % 4)
        chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(self.data), b"BIN\0")
        return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks) + len(self.data)) + chunks + self.data


def random_glb(rng: np.random.Generator) -> bytes:
    """Meshes of primitives that share vertices, placed some times each, of whatever types and attributes."""
    writer = Writer(rng)
    pools = [attributes(writer, 3 * int(rng.integers(1, 5))) for _ in range(2)]
    meshes = []
    for _ in range(int(rng.integers(1, 4))):
        chosen = [pools[int(rng.integers(2))] for _ in range(int(rng.integers(1, 4)))]
        meshes.append({"primitives": [primitive(writer, *pool) for pool in chosen]})
    nodes: list[dict[str, Any]] = []
    for number in range(int(rng.integers(1, 6))):
        scale = rng.choice([-2.0, 1.0, 1.0, 0.5], 3).tolist()
        place = {"translation": rng.integers(-9, 9, 3).tolist(), "scale": scale} if rng.integers(3) else {}
        nodes.append({"name": f"n{number}", "mesh": int(rng.integers(len(meshes))), **place})
    materials = [{"pbrMetallicRoughness": {"baseColorFactor": [n / 4, 0.5, 1.0, 1.0]}} for n in range(3)]
    return writer.glb(meshes=meshes, nodes=nodes, materials=materials, scenes=[{"nodes": list(range(len(nodes)))}])


def attributes(writer: Writer, count: int) -> tuple[dict[str, int], int]:
    rng = writer.rng
    kinds = (np.float32, np.float32, np.int16, np.uint8)
    found = {"POSITION": writer.rows(kinds[int(rng.integers(4))], count, 3)}
    if rng.integers(2):
        found["NORMAL"] = writer.rows((np.float32, np.int8)[int(rng.integers(2))], count, 3)
    if rng.integers(2):
        kind = (np.uint8, np.uint16, np.float32)[int(rng.integers(3))]
        found["COLOR_0"] = writer.rows(kind, count, int(rng.integers(3, 5)))
    return found, count


def primitive(writer: Writer, found: dict[str, int], count: int) -> dict[str, Any]:
    rng = writer.rng
    made: dict[str, Any] = {"attributes": found, "mode": 4} if rng.integers(2) else {"attributes": dict(found)}
    if rng.integers(4):
        first = int(rng.integers(count))
        corners = rng.integers(first, count, (3 * int(rng.integers(1, 4)), 1))
        made["indices"] = writer.add(corners.astype((np.uint8, np.uint16, np.uint32)[int(rng.integers(3))]))
    if rng.integers(3):
        made["material"] = int(rng.integers(3))
    return made


@given(seed=st.integers(0, 2**32 - 1), scale=st.sampled_from([None, 0.01]))
def test_random_files_are_read_alike(tmp_path_factory: pytest.TempPathFactory, seed: int, scale: float | None) -> None:
    path = tmp_path_factory.mktemp("random") / "random.glb"
    path.write_bytes(random_glb(np.random.default_rng(seed)))
    with pytest.MonkeyPatch.context() as patch:
        stored, slow = both(path, patch, scale=scale)
    assert_alike(stored, slow)
