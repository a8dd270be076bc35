"""Tests of bent rays, fold margins, and frames that show the morph pixel by pixel."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given, strategies as st
from numpy.typing import NDArray

import nearfar as nf
from nearfar._scene.builder import SceneBuilder
from tests.support.reduce_cases import CENTER, R1, R2, camera, place, rho, street

Array = NDArray[np.float64]
RADII: dict[str, Any] = {"center": CENTER, "r1": R1, "r2": R2}
USERS = [(0, 0, 8), (-6, 0.3, -5), (9, -0.5, 0), (0, 6, 0)]


def angle(a: Array, b: Array) -> Array:
    return np.asarray(np.arctan2(np.linalg.norm(np.cross(a, b), axis=-1), (a * b).sum(axis=-1)))


def directions(count: int, seed: float = 0.5) -> Array:
    """Return evenly spread directions (a spherical Fibonacci set)."""
    n = np.arange(count) + seed
    y, turn = 1.0 - 2.0 * n / count, n * np.pi * (3.0 - np.sqrt(5.0))
    r = np.sqrt(1.0 - y * y)
    return np.stack([r * np.cos(turn), y, r * np.sin(turn)], axis=1)


@pytest.mark.parametrize("kind", ["blend", "cylinder"])
@pytest.mark.parametrize("offset", USERS)
def test_bent_rays_pass_through_points_that_the_morph_shows_in_their_direction(
    kind: str, offset: tuple[float, float, float]
) -> None:
    user, rays, tolerance = CENTER + np.array(offset), directions(2000), 1e-4
    lines = nf.bend_rays(rays, user=user, tolerance=tolerance, kind=kind, **RADII)
    assert lines.dtype == np.float64
    assert lines.shape[::2] == (2000, 3)
    np.testing.assert_array_equal(lines[:, 0], np.tile(user, (2000, 1)))
    count = np.isfinite(lines[..., 0]).sum(axis=1)
    for row in range(0, 2000, 7):
        points = lines[row, 1 : count[row]]
        if not len(points):
            continue
        shown = nf.morph(points, user=user, kind=kind, **RADII) - user
        assert angle(shown, rays[row]).max() < 1e-9
        chords = (points[:-1, None] + np.linspace(0, 1, 33)[:, None] * np.diff(points, axis=0)[:, None]).reshape(-1, 3)
        assert angle(nf.morph(chords, user=user, kind=kind, **RADII) - user, rays[row]).max(initial=0) <= tolerance
        # Beyond r₂ the polyline follows the parallel ray from the centre, up to the rounding of its 50 m and more.
        assert abs(np.hypot(*(points[-1] - CENTER)[[0, 2]]) - R2) < 1e-9
        assert angle(points[-1] - CENTER, rays[row]) < 1e-12


@pytest.mark.parametrize(
    ("user", "rays", "tolerance"),
    [
        # A curve that winds about its chord and meets it near all three of its quarters.
        ((5, 1.7, 0), [[-0.29435804, 0.01554978, 0.95556871]], 1e-4),
        # Users outside r1 who look up: the bend is about as near as the centre, the end extremely far.
        *[((away, 1.7, 0), [[0, 1, 0], [1e-3, 1, 0], [0.003, 1, 0.002], [0.03, 1, 0]], 1e-3) for away in (12, 20, 25)],
        # A tolerance close to the least allowed one.
        ((5, 1.7, 0), [[0, 0.1, 1]], 1e-9),
    ],
)
def test_chords_stay_on_curves_that_wind_and_on_upright_ones(
    user: tuple[float, float, float], rays: Any, tolerance: float
) -> None:
    curve: dict[str, Any] = {"user": np.array(user), "center": (0, 1.7, 0), "r1": 10, "r2": 100}
    for direction in rays:
        line = nf.bend_rays([direction], tolerance=tolerance, **curve)[0]
        # Positions along chords are dense at both ends, because the last chord of a steep curve is kilometres long.
        share = np.concatenate([np.geomspace(1e-6, 0.5, 60), 1 - np.geomspace(1e-6, 0.5, 60)])
        chords = (line[:-1, None] + share[:, None] * np.diff(line, axis=0)[:, None]).reshape(-1, 3)
        chords = chords[np.linalg.norm(chords - curve["user"], axis=1) > 0.1]
        shown = nf.morph(chords, **curve) - curve["user"]
        assert angle(shown, np.array(direction, float)).max() <= tolerance


def test_first_chords_of_users_outside_r1_stay_on_the_curve() -> None:
    # There the morph moves even the points beside the user.
    random = np.random.default_rng(0)
    share = np.concatenate([np.geomspace(1e-6, 0.5, 60), np.linspace(0.5, 1, 20)])[:, None]
    cases = [((-4.1627374, 10.5524377, -19.15428574), (-0.80997306, 0.58004929, 0.08661795), 0.0, 96.84906785, 1e-2)]
    for _ in range(50):
        r1 = random.choice([0.0, random.uniform(0, 20)])
        r2 = r1 + random.uniform(20, 100)
        turn = random.uniform(0, 2 * np.pi)
        height = random.uniform(-10, 15)
        margin = nf.fold_margin((0, height, 0), center=(0, 0, 0), r1=max(r1, 1e-3), r2=r2)
        away = random.uniform(0.3, 1) * margin
        user = (away * np.cos(turn), height, away * np.sin(turn))
        cases.append((user, tuple(random.normal(size=3)), r1, r2, 10 ** random.uniform(-4, -1.5)))
    for user, direction, r1, r2, tolerance in cases:
        curve: dict[str, Any] = {"user": np.array(user), "center": (0, 0, 0), "r1": r1, "r2": r2}
        line = nf.bend_rays([direction], tolerance=tolerance, **curve)[0]
        chords = (line[:-1, None] + share * np.diff(line, axis=0)[:, None]).reshape(-1, 3)
        shown = nf.morph(chords, **curve) - curve["user"]
        assert angle(shown, np.array(direction)).max() <= tolerance, (user, direction, r1, r2)


def test_rays_that_need_no_bend_are_one_point() -> None:
    at_center = nf.bend_rays(directions(10), user=CENTER, tolerance=1e-3, **RADII)
    assert at_center.shape == (10, 1, 3)
    user = CENTER + np.array([5.0, 0, 0])
    straight = nf.bend_rays([[0, 1, 0], [0, -2, 0], [3, 0, 0]], user=user, tolerance=1e-3, **RADII)
    np.testing.assert_array_equal(straight, np.tile(user, (3, 1, 1)))
    assert nf.bend_rays(np.empty((0, 3)), user=user, tolerance=1e-3, **RADII).shape == (0, 1, 3)


def test_finer_tolerances_only_add_points() -> None:
    rays, user = directions(200), CENTER + np.array([4.0, 0, 7.0])
    counts = [
        np.isfinite(nf.bend_rays(rays, user=user, tolerance=t, **RADII)[..., 0]).sum() for t in (1e-2, 1e-3, 1e-4)
    ]
    assert counts == sorted(counts)
    assert counts[0] < counts[-1]


def test_refuses_tolerances_below_rounding() -> None:
    with pytest.raises(ValueError, match="tolerance: expected at least 1e-9"):
        nf.bend_rays([[0, 0, 1]], user=CENTER, tolerance=1e-10, **RADII)


def determinants(points: Array, user: Array, r1: float, r2: float) -> Array:
    """Determinants of the morph's Jacobian by differences: rounding of 1e-9 over 2e-4, truncation errors of 1e-8."""
    step = 1e-4 * np.eye(3)
    shown = [
        nf.morph(np.concatenate([points + e, points - e]), user=user, center=[0, 0, 0], r1=r1, r2=r2) for e in step
    ]
    columns = [(s[: len(points)] - s[len(points) :]) / 2e-4 for s in shown]
    return np.asarray(np.linalg.det(np.stack(columns, axis=-1)))


