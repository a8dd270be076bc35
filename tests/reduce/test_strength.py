"""The morph's strength: points, bent rays, folds and frames between the centre's view and the full morph."""

from __future__ import annotations

import itertools
import math
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar._reduce.drawing import Method, MorphKind, morph_spheres
from nearfar._scene.levels import Leveled
from tests.support.gpu_cases import ADAPTERS, adapter, check_color, check_ids
from tests.support.growth_cases import AHEAD, KINDS, USER, reduced
from tests.support.reduce_cases import ALL, CENTER, R1, R2, Array, camera, rho

PLACE: dict[str, Any] = {"user": USER, "center": CENTER, "r1": R1, "r2": R2}
STRENGTHS = (0.1, 0.4, 0.6, 0.95)


def scattered(count: int = 3000) -> Array:
    random = np.random.default_rng(1)
    return CENTER + random.normal(size=(count, 3)) * 10.0 ** random.uniform(0.5, 2.0, (count, 1))


def unit(vectors: Array) -> Array:
    return np.asarray(vectors / np.linalg.norm(vectors, axis=-1, keepdims=True))


def slowly(points: Array, kind: str, strength: float) -> Array:
    """Evaluate Eq. 1–3 of 2022 and Alg. 1 of CloVR point by point, with the weight times the strength."""
    shown = []
    for point in points:
        a, b, offset = point - USER, point - CENTER, USER - CENTER
        radius = math.hypot(b[0], b[2])
        w = strength * min(max((R2 - radius) / (R2 - R1), 0.0), 1.0)
        d = unit(w * unit(a) + (1 - w) * unit(b))
        t = w * np.linalg.norm(a) + (1 - w) * np.linalg.norm(b)
        if kind == "cylinder" and radius > math.hypot(offset[0], offset[2]):
            quadratic = [d[0] ** 2 + d[2] ** 2, 2 * (d[0] * offset[0] + d[2] * offset[2])]
            t = max(np.roots([*quadratic, offset[0] ** 2 + offset[2] ** 2 - radius**2]).real)
        shown.append(USER + t * d)
    return np.array(shown)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("strength", STRENGTHS)
def test_points_are_morphed_by_weight_times_strength(kind: MorphKind, strength: float) -> None:
    points = scattered(500)
    found = nf.morph(points, kind=kind, strength=strength, **PLACE)
    # Roots of polynomials by eigenvalues have about ten digits.
    np.testing.assert_allclose(found, slowly(points, kind, strength), atol=1e-7)
    single = nf.morph(points.astype(np.float32), kind=kind, strength=strength, **PLACE)
    expected = nf.morph(points.astype(np.float32).astype(float), kind=kind, strength=strength, **PLACE)
    np.testing.assert_allclose(single, expected, rtol=1e-6, atol=1e-5)


@pytest.mark.parametrize("kind", KINDS)
def test_strength_1_is_the_morph_and_0_the_view_from_the_centre(kind: MorphKind) -> None:
    points = scattered()
    np.testing.assert_array_equal(
        nf.morph(points, kind=kind, strength=1.0, **PLACE), nf.morph(points, kind=kind, **PLACE)
    )
    none = nf.morph(points, kind=kind, strength=0.0, **PLACE)
    np.testing.assert_allclose(unit(none - USER), unit(points - CENTER), atol=1e-12)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("strength", [0.0, *STRENGTHS, 0.5])
def test_bent_rays_contain_the_points_displayed_there(kind: MorphKind, strength: float) -> None:
    points = scattered(600)
    points = points[(rho(points) < R2) & (np.linalg.norm(points - USER, axis=1) > 1.0)]
    shown = nf.morph(points, kind=kind, strength=strength, **PLACE)
    directions = unit(shown - USER)
    level = np.hypot(directions[:, 0], directions[:, 2]) > 0.05
    tolerance = 1e-4
    lines = nf.bend_rays(directions[level], tolerance=tolerance, kind=kind, strength=strength, **PLACE)
    passed = []
    for point, direction, line in zip(points[level], directions[level], lines, strict=True):
        line = line[np.isfinite(line[:, 0])]
        along, s = (line - USER) @ direction, (point - USER) @ direction
        assert (np.diff(along) > 0).all()
        assert s > along[0] - 1e-9
        where = np.array([np.interp(s, along, line[:, axis]) for axis in range(3)])
        passed.append(where if s < along[-1] else line[-1] + (s - along[-1]) * direction)
    # Beside each point the ray passes one that is displayed in the same direction.
    seen = unit(nf.morph(np.array(passed), kind=kind, strength=strength, **PLACE) - USER)
    assert np.linalg.norm(seen - directions[level], axis=1).max() <= tolerance


