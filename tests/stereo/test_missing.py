"""Tests that no pixel is missing: where separate stereo shows surfaces all around, hybrid pictures show one."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar.stereo._passes import narrow_gaps
from tests.support import data

SCENES: dict[str, Callable[[], nf.Scene]] = {
    "beams": nf.datasets.beams,
    "spheres": lambda: nf.datasets.spheres(detail=1),
    "landscape": lambda: nf.datasets.landscape(detail=1),
    "tokyo": lambda: nf.Scene.load(data("city/tokyo23/tokyo_core_lod1.glb")),
    "garage": lambda: nf.Scene.load(data("interior/garage/garage.gltf")),
}


def surrounded(coverage: NDArray[np.float32], reach: int) -> NDArray[np.bool_]:
    """Pixels with surfaces in all pixels up to a distance across and down; none lie beyond the picture."""
    padded = np.pad(coverage == 0.0, reach, constant_values=True)
    sums = np.pad(padded.astype(np.int64).cumsum(axis=0).cumsum(axis=1), ((1, 0), (1, 0)))
    side = 2 * reach + 1
    missed = sums[side:, side:] - sums[:-side, side:] - sums[side:, :-side] + sums[:-side, :-side]
    return np.asarray(missed == 0)


def check(name: str, views: int) -> None:
    scene, dice = SCENES[name](), np.random.default_rng(11)
    low, high = scene.bounds
    size = (324, 360)
    checked = 0
    for _ in range(views):
        head = np.array((0.0, 1.7, 0.0)) if name in ("beams", "spheres", "landscape") else dice.uniform(low, high)
        ahead = dice.normal(size=3) * (1.0, 0.4, 1.0)
        way = nf.Camera.look_at(head, head + ahead, fov=nf.Fov.symmetric(90), size=(1, 1)).orientation
        hmd = nf.hmd.get(str(dice.choice(nf.hmd.names())))
        rig = nf.stereo.HybridRig.of(hmd, mono_plane=float(2.0 ** dice.uniform(0.0, 5.0)), size=size)
        frame = rig.render(scene, head, way, channels=("coverage",), near=1e-6)
        reach = math.ceil(rig.max_error(axis="both")) + 1
        for side, camera in zip(("left", "right"), rig.cameras(head, way), strict=False):
            # Nearer surfaces may hide the edge of a far one, which the shared picture shows displaced.
            behind = rig.clip(head, way, near=0.6 * rig.planes[0])
            whole = nf.render(scene, camera, channels=("coverage",), clip=behind).require("coverage")
            inner = surrounded(whole, reach)
            missing = inner & (getattr(frame, side).require("coverage") == 0.0)
            checked += int(inner.sum())
            assert not missing.any(), (head, ahead, hmd.name, rig.mono_plane)
    assert checked > 5000 * views


def test_outlines_have_no_holes() -> None:
    """Gaps of one and two pixels are found, and none along straight outlines of any direction."""
    rows, columns = np.mgrid[:60, :80] + 0.5
    for turn in np.linspace(0.0, 2.0 * np.pi, 97):
        beside = np.cos(turn) * (columns - 40.0) + np.sin(turn) * (rows - 30.0)
        half = beside < 0.3
        # Pixels beyond the picture count as covered, so its own edge is excluded.
        assert not narrow_gaps(half)[2:-2, 2:-2].any()
    for width, found in ((1, True), (2, True), (3, False)):
        crack = np.ones((12, 12), bool)
        crack[4 : 4 + width, 2:10] = False
        for gap in (crack, crack.T):
            assert (narrow_gaps(gap) == (~gap if found else False)).all()


@pytest.mark.parametrize("name", ["beams", "spheres", "landscape"])
def test_no_pixel_is_missing(name: str) -> None:
    check(name, 4)


@pytest.mark.stress
@pytest.mark.parametrize("name", SCENES)
def test_no_pixel_is_missing_in_a_hundred_views(name: str) -> None:
    check(name, 100)
