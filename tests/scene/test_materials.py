"""Tests of base colours of loaded scenes: factors, textures, vertex and face colours, alpha."""

from __future__ import annotations

import io
import json
import struct
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from PIL import Image

import nearfar as nf
from nearfar._base import glb
from nearfar._scene import load
from nearfar._scene.budget import Budget
from nearfar._scene.content import Content, Shape
from nearfar._scene.gltf import document
from nearfar._scene.materials import BaseColor, colors_of
from nearfar._scene.srgb import to_linear, to_srgb
from tests.support.gltf_cases import gltf, picture as gltf_picture, texels

PBR = trimesh.visual.material.PBRMaterial


def source_of(path: Path) -> Content:
    """The content of a file as arrays."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(load, "read_gltf", partial(document.read, stores=False))
        return load._read(path, path.read_bytes(), nf.LoadOptions(), Budget())


def shape_of(path: Path) -> Shape:
    return next(iter(source_of(path).shapes.values()))


def picture(seed: int = 0, size: tuple[int, int] = (5, 7), channels: int = 4) -> Image.Image:
    return Image.fromarray(np.random.default_rng(seed).integers(0, 256, (*size, channels), np.uint8))


def textured_box(material: trimesh.visual.material.Material) -> trimesh.Trimesh:
    box = trimesh.creation.box()
    uv = np.random.default_rng(1).uniform(0, 1, (len(box.vertices), 2)).astype(np.float32)
    visual = trimesh.visual.TextureVisuals(uv=uv, material=material)
    return trimesh.Trimesh(box.vertices, box.faces, visual=visual, process=False)


def test_srgb_is_inverted_and_meets_its_fixed_points() -> None:
    light = np.linspace(0, 1, 1001)
    # IEC 61966-2-1's constants are rounded: both branches meet only within 3e-8.
    np.testing.assert_allclose(to_linear(to_srgb(light)), light, atol=1e-7)
    assert to_srgb(np.array(0.5)) == pytest.approx(0.7353569830524495, rel=1e-12)
    np.testing.assert_allclose(to_srgb(np.array([0.0, 1.0])), [0, 1], atol=1e-15)


@pytest.mark.parametrize("kind", [np.uint8, np.uint16, np.float32])
@pytest.mark.parametrize("channels", [3, 4])
def test_linear_colours_are_encoded_and_srgb_ones_kept(kind: type, channels: int) -> None:
    levels = np.random.default_rng(0).integers(0, 256, (50, channels)).astype(np.uint8)
    light = levels / 255
    values = levels if kind is np.uint8 else light.astype(kind) if kind is np.float32 else levels * np.uint16(257)
    kept, encoded = (colors_of(values, 50, linear=linear) for linear in (False, True))
    assert kept is not None
    assert encoded is not None
    np.testing.assert_array_equal(kept[:, :channels], levels)
    np.testing.assert_array_equal(encoded[:, :3], np.rint(to_srgb(light[:, :3]) * 255))
    np.testing.assert_array_equal(kept[:, 3], encoded[:, 3])
    assert (encoded[:, 3] == (levels[:, 3] if channels == 4 else 255)).all()


def test_colours_that_fit_no_mesh_are_omitted() -> None:
    assert colors_of(np.zeros((3, 4), np.uint8), 4, linear=False) is None
    assert colors_of(np.zeros((4, 2), np.uint8), 4, linear=False) is None
    np.testing.assert_array_equal(colors_of(np.full((1, 3), np.nan), 1, linear=True), [[0, 0, 0, 255]])


def test_texture_coordinates_that_fit_no_mesh_are_noted() -> None:
    box = trimesh.creation.box()
    material = trimesh.visual.material.PBRMaterial(
        baseColorTexture=Image.new("RGB", (2, 2)), doubleSided=True, metallicFactor=0
    )
    box.visual = trimesh.visual.TextureVisuals(uv=np.zeros((5, 2)), material=material)
    note = "texture coordinates of mesh 'object' ignored: 5 rows for 8 vertices"
    assert nf.Scene.from_trimesh(box).report.notes == (note,)


def test_gltf_keeps_factor_texture_and_cutoff(tmp_path: Path) -> None:
    image = picture()
    factor = [0.001, 0.25, 1.0, 0.5]  # The first value is below half a step of 8 bits.
    box = textured_box(PBR(baseColorTexture=image, alphaMode="MASK", alphaCutoff=0.3))
    data = box.export(file_type="glb")
    (tmp_path / "box.glb").write_bytes(with_factor(data, factor))
    shape = shape_of(tmp_path / "box.glb")
    (material,) = shape.materials
    # The header keeps all digits; eight bits would be off by 1e-3.
    assert material.factor == pytest.approx(factor, rel=1e-12)
    assert material.cutoff == pytest.approx(0.3)
    assert material.texture is not None
    np.testing.assert_array_equal(material.texture, np.asarray(image))
    assert shape.uvs is not None
    # The file flips v, 1 - v in float32, on writing and on reading.
    np.testing.assert_allclose(shape.uvs, box.visual.uv, atol=1.2e-7)
    report = nf.Scene.load(tmp_path / "box.glb").report
    assert (report.materials, report.textures) == (1, 1)


def with_factor(data: bytes, factor: list[float]) -> bytes:
    """Write a base colour factor into a GLB's JSON, which trimesh stores in 8 bits."""
    (length,) = struct.unpack("<I", data[12:16])
    header = json.loads(data[20 : 20 + length])
    header["materials"][0].setdefault("pbrMetallicRoughness", {})["baseColorFactor"] = factor
    text = json.dumps(header).encode()
    text += b" " * (-len(text) % 4)
    rest = data[20 + length :]
    return data[:8] + struct.pack("<III", 20 + len(text) + len(rest), len(text), 0x4E4F534A) + text + rest


