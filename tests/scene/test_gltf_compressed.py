"""glTF files compressed by meshoptimizer: the original arrays, or an error that names the file."""

from __future__ import annotations

import base64
from collections import Counter
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from tests.support import data, need
from tests.support.gltf_cases import decode, encode, load, picture
from tests.support.meshopt_cases import EXTENSION, Stream, attributes, glb, indices, triangles
from tests.support.refused import refusals

DUCKS = "wild/cesium-native/CesiumGltfReader/test/data/DucksMeshopt"
BOXES = "wild/glTF-Transform/packages"
CORNERS = np.array([[0, 0, 0], [1, 0, 0], [0, -1.5, 0], [3, 2, 1]], np.float32)
FACES = np.array([[0, 1, 2], [3, 2, 1]], np.uint16)
PLAIN = [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}]


def square(faces: Stream | None = None) -> list[Stream]:
    return [attributes(CORNERS), faces or triangles(FACES)]


def count_triangles(corners: NDArray[Any]) -> Counter[Any]:
    """Counts of triangles (N, 3, 3), rounded to integers, in any order and with any corner first."""
    faces = np.rint(corners).astype(np.int64).tolist()
    return Counter(min((a, b, c), (b, c, a), (c, a, b)) for a, b, c in (map(tuple, face) for face in faces))


@pytest.mark.parametrize("name", [EXTENSION, "KHR_meshopt_compression"])
@pytest.mark.parametrize("kind", [np.uint16, np.uint32])
def test_rows_and_indices_are_decoded(tmp_path: Path, name: str, kind: type[np.generic]) -> None:
    for faces in (triangles(FACES.astype(kind)), indices(FACES.astype(kind).ravel())):
        scene = load(tmp_path, glb(square(faces), name=name, meshes=PLAIN))
        np.testing.assert_array_equal(scene.triangles(), CORNERS[FACES])
        assert scene.report.notes == ()


@pytest.mark.parametrize("count", [1, 15, 16, 17, 255, 256, 257, 1000])
def test_blocks_of_every_length_are_decoded(tmp_path: Path, count: int) -> None:
    corners = np.random.default_rng(count).normal(size=(3 * count, 3)).astype(np.float32)
    meshes = [{"primitives": [{"attributes": {"POSITION": 0}}]}]
    scene = load(tmp_path, glb([attributes(corners)], meshes=meshes))
    np.testing.assert_array_equal(scene.triangles(), corners.reshape(-1, 3, 3))


