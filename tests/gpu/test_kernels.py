"""Tests of the kernels on the graphics device against those of the CPU, which have their own oracles."""

from __future__ import annotations

import threading
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings, strategies as st
from numpy.typing import NDArray

import nearfar as nf
from nearfar import _core, gpu
from nearfar._cubemap.lookup import Filter
from nearfar._scene.scene import core_of
from tests.support import need
from tests.support.gpu_cases import ADAPTERS, adapter
from tests.support.reduce_cases import CENTER, camera, street

CHANNELS = ("color", "range", "object_id", "face_id", "position", "normal")
EPSILON = 2.0**-24
"""Greatest relative error of rounding to float32."""

# Sharing a module's fixture between examples is safe.
SHARED = settings(suppress_health_check=[HealthCheck.function_scoped_fixture])


@pytest.fixture
def device(backend: str) -> _core.GpuDevice:
    return _core.GpuDevice(backend)


def view(aside: float = 0.0, size: tuple[int, int] = (96, 60)) -> nf.Camera:
    return camera(CENTER + np.array([0, 0.2, 7.0 + aside]), (1, -0.03, 0.1), size)


# frames ---------------------------------------------------------------------------------------------------------------
def test_a_frame_kept_on_the_device_equals_its_copy(device: _core.GpuDevice) -> None:
    scene, shot = street(), view()
    core = core_of(scene)
    settings = nf.Shot(cameras=(shot,), channels=CHANNELS, samples=4).settings
    expected = device.truth(core, [shot._core], settings)[0].finish()
    device_frame = gpu.render(scene, shot, channels=CHANNELS, samples=4)
    for _ in range(2):
        frame = device_frame.read()
        assert frame.channels == device_frame.channels == CHANNELS
        assert frame.origin == core.origin
        assert frame.camera is device_frame.camera is shot
        for name in CHANNELS:
            np.testing.assert_array_equal(frame.require(name), expected[name])
    assert repr(device_frame).startswith("DeviceFrame(96 × 60, color, range, object_id, face_id, position, normal, on ")


def test_memory_of_dropped_frames_is_reused(device: _core.GpuDevice) -> None:
    scene = street()
    size = (61, 47)

    def draw() -> gpu.DeviceFrame:
        return gpu.render(scene, view(size=size), channels=("color", "position"))

    first, second = draw(), draw()
    before = first.read()
    gpu.ssim(first, second)
    np.testing.assert_array_equal(first.read().require("color"), before.require("color"))
    del first, second
    made = device.counters()[0]
    for _ in range(3):
        frame = draw()
        frame.read()
        del frame
    assert device.counters()[0] == made


def test_frames_of_several_windows_are_refused(device: _core.GpuDevice) -> None:
    across = next(row[6] for row in _core.gpu_adapters() if device.label == f"{row[0]} ({row[1]})")
    if across + 8 > 1 << 16:
        pytest.skip("this adapter draws pictures of any size that cameras have")
    wide, before = camera(CENTER, (1, 0, 0), (across + 8, 2)), gpu.stats()
    with pytest.raises(ValueError, match=f"camera: expected .*{across} each way.*got {across + 8} × 2"):
        gpu.render(street(), wide)
    assert gpu.stats() == before  # Nothing was uploaded.


def test_missing_channels_are_named(device: _core.GpuDevice) -> None:
    scene = street()
    frame, other = gpu.render(scene, view(), channels=("color",)), gpu.render(scene, view(), channels=("range",))
    with pytest.raises(ValueError, match=r"no color: .*'color', 'range'"):
        gpu.ssim(frame, other)
    with pytest.raises(ValueError, match="no position"):
        gpu.discontinuity(frame)
    with pytest.raises(ValueError, match="test: expected 96 × 60 pixels, got 32 × 60"):
        gpu.ssim(frame, gpu.render(scene, view(size=(32, 60)), channels=("color",)))


