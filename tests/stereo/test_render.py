"""Tests of hybrid pictures: against a slow assembly of separate pictures, against points in space, and limit cases."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar._scene.builder import SceneBuilder
from nearfar.stereo import HybridRig
from nearfar.stereo._settings import Assembly
from tests.support.hybrid_cases import AHEAD, HEAD, SHALLOW, cut, places, rig, rotate, scene, textured, towards
from tests.support.reduce_cases import ALL, street


def taps(rig: HybridRig, side: str, coverage: NDArray[Any]) -> tuple[Any, Any, Any]:
    """Columns, rows and weights (H, W, 4) of the third camera's pixels that are mixed for each pixel of an eye.

    Weights are bilinear; pixels at whose position the eye has its own surface are excluded, unless none would remain.
    """
    width, height = rig.center_size
    at = places(rig, side)
    x, y = np.clip(at[..., 0] - 0.5, 0.0, width - 1.0), np.clip(at[..., 1] - 0.5, 0.0, height - 1.0)
    left, top = np.floor(x).astype(int), np.floor(y).astype(int)
    columns = np.minimum(left[..., None] + (0, 1, 0, 1), width - 1)
    rows = np.minimum(top[..., None] + (0, 0, 1, 1), height - 1)
    across, down = (x - left)[..., None], (y - top)[..., None]
    weights = np.abs(np.array([1, 0, 1, 0]) - across) * np.abs(np.array([1, 1, 0, 0]) - down)
    back = np.stack([columns + 0.5, rows + 0.5, np.ones(columns.shape)], -1) @ rig.homography(side).T
    u, v = (np.floor(back[..., n] / back[..., 2]).astype(int) for n in (0, 1))
    inside = (u >= 0) & (v >= 0) & (u < rig.size[0]) & (v < rig.size[1])
    covered = np.where(inside, coverage[np.where(inside, v, 0), np.where(inside, u, 0)], 0.0)
    left_over = weights * (1.0 - covered)
    total = left_over.sum(axis=-1, keepdims=True)
    return columns, rows, np.where(total > 1e-6, left_over / np.maximum(total, 1e-9), weights)


@pytest.mark.parametrize("cant", [0.0, 6.0])
@pytest.mark.parametrize("samples", [1, 4])
def test_eyes_show_their_own_near_part_in_front_of_the_shared_picture(samples: int, cant: float) -> None:
    """Compares with pictures drawn one by one with planes, and assembled in NumPy."""
    world, hybrid = scene(), rig(cant=cant)
    frame = hybrid.render(world, HEAD, AHEAD, samples=samples, channels=("color", "range", "face_id", "coverage"))
    left, right, center = hybrid.cameras(HEAD, AHEAD)
    overlap, channels = SHALLOW - hybrid.overlap, ("color", "range", "face_id", "coverage", "position")
    shared = nf.render(world, center, samples=samples, clip=cut(hybrid, overlap, math.inf), channels=channels)
    whole = {}
    for side, camera in (("left", left), ("right", right)):
        got = getattr(frame, side)
        own = nf.render(world, camera, samples=samples, clip=cut(hybrid, 0.1, SHALLOW), channels=channels)
        coverage = own.require("coverage")[..., None].astype(np.float64)
        # An empty sample of the eye's own picture has the colour of the sky, which is nearly constant
        # within a pixel.
        nothing = nf.render(empty(), camera, samples=samples)
        columns, rows, weights = taps(hybrid, side, own.require("coverage"))
        far = (shared.require("color")[rows, columns] * weights[..., None]).sum(axis=2)
        expected = own.require("color") + (1.0 - coverage) * (far - nothing.require("color"))
        tolerance = 2e-6 if samples == 1 else 4e-3
        # Narrow gaps that both pictures leave open show what the eye itself sees there.
        most = weights.argmax(axis=-1)[..., None]
        nearest = [np.take_along_axis(values, most, -1)[..., 0] for values in (rows, columns)]
        behind = nf.render(world, camera, samples=samples, clip=cut(hybrid, SHALLOW, math.inf), channels=channels)
        open_ = (coverage[..., 0] == 0.0) & (shared.require("coverage")[tuple(nearest)] == 0.0)
        filled = open_ & (got.require("coverage") > 0.0)
        assert filled.sum() < 1e-3 * filled.size
        np.testing.assert_array_equal(got.require("color")[filled], behind.require("color")[filled])
        np.testing.assert_array_equal(got.require("face_id")[filled], behind.require("face_id")[filled])
        np.testing.assert_allclose(got.require("color")[~filled], expected[~filled], atol=tolerance)
        is_own = (own.require("face_id") >= 0) | filled
        assert 0.1 < is_own.mean() < 0.9
        near = is_own & ~filled
        np.testing.assert_array_equal(got.require("face_id")[near], own.require("face_id")[near])
        np.testing.assert_array_equal(got.require("range")[near], own.require("range")[near])
        column, row = (np.take_along_axis(values, most, -1)[..., 0][~is_own] for values in (columns, rows))
        # Two pixels may have equal weights.
        clear = np.sort(weights, axis=-1)[~is_own][:, -1] - np.sort(weights, axis=-1)[~is_own][:, -2] > 1e-4
        same = got.require("face_id")[~is_own] == shared.require("face_id")[row, column]
        assert same[clear].all()
        points = shared.require("position")[row, column] + world.origin
        away = np.nan_to_num(np.linalg.norm(points - camera.position, axis=1), nan=math.inf)
        # Points of the ground's triangles, 2 km long, are rounded by 1e-4 m.
        np.testing.assert_allclose(got.require("range")[~is_own][clear], away[clear], rtol=5e-5)
        whole[side] = got
    assert frame.center is not None
    assert frame.center.camera == center


def empty() -> nf.Scene:
    return SceneBuilder().build()


@pytest.mark.parametrize("samples", [1, 3])
@pytest.mark.parametrize("assembly", ["bilinear", "resolved"])
def test_culling_changes_no_pixel_of_the_eyes(assembly: Assembly, samples: int) -> None:
    frames = [
        rig().render(scene(), HEAD, AHEAD, cull=cull, assembly=assembly, samples=samples, channels=ALL)
        for cull in ("frustum", "discard", "occlusion")
    ]
    for other in frames[1:]:
        for side in ("left", "right"):
            for name in ALL:
                np.testing.assert_array_equal(
                    getattr(frames[0], side).require(name), getattr(other, side).require(name)
                )
    pixels = [frame.stats["pixels"] for frame in frames]
    total = math.prod(rig().center_size)
    assert (pixels[0]["center"], pixels[0]["discarded"]) == (total, 0)
    assert all(0 < count["discarded"] == total - count["center"] for count in pixels[1:])


def test_resolved_pixels_show_what_the_third_camera_sees_there() -> None:
    """Compares with the third camera's ray through each position, traced alone."""
    world, hybrid = textured(), rig(size=(60, 50))
    frame = hybrid.render(world, HEAD, AHEAD, assembly="resolved", channels=("color", "coverage", "face_id"))
    blurred = hybrid.render(world, HEAD, AHEAD)
    _, _, center = hybrid.cameras(HEAD, AHEAD)
    own = nf.render(
        world, hybrid.cameras(HEAD, AHEAD)[0], clip=cut(hybrid, 0.1, SHALLOW), channels=("face_id",)
    ).require("face_id")
    fov, (width, height) = center.fov, center.size
    assert isinstance(fov, nf.Fov)
    pitch = np.array([(fov.right - fov.left) / width, (fov.up - fov.down) / height])
    errors, blurs = [], []
    for row, column in np.argwhere(own < 0)[::7]:
        x, y = places(hybrid, "left")[row, column]
        a, b = fov.left + pitch[0] * (x - 0.5), fov.up - pitch[1] * (y + 0.5)
        pixel = nf.Camera(
            center.position, center.orientation, fov=nf.Fov(a, a + pitch[0], b, b + pitch[1]), size=(1, 1)
        )
        truth = nf.render(world, pixel, clip=cut(hybrid, SHALLOW - hybrid.overlap, math.inf)).require("color")[0, 0]
        errors.append(np.abs(frame.left.require("color")[row, column] - truth).max())
        blurs.append(np.abs(blurred.left.require("color")[row, column] - truth).max())
    # If none of the four pixels around shows the face at the position, the mixture stays.
    assert np.mean(np.array(errors) < 1e-5) > 0.97
    assert np.mean(errors) < 0.5 * np.mean(blurs)


