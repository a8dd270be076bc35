"""A street morphed as a whole for a user apart from the camera: the expected picture of a reduced scene."""

from __future__ import annotations

import functools
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from nearfar._reduce.drawing import MorphKind
from tests.support.gpu_cases import edges
from tests.support.reduce_cases import CENTER, R1, R2, Array, place, rho, street

ALL = ("color", "range", "object_id", "face_id", "position")
MAPPED = ("color", "range", "object_id")
USER = CENTER + np.array([4.0, 0.2, 3.0])
# Positions of cameras relative to the user, and a viewing direction.
APART = [(0.5, 0.1, -0.3), (-3.0, 0.6, 2.0)]
AHEAD = (1.0, -0.02, -0.3)
# Poses of the car: near, between the radii, across r₂, and beyond it.
PLACES = {"near": (20, 0.75, -8), "between": (40, 0.75, 2), "across": (52.6, 0.75, -6), "beyond": (75, 0.75, -8)}
LONGEST = 0.6


@functools.cache
def reduced_street(kind: MorphKind) -> nf.ReducedScene:
    """The street without ground, with a map of colours, ranges and objects."""
    scene = street(dynamic=True, ground=False)
    return nf.reduce(scene, center=CENTER, r1=R1, r2=R2, face_size=256, samples=1, morph=kind, channels=MAPPED)


@functools.cache
def morphed_street(kind: str, where: str) -> tuple[nf.Scene, Array]:
    """Short triangles with their corners morphed for the user, and the unmorphed distance of each from the axis."""
    scene = street(dynamic=True, ground=False).at({"car": place(*PLACES[where])})
    # Boxes of twelve triangles.
    corners, owner = bisect(scene.triangles().astype(np.float64), np.arange(scene.triangle_count) // 12)
    shown = corners.reshape(-1, 3)
    if kind != "none":
        shown = nf.morph(shown, user=USER, center=CENTER, r1=R1, r2=R2, kind=kind)
    faces = np.arange(len(shown)).reshape(-1, 3)
    static = nf.Scene.from_arrays(shown, faces, owner.astype(np.int32), object_names=scene.object_names)
    return static, rho(corners.mean(axis=1))


def bisect(triangles: Array, owner: NDArray[np.int64]) -> tuple[Array, NDArray[np.int64]]:
    """Halve the longest edges within r₂ until all are short, on both sides alike; beyond r₂ the morph is linear."""
    done = []
    while len(triangles):
        lengths = np.linalg.norm(np.roll(triangles, -1, axis=1) - triangles, axis=2)
        is_short = (lengths.max(axis=1) <= LONGEST) | (rho(triangles).min(axis=1) - lengths.max(axis=1) > R2)
        done.append((triangles[is_short], owner[is_short]))
        first = (lengths.argmax(axis=1)[~is_short, None] + np.arange(3)) % 3
        a, b, c = np.take_along_axis(triangles[~is_short], first[:, :, None], axis=1).transpose(1, 0, 2)
        triangles = np.concatenate([np.stack([a, (a + b) / 2, c], axis=1), np.stack([(a + b) / 2, b, c], axis=1)])
        owner = np.tile(owner[~is_short], 2)
    return np.concatenate([part for part, _ in done]), np.concatenate([owners for _, owners in done])


def pictures(kind: str, view: nf.Camera, where: str, **segment: Any) -> tuple[nf.Frame, nf.Frame, Array]:
    """The reduced street's picture for the user, that of the morphed street, and the radii of the faces seen there."""
    pose = {"car": place(*PLACES[where])}
    reduced = reduced_street(kind)
    frame = reduced.render(view, user=USER, at=pose, channels=ALL, tolerance_px=0.1, backend="cpu", **segment)
    static, radii = morphed_street(kind, where)
    expected = nf.render(static, view, channels=ALL, backend="cpu", **segment)
    seen = expected.require("face_id")
    return frame, expected, np.where(seen >= 0, radii[np.maximum(seen, 0)], np.nan)


def check_near(frame: nf.Frame, expected: nf.Frame, radii: Array, least: int = 1500) -> None:
    """Check that the near part of the morphed street is shown at its range, and no other static geometry."""
    near = frame.require("face_id") >= 0
    within, stands = radii < R2 - 1.0, frame.require("object_id") != 3
    assert within.sum() > least
    clear = ~edges(expected.require("object_id")) & ~edges(frame.require("object_id"))
    assert near[within & clear].all()
    assert (radii[near & clear & stands] < R2 + 1.0).all()
    both = near & within & clear
    np.testing.assert_array_equal(frame.require("object_id")[both], expected.require("object_id")[both])
    apart = np.abs(frame.require("range")[both] / expected.require("range")[both] - 1.0)
    # A tenth of a pixel on walls that are seen at a slant.
    assert apart.max() < 1e-3
