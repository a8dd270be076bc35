"""Triangles of glTF's strips and fans, and notes on points and lines."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, strategies as st

import nearfar as nf
from nearfar._scene.gltf import corners as of_corners
from tests.support import data
from tests.support.gltf_cases import encode

KINDS = {np.uint8: 5121, np.uint16: 5123, np.uint32: 5125}
STRIP, FAN = 5, 6
POINTS = np.random.default_rng(0).normal(size=(12, 3)).astype(np.float32)


def load(folder: Path, content: bytes, **options: Any) -> nf.Scene:
    (folder / "a.glb").write_bytes(content)
    return nf.Scene.load(folder / "a.glb", **options)


def primitive(mode: int, corners: np.ndarray | None) -> bytes:
    """A GLB of one primitive of POINTS, with indices or without."""
    views = [{"buffer": 0, "byteLength": POINTS.nbytes}]
    accessors = [{"bufferView": 0, "componentType": 5126, "count": len(POINTS), "type": "VEC3"}]
    described: dict[str, Any] = {"attributes": {"POSITION": 0}, "mode": mode}
    binary = POINTS.tobytes()
    if corners is not None:
        views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": corners.nbytes})
        kind = KINDS[corners.dtype.type]
        accessors.append({"bufferView": 1, "componentType": kind, "count": len(corners), "type": "SCALAR"})
        described["indices"] = 1
        binary += corners.tobytes()
    document = {
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [described]}],
        "accessors": accessors,
        "bufferViews": views,
        "buffers": [{"byteLength": len(binary)}],
    }
    return encode(document, binary)


def expected_triangles(mode: int, corners: list[int]) -> list[tuple[int, int, int]]:
    """Triangles one by one, as in glTF 2.0, 3.7.2.1, without those with two equal corners."""
    found = []
    for i in range(len(corners) - 2):
        if mode == STRIP:
            face = corners[i], corners[i + (1 + i % 2)], corners[i + (2 - i % 2)]
        else:
            face = corners[i + 1], corners[i + 2], corners[0]
        if len(set(face)) == 3:
            found.append(face)
    return found


def least_corner_first(faces: Any) -> list[tuple[int, ...]]:
    """Triangles rotated so that the least corner is first."""
    rows = [tuple(map(int, face)) for face in faces]
    return [min((a, b, c), (b, c, a), (c, a, b)) for a, b, c in rows]


@given(
    st.sampled_from([STRIP, FAN]), st.lists(st.integers(0, 11), max_size=40), st.sampled_from(sorted(KINDS, key=str))
)
def test_triangles_equal_the_specification(mode: int, corners: list[int], kind: type[np.generic]) -> None:
    faces = of_corners.faces(mode, np.array(corners, kind), is_indexed=True)
    assert least_corner_first(faces) == least_corner_first(expected_triangles(mode, corners))


@pytest.mark.parametrize("mode", [STRIP, FAN])
@pytest.mark.parametrize("kind", [None, *KINDS])
def test_strips_and_fans_load(tmp_path: Path, mode: int, kind: type[np.generic] | None) -> None:
    corners = None if kind is None else np.array([3, 1, 4, 1, 5, 9, 2, 6, 5, 5, 5, 8], kind)
    scene = load(tmp_path, primitive(mode, corners))
    faces = expected_triangles(mode, list(range(len(POINTS))) if corners is None else corners.tolist())
    numbers = [[int(np.argmin(np.abs(POINTS - corner).sum(axis=1))) for corner in face] for face in scene.triangles()]
    assert sorted(least_corner_first(numbers)) == sorted(least_corner_first(faces))
    assert scene.report.degenerate_faces == 0
    assert scene.report.notes == ()


@pytest.mark.parametrize("mode", [STRIP, FAN])
@pytest.mark.parametrize("kind", list(KINDS))
def test_primitive_restarts_are_refused(tmp_path: Path, mode: int, kind: type[np.integer[Any]]) -> None:
    most = np.iinfo(kind).max
    content = primitive(mode, np.array([0, 1, 2, most, 3, 4, 5], kind))
    with pytest.raises(nf.SceneError, match=f"a.glb: a strip or fan of its meshes has the index {most}"):
        load(tmp_path, content)
    with pytest.raises(nf.SceneError, match="1 face with vertices that do not exist"):
        load(tmp_path, primitive(mode, np.array([0, 1, 99], kind)))


@pytest.mark.parametrize(
    ("mode", "note"),
    [
        (0, "1 point primitive ignored"),
        (1, "1 line primitive ignored"),
        (2, "1 line primitive ignored"),
        (3, "1 line primitive ignored"),
        (7, "1 primitive of an unknown mode ignored"),
        (-1, "1 primitive of an unknown mode ignored"),
        ("x", "1 primitive of an unknown mode ignored"),
    ],
)
def test_other_primitives_are_noted(tmp_path: Path, mode: Any, note: str) -> None:
    with pytest.raises(nf.SceneError, match=f"a.glb: no triangles; {note}"):
        load(tmp_path, primitive(mode, None))


def test_real_primitives_of_every_mode() -> None:
    """The file has points, three kinds of lines, a list, a strip and a fan of two hexagons of 4 and 6 triangles."""
    folder = "wild/cesium-native/CesiumGltfReader/test/data"
    scene = nf.Scene.load(data(f"{folder}/MeshPrimitiveModes/MeshPrimitiveModes.gltf"))
    assert scene.report.notes == ("1 point primitive ignored", "3 line primitives ignored")
    areas = {}
    for name in scene.object_names:
        corners = scene.subset(objects=[name]).triangles()
        sides = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        assert (sides[:, 2] > 0).all(), "all triangles face the viewer"
        areas[name] = float(sides[:, 2].sum() / 2)
    # Regular hexagons of radius 1, whose corners the file has to three digits.
    np.testing.assert_allclose(list(areas.values()), 1.5 * 3**0.5, atol=2e-3)
    with pytest.raises(nf.SceneError, match="no triangles; 4 point primitives ignored"):
        nf.Scene.load(data(f"{folder}/StyledPoints/BENTLEY_materials_point_style.gltf"))
