"""Tests of emission and of unlit materials: reading, storage and writing."""

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
from nearfar._scene.emission import MAX_EMISSION
from nearfar._scene.serialize import parts_of
from nearfar._scene.srgb import to_linear
from tests.support import ktx2_cases
from tests.support.gltf_cases import MATERIALS, decode, gltf, materials, picture, texels
from tests.support.render_cases import build, glowing

FOV = nf.Fov(-1.2, 0.9, -1.1, 1.0)
PLAIN: dict[str, Any] = {"pbrMetallicRoughness": {"metallicFactor": 0.0}, "doubleSided": True}
UNLIT: dict[str, Any] = {"extensions": {"KHR_materials_unlit": {}}}
DRAWN = ("material_colors", "material_emissions", "material_unlit")


def strength(value: Any) -> dict[str, Any]:
    return {"extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": value}}}


def load_materials(folder: Path, *entries: dict[str, Any], **changes: Any) -> nf.Scene:
    (folder / "source.glb").write_bytes(gltf([PLAIN | entry for entry in entries], **changes))
    return nf.Scene.load(folder / "source.glb")


def emissions(scene: nf.Scene) -> list[list[float]]:
    found: list[list[float]] = parts_of(scene._core)["material_emissions"].tolist()
    return found


def glow(scene: nf.Scene, number: int = 0) -> np.ndarray | None:
    """The emission texture of a material."""
    parts = parts_of(scene._core)
    link = parts["material_emission_textures"][number]
    return None if link < 0 else np.asarray(parts["textures"][link])


@pytest.mark.parametrize(
    ("entry", "expected"),
    [
        ({}, [0, 0, 0]),
        ({"emissiveFactor": [0.25, 0.5, 1]}, [0.25, 0.5, 1]),
        ({"emissiveFactor": [0.25, 0.5, 1]} | strength(6), [1.5, 3, 6]),
        ({"emissiveFactor": [0, 0.5, 0]} | strength("much"), [0, 0.5, 0]),
        ({"emissiveFactor": [1, 0, 0.5]} | strength(1e300), [MAX_EMISSION, 0, MAX_EMISSION]),
        (strength(6), [0, 0, 0]),
        # Khronos: an unlit material has no other properties than its base colour.
        ({"emissiveFactor": [1, 1, 1]} | UNLIT, [0, 0, 0]),
    ],
)
def test_emission_in_gltf_is_factor_times_strength(
    tmp_path: Path, entry: dict[str, Any], expected: list[float]
) -> None:
    scene = load_materials(tmp_path, entry)
    assert emissions(scene) == [expected]
    assert parts_of(scene._core)["material_unlit"].tolist() == [entry.get("extensions") == UNLIT["extensions"]]
    assert scene.report.notes == ()


def test_unlit_materials_need_no_notes_on_gloss_or_maps(tmp_path: Path) -> None:
    maps = {"normalTexture": {"index": 1}, "occlusionTexture": {"index": 1}, "pbrMetallicRoughness": {}}
    assert load_materials(tmp_path, maps | UNLIT).report.notes == ()
    assert len(load_materials(tmp_path, maps).report.notes) == 3


def test_emission_textures_are_read_with_the_base_colour(tmp_path: Path) -> None:
    base = {"pbrMetallicRoughness": {"metallicFactor": 0.0, "baseColorTexture": {"index": 2}}}
    lamp = {"emissiveFactor": [1, 1, 1], "emissiveTexture": {"index": 3}}
    scene = load_materials(tmp_path, base | lamp, lamp, base | lamp | {"emissiveTexture": {"index": 2}})
    assert scene.report.textures == 2
    for number, image in ((0, 3), (1, 3), (2, 2)):
        np.testing.assert_array_equal(glow(scene, number), texels(picture(image, "png")))
    assert scene.report.notes == ()


@pytest.mark.parametrize(
    ("base", "map_", "note"),
    [
        ({}, {"texCoord": 1}, "with emission on other texture coordinates drawn and saved without it"),
        (
            {},
            {"extensions": {"KHR_texture_transform": {"scale": [2, 2]}}},
            "with emission on other texture coordinates drawn without it",
        ),
        (None, {"index": 77}, "with an unreadable map of emission drawn and saved without it"),
    ],
)
def test_emission_with_unsupported_coordinates_is_not_drawn(
    tmp_path: Path, base: dict[str, Any] | None, map_: dict[str, Any], note: str
) -> None:
    surface = {"metallicFactor": 0.0} | ({} if base is None else {"baseColorTexture": {"index": 2} | base})
    entry = {"pbrMetallicRoughness": surface, "emissiveFactor": [1, 1, 1], "emissiveTexture": {"index": 3} | map_}
    scene = load_materials(tmp_path, entry)
    assert emissions(scene) == [[0, 0, 0]]
    assert f"1 material {note}" in scene.report.notes
    nf.lod.export(scene, tmp_path / "written.glb", view=FOV)
    # With the factor alone dark parts would glow.
    written = materials(tmp_path / "written.glb")[""]
    assert ("emissiveTexture" in written) == ("emissiveFactor" in written) == ("saved" not in note)
    assert emissions(nf.Scene.load(tmp_path / "written.glb")) == [[0, 0, 0]]


