"""A user's eye apart from the camera: against finely split scenes that are morphed as a whole, on every back end."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar._reduce.drawing import MorphKind
from nearfar._scene.builder import SceneBuilder
from tests.support.gpu_cases import ADAPTERS, adapter, backend_of, check_color, check_ids, check_range, edges
from tests.support.morphed_oracle import AHEAD, ALL, APART, PLACES, USER, check_near, pictures, reduced_street
from tests.support.reduce_cases import CENTER, R1, R2, box, camera, place, rho


@pytest.fixture(params=["blend", "cylinder"])
def reduced(request: pytest.FixtureRequest) -> nf.ReducedScene:
    return reduced_street(request.param)


@pytest.mark.parametrize("where", PLACES)
@pytest.mark.parametrize("apart", APART)
def test_a_camera_shows_geometry_morphed_for_the_user(
    reduced: nf.ReducedScene, apart: tuple[float, float, float], where: str
) -> None:
    view = camera(USER + np.array(apart), AHEAD)
    frame, expected, radii = pictures(reduced.morph, view, where)
    check_near(frame, expected, radii)
    # The car is geometry at all distances: with the camera's parallax, also in front of the map, which has none.
    car = reduced.scene.object_names.index("car")
    cars = [picture.require("object_id") == car for picture in (frame, expected)]
    assert cars[1].sum() > 5
    assert not ((cars[0] != cars[1]) & ~edges(cars[1])).any()


@pytest.mark.parametrize("apart", APART)
def test_near_pixels_show_points_morphed_for_the_user(
    reduced: nf.ReducedScene, apart: tuple[float, float, float]
) -> None:
    view = camera(USER + np.array(apart), AHEAD)
    pose = {"car": place(*PLACES["between"])}
    frame = reduced.render(view, user=USER, at=pose, channels=ALL, tolerance_px=0.25, backend="cpu")
    near = frame.require("face_id") >= 0
    points = frame.require("position")[near].astype(np.float64)
    shown = nf.morph(points, user=USER, center=CENTER, r1=R1, r2=R2, kind=reduced.morph)
    x, y = np.meshgrid(np.arange(view.size[0]) + 0.5, np.arange(view.size[1]) + 0.5)
    miss = np.abs(view.project(shown)[:, :2] - np.stack([x, y], axis=-1)[near]).max(axis=1)
    assert miss.max() < 0.3
    away = np.linalg.norm(shown - view.position, axis=1)
    np.testing.assert_allclose(frame.require("range")[near], away, rtol=3e-3)


def test_the_map_is_sampled_along_the_cameras_directions(reduced: nf.ReducedScene) -> None:
    view = camera(USER + np.array(APART[1]), AHEAD)
    frame = reduced.render(view, user=USER, channels=ALL, backend="cpu")
    far = frame.require("face_id") < 0
    assert reduced.env is not None
    assert 0.1 < far.mean() < 0.9
    directions = view.rays()[1][far]
    expected = reduced.env.sample(directions, filter="linear")
    # The kernel blends colours in float32 along directions in float32.
    np.testing.assert_allclose(frame.require("color")[far], expected, atol=1e-4)
    beside = reduced.render(view, channels=("color",), backend="cpu").require("color")
    both = far & (reduced.render(view, channels=("face_id",), backend="cpu").require("face_id") < 0)
    np.testing.assert_array_equal(frame.require("color")[both], beside[both])


@pytest.mark.parametrize("backend", ["cpu", *ADAPTERS])
def test_a_user_at_the_cameras_position_changes_nothing(reduced: nf.ReducedScene, backend: str) -> None:
    pose = {"car": place(*PLACES["beyond"])}
    for eye in (USER, CENTER):
        view = camera(eye, AHEAD)
        for env in (True, False):
            with backend_of(backend) as name:
                settings: dict[str, Any] = {"at": pose, "channels": ALL, "env": env, "backend": name}
                own, told = reduced.render(view, **settings), reduced.render(view, user=eye, **settings)
                assert own.stats["tolerance_held"]
            for channel in ALL:
                np.testing.assert_array_equal(told.require(channel), own.require(channel))


def test_for_a_user_at_the_centre_near_geometry_is_undistorted(reduced: nf.ReducedScene) -> None:
    """The camera beside the centre has parallax, although nothing is morphed."""
    view, pose = camera(CENTER + np.array(APART[1]), AHEAD), {"car": place(*PLACES["beyond"])}
    frame = reduced.render(view, user=CENTER, at=pose, channels=ALL, backend="cpu")
    truth = nf.render(reduced.scene, view, at=pose, channels=ALL, backend="cpu")
    near = rho(truth.require("position")) < R2 - 1e-3
    car = truth.require("object_id") == reduced.scene.object_names.index("car")
    assert near.sum() > 1500
    assert car.sum() > 5
    np.testing.assert_array_equal(frame.require("face_id")[near | car], truth.require("face_id")[near | car])
    np.testing.assert_allclose(frame.require("range")[near | car], truth.require("range")[near | car], rtol=1e-5)


@pytest.mark.parametrize("backend", ["cpu", *ADAPTERS])
def test_without_a_morph_there_is_no_user(reduced: nf.ReducedScene, backend: str) -> None:
    conventional = reduced.with_morph("none")
    view, pose = camera(USER, AHEAD), {"car": place(*PLACES["beyond"])}
    with backend_of(backend) as name:
        for method in ("vertex", "exact"):
            settings: dict[str, Any] = {"at": pose, "channels": ALL, "method": method, "backend": name}
            own = conventional.render(view, **settings)
            told = conventional.render(view, user=USER + np.array(APART[1]), **settings)
            for channel in ALL:
                np.testing.assert_array_equal(told.require(channel), own.require(channel))


@pytest.mark.parametrize(("name", "apart", "env"), [*zip(ADAPTERS, APART, (True, False), strict=True)])
def test_adapters_agree_with_the_tracer_for_users(
    reduced: nf.ReducedScene, name: str, apart: tuple[float, float, float], env: bool
) -> None:
    view = camera(USER + np.array(apart), AHEAD, (320, 180))
    for where in PLACES.values():
        pose = {"car": place(*where)}
        with adapter(name):
            # The same vertices, so only rounding differs.
            settings: dict[str, Any] = {"user": USER, "at": pose, "channels": ALL, "env": env, "tolerance_px": np.inf}
            cpu, gpu = (reduced.render(view, backend=backend, **settings) for backend in ("cpu", "gpu"))
            split = reduced.render(view, user=USER, at=pose, channels=ALL, env=env, backend="gpu")
            assert not split.stats["tolerance_held"]
        check_ids(cpu.require("object_id"), gpu.require("object_id"))
        check_ids(cpu.require("face_id"), gpu.require("face_id"))
        check_color(cpu, gpu)
        # Beyond r₂ corners of the car are drawn on other planes, where no map but the far part itself is behind it.
        check_range(cpu, gpu, tolerance=5e-5, worst=1e-3)
        finer = reduced.render(view, user=USER, at=pose, channels=ALL, env=env, backend="cpu")
        check_ids(finer.require("object_id"), split.require("object_id"))
        check_color(finer, split)


@pytest.mark.parametrize("kind", ["blend", "cylinder"])
def test_far_instances_at_the_edges_of_a_view_are_not_culled(kind: MorphKind) -> None:
    """Culling takes into account that far geometry has no parallax between user and camera."""
    builder = SceneBuilder()
    angles = np.linspace(0, 2 * np.pi, 120, endpoint=False)
    places = [place(70 * np.cos(angle), 0.0, 70 * np.sin(angle)) for angle in angles]
    builder.place_many(builder.mesh(*box((-1, 0, -1), (1, 6, 1))), np.array(places), "post")
    ring = nf.reduce(builder.build(), center=(0, 1.7, 0), r1=R1, r2=R2, face_size=16, samples=1, morph=kind)
    user = np.array([2.0, 1.7, -1.0])
    for side in (-9.0, 9.0):
        view = camera(user + np.array([0, 0, side]), (1, 0, 0))
        with adapter("vulkan"):
            cpu, gpu = (
                ring.render(view, user=user, channels=("object_id",), env=False, backend=backend).require("object_id")
                for backend in ("cpu", "gpu")
            )
        assert (cpu >= 0).sum() > 300
        check_ids(cpu, gpu, share=0.995)


def test_bent_rays_require_the_users_eye(reduced: nf.ReducedScene) -> None:
    view = camera(USER, AHEAD)
    own = reduced.render(view, method="exact").require("color")
    np.testing.assert_array_equal(reduced.render(view, user=USER, method="exact").require("color"), own)
    with pytest.raises(ValueError, match=r"user: expected the camera's own position with method='exact', .*'vertex'"):
        reduced.render(view, user=USER + 0.01, method="exact")
    with pytest.raises(ValueError, match="user: expected a place within"):
        reduced.render(view, user=(1e31, 0, 0))


def test_both_eyes_of_a_user_share_one_morph(reduced: nf.ReducedScene) -> None:
    """In pictures of a shot the geometry is the user's, whichever camera renders."""
    eyes = [camera(USER + np.array([0, 0, side]), AHEAD) for side in (-0.03, 0.03)]
    frames = [nf.render(reduced, eye, user=USER, channels=ALL, backend="cpu") for eye in eyes]
    for frame, eye in zip(frames, eyes, strict=True):
        same = reduced.render(eye, user=USER, channels=ALL, backend="cpu")
        np.testing.assert_array_equal(frame.require("range"), same.require("range"))
        near: NDArray[np.bool_] = frame.require("face_id") >= 0
        shown = nf.morph(
            frame.require("position")[near].astype(float), user=USER, center=CENTER, r1=R1, r2=R2, kind=reduced.morph
        )
        away = np.linalg.norm(shown - eye.position, axis=1)
        np.testing.assert_allclose(frame.require("range")[near], away, rtol=3e-3)


