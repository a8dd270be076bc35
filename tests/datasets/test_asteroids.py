"""Tests of the procedural asteroids: counts, separation, levels within their error, consistent queries."""

from __future__ import annotations

import numpy as np
import pytest

import nearfar as nf
from nearfar import datasets
from nearfar.datasets import _rocks as rocks
from nearfar.datasets._shapes import Soup
from tests.support.solids import digest, lone_edges, volume

FEW = datasets.asteroids(200, 1200, seed=2)


def test_the_default_equals_the_paper() -> None:
    belt = datasets.asteroids()
    assert len(belt.centers) == len(belt) == 29_264
    assert abs(belt.triangle_count / len(belt) - 97_000) < 0.01 * 97_000
    assert 2.8e9 < belt.triangle_count < 2.9e9
    assert np.bincount(belt.shapes, minlength=16).min() > 1500
    # No two touch: each lies inside its own cube of the grid.
    _, *cell = belt._places
    cubes = np.stack(cell, -1)
    assert len(np.unique(cubes, axis=0)) == 29_264
    assert (np.abs(belt.centers - 1400.0 * cubes).max(1) + belt.radii < 700.0).all()
    assert (belt.bounds[0] < 0).all()


def test_all_bodies_are_one_scene_of_shared_meshes() -> None:
    scene = FEW.scene()
    assert scene.triangle_count == FEW.triangle_count == 200 * 1200
    assert len(np.unique(scene._core.mesh_ids())) == len(np.unique(FEW.shapes)) == 16
    assert set(scene.object_names) == {f"asteroid_{k}" for k in range(200)}
    corners = scene.triangles().astype(float) + scene.origin
    assert (corners.min((0, 1)) >= FEW.bounds[0] - 0.01).all()
    assert (corners.max((0, 1)) <= FEW.bounds[1] + 0.01).all()
    part = scene.subset(objects=["asteroid_7"])
    away = np.linalg.norm(part.triangles().astype(float) + part.origin - FEW.centers[7], axis=2)
    # float32 at some kilometres from the origin.
    assert away.max() == pytest.approx(FEW.radii[7], rel=1e-3)


@pytest.mark.parametrize("level", range(4))
def test_shapes_are_closed_balls_with_faces_outwards(level: int) -> None:
    for number in range(3):
        rock = rocks.rock(0, number, 20, level)
        soup = Soup(rock.positions[rock.faces].astype(float), np.zeros(len(rock.faces), np.int32))
        assert len(rock.faces) == 12 * rocks.levels(20)[level] ** 2
        assert len(lone_edges(soup)) == 0
        assert 0.5 < volume(soup) < 4.19
        assert np.linalg.norm(rock.positions.astype(float), axis=1).max() <= 1.0
        middle = soup.corners.mean(1)
        normal = np.cross(soup.corners[:, 1] - soup.corners[:, 0], soup.corners[:, 2] - soup.corners[:, 0])
        # The whole surface is visible from the centre, which the bound on the error needs.
        assert ((middle * normal).sum(1) > 0).all()
        assert (np.einsum("ij,ij->i", rock.normals, rock.positions) > 0).mean() > 0.99


def dense(rock: rocks.Rock, count: int) -> np.ndarray:
    """Points (N, 3) on the triangles of a level, `count` along each edge."""
    weights = np.array([(a, b, count - a - b) for a in range(count + 1) for b in range(count + 1 - a)]) / count
    points = rock.positions[rock.faces].astype(float)
    return np.asarray(np.einsum("kc,tcx->tkx", weights, points).reshape(-1, 3))


@pytest.mark.parametrize("number", [0, 5])
def test_asteroid_levels_are_within_their_stated_error(number: int) -> None:
    fine = rocks.rock(1, number, 32, 0)
    whole = nf.Scene.from_arrays(fine.positions, fine.faces, copy=True)
    assert rocks.error(1, number, 32, 0) == 0.0
    errors = []
    for level in range(1, len(rocks.levels(32))):
        coarse = rocks.rock(1, number, 32, level)
        scene = nf.Scene.from_arrays(coarse.positions, coarse.faces, copy=True)
        count = 3 * 2**level
        there = nf.nearest_points(whole, dense(coarse, count)).distance.max()
        back = nf.nearest_points(scene, dense(fine, 3)).distance.max()
        errors.append(rocks.error(1, number, 32, level))
        assert max(there, back) <= errors[-1]
        assert max(there, back) > 0.2 * errors[-1]
    assert errors == sorted(errors)


def test_detail_selects_the_coarsest_sufficient_level() -> None:
    for detail in (0.0, 5.0, 30.0, 1000.0):
        levels = FEW.levels(detail)
        n = rocks.squares(1200)
        for body in range(0, 200, 41):
            error = [rocks.error(2, int(FEW.shapes[body]), n, k) * FEW.radii[body] for k in range(len(rocks.levels(n)))]
            assert error[levels[body]] <= detail
            assert all(e > detail for e in error[levels[body] + 1 :])
        counts = 12 * np.array(rocks.levels(n))[levels] ** 2
        assert FEW.scene(detail).triangle_count == counts.sum()
    assert FEW.scene(1.0e6).triangle_count == 200 * 48


def test_a_query_returns_bodies_that_reach_its_box() -> None:
    low, high = FEW.centers[3] - 1500.0, FEW.centers[3] + [900.0, 2000.0, 3000.0]
    found = FEW.query([low, high])
    away = np.linalg.norm(np.clip(FEW.centers, low, high) - FEW.centers, axis=1)
    near = np.flatnonzero(away <= FEW.radii)
    assert len(near) > 1
    whole = FEW.scene().subset(objects=[f"asteroid_{k}" for k in near])
    there = whole.triangles().astype(float) + whole.origin
    inside = ((there >= low) & (there <= high)).all(2).any(1)
    rows = {row.tobytes() for row in (found.triangles().astype(float) + found.origin).reshape(-1, 9)}
    assert {row.tobytes() for row in there[inside].reshape(-1, 9)} <= rows
    assert rows <= {row.tobytes() for row in there.reshape(-1, 9)}


def test_empty_space_is_an_empty_scene() -> None:
    assert FEW.query([[-1.0] * 3, [1.0] * 3]).triangle_count == 0
    assert FEW.query([[-np.inf] * 3, [np.inf] * 3], 50.0).triangle_count == FEW.scene(50.0).triangle_count


GOLDEN = "5f630addea0992fc"
"""Digest of a belt; it changes only with the rocks."""


def test_belts_have_the_same_bytes_everywhere() -> None:
    assert digest(datasets.asteroids(40, 300, seed=9).scene(5.0).triangles()) == GOLDEN
    assert digest(datasets.asteroids(40, 300, seed=8).scene(5.0).triangles()) != GOLDEN
