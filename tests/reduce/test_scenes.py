"""Tests of near–far reduction with cut-out materials, placed instances and moving objects."""

from __future__ import annotations

import hashlib

import numpy as np
import pytest

import nearfar as nf
from nearfar._reduce.drawing import MorphKind
from nearfar._scene.builder import SceneBuilder
from tests.support import printed_by_threads
from tests.support.reduce_cases import CENTER, FOV, R1, R2, Array, box, camera, place, rho, street

ALL = ("color", "range", "object_id", "face_id", "position", "normal")
BAKED = ("color", "range", "object_id")


def beside(x: float, y: float, z: float) -> Array:
    """Return a place relative to the centre."""
    return np.asarray(CENTER + np.array([x, y, z]))


def fences() -> nf.Scene:
    """Return fences with holes within r₁, across r₂ and beyond it, a wall far behind them, and a moving fence."""
    texture = np.full((8, 8, 4), 255, np.uint8)
    texture[::2, ::2, 3] = 0
    build = SceneBuilder()
    material = build.material((0.2, 0.7, 0.2, 1), texture, 0.5)
    # Upright squares across x; holes take a quarter of each.
    quad = np.array([[0, 0, -1], [0, 0, 1], [0, 2, 1], [0, 2, -1]], float)
    uvs = np.array([[0, 0], [4, 0], [4, 4], [0, 4]], float)
    fence = build.mesh(quad, [[0, 1, 2], [0, 2, 3]], material=material, uvs=uvs)
    # The fence across r₂ is rotated and stretched; the far one is mirrored.
    turn = np.array([[0.6, 0, 0.8], [0, 1, 0], [-0.8, 0, 0.6]])
    for name, x, z, linear in [
        ("near", 12.0, 0.0, np.diag([1, 4, 8])),
        ("across", 47.0, 8.0, turn @ np.diag([1, 9, 20])),
        ("far", 80.0, -10.0, np.diag([1, 20, -40])),
        ("moving", 15.0, 9.0, np.diag([1, 4, 4])),
    ]:
        matrix = place(*beside(x, -1.7, z))
        matrix[:3, :3] = linear
        build.instance(fence, matrix, name=name)
    wall = build.mesh(*box((200, 0, -300), (210, 150, 300)), material=build.material((0.7, 0.3, 0.2, 1)))
    build.instance(wall, name="wall")
    return build.build(dynamic=["moving"])


@pytest.fixture(scope="module")
def fenced() -> nf.ReducedScene:
    return nf.reduce(fences(), center=CENTER, r1=R1, r2=R2, face_size=1024, samples=1, channels=("color", "object_id"))


@pytest.mark.parametrize("kind", ["blend", "cylinder", "none"])
def test_cut_out_holes_are_open_in_maps_and_near_parts(fenced: nf.ReducedScene, kind: MorphKind) -> None:
    scene, reduced = fenced.scene, fenced.with_morph(kind)
    number = {name: i for i, name in enumerate(scene.object_names)}
    fov = nf.Fov.symmetric(60, 1)
    view = nf.Camera.look_at(CENTER, beside(1, 0.1, 0), fov=fov, size=(200, 200))
    ids = reduced.render(view, channels=BAKED).require("object_id")
    expected = nf.render(scene, view).require("object_id")
    for name in ("near", "across", "far", "moving", "wall"):
        # All fences are visible, so each shows the others through its holes.
        assert (expected == number[name]).sum() > 200, name
    # A texel is 2 mrad wide, a pixel 6: where a silhouette passes within a texel of a pixel's centre, they may differ.
    assert (ids == expected).mean() > 0.995
    near = np.isin(expected, [number["near"], number["moving"]])
    np.testing.assert_array_equal(ids[near], expected[near])
    # One step aside, everything near r₁ is still exact with both tracing methods.
    view = nf.Camera.look_at(beside(0, 0.2, 0.5), beside(12, 0, 0.5), fov=fov, size=(200, 200))
    near = nf.render(scene, view, channels=BAKED).require("object_id") == number["near"]
    assert near.sum() > 200
    assert (reduced.render(view, channels=BAKED).require("object_id") == number["near"])[near].all()


@pytest.mark.slow
def test_bytes_of_bakes_and_frames_do_not_depend_on_the_number_of_threads() -> None:
    code = "from tests.reduce import test_scenes; print(test_scenes.digest())"
    assert printed_by_threads(code) == {digest() + "\n"}


def digest() -> str:
    """Hash of the map and of frames of all kinds, with cut-outs, instances, splits and moving objects."""
    scene, digest = fences(), hashlib.sha256()
    for kind in ("blend", "cylinder", "none"):
        reduced = nf.reduce(
            scene, center=CENTER, r1=R1, r2=R2, face_size=96, samples=3, morph=kind, channels=("color", "object_id")
        )
        assert reduced.env is not None
        for name in reduced.env.channels:
            digest.update(getattr(reduced.env, name).tobytes())
        for offset in ((0.0, 0.0, 0.0), (-4.0, 0.5, 7.0)):
            frame = reduced.render(camera(CENTER + offset, (1, 0.1, 0.1)), samples=2, channels=ALL)
            for name in ALL:
                digest.update(frame.require(name).tobytes())
    return digest.hexdigest()


