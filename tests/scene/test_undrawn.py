"""Tests of material properties that are not drawn: reports note them, and written files keep them."""

from __future__ import annotations

import copy
import json
import pickle
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from PIL import Image

import nearfar as nf
from nearfar._base import data as data_files
from tests.support import need
from tests.support.gltf_cases import MATERIALS, assert_same_materials, decode, gltf, materials

FOV = nf.Fov(-1.2, 0.9, -1.1, 1.0)
PBR = trimesh.visual.material.PBRMaterial
PLAIN: dict[str, Any] = {"pbrMetallicRoughness": {"metallicFactor": 0.0}, "doubleSided": True}


def load_bytes(folder: Path, data: bytes, **options: Any) -> nf.Scene:
    (folder / "source.glb").write_bytes(data)
    return nf.Scene.load(folder / "source.glb", **options)


def saved_near(scene: nf.Scene, folder: Path) -> Path:
    reduced = nf.reduce(scene, center=(1, 1, 1), r1=50, r2=90, face_size=4)
    reduced.save(folder)
    return folder / "near.glb"


@pytest.mark.parametrize(
    ("change", "note"),
    [
        ({"normalTexture": {"index": 1}}, "with a normal map drawn without it"),
        ({"occlusionTexture": {"index": 1}}, "with an occlusion map drawn without it"),
        ({"doubleSided": False}, "with single-sided faces drawn from both sides"),
        ({"alphaMode": "BLEND"}, "with blending drawn opaque"),
        ({"pbrMetallicRoughness": {}}, "with metal or gloss drawn matt"),
        ({"pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 0.5}}, "with metal or gloss drawn matt"),
        ({"extensions": {"KHR_materials_sheen": {}}}, "with the extension KHR_materials_sheen drawn without it"),
        ({"extensions": {"ACME_glow": {}}}, "with the extension ACME_glow drawn and saved without it"),
        (
            {
                "pbrMetallicRoughness": {"metallicFactor": 0, "baseColorTexture": {"index": 2}},
                "normalTexture": {"index": 1, "texCoord": 1},
            },
            "with a map on other texture coordinates drawn and saved without it",
        ),
        ({"normalTexture": {"index": 77}}, "with an unreadable map saved without it"),
    ],
)
def test_each_undrawn_property_is_noted(tmp_path: Path, change: dict[str, Any], note: str) -> None:
    assert load_bytes(tmp_path, gltf([PLAIN])).report.notes == ()
    assert f"1 material {note}" in load_bytes(tmp_path, gltf([PLAIN | change])).report.notes
    assert (
        f"2 materials {note}"
        in load_bytes(tmp_path, gltf([PLAIN | change, {"name": "b"} | PLAIN | change])).report.notes
    )


@pytest.mark.parametrize("suffix", ["ply", "glb"])
def test_transparent_vertices_are_noted(tmp_path: Path, suffix: str) -> None:
    box = trimesh.creation.box()
    box.visual.vertex_colors = np.full((8, 4), 255, np.uint8)
    box.export(tmp_path / f"a.{suffix}")
    assert not any("alpha" in note for note in nf.Scene.load(tmp_path / f"a.{suffix}").report.notes)
    box.visual.vertex_colors[3, 3] = 0
    box.export(tmp_path / f"a.{suffix}")
    assert "1 mesh with vertex alpha below 1 drawn opaque" in nf.Scene.load(tmp_path / f"a.{suffix}").report.notes


def test_the_near_part_keeps_the_materials_of_the_file(tmp_path: Path) -> None:
    scene = load_bytes(tmp_path, gltf())
    near = saved_near(scene, tmp_path / "reduced")
    assert_same_materials(near, tmp_path / "source.glb")
    used = ["KHR_materials_emissive_strength", "KHR_texture_transform"]
    assert decode(near)[0]["extensionsUsed"] == used
    back = nf.ReducedScene.load(tmp_path / "reduced")
    assert back.scene.report.notes == scene.report.notes
    back.save(tmp_path / "again")
    assert (tmp_path / "again" / "near.glb").read_bytes() == near.read_bytes()


@pytest.mark.parametrize("how", ["plain", "levels", "model", "place"])
def test_levels_keep_the_materials_of_the_file(tmp_path: Path, how: str) -> None:
    scene = load_bytes(tmp_path, gltf())
    target = tmp_path / "written.glb"
    levels = nf.lod.simplify(scene, [0.5], name="squares")
    a, b, c, d, rms = (np.array([x]) for x in (1.0, 1.0, 1.0, 0.95, 0.0))
    model = nf.lod.LodModel(
        triangles=np.array([level.triangle_count for level in levels]),
        curves=nf.lod.Curve4PL(a, b, c, d, rms, np.array(["flat"]), np.array([""])),
        center=levels.center,
        radius=levels.radius,
        sigma=(1e-4, 0.3),
        errors=np.zeros(len(levels)),
        levels=levels,
    )
    if how == "plain":
        nf.lod.export(scene, target, view=FOV)
    elif how == "model":
        model.export(target, view=FOV, all_levels=True)
        back = nf.lod.LodModel.load(target)
        back.export(tmp_path / "again.glb", view=FOV, all_levels=True)
        assert (tmp_path / "again.glb").read_bytes() == target.read_bytes()
    elif how == "place":
        placed = nf.lod.place([model], [0, 0], np.tile(np.eye(4), (2, 1, 1)))
        assert set(scene.report.notes) <= set(placed.report.notes)
        nf.lod.export(placed, target, view=FOV)
    else:
        nf.lod.export(scene.with_levels({"square0": model}), target, view=FOV)
    assert_same_materials(target, tmp_path / "source.glb")


def test_materials_that_look_alike_stay_separate(tmp_path: Path) -> None:
    pair = [PLAIN, PLAIN | {"name": "glowing", "emissiveFactor": [1.0, 1.0, 0.0]}]
    scene = load_bytes(tmp_path, gltf(pair))
    assert scene.report.materials == 2
    for way in (pickle.loads(pickle.dumps(scene)), copy.deepcopy(scene), scene.subset(objects=["square1"])):
        nf.lod.export(way, tmp_path / "written.glb", view=FOV)
        assert materials(tmp_path / "written.glb")["glowing"]["emissiveFactor"] == [1.0, 1.0, 0.0]


def test_meshes_without_texture_coordinates_have_no_textures(tmp_path: Path) -> None:
    document_meshes = [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 2, "material": 0}]}]
    lamp = {key: value for key, value in MATERIALS[0].items() if key != "pbrMetallicRoughness"}
    scene = load_bytes(tmp_path, gltf([lamp], meshes=document_meshes))
    nf.lod.export(scene, tmp_path / "written.glb", view=FOV)
    written = materials(tmp_path / "written.glb")["lamp"]
    assert "emissiveFactor" not in written
    assert not [key for key in written if key.endswith("Texture")]
    assert "textures" not in decode(tmp_path / "written.glb")[0]


