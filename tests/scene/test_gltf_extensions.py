"""Tests of glTF's extensions: undecodable data is an error that names it, never a shape of zeros."""

from __future__ import annotations

import io
from pathlib import Path
from typing import Any
from urllib.parse import quote

import numpy as np
import pytest
from PIL import Image, features

import nearfar as nf
from tests.support.gltf_cases import MATERIALS, gltf, load, triangle

DRACO = "KHR_draco_mesh_compression"
FOV = nf.Fov(-1.2, 0.9, -1.1, 1.0)
FLOAT, SHORT, UNSIGNED_SHORT = 5126, 5122, 5123


def without_decoder(monkeypatch: pytest.MonkeyPatch) -> None:
    from nearfar._scene.gltf import draco

    monkeypatch.setattr(draco, "find_spec", lambda name: None)


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


def test_sparse_accessors_replace_rows(tmp_path: Path) -> None:
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 2, 0]], np.float32)
    binary = corners.tobytes() + np.array([2, 0], np.uint16).tobytes() + np.full(3, 5, np.float32).tobytes()
    views = [{"buffer": 0, "byteOffset": start, "byteLength": length} for start, length in ((0, 36), (36, 4), (40, 12))]
    sparse: dict[str, Any] = {
        "count": 1,
        "indices": {"bufferView": 1, "componentType": UNSIGNED_SHORT},
        "values": {"bufferView": 2},
    }
    accessor = {"bufferView": 0, "componentType": FLOAT, "count": 3, "type": "VEC3", "sparse": sparse}
    entries: dict[str, Any] = {
        "accessors": [accessor], "bufferViews": views, "buffers": [{"byteLength": len(binary)}],
    }  # fmt: skip
    scene = load(tmp_path, triangle(binary, **entries))
    np.testing.assert_array_equal(scene.triangles()[0], [[0, 0, 0], [1, 0, 0], [5, 5, 5]])
    del accessor["bufferView"]
    scene = load(tmp_path, triangle(binary, **entries))
    np.testing.assert_array_equal(scene.triangles()[0], [[0, 0, 0], [0, 0, 0], [5, 5, 5]])
    sparse["count"] = 9
    with pytest.raises(nf.SceneError, match="refers to an item that it does not contain"):
        load(tmp_path, triangle(binary, **entries))
    # NumPy would count a negative row from the end.
    sparse |= {"count": 1, "indices": {"bufferView": 1, "componentType": SHORT}}
    binary = binary[:36] + np.array([-1, 0], np.int16).tobytes() + binary[40:]
    with pytest.raises(nf.SceneError, match="a sparse accessor changes a row that does not exist among its 3"):
        load(tmp_path, triangle(binary, **entries))


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
    assert load(tmp_path, triangle(buffers=[{"byteLength": 36, "uri": quote("ein Würfel.bin")}])).triangle_count == 1
