"""Orthoviews drawn by adapters compared with the CPU, which other tests compare with simple references."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar import _core
from nearfar._render import backend as backends
from tests.support.gpu_cases import adapter
from tests.support.splat_cases import (
    CAMERAS,
    CHANNELS,
    LARGE,
    MIDDLE,
    STRAIGHT,
    THREE,
    draw_splats,
    flat,
    limits_of,
    splats_of,
    wall,
)

WAYS = ("vulkan", "vulkan, 32 bits", "gl")
"""Adapters, and whether they are used without 64-bit atomic integers."""

ALL = ("color", "coverage", *CHANNELS, "position", "shading_normal")


@pytest.fixture(params=WAYS)
def device(request: pytest.FixtureRequest) -> Iterator[_core.GpuDevice]:
    name, *short = str(request.param).split(", ")
    with adapter(name):
        opened = backends.open_device()
        before = opened.allow_long_atomics(not short)
        try:
            yield opened
        finally:
            opened.allow_long_atomics(before)


def check(got: dict[str, Any], right: dict[str, Any], least: float = 0.997) -> None:
    """Compare pictures, except for a few pixels in which rounding decides a splat's edge or the order of two splats."""
    for name in set(right) - {"stats"}:
        close = np.isclose(got[name], right[name], rtol=1e-4, atol=2e-5, equal_nan=True)
        assert got[name].dtype == right[name].dtype
        assert close.mean() >= least, (name, close.mean())
    counts, expected = got["stats"], right["stats"]
    assert all(counts[name] == expected[name] for name in ("splats", "splats_in_picture"))
    # Blocks behind others are culled between batches, but later than on the CPU.
    assert 0.5 * expected["splats_seen"] <= counts["splats_seen"] <= counts["splats_in_picture"]


def test_pictures_equal_the_cpu(device: _core.GpuDevice) -> None:
    splats = splats_of([(1, 0, 0), (0, 1, 0), (0, 0, 1), (0, 1, 1), (-1, -1, 1)])
    for camera in CAMERAS.values():
        right = draw_splats(splats, camera, ALL)
        assert np.isfinite(right["range"]).mean() > 0.02
        check(draw_splats(splats, camera, ALL, device=device), right)


@pytest.mark.parametrize("grid", [2, 3, 8])
def test_colour_is_the_mean_over_samples(device: _core.GpuDevice, grid: int) -> None:
    splats = splats_of(THREE, size=16)
    for name in ("perspective", "parallel"):
        right = draw_splats(splats, CAMERAS[name], ("color", "coverage"), grid)
        got = draw_splats(splats, CAMERAS[name], ("color", "coverage"), grid, device=device)
        # One sample more or less changes a pixel by its share.
        assert (np.abs(got["color"] - right["color"]) <= 1e-4).mean() >= 0.99
        assert np.abs(got["color"] - right["color"]).max() <= 4 / grid**2
        check(got, right, least=0.99)


def test_large_pictures_and_large_views_are_drawn(device: _core.GpuDevice) -> None:
    splats = splats_of(THREE, size=128)
    check(draw_splats(splats, LARGE, ALL, device=device), draw_splats(splats, LARGE, ALL))


def test_all_splat_formats_are_drawn(device: _core.GpuDevice) -> None:
    camera = CAMERAS["perspective"]
    for depth_bits, normal_bits in ((8, 16), (12, 24), (16, 24)):
        splats = splats_of(THREE, depth_bits, normal_bits, size=20)
        check(draw_splats(splats, camera, ALL, device=device), draw_splats(splats, camera, ALL))


@pytest.mark.parametrize("camera", ["perspective", "parallel"])
def test_limits_on_range_and_space_are_applied(device: _core.GpuDevice, camera: str) -> None:
    splats = splats_of(THREE)
    whole = draw_splats(splats, CAMERAS[camera], ALL)["range"]
    for name in ("t_min", "t_max", "both", "box", "planes"):
        limits = limits_of(name)
        right = draw_splats(splats, CAMERAS[camera], ALL, **limits)
        assert not np.array_equal(right["range"], whole)
        check(draw_splats(splats, CAMERAS[camera], ALL, device=device, **limits), right)


