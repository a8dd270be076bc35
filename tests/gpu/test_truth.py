"""Tests of ground truth on graphics adapters against the tracer and against float64."""

from __future__ import annotations

import functools

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar._camera.camera import Projection
from nearfar._scene.builder import SceneBuilder
from tests.support import data, render_oracle as oracle
from tests.support.gpu_cases import agree, both, check_color, check_ids, crowd, view
from tests.support.normal_cases import PLACES, ball
from tests.support.render_cases import PROJECTIONS, QUAD, build, quad, room
from tests.support.render_oracle import Surface

pytestmark = pytest.mark.usefixtures("backend")


@pytest.mark.parametrize("eye", [(0.0, 1.7, 0.0), (50.0, 80.0, 60.0)])
def test_the_procedural_city_agrees_with_the_tracer(city: nf.Scene, eye: tuple[float, float, float]) -> None:
    # From above, edges pass many pixels.
    agree(*both(city, view(eye, (20, 5, -40))), same=0.999 if eye[1] < 2 else 0.998)


load = functools.cache(lambda name: nf.Scene.load(data(name)))


@pytest.mark.parametrize(
    ("name", "eye", "target"),
    [
        ("city/tokyo23/tokyo_core_lod1.glb", (115, 300, 192), (400, 0, -200)),
        # From outside, where coplanar faces lie next to each other, and from inside.
        ("interior/garage/garage.gltf", (0, 1.4, 7.8), (0, 1.4, 0)),
        ("interior/garage/garage.gltf", (0, 1.4, 0.3), (1, 1.5, 0.7)),
        ("objects/gltf/FlightHelmet/FlightHelmet.gltf", (0, 0.36, 0.75), (0, 0.36, 0)),
    ],
)
def test_scenes_from_files_agree_with_the_tracer(
    name: str, eye: tuple[float, float, float], target: tuple[float, float, float]
) -> None:
    # From outside the garage is mostly edges and coincident surfaces, and the city from above mostly edges.
    agree(*both(load(name), view(eye, target)), same=0.998 if eye[2] == 7.8 or eye[1] == 300 else 0.999)


def test_ranges_are_as_accurate_as_the_tracers(city: nf.Scene) -> None:
    """Compares planes along rays in float64: errors are at most 1.5 times the tracer's, also at slanted surfaces."""
    camera = view((0, 1.7, 0), (20, 5, -40), size=(480, 320))
    cpu, gpu = both(city, camera)
    equal = agree(cpu, gpu)
    hits = equal & np.isfinite(cpu.require("range"))
    corners = city.triangles()[cpu.require("face_id")[hits]].astype(np.float64) + city.origin
    rays = oracle.view(camera)
    inside = hits.ravel()
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    ahead = np.einsum("ij,ij->i", normal, rays.directions[inside])
    exact = np.einsum("ij,ij->i", normal, corners[:, 0] - rays.origins[inside]) / ahead
    errors = [np.abs(frame.require("range")[hits] - exact) / exact for frame in (cpu, gpu)]
    traced, drawn = (np.percentile(error, [50, 99, 99.9, 100]) for error in errors)
    assert (drawn <= 1.5 * traced).all(), (traced, drawn)


@pytest.mark.parametrize("fov", PROJECTIONS, ids=lambda fov: f"{type(fov).__name__}{getattr(fov, 'face', '')}")
def test_every_projection_and_surface_type_agrees_with_brute_force(fov: Projection) -> None:
    """A room with a repeated texture, vertex colours and a cut-out leaf, compared with brute force in float64."""
    surfaces = room()
    turn = (0.0, 0.0, 0.0, 1.0) if isinstance(fov, nf.CubeFace) else (0.1, 0.2, -0.1, 0.9695359714832659)
    camera = nf.Camera(
        (0.31, 0.17, 0.43), turn, fov=fov, size=(64, 48) if not isinstance(fov, nf.CubeFace) else (48, 48)
    )
    cpu, gpu = both(build(surfaces), camera)
    # Some hundred pixels along the holes of a leaf of noise are on their edges.
    agree(cpu, gpu, same=0.995)
    exact = oracle.cast(surfaces, oracle.view(camera))
    same = exact.face_id.reshape(48, -1) == gpu.require("face_id")
    assert same.mean() >= 0.995
    # The tolerance of the tracer's own test: texture levels and corner colours are rounded to float32.
    np.testing.assert_allclose(gpu.require("color")[same], exact.color.reshape(48, -1, 3)[same], atol=2e-3)


