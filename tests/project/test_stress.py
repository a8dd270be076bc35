"""Tests at large sizes, which reveal errors of memory, 32-bit numbers and complexity; for `make stress` only."""

from __future__ import annotations

import json

import numpy as np
import psutil
import pytest
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.tokyo import load_arrays, with_buildings
from nearfar.stream._on_demand import OnDemand
from tests.support import need

pytestmark = pytest.mark.stress

STATION = (0.0, 1.7, 0.0)
"""Tokyo Station, the centre of the city, world metres."""

City = tuple[NDArray[np.float32], NDArray[np.uint32]]


@pytest.fixture(scope="module")
def arrays() -> City:
    """Vertices and faces of 29.8 million triangles."""
    need("tokyo")
    found = load_arrays()
    assert found is not None
    return found


@pytest.fixture(scope="module")
def tokyo(arrays: City) -> nf.Scene:
    return nf.Scene.from_arrays(*arrays)


def test_a_scene_borrows_the_arrays_of_a_whole_city(arrays: City) -> None:
    # At most half of the arrays' size may be added; only a few tiles are expected.
    before = psutil.Process().memory_info().rss
    scene = nf.Scene.from_arrays(*arrays)
    grown = psutil.Process().memory_info().rss - before
    assert scene.triangle_count == len(arrays[1])
    assert grown < 0.5 * sum(array.nbytes for array in arrays)


def test_radii_partition_and_curve_agree_on_every_triangle(arrays: City, tokyo: nf.Scene) -> None:
    radii = nf.triangle_radii(*arrays, center=STATION)
    curve = nf.load_curve(tokyo, center=STATION)
    for r1, r2 in ((30.0, 50.0), (500.0, 2000.0), (10_000.0, 40_000.0)):
        zones = nf.partition(tokyo, center=STATION, r1=r1, r2=r2)
        np.testing.assert_array_equal(zones.near, np.flatnonzero(radii[:, 0] <= r1))
        np.testing.assert_array_equal(zones.nsf, np.flatnonzero(radii[:, 0] <= r2))
        np.testing.assert_array_equal(zones.sf, np.flatnonzero(radii[:, 1] > r2))
        assert curve.count(r2) == len(zones.nsf)


def test_metrics_of_gigapixel_pictures_equal_those_of_their_parts() -> None:
    # 32,768 × 32,768 bytes: more than 2³⁰ pixels, with repeated rows, so that the result is known.
    random = np.random.default_rng(0)
    a, b = random.integers(0, 256, (2, 512, 32_768), dtype=np.uint8)
    tall = [np.lib.stride_tricks.as_strided(p, (64, *p.shape), (0, *p.strides)).reshape(-1, 32_768) for p in (a, b)]
    assert nf.metrics.rmse(*tall) == nf.metrics.rmse(a, b)
    # Windows across the seams see other pixels: 11 of 512 rows, with about the same mean.
    assert nf.ssim(*tall, data_range=255) == pytest.approx(nf.ssim(a, b, data_range=255), abs=1e-4)
    assert nf.ssim(tall[0], tall[0], data_range=255) == 1.0


