"""Tests of hybrid stereo on graphics adapters: against the tracer, and how much culling omits."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar import _core
from nearfar._scene.builder import SceneBuilder
from tests.support.gpu_cases import RENDERED, adapter, check_color, check_ids, crowd, view

HEAD = (0.0, 1.5, 2.0)
AHEAD = (0.0, 0.0, 0.0, 1.0)
CHANNELS = ("color", "range", "object_id", "face_id", "coverage")


def instance_count(scene: nf.Scene) -> int:
    return len(rig()._core.contents(scene._core, (HEAD, AHEAD, (0.1, 100.0)), False)[0])


def rig(size: tuple[int, int] = (120, 100)) -> nf.stereo.HybridRig:
    return nf.stereo.HybridRig.of(nf.hmd.QUEST_2, mono_plane=4.0, size=size)


@pytest.mark.parametrize("samples", [1, 4])
def test_adapters_agree_with_the_tracer(backend: str, samples: int) -> None:
    scene = crowd(("one_7",))
    expected = rig().render(scene, HEAD, channels=CHANNELS, samples=samples, backend="cpu")
    found = rig().render(scene, HEAD, channels=CHANNELS, samples=samples, backend="gpu")
    for side in ("left", "right"):
        reference, test = getattr(expected, side), getattr(found, side)
        check_ids(reference.require("face_id"), test.require("face_id"), share=0.99)
        # The adapter's own samples lie elsewhere in a pixel, which shows along edges.
        check_color(reference, test, percentile=98.0 if samples == 1 else 90.0, codes=3)
        apart = np.abs(reference.require("coverage") - test.require("coverage"))
        assert (apart > 0.3).mean() < 0.01


@pytest.mark.parametrize("samples", [1, 4])
def test_culling_changes_no_pixel_of_the_eyes(backend: str, samples: int) -> None:
    scene = crowd(("one_7",))
    frames = [
        rig().render(scene, HEAD, channels=CHANNELS, samples=samples, backend="gpu", cull=cull)
        for cull in ("frustum", "discard", "occlusion")
    ]
    for other in frames[1:]:
        for side in ("left", "right"):
            for channel in CHANNELS:
                np.testing.assert_array_equal(
                    getattr(frames[0], side).require(channel), getattr(other, side).require(channel)
                )
        assert other.stats["pixels"]["discarded"] > 0
        assert other.center is not None
        # Nothing was drawn where no eye looks.
        hidden = other.center.require("face_id") < 0
        assert (other.center.require("color") == 0.0).all(axis=-1).sum() >= other.stats["pixels"]["discarded"]
        assert hidden.sum() >= other.stats["pixels"]["discarded"]


def test_geometry_behind_hidden_pixels_is_not_drawn(backend: str) -> None:
    scene, camera = crowd(), view((0, 0.5, 1), (0, 0, -6), size=(64, 48))
    hidden = np.zeros((48, 64), bool)
    hidden[:, 60:] = True
    drawn: dict[tuple[bool, bool], int] = {}
    device = _core.GpuDevice(backend)
    for masked, occlusion in ((False, True), (True, False), (True, True)):
        shot = nf.Shot(
            cameras=(camera,),
            channels=("face_id",),
            mask=hidden if masked else None,
            occlusion=occlusion,
        )
        before = device.counters()[3]
        (job,) = device.truth(scene._core, [camera._core], shot.settings)
        faces = job.finish()["face_id"]
        drawn[masked, occlusion] = device.counters()[3] - before
        if not masked:
            whole = faces
        else:
            np.testing.assert_array_equal(faces[hidden], whole[hidden])
            assert (faces[~hidden] == -1).all()
    assert drawn[True, True] < drawn[True, False] == drawn[False, True]


@pytest.mark.parametrize("samples", [1, 4])
def test_adapter_samples_are_resolved_like_the_tracers(backend: str, samples: int) -> None:
    scene = crowd(("one_7",))
    settings: dict[str, Any] = {"samples": samples, "assembly": "resolved"}
    expected = rig().render(scene, HEAD, backend="cpu", **settings)
    found = [rig().render(scene, HEAD, backend="gpu", cull=cull, **settings) for cull in ("frustum", "occlusion")]
    for side in ("left", "right"):
        check_color(
            getattr(expected, side), getattr(found[1], side), percentile=98.0 if samples == 1 else 90.0, codes=3
        )
        np.testing.assert_array_equal(*(getattr(frame, side).require("color") for frame in found))


def test_instances_known_to_be_invisible_are_not_drawn(backend: str) -> None:
    scene, camera = crowd(("one_7", "one_11")), view((0, 0.5, 1), (0, 0, -6), size=(64, 48))
    device = _core.GpuDevice(backend)

    def draw_instances(instances: NDArray[np.bool_] | None) -> tuple[NDArray[np.int64], int]:
        shot = nf.Shot(cameras=(camera,), channels=("face_id",), instances=instances)
        before = device.counters()[3]
        (job,) = device.truth(scene._core, [camera._core], shot.settings)
        return job.finish()["face_id"], device.counters()[3] - before

    whole, triangles = draw_instances(None)
    faces, fewer = draw_instances(np.zeros(instance_count(scene), bool))
    assert (faces == -1).all()
    assert fewer == 0
    same, as_many = draw_instances(np.ones(instance_count(scene), bool))
    np.testing.assert_array_equal(same, whole)
    assert as_many >= triangles
    with pytest.raises(ValueError, match="instances: expected"):
        draw_instances(np.ones(instance_count(scene) + 1, bool))


@contextmanager
def two_views(device: _core.GpuDevice) -> Iterator[None]:
    """Let one pass draw both eyes, even on software adapters, for triangles that cross no edge of a picture."""
    before = device.allow_two_views(True)
    try:
        yield
    finally:
        device.allow_two_views(before)


def cluster() -> nf.Scene:
    """Return bent quads in front of both eyes, none of which crosses an edge of their pictures; one can move."""
    dice = np.random.default_rng(5)
    builder = SceneBuilder()
    for number, color in enumerate([(1.0, 0.8, 0.6, 1.0), (0.3, 0.5, 0.9, 1.0), (0.6, 0.9, 0.4, 1.0)]):
        corners = dice.normal(size=(40, 3)) * (1.5, 1.0, 1.0) + (0.0, 1.5, -4.0 - number)
        faces = dice.permutation(40)[:39].reshape(13, 3)
        builder.instance(builder.mesh(corners, faces, material=builder.material(color)), name=f"part_{number}")
    return builder.build(["part_2"])


@pytest.mark.parametrize("samples", [1, 2, 4])
def test_two_views_in_one_pass_equal_two_pictures(samples: int) -> None:
    """An adapter that draws both eyes in one pass receives each triangle once."""
    scene, pair = cluster(), rig().cameras(HEAD)[:2]
    settings: dict[str, Any] = {"channels": RENDERED, "samples": samples}
    with adapter("vulkan"):
        device = _core.GpuDevice("vulkan")
        before = device.counters()[3]
        with two_views(device):
            jobs = scene.begin(device, nf.Shot(cameras=pair, **settings))
        # The second one first: the frames are computed asynchronously.
        both = [job.finish() for job in reversed(jobs)][::-1]
        at_once = device.counters()[3] - before
        alone = [nf.render(scene, camera, backend="gpu", **settings) for camera in pair]
        separate = device.counters()[3] - before - at_once
        with pytest.raises(ValueError, match="frame: expected a frame that was not read yet"):
            jobs[0].finish()
    assert (alone[0].require("face_id") != alone[1].require("face_id")).any()
    for images, frame in zip(both, alone, strict=True):
        assert (images["face_id"] >= 0).mean() > 0.02
        check_ids(frame.require("face_id"), images["face_id"], share=0.999)
        same = frame.require("face_id") == images["face_id"]
        for channel in RENDERED:
            close = np.isclose(images[channel], frame.require(channel), rtol=1e-5, atol=1e-5, equal_nan=True)
            # Samples away from the pixel's centre may see another face.
            assert close[same].mean() > (0.9999 if samples == 1 else 0.99)
    # Hardware multisampling takes a pass for each eye.
    assert at_once == (separate if samples == 4 else separate / 2)


def test_software_adapters_draw_each_eye_separately() -> None:
    """Lavapipe draws triangles that cross an edge of the picture into the first view only."""
    with adapter("vulkan"):
        assert not _core.GpuDevice("vulkan").allow_two_views(False)
