"""Meshes that the core reads from a file as stored equal those read array by array."""

from __future__ import annotations

import base64
import json
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
from nearfar._scene.gltf.buffers import Buffers
from tests.support import need
from tests.support.gltf_writer import Writer, random_glb

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
    """Faces as rows (F, K) of all corner attributes, in a fixed order."""
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
    # One reader rounds scaled coordinates once, and normalises each normal by itself.
    np.testing.assert_allclose(faces_of(stored), faces_of(slow), rtol=2.0**-22, atol=2.0**-22)
    assert (stored._frames is None) == (slow._frames is None)
    if stored._frames is not None:
        np.testing.assert_array_equal(stored._frames, slow._frames)


# files ---------------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("name", [*FILES[:-1], pytest.param(FILES[-1], marks=pytest.mark.stress)])
def test_real_files_are_read_equally(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    need("data")
    path = data_files.find(name)
    assert path is not None
    stored, slow = both(path, monkeypatch)
    assert_alike(stored, slow)
    assert stored._notes == slow._notes
    assert stored.report.instances <= slow.report.instances
    content = load._read(path, path.read_bytes(), nf.LoadOptions(), Budget())
    assert (content.shapes, content.stored is None) == ({}, False)


@pytest.mark.slow
def test_files_in_the_wild_are_read_equally(monkeypatch: pytest.MonkeyPatch) -> None:
    need("data")
    folder = data_files.find("wild")
    assert folder is not None
    scenes = 0
    for path in sorted(path for path in folder.rglob("*") if path.suffix in (".glb", ".gltf")):
        stored = load_or_message(path)
        with monkeypatch.context() as within:
            within.setattr(load, "read_gltf", partial(document.read, stores=False))
            slow = load_or_message(path)
        if isinstance(stored, nf.Scene) and isinstance(slow, nf.Scene):
            assert_alike(stored, slow)
            assert stored._notes == slow._notes
            scenes += 1
        else:
            assert stored == slow
    assert scenes > 30


def load_or_message(path: Path) -> nf.Scene | str:
    """The scene of a file, or the error message."""
    try:
        return nf.Scene.load(path)
    except SceneError as error:
        return str(error)


# files that are odd ---------------------------------------------------------------------------------------------------
SQUARE = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], np.float32)
HALVES = np.array([[0], [1], [2], [0], [2], [3]], np.uint16)


def square(primitive: dict[str, Any] | None = None, **document: Any) -> bytes:
    """A GLB with a square; accessor 0 has its corners, and 1 the indices of its two triangles."""
    writer = Writer(np.random.default_rng(0))
    writer.add(SQUARE)
    writer.add(HALVES)
    whole = {"attributes": {"POSITION": 0}, "indices": 1} | (primitive or {})
    parts = {"meshes": [{"primitives": [whole]}], "nodes": [{"mesh": 0}], "scenes": [{"nodes": [0]}]}
    return writer.glb(**parts | document)


