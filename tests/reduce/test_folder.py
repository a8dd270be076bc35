"""Tests of saved reduced scenes: equal pictures after loading, and files that other programs read."""

from __future__ import annotations

import json
import os
import shutil
import struct
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, strategies as st
from numpy.typing import NDArray

import nearfar as nf
from nearfar._base import formats
from nearfar._reduce.drawing import Boundary, MorphKind
from nearfar._reduce.folder import COUNTS
from nearfar._scene import glb
from nearfar._scene.builder import SceneBuilder
from tests.support import data, need, valid
from tests.support.reduce_cases import CENTER, R1, R2, camera, place, street

METHODS: list[dict[str, Any]] = [{"method": "vertex"}, {"method": "exact"}]
USER = CENTER + np.array([6.0, 0.2, 3.0])


def assert_same_pictures(saved: nf.ReducedScene, loaded: nf.ReducedScene, view: nf.Camera, **how: Any) -> None:
    baked = ("color", "range", "object_id") if saved.env is None else saved.env.channels
    channels = [*baked, "position"] if "range" in baked else list(baked)
    one, other = (reduced.render(view, channels=channels, **how) for reduced in (saved, loaded))
    for name in channels:
        expected, found = one.require(name), other.require(name)
        if name == "object_id":
            # Without object numbers in the map, a loaded scene has only the objects of the near part.
            expected, found = (
                np.array([*reduced.scene.object_names, "nothing"])[image]
                for reduced, image in ((saved, expected), (loaded, found))
            )
        np.testing.assert_array_equal(expected, found, err_msg=f"{name} {how}")


def dressed() -> nf.Scene:
    """Return a scene with everything that a GLB must store: textures, cut-outs, colours, normals, instances, groups."""
    build = SceneBuilder()
    rng = np.random.default_rng(5)
    leaves = rng.integers(0, 256, (8, 16, 4), dtype=np.uint8)
    bricks = rng.integers(0, 256, (4, 4, 4), dtype=np.uint8)
    bricks[..., 3] = 255
    build.objects(["left", "right"])
    first = build.material((0.3, 0.9, 1e-9, 1))
    second = build.material((1, 1, 1, 1), bricks)
    cut = build.material((1, 0.5, 0.25, 1), leaves, 0.4)
    quad = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0.0]])
    vertices = np.concatenate([quad * 5 + offset for offset in ([8, 0, 4], [-9, 0, 12], [30, 0, 9], [2, 1, -70])])
    faces = np.array([[0, 1, 2], [0, 2, 3]])[None] + 4 * np.arange(4)[:, None, None]
    build.instance(
        build.mesh(
            vertices,
            faces.reshape(-1, 3)[[5, 0, 3, 1, 4, 2, 6, 7]],
            material=[second, first, cut, second, cut, first, first, second],
            face_object=[0, 1, -1, 0, 1, 1, 0, -1],
            uvs=rng.uniform(-2, 3, (16, 2)) ** 9,
            colors=rng.integers(0, 256, (16, 4), dtype=np.uint8),
            normals=rng.normal(size=(16, 3)),
        )
    )
    up = np.array([[0.1, 0.3, 1.0], [0, 0, 0], [0, 1, 1], [0.5, 0, 1]])
    sign = build.mesh(quad.astype(np.float32), [[0, 1, 2], [0, 2, 3]], material=cut, uvs=quad[:, :2], normals=up)
    turned = np.array([[0, 0, 2, 4], [0, 3, 0, 0.1], [-2, 0, 0, 1 / 3], [0, 0, 0, 1.0]])
    build.place_many(sign, [place(12, 0, 3), turned, place(3, 0, 1) * [[-1], [1], [1], [1]]], "sign")
    for name in ("car", "van"):
        build.instance(build.mesh(quad, [[0, 1, 2], [0, 2, 3]], material=second), place(9, 1, -8), name=name)
    return build.build(dynamic=["car", "van"])