@pytest.mark.parametrize("strength", [0.25, 0.5, 0.75, 1.0])
def test_a_weaker_blend_folds_later(strength: float) -> None:
    margin = nf.fold_margin(CENTER, center=CENTER, r1=R1, r2=R2, strength=strength)
    full = nf.fold_margin(CENTER, center=CENTER, r1=R1, r2=R2)
    # From a strength of ½, users beyond r1 have points in opposite directions.
    assert min(full / strength, R1) - 0.01 <= margin <= (R2 - R1) / strength
    assert nf.fold_margin(CENTER, center=CENTER, r1=R1, r2=R2, strength=0.0) == math.inf


@pytest.mark.parametrize("strength", [0.05, 0.2, 0.5, 0.8, 1.0])
def test_the_cylinder_never_folds_for_users_within_r1(strength: float) -> None:
    """Points of a fine grid keep their order in the direction in which a bent ray passes them."""
    place: dict[str, Any] = {"center": (0.0, 0.0, 0.0), "r1": 7.0, "r2": 10.0, "kind": "cylinder", "strength": strength}
    margin = nf.fold_margin((0, 0, 0), **place)
    assert margin >= 7.0 - 1e-3
    if strength > 0.43:
        assert margin == pytest.approx(7.0, abs=1e-3)
    turn, height = np.linspace(0, 2 * np.pi, 361)[:-1], np.linspace(-6.0, 6.0, 41)
    user = np.array([6.9, 0.2, 0.0])
    for radius in np.linspace(6.95, 10.0, 16):
        points = np.stack(
            [
                radius * np.cos(turn)[:, None] + 0 * height,
                0 * turn[:, None] + height,
                radius * np.sin(turn)[:, None] + 0 * height,
            ],
            axis=-1,
        )
        seen = unit(nf.morph(points.reshape(-1, 3), user=user, **place) - user).reshape(points.shape)
        across, up = np.roll(seen, -1, axis=0) - seen, np.diff(seen, axis=1)
        sides = np.einsum("ijk,ijk->ij", np.cross(across[:, :-1], up), seen[:, :-1])
        # Points of a cylinder as U sees them from within: all have the same winding.
        assert (sides < 0).all() or (sides > 0).all()


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("method", ["vertex", "exact"])
def test_a_frame_of_strength_0_equals_radius_0(kind: MorphKind, method: Method) -> None:
    whole, view = reduced(kind), camera(USER, AHEAD)
    given: dict[str, Any] = {"method": method, "channels": ALL, "env": False}
    none, nothing = whole.render(view, strength=0.0, **given), whole.render(view, radius=0.0, **given)
    for channel in ALL:
        np.testing.assert_array_equal(none.require(channel), nothing.require(channel))
    assert none.stats["fold_margin"] == math.inf
    full, plain = whole.render(view, strength=1.0, **given), whole.render(view, **given)
    for channel in ALL:
        np.testing.assert_array_equal(full.require(channel), plain.require(channel))


@pytest.mark.parametrize(("strength", "kind"), [*zip(STRENGTHS, itertools.cycle(KINDS), strict=False)])
def test_vertex_morph_and_bent_rays_agree(kind: MorphKind, strength: float) -> None:
    """A pixel shows a point that the morph displays there."""
    whole, view = reduced(kind), camera(USER, AHEAD, (80, 45))
    given: dict[str, Any] = {"strength": strength, "channels": ALL, "env": False}
    # Rays keep their tolerance. Next to a user far from the centre no bound holds for vertices, as the frame says:
    # pieces of ground are as long as they may be there.
    for method, greatest in (("exact", 0.1), ("vertex", 8.0)):
        frame = whole.render(view, tolerance_px=0.1, **given | {"method": method})
        near = (frame.require("face_id") >= 0) & (rho(frame.require("position")) < R2)
        assert near.sum() > 2500
        points = frame.require("position")[near].astype(float) + frame.origin
        found = view.project(nf.morph(points, kind=kind, strength=strength, **PLACE))[:, :2]
        rows, columns = np.nonzero(near)
        miss = np.abs(found - np.stack([columns, rows], axis=1) - 0.5).max(axis=1)
        assert np.percentile(miss, 99) < greatest
        assert frame.stats["tolerance_held"] is (method == "exact")