def test_displacements_beyond_the_plane_equal_the_closed_form() -> None:
    """Compares displacements by the third camera's positions with the field, for asymmetric and rotated eyes."""
    for cant in (0.0, 5.0):
        hybrid = rig(cant=cant, size=(500, 420))
        frame = hybrid.render(scene(), HEAD, AHEAD, cull="frustum", channels=("position", "color"))
        left, _, center = hybrid.cameras(HEAD, AHEAD)
        assert frame.center is not None
        points = frame.center.require("position").reshape(-1, 3).astype(np.float64) + scene().origin
        ahead = rotate(AHEAD, (0.0, 0.0, -1.0))
        depth = (points - center.position) @ ahead - hybrid.center_offset
        true = left.project(points)[:, :2]
        x, y = np.meshgrid(np.arange(center.width) + 0.5, np.arange(center.height) + 0.5)
        shown = np.stack([x.ravel(), y.ravel(), np.ones(x.size)])
        at = (hybrid.homography("left") @ shown).T
        moved = at[:, :2] / at[:, 2:] - true
        inside = (
            np.isfinite(true).all(axis=1) & (depth > SHALLOW) & (true > 0).all(axis=1) & (true < left.size).all(axis=1)
        )
        fov = hybrid.left.fov
        checked = 0
        for n in np.flatnonzero(inside)[::997]:
            tangents = (
                fov.left + (fov.right - fov.left) * true[n, 0] / left.width,
                fov.up - (fov.up - fov.down) * true[n, 1] / left.height,
            )
            to = hybrid.shown("left", tangents, depth=float(depth[n]))
            expected = np.subtract(to, tangents) * (
                left.width / (fov.right - fov.left),
                -left.height / (fov.up - fov.down),
            )
            np.testing.assert_allclose(moved[n], expected, atol=0.02)
            checked += 1
        assert checked > 50
        assert np.abs(moved[inside]).max() < 1.01 * max(
            hybrid.max_error(axis=axis) for axis in ("horizontal", "vertical")
        )