@pytest.mark.parametrize("kind", [np.int8, np.uint8, np.int16, np.uint16])
@pytest.mark.parametrize("normalized", [True, False])
def test_integers_of_every_type_are_coordinates(tmp_path: Path, kind: type[np.integer[Any]], normalized: bool) -> None:
    limits = np.iinfo(kind)
    numbers = np.array([[limits.min, 0, limits.max], [limits.max, 1, 0], [limits.min + 1, 7, 9]], kind)
    uvs = np.abs(numbers[:, :2] // 2).astype(kind)
    primitive = {"attributes": {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2}, "material": 0}
    maps = {"normalTexture": {"index": 0}}
    scene = load(
        tmp_path,
        glb(
            [attributes(rows, normalized=normalized) for rows in (numbers, numbers, uvs)],
            meshes=[{"primitives": [primitive]}],
            materials=[maps],
            textures=[{"source": 0}],
            images=[{"uri": f"data:image/png;base64,{base64.b64encode(picture(0, 'png')).decode()}"}],
        ),
    )
    # Equation of glTF 2.0, 3.11: the least signed number counts as −1.
    expected = np.maximum(numbers / limits.max, -1) if normalized else numbers.astype(np.float64)
    parts = nf._core.mesh_parts(scene._core.merged())
    np.testing.assert_allclose(parts["positions"] + scene.origin, expected, rtol=1e-6)
    normals = expected / np.linalg.norm(expected, axis=1, keepdims=True)
    np.testing.assert_allclose(parts["normals"], normals, atol=1e-6)
    shown = uvs / limits.max if normalized else uvs.astype(np.float64)
    np.testing.assert_allclose(parts["uvs"], shown * [1, -1] + [0, 1], rtol=1e-6)


def test_filters_are_applied(tmp_path: Path) -> None:
    # Exponent in the highest byte, and mantissa: 3 · 2⁻¹ is 1.5.
    mantissas = np.array([[0, 0, 0], [1, 0, 0], [0, -3, 0], [3, 2, 1]])
    exponents = np.array([[0, 0, 0], [0, 0, 0], [0, -1, 0], [0, 0, 0]])
    words = (exponents << 24 | mantissas & 0xFFFFFF).astype(np.int64).astype(np.uint32)
    # The first three rows of meshoptimizer's own test of octahedral vectors.
    octahedral = np.array([[0, 1, 127, 0], [0, 187, 127, 1], [255, 1, 127, 0], [0, 0, 127, 0]], np.uint8).view(np.int8)
    vectors = np.array([[0, 1, 127], [0, 159 - 256, 82], [-1, 1, 127], [0, 0, 127]])
    primitive = {"attributes": {"POSITION": 0, "NORMAL": 2}, "indices": 1}
    normals = attributes(octahedral, filter="OCTAHEDRAL", normalized=True, type="VEC3")
    positions = attributes(words, filter="EXPONENTIAL", componentType=5126)
    scene = load(tmp_path, glb([positions, triangles(FACES), normals], meshes=[{"primitives": [primitive]}]))
    np.testing.assert_array_equal(scene.triangles(), CORNERS[FACES])
    parts = nf._core.mesh_parts(scene._core.merged())
    np.testing.assert_allclose(parts["normals"], vectors / np.linalg.norm(vectors, axis=1, keepdims=True), atol=1e-6)


@pytest.mark.parametrize("bits", [3, 6, 9, 12, 15])
def test_real_ducks_have_the_triangles_of_the_plain_one(bits: int) -> None:
    """The plain file rounded to the grid of the compressed one, which its node scales and moves."""
    path = data(f"{DUCKS}/Duck-vp-{bits}-vt-{bits}-vn-{bits}.glb")
    plain, packed = nf.Scene.load(path.with_name("Duck.glb")), nf.Scene.load(path)
    assert packed.triangle_count == plain.triangle_count == 4212
    node = decode(path)[0]["nodes"][0]
    step = node["scale"][0]

    def whole(scene: nf.Scene) -> NDArray[Any]:
        return np.asarray((scene.triangles() - node["translation"]) / step)

    found = whole(packed)
    # Two of 2¹⁵ steps of float32's 2²³ at coordinates near 1.
    np.testing.assert_allclose(found, np.rint(found), atol=2.0**-7)
    # Coordinates that lie halfway between two steps may be rounded to either.
    assert (count_triangles(found) & count_triangles(whole(plain))).total() > 0.98 * 4212
    np.testing.assert_allclose(packed.bounds, plain.bounds, atol=step)


@pytest.mark.parametrize("name", ["BoxMeshopt.glb", "BoxMeshopt.gltf"])
def test_real_boxes_have_the_triangles_of_the_plain_one(name: str) -> None:
    packed = nf.Scene.load(data(f"{BOXES}/extensions/test/in/{name}"))
    plain = nf.Scene.load(data(f"{BOXES}/core/test/in/Box_glTF-Binary/Box.glb"))
    # All corners are ±0.5; both files hold them to 2⁻¹⁴ at least.
    assert count_triangles(2 * packed.triangles()) == count_triangles(2 * plain.triangles())
    np.testing.assert_allclose(packed.bounds, [[-0.5] * 3, [0.5] * 3], atol=2.0**-13)


def test_plain_bytes_are_preferred_to_compressed_ones(tmp_path: Path) -> None:
    """A view whose buffer has bytes needs no decoder, so damage to the stream does not matter."""
    stream = replace(attributes(CORNERS), data=b"none")
    document, binary = decode(glb([stream, triangles(FACES)], meshes=PLAIN))
    document["buffers"][1] |= {"uri": "plain.bin"}
    (tmp_path / "plain.bin").write_bytes(CORNERS.tobytes() + FACES.tobytes())
    np.testing.assert_array_equal(load(tmp_path, encode(document, binary)).triangles(), CORNERS[FACES])


def square_with(**changes: Any) -> bytes:
    """A square with a changed description of its first stream."""
    first = square()[0]
    return glb([replace(first, extension=first.extension | changes), triangles(FACES)], meshes=PLAIN)


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"mode": "X"}, "its buffer view 0 cannot be decoded: mode: expected 'ATTRIBUTES', 'TRIANGLES' or 'INDICES'"),
        ({"filter": "X"}, "its buffer view 0 cannot be decoded: filter: expected 'NONE', 'OCTAHEDRAL'"),
        ({"filter": "QUATERNION"}, "ATTRIBUTES of 12 bytes have no filter QUATERNION"),
        ({"mode": "TRIANGLES"}, "TRIANGLES have no rows of 12 bytes"),
        ({"byteStride": 14}, "ATTRIBUTES have no rows of 14 bytes"),
        ({"byteStride": 0}, "ATTRIBUTES have no rows of 0 bytes"),
        ({"byteStride": 260}, "ATTRIBUTES have no rows of 260 bytes"),
        ({"byteStride": 16}, "its compressed bytes are damaged"),
        ({"count": 3}, "refers to an item that it does not contain"),
        ({"count": 300}, "its compressed bytes are damaged"),
        ({"count": -4}, "its buffer view 0 has -4 rows of 12 bytes"),
        ({"count": 10**400}, "it unpacks to more than"),
        ({"count": 10**6}, "1000000 rows of 12 bytes cannot come from 237 bytes"),
        ({"byteLength": 0}, "4 rows of 12 bytes cannot come from 0 bytes"),
        ({"byteOffset": 4}, "its compressed bytes are damaged|cannot come"),
        ({"byteLength": 10**6}, "refers to an item that it does not contain"),
        ({"buffer": 7}, "refers to an item that it does not contain"),
        ({"mode": 5}, "wrong type"),
    ],
)
def test_streams_that_cannot_be_decoded_are_errors(tmp_path: Path, changes: dict[str, Any], words: str) -> None:
    with pytest.raises(nf.SceneError, match=f"a\\.glb: .*({words})"):
        load(tmp_path, square_with(**changes))