def test_the_diffuse_part_of_specular_glossiness_is_the_base_colour(tmp_path: Path) -> None:
    """A file may also have the base colour of metal–roughness, which the extension replaces."""
    gloss: dict[str, Any] = {"diffuseFactor": [0.5, 0.25, 0.1, 0.75], "specularFactor": [1, 1, 1]}
    fallback = {"baseColorFactor": [0, 1, 0, 1], "baseColorTexture": {"index": 0}, "metallicFactor": 0}
    path = tmp_path / "a.glb"
    for infos in ({"diffuseTexture": {"index": 2}}, {}):
        extensions = {"KHR_materials_pbrSpecularGlossiness": gloss | infos}
        path.write_bytes(gltf([{"pbrMetallicRoughness": fallback, "extensions": extensions, "doubleSided": True}]))
        (material,) = shape_of(path).materials
        assert material.factor == (0.5, 0.25, 0.1, 0.75)
        assert (material.texture is None) == (not infos)
        if material.texture is not None:
            np.testing.assert_array_equal(material.texture, texels(gltf_picture(2, "png")))
        scene = nf.Scene.load(path)
        assert scene.report.notes == ("1 material with metal or gloss drawn matt",)
        nf.lod.export(scene, tmp_path / "written.glb", view=nf.Fov(-1.2, 0.9, -1.1, 1.0))
        (written,) = shape_of(tmp_path / "written.glb").materials
        assert written.factor == pytest.approx(material.factor, rel=1e-6)
        np.testing.assert_array_equal(written.texture, material.texture)


def test_cutoffs_beyond_float32_cut_everything(tmp_path: Path) -> None:
    data = textured_box(PBR(baseColorTexture=picture(), alphaMode="MASK", alphaCutoff=0.125)).export(file_type="glb")
    assert data.count(b'"alphaCutoff":0.125') == 1
    (tmp_path / "box.glb").write_bytes(data.replace(b'"alphaCutoff":0.125', b'"alphaCutoff":9e200'))
    assert shape_of(tmp_path / "box.glb").materials[0].cutoff == pytest.approx(3.4e38, rel=0.01)
    assert nf.Scene.load(tmp_path / "box.glb").triangle_count == 12


def test_vertex_colours_of_gltf_are_linear_and_those_of_ply_srgb(tmp_path: Path) -> None:
    box = trimesh.creation.box()
    colors = np.random.default_rng(2).integers(0, 256, (8, 4), np.uint8)
    box.visual.vertex_colors = colors
    for suffix in ("glb", "ply"):
        box.export(tmp_path / f"box.{suffix}")
    np.testing.assert_array_equal(shape_of(tmp_path / "box.ply").colors, colors)
    encoded = np.rint(to_srgb(colors[:, :3] / 255) * 255)
    shape = shape_of(tmp_path / "box.glb")
    assert shape.colors is not None
    np.testing.assert_array_equal(shape.colors[:, :3], encoded)
    loaded = nf.Scene.from_trimesh(trimesh.load_scene(tmp_path / "box.glb", process=False))
    assert loaded.report.materials == 1


def test_colours_of_faces_become_materials() -> None:
    box = trimesh.creation.box()
    box.visual.face_colors = np.repeat([[255, 0, 0, 255], [0, 128, 0, 255]], 6, axis=0).astype(np.uint8)
    scene = nf.Scene.from_trimesh(box)
    assert scene.report.materials == 2
    assert scene.triangle_count == 12


@pytest.mark.parametrize(
    ("lines", "notes"),
    [
        ("Ks 0.3 0.3 0.3\nNs 50\nTr 0\nd 1\nKe 0 0 0\nPm 0\nillum 2", []),
        ("Ke 1 0.5 0", []),
        ("map_Ke glow.png", ["with a map of emission drawn and saved without it"]),
        ("map_Bump -bm 0.3 bumps.png", ["with a normal map drawn and saved without it"]),
        ("norm n.png\nbump b.png", ["with a normal map drawn and saved without it"]),
        ("map_Ks s.png", ["with a map of metal or gloss drawn and saved without it"]),
        ("Pm 1", ["with metal or gloss drawn matt"]),
        ("Pr 0.2", ["with metal or gloss drawn matt"]),
        ("d 0.5", ["with transparency drawn opaque"]),
        ("Tr 0.5", ["with transparency drawn opaque"]),
        ("d 1\nTr 1", []),
        ("map_d holes.png\nTr x", ["with an opacity map drawn and saved without it"]),
    ],
)
def test_undrawn_properties_of_wavefront_materials_are_noted(lines: str, notes: list[str], tmp_path: Path) -> None:
    (tmp_path / "a.mtl").write_text(f"newmtl m\nKd 0.5 0.4 0.3\n{lines}\n")
    (tmp_path / "a.obj").write_text("mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n")
    assert list(nf.Scene.load(tmp_path / "a.obj").report.notes) == [f"1 material {note}" for note in notes]