@pytest.mark.parametrize("morph", ["blend", "cylinder", "none"])
def test_a_loaded_scene_shows_the_same_pictures(morph: MorphKind, tmp_path: Path) -> None:
    scene = street(dynamic=True)
    pose = {"car": place(14, 0.75, -3)}
    reduced = nf.reduce(
        scene.at(pose), center=CENTER, r1=R1, r2=R2, face_size=32, morph=morph, channels=("color", "range", "object_id")
    )
    reduced.save(tmp_path / "street", half=False)
    loaded = nf.ReducedScene.load(tmp_path / "street")
    for how in METHODS:
        for at in (None, {"car": place(70, 1, -9)}, {"car": place(40, 0.75, 4)}):
            assert_same_pictures(reduced, loaded, camera(USER, (1, 0, -0.3)), at=at, **how)
    assert loaded.scene.transform("car").tolist() == scene.transform("car").tolist()
    same = ("triangles", "near", "intermediate", "nsf", "sf", "drawn", "rays", "ranges_computed", "map_bytes")
    assert {name: loaded.stats[name] for name in same} == {name: reduced.stats[name] for name in same}
    assert (loaded.center, loaded.r1, loaded.r2, loaded.morph) == (reduced.center, R1, R2, morph)
    assert loaded.scene.object_names == scene.object_names
    assert loaded.scene.triangle_count == reduced.stats["drawn"]


def test_all_shading_data_is_restored_bit_for_bit(tmp_path: Path) -> None:
    scene = dressed()
    reduced = nf.reduce(scene, center=CENTER, r1=R1, r2=R2, face_size=32)
    reduced.save(tmp_path / "all", half=False)
    loaded = nf.ReducedScene.load(tmp_path / "all")
    near = scene.subset(triangles=reduced.partition.nsf)
    np.testing.assert_array_equal(loaded.scene.triangles(), near.triangles())
    for how in METHODS:
        for toward in [(1, 0, 0.3), (-1, 0.1, 1), (0.2, 0, -1)]:
            assert_same_pictures(reduced, loaded, camera(USER, toward), **how)
    again = glb.Decoder(glb.encode(loaded.scene._core, scene.object_names, {}), scene._names).decode()
    np.testing.assert_array_equal(again.triangles(), near.triangles())


def test_maps_are_stored_as_half_floats_by_default(tmp_path: Path) -> None:
    reduced = nf.reduce(street(), center=CENTER, r1=R1, r2=R2, face_size=32)
    reduced.save(tmp_path / "half")
    loaded = nf.ReducedScene.load(tmp_path / "half")
    assert reduced.env is not None
    assert loaded.env is not None
    # Half floats have 11 significant bits.
    np.testing.assert_allclose(loaded.env.color, reduced.env.color, rtol=2**-11, atol=2**-24)


@pytest.mark.parametrize("boundary", ["r1", "r2"])
def test_saved_geometry_is_the_drawn_geometry(boundary: Boundary, tmp_path: Path) -> None:
    scene = street(dynamic=True)
    reduced = nf.reduce(scene, center=CENTER, r1=R1, r2=R2, face_size=32, morph="none", boundary=boundary)
    reduced.save(tmp_path / "saved", half=False)
    loaded = nf.ReducedScene.load(tmp_path / "saved")
    assert loaded.scene.triangle_count == reduced.stats["drawn"] == loaded.stats["drawn"]
    assert_same_pictures(reduced, loaded, camera(USER, (1, 0, -0.3)))
    loaded.save(tmp_path / "again", half=False)
    for name in ("near.glb", "reduced.json"):
        assert (tmp_path / "again" / name).read_bytes() == (tmp_path / "saved" / name).read_bytes()


