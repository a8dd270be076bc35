"""Vertex normals from arrays, trimesh and files, and saved scenes that keep them."""

from __future__ import annotations

import io
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh

import nearfar as nf
from nearfar import _core
from nearfar._base.glb import Reader
from nearfar._scene import glb, load
from nearfar._scene.budget import Budget
from nearfar._scene.builder import SceneBuilder
from nearfar._scene.content import Shape
from nearfar._scene.names import Names
from tests.support import data
from tests.support.normal_cases import TURN, ball, camera, colors, scene_of


def parts_of(scene: nf.Scene) -> list[dict[str, Any]]:
    return [_core.mesh_parts(mesh) for mesh in _core.scene_parts(scene._core)["meshes"]]


def test_unit_normals_are_borrowed_and_others_normalised() -> None:
    vertices, faces = ball()
    builder = SceneBuilder()
    unit, kept = vertices.copy(), vertices.copy()
    builder.mesh(vertices.copy(), faces.copy(), normals=unit)
    builder.mesh(vertices.copy(), faces.copy(), normals=kept, copy=True)
    assert not unit.flags.writeable
    assert kept.flags.writeable
    long = vertices.astype(np.float64) * np.geomspace(1e-200, 1e200, len(vertices))[:, None]
    long[3] = 0
    (parts,) = parts_of(scene_of(vertices, faces, long))
    expected = np.where(np.arange(len(vertices))[:, None] == 3, 0, vertices)
    np.testing.assert_allclose(parts["normals"], expected, atol=1e-7)
    (flat,) = parts_of(scene_of(vertices, faces, None))
    assert flat["normals"] is None


def test_kernels_refuse_normals_of_other_vertices() -> None:
    vertices, faces = ball()
    with pytest.raises(ValueError, match="normals: expected one row for each of 42 vertices, got 41"):
        _core.Mesh(vertices, faces, normals=vertices[1:].copy(), objects=0, materials=-1)


def hard() -> trimesh.Trimesh:
    """A mesh with normals that cannot be computed from its faces."""
    vertices, faces = ball(2)
    rows = vertices + np.random.default_rng(3).normal(scale=0.3, size=vertices.shape)
    rows /= np.linalg.norm(rows, axis=1, keepdims=True)
    return trimesh.Trimesh(vertices, faces, vertex_normals=rows, process=False)


def shape_of(path: Path) -> Shape:
    return next(iter(load._read(path, path.read_bytes(), nf.LoadOptions(), Budget()).shapes.values()))


@pytest.mark.parametrize("suffix", ["glb", "obj", "ply"])
def test_normals_of_files_are_kept(tmp_path: Path, suffix: str) -> None:
    mesh, path = hard(), tmp_path / f"ball.{suffix}"
    mesh.export(path)
    (parts,) = parts_of(nf.Scene.load(path))
    order = trimesh.proximity.ProximityQuery(mesh).vertex(parts["positions"])[1]
    # OBJ has eight digits, PLY and GLB float32.
    np.testing.assert_allclose(parts["normals"], mesh.vertex_normals[order], atol=1e-6)
    assert nf.Scene.load(path).report.notes == ()
    plain = trimesh.Trimesh(mesh.vertices, mesh.faces, process=False)
    plain.export(path, **({"include_normals": False} if suffix == "obj" else {}))
    (parts,) = parts_of(nf.Scene.load(path))
    assert parts["normals"] is None


def test_corners_of_an_obj_have_separate_normals_and_coordinates(tmp_path: Path) -> None:
    """A box of eight vertices and six normals: each vertex has three."""
    box = trimesh.creation.box()
    sides, side = np.unique(np.rint(box.face_normals), axis=0, return_inverse=True)
    lines = [f"v {x} {y} {z}" for x, y, z in box.vertices] + [f"vn {x} {y} {z}" for x, y, z in sides]
    lines += [f"vt {k / 8} {1 - k / 8}" for k in range(len(sides))]
    faces = zip(box.faces + 1, side + 1, strict=True)
    lines += ["f " + " ".join(f"{v}/{k}/{k}" for v in face) for face, k in faces]
    (tmp_path / "box.obj").write_text("\n".join(["o box", *lines]))
    scene = nf.Scene.load(tmp_path / "box.obj")
    np.testing.assert_allclose(scene.triangles(), box.triangles, atol=1e-6)
    flat = nf.Scene.from_trimesh(box)
    np.testing.assert_allclose(colors(scene), colors(flat), atol=1e-6)
    (parts,) = parts_of(scene)
    np.testing.assert_allclose(parts["normals"][parts["faces"]], np.repeat(box.face_normals[:, None], 3, 1), atol=1e-6)


