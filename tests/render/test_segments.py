"""Ray segments between two distances: against brute force, against scenes cut by hand, and on graphics adapters."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar._render.channels import DRAWN
from nearfar._scene.builder import SceneBuilder
from tests.support import render_oracle as oracle
from tests.support.gpu_cases import ADAPTERS, adapter, agree, backend_of, both, check_color, crowd, view
from tests.support.render_cases import PROJECTIONS, QUAD, WIDE, build, quad, room

SEGMENTS = [(3.5, np.inf), (0.0, 6.0), (4.0, 7.25)]
TURN = (0.05, -0.12, 0.02, np.sqrt(1 - 0.0173))
CAMERAS = [nf.Camera((0.3, 0.1, 0.4), TURN, fov=fov, size=(41, 41)) for fov in PROJECTIONS]


@pytest.mark.parametrize("segment", SEGMENTS)
@pytest.mark.parametrize("camera", CAMERAS, ids=lambda camera: str(camera.fov))
def test_every_channel_agrees_with_brute_force(camera: nf.Camera, segment: tuple[float, float]) -> None:
    surfaces = room()
    frame = nf.render(build(surfaces), camera, channels=DRAWN, t_min=segment[0], t_max=segment[1], backend="cpu")
    expected = oracle.cast(surfaces, oracle.view(camera), segment)
    flat = {name: frame.require(name).reshape(41 * 41, *frame.require(name).shape[2:]) for name in DRAWN}
    np.testing.assert_array_equal(flat["object_id"], expected.object_id)
    np.testing.assert_array_equal(flat["face_id"], expected.face_id)
    # As for whole rays: coordinates of 10 m are rounded by 5e-7, and texture coordinates of 8 by as much.
    np.testing.assert_allclose(flat["range"], expected.range, rtol=2e-6)
    np.testing.assert_allclose(flat["position"], expected.position, atol=1e-5)
    np.testing.assert_allclose(flat["color"], expected.color, atol=1e-4)


def test_samples_of_a_pixel_end_on_their_own_rays() -> None:
    surfaces, camera = room(), nf.Camera((0, 0, 2), fov=WIDE, size=(30, 20))
    frame = nf.render(build(surfaces), camera, samples=2, channels=["color"], t_min=4.0, t_max=7.0, backend="cpu")
    views = [oracle.view(camera, offset, 2) for offset in ((0.25, 0.25), (0.75, 0.75))]
    colors = [oracle.cast(surfaces, rays, (4.0, 7.0)).color for rays in views]
    np.testing.assert_allclose(frame.require("color").reshape(-1, 3), np.mean(colors, axis=0), atol=1e-4)


BACKENDS = ["cpu", *ADAPTERS]


@pytest.fixture(scope="module")
def rows() -> nf.Scene:
    """Tilted squares 3 to 5 m and 9 to 12 m away, far ones behind near ones and next to them."""
    builder = SceneBuilder()
    for number in range(24):
        is_near = number % 2 == 0
        x, y = (number % 6) - 2.5, (number // 6) - 1.5
        scale = 1.0 if is_near else 2.6
        center = (0.9 * scale * x, 0.8 * scale * y, -4.0 if is_near else -10.0)
        corners = quad(center, (0.4 * scale, 0, 0.2), (0, 0.35 * scale, 0.1 * (number % 3)))
        builder.instance(builder.mesh(corners, QUAD), name=f"{'near' if is_near else 'far'} {number}")
    return builder.build()


@pytest.mark.parametrize("samples", [1, 4])
@pytest.mark.parametrize("fov", [nf.Fov.symmetric(75), nf.Orthographic(-4.0, 3.0, -2.0, 2.5)], ids=str)
@pytest.mark.parametrize("name", BACKENDS)
def test_segments_equal_scenes_cut_by_hand(
    rows: nf.Scene, name: str, fov: nf.Fov | nf.Orthographic, samples: int
) -> None:
    camera = nf.Camera((0.1, 0.05, 0.3), fov=fov, size=(120, 80))
    channels = ("color", "range", "object_id", "position", "normal")
    halves = {
        kind: rows.subset(objects=[n for n in rows.object_names if n.startswith(kind)]) for kind in ("near", "far")
    }
    with backend_of(name) as backend:
        settings: dict[str, Any] = {"channels": channels, "samples": samples, "backend": backend}
        for kind, t_min, t_max in (("near", 0.0, 7.0), ("far", 7.0, np.inf)):
            cut = nf.render(rows, camera, t_min=t_min, t_max=t_max, **settings)
            by_hand = nf.render(halves[kind], camera, **settings)
            assert 0.05 < np.isfinite(cut.require("range")).mean() < 0.95
            np.testing.assert_array_equal(cut.require("object_id"), by_hand.require("object_id"))
            # Adapters use the farthest point of a scene as the depth of parallel rays: edges may round differently.
            apart = 0.0 if backend == "cpu" else 2e-6
            for channel in ("range", "position", "normal"):
                np.testing.assert_allclose(cut.require(channel), by_hand.require(channel), rtol=apart, atol=apart)
            if samples == 1 or backend == "cpu":
                np.testing.assert_allclose(cut.require("color"), by_hand.require("color"), rtol=0, atol=apart)
            else:
                # Whole rays may use the adapter's own samples.
                check_color(cut, by_hand, codes=60, percentile=98)


@pytest.mark.parametrize("name", BACKENDS)
def test_a_segment_with_everything_changes_nothing(name: str) -> None:
    scene, camera = crowd(), view((0, 0.5, 1), (0, 0, -6), size=(160, 120))
    with backend_of(name) as backend:
        whole = nf.render(scene, camera, channels=DRAWN, backend=backend)
        part = nf.render(scene, camera, channels=DRAWN, backend=backend, t_min=1e-3, t_max=1e4)
    for channel in DRAWN:
        np.testing.assert_array_equal(part.require(channel), whole.require(channel))


@pytest.mark.parametrize("segment", SEGMENTS)
@pytest.mark.parametrize("name", ADAPTERS)
def test_adapters_cut_like_the_tracer(name: str, segment: tuple[float, float]) -> None:
    bounds = {"t_min": segment[0], "t_max": segment[1]}
    with adapter(name):
        for camera in CAMERAS:
            wide = nf.Camera(camera.position, camera.orientation, fov=camera.fov, size=(100, 100))
            agree(*both(build(room()), wide, **bounds), same=0.998)
        agree(*both(crowd(("one_7",)), view((0, 0.5, 1), (0, 0, -6), (240, 160)), **bounds), same=0.998)


@pytest.mark.parametrize("name", ADAPTERS)
def test_segment_ends_are_antialiased_like_the_tracers(name: str) -> None:
    """A ground that ends 6 m away: four samples blend it with the sky, like the tracer's."""
    scene, camera = crowd(), view((0, 0.5, 1), (0, 0, -6), size=(240, 160))
    with adapter(name):
        cpu, gpu = both(scene, camera, channels=("color",), samples=4, t_max=6.0)
        check_color(cpu, gpu)


def test_geometry_beyond_the_end_is_not_rasterised() -> None:
    scene, camera = crowd(("one_7",)), view((0, 0.5, 1), (0, 0, -6), size=(40, 30))
    with adapter("vulkan"):
        device = nf._core.GpuDevice("vulkan")
        drawn = []
        for t_max in (np.inf, 5.0):
            before = device.counters()[3]
            shot = nf.Shot(cameras=(camera,), channels=("range",), t_max=t_max)
            (job,) = device.truth(scene._core, [camera._core], shot.settings)
            job.finish()
            drawn.append(device.counters()[3] - before)
    assert 0 < drawn[1] < drawn[0]