def test_far_geometry_is_not_saved(tmp_path: Path) -> None:
    reduced = nf.reduce(street(), center=CENTER, r1=R1, r2=R2, face_size=16)
    reduced.save(tmp_path / "saved")
    loaded = nf.ReducedScene.load(tmp_path / "saved")
    for scene in (loaded, loaded.with_morph("none")):
        with pytest.raises(ValueError, match="far geometry was not saved"):
            scene.render(camera(USER, (1, 0, 0)), env=False)


def test_without_far_geometry_there_is_no_map(tmp_path: Path) -> None:
    near = street(ground=False).subset(objects=["near"])
    reduced = nf.reduce(near, center=CENTER, r1=R1, r2=R2)
    reduced.save(tmp_path / "saved")
    assert sorted(file.name for file in (tmp_path / "saved").iterdir()) == ["near.glb", "reduced.json"]
    loaded = nf.ReducedScene.load(tmp_path / "saved")
    assert loaded.env is None
    for env in (True, False):
        assert_same_pictures(reduced, loaded, camera(USER, (1, 0, 1)), env=env)


def test_without_near_geometry_the_glb_is_empty(tmp_path: Path) -> None:
    reduced = nf.reduce(street(ground=False).subset(objects=["tower"]), center=CENTER, r1=R1, r2=R2, face_size=16)
    reduced.save(tmp_path / "saved", half=False)
    loaded = nf.ReducedScene.load(tmp_path / "saved")
    assert loaded.stats["drawn"] == 0
    assert_same_pictures(reduced, loaded, camera(USER, (1, 0.2, 0.6)))


def test_far_from_the_origin_saved_scenes_keep_their_digits(tmp_path: Path) -> None:
    offset = np.array([400_000.25, 12.5, -5_000_000.125])
    build = SceneBuilder()
    corners = np.array([[-9, 0, -9], [9, 0, -9], [9, 0.3, 60], [-9, 0.1, 60]]) + offset
    build.instance(build.mesh(corners, [[0, 2, 1], [0, 3, 2]]), name="strip")
    reduced = nf.reduce(build.build(), center=offset + np.array([0, 1.7, 0]), r1=20, r2=30, face_size=16)
    reduced.save(tmp_path / "saved", half=False)
    loaded = nf.ReducedScene.load(tmp_path / "saved")
    np.testing.assert_array_equal(loaded.scene.origin, reduced.scene.origin)
    stated = glb.Decoder((tmp_path / "saved" / "near.glb").read_bytes(), None).document["scenes"][0]["extras"][
        "nearfar"
    ]
    assert stated == {"center": list(reduced.center), "origin": [0, 0, 0], "r1": 20, "r2": 30}
    assert_same_pictures(reduced, loaded, camera(offset + np.array([2, 1.8, 1]), (0, -0.2, 1)))


def test_nameless_objects_are_counted(tmp_path: Path) -> None:
    vertices = np.random.default_rng(1).uniform(-60, 60, (300, 3))
    scene = nf.Scene.from_arrays(vertices, np.arange(300).reshape(-1, 3), np.repeat(np.arange(20), 5))
    reduced = nf.reduce(scene, center=CENTER, r1=R1, r2=R2, face_size=16, channels=("color", "object_id"))
    reduced.save(tmp_path / "saved", half=False)
    assert json.loads((tmp_path / "saved" / "reduced.json").read_text())["object_names"] == 20
    loaded = nf.ReducedScene.load(tmp_path / "saved")
    assert_same_pictures(reduced, loaded, camera(USER, (1, 0, 1)))