def test_emission_textures_may_be_ktx_2_images(tmp_path: Path) -> None:
    pixels = np.random.default_rng(4).integers(0, 256, (3, 5, 4), np.uint8)
    lamp = PLAIN | {"emissiveFactor": [1, 1, 1], "emissiveTexture": {"index": 0}}
    (tmp_path / "a.glb").write_bytes(ktx2_cases.glb(ktx2_cases.ktx2(pixels, 43), materials=[lamp]))
    scene = nf.Scene.load(tmp_path / "a.glb")
    nf.reduce(scene, center=(1, 1, 1), r1=50, r2=90, face_size=4).save(tmp_path / "reduced")
    back = nf.ReducedScene.load(tmp_path / "reduced").scene
    for shown in (scene, back, nf.Scene.load(tmp_path / "reduced" / "near.glb")):
        assert emissions(shown) == [[1, 1, 1]]
        np.testing.assert_array_equal(glow(shown), pixels)
    binary = (tmp_path / "reduced" / "near.glb").read_bytes()
    assert binary.count(ktx2_cases.ktx2(pixels, 43)) == 1


def test_a_damaged_emission_image_is_noted_and_kept(tmp_path: Path) -> None:
    data = gltf([PLAIN | {"emissiveFactor": [1, 1, 1], "emissiveTexture": {"index": 3}}])
    start = data.index(picture(3, "png")) + 50
    (tmp_path / "a.glb").write_bytes(data[:start] + bytes(30) + data[start + 30 :])
    scene = nf.Scene.load(tmp_path / "a.glb")
    assert (emissions(scene), glow(scene)) == ([[0, 0, 0]], None)
    assert scene.report.notes == ("1 material with an unreadable map of emission drawn without it",)
    nf.reduce(scene, center=(1, 1, 1), r1=50, r2=90, face_size=4).save(tmp_path / "reduced")
    assert emissions(nf.ReducedScene.load(tmp_path / "reduced").scene) == [[0, 0, 0]]
    assert materials(tmp_path / "reduced" / "near.glb")[""]["emissiveFactor"] == [1, 1, 1]


def test_meshes_without_coordinates_show_no_emission_map(tmp_path: Path) -> None:
    meshes = [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 2, "material": 0}]}]
    scene = load_materials(tmp_path, {"emissiveFactor": [1, 1, 1], "emissiveTexture": {"index": 3}}, meshes=meshes)
    assert emissions(scene) == [[0, 0, 0]]
    ending = "with a map of emission but no texture coordinates drawn and saved without it"
    assert scene.report.notes == (f"1 mesh {ending}",)
    assert emissions(load_materials(tmp_path, {"emissiveFactor": [1, 1, 1]}, meshes=meshes)) == [[1, 1, 1]]


def wavefront(folder: Path, lines: str) -> nf.Scene:
    (folder / "a.mtl").write_text(f"newmtl m\nKd 0.5 0.4 0.3\n{lines}\n")
    corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
    (folder / "a.obj").write_text(f"mtllib a.mtl\n{corners}usemtl m\nf 1/1 2/2 3/3\n")
    return nf.Scene.load(folder / "a.obj")


@pytest.mark.parametrize(
    ("lines", "expected"),
    [("Ke 1 0.5 0", [1, 0.5, 0]), ("Ke 0.25", [0.25] * 3), ("Ke 0 0 0", [0] * 3), ("Ke -1 -2 0", [0] * 3)],
)
def test_emission_in_wavefront_is_srgb(tmp_path: Path, lines: str, expected: list[float]) -> None:
    light = to_linear(np.array(expected)).astype(np.float32)
    np.testing.assert_array_equal(emissions(wavefront(tmp_path, lines)), [light])


def test_bright_emission_in_wavefront_is_kept(tmp_path: Path) -> None:
    scene = wavefront(tmp_path, "Ke 10 5 0.5")
    np.testing.assert_allclose(emissions(scene), np.array([[10, 5, float(to_linear(np.array(0.5)))]]), rtol=1e-6)
    nf.lod.export(scene, tmp_path / "written.glb", view=FOV)
    assert emissions(nf.Scene.load(tmp_path / "written.glb")) == emissions(scene)


@pytest.mark.parametrize(
    ("lines", "expected"), [("Ke 0.5 1 1", [float(to_linear(np.array(0.5))), 1, 1]), ("", [1, 1, 1])]
)
def test_an_emission_map_in_wavefront_is_drawn(tmp_path: Path, lines: str, expected: list[float]) -> None:
    (tmp_path / "light of lamp.png").write_bytes(picture(0, "png"))
    scene = wavefront(tmp_path, f"{lines}\nmap_Ke light of lamp.png")
    np.testing.assert_allclose(emissions(scene), [expected], rtol=1e-6)
    np.testing.assert_array_equal(glow(scene), texels(picture(0, "png")))
    assert scene.report.notes == ()


