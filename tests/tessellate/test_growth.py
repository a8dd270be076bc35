"""Tests of tessellation for the growth of a cylinder morph: within its tolerance at every stage, and without cracks."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import trimesh

import nearfar as nf
from tests.support.tessellate_cases import CENTER, PIXEL, VIEW, Array, ground, open_edges, users

NEAR = 0.7


def split(mesh: Any, *, r2: float, tolerance_px: float = 8.0, reach: float = 1.0, **growth: Any) -> Any:
    zones: dict[str, Any] = {"center": CENTER, "r1": NEAR * r2, "r2": r2, "user_region": reach}
    return nf.tessellate(mesh, **zones, tolerance_px=tolerance_px, camera=VIEW, kind="cylinder", **growth)


def cylinder_morph(points: Array, eye: Array, radius: float, strength: float) -> Array:
    """The cylinder morph, relative to the eye, in its printed form (Alg. 1 of CloVR), with a strength."""
    x, v = points - CENTER, eye - CENTER
    rho = np.hypot(x[:, 0], x[:, 2])
    w = strength * np.clip((radius - rho) / (radius - NEAR * radius), 0, 1)[:, None]
    blend = w * (x - v) / np.linalg.norm(x - v, axis=1, keepdims=True)
    blend += (1 - w) * x / np.linalg.norm(x, axis=1, keepdims=True)
    d = blend / np.linalg.norm(blend, axis=1, keepdims=True)
    # The greater root of |v + t d|² = ρ², horizontally.
    a = d[:, 0] ** 2 + d[:, 2] ** 2
    b = d[:, 0] * v[0] + d[:, 2] * v[2]
    c = v[0] ** 2 + v[2] ** 2 - rho**2
    t = (np.sqrt(b**2 - a * c) - b) / a
    return np.asarray(t[:, None] * d)


def greatest_error(triangles: Array, eyes: Array, morphs: list[tuple[float, float]], seed: int = 0) -> float:
    """Greatest angle between the interpolated morph of corners and the morph of the point, in pixels."""
    weights = np.random.default_rng(seed).dirichlet(np.ones(3), 4)
    weights = np.concatenate([weights, (1 - np.eye(3)) / 2, np.full((1, 3), 1 / 3)])
    points = np.einsum("wk,tkc->twc", weights, triangles).reshape(-1, 3)
    worst = 0.0
    for eye, (radius, strength) in zip(eyes, morphs, strict=True):
        corners = cylinder_morph(triangles.reshape(-1, 3), eye, radius, strength).reshape(triangles.shape)
        mixed = np.einsum("wk,tkc->twc", weights, corners).reshape(-1, 3)
        exact = cylinder_morph(points, eye, radius, strength)
        cross = np.linalg.norm(np.cross(mixed, exact), axis=1)
        worst = max(worst, float(np.arctan2(cross, (mixed * exact).sum(axis=1)).max()))
    return worst / PIXEL


def triangles_beyond(triangles: Array, radius: float) -> Array:
    """Triangles whose corners all lie beyond a distance from the axis."""
    rho = np.hypot(*np.moveaxis((triangles - CENTER)[..., [0, 2]], -1, 0))
    return np.asarray(triangles[(rho > radius).all(axis=1)])


@pytest.mark.parametrize(("least", "r2"), [(12.0, 12.0), (22.0, 32.0)])
def test_the_error_stays_within_the_tolerance_for_all_radii_of_a_growth(least: float, r2: float) -> None:
    made = triangles_beyond(np.asarray(split(ground(60.0), r2=r2, radius=least, tolerance_px=16.0).triangles), 2.0)
    morphs = [(radius, 1.0) for radius in np.linspace(least, r2, 12)]
    before = greatest_error(triangles_beyond(np.asarray(ground(60.0).triangles), 2.0), users(1.0, 12, 0), morphs)
    after = greatest_error(made, users(1.0, 12, 1), morphs)
    assert before > 40
    # The bound covers all heights, directions and radii at once; on the ground the error is a small part of it.
    assert 0.02 * 16.0 < after <= 16.0


def test_the_error_stays_within_the_tolerance_for_all_strengths() -> None:
    made = split(ground(30.0), r2=10.0, tolerance_px=16.0, reach=0.5, strength=0.0)
    morphs = [(10.0, strength) for strength in np.linspace(0.05, 1.0, 12)]
    triangles = triangles_beyond(np.asarray(made.triangles), 2.6 * 0.5)
    assert len(triangles) > 0.3 * len(made.faces)
    assert 0.02 * 16.0 < greatest_error(triangles, users(0.5, 12, 1), morphs) <= 16.0


def test_there_are_no_cracks_and_unsplit_triangles_keep_their_bits() -> None:
    house = trimesh.creation.box(bounds=[[7, -3, -15], [40, 25, 30]])
    made = split(house, r2=32.0, radius=22.0)
    assert open_edges(np.asarray(made.triangles)) == 0
    assert len(made.faces) > 500
    near = trimesh.creation.icosphere(radius=5).apply_translation(CENTER)
    again = split(near, r2=32.0, radius=22.0)
    np.testing.assert_array_equal(again.faces, near.faces)
    scene = split(nf.Scene.from_trimesh(house), r2=32.0, radius=22.0)
    assert open_edges(scene.triangles()) == 0


def test_pieces_grow_with_the_height() -> None:
    def count(height: float) -> int:
        wall = trimesh.Trimesh(
            np.array([[-20, 0, 8], [20, 0, 8], [20, height, 8], [-20, height, 8]]) + CENTER, [[0, 1, 2], [0, 2, 3]]
        )
        return len(split(wall, r2=10.0, tolerance_px=8.0).faces)

    # The height doubles 12 times; each doubling of a high wall takes about as many pieces as the whole low one.
    assert count(1e5) < 12 * count(30.0)


@pytest.mark.parametrize("changed", [{"radius": 20.0}, {"strength": 0.5}, {"kind": "sphere"}])
def test_a_blend_has_no_growth(changed: dict[str, Any]) -> None:
    with pytest.raises(ValueError, match=f"^{next(iter(changed))}: expected"):
        nf.tessellate(
            ground(), center=CENTER, r1=30.0, r2=50.0, user_region=1.0, tolerance_px=1.0, camera=VIEW, **changed
        )