@pytest.mark.parametrize("grid", [1, 3])
def test_splats_are_combined_with_earlier_geometry(device: _core.GpuDevice, grid: int) -> None:
    camera, splats = CAMERAS["perspective"], splats_of(THREE)
    width, height = camera.size
    ranges = draw_splats(splats, camera)["range"]
    finer = replace(camera, size=(width * grid, height * grid))
    random = np.random.default_rng(2).random(finer.size[::-1])
    before = wall(finer, np.where(random < 0.3, np.inf, np.median(ranges[np.isfinite(ranges)])))
    channels = (*ALL[:5], "object_id", "face_id")
    right = draw_splats(splats, camera, channels, grid, before=before)
    assert 0.02 < (right["object_id"] == 7).mean() < 0.98
    check(draw_splats(splats, camera, channels, grid, before=before, device=device), right)


def test_walls_cull_whole_blocks(device: _core.GpuDevice) -> None:
    camera, splats = CAMERAS["perspective"], splats_of(THREE)
    images = draw_splats(splats, camera, ("color", "range"), before=wall(camera, 1.0), device=device)
    assert (images["color"] == [1, 0, 0]).all()
    assert (images["range"] == 1).all()
    assert images["stats"]["splats_seen"] == 0 < images["stats"]["splats_in_picture"]


def test_masked_and_bare_pictures_are_drawn(device: _core.GpuDevice) -> None:
    camera, splats = CAMERAS["perspective"], splats_of(THREE)
    mask = np.random.default_rng(0).random(camera.size[::-1]) < 0.6
    for limits in ({"mask": mask}, {"bare": True}):
        right = draw_splats(splats, camera, ALL, **limits)
        check(draw_splats(splats, camera, ALL, device=device, **limits), right)
        assert (right["color"] == 0).all(axis=-1).any()


def test_a_picture_without_splats_is_sky(device: _core.GpuDevice) -> None:
    camera, splats = CAMERAS["perspective"], splats_of(THREE)
    eye = MIDDLE + np.array([0, 0, 60])
    away = nf.Camera.look_at(eye, eye + np.array([0, 0, 30]), fov=camera.fov, size=camera.size)
    for views, lens in (([], camera), (splats, away)):
        got, right = draw_splats(views, lens, ALL, device=device), draw_splats(views, lens, ALL)
        check(got, right, least=1.0)
        assert (got["coverage"] == 0).all()
        assert got["stats"] == right["stats"]


def test_at_equal_depth_the_first_splat_wins(device: _core.GpuDevice) -> None:
    dark, light = flat(50), flat(200)
    for order in ([dark, light], [light, dark]):
        both = draw_splats(order, STRAIGHT, device=device)
        np.testing.assert_array_equal(both["albedo"], draw_splats(order[:1], STRAIGHT)["albedo"])
    nearer = flat(120, 99)
    got = draw_splats([dark, nearer], STRAIGHT, device=device)
    np.testing.assert_array_equal(got["albedo"], draw_splats([nearer], STRAIGHT)["albedo"])


def test_both_atomic_widths_give_the_same_picture() -> None:
    splats = splats_of(THREE, size=64)
    with adapter("vulkan"):
        device = backends.open_device()
        assert device.uses_long_atomics
        pictures = []
        for allowed in (True, False):
            before = device.allow_long_atomics(allowed)
            try:
                assert device.uses_long_atomics == allowed
                pictures.append(draw_splats(splats, LARGE, ALL, device=device))
            finally:
                device.allow_long_atomics(before)
        for name in ALL:
            assert pictures[0][name].tobytes() == pictures[1][name].tobytes()


def test_views_are_uploaded_once_and_freed_with_their_last_reference(device: _core.GpuDevice) -> None:
    splats = splats_of(THREE, size=64)
    own = sum(view.compressed_bytes for view in splats)
    assert 0 < own < sum(view.bytes for view in splats)
    _core.gpu_keep_orthoviews(device, splats)
    kept, sent = _core.gpu_orthoview_bytes(device), device.counters()[2]
    assert kept >= own
    _core.gpu_keep_orthoviews(device, splats)
    assert device.counters()[2] == sent
    draw_splats(splats, CAMERAS["perspective"], device=device)
    # Views in front of the camera with blocks, but without splats.
    assert 0 < device.counters()[2] - sent < own
    del splats
    _core.gpu_keep_orthoviews(device, [])
    assert _core.gpu_orthoview_bytes(device) == kept - own


