"""Radii of rings, the ring of each object, and the content of each ring."""

from __future__ import annotations

from itertools import combinations
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar.stream._assign import Rule
from nearfar.stream._radii import equal_areas, merge_parts
from tests.support import data

CENTER = (3.0, 1.7, -2.0)


@pytest.fixture(scope="module")
def city() -> nf.Scene:
    return nf.datasets.city(blocks=3, detail=1)


def least_by_triangle(scene: nf.Scene, center: tuple[float, float, float], rule: str) -> dict[str, float]:
    """Least distance of each static object, over all its triangles one by one."""
    axis = np.array(center)[[0, 2]]
    found = {}
    moving = {scene.object_names[number] for number in scene._core.moving_objects()}
    for name in set(scene.object_names) - moving:
        corners = scene.subset(objects=[name]).triangles().astype(np.float64) + scene.origin
        if rule == "vertex":
            found[name] = float(np.linalg.norm(corners[:, :, [0, 2]] - axis, axis=2).min())
        else:
            found[name] = float(nf.triangle_radii(corners, center=center)[:, 0].min())
    return found


@pytest.mark.parametrize("rule", ["object", "vertex"])
def test_rings_contain_the_objects_that_extend_inside(city: nf.Scene, rule: Rule) -> None:
    radii = (10.0, 22.0, 63.0)
    rings = nf.stream.assign(city, center=CENTER, radii=radii, rule=rule)
    expected = least_by_triangle(city, CENTER, rule)
    names = city.object_names
    for number, name in enumerate(names):
        if name not in expected:
            assert rings.ring[number] == 0
            continue
        # Distances are float32 in the scene's frame.
        rho = expected[name]
        if rho <= radii[-1]:
            assert rings.least[number] == pytest.approx(rho, rel=2e-7, abs=1e-6)
        ring = 1 + sum(radius < rho for radius in radii)
        assert rings.ring[number] == ring or min(abs(rho - radius) for radius in radii) < 1e-5
    listed = [rings.objects(ring) for ring in range(rings.count + 2)]
    assert sorted(name for objects in listed for name in objects) == sorted(names)
    assert len(set(rings.ring.tolist())) == 5, "every kind of ring occurs"


def test_a_floor_without_a_corner_inside_is_near_by_surface_only() -> None:
    corners = np.array([[-50, 0, -50], [50, 0, -50], [50, 0, 50], [-50, 0, 50]], np.float32)
    floor = nf.Scene.from_arrays(corners, [[0, 1, 2], [0, 2, 3]])
    by = {rule: nf.stream.assign(floor, center=(0, 1.7, 0), radii=[10.0], rule=rule) for rule in ("object", "vertex")}
    assert [by[rule].ring.tolist() for rule in by] == [[1], [2]]


def test_summaries_count_every_triangle_once_and_stored_ones_by_mesh(city: nf.Scene) -> None:
    rings = nf.stream.assign(city, center=CENTER, radii=(10.0, 22.0, 63.0))
    rows = rings.summary()
    assert [row["radius"] for row in rows] == [10.0, 22.0, 63.0, np.inf]
    for ring, row in enumerate(rows, 1):
        assert row["objects"] == len(rings.objects(ring))
        assert row["triangles"] == city.subset(objects=rings.objects(ring)).triangle_count
        assert row["stored"] <= row["triangles"]
    assert sum(row["triangles"] for row in rows) == city._core.standing_triangle_count
    assert sum(row["stored"] for row in rows) < 0.7 * city._core.standing_triangle_count, "trees are instances"


def test_distant_objects_are_not_measured() -> None:
    forest = nf.datasets.forest(trees=500)
    rings = nf.stream.assign(forest, center=(0, 1.7, 0), radii=[10.0])
    assert 0 < rings.measured < 0.3 * forest.triangle_count
    assert np.isinf(rings.least[rings.ring == 2]).all()


