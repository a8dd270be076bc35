"""Tests of glTF's extensions: undecodable data is an error that names it, never a shape of zeros."""

from __future__ import annotations

import base64
import io
import shutil
from pathlib import Path
from typing import Any
from urllib.parse import quote

import numpy as np
import pytest
from PIL import Image, features

import nearfar as nf
from nearfar._base import data as data_files
from tests.support import need
from tests.support.gltf_cases import MATERIALS, encode, gltf, picture

DRACO = "KHR_draco_mesh_compression"
FOV = nf.Fov(-1.2, 0.9, -1.1, 1.0)
FLOAT, SHORT, UNSIGNED_SHORT, UNSIGNED_BYTE = 5126, 5122, 5123, 5121


def load(folder: Path, data: bytes) -> nf.Scene:
    (folder / "a.glb").write_bytes(data)
    return nf.Scene.load(folder / "a.glb")


def without_decoder(monkeypatch: pytest.MonkeyPatch) -> None:
    from nearfar._scene.gltf import draco

    monkeypatch.setattr(draco, "find_spec", lambda name: None)


def wild(name: str) -> Path:
    need("data")
    folder = data_files.require("wild")
    return next(iter(sorted(folder.rglob(name))))


def mesh_with(**arrays: np.ndarray) -> bytes:
    """A GLB of a mesh with these attributes, normalised if integers."""
    components = {np.float32: FLOAT, np.int16: SHORT, np.uint16: UNSIGNED_SHORT, np.uint8: UNSIGNED_BYTE}
    views: list[dict[str, Any]] = []
    accessors: list[dict[str, Any]] = []
    binary = b""
    for values in arrays.values():
        code = next(code for kind, code in components.items() if values.dtype == kind)
        rows = np.zeros((len(values), -(-values.itemsize * values.shape[1] // 4) * 4), np.uint8)
        rows[:, : values.itemsize * values.shape[1]] = values.view(np.uint8)
        views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": rows.size, "byteStride": rows.shape[1]})
        accessor = {"bufferView": len(accessors), "componentType": code, "count": len(values)}
        accessors.append(accessor | {"type": f"VEC{values.shape[1]}", "normalized": code != FLOAT})
        binary += rows.tobytes()
    names = dict(zip(arrays, range(len(arrays)), strict=True))
    return encode(
        {
            "asset": {"version": "2.0"},
            "extensionsRequired": ["KHR_mesh_quantization"],
            "scenes": [{"nodes": [0]}],
            "nodes": [{"mesh": 0}],
            "meshes": [{"primitives": [{"attributes": names, "material": 0}]}],
            "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
            "textures": [{"source": 0}],
            "images": [{"uri": f"data:image/png;base64,{base64.b64encode(picture(0, 'png')).decode()}"}],
            "accessors": accessors,
            "bufferViews": views,
            "buffers": [{"byteLength": len(binary)}],
        },
        binary,
    )


def test_draco_without_a_decoder_is_an_error(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Files that only use the extension have accessors without data, which are zeros."""
    without_decoder(monkeypatch)
    compressed = [{"primitives": [{"attributes": {"POSITION": 0}, "extensions": {DRACO: {"bufferView": 0}}}]}]
    bare = [{"componentType": FLOAT, "count": 3, "type": "VEC3"}]
    for lists in ({"extensionsUsed": [DRACO]}, {"extensionsRequired": [DRACO]}, {}):
        with pytest.raises(nf.SceneError, match=r"a\.glb: it needs the extension KHR_draco.*pip"):
            load(tmp_path, gltf([], meshes=compressed, nodes=[{"mesh": 0}], accessors=bare, **lists))
    # A file with plain data besides the compressed data needs no decoder.
    plain = [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 2, "extensions": {DRACO: {"bufferView": 0}}}]}]
    scene = load(tmp_path, gltf([], meshes=plain, nodes=[{"mesh": 0}], scenes=[{"nodes": [0]}]))
    np.testing.assert_array_equal(scene.bounds, [[0, 0, 0], [1, 1, 0]])


def test_extensions_that_would_give_zeros_are_an_error(tmp_path: Path) -> None:
    compressed = [{"primitives": [{"attributes": {"POSITION": 0}, "extensions": {"ACME_squeeze": {}}}]}]
    bare = [{"componentType": FLOAT, "count": 3, "type": "VEC3"}]
    with pytest.raises(nf.SceneError, match="its extension ACME_squeeze was not decoded"):
        load(tmp_path, gltf([], meshes=compressed, nodes=[{"mesh": 0}], scenes=[{"nodes": [0]}], accessors=bare))


@pytest.mark.parametrize(
    ("lists", "error"),
    [
        ({"extensionsRequired": ["ACME_gizmo"]}, "it needs the extension ACME_gizmo, which is not read"),
        ({"extensionsRequired": ["MSFT_texture_dds"]}, "MSFT_texture_dds, which is not read: save its textures"),
        ({"extensionsRequired": ["KHR_texture_basisu"]}, None),
        ({"extensionsUsed": ["ACME_gizmo"]}, None),
        ({"extensionsRequired": ["KHR_lights_punctual"]}, None),
        ({"extensionsRequired": ["KHR_materials_clearcoat", "KHR_texture_transform"]}, None),
    ],
)
def test_required_extensions_are_read_or_an_error(tmp_path: Path, lists: dict[str, Any], error: str | None) -> None:
    data = gltf(MATERIALS, **lists)
    if error is not None:
        with pytest.raises(nf.SceneError, match=error):
            load(tmp_path, data)
        return
    notes = load(tmp_path, data).report.notes
    for name in [*lists.get("extensionsUsed", []), *lists.get("extensionsRequired", [])]:
        is_noted_elsewhere = name.startswith(("KHR_materials_", "KHR_texture_"))
        assert (f"extension {name} ignored" in notes) != is_noted_elsewhere


def test_meshopt_with_a_fallback_is_read_without_a_decoder(tmp_path: Path) -> None:
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 2, 0]], np.float32).tobytes()
    compressed = {"EXT_meshopt_compression": {"buffer": 0, "byteLength": 5, "mode": "ATTRIBUTES", "count": 3}}
    (tmp_path / "fallback.bin").write_bytes(corners)
    changes: dict[str, Any] = {
        "extensionsUsed": ["EXT_meshopt_compression"],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "nodes": [{"mesh": 0}],
        "scenes": [{"nodes": [0]}],
        "accessors": [{"bufferView": 0, "componentType": FLOAT, "count": 3, "type": "VEC3"}],
        "bufferViews": [{"buffer": 1, "byteLength": 36, "extensions": compressed}],
    }
    fallback = {"byteLength": 36, "extensions": {"EXT_meshopt_compression": {"fallback": True}}}
    with pytest.raises(nf.SceneError, match="lacks an entry that it needs: byteStride"):
        load(tmp_path, gltf([], **changes, textures=[], images=[], buffers=[{"byteLength": 4}, fallback]))
    fallback["uri"] = "fallback.bin"
    scene = load(tmp_path, gltf([], **changes, textures=[], images=[], buffers=[{"byteLength": 4}, fallback]))
    np.testing.assert_array_equal(scene.bounds, [[0, 0, 0], [1, 2, 0]])


def test_quantised_meshes_keep_shape_and_texture_coordinates(tmp_path: Path) -> None:
    corners = np.array([[-1, 0, 0.5], [1, 0, 0.5], [0, 1, -0.25]])
    uvs = np.array([[0, 0.25], [1, 0.5], [0.5, 1]])
    normals = np.array([[0, 0, 1], [0, 1, 0], [1, 0, 0]])
    scene = load(
        tmp_path,
        mesh_with(
            POSITION=np.rint(corners * 32767).astype(np.int16),
            TEXCOORD_0=np.rint(uvs * 65535).astype(np.uint16),
            NORMAL=np.rint(normals * 32767).astype(np.int16),
        ),
    )
    parts = nf._core.mesh_parts(scene._core.merged())
    np.testing.assert_allclose(parts["positions"], corners, atol=2e-5)
    np.testing.assert_allclose(parts["uvs"], uvs * [1, -1] + [0, 1], atol=1e-5)
    np.testing.assert_allclose(parts["normals"], normals, atol=1e-4)
    assert scene.report.notes[-1] == "1 material with single-sided faces drawn from both sides"


def test_sparse_accessors_replace_rows(tmp_path: Path) -> None:
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 2, 0]], np.float32)
    binary = corners.tobytes() + np.array([2, 0], np.uint16).tobytes() + np.full(3, 5, np.float32).tobytes()
    views = [{"buffer": 0, "byteOffset": start, "byteLength": length} for start, length in ((0, 36), (36, 4), (40, 12))]
    sparse: dict[str, Any] = {
        "count": 1,
        "indices": {"bufferView": 1, "componentType": UNSIGNED_SHORT},
        "values": {"bufferView": 2},
    }
    document: dict[str, Any] = {
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"bufferView": 0, "componentType": FLOAT, "count": 3, "type": "VEC3", "sparse": sparse}],
        "bufferViews": views,
        "buffers": [{"byteLength": len(binary)}],
    }
    scene = load(tmp_path, encode(document, binary))
    np.testing.assert_array_equal(scene.triangles()[0], [[0, 0, 0], [1, 0, 0], [5, 5, 5]])
    del document["accessors"][0]["bufferView"]
    scene = load(tmp_path, encode(document, binary))
    np.testing.assert_array_equal(scene.triangles()[0], [[0, 0, 0], [0, 0, 0], [5, 5, 5]])
    sparse["count"] = 9
    with pytest.raises(nf.SceneError, match="refers to an item that it does not contain"):
        load(tmp_path, encode(document, binary))
    # NumPy would count a negative row from the end.
    sparse |= {"count": 1, "indices": {"bufferView": 1, "componentType": SHORT}}
    binary = binary[:36] + np.array([-1, 0], np.int16).tobytes() + binary[40:]
    with pytest.raises(nf.SceneError, match="a sparse accessor changes a row that does not exist among its 3"):
        load(tmp_path, encode(document, binary))


@pytest.mark.parametrize("kind", ["webp", "avif"])
def test_textures_of_extensions_are_drawn_and_exported(tmp_path: Path, kind: str) -> None:
    if not features.check(kind):
        pytest.skip(f"Pillow was built without {kind}")
    file = io.BytesIO()
    Image.new("RGB", (4, 4), (250, 20, 30)).save(file, kind)
    (tmp_path / f"red.{kind}").write_bytes(file.getvalue())
    name = f"EXT_texture_{kind}"
    data = gltf(
        [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}, "normalTexture": {"index": 0}}],
        textures=[{"extensions": {name: {"source": 0}}}],
        images=[{"uri": f"red.{kind}"}],
        extensionsRequired=[name],
    )
    scene = load(tmp_path, data)
    assert scene.report.textures == 1
    assert not any("texture" in note for note in scene.report.notes)
    nf.lod.export(scene, tmp_path / "written.glb", view=FOV)
    again = nf.Scene.load(tmp_path / "written.glb")
    assert again.report.notes == scene.report.notes
    assert file.getvalue() in (tmp_path / "written.glb").read_bytes()


def test_file_names_may_be_percent_encoded(tmp_path: Path) -> None:
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 2, 0]], np.float32).tobytes()
    (tmp_path / "ein Würfel.bin").write_bytes(corners)
    changes = {"buffers": [{"byteLength": 36, "uri": quote("ein Würfel.bin")}]}
    views = [{"buffer": 0, "byteLength": 36}]
    meshes = [{"primitives": [{"attributes": {"POSITION": 0}}]}]
    accessors = [{"bufferView": 0, "componentType": FLOAT, "count": 3, "type": "VEC3"}]
    scene = load(
        tmp_path,
        gltf([], **changes, bufferViews=views, meshes=meshes, accessors=accessors, nodes=[{"mesh": 0}],
             scenes=[{"nodes": [0]}], images=[], textures=[]),
    )  # fmt: skip
    assert scene.triangle_count == 1


@pytest.mark.parametrize("name", ["BoxDraco.gltf", "CesiumMilkTruck.gltf", "DracoSparseMesh.gltf"])
def test_real_draco_files_are_right_or_an_error(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    path = wild(name)
    with monkeypatch.context() as patch:
        without_decoder(patch)
        with pytest.raises(nf.SceneError, match=f"{name}: .*{DRACO}.*pip install .nearfar.formats"):
            nf.Scene.load(path)
    need("DracoPy")
    scene = nf.Scene.load(path)
    if name == "BoxDraco.gltf":
        np.testing.assert_allclose(scene.bounds, [[-0.5] * 3, [0.5] * 3], atol=1e-3)
        assert scene.triangle_count == 12
    assert (np.diff(scene.bounds, axis=0) > 0).all()


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("basic.glb", "KHR_gaussian_splatting"),
        ("ACMEBox.gltf", "ACME_gizmo"),
    ],
)
def test_real_files_with_unsupported_extensions_are_errors(name: str, words: str) -> None:
    with pytest.raises(nf.SceneError, match=f"{name}: it needs the extension {words}"):
        nf.Scene.load(wild(name))


def test_real_files_with_percent_encoded_names_load(tmp_path: Path) -> None:
    path = wild("Unicode*Test.gltf")
    shutil.copytree(path.parent, tmp_path / "copy")
    assert nf.Scene.load(tmp_path / "copy" / path.name).report.textures == 1
