"""The GLB of impostors, read by nearfar, trimesh and glTF's validator."""

from __future__ import annotations

import io
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from PIL import Image

import nearfar as nf
from nearfar._base import glb
from nearfar._impostor.file import Textures
from tests.support import need
from tests.support.impostor_cases import CENTER, SETTINGS, view
from tests.support.reader_cases import node


@pytest.mark.parametrize(("textures", "least"), [("png", 50.0), ("webp", 34.0)])
def test_a_file_looks_like_the_far_part(
    impostors: nf.Impostors, tmp_path: Path, textures: Textures, least: float
) -> None:
    path = tmp_path / "far.glb"
    impostors.save_glb(path, part="far", textures=textures, geometry="plain")
    loaded = nf.Scene.load(path)
    assert loaded.triangle_count == impostors.stats["triangles"]
    found = np.concatenate([mesh.triangles for mesh in trimesh.load_scene(path, process=False).dump()])
    assert impostors.far is not None
    np.testing.assert_allclose(np.sort(found, axis=0), np.sort(impostors.far.triangles() - CENTER, axis=0), atol=1e-5)
    for user, turn in (((0.0, 0.0, 0.0), 0.0), ((-1.2, 0.3, 1.5), 2.0)):
        cameras = [(impostors.far, view(np.add(CENTER, user), turn)), (loaded, view(np.array(user), turn))]
        # Positions about the centre are rounded once more in `far`.
        ours, theirs = (nf.render(shown, camera, samples=4).require("color") for shown, camera in cameras)
        assert nf.psnr(ours, theirs, data_range=1.0) > least


def test_the_file_is_plain_gltf(impostors: nf.Impostors, tmp_path: Path) -> None:
    path = tmp_path / "far.glb"
    impostors.save_glb(path, part="far")
    data = path.read_bytes()
    document, end = glb.header(data)
    region = document["scenes"][0]["extras"]["nearfar"]
    assert region == {"center": list(CENTER), "reach": 2.0, "r2": 12.0, "error_px": 2.0}
    ((node_entry,), (mesh,)) = (document[part] for part in ("nodes", "meshes"))
    assert "matrix" not in node_entry
    modes = [document["materials"][primitive["material"]].get("alphaMode") for primitive in mesh["primitives"]]
    assert modes == [None, "MASK"]
    for primitive in mesh["primitives"]:
        assert set(primitive["attributes"]) == {"POSITION", "TEXCOORD_0"}
    for material in document["materials"]:
        assert "KHR_materials_unlit" in material["extensions"]
    assert document["samplers"] == [{"wrapS": 33071, "wrapT": 33071, "magFilter": 9729, "minFilter": 9729}]
    assert document["extensionsRequired"] == ["EXT_texture_webp"]
    (image,) = document["images"]
    view_entry = document["bufferViews"][image["bufferView"]]
    start = view_entry["byteOffset"]
    with Image.open(io.BytesIO(glb.binary(data, end)[start : start + view_entry["byteLength"]])) as picture:
        assert picture.format == "WEBP"
        assert impostors._quads is not None
        np.testing.assert_array_equal(np.asarray(picture)[..., 3], impostors._quads.atlas[..., 3])
    impostors.save_glb(path, part="far", textures="png")
    assert "extensionsRequired" not in glb.header(path.read_bytes())[0]


def test_bad_files_are_refused(impostors: nf.Impostors, tmp_path: Path) -> None:
    unknown: Any = "jpeg"
    with pytest.raises(ValueError, match="textures: expected"):
        impostors.save_glb(tmp_path / "far.glb", textures=unknown)
    with pytest.raises(ValueError, match="path: expected"):
        impostors.save_glb(tmp_path / "far.obj")
    with pytest.raises(OSError, match="missing"):
        impostors.save_glb(tmp_path / "missing" / "far.glb")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.slow
def test_the_gltf_validator_finds_no_errors(scene: nf.Scene, tmp_path: Path) -> None:
    need("node")
    baked = nf.reduce(scene, far="impostors", **{**SETTINGS, "face_size": 64})
    paths = [tmp_path / f"{textures}.glb" for textures in ("webp", "png")]
    baked.save_glb(paths[0], part="far", textures="webp")
    baked.save_glb(paths[1], part="far", textures="png")
    for report in node("validate.mjs", paths).values():
        messages = [message for message in report["messages"] if message["severity"] < 2]
        assert not messages, messages[:3]
        assert {message["code"] for message in report["messages"]} <= {"UNSUPPORTED_EXTENSION", "IMAGE_NPOT_DIMENSIONS"}
