"""Tests of the procedural scenes: identical bytes, closed solids, names, sizes, free views."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given, strategies as st

from nearfar import datasets
from nearfar.datasets import (
    _facade,
    _forest,
    _furnishings,
    _furniture,
    _ground,
    _palette,
    _roofs,
    _shapes,
    _textures,
    _vegetation,
    _vehicles,
)
from nearfar.datasets._buildings import Kind, building
from nearfar.datasets._layout import Grid, plots
from nearfar.datasets._random import RandomStream, turn
from nearfar.datasets._shapes import Soup, weld
from tests.support.solids import areas, count_covered, digest, lone_edges, volume


def test_turn_matches_the_library_within_rounding() -> None:
    fraction = np.linspace(-3.0, 3.0, 4001)
    cosine, sine = turn(fraction)
    # The library's own argument 2πf is rounded: 3 turns, 19 radians, times 2⁻⁵³.
    np.testing.assert_allclose(cosine, np.cos(2.0 * np.pi * fraction), rtol=0, atol=1e-14)
    np.testing.assert_allclose(sine, np.sin(2.0 * np.pi * fraction), rtol=0, atol=1e-14)
    assert [float(v) for pair in turn(np.array([0.0, 0.25, 0.5, 0.75])) for v in pair] == [1, 0, -1, 0, 0, 1, 0, -1]


def test_draws_depend_on_names_and_counters_only() -> None:
    whole = RandomStream(5, 1, 2).uniform(10)
    split = RandomStream(5, 1, 2)
    np.testing.assert_array_equal(whole, np.concatenate([split.uniform(3), split.uniform(7)]))
    assert not np.array_equal(whole, RandomStream(5, 2, 1).uniform(10))
    assert 0 <= RandomStream(0, 0).integers(1000, 7).min() <= RandomStream(0, 0).integers(1000, 7).max() == 6


@given(st.lists(st.tuples(*[st.integers(-2, 2)] * 9), min_size=1, max_size=30), st.booleans())
def test_weld_keeps_triangles_and_joins_equal_corners(rows: list[tuple[int, ...]], with_tints: bool) -> None:
    corners = np.array(rows, float).reshape(-1, 3, 3) * 0.1
    soup = Soup(corners, np.zeros(len(rows), np.int32), corners[..., 0] if with_tints else None)
    joined = weld(soup)
    np.testing.assert_array_equal(joined.positions[joined.faces], corners.astype(np.float32) + np.float32(0))
    # A tint that is a function of the position splits nothing.
    assert len(np.unique(joined.positions, axis=0)) == len(joined.positions)


SOLIDS = {
    "box": (_shapes.boxes([0, 0, 0], [1, 2, 3], 0), 6.0),
    "sphere": (_shapes.triangles(_shapes.sphere(3), 0), 4.15),
    "lathe": (_shapes.lathe([(1.0, 0.0), (1.0, 1.0)], 64, 0), 3.136),
    "cone": (_shapes.lathe([(1.0, 0.0), (0.0, 3.0)], 64, 0, top=False), 3.136),
    "tube": (_shapes.tube([(0, 0, 0), (0, 1, 0), (0, 2, 0)], 0.5, 64, 0), 1.568),
    "cornice": (_roofs.parapet(10.0, 8.0, 5.0, "moulded", 0), None),
    "cornice between neighbours": (_roofs.parapet(10.0, 8.0, 5.0, "moulded", 0, "+x -x"), None),
    "hipped roof": (_roofs.hipped(12.0, 9.0, 5.0, 0.7, 0, 0), None),
    "gabled roof": (_roofs.gabled(12.0, 9.0, 5.0, 0.7, 0, 0, 0), None),
    "awning": (_facade.awning(np.array([0.0, 2.0, 0.0, 3.0]), 0), None),
}


@pytest.mark.parametrize("name", SOLIDS)
def test_solids_are_closed_and_face_outwards(name: str) -> None:
    soup, expected = SOLIDS[name]
    assert len(lone_edges(soup)) == 0
    assert volume(soup) > 0
    if expected is not None:
        # Polyhedra inside smooth bodies: the expected volumes are given to three digits.
        assert volume(soup) == pytest.approx(expected, rel=2e-3)


PROTOTYPES = {
    "saloon": _vehicles.car(_vehicles.SALOON, 0, 2),
    "van": _vehicles.car(_vehicles.VAN, 0, 2),
    "low car": _vehicles.car(_vehicles.HATCH, 0, 0),
    "tree": _vegetation.broadleaf(0, 1, 2),
    "conifer": _vegetation.conifer(0, 1, 2),
    "shrub": _vegetation.shrub(0, 1, 2),
    "rock": _vegetation.rock(0, 1, 2),
    "lamp": _furniture.lamp_post(2),
    "bench": _furniture.bench(2),
    "bin": _furniture.litter_bin(2),
    "signal": _furniture.traffic_light(2),
    "shelter": _furniture.shelter(2),
    "fountain": _furniture.fountain(2),
    "tank": _roofs.water_tank(2),
    **{f"building {form}": building(Kind(199, 170, form, place, 0), 0, 2) for form, place in enumerate((0, 1, 2, 3))},
    "house at detail 1": building(Kind(159, 160, 0, 1, 0), 0, 1),
    "house at detail 3": building(Kind(159, 160, 1, 1, 1), 0, 3),
}


@pytest.mark.parametrize("name", PROTOTYPES)
def test_prototypes_are_well_formed(name: str) -> None:
    soup = PROTOTYPES[name]
    assert volume(soup) > 0
    joined = weld(soup)
    corners = joined.positions[joined.faces]
    # A square of a tenth of a millimetre: far below the smallest part, far above float32's rounding at 100 m.
    assert areas(corners).min() > 1e-8
    distinct = np.unique(np.sort(joined.faces, axis=1), axis=0)
    assert len(distinct) == len(joined.faces)
    np.testing.assert_array_equal(corners, (soup.corners.astype(np.float32) + np.float32(0)))


@pytest.mark.parametrize("name", [name for name in PROTOTYPES if "building 3" not in name])
def test_no_surface_lies_in_another(name: str) -> None:
    assert count_covered(PROTOTYPES[name].corners) == 0


def test_facade_rows_meet_at_corners() -> None:
    """The walls of all four sides form one sheet: only the upper and lower rims are open."""
    ends = lone_edges(building(Kind(200, 160, 1, 3, 0), 0, 1))
    on_wall = (np.abs(ends[..., 0]) == 10.0).all(1) | (np.abs(ends[..., 2]) == 8.0).all(1)
    assert on_wall.any()
    assert np.ptp(ends[on_wall][..., 1], axis=1).max() == 0.0


def test_ground_has_no_cracks() -> None:
    sheet = _ground.ground(Grid.generate(3), 0, 2)
    ends = lone_edges(sheet)
    corners = sheet.corners.astype(np.float32)
    at_rim = (ends == corners.min(axis=(0, 1))) | (ends == corners.max(axis=(0, 1)))
    assert at_rim[..., [0, 2]].all(1).any(1).all()
    normals = np.cross(sheet.corners[:, 1] - sheet.corners[:, 0], sheet.corners[:, 2] - sheet.corners[:, 0])
    assert normals[:, 1].min() >= 0.0


def test_plots_do_not_overlap() -> None:
    for seed in range(3):
        found = plots(Grid.generate(6), seed)
        assert len({plot.name for plot in found}) == len(found)
        wide = np.array([[p.kind.width, p.kind.depth] for p in found]) * 0.05
        low = np.array([[p.x, p.z] for p in found]) - wide
        high = np.array([[p.x, p.z] for p in found]) + wide
        overlap = (low[:, None] < high[None] - 1e-9).all(2) & (low[None] < high[:, None] - 1e-9).all(2)
        assert overlap.sum() == len(found)  # each with itself


# Triangles by detail for the default of 12 blocks: ranges wide enough for other seeds.
CITY_RANGES = {0: (10_000, 40_000), 1: (800_000, 2_500_000), 2: (5_000_000, 12_000_000), 3: (30_000_000, 80_000_000)}


@pytest.mark.slow
@pytest.mark.parametrize("detail", CITY_RANGES)
def test_city_grows_with_detail(detail: int) -> None:
    scene = datasets.city(detail=detail)
    low, high = CITY_RANGES[detail]
    assert low < scene.triangle_count < high
    names = set(scene.object_names)
    assert {"ground", *(f"car_{k}" for k in range(8))} <= names
    assert sum(name.startswith("building_") for name in names) > 500
    assert (detail == 0) == ("tree_17" not in names)


def test_city_is_the_same_on_every_run() -> None:
    first, second, other = (datasets.city(blocks=1, seed=seed, detail=2) for seed in (0, 0, 1))
    assert digest(first.triangles()) == digest(second.triangles()) != digest(other.triangles())
    assert first.object_names == second.object_names


# Fixed hashes detect changes of platform, NumPy or drawing order; replace them only on purpose.
GOLDEN = {
    "building": "72b9bd332af9ca70",
    "tree": "cf41023a7039f2d2",
    "car": "859bbbcfa5538287",
    "ground": "25111d14d93a2cbe",
    "spruce": "e665b96101035ef1",
    "books": "1c5aac6b87a15825",
    "planks": "10c01c334f06930a",
    "leaves": "fa9ac870295b077b",
}


def golden_digests() -> dict[str, str]:
    made = {
        "building": building(Kind(199, 170, 1, 1, 0), 7, 2),
        "tree": _vegetation.broadleaf(7, 3, 3),
        "car": _vehicles.car(_vehicles.ESTATE, 1, 2),
        "ground": _ground.ground(Grid.generate(4), 7, 2),
        "spruce": _vegetation.conifer(7, 1, 2),
        "books": _furnishings.shelf(7, 2),
    }
    found = {}
    for name, soup in made.items():
        joined = weld(soup)
        extra = [] if joined.colors is None else [joined.colors]
        colors = np.array(_palette.linear_colors(), np.float32)[joined.materials]
        found[name] = digest(joined.positions, joined.faces, colors, *extra)
    found["planks"] = digest(_textures.planks(7))
    found["leaves"] = digest(_vegetation.leaf_texture())
    return found


def test_geometry_has_the_same_bytes_everywhere() -> None:
    assert golden_digests() == GOLDEN


@pytest.mark.parametrize("blocks", [1, 2, 5])
def test_street_view_is_free(blocks: int) -> None:
    (x, y, z), target = datasets.street_view()
    corners = datasets.city(blocks=blocks).triangles()
    # Nothing but the street's surface and its markings is near the eye.
    low, high = corners.min(axis=1), corners.max(axis=1)
    nearest = np.clip((x, z), low[:, [0, 2]], high[:, [0, 2]]) - np.array((x, z))
    near = np.hypot(nearest[:, 0], nearest[:, 1]) < 2.0
    assert (high[near, 1] < 0.2).all()
    # The view along the avenue is open for 200 m at the eye's height.
    across = (low[:, 0] < 0.2) & (high[:, 0] > -0.2) & (low[:, 1] < y + 0.2) & (high[:, 1] > y - 0.2)
    assert not (across & (low[:, 2] < z) & (high[:, 2] > -200.0)).any()
    assert target[2] < z


def test_moving_cars_are_dynamic() -> None:
    scene = datasets.city(blocks=2, detail=1)
    pose = np.eye(4)
    pose[:3, 3] = (100.0, 0.0, 100.0)
    moved = scene.at({"car_3": pose})
    assert moved.triangle_count == scene.triangle_count
    with pytest.raises(ValueError, match="tree"):
        scene.at({"tree_1": pose})


FURNISHINGS: dict[str, Callable[[int], Soup]] = {
    "sofa": _furnishings.sofa,
    "table": _furnishings.table,
    "chair": _furnishings.chair,
    "lamp": _furnishings.floor_lamp,
    "pendant": _furnishings.pendant,
    "curtain": lambda detail: _furnishings.curtain(0.5, 2.4, detail),
    "cushion": lambda detail: _furnishings.cushion([0, 0, 0], [1, 1, 1], 0.2, 0, detail),
    "books": lambda detail: _furnishings.shelf(0, detail),
    "crockery": lambda detail: _furnishings.crockery(0, detail),
}


@pytest.mark.parametrize("detail", range(4))
@pytest.mark.parametrize("name", FURNISHINGS)
def test_furnishings_are_closed(name: str, detail: int) -> None:
    soup = FURNISHINGS[name](detail)
    assert len(lone_edges(soup)) == 0
    assert volume(soup) > 0
    assert areas(soup.corners).min() > 0
    assert detail > 2 or count_covered(soup.corners) == 0


# Triangles by detail, as the documentation says.
ROOM_RANGES = {0: (3_000, 20_000), 1: (10_000, 50_000), 2: (50_000, 200_000), 3: (200_000, 1_000_000)}


@pytest.mark.parametrize("detail", ROOM_RANGES)
def test_room_grows_with_detail(detail: int) -> None:
    scene = datasets.room(detail=detail)
    low, high = ROOM_RANGES[detail]
    assert low < scene.triangle_count < high
    assert {"walls", "floor", "table", "sofa", "shelf", "plant", "chair_0", "curtain_3", "tree_13"} <= set(
        scene.object_names
    )
    assert scene.at({"chair_0": np.eye(4)}).triangle_count == scene.triangle_count


def test_room_view_is_free() -> None:
    eye, _ = datasets.room_view()
    corners = datasets.room().triangles()
    low, high = corners.min(axis=1), corners.max(axis=1)
    gap = np.clip(eye, low, high) - np.array(eye)
    # The walls of the corner that the eye stands in are the nearest.
    assert np.linalg.norm(gap, axis=1).min() > 0.25


FOREST_RANGES = {0: (150_000, 900_000), 1: (600_000, 2_000_000), 2: (4e6, 12e6), 3: (20e6, 80e6)}


@pytest.mark.parametrize("detail", FOREST_RANGES)
def test_forest_grows_with_detail(detail: int) -> None:
    scene = datasets.forest(detail=detail)
    low, high = FOREST_RANGES[detail]
    assert low < scene.triangle_count < high
    kinds = {name.split("_")[0] for name in scene.object_names}
    assert kinds >= {"land", "spruce", "oak", "birch"}
    assert ("grass" in kinds) == (detail >= 2)


@pytest.mark.parametrize("trees", [1, 7, 500])
def test_forest_has_the_requested_number_of_trees(trees: int) -> None:
    names = datasets.forest(trees, detail=0).object_names
    assert sum(name.startswith(("spruce_", "oak_", "birch_")) for name in names) == trees


def test_trees_stand_on_the_land() -> None:
    land = _forest.Land.generate(400, 3)
    assert float(land.height(0.0, 0.0)) == 0.0
    corners = datasets.forest(400, seed=3, detail=0).triangles().reshape(-1, 3)
    near = corners[np.abs(corners[:, [0, 2]]).max(axis=1) < 0.5 * land.side]
    # Nothing is deeper in the ground than a scaled trunk's foot, measured on the sheet's chords.
    assert (near[:, 1] - land.height(near[:, 0].astype(float), near[:, 2].astype(float))).min() > -1.5


def test_textures_repeat_and_are_cut_out() -> None:
    planks = _textures.planks(0)[..., :3].astype(int)
    # The seam is no rougher than the rest of the texture (including joints between boards).
    assert np.abs(planks[:, 0] - planks[:, -1]).mean() < 2.0 * np.abs(np.diff(planks, axis=1)).mean()
    alpha = _vegetation.leaf_texture()[..., 3]
    assert set(np.unique(alpha)) == {0, 255}
    assert 0.1 < (alpha == 255).mean() < 0.7