def test_wavefront_properties_that_gltf_supports_are_saved(tmp_path: Path) -> None:
    (tmp_path / "a.mtl").write_text("newmtl m\nKd 0.5 0.4 0.3\nKe 1 0.5 0\nPm 0.25\nPr 0.5\nTr 0.75\n")
    (tmp_path / "a.obj").write_text("mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n")
    scene = nf.Scene.load(tmp_path / "a.obj")
    nf.reduce(scene, center=(0, 0, 1), r1=3, r2=4, face_size=8).save(tmp_path / "light")
    header, _ = glb.header((tmp_path / "light" / "near.glb").read_bytes())
    (material,) = header["materials"]
    np.testing.assert_allclose(material["emissiveFactor"], [1.0, 0.21404, 0.0], atol=1e-5)
    surface = material["pbrMetallicRoughness"]
    assert (surface["metallicFactor"], surface["roughnessFactor"], surface["baseColorFactor"][3]) == (0.25, 0.5, 0.25)
    assert (material["alphaMode"], material["doubleSided"]) == ("BLEND", True)


def test_wavefront_materials_are_srgb_with_texture(tmp_path: Path) -> None:
    picture(channels=3).save(tmp_path / "wood.png")
    (tmp_path / "a.mtl").write_text("newmtl wood\nKd 1 1 1\nmap_Kd wood.png\nnewmtl paint\nKd 0.5 0.25 0\n")
    corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
    text = f"mtllib a.mtl\n{corners}usemtl wood\nf 1/1 2/2 3/3\nusemtl paint\nf 3/3 2/2 1/1\n"
    (tmp_path / "a.obj").write_text(text)
    materials = {
        m.texture is not None: m for shape in source_of(tmp_path / "a.obj").shapes.values() for m in shape.materials
    }
    texture = materials[True].texture
    assert texture is not None
    np.testing.assert_array_equal(texture[..., :3], np.asarray(picture(channels=3)))
    # trimesh stores 8 bits of Kd: 128/255 and 64/255.
    np.testing.assert_allclose(materials[False].factor[:3], to_linear(np.array([128, 64, 0]) / 255), atol=1e-12)
    assert nf.Scene.load(tmp_path / "a.obj").report.textures == 1


@pytest.mark.parametrize("mode", ["1", "L", "LA", "P", "RGB", "CMYK", "I;16"])
def test_images_of_every_mode_become_rgba(tmp_path: Path, mode: str) -> None:
    size = (4, 3)
    image = Image.new("I;16", size, 40_000) if mode == "I;16" else picture(channels=3).resize(size).convert(mode)
    suffix = "jpg" if mode == "CMYK" else "png"
    image.save(tmp_path / f"t.{suffix}")
    (tmp_path / "a.mtl").write_text(f"newmtl m\nmap_Kd t.{suffix}\n")
    (tmp_path / "a.obj").write_text(
        "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 1\nusemtl m\nf 1/1 2/2 3/1\n"
    )
    texture = shape_of(tmp_path / "a.obj").materials[0].texture
    assert texture is not None
    assert texture.shape == (3, 4, 4)
    if mode == "I;16":
        assert (texture == (40_000 >> 8, 40_000 >> 8, 40_000 >> 8, 255)).all()


def test_one_image_of_many_materials_is_one_texture(tmp_path: Path) -> None:
    scene = trimesh.Scene()
    for k in range(3):
        material = PBR(baseColorTexture=picture(), baseColorFactor=[80 * k, 0, 0, 255], name=f"m{k}")
        scene.add_geometry(textured_box(material), geom_name=f"g{k}", node_name=f"n{k}")
    scene.export(tmp_path / "a.glb")
    report = nf.Scene.load(tmp_path / "a.glb").report
    assert (report.materials, report.textures) == (3, 1)


def test_a_damaged_image_is_reported(tmp_path: Path) -> None:
    buffer = io.BytesIO()
    picture(size=(64, 64)).save(buffer, "png")
    box = textured_box(PBR(baseColorTexture=picture(size=(64, 64))))
    data = box.export(file_type="glb")
    start = data.index(b"IDAT") + 40
    (tmp_path / "a.glb").write_bytes(data[:start] + bytes(200) + data[start + 200 :])
    report = nf.Scene.load(tmp_path / "a.glb").report
    assert report.textures == 0
    assert "1 material with an unreadable texture drawn without it" in report.notes


def test_sources_without_materials_are_light_grey(tmp_path: Path) -> None:
    trimesh.creation.box().export(tmp_path / "a.stl")
    assert shape_of(tmp_path / "a.stl").materials == []
    assert BaseColor().factor == (1, 1, 1, 1)