def test_the_document_does_not_repeat_the_other_files(tmp_path: Path) -> None:
    build = SceneBuilder()
    for number in range(2000):
        z = -8.0 - 0.5 * number
        corners = np.array([[-1, 0, z], [1, 0, z], [0, 2, z]])
        build.instance(build.mesh(corners, [[0, 1, 2]]), name=f"a sign with a long name, number {number}")
    scene = build.build(dynamic=["a sign with a long name, number 3"])
    for channels in (("color",), ("color", "object_id")):
        reduced = nf.reduce(scene, center=CENTER, r1=15, r2=25, face_size=16, channels=channels)
        reduced.save(tmp_path / "saved", half=False)
        document = tmp_path / "saved" / "reduced.json"
        assert document.stat().st_size < 1500
        valid(json.loads(document.read_text()), "reduced")
        loaded = nf.ReducedScene.load(tmp_path / "saved")
        assert_same_pictures(reduced, loaded, camera(USER, (-1, 0, -3)))
        known = scene.triangle_count if "object_id" in channels else reduced.stats["drawn"]
        assert len(loaded.scene.object_names) == known
        pose = {"a sign with a long name, number 3": place(0, 1, -20)}
        for method in METHODS:
            frames = [one.render(camera(USER, (-1, 0, -3)), at=pose, **method) for one in (reduced, loaded)]
            np.testing.assert_allclose(frames[0].require("color"), frames[1].require("color"), atol=1e-3)


def test_a_moving_object_without_triangles_is_omitted(tmp_path: Path) -> None:
    build = SceneBuilder()
    for name, faces in (("nothing", np.empty((0, 3), np.uint32)), ("car", np.array([[0, 1, 2]], np.uint32))):
        vertices = np.array([[0, 0, -10], [1, 0, -10], [0, 1, -10]])
        build.instance(build.mesh(vertices, faces), name=name)
    scene = build.build(dynamic=["nothing", "car"])
    reduced = nf.reduce(scene, center=(0, 1, 0), r1=5, r2=20, face_size=8)
    reduced.save(tmp_path / "saved")
    loaded = nf.ReducedScene.load(tmp_path / "saved")
    assert_same_pictures(reduced, loaded, nf.Camera((1, 1, 0), fov=nf.Fov.symmetric(90), size=(16, 16)))
    assert loaded.at({"car": place(1.0, 0.0, 0.0)}).scene.triangle_count == 1


def test_folders_of_the_first_version_are_read(folder: Path, tmp_path: Path) -> None:
    older = shutil.copytree(folder, tmp_path / "older")
    document = json.loads((older / "reduced.json").read_text())
    loaded = nf.ReducedScene.load(folder)
    rest = dict(zip((row["object"] for row in document["moving"]), loaded.scene._load_placements.tolist(), strict=True))
    for row in document["moving"]:
        row.setdefault("transform", loaded.scene.transform(row["object"]).tolist())
        row.setdefault("rest", rest[row["object"]])
    names = [*loaded.scene.object_names, "far away"]
    (older / "reduced.json").write_text(formats.to_json(document | {"version": 1, "object_names": names}))
    again = nf.ReducedScene.load(older)
    assert list(again.scene.object_names) == names
    assert_same_pictures(loaded, again, camera(USER, (1, 0, -0.3)))


def test_the_document_follows_its_schema(tmp_path: Path) -> None:
    nf.reduce(street(dynamic=True), center=CENTER, r1=R1, r2=R2, face_size=16).save(tmp_path / "saved")
    document = json.loads((tmp_path / "saved" / "reduced.json").read_text())
    valid(document, "reduced")
    assert document["moving"][0]["object"] == "car"


def test_trimesh_sees_the_same_triangles_names_and_textures(tmp_path: Path) -> None:
    import trimesh

    scene = dressed()
    nf.reduce(scene, center=CENTER, r1=R1, r2=R2, face_size=16).save(tmp_path / "saved")
    near = nf.ReducedScene.load(tmp_path / "saved").scene
    seen = trimesh.load_scene(tmp_path / "saved" / "near.glb")
    assert {"left", "right", "sign_0", "sign_2", "car", "van"} <= set(seen.graph.nodes)
    triangles = seen.to_geometry().triangles

    def ordered(corners: NDArray[Any]) -> NDArray[np.float64]:
        rows = np.asarray(corners, np.float64).reshape(-1, 9)
        return rows[np.lexsort(rows.round(3).T)]

    # trimesh multiplies matrices in float64, nearfar in float32: a few roundings at 50 m. trimesh does not reverse the
    # faces of mirrored instances, so corners are compared sorted.
    mine = np.sort(near.triangles(), axis=1)
    np.testing.assert_allclose(ordered(mine), ordered(np.sort(triangles, axis=1)), atol=2e-5)
    textured = [mesh for mesh in seen.geometry.values() if getattr(mesh.visual, "kind", None) == "texture"]
    assert any(mesh.visual.material.baseColorTexture is not None for mesh in textured)


