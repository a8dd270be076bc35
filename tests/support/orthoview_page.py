"""Vectors with which Node compares the page's reading of trees with Python's."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

import nearfar as nf
from nearfar.orthoview._grid import Place
from tests.support.web_cases import run

ViewKey = tuple[int, Place, int]


def cameras(tree: nf.orthoview.OrthoTree, count: int, seed: int) -> list[nf.Camera]:
    """Perspective cameras in and around a tree, with fields of view of all kinds."""
    rng = np.random.default_rng(seed)
    low, high = tree.bounds
    side = (high - low).max()
    found = []
    for _ in range(count):
        eye = low + rng.uniform(-0.4, 1.4, 3) * (high - low)
        target = low + rng.uniform(0, 1, 3) * (high - low)
        left, right, down, up = rng.uniform(0.05, 1.3, 4)
        fov = nf.Fov(-left, right, -down, up)
        size = tuple(int(n) for n in rng.integers(20, 4 * tree.size, 2))
        found.append(nf.Camera.look_at(eye + 1e-3 * side, target, fov=fov, size=(size[0], size[1])))
    return found


def axes_of(camera: nf.Camera) -> list[list[float]]:
    """World directions of a camera's axes: the columns of its orientation's matrix."""
    x, y, z, w = map(float, camera.orientation)
    return [
        [1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)],
        [2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)],
        [2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)],
    ]


def camera_of(camera: nf.Camera) -> dict[str, Any]:
    """A camera in the page's format."""
    fov = camera.fov
    assert isinstance(fov, nf.Fov)
    right, up, back = axes_of(camera)
    width, height = camera.size
    axes = {"right": right, "up": up, "back": back}
    sides = {name: float(getattr(fov, name)) for name in ("left", "right", "down", "up")}
    return {"position": list(map(float, camera.position)), **axes, "fov": sides, "width": width, "height": height}


def cases_of(tree: nf.orthoview.OrthoTree, some: Sequence[nf.Camera]) -> list[dict[str, Any]]:
    """Cuts of a tree, with other settings for each camera."""
    found = []
    for number, camera in enumerate(some):
        views, error, around = 1 + number % 4, (0.5, 1.0, 2.0)[number % 3], number % 5 == 0
        geometry, lift = number % 2 == 0, (0.0, 30.0, 75.0)[number % 7 % 3]
        cut = tree.cut(camera, views=views, error_px=error, geometry=geometry, around=around, lift_deg=lift)
        directions = [[n for n in row if n >= 0] for row in cut.directions.tolist()]
        rows = zip(cut.level, cut.place, cut.distance, cut.in_picture, directions, strict=True)
        cells = [[int(a), b.tolist(), float(c), bool(d), e] for a, b, c, d, e in rows]
        leaf_rows = zip(cut.leaves, cut.leaf_distance, cut.leaf_in_picture, strict=True)
        leaves = [[a.tolist(), float(b), bool(c)] for a, b, c in leaf_rows]
        files = tree._viewer.cutter.with_guests(cut.leaf_places())
        settings = {"views": views, "error": error, "around": around, "geometry": geometry, "lift": lift}
        near = {"leaves": leaves, "files": files, "unbuilt": cut.unbuilt}
        found.append({"camera": camera_of(camera), **settings, "reach": cut.reach, "cells": cells, **near})
    return found


@dataclass
class Damage:
    """A view or, with the direction −1, a leaf that cannot be read."""

    view: ViewKey
    kind: str
    words: list[str]
    """Words of the error."""


@dataclass
class Store:
    """A store that Node reads."""

    url: str
    cases: list[dict[str, Any]]
    """Cuts that are compared."""
    views: list[ViewKey]
    """Views whose splats are read."""
    damaged: list[Damage] = field(default_factory=list)


def in_node(tests: Path, folder: Path, stores: Sequence[Store]) -> list[list[list[dict[str, Any]]]]:
    """Run the page's tests of trees on some stores; returns for each the splats of each view's layers."""
    outputs = [folder / f"splats {number}.json" for number in range(len(stores))]
    told = [asdict(store) | {"output": str(output)} for store, output in zip(stores, outputs, strict=True)]
    (folder / "told.json").write_text(json.dumps(told))
    files = sorted(map(str, tests.glob("orthoview_*.test.mjs")))
    run("node", "--test", *files, NEARFAR_ORTHOVIEW=str(folder / "told.json"))
    return [json.loads(output.read_text()) for output in outputs]
