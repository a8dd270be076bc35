"""Tests of tessellation: within its tolerance for every user, without cracks, and without needless splits."""

from __future__ import annotations

import math
from collections import Counter
from typing import Any

import numpy as np
import pytest
import trimesh
from hypothesis import given, settings, strategies as st

import nearfar as nf
from nearfar._scene.builder import SceneBuilder
from tests.support import printed_by_threads
from tests.support.tessellate_cases import CENTER, PIXEL, VIEW, Array, ground, open_edges, users

R1, R2 = 30.0, 50.0


def split(mesh: Any, *, tolerance_px: float = 0.5, user_region: Any = 5.0) -> Any:
    return nf.tessellate(
        mesh, center=CENTER, r1=R1, r2=R2, user_region=user_region, tolerance_px=tolerance_px, camera=VIEW
    )


def greatest_error(triangles: Array, eyes: Array, seed: int = 0) -> float:
    """Greatest angle between the interpolated morph of corners and the morph of the point, in pixels."""
    weights = np.random.default_rng(seed).dirichlet(np.ones(3), 6)
    weights = np.concatenate([weights, (1 - np.eye(3)) / 2, np.full((1, 3), 1 / 3)])
    points = np.einsum("wk,tkc->twc", weights, triangles).reshape(-1, 3)
    worst = 0.0
    for eye in eyes:
        morphing: dict[str, Any] = {"user": eye, "center": CENTER, "r1": R1, "r2": R2}
        corners = nf.morph(triangles.reshape(-1, 3), **morphing).reshape(triangles.shape)
        shown = np.einsum("wk,tkc->twc", weights, corners).reshape(-1, 3) - eye
        exact = nf.morph(points, **morphing) - eye
        cross = np.linalg.norm(np.cross(shown, exact), axis=1)
        worst = max(worst, float(np.arctan2(cross, (shown * exact).sum(axis=1)).max()))
    return worst / PIXEL


@pytest.mark.parametrize("tolerance", [0.25, 1.0])
def test_two_triangles_of_ground_stay_within_the_tolerance(tolerance: float) -> None:
    made = split(ground(), tolerance_px=tolerance)
    before = greatest_error(np.asarray(ground().triangles), users(5.0, 8, 0))
    after = greatest_error(np.asarray(made.triangles), users(5.0, 24, 1))
    assert before > 100
    # Not far below either, so that the bound is tight.
    assert 0.3 * tolerance < after <= tolerance
    assert made.area == pytest.approx(ground().area, rel=1e-9)
    assert (made.face_normals[:, 1] > 0.999).all()


@settings(max_examples=25, deadline=None)
@given(st.integers(0, 2**32), st.floats(0.1, 15.0), st.floats(0.3, 8.0), st.floats(1.0, 150.0))
def test_any_triangles_stay_within_the_tolerance(seed: int, reach: float, tolerance: float, size: float) -> None:
    random = np.random.default_rng(seed)
    corners = CENTER + random.uniform(-60, 60, (4, 1, 3)) * [1, 0.3, 1] + random.normal(size=(4, 3, 3)) * size
    mesh = trimesh.Trimesh(corners.reshape(-1, 3), np.arange(12).reshape(4, 3), process=False)
    made = split(mesh, tolerance_px=tolerance * max(1.0, reach / 4), user_region=reach)
    error = greatest_error(np.asarray(made.triangles), users(reach, 6, seed), seed)
    assert error <= tolerance * max(1.0, reach / 4) * (1 + 1e-9)


def test_there_are_no_cracks_within_a_mesh_or_between_objects() -> None:
    # A wall, a roof and a floor of a house across both radii, each a separate object; closed by its box.
    house = trimesh.creation.box(bounds=[[10, -3, -15], [70, 25, 40]])
    made = split(house)
    assert open_edges(np.asarray(made.triangles)) == 0
    assert len(made.faces) > 500
    build = SceneBuilder()
    for number, face in enumerate(house.triangles):
        build.instance(build.mesh(face, [[0, 1, 2]]), name=f"side {number}")
    scene = split(build.build())
    assert open_edges(scene.triangles()) == 0
    assert len(scene.object_names) == 12
    # Rounding of float32 vertices slightly changes the edges' crossings, and with them their number.
    assert scene.triangle_count == pytest.approx(len(made.faces), rel=0.1)


