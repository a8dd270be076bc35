"""Scores of levels by material: objects, their levels, and masked SSIM over views, sizes and materials."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness import scenes
from benchmarks.lod._material import FINER, NEUTRAL, Material, Shape, look, shade
from benchmarks.lod._objects import spot_mesh
from nearfar._base import data

Array = NDArray[np.float64]

# Metallic and roughness as in glTF; frequencies of patterns in cycles across the object.
METALLIC, ROUGHNESS = (0.0, 0.5, 1.0), (0.25, 0.5, 0.75, 1.0)
FREQUENCY, CONTRAST = (2.0, 4.0, 8.0, 16.0), (0.5, 1.0)
MIXED = (Material(1.0, 0.5, 8.0, 0.5, True), Material(0.5, 0.5, 4.0, 1.0, True), Material(0.0, 0.5, 16.0, 0.5))
"""Metallic or glossy materials with patterns: predicted, not fitted."""


def patterns(frequencies: Sequence[float], *, mapped: bool) -> tuple[Material, ...]:
    """Dull materials with patterns of all contrasts."""
    pairs = itertools.product(frequencies, CONTRAST)
    return tuple(Material(frequency=frequency, contrast=contrast, mapped=mapped) for frequency, contrast in pairs)


HEADSET = nf.hmd.RIFT_S
_AXES = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (3**-0.5,) * 3)
_MARGIN = 6
"""Margin in pixels around the object, so that SSIM's windows at its silhouette lie within the picture."""


@dataclass(frozen=True)
class Plan:
    """Levels, sizes, views and materials to score."""

    ratios: tuple[float, ...] = (0.2, 0.05, 0.0125)
    sizes: tuple[float, ...] = (1.0, 1 / 8, 1 / 64)
    """Solid angles, relative to that of a sphere that fills 1/16 of the screen."""
    steps: int = 6
    """Number of views in a full turn about each of four axes."""
    materials: tuple[Material, ...] = (
        *(Material(metallic, roughness) for metallic in METALLIC for roughness in ROUGHNESS),
        *patterns(FREQUENCY, mapped=False),
        *patterns(FREQUENCY, mapped=True),
        *MIXED,
    )


QUICK = Plan(
    ratios=(0.2, 0.05),
    sizes=(1 / 16, 1 / 64),
    steps=2,
    materials=(
        NEUTRAL,
        *(Material(metallic, roughness) for metallic in METALLIC for roughness in ROUGHNESS[:2]),
        Material(1.0),
        *patterns(FREQUENCY[::2], mapped=False),
        *patterns(FREQUENCY[::2], mapped=True),
        MIXED[0],
    ),
)
"""Plan for procedural objects that takes much less than a minute."""


# objects --------------------------------------------------------------------------------------------------------------
def unit(vertices: NDArray[Any], faces: NDArray[Any]) -> Shape:
    """Scale a mesh to a bounding sphere of radius 1 about the origin."""
    center, radius = nf.bounding_sphere(np.asarray(vertices, np.float64))
    return Shape(((vertices - center) / radius).astype(np.float32), np.asarray(faces, np.int64))


def rock(detail: int = 5) -> Shape:
    """Make a ball with bumps of several sizes."""
    import trimesh

    ball = trimesh.creation.icosphere(subdivisions=detail)
    points, bumps = np.asarray(ball.vertices), np.zeros(len(ball.vertices))
    for n in range(1, 5):
        turn = np.linalg.qr(np.sin(np.arange(9.0).reshape(3, 3) * (n + 0.7)))[0]
        bumps += np.sin(2**n * (points @ turn)).prod(axis=1) / 2**n
    return unit(points * (1 + 0.35 * bumps)[:, None], ball.faces)


def knot(around: int = 240, across: int = 40) -> Shape:
    """Make a torus knot: a tube that occludes itself."""
    t = 2 * np.pi * np.arange(around) / around
    ring = 2 + np.cos(3 * t)
    path = np.stack([ring * np.cos(2 * t), ring * np.sin(2 * t), np.sin(3 * t)], axis=1)
    ahead = np.roll(path, -1, axis=0) - np.roll(path, 1, axis=0)
    side = np.cross(ahead, path)
    up = np.cross(side, ahead)
    turn = 2 * np.pi * np.arange(across) / across
    directions = [vectors / np.linalg.norm(vectors, axis=1, keepdims=True) for vectors in (side, up)]
    tube = sum(
        0.45 * wave[None, :, None] * vectors[:, None]
        for wave, vectors in zip((np.cos(turn), np.sin(turn)), directions, strict=True)
    )
    # Two faces for each cell of a grid that is closed in both directions.
    i, j = (axis.ravel() for axis in np.mgrid[:around, :across])
    corners = [(i + di) % around * across + (j + dj) % across for di, dj in ((0, 0), (1, 0), (1, 1), (0, 1))]
    faces = np.concatenate([np.stack([corners[n] for n in face], axis=1) for face in ((0, 1, 2), (0, 2, 3))])
    return unit((path[:, None] + np.asarray(tube)).reshape(-1, 3), faces)


