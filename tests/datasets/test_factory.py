"""Tests of the factory: identical bytes, closed hall and solids, free views, the same picture without instances."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar import datasets
from nearfar.datasets._factory import (
    forklifts,
    gangway,
    machines,
    parts,
    pipes,
    plan,
    presses,
    robots,
    shell,
    steel,
    storage,
    tanks,
)
from nearfar.datasets._palette import material
from nearfar.datasets._random import RandomStream
from nearfar.datasets._shapes import Soup, weld
from nearfar.datasets._stage import Stage
from tests.support.solids import areas, count_covered, digest, lone_edges, volume

STEEL = material("metal")


@pytest.fixture(scope="module")
def hall() -> nf.Scene:
    return datasets.factory(detail=1)


@pytest.fixture(scope="module")
def simple() -> nf.Scene:
    return datasets.factory(detail=0)


def sphere(count: int) -> NDArray[np.float64]:
    """Return evenly spread unit directions (count, 3): a Fibonacci lattice."""
    index = np.arange(count)
    y, turn = 1.0 - 2.0 * (index + 0.5) / count, index * 2.399963
    radius = np.sqrt(1.0 - y * y)
    return np.stack([radius * np.cos(turn), y, radius * np.sin(turn)], -1)


PROTOTYPES: dict[str, Callable[[int], Soup]] = {
    "casing": lambda d: parts.casing([0, 0, 0], [1, 2, 1], 0.1, STEEL, d),
    "drum": lambda d: parts.drum(0.5, 0.0, 1.0, STEEL, d, 0.05),
    "torus": lambda d: parts.torus(0.5, 0.05, STEEL, d),
    "flange": lambda d: parts.flange(0.1, STEEL, max(d, 1)),
    "gauge": lambda d: parts.gauge(0.1, d),
    "panel": parts.panel,
    "signal tower": lambda d: parts.signal_tower(2.0, max(d, 1)),
    "bent pipe": lambda d: parts.piping([[0, 0, 0], [2, 0, 0], [2, 3, 0], [2, 3, -1]], 0.1, 0.3, STEEL, d),
    "beam": lambda d: parts.i_beam([0, 0, 0], 5.0, 0.4, 0.3, STEEL),
    "lathe": lambda d: machines.lathe_machine(1, d),
    "mill": lambda d: machines.mill(2, d),
    "press": lambda d: presses.press(1, d),
    "bench": lambda d: presses.bench(0, 1, d),
    "compressor": lambda d: presses.compressor(1, d),
    "robot": lambda d: robots.robot(1, d),
    "conveyor": robots.conveyor,
    "fence": robots.fence,
    "carton": lambda d: robots.carton(1, d),
    "tank": lambda d: tanks.tank(2, d),
    "rack": lambda d: storage.rack(0, 3, max(d, 1)),
    "end of a rack": storage.rack_end,
    "barrel": lambda d: storage.barrel(STEEL, d),
    "railing": lambda d: gangway.railing(2.0, d),
    "gangway": gangway.deck,
    "stairs": gangway.stairs,
    "mezzanine": gangway.cabin,
    "forklift": forklifts.forklift,
    "column": steel.column,
    "girder": steel.girder,
    "truss": lambda d: steel.truss(10, d),
    "crane": steel.bridge,
    "lamp": steel.lamp,
    "valve": lambda d: pipes.valve(0.1, d),
    "pipe": lambda d: pipes.straight(0.26, STEEL, d, insulated=True),
    "riser": lambda d: pipes.riser(4.3, 0.1, STEEL, d),
    "branch": pipes.branch,
    "duct": pipes.duct,
    "sprinkler": pipes.sprinkler,
}


@pytest.mark.parametrize("name", PROTOTYPES)
def test_prototypes_are_closed_and_face_outwards(name: str) -> None:
    for detail in range(4):
        soup = PROTOTYPES[name](detail)
        assert len(lone_edges(soup)) == 0, detail
        assert volume(soup) > 0, detail
        # A square of a tenth of a millimetre: far below the smallest part, far above float32's rounding at 10 m.
        assert areas(soup.corners.astype(np.float32)).min() > 1e-8, detail
        # No surface lies in another one.
        assert detail not in {1, 2} or count_covered(soup.corners) == 0, detail


def test_a_bent_pipe_keeps_its_radius() -> None:
    bent = parts.piping([[0, 0, 0], [2, 0, 0], [2, 3, 0], [2, 3, -1]], 0.1, 0.3, STEEL, 3)
    ends = bent.corners[np.abs(bent.corners[..., 2] + 1.0).max(axis=1) < 1e-12].reshape(-1, 3)
    rim = np.hypot(ends[:, 0] - 2.0, ends[:, 1] - 3.0)
    np.testing.assert_allclose(rim[rim > 1e-9], 0.1, rtol=1e-12)
    assert np.abs(bent.corners[..., 1].min() + 0.1) < 0.01


# Triangles by detail, as the documentation says; seeds change them by a few hundredths.
RANGES = {0: (120_000, 180_000), 1: (600_000, 900_000), 2: (1_800_000, 2_600_000)}


@pytest.mark.parametrize("detail", [0, 1, pytest.param(2, marks=pytest.mark.slow)])
def test_the_factory_grows_with_detail(simple: nf.Scene, hall: nf.Scene, detail: int) -> None:
    scene = (simple, hall)[detail] if detail < 2 else datasets.factory(detail=detail)
    low, high = RANGES[detail]
    assert low < scene.triangle_count < high
    names = scene.object_names
    assert len(set(names)) == len(names)
    assert {"floor", "column_7", "machine_12", "robot_5", "tank_3", "pipe_40", "rack_3", "railing_2"} <= set(names)
    assert ("branch_9" in names) == (detail >= 1)


def test_a_seed_gives_the_same_bytes_and_another_one_others(simple: nf.Scene) -> None:
    again, other = (datasets.factory(seed=seed, detail=0) for seed in (0, 1))
    assert digest(simple.triangles()) == digest(again.triangles()) != digest(other.triangles())
    assert simple.object_names == again.object_names


# A fixed hash detects changes of platform, NumPy or drawing order; replace it only on purpose.
GOLDEN = "eea287dedc4bef87"


def test_geometry_has_the_same_bytes_everywhere() -> None:
    made = [
        machines.lathe_machine(1, 3),
        robots.robot(2, 3),
        tanks.tank(1, 3),
        storage.rack(7, 2, 3),
        forklifts.forklift(2),
        pipes.branch(3),
    ]
    found = [array for soup in map(weld, made) for array in (soup.positions, soup.faces)]
    assert digest(*found) == GOLDEN


def test_all_numbers_are_finite_and_no_triangle_is_degenerate(hall: nf.Scene) -> None:
    corners = hall.triangles()
    assert np.isfinite(corners).all()
    # World coordinates to 80 m are rounded to 8 µm.
    assert areas(corners).min() > 1e-9
    assert hall.report.degenerate_faces == 0


@pytest.mark.parametrize("detail", [0, 2])
def test_the_hall_is_closed(detail: int) -> None:
    stage = Stage()
    shell.build(stage, 0, detail)
    empty = stage.build()
    directions = sphere(20_000)
    for eye in ((0.0, 1.7, 0.0), (79.0, 11.5, -59.0), (-79.5, 13.0, 59.5), (30.0, 0.2, 59.0)):
        seen = nf.cast_rays(empty, eye, directions)
        assert seen.hit.all()
        # The diagonal of the hall, with its saw teeth.
        assert seen.t_hit.max() <= np.sqrt(160.0**2 + 120.0**2 + 14.0**2)


@pytest.mark.parametrize("place", [0, 1])
def test_the_viewer_stands_free_inside(hall: nf.Scene, place: int) -> None:
    eye, target = datasets.factory_view(place)
    assert nf.nearest_points(hall, [eye]).distance[0] > 0.8
    seen = nf.cast_rays(hall, eye, sphere(20_000))
    assert seen.hit.all()
    assert seen.t_hit.max() < 200.0
    # The view is open along the lane.
    away = np.subtract(target, eye)
    assert nf.cast_rays(hall, eye, away[None]).t_hit[0] > 10.0


def test_no_two_machines_overlap() -> None:
    """Checks boxes around the objects in the slots, as wide as the slots' pitch allows."""
    slots = plan.slots()
    assert len(slots) == 200
    for name in ("lathe", "mill", "press", "bench", "compressor", "tank"):
        corners = PROTOTYPES[name](1).corners
        assert np.ptp(corners[..., 0]) < plan.PITCH
        # The supply cabinets end 1.5 m from the columns; the lanes begin 7.4 m from them.
        low, high = corners[..., 2].min() + plan.ASIDE, corners[..., 2].max() + plan.ASIDE
        assert name == "tank" or low > 1.5
        assert high < 7.6