def test_emission_of_trimesh_objects_is_drawn() -> None:
    image = Image.fromarray(np.full((2, 3, 3), 77, np.uint8))
    box = trimesh.creation.box()
    material = trimesh.visual.material.PBRMaterial(emissiveFactor=[0, 0.5, 1], emissiveTexture=image)
    box.visual = trimesh.visual.TextureVisuals(uv=np.zeros((8, 2)), material=material)
    scene = nf.Scene.from_trimesh(box)
    assert emissions(scene) == [[0, 0.5, 1]]
    texture = glow(scene)
    assert texture is not None
    assert (texture == (77, 77, 77, 255)).all()
    assert not [note for note in scene.report.notes if "emission" in note]


def same_surfaces(one: nf.Scene, other: nf.Scene) -> None:
    """Assert equal materials, texel for texel, in any order of textures."""
    first, second = parts_of(one._core), parts_of(other._core)
    for name in (*DRAWN, "material_cutoffs"):
        np.testing.assert_array_equal(first[name], second[name], err_msg=name)
    for name in ("material_textures", "material_emission_textures"):
        for a, b in zip(first[name], second[name], strict=True):
            assert (a < 0) == (b < 0)
            if a >= 0:
                np.testing.assert_array_equal(first["textures"][a], second["textures"][b])


@pytest.mark.parametrize("kind", ["file", "built"])
def test_written_files_look_like_the_scene(tmp_path: Path, kind: str) -> None:
    if kind == "built":
        scene = build(glowing())
    else:
        lamp = {key: MATERIALS[0][key] for key in ("emissiveTexture", "emissiveFactor", "extensions")}
        base = {"pbrMetallicRoughness": {"metallicFactor": 0.0, "baseColorTexture": {"index": 1}}}
        scene = load_materials(tmp_path, lamp, base | lamp, base | UNLIT, {"emissiveFactor": [0.1, 0.2, 0.3]})
    nf.reduce(scene, center=(1, 1, 1), r1=50, r2=90, face_size=4).save(tmp_path / "reduced")
    back = nf.ReducedScene.load(tmp_path / "reduced")
    same_surfaces(scene, back.scene)
    # Written again, the file has the same bytes.
    back.save(tmp_path / "again")
    near = tmp_path / "reduced" / "near.glb"
    assert (tmp_path / "again" / "near.glb").read_bytes() == near.read_bytes()
    same_surfaces(scene, nf.Scene.load(near))
    nf.lod.export(scene, tmp_path / "exported.glb", view=FOV)
    same_surfaces(scene, nf.Scene.load(tmp_path / "exported.glb"))
    document, _ = decode(near)
    assert len(document["materials"]) == 4
    extensions = [name for material in document["materials"] for name in material.get("extensions", {})]
    assert sorted(set(extensions)) == [name for name in document["extensionsUsed"] if "materials" in name]
    if kind == "file":
        written = json.dumps(document["materials"])
        assert [written.count(key) for key in ("emissiveFactor", "emissiveTexture", "unlit")] == [3, 2, 1]
        lamps = [material for material in document["materials"] if "emissiveTexture" in material]
        (number,) = {document["textures"][lamp["emissiveTexture"]["index"]]["source"] for lamp in lamps}
        view = document["bufferViews"][document["images"][number]["bufferView"]]
        binary = decode(near)[1]
        start = view.get("byteOffset", 0)
        assert binary[start : start + view["byteLength"]] == picture(3, "png")


def test_copies_and_parts_of_a_scene_keep_emission() -> None:
    scene = build(glowing())
    for copied in (pickle.loads(pickle.dumps(scene)), copy.deepcopy(scene), scene.subset(objects=["surface 1"])):
        same_surfaces(scene, copied)
    levels = nf.lod.simplify(scene.subset(objects=["surface 1"]), [0.5], name="lamp")
    same_surfaces(levels[0].scene, scene)


def test_materials_with_different_emission_stay_separate() -> None:
    builder = nf.SceneBuilder()
    image = np.zeros((1, 1, 4), np.uint8)
    kinds: list[dict[str, Any]] = [
        *({}, {"emission": (0, 0, 1)}, {"emission": (0, 1, 0)}, {"unlit": True}),
        {"emission": (0, 0, 1), "emission_texture": image},
    ]
    assert [builder.material(**kind) for kind in kinds] == [0, 1, 2, 3, 4]
    # A black emission texture shows nothing.
    assert builder.material(emission_texture=image) == 0
    with pytest.raises(ValueError, match="unlit: expected False for a material that emits light"):
        builder.material(emission=(1, 1, 1), unlit=True)
