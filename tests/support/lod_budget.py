"""Scenes whose levels are selected under a budget."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from tests.support.lod_oracle import model, random_spheres, rotation, usual

Array = NDArray[np.float64]

FOV = nf.Fov(-1.0, 0.9, -1.1, 1.05)
VIEW = nf.Camera.look_at((0.5, 1.5, -2.0), (4.0, 0.5, -9.0), fov=FOV, size=(1440, 1600))


def small_models(random: np.random.Generator) -> list[nf.lod.LodModel]:
    """Models of few triangles, so that all sums can be tried; curves may cross and some are missing."""
    found = []
    for seed in range(4):
        one = usual(int(random.integers(0, 5)), seed)
        triangles = np.sort(random.integers(1, 60, len(one)))[::-1]
        found.append(replace(one, triangles=triangles))
    nothing = (np.nan,) * 4
    return [*found, replace(model([(1, 1, 0.1, 0.5), nothing, (1, 1, 0.01, 0.2)]), triangles=np.array([40, 20, 20, 5]))]


def ahead(count: int, seed: int) -> tuple[Array, Array]:
    """Spheres in view that do not contain the eye."""
    random = np.random.default_rng(seed)
    away = np.exp(random.uniform(0, 3, count))
    own = np.stack([random.uniform(-0.7, 0.7, count) * away, random.uniform(-0.7, 0.7, count) * away, -away], axis=1)
    return own @ rotation(VIEW).T + VIEW.position, away * np.exp(random.uniform(-5, -1.5, count))


def crowd(count: int, seed: int = 0) -> tuple[list[nf.lod.LodModel], Any, Array, Array]:
    models = [usual(7, number) for number in range(6)]
    centers, radii = random_spheres(count, seed, VIEW)
    return models, np.random.default_rng(seed).integers(0, 6, count), centers, radii
