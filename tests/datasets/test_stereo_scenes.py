"""Tests of the scenes for hybrid stereo: identical bytes, sizes, surfaces through all depths, free views."""

from __future__ import annotations

import hashlib
from collections.abc import Callable

import numpy as np
import pytest

import nearfar as nf
from nearfar.datasets import beams, landscape, spheres

MADE: dict[str, tuple[Callable[[int], nf.Scene], int | None]] = {
    "beams": (lambda seed: beams(40, seed), 2 * 80 * 80 + 12 * 40),
    "spheres": (lambda seed: spheres(60, seed, detail=1), 2 * 80 * 80 + 80 * 60),
    "landscape": (lambda seed: landscape(20, seed, detail=0), None),
}


def digest(scene: nf.Scene) -> str:
    return hashlib.sha256(scene.triangles().tobytes()).hexdigest()


@pytest.mark.parametrize("name", MADE)
def test_a_seed_gives_the_same_bytes_and_another_one_others(name: str) -> None:
    make, triangles = MADE[name]
    scene = make(7)
    assert digest(scene) == digest(make(7)) != digest(make(8))
    assert triangles is None or scene.triangle_count == triangles
    assert len(set(scene.object_names)) == len(scene.object_names)


@pytest.mark.parametrize("name", MADE)
def test_the_viewer_stands_free_and_sees_surfaces_at_all_depths(name: str) -> None:
    scene = MADE[name][0](0)
    eye = nf.Camera((0.0, 1.7, 0.0), fov=nf.Fov.symmetric(100), size=(96, 96))
    seen = nf.render(scene, eye, channels=("range",)).require("range")
    assert seen.min() > 0.4
    depths = seen[np.isfinite(seen)]
    assert all(((depths > low) & (depths < 2.5 * low)).any() for low in (2.0, 4.0, 8.0, 16.0, 32.0))


def test_each_beam_passes_many_depths() -> None:
    scene = beams(50, seed=3)
    corners = scene.triangles()[2 * 80 * 80 :].reshape(50, -1, 3)
    depths = -corners[..., 2]
    assert (depths.max(axis=1) - depths.min(axis=1) > 5.0).all()
    assert ((depths.min(axis=1) < 8.0) & (depths.max(axis=1) > 8.0)).sum() > 10
