"""Tests of hybrid stereo on graphics adapters: against the tracer, and what culling leaves out."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar import _core
from tests.support.gpu_cases import ADAPTERS, adapter, check_color, check_ids, crowd, view

HEAD = (0.0, 1.5, 2.0)
CHANNELS = ("color", "range", "object_id", "face_id", "coverage")


def rig(size: tuple[int, int] = (120, 100)) -> nf.stereo.HybridRig:
    return nf.stereo.HybridRig.of(nf.hmd.QUEST_2, mono_plane=4.0, size=size)


@pytest.mark.parametrize("name", ADAPTERS)
@pytest.mark.parametrize("samples", [1, 4])
def test_adapters_draw_what_the_tracer_does(name: str, samples: int) -> None:
    scene = crowd(("one_7",))
    expected = rig().render(scene, HEAD, channels=CHANNELS, samples=samples, backend="cpu")
    with adapter(name):
        found = rig().render(scene, HEAD, channels=CHANNELS, samples=samples, backend="gpu")
    for side in ("left", "right"):
        reference, test = getattr(expected, side), getattr(found, side)
        check_ids(reference.require("face_id"), test.require("face_id"), share=0.99)
        # The adapter's own samples lie elsewhere in a pixel, which shows along edges.
        check_color(reference, test, percentile=98.0 if samples == 1 else 90.0, codes=3)
        apart = np.abs(reference.require("coverage") - test.require("coverage"))
        assert (apart > 0.3).mean() < 0.01


@pytest.mark.parametrize("name", ADAPTERS)
@pytest.mark.parametrize("samples", [1, 2, 4])
def test_culling_changes_no_pixel_of_the_eyes(name: str, samples: int) -> None:
    scene = crowd(("one_7",))
    with adapter(name):
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


@pytest.mark.parametrize("name", ADAPTERS)
def test_geometry_behind_hidden_pixels_is_not_drawn(name: str) -> None:
    scene, camera = crowd(), view((0, 0.5, 1), (0, 0, -6), size=(64, 48))
    hidden = np.zeros((48, 64), bool)
    hidden[:, 60:] = True
    drawn: dict[tuple[bool, bool], int] = {}
    with adapter(name):
        device = _core.GpuDevice(name)
        for masked, occlusion in ((False, True), (True, False), (True, True)):
            shot = nf.Shot(
                cameras=(camera,),
                channels=("face_id",),
                mask=hidden if masked else None,
                occlusion=occlusion,
            )
            before = device.counters()[3]
            faces = device.truth(scene._core, camera._core, shot.settings).finish()["face_id"]
            drawn[masked, occlusion] = device.counters()[3] - before
            if not masked:
                whole = faces
            else:
                np.testing.assert_array_equal(faces[hidden], whole[hidden])
                assert (faces[~hidden] == -1).all()
    assert drawn[True, True] < drawn[True, False] == drawn[False, True]


@pytest.mark.parametrize("name", ADAPTERS)
@pytest.mark.parametrize("samples", [1, 4])
def test_pictures_of_adapters_are_resolved_as_those_of_the_tracer(name: str, samples: int) -> None:
    scene = crowd(("one_7",))
    settings: dict[str, Any] = {"samples": samples, "assembly": "resolved"}
    expected = rig().render(scene, HEAD, backend="cpu", **settings)
    with adapter(name):
        found = [rig().render(scene, HEAD, backend="gpu", cull=cull, **settings) for cull in ("frustum", "occlusion")]
    for side in ("left", "right"):
        check_color(
            getattr(expected, side), getattr(found[1], side), percentile=98.0 if samples == 1 else 90.0, codes=3
        )
        np.testing.assert_array_equal(*(getattr(frame, side).require("color") for frame in found))