@pytest.mark.parametrize("kind", ["blend", "cylinder"])
@pytest.mark.parametrize("offset", [(20.0, 0.0, 10.0), (-20.0, 0.0, -10.0)])
def test_far_walls_occlude_only_objects_behind_them(kind: MorphKind, offset: tuple[float, float, float]) -> None:
    scene = street(dynamic=True)
    car = scene.object_names.index("car")
    reduced = nf.reduce(scene, center=CENTER, r1=R1, r2=R2, face_size=512, samples=1, morph=kind, channels=BAKED)
    user, toward = CENTER + np.array(offset), np.array([100.0, 10, 70]) - CENTER
    view = nf.Camera.look_at(user, user + toward, fov=nf.Fov.symmetric(40, 1), size=(200, 200))
    # The tower's face begins at a share of 1, and the car is 4 m long; 20 m ahead or behind, both are shown that much
    # nearer or farther by "cylinder".
    for share, seen in ((0.9, True), (0.97, True), (1.05, False), (1.3, False)):
        frame = reduced.render(view, at={"car": place(*(CENTER + toward * share))})
        assert ((frame.require("object_id") == car).sum() > 20) == seen, share


@pytest.mark.parametrize("kind", ["blend", "cylinder"])
def test_ranges_of_far_pixels_are_displayed_distances(kind: MorphKind) -> None:
    reduced = nf.reduce(
        street(), center=CENTER, r1=R1, r2=R2, face_size=128, samples=1, morph=kind, channels=("color", "range")
    )
    user = CENTER + np.array([15.0, 0.5, -9])
    frame = reduced.render(camera(user, (1, 0.1, 0.5)), channels=("range", "position", "face_id"))
    position = frame.require("position")
    far = (frame.require("face_id") < 0) & np.isfinite(position[..., 0]) & (rho(position) > R2)
    assert far.sum() > 1000
    points = position[far].astype(np.float64)
    shown = nf.morph(points, user=user, center=CENTER, r1=R1, r2=R2, kind=kind)
    # Float32 at 2 km, in the position and in the range.
    np.testing.assert_allclose(frame.require("range")[far], np.linalg.norm(shown - user, axis=1), rtol=0, atol=5e-4)


def test_parallel_rays_require_an_all_near_scene() -> None:
    scene = street()
    view = nf.Camera.look_at(CENTER, beside(1, -0.3, 0), fov=nf.Orthographic(-40, 40, -25, 25), size=(64, 40))
    reduced = nf.reduce(scene, center=CENTER, r1=R1, r2=R2, face_size=8, samples=1)
    with pytest.raises(ValueError, match=r"camera: expected a perspective view or a cube face.*got parallel rays"):
        reduced.render(view)
    whole = nf.reduce(scene, center=CENTER, r1=1e4, r2=2e4)
    np.testing.assert_array_equal(whole.render(view).require("color"), nf.render(scene, view).require("color"))


def test_cube_faces_are_views_of_90_degrees_seen_from_inside() -> None:
    reduced = nf.reduce(street(), center=CENTER, r1=R1, r2=R2, face_size=64, samples=1, channels=BAKED)
    user = beside(4, 0.2, 3)
    face = reduced.render(nf.Camera((user[0], user[1], user[2]), fov=nf.CubeFace(0), size=(64, 64)))
    ahead = nf.Camera.look_at(user, beside(5, 0.2, 3), fov=nf.Fov.symmetric(90, 1), size=(64, 64))
    np.testing.assert_array_equal(face.require("object_id"), reduced.render(ahead).require("object_id")[:, ::-1])


def test_moving_objects_beyond_r1_are_drawn_and_counted() -> None:
    scene = street(dynamic=True).at({"car": place(300, 0.75, 0)})
    reduced = nf.reduce(scene, center=CENTER, r1=R1, r2=R2, face_size=8, samples=1, morph="none", boundary="r1")
    assert reduced.stats["drawn"] == reduced.stats["near"] + 12


def test_radii_that_differ_by_rounding_are_refused() -> None:
    reduced = nf.reduce(street(), center=CENTER, r1=0, r2=1e-300, face_size=16, samples=1)
    assert np.isfinite(reduced.render(camera(CENTER + 1.0, (1, 0, 0))).require("color")).all()


def test_users_beyond_float32_are_refused() -> None:
    reduced = nf.reduce(street(), center=CENTER, r1=R1, r2=R2, face_size=8, samples=1)
    view = nf.Camera((1e300, 0, 0), fov=FOV, size=(16, 16))
    with pytest.raises(ValueError, match=r"position: .*within 1e30 m"):
        reduced.render(view)