def ring(r1: float, r2: float) -> Array:
    radius, turn, lift = np.meshgrid(
        np.linspace(r1 + 1e-3, r2 - 1e-3, 24), np.linspace(0, np.pi, 37), np.linspace(-1.5, 1.5, 61), indexing="ij"
    )
    points = np.stack([radius * np.cos(turn), radius * np.tan(lift), radius * np.sin(turn)], axis=-1)
    return points.reshape(-1, 3)


@pytest.mark.parametrize(("r1", "r2", "height"), [(30, 50, 0), (30, 50, 5), (30, 50, 25), (40, 50, 3), (10, 50, 0)])
def test_folds_begin_where_the_margin_ends(r1: float, r2: float, height: float) -> None:
    margin = nf.fold_margin([0, height, 0], center=[0, 0, 0], r1=r1, r2=r2)
    points, slack = ring(r1, r2), 0.02 * (r2 - r1)
    assert 0 < margin <= r2 - r1
    assert determinants(points, np.array([margin - 1e-3 * (r2 - r1), height, 0]), r1, r2).min() > 0
    # The grid's points are half a metre apart, so that it detects a fold slightly late.
    assert determinants(points, np.array([margin + slack, height, 0]), r1, r2).min() < 0
    away = nf.fold_margin([3, height, -4], center=[0, 0, 0], r1=r1, r2=r2)
    assert away == pytest.approx(margin - 5, abs=2e-4 * (r2 - r1))