def test_forklifts_are_dynamic(hall: nf.Scene) -> None:
    assert hall.report.dynamic == 8
    pose = np.eye(4)
    pose[:3, 3] = (5.0, 0.0, -1.0)
    moved = hall.at({"forklift_0": pose})
    assert moved.triangle_count == hall.triangle_count
    with pytest.raises(ValueError, match="machine"):
        hall.at({"machine_1": pose})


@pytest.mark.parametrize("name", ["factory", "city"])
def test_copies_that_share_no_mesh_look_alike(simple: nf.Scene, name: str) -> None:
    if name == "factory":
        shared, copied = simple, datasets.factory(detail=0, instanced=False)
    else:
        shared, copied = (datasets.city(blocks=2, detail=1, instanced=instanced) for instanced in (True, False))
    assert copied.triangle_count == shared.triangle_count
    assert copied.object_names == shared.object_names
    # All static objects are one mesh; each of the eight moving objects has its own.
    assert copied.report.dynamic == shared.report.dynamic == 8
    assert copied.report.meshes == copied.report.instances == 9
    assert shared.report.instances > 100
    eye, target = datasets.factory_view() if name == "factory" else datasets.street_view()
    camera = nf.Camera.look_at(eye, target, fov=nf.Fov.symmetric(80), size=(160, 100))
    first, second = (nf.render(scene, camera, channels=("range",)).require("range") for scene in (shared, copied))
    # Corners are rounded to float32 in the world instead of in their mesh's frame; edges may move over pixels' centres.
    # Pixels that see the sky have an infinite range in both.
    assert np.isclose(first, second, rtol=1e-4, atol=0.0).mean() > 0.999


@pytest.mark.slow
def test_the_near_zone_has_the_size_of_the_published_scene() -> None:
    scene = datasets.factory(detail=3)
    eye, _ = datasets.factory_view()
    near = nf.stream.assign(scene, center=eye, radii=[63.0]).summary()[0]
    assert 2_200_000 < near["triangles"] < 2_500_000


def test_loads_rest_on_their_pallets() -> None:
    for seed in range(8):
        corners = storage.pallet(RandomStream(seed, 1), 2).corners
        assert np.abs(corners[..., 0]).max() < 0.62
        assert np.abs(corners[..., 2]).max() < 0.48
        assert corners[..., 1].min() == 0.0
        assert corners[..., 1].max() < 1.4