@pytest.mark.stress
@pytest.mark.parametrize("count", [1, 64])
def test_splits_of_very_many_pieces_are_coarser(count: int) -> None:
    """A square of ground, whole or of many squares, whose tolerance requires more than four million pieces."""
    build = SceneBuilder()
    line = np.linspace(-20.0, 20.0, count + 1)
    x, z = (axis.ravel() for axis in np.meshgrid(line, line))
    first = (np.arange(count)[:, None] * (count + 1) + np.arange(count)).ravel()
    a, b, c, d = first, first + 1, first + count + 1, first + count + 2
    faces = np.concatenate([np.stack([a, c, b], -1), np.stack([b, c, d], -1)])
    vertices = np.stack([x, np.zeros_like(x), z], -1)
    build.instance(build.mesh(vertices, faces, material=build.material((0.5, 0.5, 0.5, 1.0))), name="a")
    reduced = nf.reduce(build.build(), center=(0.0, 1.7, 0.0), r1=8.0, r2=16.0, face_size=8, samples=1)
    view = camera(np.array((1.0, 1.7, 0.5)), AHEAD)
    fine, finer = (reduced.render(view, tolerance_px=tolerance, backend="cpu") for tolerance in (3e-4, 3e-5))
    assert fine.stats["tolerance_held"]
    assert not finer.stats["tolerance_held"]
    assert fine.stats["frame_triangles"] < finer.stats["frame_triangles"] <= (1 << 22) + 2 * count * count
    # The bound holds for 10⁻⁴ as well, so that precision does not limit it.
    least = reduced.render(view, tolerance_px=1e-4, backend="cpu")
    assert least.stats["tolerance_held"]
    assert finer.stats["frame_triangles"] == least.stats["frame_triangles"]
