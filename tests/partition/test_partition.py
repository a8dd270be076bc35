"""Partitions against slow definitions: of random towns, instances, moving objects and real cities."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
import trimesh
from hypothesis import given, strategies as st
from numpy.typing import NDArray

import nearfar as nf
from tests.support import data
from tests.support.partition_cases import exact_radii, numpy_radii, soup, town

SETS = ("near", "intermediate", "far", "nsf", "sf")


def expected_sets(radii: NDArray[Any], r1: float, r2: float, moving: NDArray[np.bool_]) -> dict[str, NDArray[Any]]:
    least, greatest = radii.astype(np.float64).T
    near, far = least <= r1, least > r2
    masks = {
        "near": near,
        "intermediate": ~near & ~far,
        "far": far,
        "nsf": ~far | moving,
        "sf": (greatest > r2) & ~moving,
    }
    return {name: np.flatnonzero(mask) for name, mask in masks.items()}


@given(st.integers(0, 100), st.floats(0, 60), st.floats(0.5, 100), st.floats(-80, 80))
def test_partition_equals_sets_by_radii(seed: int, r1: float, width: float, x: float) -> None:
    corners, r2, center = town(seed), r1 + width, (x, 3.0, -x / 2)
    scene = soup(corners)
    partition = nf.partition(scene, center=center, r1=r1, r2=r2)
    partition.validate()
    radii = nf.triangle_radii(scene.triangles(), center=np.subtract(center, scene.origin))
    expected = expected_sets(radii, r1, r2, np.zeros(len(corners), bool))
    for name in SETS:
        found = getattr(partition, name)
        assert found.dtype == np.int64
        np.testing.assert_array_equal(found, expected[name])
    counts = partition.summary()
    assert counts["near"] + counts["intermediate"] + counts["far"] == counts["triangles"] == len(corners)
    assert counts["nsf"] + counts["sf"] - counts["straddling"] == counts["triangles"]
    assert {name: counts[name] for name in SETS} == {name: len(expected[name]) for name in SETS}
    assert counts["measured"] <= counts["examined"] <= counts["triangles"]


def similarity(x: float, z: float, angle: float, scale: float = 1.0) -> NDArray[np.float64]:
    matrix = np.eye(4)
    matrix[0, 0] = matrix[2, 2] = math.cos(angle) * scale
    matrix[0, 2], matrix[2, 0] = math.sin(angle) * scale, -math.sin(angle) * scale
    matrix[[0, 2], 3] = x, z
    return matrix


def forest(origin: float) -> nf.Scene:
    """A ground, trees as instances of one mesh, and a car that may move."""
    random = np.random.default_rng(4)
    loaded = trimesh.Scene()
    loaded.add_geometry(trimesh.creation.box((400, 1, 400)), "ground", transform=similarity(origin, -origin, 0.1))
    loaded.add_geometry(trimesh.creation.icosphere(subdivisions=1), "tree", geom_name="tree")
    for i, (x, z) in enumerate(random.uniform(-150, 150, (60, 2))):
        placed = similarity(origin + x, z - origin, random.uniform(0, 6), random.uniform(1, 6))
        loaded.graph.update(frame_to=f"tree_{i}", geometry="tree", matrix=placed)
    loaded.add_geometry(trimesh.creation.box((4, 1, 2)), "car", transform=similarity(origin + 100, -origin, 0.5))
    return nf.Scene.from_trimesh(loaded).with_dynamic(["car"])


@pytest.mark.parametrize("origin", [0.0, 1e6])
def test_instances_are_partitioned_like_merged_geometry(origin: float) -> None:
    scene = forest(origin)
    corners = scene.triangles()
    merged = soup(corners)
    total, car = len(corners), 12
    moving = np.arange(total) >= total - car
    center = (origin + 3.0, 1.7, -origin)
    local = np.subtract(center, scene.origin)
    for r1, r2 in [(0.0, 10.0), (30.0, 50.0), (50.0, 200.0), (1.0, 1000.0)]:
        partition = nf.partition(scene, center=center, r1=r1, r2=r2)
        partition.validate()
        standing = nf.partition(merged, center=local, r1=r1, r2=r2)
        for name in ("near", "intermediate", "far"):
            np.testing.assert_array_equal(getattr(partition, name), getattr(standing, name))
        expected = expected_sets(nf.triangle_radii(corners, center=local), r1, r2, moving)
        for name in SETS:
            np.testing.assert_array_equal(getattr(partition, name), expected[name])
        assert nf.load_curve(scene, center=center).count(r2) == len(expected["nsf"])
    # At 30 and 50 m bounding boxes decide most trees; only the others are examined.
    counts = nf.partition(scene, center=center, r1=30, r2=50).summary()
    assert counts["far_instances"] > 30
    assert 0 < counts["examined"] < total / 2
    assert counts["near_instances"] + counts["intermediate_instances"] + counts["far_instances"] + counts[
        "mixed_instances"
    ] == len(scene.object_names)


def test_moving_triangles_are_geometry_wherever_they_are() -> None:
    scene = forest(0.0)
    partition = nf.partition(scene, center=(0, 0, 0), r1=30, r2=50)
    car = np.arange(scene.triangle_count - 12, scene.triangle_count)
    assert np.isin(car, partition.nsf).all()
    assert np.isin(car, partition.far).all()
    assert not np.isin(car, partition.sf).any()
    here = scene.at({"car": np.eye(4)})
    assert np.isin(car, nf.partition(here, center=(0, 0, 0), r1=30, r2=50).near).all()
    assert nf.load_curve(scene, center=(0, 0, 0)).moving_count == 12


def test_scenes_may_be_all_near_or_all_far() -> None:
    scene = soup(town())
    everything = np.arange(scene.triangle_count)
    near = nf.partition(scene, center=(0, 0, 0), r1=1e4, r2=2e4)
    np.testing.assert_array_equal(near.nsf, everything)
    assert near.sf.size == 0
    assert near.summary()["examined"] == 0
    far = nf.partition(scene, center=(1e5, 0, 0), r1=10, r2=20)
    np.testing.assert_array_equal(far.sf, everything)
    assert far.nsf.size == 0
    assert far.summary()["examined"] == 0


@pytest.mark.parametrize("city", ["city/tokyo23/tokyo_core_lod1.glb", "city/manhattan_deckgl/manhattan_core.glb"])
def test_partitions_of_real_cities_equal_the_definition(city: str) -> None:
    scene = nf.Scene.load(data(city))
    low, high = scene.bounds
    center = (low + high) / 2
    corners, local = scene.triangles(), center - scene.origin
    radii = nf.triangle_radii(corners, center=local)
    # Float64 rounding of either form, and one of float32.
    np.testing.assert_allclose(radii, numpy_radii(corners, local), rtol=1e-7, atol=1e-9)
    curve = nf.load_curve(scene, center=center)
    for r1, r2 in [(30.0, 50.0), (300.0, 500.0), (1e3, 2e3)]:
        partition = nf.partition(scene, center=center, r1=r1, r2=r2)
        expected = expected_sets(radii, r1, r2, np.zeros(len(corners), bool))
        for name in SETS:
            np.testing.assert_array_equal(getattr(partition, name), expected[name])
        assert curve.count(r2) == len(expected["nsf"])
    random = np.random.default_rng(0).integers(0, len(corners), 200)
    for triangle, found in zip(corners[random], radii[random], strict=True):
        # Half a step of float32 is 6e-8 of a number.
        np.testing.assert_allclose(found, exact_radii(triangle, local), rtol=6e-8)
