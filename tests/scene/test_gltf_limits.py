"""glTF files with very many parts, and parts that claim more than the file has: errors, before memory is allocated."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from tests.support.gltf_cases import CORNERS, gltf, load, triangle

FLOAT = 5126


def many(number: int) -> bytes:
    """A thousand triangles that share one long array of vertices, each in a separate mesh."""
    vertices = np.zeros((number, 3), np.float32)
    vertices[: len(CORNERS)] = CORNERS
    faces = np.array([0, 1, 2], np.uint32)
    accessors = [
        {"bufferView": 0, "componentType": FLOAT, "count": number, "type": "VEC3"},
        {"bufferView": 1, "componentType": 5125, "count": 3, "type": "SCALAR"},
    ]
    return triangle(
        vertices.tobytes() + faces.tobytes(),
        scenes=[{"nodes": list(range(1000))}],
        nodes=[{"mesh": mesh} for mesh in range(1000)],
        meshes=[{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]} for _ in range(1000)],
        accessors=accessors,
        bufferViews=[
            {"buffer": 0, "byteLength": vertices.nbytes},
            {"buffer": 0, "byteOffset": vertices.nbytes, "byteLength": faces.nbytes},
        ],
        buffers=[{"byteLength": vertices.nbytes + faces.nbytes}],
    )


def test_triangles_keep_only_their_vertices_of_shared_arrays(tmp_path: Path) -> None:
    scene = load(tmp_path, many(100_000))
    assert scene.triangle_count == 1000
    np.testing.assert_array_equal(scene.triangles()[999], CORNERS)
    # Otherwise a thousand copies of 1.2 MB would be merged.
    assert load(tmp_path, many(100_000), max_bytes=1 << 20).triangle_count == 1000


def test_repeated_arrays_count_towards_the_limit(tmp_path: Path) -> None:
    vertices = np.zeros((30_000, 3), np.float32)
    accessor = {"bufferView": 0, "componentType": FLOAT, "count": len(vertices), "type": "VEC3"}
    content = triangle(
        vertices.tobytes(),
        meshes=[{"primitives": [{"attributes": {"POSITION": number}} for number in range(2000)]}],
        accessors=[accessor] * 2000,
        bufferViews=[{"buffer": 0, "byteLength": vertices.nbytes}],
        buffers=[{"byteLength": vertices.nbytes}],
    )
    with pytest.raises(nf.SceneError, match=r"a\.glb: it unpacks to more than 268,435,456 bytes"):
        load(tmp_path, content)


def test_claimed_rows_of_sparse_accessors_count_towards_the_limit(tmp_path: Path) -> None:
    sparse = {"count": 1, "indices": {"bufferView": 0, "componentType": 5125}, "values": {"bufferView": 0}}
    accessor = {"componentType": FLOAT, "count": 10**9, "type": "VEC3", "sparse": sparse}
    with pytest.raises(nf.SceneError, match="it unpacks to more than 268,435,456 bytes"):
        load(tmp_path, triangle(accessors=[accessor]))


def test_copies_of_flat_instances_count_towards_the_limit(tmp_path: Path) -> None:
    """Instances without an inverse are merged, each as a copy."""
    vertices = np.random.default_rng(0).random((30_000, 3)).astype(np.float32)
    accessor = {"bufferView": 0, "componentType": FLOAT, "count": len(vertices), "type": "VEC3"}
    content = triangle(
        vertices.tobytes(),
        scenes=[{"nodes": list(range(800))}],
        nodes=[{"mesh": 0, "scale": [1, 1, 0]}] * 800,
        accessors=[accessor],
        bufferViews=[{"buffer": 0, "byteLength": vertices.nbytes}],
        buffers=[{"byteLength": vertices.nbytes}],
    )
    with pytest.raises(nf.SceneError, match="it unpacks to more than 268,435,456 bytes"):
        load(tmp_path, content)


def test_images_that_many_textures_share_are_kept_once(tmp_path: Path) -> None:
    textured = [
        {"pbrMetallicRoughness": {"baseColorFactor": [n / 500, 0, 0, 1], "baseColorTexture": {"index": n}}}
        for n in range(500)
    ]
    images = [{"bufferView": 3, "mimeType": "image/png"}] * 500
    scene = load(tmp_path, gltf(textured, images=images, textures=[{"source": n} for n in range(500)]))
    assert (scene.report.materials, scene.report.textures) == (500, 1)


def test_many_nodes_have_the_files_transforms(tmp_path: Path) -> None:
    places = np.random.default_rng(1).integers(-1000, 1000, (5_000, 3))
    nodes = [{"mesh": 0, "translation": place} for place in places.tolist()]
    scene = load(tmp_path, triangle(nodes=nodes, scenes=[{"nodes": list(range(len(nodes)))}]))
    firsts = np.sort(scene.triangles()[:, 0].astype(np.int64), axis=0)
    np.testing.assert_array_equal(firsts, np.sort(places, axis=0))


def test_long_chains_of_nodes_multiply_their_transforms(tmp_path: Path) -> None:
    nodes: list[dict[str, Any]] = [{"translation": [0.5, 0, 0], "children": [n + 1]} for n in range(10_000)]
    nodes.append({"mesh": 0, "rotation": [0, 0, 1, 0], "scale": [2, 1, 1], "name": "end"})
    scene = load(tmp_path, triangle(nodes=nodes))
    np.testing.assert_allclose(scene.bounds, [[4_998, -1, 0], [5_000, 0, 0]], atol=1e-3)
    assert scene.object_names == ("end",)


def test_equal_names_get_unique_numbers(tmp_path: Path) -> None:
    nodes = [{"mesh": 0, "name": name} for name in ("a", "a_1", "a", "a", "a_1")]
    scene = load(tmp_path, triangle(nodes=nodes, scenes=[{"nodes": [0, 1, 2, 3, 4]}]))
    assert scene.object_names == ("a", "a_1", "a_2", "a_3", "a_1_1")


def test_sparse_indices_are_read(tmp_path: Path) -> None:
    quad = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], np.float32)
    indices = {"componentType": 5125, "count": 3, "type": "SCALAR"}
    # Rows 1 and 2 become 2 and 3.
    sparse = {"count": 2, "indices": {"bufferView": 1, "componentType": 5125}, "values": {"bufferView": 2}}
    content = triangle(
        quad.tobytes() + np.array([1, 2, 2, 3], np.uint32).tobytes(),
        meshes=[{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        accessors=[{"bufferView": 0, "componentType": FLOAT, "count": 4, "type": "VEC3"}, indices | {"sparse": sparse}],
        bufferViews=[{"buffer": 0, "byteOffset": at, "byteLength": size} for at, size in ((0, 48), (48, 8), (56, 8))],
        buffers=[{"byteLength": 64}],
    )
    np.testing.assert_array_equal(load(tmp_path, content).triangles()[0], quad[[0, 2, 3]])