@pytest.mark.parametrize(("r1", "r2"), [(8.8, 50), (8, 20), (10, 100)])
def test_folds_beside_the_user_begin_where_the_margin_ends(r1: float, r2: float) -> None:
    margin = nf.fold_margin([0, 0, 0], center=[0, 0, 0], r1=r1, r2=r2)
    assert margin == pytest.approx((r2 + r1) / 3, abs=1e-3 * (r2 - r1))
    # Only points between user and centre fold at first, and those nearest to the user before all others.
    before, beyond = (np.array([margin + change * (r2 - r1), 0, 0]) for change in (-0.01, 0.01))
    beside = np.geomspace(3e-3, margin - r1 - 0.02 * r2, 50)[:, None] * [-1, 0, 0]
    assert determinants(before + beside, before, r1, r2).min() > 0
    signs = determinants(beyond + beside, beyond, r1, r2) < 0
    assert signs[0]
    assert not signs[-1]


def test_margins_of_the_paper_and_of_the_cylinder() -> None:
    assert 19.0 < nf.fold_margin(CENTER, **RADII) < 19.9
    assert nf.fold_margin(CENTER + np.array([25.0, 0, 0]), **RADII) < 0
    assert nf.fold_margin(CENTER + np.array([3.0, 9, 4]), kind="cylinder", **RADII) == R1 - 5
    # A hundred metres above the centre the ground folds wherever the user is.
    assert nf.fold_margin([0, 100, 0], center=[0, 0, 0], r1=30, r2=50) == -math.inf
    with pytest.raises(ValueError, match="user: expected a place within 1e30 m"):
        nf.fold_margin([0, 1e300, 0], center=[0, 0, 0], r1=30, r2=50)


def cards(count: int = 6000) -> nf.Scene:
    """Small upright cards between the radii, beyond the centre for users at +x, each an object's face."""
    n = np.arange(count)
    share = [np.modf((n + 0.5) * step)[0] for step in (0.8191725134, 0.6710436067, 0.5497004779)]
    radius, turn, lift = R1 + (R2 - R1) * share[0], np.pi + (share[1] - 0.5), 1.9 * (share[2] - 0.5)
    middle = np.stack([radius * np.cos(turn), radius * np.tan(lift), radius * np.sin(turn)], axis=1) + CENTER
    side = 0.5 * np.stack([-np.sin(turn), np.zeros(count), np.cos(turn)], axis=1)
    up = np.array([0, 0.5, 0])
    vertices = np.stack([middle - side - up, middle + side - up, middle + up], axis=1).reshape(-1, 3)
    return nf.Scene.from_arrays(vertices, np.arange(3 * count).reshape(-1, 3), n.astype(np.int32))