def test_attributes_without_a_row_for_each_vertex_are_noted(tmp_path: Path) -> None:
    """The six vertices of two primitives: the second uses three of them, as many as the normals have rows."""
    writer = Writer(np.random.default_rng(0))
    positions = writer.add(np.eye(3, dtype=np.float32)[[0, 1, 2, 0, 2, 1]] + np.float32(1))
    rows = {name: writer.add(np.full((3, width), 0.5, np.float32)) for name, width in (("V", 3), ("C", 4), ("T", 2))}
    corners = writer.add(np.array([[3], [4], [5]], np.uint16))
    material = {"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "metallicFactor": 0}, "doubleSided": True}
    attributes = {"POSITION": positions, "NORMAL": rows["V"], "COLOR_0": rows["C"], "TEXCOORD_0": rows["T"]}
    plain = {"POSITION": positions, "TEXCOORD_0": rows["T"]}
    primitives = [{"attributes": plain}, {"attributes": attributes, "indices": corners, "material": 0}]
    document: dict[str, Any] = {"nodes": [{"mesh": 0}], "scenes": [{"nodes": [0]}], "materials": [material]}
    mesh = {"name": "tri", "primitives": primitives}
    (tmp_path / "a.glb").write_bytes(writer.glb(meshes=[mesh], textures=[{}], **document))
    scene = nf.Scene.load(tmp_path / "a.glb")
    listed = ", ".join(f"{name} of mesh 'tri_1' (3 for 6)" for name in ("NORMAL", "TEXCOORD_0", "COLOR_0"))
    assert f"3 attributes without a row for each vertex ignored: {listed}" in scene.report.notes
    parts = nf._core.mesh_parts(scene._core.merged())
    assert parts["normals"] is None
    assert parts["colors"] is None
    assert scene.triangle_count == 3


def test_unneeded_arrays_may_be_missing(tmp_path: Path) -> None:
    header = json.loads(square()[20 : 20 + int.from_bytes(square()[12:16], "little")])
    binary = square()[28 + int.from_bytes(square()[12:16], "little") :]
    (tmp_path / "a.bin").write_bytes(binary)
    header["buffers"] = [{"uri": "a.bin", "byteLength": len(binary)}, {"uri": "missing.bin", "byteLength": 64}]
    header["bufferViews"].append({"buffer": 1, "byteLength": 64})
    header["accessors"].append({"bufferView": 2, "componentType": 5126, "count": 4, "type": "VEC4"})
    header["accessors"].append({"type": ["junk"]})
    header["meshes"][0]["primitives"][0]["attributes"]["TANGENT"] = 2
    (tmp_path / "a.gltf").write_text(json.dumps(header))
    assert nf.Scene.load(tmp_path / "a.gltf").triangle_count == 2


def test_a_document_without_meshes_has_no_triangles(tmp_path: Path) -> None:
    (tmp_path / "a.glb").write_bytes(square(meshes=[], nodes=[], scenes=[{"nodes": []}], animations=[{}]))
    with pytest.raises(SceneError, match="no triangles; 1 animation ignored"):
        nf.Scene.load(tmp_path / "a.glb")
    data = Writer(np.random.default_rng(0))
    data.add(SQUARE)
    (tmp_path / "b.glb").write_bytes(data.glb(animations=[{}]))
    with pytest.raises(SceneError, match="no triangles; 1 animation ignored"):
        nf.Scene.load(tmp_path / "b.glb")


def test_materials_of_unplaced_meshes_are_omitted(tmp_path: Path) -> None:
    materials = [{"pbrMetallicRoughness": {"baseColorFactor": [n / 9, 0.5, 1.0, 1.0]}} for n in range(9)]
    rows = [{"attributes": {"POSITION": 0}, "indices": 1, "material": n} for n in range(9)]
    meshes = [{"primitives": [row]} for row in rows]
    (tmp_path / "a.glb").write_bytes(square(meshes=meshes, nodes=[{"mesh": 4}], materials=materials))
    assert nf.Scene.load(tmp_path / "a.glb").report.materials == 1


def test_sizes_are_counted_before_meshes_are_examined(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    writer = Writer(np.random.default_rng(0))
    writer.add(np.zeros((50_000, 3), np.float32))
    writer.accessors *= 1000
    rows = [{"attributes": {"POSITION": number}} for number in range(1000)]
    for row in rows:
        writer.accessors[row["attributes"]["POSITION"]]["count"] = 49_998
    meshes = [{"primitives": [row]} for row in rows]
    path = tmp_path / "a.glb"
    path.write_bytes(writer.glb(meshes=meshes, nodes=[{"mesh": 0}], scenes=[{"nodes": [0]}]))
    monkeypatch.setattr(_core, "StoredMeshes", None)
    with pytest.raises(SceneError, match="it unpacks to more than"):
        nf.Scene.load(path)


def test_unfit_meshes_are_dropped_in_one_pass(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each mesh shares its positions with the next one, and the first one is damaged."""
    count = 60
    writer = Writer(np.random.default_rng(0))
    for _ in range(count + 1):
        writer.add(np.random.default_rng(1).random((99, 3), np.float32))
    corners = [writer.add(np.array([[0], [1], [2]], np.uint16)), writer.add(np.array([[0], [1], [500]], np.uint16))]
    rows = [
        [{"attributes": {"POSITION": at}, "indices": corners[at == 0 == n]} for n, at in enumerate((first, first + 1))]
        for first in range(count)
    ]
    nodes = [{"mesh": number} for number in range(count)]
    document = {
        "meshes": [{"primitives": row} for row in rows],
        "nodes": nodes,
        "scenes": [{"nodes": list(range(count))}],
    }
    path = tmp_path / "a.glb"
    path.write_bytes(writer.glb(**document))
    made: list[Any] = []
    original = _core.StoredMeshes

    def record_result(*given: Any) -> Any:
        made.append(original(*given))
        return made[-1]

    monkeypatch.setattr(_core, "StoredMeshes", record_result)
    scene = nf.Scene.load(path, on_invalid="drop")
    assert (len(made), scene.triangle_count, scene.report.dropped_faces) == (1, 2 * count - 1, 1)


def test_textures_of_one_image_share_its_bytes() -> None:
    uri = "data:image/png;base64," + base64.b64encode(b"picture").decode()
    header = {"images": [{"uri": uri}], "textures": [{"source": 0}, {"source": 0}, {}]}
    buffers = Buffers(header, b"", None, Budget())
    assert (buffers.picture(0), buffers.picture(2), buffers.picture(7)) == (b"picture", None, None)
    assert buffers.picture(0) is buffers.picture(1)


# random files --------------------------------------------------------------------------------------------------------
# With scales other than powers of two, equal coordinates may be rounded differently, and faces be sorted differently.
@given(seed=st.integers(0, 2**32 - 1), scale=st.sampled_from([None, 2.0**-7]))
def test_random_files_are_read_equally(
    tmp_path_factory: pytest.TempPathFactory, seed: int, scale: float | None
) -> None:
    path = tmp_path_factory.mktemp("random") / "random.glb"
    path.write_bytes(random_glb(np.random.default_rng(seed)))
    with pytest.MonkeyPatch.context() as patch:
        stored, slow = both(path, patch, scale=scale)
    assert_alike(stored, slow)