def test_scenes_on_one_side_of_the_plane_are_separate_or_shared() -> None:
    world, far, near = scene(), rig(20000.0), rig(1.2)
    stereo = far.render(world, HEAD, AHEAD, channels=ALL)
    assert stereo.center is None
    assert set(stereo.stats["seconds"]) == {"culling", "eyes"}
    for side, camera in zip(("left", "right"), far.cameras(HEAD, AHEAD), strict=False):
        plain = nf.render(world, camera, channels=ALL, clip=cut(far, 0.1, math.inf))
        for name in ALL:
            np.testing.assert_array_equal(getattr(stereo, side).require(name), plain.require(name))
    mono = near.render(street(ground=False), HEAD, AHEAD, channels=ALL)
    assert set(mono.stats["seconds"]) == {"center", "culling", "assembly", "filling"}
    assert mono.center is not None
    assert (mono.left.require("face_id") >= 0).any()


def test_triangles_in_each_view_are_counted() -> None:
    import trimesh

    world = trimesh.Scene()
    across_the_plane = trimesh.creation.icosphere(1, 0.5).apply_translation((1, 0, -12))
    world.add_geometry(across_the_plane, node_name="across")
    for name, z, subdivisions in [("near", -4, 0), ("far", -40, 2), ("behind", 9, 3)]:
        world.add_geometry(trimesh.creation.icosphere(subdivisions, 0.5).apply_translation((0, 0, z)), node_name=name)
    # Only the left eye sees this far to the left.
    world.add_geometry(trimesh.creation.box((0.2, 0.2, 0.2)).apply_translation((-4.5, 0, -4)), node_name="left")
    counted = rig().triangles(nf.Scene.from_trimesh(world), (0, 0, 0))
    # The eyes are 0.02 m ahead of the head's origin.
    depths = -np.asarray(across_the_plane.triangles)[..., 2] - 0.02
    before, beyond = (depths < SHALLOW).any(axis=1), (depths > SHALLOW - rig().overlap).any(axis=1)
    near, far, left = 20, 320, 12
    assert counted == {
        "left": near + before.sum() + left,
        "right": near + before.sum(),
        "center": beyond.sum() + far,
        "thrice": (before & beyond).sum(),
        "plain": 2 * (near + 80 + far) + left,
    }