def test_reading_and_comparing_run_one_after_the_other(device: _core.GpuDevice) -> None:
    scene = street()
    one, other = (gpu.render(scene, view(aside), channels=("color",)) for aside in (0.0, 0.4))
    expected, picture = gpu.ssim(one, other), one.read().require("color")
    wrong = []

    def work(first: gpu.DeviceFrame, second: gpu.DeviceFrame) -> None:
        for _ in range(20):
            if gpu.ssim(first, second) != expected or not np.array_equal(one.read().require("color"), picture):
                wrong.append(1)

    threads = [threading.Thread(target=work, args=pair) for pair in ((one, other), (other, one))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert wrong == []


# similarity -----------------------------------------------------------------------------------------------------------
WINDOWS: tuple[dict[str, Any], ...] = (
    {},
    {"size": 4},
    {"size": 17, "sigma": 3.0},
    {"window": "uniform", "size": 7},
    {"size": 1},
)


@pytest.mark.parametrize("size", [(96, 60), (33, 17), (16, 16), (9, 40), (3, 2), (1, 1)])
def test_similarity_equals_the_cpu(device: _core.GpuDevice, size: tuple[int, int]) -> None:
    one, same, other = (gpu.render(street(), view(aside, size), channels=("color",)) for aside in (0.0, 0.0, 0.4))
    for window in WINDOWS:
        if window.get("size", 11) > min(size):
            with pytest.raises(ValueError, match=f"size: expected a window of at most {min(size)} pixels"):
                gpu.ssim(one, other, **window)
            continue
        mean, found = gpu.ssim(one, other, full=True, **window)
        expected, similarities = nf.ssim(one.read(), other.read(), full=True, **window)
        # Encoded values are off by 2 roundings of 1, so that σ of the difference is by 1.2e-7 and, over c₂ = 0.03²,
        # the second factor by 2 σd 1.2e-7 / (σ² + c₂) ≤ 4e-6; the first by as much over c₁ = 0.01²: 1.2e-5. Means
        # average errors of both signs.
        assert np.abs(found - similarities).max() < 2e-5
        assert abs(mean - expected) < 1e-6
        assert gpu.ssim(one, other, **window) == mean == gpu.ssim(other, one, **window)
        for equal in (one, same):
            mean, found = gpu.ssim(one, equal, full=True, **window)
            assert mean == 1.0
            assert (found == 1.0).all()


# discontinuity --------------------------------------------------------------------------------------------------------
TRUTHS: dict[str, nf.Camera | None] = {
    "own": None,
    "aside": view(0.4),
    "parallel": nf.Camera(
        tuple(CENTER), (0, -np.sqrt(0.5), 0, np.sqrt(0.5)), fov=nf.Orthographic(-20, 20, -12, 12), size=(70, 40)
    ),
    "cube": nf.Camera(tuple(CENTER), fov=nf.CubeFace(0), size=(64, 64)),
    "behind": camera(CENTER, (-1, 0, 0), (40, 30)),
}


NEIGHBOURS = [(17.03, 1.0), (5.01, 0.25), (200.3, 5.0), (1e4, 1.0), (17.03, 1.0)]


@pytest.mark.parametrize(
    ("name", "epsilon", "least"), [(name, *near) for name, near in zip(TRUTHS, NEIGHBOURS, strict=True)]
)
def test_discontinuity_equals_the_cpu(device: _core.GpuDevice, name: str, epsilon: float, least: float) -> None:
    truth = TRUTHS[name]
    frame = gpu.render(street(), view(size=truth.size if truth else (96, 60)), channels=("position",))
    found = gpu.discontinuity(frame, truth, epsilon=epsilon, min_distance=least)
    expected = nf.metrics.discontinuity(frame.read(), truth, epsilon=epsilon, min_distance=least)
    np.testing.assert_array_equal(np.isnan(found), np.isnan(expected))
    # Positions are rounded to some 1e-5 pixels; a pair at a distance that close to ε may count or not: one of dozens.
    np.testing.assert_allclose(found, expected, rtol=2e-3, atol=2e-3)
    differs = np.abs(found - expected) > 1e-4 * (1 + np.abs(expected))
    assert differs.mean() < 0.02
    again = gpu.discontinuity(frame, truth, epsilon=epsilon, min_distance=least)
    np.testing.assert_array_equal(again, found)


@pytest.mark.stress
def test_dense_clusters_of_points_are_summed_completely(device: _core.GpuDevice) -> None:
    # Four squares and a point amidst them lie in nine cells of 4 pixels of the truth. The point visits more points
    # than the iterations after which software drivers end loops, and each square has more of them than a call takes.
    side, size = np.array([2 / 3, 1.0]), (780, 780)
    squares = [(a * side, b * side) for a in (-1, 1) for b in (-1, 1)] + [(side * 0.03 - 0.025,) * 2]
    corners = np.array([(x, y, -1) for xs, ys in squares for y in ys for x in xs], np.float32)
    faces = [[4 * n + i for i in face] for n in range(len(squares)) for face in ((0, 1, 2), (1, 3, 2))]
    shot, heap = (nf.Camera((0, 0, 0), fov=nf.Fov(-t, t, -t, t), size=size) for t in (1, 65))
    frame = gpu.render(nf.Scene.from_arrays(corners, faces), shot, channels=("position",))
    read = frame.read()
    points = read.require("position").reshape(-1, 3).astype(np.float64)
    cells = heap.project(points[np.isfinite(points[:, 0])])[:, :2] // 4
    places, counts = np.unique(cells, axis=0, return_counts=True)
    assert np.ptp(places, axis=0).tolist() == [2, 2]
    assert counts.sum() > 1 << 16
    assert np.sort(counts)[1] > 1 << 12
    found = gpu.discontinuity(frame, heap, epsilon=1.0137)
    # Positions are rounded to some 1e-5 pixels; of thousands of neighbours some at the distance ε may count or not.
    np.testing.assert_allclose(found + 1, nf.metrics.discontinuity(read, heap, epsilon=1.0137) + 1, rtol=5e-3)


def test_pictures_without_continuous_pixels_have_no_discontinuity(device: _core.GpuDevice) -> None:
    frame = gpu.render(street(), view(), channels=("position",))
    assert np.isnan(gpu.discontinuity(frame, epsilon=1e-3)).all()


# morph ----------------------------------------------------------------------------------------------------------------
def scattered(seed: int, center: NDArray[np.float64], r2: float, count: int) -> NDArray[np.float32]:
    random = np.random.default_rng(seed)
    size = r2 * 10 ** random.uniform(-2, 2, (count, 1))
    return (center + random.normal(size=(count, 3)) * size).astype(np.float32)


@SHARED
@given(
    st.integers(0, 2**32 - 1),
    st.floats(1, 1e3),
    st.floats(1.1, 20),
    st.sampled_from([0.0, 1e3, 1e6]),
    st.floats(0, 0.5),
    st.sampled_from(["blend", "cylinder"]),
)
def test_morphed_points_are_within_their_bound(
    device: _core.GpuDevice, seed: int, r1: float, ratio: float, away: float, share: float, kind: str
) -> None:
    r2, center = r1 * ratio, np.array([away, 1.7, -away / 3])
    step = np.random.default_rng(seed).normal(size=3)
    offset = step / np.linalg.norm(step) * share * r1
    points = scattered(seed, center, r2, 500)
    place: dict[str, Any] = {"user": center + offset, "center": center, "r1": r1, "r2": r2, "kind": kind}
    found = gpu.morph(points, **place)
    expected = nf.morph(points.astype(np.float64), **place)
    apart = np.abs(found - expected).max(axis=1)
    # One step of the result; beyond r₁ roundings of the formula, relative to the user's offset and greater
    # for narrow intermediate zones. The centre itself is rounded to 2⁻⁴⁸ of its size.
    bound = np.spacing(np.abs(found).max(axis=1)) + EPSILON * (16 + 8 * ratio / (ratio - 1)) * share * r1
    bound += 2.0**-46 * np.abs(center).max()
    if kind == "cylinder":
        # Where the direction leaves the cylinder: some roundings of the distance, greater near the user's own radius.
        rho = np.hypot(*(points[:, [0, 2]] - center[[0, 2]]).T)
        distance = np.linalg.norm(points - center, axis=1) + share * r1
        bound += np.where(rho > r1, EPSILON * 32 * distance * rho / np.maximum(rho - share * r1, 1e-30), 0.0)
    assert (apart <= bound).all(), (apart / bound).max()


def test_points_inside_keep_their_bits_and_nan_stays_nan(device: _core.GpuDevice) -> None:
    points = scattered(1, np.zeros(3), 5.0, 1000)
    place: dict[str, Any] = {"user": (3, 0.5, 1), "center": (0, 0, 0)}
    np.testing.assert_array_equal(gpu.morph(points, r1=1e5, r2=2e5, **place), points)
    points[::7, 1] = np.nan
    points[::11, 0] = np.nan
    for kind in ("blend", "cylinder"):
        found = gpu.morph(points, r1=4, r2=9, kind=kind, **place)
        np.testing.assert_array_equal(np.isnan(found).any(axis=1), np.isnan(points).any(axis=1))
    assert gpu.morph(np.empty((0, 3), np.float32), r1=4, r2=9, **place).shape == (0, 3)
    nothing_near = gpu.morph(points[1:7], r1=0, r2=0, kind="cylinder", **place)
    np.testing.assert_allclose(nothing_near, nf.morph(points[1:7], r1=0, r2=0, kind="cylinder", **place), rtol=1e-5)


def test_long_arrays_are_morphed_in_pieces(device: _core.GpuDevice) -> None:
    """Three pieces of 16 MiB and a last short one: each point is morphed as among a few."""
    points = scattered(2, np.zeros(3), 20.0, 10_007)
    place: dict[str, Any] = {"user": (3, 0.5, 1), "center": (0, 0, 0), "r1": 10, "r2": 30}
    found = gpu.morph(np.tile(points, (400, 1)), **place).reshape(400, *points.shape)
    assert (found == gpu.morph(points, **place)).all()


# lookup ---------------------------------------------------------------------------------------------------------------
def ranges(seed: int, shape: tuple[int, ...]) -> NDArray[np.float32]:
    random = np.random.default_rng(seed)
    faces = (random.random(shape) * 100 - 20).astype(np.float32)
    faces[random.random(shape) < 0.1] = np.inf
    faces[random.random(shape) < 0.3] = np.nan
    return faces


@SHARED
@given(st.integers(0, 2**32 - 1), st.integers(1, 40), st.sampled_from(gpu._kernels.FILTERS))
def test_lookups_equal_the_cpu(device: _core.GpuDevice, seed: int, size: int, chosen: Filter) -> None:
    random = np.random.default_rng(seed)
    faces = ranges(seed, (6, size, size))
    directions = (random.normal(size=(600, 3)) * 10.0 ** random.integers(-3, 4, (600, 1))).astype(np.float32)
    found = gpu.cube_lookup(faces, directions, filter=chosen)
    expected = nf.cube_lookup(faces, directions, filter=chosen)
    same = (found == expected) | (np.isnan(found) & np.isnan(expected))
    # Within some roundings of a border between texels or their centres, the neighbouring texels may be used.
    assert (~same).mean() < 0.01
    for n in np.flatnonzero(~same):
        beside = directions[n] * (1 + 1e-6 * random.normal(size=(200, 3)))
        others = nf.cube_lookup(faces, beside, filter=chosen)
        # If a direction rounds to the line through centres, the texels on one side of it do not count at all.
        around = directions[n] * (1 + random.uniform(-2.0 / size, 2.0 / size, (200, 3)))
        texels = nf.cube_lookup(faces, around, filter="nearest")
        assert np.isnan(found[n]) or (others == found[n]).any() or np.isnan(others).any() or (texels == found[n]).any()


@pytest.mark.parametrize("chosen", gpu._kernels.FILTERS)
def test_lookups_of_edges_corners_and_channels(device: _core.GpuDevice, chosen: Filter) -> None:
    # No direction on these axes and diagonals depends on rounding: coordinates are -1, 0 and 1.
    grid = np.stack(np.meshgrid(*[(-1, 0, 1)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    directions = grid[np.abs(grid).any(axis=1)].astype(np.float32).reshape(2, 13, 3)
    faces = ranges(5, (6, 5, 5, 3))
    found = gpu.cube_lookup(faces, directions, filter=chosen)
    assert found.shape == (2, 13, 3)
    np.testing.assert_array_equal(found, nf.cube_lookup(faces, directions, filter=chosen))
    assert gpu.cube_lookup(faces, np.empty((0, 3), np.float32), filter=chosen).shape == (0, 3)


def test_lookups_check_their_arguments(device: _core.GpuDevice) -> None:
    faces, directions = np.zeros((6, 4, 4), np.float32), np.ones((5, 3), np.float32)
    bad = np.ones((2_000_000, 3), np.float32)
    bad[[1_500_000, 1_900_000]] = 0.0
    for wrong in (0.0, np.nan, np.inf):
        bad[1_500_000, 1] = wrong
        with pytest.raises(ValueError, match=r"directions: .* at index 1500000"):
            gpu.cube_lookup(faces, bad)
    with pytest.raises(TypeError, match="faces: expected float32"):
        gpu.cube_lookup(faces.astype(int), directions)


# loss -----------------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("name", ["vulkan", "gl"])
def test_a_lost_device_raises_and_the_next_one_works(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    need(name)
    monkeypatch.setenv("NEARFAR_ADAPTER", name)
    points = scattered(1, np.zeros(3), 5.0, 10)
    place: dict[str, Any] = {"user": (1, 0, 0), "center": (0, 0, 0), "r1": 2, "r2": 9}
    frame = gpu.render(street(), view(), channels=("color", "position"))
    device = _core.GpuDevice(name)
    device.lose()
    for job in (frame.read, lambda: gpu.ssim(frame, frame), lambda: gpu.discontinuity(frame)):
        with pytest.raises(nf.DeviceError, match="lost"):
            job()
    with pytest.raises(nf.DeviceError, match="lost"):
        _core.gpu_morph(device, points, points.copy(), place | {"kind": "blend", "strength": 1.0})
    assert gpu.morph(points, **place).shape == (10, 3)
    again = gpu.render(street(), view(), channels=("color",))
    for old in ((again, frame), (frame, again)):
        with pytest.raises(nf.DeviceError, match="lost"):
            gpu.ssim(*old)


def test_frames_of_two_devices_are_not_compared() -> None:
    frames = []
    for name in ADAPTERS:
        with adapter(name):
            frames.append(gpu.render(street(), view(), channels=("color",)))
    with pytest.raises(ValueError, match=r"test: expected a frame on .* got one on"):
        gpu.ssim(*frames)