def test_our_loader_reads_the_near_part_like_any_glb(tmp_path: Path) -> None:
    reduced = nf.reduce(dressed(), center=CENTER, r1=R1, r2=R2, face_size=16)
    reduced.save(tmp_path / "saved")
    near = nf.ReducedScene.load(tmp_path / "saved").scene
    loaded = nf.Scene.load(tmp_path / "saved" / "near.glb")
    assert loaded.triangle_count == near.triangle_count
    view = camera(USER, (1, 0, 0.3))
    one, other = nf.render(near, view).require("color"), nf.render(loaded, view).require("color")
    # The textures must not be flipped; computing 1 − v twice in float32 shifts a lookup by a rounding.
    assert np.mean(np.abs(one - other).max(axis=-1) > 1e-3) < 2e-3


def test_accessors_follow_the_rules_of_gltf(tmp_path: Path) -> None:
    """Checks glTF 2.0, 3.6: alignment, bounds of positions, strides, and no empty lists."""
    nf.reduce(dressed(), center=CENTER, r1=R1, r2=R2, face_size=16).save(tmp_path / "saved")
    content = (tmp_path / "saved" / "near.glb").read_bytes()
    magic, version, size, length, kind = struct.unpack_from("<4sIII4s", content)
    assert (magic, version, size, kind, length % 4) == (b"glTF", 2, len(content), b"JSON", 0)
    document = json.loads(content[20 : 20 + length])
    sizes = {5121: 1, 5123: 2, 5125: 4, 5126: 4}
    for accessor in document["accessors"]:
        view = document["bufferViews"][accessor["bufferView"]]
        start = view["byteOffset"] + accessor["byteOffset"]
        assert start % sizes[accessor["componentType"]] == 0
        assert view["byteOffset"] % 4 == 0
        width = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}[accessor["type"]]
        step = sizes[accessor["componentType"]] * width
        assert accessor["byteOffset"] + accessor["count"] * step <= view["byteLength"]
        assert accessor["count"] >= 1
        assert view.get("byteStride", step) == step
    used = [primitive for mesh in document["meshes"] for primitive in mesh["primitives"]]
    assert all({"min", "max"} <= document["accessors"][p["attributes"]["POSITION"]].keys() for p in used)

    def lists(value: Any) -> list[list[Any]]:
        inner = value.values() if isinstance(value, dict) else value if isinstance(value, list) else []
        return ([value] if isinstance(value, list) else []) + [found for item in inner for found in lists(item)]

    assert all(lists(document))


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    made = tmp_path_factory.mktemp("bundle") / "saved"
    nf.reduce(dressed(), center=CENTER, r1=R1, r2=R2, face_size=8).save(made)
    return made


@pytest.mark.parametrize("name", ["near.glb", "far.exr", "reduced.json"])
def test_a_missing_file_is_named(name: str, folder: Path, tmp_path: Path) -> None:
    broken = shutil.copytree(folder, tmp_path / "broken")
    (broken / name).unlink()
    with pytest.raises(FileNotFoundError, match=name):
        nf.ReducedScene.load(broken)


