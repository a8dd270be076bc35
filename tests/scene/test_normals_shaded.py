"""Vertex normals in pictures: against brute force and exact spheres, posed, cut, split and reduced."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import trimesh

import nearfar as nf
from nearfar import _core
from nearfar._reduce.drawing import MorphKind
from nearfar._scene.builder import SceneBuilder
from tests.support import render_oracle as oracle
from tests.support.normal_cases import PLACES, Array, ball, camera, colors, scene_around, scene_of
from tests.support.render_oracle import Surface


def to_world(vertices: Array, faces: Array, normals: Array, place: Array, **attributes: Any) -> Surface:
    """The mesh in world coordinates by textbook formulas, with faces outwards."""
    linear = place[:3, :3]
    rows = normals @ np.linalg.inv(linear)  # Rows times the inverse are columns times the inverse transpose.
    length = np.linalg.norm(rows, axis=1, keepdims=True)
    rows = np.divide(rows, length, out=np.zeros_like(rows), where=length > 0)
    order = [0, 2, 1] if np.linalg.det(linear) < 0 else [0, 1, 2]
    corners = vertices @ linear.T + place[:3, 3]
    return Surface(corners, faces.astype(np.int64)[:, order], normals=rows, **attributes)


def check(scene: nf.Scene, surfaces: list[Surface], view: nf.Camera) -> None:
    frame = nf.render(scene, view, channels=("color", "normal", "object_id"))
    expected = oracle.cast(surfaces, oracle.view(view))
    shape = frame.require("color").shape
    same = frame.require("object_id") == expected.object_id.reshape(shape[:2])
    assert same.mean() > 0.999
    # Weights of corners are rounded by some 1e-6 on small faces, directions of normals change by as much.
    np.testing.assert_allclose(frame.require("color")[same], expected.color.reshape(shape)[same], atol=2e-5)
    np.testing.assert_allclose(frame.require("normal")[same], expected.normal.reshape(shape)[same], atol=2e-6)


@pytest.mark.parametrize("place", PLACES.values(), ids=PLACES)
@pytest.mark.parametrize("how", ["merged", "instances", "moving"])
def test_colours_agree_with_brute_force(place: Array, how: str) -> None:
    vertices, faces = ball()
    beside = np.eye(4)
    beside[:3, 3] = 1.6, -0.4, 0.3
    places = [place] if how == "merged" else [place, beside @ place]
    scene = scene_of(vertices, faces, vertices, *places, dynamic=how == "moving")
    assert scene.report.meshes == 1
    check(scene, [to_world(vertices, faces, vertices.astype(float), matrix) for matrix in places], camera())


@pytest.mark.parametrize("lean", [0.5, 2.0, 8.0])
def test_normals_facing_away_from_the_viewer_are_kept(lean: float) -> None:
    """A quad from all sides; at 8 to 1 most viewers see its tilted normals from behind."""
    corners = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], float)
    normals = corners * lean + [0, 0, 1]
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    faces = np.array([[0, 1, 2], [0, 2, 3]])
    for eye in [(0, 0, 3), (2.5, 0.4, 0.6), (-1, -2, -0.7), (0.2, 2, 1)]:
        view = nf.Camera.look_at(eye, (0, 0, 0), fov=nf.Fov.symmetric(50), size=(40, 40))
        check(scene_of(corners, faces, normals), [Surface(corners, faces, normals=normals)], view)


def test_a_coarse_sphere_is_shaded_like_an_exact_one() -> None:
    vertices, faces = ball(3)
    eye = camera(distance=20.0).position
    view = nf.Camera.look_at(eye, (0, 0, 0), fov=nf.Fov.symmetric(6.5), size=(200, 200))
    scenes = [scene_of(vertices, faces, normals) for normals in (vertices, None)]
    smooth, flat = (nf.render(scene, view, channels=("color", "position")) for scene in scenes)
    rays = oracle.view(view)
    b = np.einsum("ij,ij->i", rays.origins, rays.directions)
    d = b**2 - (np.einsum("ij,ij->i", rays.origins, rays.origins) - 1.0)
    points = rays.origins + (-b - np.sqrt(np.maximum(d, 0)))[:, None] * rays.directions
    cosine = -np.einsum("ij,ij->i", points, rays.directions)
    inside = (d > 0) & (cosine > 0.5)
    assert inside.sum() > 10_000
    exact = 0.8 * oracle.irradiance(points[inside])
    errors = [np.abs(f.require("color").reshape(-1, 3)[inside] - exact).max(axis=1) for f in (smooth, flat)]
    # Faces lie below the sphere by at most the sagitta s of their circumscribed circle: rays continue by up to
    # s / cos, which is s tan across the sphere. Light changes by at most SUN + (SKY_HIGH - SKY_LOW) / 2 = 0.765 for
    # each radian.
    corners = vertices[faces].astype(float)
    sides = [np.linalg.norm(corners[:, i] - corners[:, i - 1], axis=1) for i in range(3)]
    area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 2
    radius = (sides[0] * sides[1] * sides[2] / (4 * area)).max()
    sagitta = 1 - np.sqrt(1 - radius**2)
    assert errors[0].max() <= 0.8 * 0.765 * sagitta * np.tan(np.arccos(0.5)) * 1.1 + 1e-5
    assert np.median(errors[1]) > 10 * np.median(errors[0])
    # Between corners on a sphere about zero, normals are the points' own directions: no bound but rounding.
    hit = smooth.require("position").reshape(-1, 3)[inside]
    ideal = 0.8 * oracle.irradiance(hit / np.linalg.norm(hit, axis=1, keepdims=True))
    np.testing.assert_allclose(smooth.require("color").reshape(-1, 3)[inside], ideal, atol=1e-5)


def test_zero_normals_mean_the_face_normal() -> None:
    vertices, faces = ball()
    flat, zeros = (scene_of(vertices, faces, n) for n in (None, np.zeros_like(vertices)))
    np.testing.assert_array_equal(colors(zeros), colors(flat))
    some = vertices.copy()
    some[::3] = 0
    for name in ("as it is", "mirrored"):
        one, other = (colors(scene_of(vertices, faces, normals, PLACES[name])) for normals in (some, None))
        assert (one != other).mean() > 0.1
    check(scene_of(vertices, faces, some), [to_world(vertices, faces, some.astype(float), np.eye(4))], camera())


def test_normals_may_point_inwards_as_in_files() -> None:
    """Both sides of faces are visible, so the order of their corners does not matter."""
    vertices, faces = ball()
    reference = colors(scene_of(vertices, faces, vertices))
    for other in (scene_of(vertices, faces, -vertices), scene_of(vertices, faces[:, [0, 2, 1]], vertices)):
        np.testing.assert_allclose(colors(other), reference, atol=1e-6)


def test_poses_rotate_stretch_and_mirror_normals() -> None:
    vertices, faces = ball()
    scene = scene_of(vertices, faces, vertices, np.eye(4), dynamic=True)
    for place in PLACES.values():
        check(scene.at({"ball 0": place}), [to_world(vertices, faces, vertices.astype(float), place)], camera())


def test_a_part_of_a_scene_keeps_its_normals() -> None:
    vertices, faces = ball(2)
    scene = scene_of(vertices, faces, vertices)
    whole = nf.render(scene, camera(), channels=("color", "face_id"))
    seen = np.unique(whole.require("face_id"))
    for triangles in (seen[seen >= 0], seen[seen >= 0][:9]):
        part = nf.render(scene.subset(triangles=triangles), camera(), channels=("color", "face_id"))
        same = np.isin(whole.require("face_id"), triangles)
        np.testing.assert_array_equal(part.require("color")[same], whole.require("color")[same])
    moved = nf.render(scene.with_dynamic(["ball 0"]), camera())
    np.testing.assert_array_equal(moved.require("color"), whole.require("color"))


def test_meshes_without_normals_stay_flat_among_others() -> None:
    vertices, faces = ball()
    builder = SceneBuilder()
    place = np.eye(4)
    for x, normals in [(-1.2, vertices), (1.2, None)]:
        place[0, 3] = x
        builder.instance(builder.mesh(vertices, faces, normals=normals), place.copy(), name=str(x))
    scene = builder.build()
    assert scene.report.meshes == 1
    shift = np.array([1.2, 0, 0])
    surfaces = [Surface(vertices - shift, faces, normals=vertices), Surface(vertices + shift, faces)]
    check(scene, surfaces, camera(distance=6.0))


def test_split_triangles_are_shaded_like_whole_ones() -> None:
    """The mean of two normals is normalised, which slightly rotates those between it and the ends."""
    vertices, faces = ball(1)
    place = np.diag([12.0, 9.0, 12.0, 1.0])
    place[:3, 3] = 40, 4, 1
    scene = scene_of(vertices, faces, vertices, place, uvs=vertices[:, :2])
    wide = nf.Camera((0, 0, 0), fov=nf.Fov.symmetric(90), size=(1000, 1000))
    made = nf.tessellate(scene, center=(0, 1.7, 0), r1=30, r2=50, user_region=5.0, tolerance_px=0.5, camera=wide)
    assert made.triangle_count > 2 * scene.triangle_count
    (normals,) = (_core.mesh_parts(mesh)["normals"] for mesh in _core.scene_parts(made._core)["meshes"])
    np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1.0, atol=1e-6)
    view = nf.Camera.look_at((0, 1.7, 0), (40, 4, 1), fov=nf.Fov.symmetric(50), size=(80, 80))
    one, other = (nf.render(s, view, channels=("color", "position")) for s in (scene, made))
    # Normals at the ends of this ball's edges are up to 0.9 apart once stretched: 0.05 of it, times a light of 0.6.
    np.testing.assert_allclose(one.require("color"), other.require("color"), atol=0.8 * 0.765 * 0.25 * 0.45**2)
    flat = nf.render(scene_of(vertices, faces, None, place), view).require("color")
    error = np.abs(one.require("color") - other.require("color")).mean()
    assert error < 0.02 * np.abs(one.require("color") - flat).mean()


def test_a_split_trimesh_keeps_the_normals_that_it_was_given() -> None:
    corners = np.array([[-80, 0, -80], [-80, 0, 80], [80, 0, 80], [80, 0, -80]], float)
    normals = corners / 160 + [0, 1, 0]
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    view = nf.Camera((0, 0, 0), fov=nf.Fov.symmetric(90), size=(1000, 1000))
    settings: dict[str, Any] = {"center": (0, 1.7, 0), "r1": 30, "r2": 50, "user_region": 5.0, "tolerance_px": 0.5}
    mesh = trimesh.Trimesh(corners, [[0, 1, 2], [0, 2, 3]], vertex_normals=normals, process=False)
    made = nf.tessellate(mesh, camera=view, **settings)
    expected = made.vertices / 160 + [0, 1, 0]
    expected /= np.linalg.norm(expected, axis=1, keepdims=True)
    # Corners' lengths differ by rounding only: the mean of unit normals equals the mean of the originals.
    np.testing.assert_allclose(made.vertex_normals, expected, atol=1e-12)
    plain = nf.tessellate(trimesh.Trimesh(corners, [[0, 1, 2], [0, 2, 3]], process=False), camera=view, **settings)
    assert "vertex_normals" not in plain._cache.cache


@pytest.mark.parametrize("morph", ["blend", "cylinder", "none"])
@pytest.mark.parametrize("method", ["vertex", "exact"])
def test_a_user_at_the_centre_of_a_reduced_scene_sees_the_truth(morph: MorphKind, method: Any) -> None:
    center = np.array([3.0, 1.7, -2.0])
    scene = scene_around(center)
    channels = ("color", "object_id")
    reduced = nf.reduce(
        scene, center=center, r1=15, r2=25, face_size=512, morph=morph, samples=1, channels=("range", *channels)
    )
    view = nf.Camera.look_at(center, center + np.array([1, 0.02, 0.4]), fov=nf.Fov.symmetric(60), size=(96, 96))
    truth = nf.render(scene, view, channels=("range", *channels))
    shown = reduced.render(view, channels=channels, method=method)
    near = np.isfinite(truth.require("range")) & (truth.require("range") < 24)
    near &= (truth.require("object_id") < 3) & (shown.require("object_id") == truth.require("object_id"))
    assert near.sum() > 300
    # Split vertices are float32 of some tens of metres, and their weights have the same precision.
    np.testing.assert_allclose(shown.require("color")[near], truth.require("color")[near], atol=2e-4)
    far = truth.require("object_id") == 3
    assert far.sum() > 100
    # The map has the colours of its texels' centres: balls beyond are smooth as well.
    assert np.median(np.abs(shown.require("color")[far] - truth.require("color")[far])) < 0.01
