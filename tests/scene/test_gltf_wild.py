"""Every glTF file of the test data of cesium-native and glTF-Transform: its triangles, its picture, and its notes."""

from __future__ import annotations

import io
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from PIL import Image

import nearfar as nf
from nearfar._base import data as data_files
from tests.support import need
from tests.support.gltf_oracle import Document

SINGLE = "1 material with single-sided faces drawn from both sides"
FOUR = "4 materials with single-sided faces drawn from both sides"
FEATURES, METADATA = "extension EXT_mesh_features ignored", "extension EXT_structural_metadata ignored"
DUCK = "DucksMeshopt/Duck"
META = "EXT_structural_metadata"

LOADED: dict[str, tuple[int, int, tuple[str, ...]]] = {
    "InvalidFeatureTable/Triangle.glb": (1, 0, ()),
    "BoxTextured/BoxTextured.gltf": (12, 1, (SINGLE,)),
    "BoxTexturedWebp/BoxTexturedWebp.gltf": (12, 1, (SINGLE,)),
    "DracoCompressed/CesiumMilkTruck.gltf": (3624, 1, ("1 animation ignored", FOUR)),
    f"{DUCK}.glb": (4212, 1, ("1 camera ignored", SINGLE)),
    **{f"{DUCK}-vp-{n}-vt-{n}-vn-{n}.glb": (4212, 1, ("1 camera ignored", SINGLE)) for n in (3, 6, 9, 12, 15)},
    "MeshPrimitiveModes/MeshPrimitiveModes.gltf": (16, 0, ("1 point primitive ignored", "3 line primitives ignored")),
    "TriangleWithPaddingInGlbBin/TriangleWithPaddingInGlbBin.glb": (1, 0, ()),
    "glTF-Embedded/TriangleWithoutIndices.gltf": (1, 0, ()),
    "in/chr_knight.glb": (1460, 1, (SINGLE,)),
    "BoxTextured_glTF/BoxTextured.gltf": (12, 1, (SINGLE,)),
    "BoxTextured_glTF-pbrSpecularGlossiness/BoxTextured.gltf": (
        12,
        1,
        ("1 material with metal or gloss drawn matt", SINGLE),
    ),
    "in/BoxVertexColors.glb": (
        12,
        0,
        ("1 material with metal or gloss drawn matt", SINGLE, "1 mesh with vertex alpha below 1 drawn opaque"),
    ),
    "Box_glTF/Box.gltf": (12, 0, (SINGLE,)),
    "Box_glTF-Binary/Box.glb": (12, 0, (SINGLE,)),
    "Box_glTF-Embedded/Box.gltf": (12, 0, (SINGLE,)),
    "EncodingTest/Unicode ❤♻ Test.gltf": (2, 1, (SINGLE,)),
    "in/BoxDraco.gltf": (12, 0, (SINGLE,)),
    "in/BoxMeshopt.glb": (12, 0, (SINGLE,)),
    "in/BoxMeshopt.gltf": (12, 0, (SINGLE,)),
    "in/DracoSparseMesh.gltf": (102, 0, ("1 set of tangents ignored",)),
    "EXT_mesh_features/FeatureIdAttribute.gltf": (8, 0, (FEATURES,)),
    "EXT_mesh_features/FeatureIdTexture.gltf": (2, 1, (FEATURES,)),
    f"{META}/ComplexTypes.gltf": (8, 0, (FEATURES, METADATA)),
    f"{META}/FeatureIdAttributeAndPropertyTable.gltf": (8, 0, (FEATURES, METADATA)),
    f"{META}/FeatureIdTextureAndPropertyTable.gltf": (2, 1, (FEATURES, METADATA)),
    f"{META}/MultipleClasses.gltf": (8, 0, (FEATURES, METADATA)),
    f"{META}/MultipleFeatureIdsAndProperties.gltf": (8, 0, (FEATURES, METADATA)),
    f"{META}/SharedPropertyTable.gltf": (16, 0, (FEATURES, METADATA)),
    f"{META}/SimplePropertyTexture.gltf": (2, 1, (METADATA,)),
}
"""Triangles, textures and notes of the loadable files, by suffix of their paths."""

