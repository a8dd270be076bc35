"""FLIP, which another project computes: conversions, ranges and errors are ours."""

from __future__ import annotations

import sys
from typing import Any

import numpy as np
import pytest

import nearfar as nf

flip_evaluator = pytest.importorskip("flip_evaluator", reason="flip-evaluator is not installed")


def pictures() -> tuple[Any, Any]:
    random = np.random.default_rng(0)
    one = random.integers(40, 200, (48, 64, 3), np.uint8)
    return one, np.clip(one + random.normal(0, 12, one.shape), 0, 255).astype(np.uint8)


@pytest.mark.parametrize("density", [67.0, 20.0])
def test_flip_equals_the_evaluator(density: float) -> None:
    one, other = pictures()
    unit = [np.asarray(picture / 255, np.float32) for picture in (one, other)]
    errors, expected, _ = flip_evaluator.evaluate(*unit, "LDR", applyMagma=False, parameters={"ppd": density})
    mean, found = nf.metrics.flip(one, other, data_range=255, pixels_per_degree=density, full=True)
    assert mean == pytest.approx(expected, rel=1e-6)
    assert found.shape == (48, 64)
    np.testing.assert_allclose(found, errors[..., 0], atol=1e-6)
    assert mean == pytest.approx(found.mean(), rel=1e-4)
    assert nf.metrics.flip(unit[0], unit[1], data_range=1, pixels_per_degree=density) == pytest.approx(mean, rel=1e-6)
    assert float(nf.metrics.flip(one, one, data_range=255)) == 0.0


def test_grey_pictures_and_frames_are_compared_as_colours(monkeypatch: pytest.MonkeyPatch) -> None:
    one, other = (picture[..., 0] for picture in pictures())
    grey = nf.metrics.flip(one, other, data_range=255)
    colors = [np.repeat(picture[..., None], 3, axis=2) for picture in (one, other)]
    assert grey == nf.metrics.flip(*colors, data_range=255) > 0
    scene = nf.datasets.city(blocks=2, detail=0)
    frames = [
        nf.render(scene, nf.Camera((x, 1.7, 0), fov=nf.Fov.symmetric(80), size=(40, 30)), channels=("color",))
        for x in (0.0, 0.2)
    ]
    with_positions = nf.render(scene, frames[1].camera, channels=("color", "position"))
    comparison = nf.compare(frames[0], with_positions, center=(0, 1.7, 0), radius=20)
    assert comparison.flip == pytest.approx(nf.metrics.flip(frames[0], with_positions))
    with monkeypatch.context() as patch:
        patch.setitem(sys.modules, "flip_evaluator", None)
        assert nf.compare(frames[0], with_positions, center=(0, 1.7, 0), radius=20).flip is None
    codes = [frame.to_image()[..., :3] for frame in frames]
    # Eight bits round each value by half a code.
    assert nf.metrics.flip(*frames) == pytest.approx(nf.metrics.flip(*codes, data_range=255), abs=2e-3)