def test_mirrored_instances_face_outwards_in_other_programs(tmp_path: Path) -> None:
    """glTF reverses the faces of nodes with a mirroring matrix, which matters if back faces are culled."""
    builder = nf.SceneBuilder()
    box = trimesh.creation.box()
    mesh = builder.mesh(np.asarray(box.vertices, np.float32), np.asarray(box.faces, np.uint32))
    mirror = np.diag([-1.0, 1, 1, 1])
    mirror[0, 3] = 5
    builder.place_many(mesh, np.stack([np.eye(4), mirror]), ["straight", "mirrored"])
    scene = builder.build()
    nf.lod.export(scene, tmp_path / "boxes.glb", view=FOV)
    back = nf.Scene.load(tmp_path / "boxes.glb")

    def volume(corners: Any) -> float:
        return float(np.einsum("ni,ni->n", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])).sum() / 6)

    assert volume(scene.triangles()) == pytest.approx(2, rel=1e-5)
    assert volume(back.triangles()) == pytest.approx(2, rel=1e-5)
    # In the mesh's own frame both nodes' faces point outwards.
    seen = trimesh.load_scene(tmp_path / "boxes.glb")
    assert all(part.volume == pytest.approx(1, rel=1e-5) for part in seen.geometry.values())
    reduced = nf.reduce(scene, center=(2, 0, 3), r1=50, r2=90, face_size=4)
    reduced.save(tmp_path / "reduced")
    near = nf.ReducedScene.load(tmp_path / "reduced").scene
    np.testing.assert_array_equal(near.triangles(), reduced.scene.subset(objects=scene.object_names).triangles())


