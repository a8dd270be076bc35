"""Radii and content of rings; files of the strategies vis0 and vis1."""

from __future__ import annotations

import json
from itertools import combinations, pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar.stream import _by_footprint
from nearfar.stream._assign import Rule
from nearfar.stream._decode import decode_map, ring_scene
from nearfar.stream._radii import equal_areas, merge_parts
from tests.support.bundled_scenes import bundled_scenes

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


# Files of near objects by their footprints, and the whole map of the last ring ----------------------------------------
RADII = (10.0, 63.0)


@pytest.fixture(scope="module")
def scene() -> nf.Scene:
    return bundled_scenes()["city"]


@pytest.fixture(scope="module")
def bundle(scene: nf.Scene, tmp_path_factory: pytest.TempPathFactory) -> nf.stream.Bundle:
    folder = tmp_path_factory.mktemp("by_footprint") / "b"
    settings: dict[str, Any] = {"face_size": 64, "quality": None}
    return nf.stream.export(scene, folder, center=CENTER, radii=RADII, by_footprint=True, **settings)


def triangles_of(bundle: nf.stream.Bundle, entry: dict[str, Any]) -> int:
    if entry["geometry"] is None:
        return 0
    return int(ring_scene(entry["geometry"], entry["parts"], bundle.read, "b").triangle_count)


def test_portions_have_visible_near_objects_largest_first(scene: nf.Scene) -> None:
    rings = nf.stream.assign(scene, center=CENTER, radii=RADII)
    portions = _by_footprint.Portions.from_rings(rings, scene=scene)
    seen = nf.stream.footprints(scene, center=CENTER)
    is_near = (rings.ring > 0) & (rings.ring <= rings.count)
    assert (portions.portion[rings.ring == 0] == 0).all()
    assert (portions.portion[(rings.ring > rings.count) | (is_near & (seen == 0))] == portions.count + 1).all()
    sent = is_near & (seen > 0)
    assert 5 < sent.sum() < is_near.sum()
    by_portion = [seen[sent & (portions.portion == number)] for number in range(1, portions.count + 1)]
    assert sum(map(len, by_portion)) == sent.sum()
    for before, after in pairwise(by_portion):
        assert before.min() >= after.max()
    # Files with equal numbers of objects.
    assert np.ptp([len(own) for own in by_portion]) <= 1


def test_files_contain_their_objects_and_the_whole_last_map(scene: nf.Scene, bundle: nf.stream.Bundle) -> None:
    region = bundle._manifest["regions"][0]
    entry = region["by_footprint"]
    rows = _by_footprint.Portions.from_rings(nf.stream.assign(scene, center=CENTER, radii=RADII), scene=scene).summary()
    assert [portion["objects"] for portion in entry["portions"]] == [row["objects"] for row in rows[:-1]]
    for portion in entry["portions"]:
        assert triangles_of(bundle, portion) == portion["triangles"]
    maps = [
        {"color": entry["map"]["color"]},
        {"tiles": [], "color": None, "range": entry["map"]["range"]},
    ]
    color, ranges = decode_map(maps, bundle._layout, bundle._decode_file)
    last = bundle.map(bundle.count)
    assert np.array_equal(color, last.color)
    assert ranges is not None
    assert last.range is not None
    assert np.array_equal(ranges, last.range)


def test_files_by_footprint_are_written_only_on_request(
    scene: nf.Scene, bundle: nf.stream.Bundle, tmp_path: Path
) -> None:
    plain = nf.stream.export(scene, tmp_path / "b", center=CENTER, radii=RADII, face_size=64, quality=None)
    assert plain._manifest["regions"][0]["by_footprint"] is None
    assert set(plain.files) < set(bundle.files)
    assert plain.summary() == bundle.summary()


def test_a_centre_without_visible_near_objects(tmp_path: Path) -> None:
    builder = nf.SceneBuilder()
    corners = np.array([[0.0, 0, 0], [1, 0, 0], [0, 0, 1]])
    builder.instance(builder.mesh(corners + np.array([0, 5, 0]), [[0, 1, 2]]), name="above")
    # Hidden by the one above.
    builder.instance(builder.mesh(corners * 0.01 + np.array([0.2, 6, 0.2]), [[0, 1, 2]]), name="hidden")
    scene = builder.build()
    bundle = nf.stream.export(scene, tmp_path / "b", center=(50, 1, 0), radii=[10.0], face_size=64, by_footprint=True)
    (portion,) = bundle._manifest["regions"][0]["by_footprint"]["portions"]
    assert (portion["objects"], portion["geometry"]) == (0, None)


@pytest.mark.parametrize(
    ("change", "told"),
    [
        ({"portions": 3}, "portions"),
        ({"portions": [{"objects": -1}]}, "objects"),
        ({"portions": [{"objects": 1, "triangles": 1, "stored": 1, "geometry": "files/x.glb", "parts": []}]}, "files"),
        ({"map": {"color": None, "range": None}}, "manifest"),
        ({"map": {}}, "manifest"),
    ],
)
def test_damage_is_refused(bundle: nf.stream.Bundle, change: dict[str, Any], told: str, tmp_path: Path) -> None:
    place = Path(bundle._reader.location)
    manifest = json.loads((place / "manifest.json").read_text())
    manifest["regions"][0]["by_footprint"] |= change
    copy = tmp_path / "copy"
    copy.mkdir()
    for name in ("files", "tileset.json"):
        (copy / name).symlink_to(place / name)
    (copy / "manifest.json").write_text(json.dumps(manifest))
    with pytest.raises(nf.FormatError, match=told):
        nf.stream.open(copy)


def test_splitting_rings_does_not_affect_files_by_footprint(
    bundle: nf.stream.Bundle, scene: nf.Scene, tmp_path: Path
) -> None:
    settings: dict[str, Any] = {"face_size": 64, "quality": None, "by_footprint": True, "split_px": 20.0}
    split = nf.stream.export(scene, tmp_path / "b", center=CENTER, radii=RADII, **settings)
    regions = [each._manifest["regions"][0] for each in (bundle, split)]
    assert regions[0]["by_footprint"]["portions"] == regions[1]["by_footprint"]["portions"]
    assert split.summary()[1]["geometry"] > bundle.summary()[1]["geometry"]
