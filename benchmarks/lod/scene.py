"""Cost and saving of levels of detail in a frame of a thousand objects: selection, scene, tree, picture."""

from __future__ import annotations

import functools

import numpy as np
import trimesh
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.compare import OURS, Case, compare
from benchmarks.harness.report import start

OBJECTS, RADIUS = 1_000, 20.0
"""Number of objects, and the radius of the ball that contains them, metres."""
FINEST, COARSEST = 6, 1
"""Subdivisions of the models' spheres: 81,920 to 80 triangles."""


def model(seed: int) -> nf.lod.LodModel:
    """Make a bumpy ball of six levels; curves of coarser levels begin to fall at smaller solid angles."""
    random = np.random.default_rng(seed)
    axes = random.normal(size=(6, 3))
    levels = []
    for subdivisions in range(FINEST, COARSEST - 1, -1):
        ball = trimesh.creation.icosphere(subdivisions)
        bumps = 1 + 0.04 * np.sin(6 * ball.vertices @ axes.T).sum(axis=1, keepdims=True)
        scene = nf.Scene.from_arrays((0.3 * ball.vertices * bumps).astype(np.float32), ball.faces.astype(np.uint32))
        levels.append(nf.lod.Level(scene=scene))
    all_levels = nf.lod.Levels(levels, name=f"model_{seed}")
    ones = np.ones(len(all_levels) - 1)
    middles = 0.5 / 4.0 ** np.arange(len(ones))
    return nf.lod.LodModel(
        triangles=np.array([level.triangle_count for level in all_levels]),
        curves=nf.lod.Curve4PL(ones, 1.2 * ones, middles, 0.6 * ones),
        center=all_levels.center,
        radius=all_levels.radius,
        sigma=(1e-6, 1.0),
        levels=all_levels,
    )


def places(random: np.random.Generator) -> NDArray[np.float64]:
    matrices = np.tile(np.eye(4), (OBJECTS, 1, 1))
    for matrix in matrices:
        matrix[:] = trimesh.transformations.random_rotation_matrix(random.random(3))
        direction = random.normal(size=3)
        matrix[:3, 3] = direction / np.linalg.norm(direction) * RADIUS * random.random() ** (1 / 3)
    return matrices


def main() -> None:
    start(__doc__)
    random = np.random.default_rng(0)
    models = [model(seed) for seed in range(8)]
    scene = nf.lod.place(models, random.integers(0, len(models), OBJECTS), places(random))
    camera = nf.Camera((0, 0, 0), fov=nf.Fov.symmetric(87, 87 / 90), size=(640, 660))
    objects = scene.leveled
    if objects is None:
        raise RuntimeError("expected objects with levels")
    choose = functools.partial(
        nf.lod.select, objects.models, objects.model_index, objects.centers, objects.radii, camera=camera, mode="depth"
    )
    picture = functools.partial(nf.render, scene, camera, backend="cpu")
    levels = choose().level
    drawn = scene.at_levels(levels)
    drawn._core.build()
    print(f"{drawn.triangle_count:,} of {scene.triangle_count:,} triangles, {int((levels >= 0).sum())} objects in view")
    cases = [
        Case(f"{OURS}: choose levels", choose),
        Case(f"{OURS}: scene of the levels", lambda: scene.at_levels(levels)),
        Case(f"{OURS}: scene and its tree", lambda: scene.at_levels(levels)._core.build()),
        Case(f"{OURS}: picture of levels", functools.partial(picture, lod=choose_by_depth)),
        Case("picture of level 0", picture),
        Case("scene and tree built anew", lambda: rebuild(scene, levels)),
    ]
    print(compare(f"A frame of {OBJECTS:,} objects", cases, repeat=4))


choose_by_depth = functools.partial(nf.lod.select, mode="depth")


def rebuild(scene: nf.Scene, levels: NDArray[np.int32]) -> nf.Scene:
    """Build a frame without shared levels: the chosen triangles as one new scene with its own search tree."""
    corners = scene.at_levels(levels).triangles().reshape(-1, 3)
    merged = nf.Scene.from_arrays(corners, np.arange(len(corners), dtype=np.uint32).reshape(-1, 3))
    merged._core.build()
    return merged


if __name__ == "__main__":
    main()