def test_cube_faces_look_in_their_directions() -> None:
    """Six walls of six colours about the eye."""
    colors = [(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0), (0, 1, 1), (1, 0, 1)]
    walls = []
    for axis, sign in [(a, s) for a in range(3) for s in (1, -1)]:
        middle = np.zeros(3)
        middle[axis] = 2.0 * sign
        right, up = (np.roll((0.0, 2.0, 0.0), axis), np.roll((0.0, 0.0, 2.0), axis))
        walls.append(Surface(quad(middle, right, up), QUAD, (*colors[2 * axis + (sign < 0)], 1.0)))
    scene = build(walls)
    for face in range(6):
        frame = nf.render(scene, nf.Camera((0, 0, 0), fov=nf.CubeFace(face), size=(16, 16)), backend="gpu")
        assert (frame.require("object_id") == face).all()
        lit = frame.require("color").reshape(-1, 3).max(0) > 0
        np.testing.assert_array_equal(lit, np.array(colors[face]) > 0)


def test_textures_are_neither_mirrored_nor_rotated() -> None:
    """Each quarter of the picture shows one texel, in a distinct colour."""
    texture = np.zeros((2, 2, 4), np.uint8)
    texture[..., 3] = 255
    texture[0, 0, 0] = texture[0, 1, 1] = texture[1, 0, 2] = 255
    uvs = np.array([[0.0, 0.0], [1, 0], [1, 1], [0, 1]])
    wall = Surface(quad((0, 0, -1), (1, 0, 0), (0, 1, 0)), QUAD, (1, 1, 1, 1), None, uvs, texture)
    camera = nf.Camera((0, 0, 0), fov=nf.Fov(-1, 1, -1, 1), size=(64, 64))
    cpu, gpu = both(build([wall]), camera)
    agree(cpu, gpu)
    color = gpu.require("color")
    assert np.argmax(color[16, 16]) == 0
    assert np.argmax(color[16, 48]) == 1
    assert np.argmax(color[48, 16]) == 2


def test_mirrored_and_moving_instances_agree_with_the_tracer() -> None:
    camera = view((0.2, 1.3, 1.0), (0, 0, -6))
    standing = crowd()
    agree(*both(standing, camera))
    moving = crowd(("one_7", "one_12"))
    agree(*both(moving, camera))
    for step in range(3):
        pose = np.eye(4)
        pose[:3, 3] = (0.5 * step - 1.0, 0.4, -2.5 - step)
        cpu, gpu = both(moving.at({"one_7": pose}), camera)
        agree(cpu, gpu)
        shown = gpu.require("object_id") == moving.object_names.index("one_7")
        assert shown.sum() > 100