@pytest.mark.parametrize("kind", KINDS)
def test_points_move_continuously_with_strength(kind: MorphKind) -> None:
    points = scattered()
    points = points[np.linalg.norm(points - USER, axis=1) > 8.0]
    shown = [unit(nf.morph(points, kind=kind, strength=s, **PLACE) - USER) for s in np.linspace(0.0, 1.0, 201)]
    # From the centre's direction to the user's a point turns by less than |U−O| π/2 over its distance from either.
    least = np.minimum(np.linalg.norm(points - USER, axis=1), np.linalg.norm(points - CENTER, axis=1))
    step = np.linalg.norm(np.diff(shown, axis=0), axis=-1)
    assert (step < 4.0 * np.linalg.norm(USER - CENTER) / least / 200 * np.pi).all()


@pytest.mark.parametrize(("name", "kind"), [*zip(ADAPTERS, KINDS, strict=True)])
def test_adapters_agree_for_all_strengths_and_radii(name: str, kind: MorphKind) -> None:
    whole, view = reduced(kind), camera(USER, AHEAD, (320, 180))
    settings: dict[str, Any] = {"channels": ALL[:4], "method": "vertex", "env": False, "tolerance_px": 2.0}
    with adapter(name):
        # Back to the full radius: pieces split for another one are not reused.
        states: list[dict[str, Any]] = [{"strength": 0.6}, {"strength": 0.3, "radius": 40.0}, {}, {"radius": 0.0}, {}]
        for growth in states:
            cpu, gpu = (whole.render(view, backend=backend, **growth, **settings) for backend in ("cpu", "gpu"))
            assert cpu.stats["fold_margin"] == gpu.stats["fold_margin"]
            check_ids(cpu.require("object_id"), gpu.require("object_id"))
            check_color(cpu, gpu)


def test_growth_is_stored_in_a_scene_and_frames_may_override_it() -> None:
    whole, view = reduced("cylinder"), camera(USER, AHEAD)
    grown = whole.with_growth(40.0, 0.5)
    expected = whole.render(view, radius=40.0, strength=0.5)
    np.testing.assert_array_equal(grown.render(view).require("color"), expected.require("color"))
    np.testing.assert_array_equal(nf.render(grown, view, samples=1).require("color"), expected.require("color"))
    back = grown.render(view, strength=1.0, radius=R2)
    np.testing.assert_array_equal(back.require("color"), whole.render(view).require("color"))
    points = scattered(10)
    near = nf.morph(points, user=USER, center=CENTER, r1=R1 * 0.8, r2=40.0, kind="cylinder", strength=0.5)
    np.testing.assert_array_equal(grown.displayed(points, USER), near)


def test_balls_of_a_weaker_morph_enclose_their_points() -> None:
    middle = CENTER + np.array([6.0, 0.0, 2.0])
    ball = Leveled(("ball",), np.array([0]), (), np.array([0]), middle[None], np.array([1.5]))
    grown: dict[str, Any] = {"r1": R1, "r2": R2, "strength": 0.5}
    shown = morph_spheres(ball, USER, center=(3.0, 1.7, -2.0), kind="blend", growth=grown)
    points = middle + 1.5 * unit(np.random.default_rng(0).normal(size=(500, 3)))
    apart = nf.morph(points, user=USER, center=CENTER, kind="blend", **grown) - shown.centers[0]
    assert np.linalg.norm(apart, axis=1).max() <= shown.radii[0]


def test_the_conventional_method_has_no_strength() -> None:
    with pytest.raises(ValueError, match="strength: expected 1 without a morph"):
        reduced("none").render(camera(USER, AHEAD), strength=0.5)