@given(name=st.sampled_from(["near.glb", "far.exr", "reduced.json"]), where=st.floats(0, 1), value=st.integers(0, 255))
def test_damage_is_reported_with_the_file(name: str, where: float, value: int, folder: Path) -> None:
    content = bytearray((folder / name).read_bytes())
    for damaged in (content[: int(where * len(content))], content.copy()):
        if len(damaged) == len(content):
            damaged[int(where * (len(content) - 1))] ^= value
        broken = folder.with_name("broken")
        shutil.rmtree(broken, ignore_errors=True)
        shutil.copytree(folder, broken)
        (broken / name).write_bytes(damaged)
        # A damaged file may still be readable. If files contradict each other, the error may name either.
        try:
            nf.ReducedScene.load(broken)
        except nf.FormatError as error:
            message = str(error)
        else:
            continue
        assert message.startswith(os.fspath(broken))


@pytest.mark.parametrize(
    ("change", "word"),
    [
        ({"format": "nearfar.frame"}, "nearfar.reduced"),
        ({"version": 99}, "version 99"),
        ({"center": [0, 0]}, "center"),
        ({"r1": 60}, "r1"),
        ({"morph": "linear"}, "morph"),
        ({"counts": {}}, "triangles"),
        ({"counts": dict.fromkeys(COUNTS, -1)}, "expected a whole number"),
        ({"moving": []}, "moving"),
        ({"object_names": ["left"]}, "no object"),
        ({"files": None}, "NoneType"),
    ],
)
def test_a_wrong_document_is_explained(change: dict[str, Any], word: str, folder: Path, tmp_path: Path) -> None:
    broken = shutil.copytree(folder, tmp_path / "broken")
    document = json.loads((broken / "reduced.json").read_text()) | change
    (broken / "reduced.json").write_text(formats.to_json(document))
    with pytest.raises(nf.FormatError, match=word):
        nf.ReducedScene.load(broken)


@pytest.mark.parametrize("name", ["near.glb", "reduced.json"])
def test_extreme_nesting_is_damage(name: str, folder: Path, tmp_path: Path) -> None:
    broken = shutil.copytree(folder, tmp_path / "broken")
    text = b"[" * 100_000
    chunk = len(text).to_bytes(4, "little") + b"JSON" + text
    whole = b"glTF" + (2).to_bytes(4, "little") + (12 + len(chunk)).to_bytes(4, "little") + chunk
    (broken / name).write_bytes(whole if name == "near.glb" else text)
    with pytest.raises(nf.FormatError, match=name):
        nf.ReducedScene.load(broken)


def test_other_folders_are_left_alone(folder: Path, tmp_path: Path) -> None:
    reduced = nf.ReducedScene.load(folder)
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "thesis.tex").write_text("years")
    with pytest.raises(FileExistsError, match="holds other files"):
        reduced.save(tmp_path / "mine")
    reduced.save(tmp_path / "new")
    reduced.save(tmp_path / "new")
    assert sorted(file.name for file in tmp_path.iterdir()) == ["mine", "new"]


@pytest.mark.slow
@pytest.mark.parametrize(
    "file",
    ["city/tokyo23/tokyo_core_lod1.glb", "objects/gltf/FlightHelmet/FlightHelmet.gltf", "interior/garage/garage.gltf"],
)
def test_real_scenes_are_restored(file: str, tmp_path: Path) -> None:
    need("data")
    scene = nf.Scene.load(data(file))
    middle = scene.bounds.mean(axis=0)
    reach = float(np.ptp(scene.bounds, axis=0)[[0, 2]].max())
    reduced = nf.reduce(scene, center=middle, r1=0.1 * reach, r2=0.2 * reach, face_size=32, samples=1)
    reduced.save(tmp_path / "saved", half=False)
    loaded = nf.ReducedScene.load(tmp_path / "saved")
    user = middle + 0.05 * reach * np.array([1, 0.5, 1])
    for how in METHODS:
        assert_same_pictures(reduced, loaded, camera(user, (-1, -0.4, -1)), **how)
