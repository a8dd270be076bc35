"""Triangles of glTF's strips and fans, and notes on points and lines."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, strategies as st

import nearfar as nf
from nearfar._scene.gltf import corners as of_corners
from tests.support.gltf_cases import load
from tests.support.gltf_writer import Writer

KINDS = (np.uint8, np.uint16, np.uint32)
STRIP, FAN = 5, 6
POINTS = np.random.default_rng(0).normal(size=(12, 3)).astype(np.float32)


def primitive(mode: Any, corners: np.ndarray | None) -> bytes:
    """A GLB of one primitive of POINTS, with indices or without."""
    writer = Writer(np.random.default_rng(0))
    described = {"attributes": {"POSITION": writer.add(POINTS)}, "mode": mode}
    if corners is not None:
        described["indices"] = writer.add(corners[:, None])
    return writer.glb(scenes=[{"nodes": [0]}], nodes=[{"mesh": 0}], meshes=[{"primitives": [described]}])


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


@given(st.sampled_from([STRIP, FAN]), st.lists(st.integers(0, 11), max_size=40), st.sampled_from(KINDS))
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
@pytest.mark.parametrize("kind", KINDS)
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