def test_rows_whose_length_differs_from_their_view_are_errors(tmp_path: Path) -> None:
    document, binary = decode(glb(square(), meshes=PLAIN))
    document["bufferViews"][0]["byteStride"] = 16
    with pytest.raises(nf.SceneError, match=r"a\.glb: its buffer view 0 has rows of 16 bytes"):
        load(tmp_path, encode(document, binary))


def test_corners_without_a_vertex_are_errors(tmp_path: Path) -> None:
    faces = np.array([[0, 1, 2], [9, 2, 1]], np.uint16)
    with pytest.raises(nf.SceneError, match=r"a\.glb: 1 face with vertices that do not exist"):
        load(tmp_path, glb(square(triangles(faces)), meshes=PLAIN))


def test_truncated_streams_are_errors(tmp_path: Path) -> None:
    for number, stream in enumerate(square()):
        for length in range(0, len(stream.data), 3):
            streams = square()
            streams[number] = replace(stream, data=stream.data[:length])
            with pytest.raises(nf.SceneError, match=r"a\.glb: its buffer view \d cannot be decoded"):
                load(tmp_path, glb(streams, meshes=PLAIN))


def test_claimed_counts_are_not_trusted(tmp_path: Path) -> None:
    """2³¹ rows of 12 bytes, refused by the limit, and by the decoder if the limit is raised."""
    need("linux")
    path = tmp_path / "a.glb"
    path.write_bytes(square_with(count=1 << 31))
    (first, second), more = refusals(path, None, 1 << 50)
    assert "a.glb: it unpacks to more than 268,435,456 bytes" in first
    assert "a.glb: its buffer view 0 cannot be decoded: 2147483648 rows of 12 bytes cannot come from 237" in second
    assert more < 200e6


def test_decoded_bytes_count_towards_the_limit(tmp_path: Path) -> None:
    content = glb(square(), meshes=PLAIN)
    assert load(tmp_path, content, max_bytes=48 + 12).triangle_count == 2
    with pytest.raises(nf.SceneError, match=r"a\.glb: it unpacks to more than 59 bytes"):
        load(tmp_path, content, max_bytes=48 + 11)