def test_normals_of_vertices_are_the_same() -> None:
    """Covers stretched and mirrored instances, a moving one, vertices without a normal, and a flat mesh."""
    vertices, faces = ball(2)
    some = vertices.copy()
    some[::7] = 0.0
    builder = SceneBuilder()
    meshes = [builder.mesh(vertices, faces, normals=normals) for normals in (vertices, some, None)]
    for number, place in enumerate([*PLACES.values()] * 3):
        matrix = place.copy()
        matrix[:3, 3] += (2.5 * (number % 4) - 3.75, 2.5 * (number // 4) - 2.5, -2.0)
        builder.instance(meshes[number // 4], matrix, name=f"{number}")
    scene = builder.build(dynamic=["2"])
    camera = view((0.5, 1.0, 7.0), (0, 0, -2), size=(160, 100))
    for shown in (scene, scene.at({"2": np.diag([-0.7, 1.5, 0.9, 1.0])})):
        cpu, gpu = both(shown, camera)
        same = agree(cpu, gpu)
        same &= np.isfinite(cpu.require("range"))
        # Only directions of normals differ, which follow from barycentric weights that are rounded differently.
        np.testing.assert_allclose(gpu.require("color")[same], cpu.require("color")[same], atol=1e-4)
    many = [frame.require("color") for frame in both(scene, camera, samples=4, channels=("color",))]
    assert np.abs(many[0] - many[1]).mean() < 2e-3


def test_far_from_the_origin_precision_is_kept() -> None:
    surfaces = room()
    shift = np.array([1e6, 2e6, -3e6])
    for surface in surfaces:
        surface.vertices = surface.vertices + shift
    builder = SceneBuilder()
    for number, surface in enumerate(surfaces):
        builder.instance(builder.mesh(surface.vertices, surface.faces), name=str(number))
    scene = builder.build()
    assert np.abs(scene.origin).max() > 1e6
    agree(*both(scene, nf.Camera(tuple(shift + 0.3), fov=nf.Fov(-1, 1, -1, 1), size=(96, 96))), same=0.995)


def test_cameras_inside_objects_and_empty_views_are_drawn() -> None:
    inside = SceneBuilder()
    for size in (0.02, 1.0, 400.0):
        box = room()[0]
        inside.instance(inside.mesh(size / 8 * box.vertices, box.faces), name=f"{size}")
    scene = inside.build()
    for eye in ((0.0, 0.001, 0.0), (0.9, 0.1, 0.0), (0.0, 0.01, 0.0), (3000.0, 10.0, 0.0)):
        agree(*both(scene, view(eye, (eye[0] + 1.0, eye[1] + 0.1, 0.5))))
    away = both(scene, view((3000, 10, 0), (4000, 10, 0)))
    agree(*away)
    assert not np.isfinite(away[1].require("range")).any()


def test_an_empty_scene_is_all_sky() -> None:
    empty = nf.Scene.from_arrays(np.zeros((0, 3)), np.zeros((0, 3), np.uint32))
    cpu, gpu = both(empty, view((0, 0, 0), (0, 0.3, -1)))
    assert agree(cpu, gpu).all()
    np.testing.assert_allclose(gpu.require("color"), cpu.require("color"), atol=1e-6)
    assert np.isnan(gpu.require("normal")).all()
    assert (gpu.require("object_id") == -1).all()


@pytest.mark.parametrize("samples", [2, 4, 16])
def test_antialiasing_converges_to_the_same_picture(city: nf.Scene, samples: int) -> None:
    """The tracer's sample positions are the same except for the hardware's four, whose edges differ slightly."""
    cpu, gpu = both(city, view((0, 1.7, 0), (20, 5, -40), (112, 70)), samples=samples)
    difference = np.abs(cpu.to_image().astype(int) - gpu.to_image()).max(-1)
    plain = nf.render(city, cpu.camera, backend="cpu").to_image().astype(int)
    aliased = np.abs(cpu.to_image().astype(int) - plain).max(-1)
    limit = 0.5 if samples == 4 else 0.05
    assert difference.mean() <= limit * aliased.mean(), (difference.mean(), aliased.mean())


def test_single_channels_equal_those_rendered_together(city: nf.Scene) -> None:
    camera = view((50, 80, 60), (0, 0, 0), size=(97, 61))
    whole = nf.render(
        city, camera, channels=("color", "range", "object_id", "face_id", "position", "normal"), backend="gpu"
    )
    for name in whole.channels:
        alone: NDArray[np.float64] = nf.render(city, camera, channels=(name,), backend="gpu").require(name)
        np.testing.assert_array_equal(alone, whole.require(name))


# Scenes and images beyond an adapter's limits -------------------------------------------------------------------------
def grid(cells: int) -> nf.Scene:
    """Return a square of 1 m cells in the ground plane, two triangles each, row by row along +z."""
    x, z = np.meshgrid(np.arange(cells + 1, dtype=np.float32), np.arange(cells + 1, dtype=np.float32))
    vertices = np.stack([x, np.zeros_like(x), z], axis=-1).reshape(-1, 3)
    corner = (np.arange(cells)[:, None] * (cells + 1) + np.arange(cells)).reshape(-1).astype(np.uint32)
    a, b, c, d = corner, corner + 1, corner + cells + 1, corner + cells + 2
    faces = np.stack([a, c, b, b, c, d], axis=-1).reshape(-1, 3)
    return nf.Scene.from_arrays(vertices, faces)


@pytest.mark.slow
def test_a_mesh_larger_than_a_binding_is_drawn_page_by_page(backend: str) -> None:
    cells = 2200
    scene = grid(cells)
    bound = next(found.largest_binding for found in nf.gpu.adapters() if found.backend == backend)
    # Three words for each face, and as many for half as many vertices.
    if 18 * scene.triangle_count <= bound:
        pytest.skip("this adapter binds the whole mesh")
    size = 300
    # A view from above gives exact ground positions; no pixel's centre lies on an edge.
    camera = nf.Camera(
        (cells / 2 + 0.21, 10.0, cells / 2 + 0.13),
        (-np.sqrt(0.5), 0.0, 0.0, np.sqrt(0.5)),
        fov=nf.Orthographic(-1000.0, 1000.0, -1000.0, 1000.0),
        size=(size, size),
    )
    frame = nf.render(scene, camera, channels=("face_id", "range"), backend="gpu")
    starts = camera.rays()[0]
    column, row = np.floor(starts[..., 0]).astype(np.int64), np.floor(starts[..., 2]).astype(np.int64)
    beyond = (starts[..., 0] - column) + (starts[..., 2] - row) > 1
    expected = 2 * (row * cells + column) + beyond
    assert np.array_equal(frame.require("face_id"), expected)
    assert np.allclose(frame.require("range"), 10.0, rtol=1e-6, atol=0)


def test_many_instances_and_distinct_meshes() -> None:
    scene = nf.datasets.forest(trees=2000, seed=3, detail=1)
    low, high = scene.bounds
    eye = (0.0, float(high[1]) + 5.0, float(high[2]))
    camera = nf.Camera.look_at(eye, (0.0, 0.0, float(low[2]) / 2), fov=nf.Fov.symmetric(70), size=(160, 120))
    cpu, gpu = (
        nf.render(scene, camera, channels=("color", "object_id", "face_id"), backend=backend)
        for backend in ("cpu", "gpu")
    )
    check_ids(cpu.require("object_id"), gpu.require("object_id"), 0.995)
    check_ids(cpu.require("face_id"), gpu.require("face_id"), 0.99)
    check_color(cpu, gpu, percentile=99.0)