def fluted(detail: int = 5) -> Shape:
    """Make an egg with flutes like a column's: creases as on artificial objects."""
    import trimesh

    ball = trimesh.creation.icosphere(subdivisions=detail)
    x, y, z = np.asarray(ball.vertices).T
    flutes = 1 - 0.15 * np.abs(np.sin(6 * np.arctan2(z, x)))
    return unit(np.stack([flutes * x, 1.3 * y, flutes * z], axis=1), ball.faces)


PROCEDURAL: dict[str, Callable[[], Shape]] = {"rock": rock, "knot": knot, "fluted": fluted}

SCANNED = {
    "bunny": scenes.FILES["bunny"],
    "dragon": "objects/dragon/dragon_vrip_res3.ply.gz",
    "armadillo": scenes.FILES["armadillo"],
    "spot": "objects/spot/spot.zip",
    "duck": scenes.FILES["Duck"],
    "helmet": scenes.FILES["FlightHelmet"],
}


def scanned(name: str) -> Shape | None:
    """Load an object of the data folder without materials, vertices merged by position; None if it is missing."""
    path = data.find(SCANNED[name])
    if path is None:
        return None
    vertices, faces = weld(nf.Scene.from_trimesh(spot_mesh(path)) if path.suffix == ".zip" else nf.Scene.load(path))
    is_degenerate = (faces == np.roll(faces, 1, axis=1)).any(axis=1)
    return unit(vertices, faces[~is_degenerate])


def weld(scene: nf.Scene) -> tuple[NDArray[np.float32], NDArray[np.int64]]:
    """Vertices of a scene merged by position, and its faces."""
    vertices, faces = np.unique(scene.triangles().reshape(-1, 3), axis=0, return_inverse=True)
    return vertices, faces.reshape(-1, 3)


def simplify_shape(shape: Shape, ratios: Sequence[float]) -> list[Shape]:
    """Return the base and a level for each ratio of its triangles, by positions only."""
    scene = nf.Scene.from_arrays(shape.vertices, shape.faces)
    levels = nf.lod.simplify(scene, ratios)
    if len(levels) <= len(ratios):
        # Only this simplifier drops small parts, so only it reaches few triangles on objects that have many.
        levels = nf.lod.simplify(scene, ratios, method="meshopt")
    if len(levels) <= len(ratios):
        raise ValueError(f"ratios: expected some that can be reached, got {ratios}: {levels}")
    return [shape, *(Shape(*weld(level.scene)) for level in levels[1:])]


# scores ---------------------------------------------------------------------------------------------------------------
def cameras(size: float, steps: int) -> Iterator[nf.Camera]:
    """Views of the unit sphere at a solid angle (relative to that at 1/16 of the screen), cropped to the sphere."""
    sine = np.sqrt(1 - (1 - size * nf.lod.reference_solid_angle(HEADSET) / (2 * np.pi)) ** 2)
    fov = HEADSET.left.fov
    focal = HEADSET.render_size[0] / (fov.right - fov.left)
    side = 2 * int(np.ceil(focal * sine / np.sqrt(1 - sine**2)) + _MARGIN)
    window = nf.Fov.symmetric(float(np.degrees(2 * np.arctan(side / 2 / focal))))
    for axis, step in itertools.product(np.array(_AXES), range(steps)):
        start = np.cross(axis, np.roll(axis, 1) + np.array([0.0, 0.0, 0.3]))
        start /= np.linalg.norm(start)
        turn = 2 * np.pi * step / steps
        eye = (np.cos(turn) * start + np.sin(turn) * np.cross(axis, start)) / sine
        yield nf.Camera.look_at(eye, (0, 0, 0), fov=window, size=(FINER * side, FINER * side), up=axis)


def scores(shape: Shape, plan: Plan) -> Array:
    """SSIM of each level at each size in each material (L, S, M): the 25th percentile over views."""
    levels = simplify_shape(shape, plan.ratios)
    percentiles = np.empty((len(levels) - 1, len(plan.sizes), len(plan.materials)))
    for number, size in enumerate(plan.sizes):
        views = np.stack([_view(levels, camera, plan.materials) for camera in cameras(size, plan.steps)])
        percentiles[:, number] = np.percentile(views, 25, axis=0, method="averaged_inverted_cdf")
    return percentiles


def _view(levels: list[Shape], camera: nf.Camera, materials: Sequence[Material]) -> Array:
    """SSIM of each level in each material from one camera (L, M), over the union of both silhouettes."""
    base, *coarser = (look(level, camera) for level in levels)
    truth = shade(base, materials)
    similarity = np.empty((len(coarser), len(materials)))
    for row, surface in zip(similarity, coarser, strict=True):
        mask = base.silhouette | surface.silhouette
        row[:] = nf.metrics.ssim_pairs(truth, shade(surface, materials), data_range=255, masks=mask)
    return similarity
