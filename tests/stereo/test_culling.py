"""Tests of object culling: which instances each view of a rig may show, by one pass over all of them."""

from __future__ import annotations

import math

import numpy as np
import pytest
import trimesh
from numpy.typing import NDArray

import nearfar as nf
from tests.support.hybrid_cases import rig as make_rig

BITS = {"left": 1, "right": 2, "center": 4}
HEAD = (0.4, 1.5, -0.3)
COUNT = 3000


@pytest.fixture(scope="module")
def scattered() -> tuple[nf.Scene, NDArray[np.float64]]:
    """Cubes all around, each a movable instance; and points in each, (N, 125, 3)."""
    dice = np.random.default_rng(3)
    world = trimesh.Scene()
    places = dice.normal(size=(COUNT, 3)) * np.geomspace(1.0, 60.0, COUNT)[:, None]
    sizes = np.tile(dice.uniform(0.05, 1.5, size=(COUNT, 1)), 3)
    for n, (place, size) in enumerate(zip(places, sizes, strict=True)):
        world.add_geometry(trimesh.creation.box(size), node_name=f"box_{n:04}", transform=translated(place))
    grid = np.stack(np.meshgrid(*[np.linspace(-0.5, 0.5, 5)] * 3), axis=-1).reshape(-1, 3)
    scene = nf.Scene.from_trimesh(world).with_dynamic([f"box_{n:04}" for n in range(COUNT)])
    return scene, places[:, None] + grid * sizes[:, None]


def translated(place: NDArray[np.float64]) -> NDArray[np.float64]:
    matrix = np.eye(4)
    matrix[:3, 3] = place
    return matrix


@pytest.mark.parametrize("cant", [0.0, 8.0])
@pytest.mark.parametrize("planes", [6.0, (3.0, 9.0)])
def test_each_view_has_the_instances_that_may_be_visible(
    scattered: tuple[nf.Scene, NDArray[np.float64]], cant: float, planes: float | tuple[float, float]
) -> None:
    rig = make_rig(planes, (80, 90), cant)
    way = nf.Camera.look_at(HEAD, (3.0, 1.0, -5.0), fov=nf.Fov.symmetric(90), size=(1, 1)).orientation
    scene, points = scattered
    near, far = 0.1, 40.0
    found, has_near, has_far = rig._core.contents(scene._core, (HEAD, way, (near, far)), True)
    assert (has_near, has_far) == (True, True)
    # The cubes are the boxes around these spheres.
    radii = np.ptp(points[..., 0], axis=1) / 2
    draws = rig.draws(points.mean(axis=1), radii, HEAD, way, near=near, far=far)
    assert draws.tolist() == [views.bit_count() for views in found.tolist()]
    assert set(draws.tolist()) == {0, 1, 2, 3}
    # The names are sorted, and so are the instances.
    first, last = rig.planes
    ranges = {"left": (near, last), "right": (near, last), "center": (last - rig.overlap, far)}
    for name, camera in zip(BITS, rig.cameras(HEAD, way), strict=True):
        begin, end = ranges[name]
        seen = in_frustum(camera, points, depths(rig, way, points), begin, end)
        listed = (found & BITS[name]) > 0
        assert listed[seen].all()
        assert 20 < seen.sum() < 0.5 * COUNT
        # A zone may show points displaced, which widens the views.
        assert (listed & ~seen).sum() < (0.3 if first < last else 0.12) * listed.sum()


def depths(
    rig: nf.stereo.HybridRig, way: tuple[float, float, float, float], points: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Depths ahead of the plane of the eyes, by the half-space of a clip that begins there."""
    (plane,) = rig.clip(HEAD, way, near=0.0, far=math.inf).half_spaces
    return np.asarray(points @ plane[:3] + plane[3])


def in_frustum(
    camera: nf.Camera, points: NDArray[np.float64], depth: NDArray[np.float64], begin: float, end: float
) -> NDArray[np.bool_]:
    """Whether any point of each box lies in a camera's picture, between two depths."""
    at = camera.project(points.reshape(-1, 3)).reshape(points.shape)
    width, height = camera.size
    with np.errstate(invalid="ignore"):
        shown = (at[..., 0] >= 0) & (at[..., 0] <= width) & (at[..., 1] >= 0) & (at[..., 1] <= height)
    return np.asarray((shown & (depth >= begin) & (depth <= end)).any(axis=1))


def test_pictures_report_the_number_of_instances_per_view(scattered: tuple[nf.Scene, NDArray[np.float64]]) -> None:
    rig = make_rig(6.0, (40, 45))
    all_stats = rig.render(scattered[0], HEAD, backend="cpu").stats
    stats, triangles = all_stats["instances"], all_stats["triangles"]
    assert triangles["all"] == scattered[0].triangle_count
    # All instances have the same number of triangles.
    assert {name: count * COUNT for name, count in triangles.items()} == {
        name: count * triangles["all"] for name, count in stats.items()
    }
    assert set(stats) == {"all", *BITS}
    assert stats["all"] == COUNT
    assert all(0 < stats[name] < COUNT / 2 for name in BITS)