REFUSED = {
    "SpzSplat/basic.glb": "it needs the extension KHR_gaussian_splatting, which is not read",
    "StyledPoints/BENTLEY_materials_point_style.gltf": "no triangles; 4 point primitives ignored",
    "in/ACMEBox.gltf": "it needs the extension ACME_gizmo, which is not read",
}

COMPRESSED = ("Draco", "Meshopt.", "Duck-vp")
"""Parts of names of files whose arrays the oracle does not read; other tests compare them with plain ones."""


def wild() -> list[Path]:
    need("data")
    files = data_files.require("wild").rglob("*")
    return sorted(path for path in files if path.suffix in (".glb", ".gltf"))


def find(name: str) -> Path:
    (path,) = (path for path in wild() if path.as_posix().endswith(f"/{name}"))
    return path


def rows(triangles: Any) -> NDArray[Any]:
    """Triangles (N, 9) with their least corner first, ordered by centroid, all to 1e-5."""
    corners = np.round(np.asarray(triangles, np.float64), 5) + 0.0
    turned = []
    for face in corners:
        first = min(range(3), key=lambda corner: tuple(face[corner]))
        turned.append(np.roll(face, -first, axis=0).ravel())
    found = np.array(turned)
    return found[np.lexsort(found.T[::-1])]


def test_all_files_are_in_the_lists() -> None:
    names = [*LOADED, *REFUSED]
    for path in wild():
        assert sum(path.as_posix().endswith(f"/{name}") for name in names) == 1, path
    assert len(wild()) == len(names)


@pytest.mark.parametrize("name", list(LOADED))
def test_files_load_with_their_notes(name: str) -> None:
    need("DracoPy") if "Draco" in name else None
    triangles, textures, notes = LOADED[name]
    scene = nf.Scene.load(find(name))
    assert (scene.triangle_count, scene.report.textures) == (triangles, textures)
    assert scene.report.notes == notes


@pytest.mark.parametrize("name", list(REFUSED))
def test_unsupported_files_are_refused_with_a_reason(name: str) -> None:
    with pytest.raises(nf.SceneError, match=REFUSED[name]):
        nf.Scene.load(find(name))


@pytest.mark.parametrize("name", [name for name in LOADED if not any(part in name for part in COMPRESSED)])
def test_triangles_equal_a_slow_reader(name: str) -> None:
    found, expected = rows(nf.Scene.load(find(name)).triangles()), rows(Document(find(name)).triangles())
    # One step of the rounding, where a number lies between two.
    np.testing.assert_allclose(found, expected, atol=1.1e-5)


TEXTURED = [name for name, (_, textures, _) in LOADED.items() if textures and "SpecularGlossiness" not in name]


@pytest.mark.parametrize("name", TEXTURED)
def test_textures_equal_pillow(name: str) -> None:
    need("DracoPy") if "Draco" in name else None
    document = Document(find(name))
    materials = document.json["materials"]
    surfaces = [material.get("pbrMetallicRoughness", {}) for material in materials]
    infos = [surface["baseColorTexture"] for surface in surfaces if "baseColorTexture" in surface]
    texture = document.json["textures"][infos[0]["index"]]
    sources = [content["source"] for content in texture.get("extensions", {}).values()]
    number = texture["source"] if "source" in texture else sources[0]
    with Image.open(io.BytesIO(document.image(number))) as opened:
        expected = np.asarray(opened.convert("RGBA"))
    (found,) = nf._core.scene_parts(nf.Scene.load(find(name))._core)["textures"]
    np.testing.assert_array_equal(found, expected)


@pytest.mark.parametrize("kind", ["lossy", "lossless"])
def test_real_webp_is_read(kind: str, tmp_path: Path) -> None:
    from tests.support.ktx2_cases import glb

    data = find("in/BoxDraco.gltf").with_name(f"test-{kind}.webp").read_bytes()
    name = "EXT_texture_webp"
    changes: dict[str, Any] = {"textures": [{"extensions": {name: {"source": 0}}}], "extensionsRequired": [name]}
    (tmp_path / "a.glb").write_bytes(glb(data, **changes))
    (found,) = nf._core.scene_parts(nf.Scene.load(tmp_path / "a.glb")._core)["textures"]
    with Image.open(io.BytesIO(data)) as opened:
        np.testing.assert_array_equal(found, np.asarray(opened.convert("RGBA")))