def test_surfaces_across_the_plane_leave_no_gap() -> None:
    """In a closed room every pixel of both eyes shows a surface, at any plane."""
    room = nf.datasets.room()
    rng = np.random.default_rng(3)
    for mono_plane in (0.8, 1.7, 3.1):
        hybrid = rig(mono_plane, size=(150, 120))
        for _ in range(3):
            head = room.bounds.mean(axis=0) + rng.uniform(-0.5, 0.5, 3)
            way = towards(head, head + rng.normal(size=3))
            frame = hybrid.render(room, head, way, channels=("coverage", "color"), near=1e-6)
            plain = [nf.render(room, camera, channels=("coverage",)) for camera in hybrid.cameras(head, way)[:2]]
            for got, expected in zip((frame.left, frame.right), plain, strict=True):
                # The sky in a window differs by the error of the shared picture.
                missing = (got.require("coverage") == 0.0) & (expected.require("coverage") > 0.0)
                assert missing.mean() <= 0.01


def test_reduced_scenes_are_morphed_for_the_head() -> None:
    """One user for all views: the picture of near geometry at the plane equals that of both eyes."""
    world, center = street(), np.array(HEAD) + np.array([2.0, 0.0, 1.0])
    reduced = nf.reduce(world, center=center, r1=20.0, r2=50.0, face_size=64, samples=1)
    frame = rig().render(reduced, HEAD, AHEAD, channels=("color",))
    _, _, camera = rig().cameras(HEAD, AHEAD)
    middle = np.array(camera.position) + rig().center_offset * rotate(AHEAD, (0.0, 0.0, -1.0))
    shared = reduced.render(
        camera, user=middle, clip=cut(rig(), SHALLOW - rig().overlap, math.inf), channels=("color",), method="vertex"
    )
    assert frame.center is not None
    drawn = frame.center.require("color").any(axis=-1)
    np.testing.assert_array_equal(frame.center.require("color")[drawn], shared.require("color")[drawn])


def test_edges_resolved_before_assembly_lack_the_background() -> None:
    """Multisampling without coverage mixes the backdrop into edges; with coverage they equal separate stereo."""
    world, hybrid = scene(), rig(size=(160, 130))
    camera = hybrid.cameras(HEAD, AHEAD)[0]
    plain = nf.render(world, camera, samples=16, channels=("color",)).require("color")
    frame = hybrid.render(world, HEAD, AHEAD, samples=16, channels=("color", "coverage"))
    own = nf.render(world, camera, samples=16, clip=cut(hybrid, 0.1, SHALLOW), channels=("color", "coverage"))
    coverage = own.require("coverage")
    edge = (coverage > 0.0) & (coverage < 1.0)
    assert edge.sum() > 100
    # The sky at edges of the eye's picture remains in them.
    resolved = np.where((coverage > 0.0)[..., None], own.require("color"), frame.left.require("color"))
    wrong, right = (
        np.abs(picture - plain).max(axis=-1)[edge].mean() for picture in (resolved, frame.left.require("color"))
    )
    assert right < 0.35 * wrong


