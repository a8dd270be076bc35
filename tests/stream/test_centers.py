"""Several centres in one bundle: a grid that merges requests, neighbours, and regions equal to single bundles."""

from __future__ import annotations

import itertools
import json
import math
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from numpy.typing import NDArray

import nearfar as nf
from nearfar.stream import _regions
from nearfar.stream._encode import MIN_SHARED_BYTES
from tests.support import valid

CENTERS = ((0.0, 1.7, 0.0), (5.0, 1.7, 0.0), (1.0, 1.7, -6.0), (11.0, 1.9, 1.0))
SETTINGS: dict[str, Any] = {"radii": (10.0, 22.0), "face_size": 64, "samples": 1}
VIEW = nf.Camera.look_at((5.4, 1.5, -0.4), (30, 3, -20), fov=nf.Fov.symmetric(90, 1.6), size=(80, 50))


@pytest.fixture(scope="module")
def city() -> nf.Scene:
    return nf.datasets.city(blocks=2, detail=0)


@pytest.fixture(scope="module")
def folder(city: nf.Scene, tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("bundles") / "city"
    nf.stream.export(city, path, center=CENTERS, **SETTINGS)
    return path


@pytest.fixture(scope="module")
def bundle(folder: Path) -> nf.stream.Bundle:
    return nf.stream.open(folder)


def gabriel(points: NDArray[np.float64]) -> list[list[int]]:
    """Neighbours by their definition, in exact arithmetic: no third point within the sphere or on it."""
    exact = [[Fraction(value) for value in point] for point in points.tolist()]
    found: list[list[int]] = [[] for _ in exact]
    for (i, a), (j, b) in itertools.permutations(enumerate(exact), 2):
        others = (c for k, c in enumerate(exact) if k not in (i, j))
        if all(sum((p - r) * (q - r) for p, q, r in zip(a, b, c, strict=True)) > 0 for c in others):
            found[i].append(j)
    return found


def scattered(count: int, seed: int, height: float) -> NDArray[np.float64]:
    generator = np.random.default_rng(seed)
    return generator.uniform((-50, 0, -50), (50, height, 50), (count, 3))


@pytest.mark.parametrize("height", [0.0, 40.0])
@pytest.mark.parametrize(("count", "seed"), [(1, 0), (2, 1), (3, 2), (12, 3), (24, 4)])
def test_neighbours_equal_the_definition(count: int, seed: int, height: float) -> None:
    points = scattered(count, seed, height)
    assert _regions.neighbours(points) == gabriel(points)


def test_neighbours_on_grids_and_lines_are_adjacent() -> None:
    side = 7
    for spacing, offset in ((1.0, 0.0), (0.1, 0.0), (2.3, 500_000.0)):
        grid = np.array([(x * spacing + offset, 1.7, z * spacing) for x in range(side) for z in range(side)])
        steps = np.abs(np.indices((side, side)).reshape(2, 1, -1) - np.indices((side, side)).reshape(2, -1, 1)).sum(0)
        # Angles across a square's diagonal are right angles, so the diagonal is not an edge.
        assert _regions.neighbours(grid) == [np.flatnonzero(row == 1).tolist() for row in steps]
    line = np.outer(np.arange(9.0), (1.0, 0.2, -3.0))
    assert _regions.neighbours(line) == [[n for n in (m - 1, m + 1) if 0 <= n < 9] for m in range(9)]
    floors = np.array([(0.0, 3.0 * floor, 0.0) for floor in range(4)])
    assert _regions.neighbours(floors) == [[1], [0, 2], [1, 3], [2]]


@pytest.mark.parametrize("seed", range(4))
def test_all_centres_are_connected(seed: int) -> None:
    points = scattered(150, seed, 3.0)
    points[::3] = points[1::3] + np.array((_regions.MIN_DISTANCE, 0.0, 0.0))
    near, reached, edge = _regions.neighbours(points), {0}, [0]
    while edge:
        edge = [n for place in edge for n in near[place] if n not in reached]
        reached.update(edge)
    assert len(reached) == len(points)


@pytest.mark.parametrize("grid", [0.001, 0.1, 2.5, 1000.0])
def test_centres_move_to_the_grid(grid: float) -> None:
    for x, y, z in [*scattered(200, 5, 9.0).tolist(), [-1e-9, 0.0, -0.0]]:
        snapped = nf.stream.snap((x, y, z), grid)
        assert snapped[1] == y
        for before, after in ((x, snapped[0]), (z, snapped[2])):
            # Half a step, and the rounding of both numbers.
            assert abs(before - after) <= grid / 2 * (1 + 1e-9) + 1e-12
            assert after == grid * round(after / grid)
        assert nf.stream.snap(snapped, grid) == snapped
        assert all(math.copysign(1.0, value) > 0 for value in snapped[::2] if value == 0)
    assert nf.stream.snap((1.5, 0.0, 2.5), 1.0) == (2.0, 0.0, 2.0)


@pytest.mark.slow
def test_regions_equal_bundles_of_each_centre(city: nf.Scene, bundle: nf.stream.Bundle, tmp_path: Path) -> None:
    manifest = json.loads((Path(bundle._reader.location) / "manifest.json").read_text())
    listed: dict[str, Any] = {}
    for number, center in enumerate(CENTERS):
        alone = nf.stream.export(city, tmp_path / str(number), center=center, **SETTINGS)
        document = json.loads((tmp_path / str(number) / "manifest.json").read_text())
        expected = {**document["regions"][0], "neighbours": list(bundle.neighbours(number))}
        assert manifest["regions"][number] == expected
        listed |= document["files"]
        region = bundle.region(number)
        assert region.number == number
        assert region.center == alone.center == center
        assert region.radii == alone.radii
        assert region.summary() == alone.summary()
        frames = [one.at(2).render(VIEW, samples=1).require("color") for one in (region, alone)]
        np.testing.assert_array_equal(frames[0], frames[1])
        np.testing.assert_array_equal(region.map(1).color, alone.map(1).color)
        shared = {name: document[name] for name in ("dynamic", "notes", "map", "bounds", "triangles")}
        assert shared == {name: manifest[name] for name in shared}
    assert listed == manifest["files"]
    assert set(bundle.files) == {f"files/{path.name}" for path in Path(bundle._reader.location, "files").iterdir()}
    bundle.verify()


def test_files_of_equal_content_are_stored_once(bundle: nf.stream.Bundle) -> None:
    rows = [row for number in range(len(CENTERS)) for row in bundle.region(number).summary()]
    assert bundle.nbytes < sum(row["geometry"] + row["color"] + row["range"] for row in rows)


def test_large_meshes_of_one_ring_are_files_that_regions_share(tmp_path: Path) -> None:
    ball, builder = trimesh.creation.icosphere(4), nf.SceneBuilder()
    mesh = builder.mesh(ball.vertices.astype(np.float32), ball.faces)
    for number, place in enumerate([(4.0, 1.7, 0.0), (0.0, 1.7, 5.0)]):
        pose = np.eye(4)
        pose[:3, 3] = place
        builder.instance(mesh, pose, name=str(number))
    bundle = nf.stream.export(builder.build(), tmp_path / "b", center=[(0, 1.7, 0), (1, 1.7, 0)], **SETTINGS)
    parts = [region["rings"][1]["parts"] for region in bundle._regions]
    assert parts[0] == parts[1]
    assert len(parts[0]) == 1
    assert len(bundle.read(parts[0][0])) > MIN_SHARED_BYTES


def test_a_bundle_opens_at_its_first_region(folder: Path, bundle: nf.stream.Bundle) -> None:
    assert valid(json.loads((folder / "manifest.json").read_text()), "bundle")
    assert bundle.number == 0
    np.testing.assert_array_equal(bundle.centers, CENTERS)
    assert not bundle.centers.flags.writeable
    assert [bundle.neighbours(n) for n in range(4)] == [tuple(near) for near in gabriel(np.array(CENTERS))]
    margins = [nf.fold_margin(c, center=c, r1=0.7 * 22.0, r2=22.0, kind="cylinder") for c in CENTERS]
    np.testing.assert_allclose(bundle.fold_margins, margins, rtol=1e-12)
    assert [bundle.nearest(center) for center in CENTERS] == [0, 1, 2, 3]
    assert bundle.nearest((8.2, 1.7, 0.2)) == 3
    assert bundle.nearest((1e308, 0.0, 0.0)) in range(4)
    assert bundle.nearest(bundle.center) == 0
    other, name = bundle.region(2), next(iter(bundle.files))
    assert other.read(name) is bundle.read(name)
    assert other.region(0).center == bundle.center
    assert (other.files, other.nbytes) == (bundle.files, bundle.nbytes)
    assert "region 2 of 4" in repr(other)


def test_requests_at_one_grid_point_are_merged(city: nf.Scene, tmp_path: Path) -> None:
    asked = [(1.2, 1.7, 0.3), (5.1, 1.7, 0.0), (0.9, 1.7, -0.4), (1.2, 4.7, 0.3)]
    bundle = nf.stream.export(city, tmp_path / "grid", center=asked, grid=2.0, **SETTINGS)
    np.testing.assert_array_equal(bundle.centers, [(2.0, 1.7, 0.0), (6.0, 1.7, 0.0), (0.0, 1.7, 0.0), (2.0, 4.7, 0.0)])
    same = nf.stream.export(city, tmp_path / "one", center=[(0.9, 1.7, 0.3), (-0.9, 1.7, 0.3)], grid=2.0, **SETTINGS)
    assert same.centers.tolist() == [[0.0, 1.7, 0.0]]
    assert same.neighbours(0) == ()


def test_regions_of_a_walk_are_accepted(city: nf.Scene, tmp_path: Path) -> None:
    walk = nf.regions(city, [(0.0, 1.7, -20.0), (0.0, 1.7, 20.0)], reach=8.0, r2=50.0)
    bundle = nf.stream.export(city, tmp_path / "walk", center=walk, **SETTINGS)
    np.testing.assert_array_equal(bundle.centers, walk.centers)
    # Everywhere on the path the user is within the nearest region's limit.
    assert (bundle.fold_margins > walk.reach).all()
    ends = {bundle.nearest((0.0, 1.7, -20.0)), bundle.nearest((0.0, 1.7, 20.0))}
    assert len(ends) == 2


def test_radii_are_chosen_for_each_centre(tmp_path: Path) -> None:
    faces = np.arange(36).reshape(-1, 3)
    box = nf.datasets.forest(trees=1, detail=0).triangles().reshape(-1, 3)[:36].astype(np.float64)
    scene = nf.Scene.from_arrays(box, faces)
    beside = np.add(box.mean(axis=0), (3.0, 0.0, 0.0))
    bundle = nf.stream.export(scene, tmp_path / "one", center=[beside], face_size=64, samples=1)
    assert bundle.radii == nf.stream.ring_radii(scene, center=beside)
    far = (5000.0, 1.0, 0.0)
    with pytest.raises(
        ValueError,
        match=r"center: .* objects around it, got \(5000, 1, 0\), within 63 m of which there is none; .* radii",
    ):
        nf.stream.export(scene, tmp_path / "two", center=[beside, far], face_size=64, samples=1)
    assert not (tmp_path / "two").exists()


@pytest.mark.parametrize("neighbours", [[0], [4], [2, 1]])
def test_unusable_neighbours_are_refused(folder: Path, tmp_path: Path, neighbours: list[int]) -> None:
    manifest = json.loads((folder / "manifest.json").read_text())
    manifest["regions"][0]["neighbours"] = neighbours
    (tmp_path / "manifest.json").write_text(json.dumps(manifest))
    with pytest.raises(nf.FormatError, match=r"manifest\.json.*neighbours"):
        nf.stream.open(tmp_path)