def test_nan_normals_count_as_missing(tmp_path: Path) -> None:
    lines = ["v 0 0 0", "v 1 0 0", "v 0 1 0", "vn nan 0 1", "vn 0 0 1", "f 1//1 2//2 3//2"]
    (tmp_path / "a.obj").write_text("\n".join(lines))
    (parts,) = parts_of(nf.Scene.load(tmp_path / "a.obj"))
    np.testing.assert_array_equal(parts["normals"][parts["faces"][0]], [[0, 0, 0], [0, 0, 1], [0, 0, 1]])


def test_normals_computed_by_trimesh_are_ignored() -> None:
    box = trimesh.creation.box()
    for _ in range(2):
        (parts,) = parts_of(nf.Scene.from_trimesh(box))
        assert parts["normals"] is None
        assert box.vertex_normals.shape == (8, 3)  # Now it is stored where given normals are.
    turned = box.copy()
    assert turned.vertex_normals.shape == (8, 3)
    turned.apply_transform(TURN)
    (parts,) = parts_of(nf.Scene.from_trimesh(turned))
    assert parts["normals"] is None
    (parts,) = parts_of(nf.Scene.from_trimesh(hard()))
    np.testing.assert_allclose(parts["normals"], hard().vertex_normals, atol=1e-7)


@pytest.mark.parametrize("name", ["FlightHelmet/FlightHelmet.gltf", "Duck.glb"])
def test_real_files_are_smooth(name: str) -> None:
    scene = nf.Scene.load(data(f"objects/gltf/{name}"))
    assert not [note for note in scene.report.notes if "normals of" in note]
    for parts in parts_of(scene):
        lengths = np.linalg.norm(parts["normals"], axis=1)
        np.testing.assert_allclose(lengths, 1.0, atol=1e-3)
        corners = parts["positions"][parts["faces"]].astype(np.float64)
        flat = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        mean = parts["normals"][parts["faces"]].mean(axis=1)
        # Normals point to the side of counter-clockwise faces, except at a few slivers.
        assert (np.einsum("ij,ij->i", flat, mean) >= 0).mean() > 0.98


def test_saved_scenes_have_the_same_normals() -> None:
    vertices, faces = ball(2)
    builder = SceneBuilder()
    rows = hard().vertex_normals.astype(np.float32)
    rows[5] = 0
    codes = np.random.default_rng(0).integers(0, 256, (len(vertices), 4), dtype=np.uint8)
    owner = np.arange(len(faces)) % 3 - 1
    material = [builder.material((0.2 * n, 0.5, 0.5, 1)) for n in range(3)]
    builder.objects(["left", "right"])
    mesh = builder.mesh(
        vertices, faces, normals=rows, colors=codes, face_object=owner, material=np.arange(len(faces)) % 2
    )
    builder.instance(mesh)
    other = builder.mesh(vertices, faces, normals=rows, material=material[2])
    plain = builder.mesh(vertices, faces)
    beside = np.eye(4)
    for number, handle in enumerate([other, other, plain]):
        beside[0, 3] = 2.5 * number - 5
        builder.instance(handle, beside.copy(), name=f"ball {number}")
    scene = builder.build()
    encoded = glb.encode(scene._core, scene.object_names, {})
    decoded = glb.Decoder(encoded, Names(scene.object_names)).decode()
    before = parts_of(scene)
    after = [_core.mesh_parts(mesh) for mesh in _core.scene_parts(decoded)["meshes"]]
    for one, two in zip(before, after, strict=True):
        for name in ("positions", "normals"):
            np.testing.assert_array_equal(one[name][one["faces"]], two[name][two["faces"]])
    loaded = nf.Scene(decoded, Names(scene.object_names))
    for x in (-4, 0, 2):
        np.testing.assert_array_equal(colors(loaded, camera((x, 0, 0))), colors(scene, camera((x, 0, 0))))
    # If an object lacks normals in a mesh where others have some, the file has none, which is flat in glTF too.
    document = Reader(encoded).document
    with_normals = {
        node["name"]: "NORMAL" in document["meshes"][node["mesh"]]["primitives"][0]["attributes"]
        for node in document["nodes"]
        if "mesh" in node and "name" in node
    }
    assert with_normals == {"left": True, "right": True, "ball 0": True, "ball 1": True, "ball 2": False}
    other_reader = trimesh.load_scene(io.BytesIO(encoded), file_type="glb", process=False)
    assert sum("vertex_normals" in mesh._cache.cache for mesh in other_reader.geometry.values()) >= 4