@pytest.mark.parametrize(("beyond", "folds"), [(-2.0, False), (4.0, True)])
def test_pictures_fold_exactly_beyond_the_margin(beyond: float, folds: bool) -> None:
    margin = nf.fold_margin(CENTER, **RADII)
    user = CENTER + np.array([margin + beyond, 0, 0])
    reduced = nf.reduce(cards(), face_size=8, samples=1, **RADII)
    view = nf.Camera.look_at(user, CENTER, fov=nf.Fov.symmetric(100, 1), size=(512, 512))
    by_distance = reduced.render(view, channels=("face_id",), method="vertex", tolerance_px=0.1).require("face_id")
    along_ray = reduced.render(view, channels=("face_id",), method="exact").require("face_id")
    # A z-buffer orders points by displayed distance, the tracer along the ray; they differ only where one direction
    # shows its points in another order. At a card's edge either face may be shown.
    differs = (by_distance != along_ray)[1:-1, 1:-1]
    inside = np.ones_like(differs)
    for image in (by_distance, along_ray):
        for dy, dx in ((0, 1), (2, 1), (1, 0), (1, 2)):
            inside &= image[dy : dy + 510, dx : dx + 510] == image[1:-1, 1:-1]
    found = int((differs & inside).sum())
    assert (along_ray >= 0).mean() > 0.1
    assert found > 20 if folds else found == 0


@pytest.fixture(scope="module")
def scene() -> nf.Scene:
    return street(dynamic=True)


@pytest.fixture(scope="module", params=["blend", "cylinder"])
def reduced(scene: nf.Scene, request: pytest.FixtureRequest) -> nf.ReducedScene:
    return nf.reduce(scene, face_size=128, samples=1, morph=request.param, channels=("color", "range"), **RADII)


def oracle(reduced: nf.ReducedScene, scene: nf.Scene, view: nf.Camera) -> NDArray[np.int64]:
    """Trace triangles along bent rays, segment by segment with a tolerance of 1e-4 pixels."""
    width, height = view.size
    _, rays = view.rays()
    rays = rays.reshape(-1, 3)
    morph: dict[str, Any] = {"user": view.position, "kind": reduced.morph, **RADII}
    lines = nf.bend_rays(rays, tolerance=1e-4 * 2 / width, **morph)
    found = np.full(len(rays), -1)
    for k in range(lines.shape[1] - 1):
        open_rays = np.flatnonzero((found < 0) & np.isfinite(lines[:, k + 1, 0]))
        legs = lines[open_rays, k + 1] - lines[open_rays, k]
        hits = nf.cast_rays(scene, lines[open_rays, k], legs)
        reached = hits.t_hit <= np.linalg.norm(legs, axis=1) * (1 + 1e-6)
        found[open_rays[reached]] = hits.triangle_index[reached]
    return found.reshape(height, width)


@pytest.mark.parametrize("offset", USERS)
def test_exact_frames_equal_rays_bent_one_by_one(
    reduced: nf.ReducedScene, scene: nf.Scene, offset: tuple[float, float, float]
) -> None:
    view = camera(CENTER + np.array(offset), (1, -0.05, -0.2), (96, 54))
    frame = reduced.render(view, method="exact", channels=("face_id", "position"), tolerance_px=0.01)
    expected = oracle(reduced, scene, view)
    standing = frame.require("face_id")
    assert (expected >= 0).mean() > 0.2
    # Rays that pass an edge within the tolerance may hit either side: of 96 × 54 pixels about 600 are at edges.
    assert (standing != expected).mean() < 1e-3