@pytest.mark.parametrize(("sides", "radii"), [(6, (30, 60)), (8, (30, 50, 80)), (7, (29.9999999, 60))])
def test_edges_between_two_points_of_r1_are_split_equally_on_both_sides(sides: int, radii: tuple[float, ...]) -> None:
    turn = np.arange(sides) * 2 * np.pi / sides
    circle = np.stack([np.cos(turn), 0 * turn, np.sin(turn)], axis=1)
    points = np.concatenate([[[0.0, 0.0, 0.0]], *(circle * radius for radius in radii)]) + CENTER
    one, other = 1 + np.arange(sides), 1 + (np.arange(sides) + 1) % sides
    faces = [np.stack([0 * one, one, other], axis=1)]
    for ring in range(len(radii) - 1):
        near, far = sides * ring, sides * (ring + 1)
        faces += [np.stack([one + near, one + far, other + far], axis=1)]
        faces += [np.stack([one + near, other + far, other + near], axis=1)]
    disc = trimesh.Trimesh(points, np.concatenate(faces), process=False)
    for whole in (disc, nf.Scene.from_trimesh(disc)):
        made = np.asarray(split(whole).triangles if whole is disc else split(whole).triangles(), np.float64)
        assert len(made) > 1000
        rim = radii[-1] * math.cos(math.pi / sides) - 1e-3
        within = made[(np.hypot(*(made.mean(axis=1) - CENTER)[:, [0, 2]].T) < rim)]
        ends = Counter(tuple(sorted(map(tuple, (t[i].tolist(), t[i - 1].tolist())))) for t in within for i in range(3))
        middles = {pair: np.hypot(*(np.mean(pair, axis=0) - CENTER)[[0, 2]]) for pair in ends}
        assert all(count == 2 for pair, count in ends.items() if middles[pair] < 0.9 * rim)


def test_unsplit_triangles_keep_their_bits() -> None:
    near = trimesh.creation.icosphere(radius=10).apply_translation([5, 2, 3])
    far = trimesh.creation.icosphere(radius=100).apply_translation([200, 0, 30])
    for mesh in (near, far):
        made = split(mesh)
        np.testing.assert_array_equal(made.vertices, mesh.vertices)
        np.testing.assert_array_equal(made.faces, mesh.faces)
    both = trimesh.util.concatenate([near, ground(), far])
    made = split(both)
    np.testing.assert_array_equal(made.vertices[: len(both.vertices)], both.vertices)
    unchanged = len(near.faces)
    np.testing.assert_array_equal(made.faces[:unchanged], both.faces[:unchanged])
    np.testing.assert_array_equal(made.faces[-len(far.faces) :], both.faces[-len(far.faces) :])


def crowd() -> nf.Scene:
    """Return ground, one box placed inside, across and outside, and a car."""
    build = SceneBuilder()
    plane = build.mesh([[-500, 0, -500], [-500, 0, 500], [500, 0, 500], [500, 0, -500]], [[0, 1, 2], [0, 2, 3]])
    build.instance(plane, name="ground")
    box = trimesh.creation.box(extents=[8, 8, 8])
    mesh = build.mesh(box.vertices, box.faces, material=build.material((0.5, 0.2, 0.1, 1)))
    for name, x in [("inside", 10.0), ("across", 33.0), ("outside", 80.0)]:
        place = np.eye(4)
        place[:3, 3] = x, 4, 1
        build.instance(mesh, place, name=name)
    place = np.eye(4)
    place[0, 3] = 40
    build.instance(mesh, place, name="car")
    return build.build(dynamic=["car"])


def test_scenes_keep_objects_and_share_unsplit_meshes() -> None:
    scene = crowd()
    made = split(scene)
    assert made.object_names == scene.object_names
    np.testing.assert_array_equal(made.origin, scene.origin)
    np.testing.assert_allclose(made.bounds, scene.bounds)
    before, after = scene._core.mesh_ids(), made._core.mesh_ids()
    assert len(set(before) & set(after)) == 1
    for name in ("inside", "outside", "car"):
        assert made.subset(objects=[name]).triangle_count == 12
    assert made.subset(objects=["across"]).triangle_count > 100
    pose = np.eye(4)
    pose[0, 3] = 45.0
    np.testing.assert_array_equal(made.at({"car": pose}).triangles()[-12:], scene.at({"car": pose}).triangles()[-12:])
    triangles = made.triangles()[:-12].astype(np.float64) + made.origin
    assert greatest_error(triangles, users(5.0, 8, 2)) <= 0.5
    view = nf.Camera.look_at(CENTER, CENTER + np.array([1, -0.1, 0.1]), fov=nf.Fov.symmetric(90, 16 / 9), size=(96, 54))
    one, other = (nf.render(s, view, channels=("color", "object_id")) for s in (scene, made))
    np.testing.assert_array_equal(one.require("object_id"), other.require("object_id"))
    # Silhouettes are equal; normals of pieces are rounded again.
    np.testing.assert_allclose(one.require("color"), other.require("color"), atol=1e-5)