@pytest.mark.parametrize("r2", [20.0, 50.0])
def test_the_error_of_a_shared_map_at_r2_is_the_setback(r2: float) -> None:
    """The map is looked up from s behind the eyes: at r2 the error is s / r2 radians, far below a pixel."""
    hybrid = rig(size=(1344, 1120))
    center = hybrid.cameras(HEAD, AHEAD)[2]
    ahead = rotate(AHEAD, (0.0, 0.0, -1.0))
    middle = np.array(center.position) + hybrid.center_offset * ahead
    away = hybrid.center_offset / r2
    pixels = max(hybrid.size[0] / (hybrid.left.fov.right - hybrid.left.fov.left), 0.0)
    ways = center.rays()[1][::97, ::89].reshape(-1, 3)
    # Near geometry ends at middle + r2 · way; the map shows there what the third camera's own direction has.
    ends = middle + r2 * ways
    seen = ends - np.array(center.position)
    seen /= np.linalg.norm(seen, axis=1, keepdims=True)
    angles = np.arccos(np.clip((seen * ways).sum(axis=1), -1.0, 1.0))
    assert angles.max() <= away
    # For these eyes s is 26 mm, and a tangent is 640 pixels.
    assert angles.max() * pixels < 17.0 / r2


def test_pictures_of_a_reduced_scene_meet_at_r2() -> None:
    """Where near geometry ends, the third camera shows it within s / r2 of the position at which the map continues."""
    r1, r2, center = 8.0, 20.0, np.subtract(HEAD, (0.6, 0.0, 0.3))
    reduced = nf.reduce(street(), center=center, r1=r1, r2=r2, face_size=64, samples=1, channels=("color", "range"))
    hybrid = rig(6.0, size=(600, 500))
    frame = hybrid.render(reduced, HEAD, AHEAD, channels=("position",), cull="frustum")
    assert frame.center is not None
    points = frame.center.require("position").astype(np.float64) + frame.center.origin
    away = points - center
    rho = np.hypot(away[..., 0], away[..., 2])
    towards_point = away / np.linalg.norm(away, axis=-1, keepdims=True)
    apart = np.linalg.norm(np.cross(towards_point, frame.center.camera.rays()[1]), axis=-1)
    residue = hybrid.center_offset / r2
    edge = (rho > 0.99 * r2) & (rho <= r2)
    assert edge.sum() > 100
    # In the last hundredth before r2 the morph still leaves 1 % × r2 / (r2 − r1) of the head's 0.7 m.
    left = 0.01 * r2 / (r2 - r1) * float(np.linalg.norm(np.subtract(HEAD, center))) / r2
    assert apart[edge].max() < residue + left
    beyond = (rho > r2) & np.isfinite(rho)
    assert beyond.sum() > 1000
    # The map is looked up along the camera's own rays; a texel's range belongs to its centre.
    assert np.percentile(apart[beyond], 99) < residue


def test_arguments_are_checked() -> None:
    hybrid, world = rig(), scene()
    wrong: list[tuple[str, dict[str, Any]]] = [
        ("near: expected less than the mono plane's 12 m, got 12", {"near": 12.0}),
        ("near: expected a number above 0, got 0", {"near": 0.0}),
        ("channels: ", {"channels": ()}),
    ]
    for words, changed in wrong:
        arguments: dict[str, Any] = {"position": HEAD, "orientation": AHEAD} | changed
        with pytest.raises(ValueError, match=words):
            hybrid.render(world, **arguments)
    reduced = nf.reduce(world, center=HEAD, r1=20.0, r2=50.0, face_size=16, samples=1)
    with pytest.raises(ValueError, match="assembly: expected 'bilinear' for ReducedScene"):
        hybrid.render(reduced, HEAD, assembly="resolved")
