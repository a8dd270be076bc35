"""Partitions by whole objects: every object with a triangle inside r2 is geometry, and the map contains the others."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import nearfar as nf
from tests.support.gpu_cases import ADAPTERS, backend_of, edges
from tests.support.reduce_cases import ALL, CENTER, R1, R2, box, camera, rho, street

USER = CENTER + np.array([5.0, 0.3, 4.0])
ALONG_THE_WALL = (1.0, 0.0, -0.35)


@pytest.fixture(scope="module", params=["instances", "merged"])
def scene(request: pytest.FixtureRequest) -> nf.Scene:
    """The street with one object per mesh, or with all objects in one mesh."""
    if request.param == "instances":
        return street()
    parts = [
        box((-2000, -1, -2000), (2000, 0, 2000)),
        box((5, 0, -25), (120, 15, -20)),
        box((10, 0, 12), (13, 4, 15)),
        box((100, 0, 60), (120, 70, 80)),
    ]
    vertices = np.concatenate([corners for corners, _ in parts])
    faces = np.concatenate([part + 8 * number for number, (_, part) in enumerate(parts)])
    owner = np.repeat(np.arange(4), 12)
    return nf.Scene.from_arrays(vertices, faces, face_object=owner)


def near_objects(scene: nf.Scene, r2: float) -> set[int]:
    """Objects with a triangle whose least ρ is at most r2, by the distances of all triangles."""
    least = nf.triangle_radii(scene.triangles().astype(np.float64) + scene.origin, center=CENTER)[:, 0]
    counts = [scene.subset(objects=[name]).triangle_count for name in scene.object_names]
    owner = np.repeat(np.arange(len(counts)), counts)
    return set(owner[least <= r2].tolist())


def test_objects_that_extend_inside_are_geometry_as_a_whole(scene: nf.Scene) -> None:
    parts = nf.partition(scene, center=CENTER, r1=R1, r2=R2, unit="object")
    near = near_objects(scene, R2)
    assert len(near) == 3
    counts = [scene.subset(objects=[name]).triangle_count for name in scene.object_names]
    summary = parts.summary()
    assert summary["nsf"] == sum(counts[number] for number in near)
    assert summary["sf"] == scene.triangle_count - summary["nsf"]
    assert summary["straddling"] == 0
    assert parts.unit == "object"
    assert parts.source is scene
    assert set(parts.scene.object_names) == set(scene.object_names)
    np.testing.assert_array_equal(np.union1d(parts.nsf, parts.sf), np.arange(scene.triangle_count))


def test_a_scene_without_near_objects_is_unchanged(scene: nf.Scene) -> None:
    far = scene.subset(objects=[scene.object_names[3]])
    parts = nf.partition(far, center=CENTER, r1=R1, r2=R2, unit="object")
    assert parts.scene is far
    assert parts.summary()["nsf"] == 0


@pytest.mark.parametrize("backend", ["cpu", *ADAPTERS])
@pytest.mark.parametrize("kind", ["blend", "cylinder"])
def test_near_objects_beyond_r2_are_shown_as_the_centre_sees_them(scene: nf.Scene, kind: str, backend: str) -> None:
    """By triangle, the part of the wall beyond r2 is in the map; by object it is geometry at the same position."""
    settings: dict[str, Any] = {"center": CENTER, "r1": R1, "r2": R2, "morph": kind, "samples": 1}
    by_object = nf.reduce(scene, unit="object", face_size=64, channels=("color", "object_id"), **settings)
    by_triangle = nf.reduce(scene, face_size=8, **settings)
    assert by_object.env is not None
    assert by_object.env.range is not None
    # Only the tower is in the map.
    assert by_object.env.object_id is not None
    assert set(np.unique(by_object.env.object_id)) == {-1, 3}
    view = camera(USER, ALONG_THE_WALL)
    with backend_of(backend) as name:
        frame = by_object.render(view, channels=ALL[:4], method="vertex", backend=name)
    expected = by_triangle.render(view, channels=ALL, method="exact", env=False)
    inner = ~edges(expected.require("object_id"))
    beyond = inner & (rho(expected.require("position")) > R2) & (expected.require("object_id") == 1)
    assert beyond.sum() > 100
    differ = inner & (frame.require("object_id") != expected.require("object_id"))
    assert differ.mean() < 0.002
    same = inner & ~differ & (expected.require("object_id") >= 0)
    np.testing.assert_allclose(
        frame.require("range")[same & beyond], expected.require("range")[same & beyond], rtol=5e-3
    )
    # The wall's colour is not a texel's: it is shaded as geometry.
    np.testing.assert_allclose(
        frame.require("color")[beyond & same], expected.require("color")[beyond & same], atol=5e-3
    )