def test_published_radii_and_equal_areas(city: nf.Scene) -> None:
    assert nf.stream.ring_radii(city, center=CENTER, policy="published") == (10.0, 14.0, 17.0, 22.0, 32.0, 63.0)
    assert nf.stream.ring_radii(city, center=CENTER, policy="published", r_max=30.0, base_radius=5.0) == (
        *(5.0, 7.0, 8.5, 11.0, 16.0),
    )
    for reach in (5.0, 0.0003, 7.3, 9.999999999999998):
        for policy in ("published", "equal_area", "cost"):
            assert nf.stream.ring_radii(city, center=CENTER, policy=policy, r_max=reach) == (reach,), policy
    area = np.array(nf.stream.ring_radii(city, center=CENTER, policy="equal_area", r_max=50.0))
    assert area[-1] == 50.0
    assert len(area) == 25
    assert np.diff(area**2) == pytest.approx(100.0)
    assert list(equal_areas(10.0, 45.0)[-2:]) == pytest.approx([10 * 20**0.5, 45.0])
    # The printed radii are those of equal areas, rounded.
    assert np.array(nf.stream._radii.PUBLISHED) == pytest.approx([10 * i**0.5 for i in (1, 2, 3, 5, 10, 40)], rel=0.02)


def expected_time(ends: tuple[int, ...], sizes: np.ndarray, weights: np.ndarray, link: tuple[float, ...]) -> float:
    """Sum over parts of weight times arrival time."""
    rate, wait, map_bytes = link
    moment, total, start = 0.0, 0.0, 0
    for end in ends:
        moment += wait + (sizes[start : end + 1].sum() + map_bytes) / rate
        total += moment * weights[start : end + 1].sum()
        start = end + 1
    return total


@pytest.mark.parametrize("seed", range(20))
def test_merging_finds_the_division_of_least_expected_time(seed: int) -> None:
    random = np.random.default_rng(seed)
    count = int(random.integers(1, 9))
    sizes, weights = random.uniform(0, 100, count), random.uniform(0, 1, count) * random.integers(0, 2, count)
    link = (float(random.uniform(1, 50)), float(random.uniform(0, 2)), float(random.uniform(0, 60)))
    divisions = [(*chosen, count - 1) for n in range(count) for chosen in combinations(range(count - 1), n)]
    best = min(expected_time(ends, sizes, weights, link) for ends in divisions)
    found = merge_parts(sizes, weights, *link)
    assert expected_time(tuple(found), sizes, weights, link) == pytest.approx(best, rel=1e-12)


def test_costly_maps_make_fewer_rings(city: nf.Scene) -> None:
    def count(**link: Any) -> int:
        return len(nf.stream.ring_radii(city, center=CENTER, **link))

    assert count(map_bytes=0.0, latency=0.0) > count(map_bytes=200_000.0) >= count(map_bytes=1e9) == 1
    # On a fast link the wait for each ring matters.
    assert count(bandwidth=1e6, latency=0.5) == 1
    rings = nf.stream.ring_radii(city, center=CENTER)
    assert rings[-1] == 63.0
    assert set(rings) <= set(equal_areas(10.0, 63.0))


def test_footprints_are_solid_angles() -> None:
    wall = nf.Scene.from_arrays([[-1, -1, -1], [1, -1, -1], [1, 1, -1], [-1, 1, -1]], [[0, 1, 2], [0, 2, 3]])
    # A face of a cube about the centre is a sixth of the sphere.
    found = nf.stream.footprints(wall, center=(0, 0, 0), face_size=128)
    assert found.sum() == pytest.approx(4 * np.pi / 6, rel=1e-3)


def test_footprints_exclude_hidden_objects(city: nf.Scene) -> None:
    found = nf.stream.footprints(city, center=(0, 1.7, 0), face_size=64)
    assert found.shape == (len(city.object_names),)
    assert 2 * np.pi < found.sum() < 4 * np.pi
    assert (found == 0).mean() > 0.2
    assert found[city.object_names.index("ground")] > 1.0


def test_wrong_settings_of_radii_are_refused(city: nf.Scene) -> None:
    with pytest.raises(ValueError, match="at most 1000 rings"):
        nf.stream.ring_radii(city, center=CENTER, base_radius=0.01)
    with pytest.raises(ValueError, match="r_max: expected a radius that an object reaches inside"):
        nf.stream.ring_radii(city, center=(90_000.0, 0.0, 0.0))


def test_the_centre_of_tokyo_is_a_corner_case() -> None:
    tokyo = nf.Scene.load(data("city/tokyo23/tokyo_core_lod1.glb"))
    center = tokyo.bounds.mean(axis=0)
    rings = nf.stream.assign(tokyo, center=center, radii=(10.0, 22.0, 63.0))
    assert sum(row["triangles"] for row in rings.summary()) == tokyo.triangle_count
    assert 0 < sum(row["triangles"] for row in rings.summary()[:3]) < 1000, "nearly all of it is far"