@pytest.mark.parametrize("offset", USERS)
def test_exact_pixels_show_points_that_the_morph_maps_there(
    reduced: nf.ReducedScene, offset: tuple[float, float, float]
) -> None:
    view = camera(CENTER + np.array(offset), (1, -0.05, -0.2))
    frame = reduced.render(view, method="exact", channels=("face_id", "position", "range"), env=False)
    near = (rho(frame.require("position")) <= R2) & (frame.require("face_id") >= 0)
    points = frame.require("position")[near].astype(np.float64)
    shown = nf.morph(points, user=view.position, kind=reduced.morph, **RADII)
    x, y = np.meshgrid(np.arange(160) + 0.5, np.arange(90) + 0.5)
    miss = view.project(shown)[:, :2] - np.stack([x, y], axis=-1)[near]
    # A tenth of a pixel is the default tolerance.
    assert np.hypot(*miss.T).max() < 0.1
    distance = np.linalg.norm(shown - view.position, axis=1)
    # Positions on the ground's triangles of 4,000 m are rounded to 2.4e-4 m, twice.
    np.testing.assert_allclose(frame.require("range")[near], distance, atol=1e-3)


def test_vertex_and_exact_frames_agree_except_at_edges(reduced: nf.ReducedScene) -> None:
    view = camera(CENTER + np.array([3.0, 0.2, 6.0]), (1, 0.0, 0.3), (480, 270))
    images = {
        (method, env): reduced.render(view, method=method, channels=("face_id", "color"), env=env)
        for method in ("vertex", "exact")
        for env in (True, False)
    }
    for env in (True, False):
        a, b = images["vertex", env], images["exact", env]
        assert (a.require("face_id") != b.require("face_id")).mean() < 5e-3
    # The map shows hits of the ideal picture's rays, resampled.
    far = (images["exact", True].require("face_id") < 0) & (images["exact", False].require("face_id") >= 0)
    error = np.abs(images["exact", True].require("color") - images["exact", False].require("color"))[far]
    assert far.sum() > 1000
    assert np.median(error) < 0.01


def test_the_ideal_conventional_picture_breaks_at_r2(scene: nf.Scene) -> None:
    plain = nf.reduce(scene, face_size=64, samples=1, morph="none", **RADII)
    view = camera(CENTER + np.array([0.0, 0, 8.0]), (1, 0, -0.3))
    ideal = plain.render(view, env=False, channels=("position", "face_id"))
    beyond = rho(ideal.require("position")) > R2
    points = ideal.require("position")[beyond].astype(np.float64)
    x, y = np.meshgrid(np.arange(160) + 0.5, np.arange(90) + 0.5)
    pixels = np.stack([x, y], axis=-1)[beyond & (ideal.require("face_id") >= 0)]
    points = points[np.isfinite(points[:, 0])]
    # The view from O has the same camera, moved there.
    np.testing.assert_allclose(view.project(points - CENTER + view.position)[:, :2], pixels, atol=1e-2)
    same = plain.render(view, env=False, method="exact", channels=("face_id",)).require("face_id")
    np.testing.assert_array_equal(same, ideal.require("face_id"))


@given(
    x=st.floats(-80, 80),
    z=st.floats(-80, 80),
    height=st.floats(-1.0, 60),
    yaw=st.floats(-3.2, 3.2),
    tilt=st.floats(-9, 9),
)
def test_users_anywhere_get_a_picture(
    reduced: nf.ReducedScene, x: float, z: float, height: float, yaw: float, tilt: float
) -> None:
    user = CENTER + np.array([x, height, z])
    view = nf.Camera.look_at(
        user, user + np.array([np.cos(yaw), tilt, np.sin(yaw)]), fov=nf.Fov.symmetric(100, 1), size=(12, 12)
    )
    frame = reduced.render(view, method="exact", channels=("color", "range"), env=False)
    assert np.isfinite(frame.require("color")).all()
    assert not np.isnan(frame.require("range")).any()