def test_attributes_are_interpolated_and_kept() -> None:
    mesh = ground(80.0)
    mesh.visual = trimesh.visual.TextureVisuals(uv=mesh.vertices[:, [0, 2]] / 160 + 0.5)
    mesh.vertex_attributes["height"] = mesh.vertices[:, 0] * 2 - mesh.vertices[:, 2]
    mesh.vertex_attributes["label"] = np.arange(4)
    mesh.face_attributes["part"] = np.array([7, 9])
    mesh.metadata["name"] = "street"
    made = split(mesh)
    x, z = made.vertices[:, 0], made.vertices[:, 2]
    # Sums of three float64 products.
    np.testing.assert_allclose(made.visual.uv, np.stack([x, z], axis=1) / 160 + 0.5, atol=1e-12)
    np.testing.assert_allclose(made.vertex_attributes["height"], 2 * x - z, atol=1e-10)
    assert set(made.vertex_attributes["label"]) == {0, 1, 2, 3}
    side = made.triangles_center
    np.testing.assert_array_equal(made.face_attributes["part"], np.where(side[:, 0] < side[:, 2], 7, 9))
    assert made.metadata["name"] == "street"


def test_colours_of_vertices_and_faces_are_kept() -> None:
    mesh = ground(80.0)
    mesh.visual.vertex_colors = [[0, 0, 0, 255], [0, 200, 0, 255], [200, 200, 0, 255], [200, 0, 0, 255]]
    made = split(mesh)
    expected = (made.vertices[:, 0] / 160 + 0.5) * 200
    np.testing.assert_allclose(made.visual.vertex_colors[:, 0], expected, atol=0.5 + 1e-9)
    painted = ground(80.0)
    painted.visual.face_colors = [[9, 8, 7, 255], [1, 2, 3, 255]]
    assert {tuple(color) for color in split(painted).visual.face_colors.tolist()} == {(9, 8, 7, 255), (1, 2, 3, 255)}


def test_regions_are_balls_or_boxes() -> None:
    mesh = ground(60.0)
    ball = split(mesh, user_region=5.0)
    box = split(mesh, user_region=CENTER + np.array([[-4, 0, -3], [1, 0, 3]]))
    np.testing.assert_array_equal(ball.faces, box.faces)
    assert len(split(mesh, user_region=2.0).faces) < len(ball.faces) < len(split(mesh, user_region=10.0).faces)


def test_results_do_not_depend_on_threads() -> None:
    code = """
import hashlib, numpy as np, nearfar as nf
scene = nf.datasets.city(blocks=3, seed=1, detail=1)
low, high = scene.bounds
view = nf.Camera((0, 0, 0), fov=nf.Fov.symmetric(90, 1), size=(1024, 1024))
made = nf.tessellate(scene, center=(low + high) / 2, r1=20, r2=35, user_region=4, tolerance_px=0.5, camera=view)
print(made.triangle_count, hashlib.sha256(made.triangles().tobytes()).hexdigest())
"""
    assert len(printed_by_threads(code)) == 1


def test_pixel_angles_consider_fine_pixels_and_corners() -> None:
    side = nf.Camera((0, 0, 0), fov=nf.Fov(-1.0, 0.5, -0.5, 0.5), size=(1536, 1024))
    assert side._core.least_pixel_angle == pytest.approx(1 / 1024 / (1 + 1 + 0.25))
    assert VIEW._core.least_pixel_angle == pytest.approx(PIXEL)
    face = nf.Camera((0, 0, 0), fov=nf.CubeFace(2), size=(512, 512))
    assert face._core.least_pixel_angle == pytest.approx(2 / 512 / 3)