def test_breaks_of_a_large_frame_do_not_depend_on_its_size() -> None:
    # A frontal view of a plane with 4,000 × 4,000 pixels, one half of which is shifted by three pixels.
    side = 4096
    view = nf.Camera((0, 0, 0), fov=nf.Fov.symmetric(90, 1), size=(side, side))
    step = 2.0 / side
    y, x = np.mgrid[:side, :side]
    position = np.stack(
        [(x + 0.5) * step - 1 + np.where(x >= side // 2, 3 * step, 0), 1 - (y + 0.5) * step, -1 + 0 * x], -1
    )
    torn = nf.metrics.discontinuity(nf.Frame(view, position=position.astype(np.float32)))
    assert abs(torn[100:-100, 100:1000]).max() < 1e-3
    middle = torn[100:-100, side // 2 - 1]
    assert middle.min() < -0.01
    np.testing.assert_allclose(middle, middle.mean(), atol=2e-3)


def test_the_map_of_a_whole_city_equals_ray_tracing(tokyo: nf.Scene) -> None:
    reduced = nf.reduce(tokyo, center=STATION, r1=30, r2=50, face_size=256, samples=1, channels=("color", "range"))
    assert reduced.env is not None
    assert reduced.env.range is not None
    for face in range(6):
        view = nf.Camera(STATION, fov=nf.CubeFace(face), size=(256, 256))
        truth = nf.render(tokyo, view, channels=("range", "position")).require("range")
        baked = reduced.env.range[face]
        # Where the truth is beyond r2 in every direction's horizontal part, both hit the same surface by the same ray.
        directions = view.rays()[1]
        far = truth * np.hypot(directions[..., 0], directions[..., 2]) > 50.0
        far &= np.isfinite(truth)
        # One float32 step of the range, computed from two starting points.
        np.testing.assert_allclose(baked[far], truth[far], rtol=2e-7)


def test_regions_on_demand_of_a_whole_city_examine_few_buildings() -> None:
    need("tokyo")
    found = with_buildings()
    assert found is not None
    scene, radii = nf.Scene.from_arrays(found[0], found[1], face_object=found[2]), (10.0, 22.0, 63.0)
    maker = OnDemand(scene, radii=radii, face_size=64, samples=1)
    for place in ((-28.0, 1.75, -8.0), (-10214.0, 1.75, -6254.0)):
        expected = nf.stream.assign(scene, center=place, radii=radii)
        (region,) = json.loads(next(maker.parts(place)).line)["manifest"]["regions"]
        counts = [[ring[key] for key in ("objects", "triangles")] for ring in region["rings"][1:]]
        assert counts == [[row[key] for key in ("objects", "triangles")] for row in expected.summary()[:3]]
        rings = nf.stream.assign(maker._tiles.scene_about(place, radii[-1]), center=place, radii=radii)
        np.testing.assert_array_equal(rings.ring, expected.ring)
        # The others lie in tiles whose boxes are beyond the last radius.
        assert rings.measured < 0.01 * scene.triangle_count


def test_a_city_of_hundreds_of_millions_by_instances() -> None:
    scene = nf.datasets.city(40, detail=3)
    assert scene.triangle_count > 3e8
    eye, target = nf.datasets.street_view()
    view = nf.Camera.look_at(eye, target, fov=nf.Fov.symmetric(90, 16 / 9), size=(480, 270))
    reduced = nf.reduce(scene, center=eye, r1=30, r2=50, face_size=256, samples=1)
    # The remaining triangles depend on the street, not on the size of the city.
    assert reduced.stats["drawn"] < 1e6
    truth, light = nf.render(scene, view), reduced.render(view, samples=1)
    near = np.isfinite(truth.require("range")) & (truth.require("range") < 30)
    # For a user at the centre nothing is morphed: inside r1 both trace the same triangles by the same rays.
    assert np.mean(np.any(truth.require("color")[near] != light.require("color")[near], axis=-1)) < 1e-3


@pytest.mark.parametrize("kind", ["blend", "cylinder"])
def test_ten_million_points_are_morphed_as_in_float64(kind: str) -> None:
    index = np.arange(10_000_000, dtype=np.float64)
    # A spiral that fills the disc of 100 m and heights up to 400 m evenly.
    rho, turn = 100 * np.sqrt((index + 0.5) / len(index)), 2.399963 * index
    points = np.stack([rho * np.cos(turn), 400 * np.mod(index * 0.618034, 1), rho * np.sin(turn)], axis=1)
    narrow = points.astype(np.float32)
    settings = {"user": (5.0, 1.7, 3.0), "center": (0.0, 1.7, 0.0), "r1": 30.0, "r2": 50.0, "kind": kind}
    shown = nf.morph(narrow, **settings)  # type: ignore[arg-type]
    exact = nf.morph(narrow.astype(np.float64), **settings)  # type: ignore[arg-type]
    # Half a float32 step at 400 m, and 2⁻²⁴ (6 + 3 r2/(r2−r1)) |U−O| of the stated bound; ten times that where the
    # cylinder's square root is taken near the user's own distance from the axis.
    bound = (2.0**-16 + 2.0**-24 * 13.5 * 6.0) * (1 if kind == "blend" else 10)
    assert np.abs(shown - exact).max() < bound