def test_texture_coordinates_keep_their_bits(tmp_path: Path) -> None:
    rng = np.random.default_rng(0)
    texture = rng.integers(0, 256, (4, 4, 4), dtype=np.uint8)
    for uvs in (rng.uniform(-9, 9, (30, 2)), rng.uniform(0, 1e-6, (30, 2)), np.full((30, 2), -0.0), np.ones((30, 2))):
        builder = nf.SceneBuilder()
        material = builder.material((1, 1, 1, 1), texture)
        corners = rng.uniform(-1, 1, (30, 3))
        mesh = builder.mesh(corners, np.arange(30).reshape(10, 3), material=material, uvs=uvs.astype(np.float32))
        builder.instance(mesh, name="soup")
        saved_near(builder.build(), tmp_path / "reduced")
        near = nf.ReducedScene.load(tmp_path / "reduced").scene
        parts = nf._core.mesh_parts(near._core.merged())
        order = np.lexsort(parts["positions"].T)
        expected = uvs.astype(np.float32)[np.lexsort(corners.astype(np.float32).T)]
        assert parts["uvs"][order].tobytes() == expected.tobytes()


def test_materials_of_trimesh_objects_are_kept(tmp_path: Path) -> None:
    maps = [Image.fromarray(np.full((2, 3, 3), level, np.uint8)) for level in (10, 120)]
    material = PBR(
        name="brass", metallicFactor=0.7, roughnessFactor=0.2, emissiveFactor=[0, 0.5, 1], normalTexture=maps[0],
        metallicRoughnessTexture=maps[1], doubleSided=True, alphaMode="BLEND",
    )  # fmt: skip
    box = trimesh.creation.box()
    box.visual = trimesh.visual.TextureVisuals(uv=np.random.default_rng(0).random((8, 2)), material=material)
    scene = nf.Scene.from_trimesh(box)
    assert "1 material with a normal map drawn without it" in scene.report.notes
    nf.lod.export(scene, tmp_path / "box.glb", view=FOV)
    (seen,) = trimesh.load_scene(tmp_path / "box.glb").geometry.values()
    back = seen.visual.material
    assert (back.name, back.metallicFactor, back.roughnessFactor) == ("brass", 0.7, 0.2)
    assert (back.doubleSided, back.alphaMode, back.emissiveFactor.tolist()) == (True, "BLEND", [0, 0.5, 1])
    assert np.asarray(back.normalTexture).max() == 10
    assert np.asarray(back.metallicRoughnessTexture).max() == 120


@pytest.mark.parametrize("value", ["abc", [1], {}, None, float("nan"), [float("inf")] * 3, [[1, 2, 3]], True])
@pytest.mark.parametrize("key", ["emissiveFactor", "doubleSided", "normalTexture", "extensions", "name"])
def test_wrong_entries_count_as_absent(tmp_path: Path, key: str, value: Any) -> None:
    (tmp_path / "source.glb").write_bytes(gltf([PLAIN | {key: value}]))
    try:
        scene = nf.Scene.load(tmp_path / "source.glb")
    except nf.SceneError:
        return  # trimesh refuses some.
    nf.lod.export(scene, tmp_path / "written.glb", view=FOV)
    assert nf.Scene.load(tmp_path / "written.glb").triangle_count == 2


def test_the_helmet_is_exported_with_all_its_maps(tmp_path: Path) -> None:
    need("data")
    source = data_files.require("objects/gltf/FlightHelmet/FlightHelmet.gltf")
    scene = nf.Scene.load(source)
    assert (scene.report.textures, scene.report.materials) == (5, 6)
    nf.lod.export(scene, tmp_path / "helmet.glb", view=FOV)
    written = materials(tmp_path / "helmet.glb")
    document = json.loads(source.read_text())
    assert written.keys() == {material["name"] for material in document["materials"]}
    for material in document["materials"]:
        mine = written[material["name"]]
        for key in ("normalTexture", "occlusionTexture"):
            if key in material:
                uri = document["images"][document["textures"][material[key]["index"]]["source"]]["uri"]
                assert mine[key]["image"] == (source.parent / uri).read_bytes()
        surface = material["pbrMetallicRoughness"]
        for key in ("metallicFactor", "roughnessFactor"):
            assert mine["pbrMetallicRoughness"].get(key) == surface.get(key)
        assert mine.get("doubleSided", False) == material.get("doubleSided", False)
        assert mine.get("alphaMode") == material.get("alphaMode")