@pytest.mark.stress
def test_pictures_are_drawn_in_several_bands(device: _core.GpuDevice) -> None:
    """The keys of 4 × 4 samples of so many pixels exceed the limit for one pass."""
    splats = splats_of(THREE, size=64)
    camera = replace(CAMERAS["perspective"], size=(1500, 1150))
    got = draw_splats(splats, camera, ("color", "coverage"), 4, device=device)
    right = draw_splats(splats, camera, ("color", "coverage"), 4)
    # A sample that shows another splat changes a pixel by a sixteenth.
    assert (np.abs(got["color"] - right["color"]) < 0.1).mean() > 0.9995
    assert (got["coverage"] == right["coverage"]).mean() > 0.9995
    seen = right["stats"]["splats_seen"]
    assert 0.9 * seen < got["stats"]["splats_seen"] <= seen


def test_a_lost_device_is_reported(device: _core.GpuDevice) -> None:
    splats = splats_of(THREE)
    device.lose()
    with pytest.raises(nf.DeviceError, match="lost"):
        draw_splats(splats, CAMERAS["perspective"], device=device)
    right = draw_splats(splats, CAMERAS["perspective"])
    check(draw_splats(splats, CAMERAS["perspective"], device=backends.open_device()), right)


def test_threads_share_a_device(device: _core.GpuDevice) -> None:
    camera, splats = CAMERAS["perspective"], splats_of(THREE)
    before = wall(camera, 47.0)
    alone = [draw_splats(splats[:count], camera, ALL[:5], before=before, device=device) for count in (1, 2, 3)]
    with ThreadPoolExecutor(6) as threads:
        jobs = [
            threads.submit(draw_splats, splats[: 1 + n % 3], camera, ALL[:5], before=before, device=device)
            for n in range(12)
        ]
        for n, job in enumerate(jobs):
            for name in ALL[:5]:
                assert job.result()[name].tobytes() == alone[n % 3][name].tobytes()


def test_occluded_views_are_culled(device: _core.GpuDevice) -> None:
    """Along the axis a wall hides a hundred views behind it, except those of the first batch."""
    views = [flat(n, z=-20.0 * n) for n in range(1, 101)]
    got = draw_splats(views[::-1], STRAIGHT, device=device)
    np.testing.assert_array_equal(got["albedo"], draw_splats(views[:1], STRAIGHT)["albedo"])
    counts = got["stats"]
    assert 0 < counts["splats_seen"] < 0.1 * counts["splats_in_picture"]


def test_large_splats_around_the_eye_are_drawn(device: _core.GpuDevice) -> None:
    """Blocks extend behind the eye, and splats across the picture: they are drawn tile by tile."""
    splats = splats_of(THREE, size=32)
    camera = replace(CAMERAS["inside"], size=(90, 72))
    check(draw_splats(splats, camera, ALL, device=device), draw_splats(splats, camera, ALL), least=0.995)
    got, right = (draw_splats(splats, camera, ("color",), 4, device=own)["color"] for own in (device, None))
    assert (np.abs(got - right) < 0.1).mean() > 0.999


def test_pictures_are_drawn_while_other_threads_upload_views(device: _core.GpuDevice) -> None:
    camera, splats = CAMERAS["perspective"], splats_of(THREE, size=32)
    before = wall(replace(camera, size=(192, 144)), 47.0)
    right = draw_splats(splats, camera, ("color",), 3, before=before)["color"]
    over = threading.Event()

    def bring() -> None:
        while not over.is_set():
            _core.gpu_keep_orthoviews(device, splats)

    with ThreadPoolExecutor(2) as threads:
        jobs = [threads.submit(bring) for _ in range(2)]
        try:
            for _ in range(3):
                got = draw_splats(splats, camera, ("color",), 3, before=before, device=device)["color"]
                assert (np.abs(got - right) < 1e-3).mean() > 0.99
        finally:
            over.set()
        for job in jobs:
            job.result()