@pytest.mark.parametrize(
    ("user", "aim", "fov"),
    [
        ((2.73, 1.31, -4.09), (1.85, 1.32, -3.58), 90),
        ((-7.37, 1.19, 2.34), (-6.22, 0.91, 2.61), 60),
        ((0.06, 1.58, -4.31), (-0.41, 1.31, -4.59), 110),
        ((-4.79, 1.22, 3.23), (-5.0, 0.61, 1.61), 110),
    ],
)
def test_exact_frames_deviate_from_the_morph_by_at_most_their_tolerance(
    user: tuple[float, float, float], aim: tuple[float, float, float], fov: float
) -> None:
    # A ground of one-metre cells, so that the rounding of hits is far below the tolerance.
    x, z = np.meshgrid(np.arange(-120.0, 121), np.arange(-120.0, 121))
    number = np.arange(x.size).reshape(x.shape)
    a, b, c, d = (number[i : i + 240, j : j + 240].ravel() for i in (0, 1) for j in (0, 1))
    faces = np.concatenate([np.stack(corners, axis=1) for corners in ((a, c, b), (b, c, d))])
    floor = nf.Scene.from_arrays(np.stack([x, 0 * x, z], axis=-1).reshape(-1, 3), faces.astype(np.uint32))
    radii: dict[str, Any] = {"center": (0, 1.7, 0), "r1": 10, "r2": 100}
    flat = nf.reduce(floor, face_size=16, **radii)
    view = nf.Camera.look_at(user, aim, fov=nf.Fov.symmetric(fov, 1.6), size=(320, 200))
    _, rays = view.rays()
    # Size of a pixel at its place in radians: tangents per pixel times cos² of its angle off the axis.
    cosine = rays @ (np.array(aim) - user) / np.linalg.norm(np.array(aim) - user) / np.linalg.norm(rays, axis=-1)
    pixel = 2 * math.tan(math.radians(fov / 2)) / 320 * cosine**2
    for tolerance in (0.1, 0.02):
        frame = flat.render(view, method="exact", channels=("position",), env=False, tolerance_px=tolerance)
        seen = frame.require("position").astype(np.float64)
        rho = np.hypot(seen[..., 0], seen[..., 2])
        bent = (rho > 10) & (rho < 100)
        assert bent.sum() > 1000
        shown = nf.morph(seen[bent], user=user, **radii) - np.array(user)
        assert (angle(shown, rays[bent]) / pixel[bent]).max() <= tolerance


def test_exact_frames_refuse_settings_without_bent_rays(reduced: nf.ReducedScene) -> None:
    flat = nf.Camera((4.0, 2.7, -1.0), fov=nf.Orthographic(-5, 5, -5, 5), size=(8, 8))
    build = SceneBuilder()
    build.instance(build.mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]), name="near")
    alone = nf.reduce(build.build(), face_size=8, **RADII)
    assert alone.env is None
    with pytest.raises(ValueError, match="perspective"):
        alone.render(flat, method="exact")


def test_bytes_do_not_depend_on_threads_or_earlier_frames(reduced: nf.ReducedScene, scene: nf.Scene) -> None:
    view = camera(CENTER + np.array([3.0, 0.2, 6.0]), (1, 0.0, 0.3))
    for method in ("vertex", "exact"):
        first = reduced.render(view, method=method, at={"car": place(20, 1, 4)}, channels=("color",))
        reduced.render(view, method=method, at={"car": place(45, 1, -8)}, channels=("color",))
        again = reduced.render(view, method=method, at={"car": place(20, 1, 4)}, channels=("color",))
        np.testing.assert_array_equal(first.require("color"), again.require("color"))
