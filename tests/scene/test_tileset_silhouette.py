"""A tileset of Manhattan cut by triangle budgets, compared with the full one: pictures, and the area of the sky."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from tests.support import data, need
from tests.support.tile_cases import b3dm, box, glb, tile, tileset, write

pytestmark = pytest.mark.slow

SHARES = (0.3, 0.55, 1.0)
"""Triangles of each level's tiles, as shares of the full geometry."""

ERRORS = (40.0, 15.0, 0.0)


def simplified(corners: NDArray[np.float64], share: float) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """A mesh of triangles (T, 3, 3) with a share of them."""
    import fast_simplification

    vertices, faces = np.unique(corners.reshape(-1, 3), axis=0, return_inverse=True)
    faces = faces.reshape(-1, 3)
    if share < 1:
        vertices, faces = fast_simplification.simplify(vertices.astype(np.float32), faces, 1 - share)
    return np.asarray(vertices), np.asarray(faces)


def manhattan(folder: Path) -> Path:
    """A quadtree of three levels of replacing tiles; the last one has all triangles."""
    scene = nf.Scene.load(data("city/manhattan_deckgl/manhattan_core.glb"))
    triangles = scene.triangles().astype(np.float64) + scene.origin
    places = triangles.mean(axis=1)[:, [0, 2]]
    cells = np.minimum((places - places.min(axis=0)) / np.ptp(places, axis=0) * 4, 3).astype(int)
    files: dict[str, bytes] = {}

    def in_tile(level: int, x: int, z: int) -> NDArray[np.bool_]:
        width = 4 >> level
        low, high = np.array([x, z]) * width, np.array([x + 1, z + 1]) * width
        return np.asarray(((cells >= low) & (cells < high)).all(axis=1))

    def branch(level: int, x: int, z: int) -> dict[str, object]:
        inside = triangles[in_tile(level, x, z)]
        name = f"{level}_{x}_{z}.b3dm"
        files[name] = b3dm(glb(*simplified(inside, SHARES[level])))
        # Tiles are z up.
        turned = inside.reshape(-1, 3)[:, [0, 2, 1]] * (1, -1, 1)
        volume = box(turned.min(axis=0), turned.max(axis=0))
        children = [(level + 1, 2 * x + a, 2 * z + b) for a in (0, 1) for b in (0, 1)] if level < 2 else []
        below = [branch(*cell) for cell in children if in_tile(*cell).any()]
        return tile(ERRORS[level], name, volume, refine="REPLACE", children=below)

    return write(folder, {"tileset.json": tileset(branch(0, 0, 0)), **files})


VIEWS = [((-900.0, 700.0, 1200.0), (600.0, 100.0, -300.0)), ((700.0, 60.0, 900.0), (900.0, 120.0, -600.0))]
"""Eyes and targets: above the harbour, and between the houses."""


def test_a_cut_keeps_its_silhouette(tmp_path: Path) -> None:
    need("fast_simplification")
    path = manhattan(tmp_path)
    whole = nf.Scene.load(path)
    assert whole.triangle_count == nf.Scene.load(data("city/manhattan_deckgl/manhattan_core.glb")).triangle_count
    found = []
    for share in (0.8, 0.6, 0.41):
        most = int(share * whole.triangle_count)
        cut = nf.Scene.load(path, triangles=most)
        assert 0.8 * most < cut.triangle_count <= most
        for eye, target in VIEWS:
            view = nf.Camera.look_at(eye, target, fov=nf.Fov.symmetric(70, 16 / 10), size=(640, 400))
            truth, seen = (nf.render(scene, view, samples=4, channels=("color", "range")) for scene in (whole, cut))
            sky = [np.isinf(np.asarray(frame.range)) for frame in (truth, seen)]
            found.append((share, cut.triangle_count, float(nf.ssim(truth, seen)), np.mean(sky[0] != sky[1])))
    # Parents with few triangles are rough: the last cut is the first tile alone.
    bounds = {0.8: (0.87, 0.04), 0.6: (0.86, 0.045), 0.41: (0.79, 0.14)}
    for share, _, similarity, wrong in found:
        assert similarity > bounds[share][0], found
        assert wrong < bounds[share][1], found
