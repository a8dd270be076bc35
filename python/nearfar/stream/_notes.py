"""Findings on centres and rings that are probably mistakes: the input is valid, but the bundle shows little."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import islice, product

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._scene.report import count
from nearfar._scene.units import extent_note
from nearfar._trace.rays import cast_rays, is_hit_from_behind
from nearfar.stream._assign import Rings

RAY_COUNT = 256
"""Rays in all directions from a centre."""

MIN_BACK_SHARE = 0.25
"""Share of the rays that must hit back faces for the centre to count as inside a solid."""

MAX_NAMED = 3
"""Greatest number of objects or rings that a sentence names."""


def findings_of(rings: Rings) -> list[str]:
    """Describe why a bundle may show little or show it late: units, centre, empty rings, rings with the whole scene."""
    scene, center, reach = rings.scene, np.array(rings.center), rings.radii[-1]
    triangles = [row["triangles"] for row in rings.summary()]
    findings = [
        extent_note(scene.bounds),
        _note_distant_center(scene.bounds, center, reach) if scene.triangle_count else "",
        _note_enclosed_center(rings),
        _note_empty_rings(rings.radii, triangles),
        _note_single_ring(rings.radii[0], triangles),
        _note_endless_objects(scene.object_names, _endless_objects(rings)),
    ]
    return [finding for finding in findings if finding]


def _note_distant_center(bounds: NDArray[np.float64], center: NDArray[np.float64], reach: float) -> str:
    """Report a centre beside or below the scene, or farther above it than the last radius."""
    low, high = bounds
    offset = np.maximum(np.maximum(low - center, center - high), 0.0)
    distance = math.hypot(*offset)
    is_beside = bool(offset[[0, 2]].any())
    if not distance or (not is_beside and 0.0 < center[1] - high[1] <= reach):
        return ""
    where = "outside the bounds of the scene"
    if not is_beside:
        where = "below the scene's lowest point" if center[1] < low[1] else "above the scene's highest point"
    return f"the centre lies {format(distance, '.3g' if distance < 1000.0 else ',.0f')} m {where}"


def _note_enclosed_center(rings: Rings) -> str:
    """Report a centre inside a solid, such as a wall, or under the ground: rays from there hit back faces."""
    reach, directions = rings.radii[-1], _sphere(RAY_COUNT)
    hits = cast_rays(rings.scene, rings.center, directions, t_max=reach)
    is_static = (hits.object_id < 0) | ~np.isin(hits.object_id, rings.scene._core.moving_objects())
    triangles = np.where(is_static, hits.triangle_index, -1)
    is_back = is_hit_from_behind(rings.scene, triangles, directions)
    if is_back.sum() < max(MIN_BACK_SHARE * RAY_COUNT, 0.5 * (triangles >= 0).sum()):
        return ""
    owners = hits.object_id[is_back & (hits.object_id >= 0)]
    name = f"'{rings.scene.object_names[np.bincount(owners).argmax()]}'" if len(owners) else "something"
    is_down = directions[:, 1] < 0.0
    where = "inside" if (is_back & is_down).sum() > 0.5 * is_down.sum() else "under"
    rays = f"{is_back.sum()} of {RAY_COUNT} rays"
    return f"the centre seems to lie {where} {name}: {rays} from it hit backs of surfaces within {reach:g} m"


def _note_empty_rings(radii: tuple[float, ...], triangles: list[int]) -> str:
    """Report rings without geometry, given the triangles of each ring and of all objects beyond."""
    rows = zip((0.0, *radii), radii, triangles, strict=False)
    empty = [f"ring {n} ({low:g} to {high:g} m)" for n, (low, high, size) in enumerate(rows, 1) if not size]
    if len(empty) == len(radii):
        return f"all rings are empty: no static object lies within {radii[-1]:g} m of the centre's vertical axis"
    verb = "is" if len(empty) == 1 else "are"
    text = f"{verb} empty: no object begins there, so that the previous map stays"
    return f"{_enumerate_names(empty)} {text}" if empty else ""


def _note_single_ring(radius: float, triangles: list[int]) -> str:
    """Report a scene that lies in ring 1 as a whole, given the triangles of each ring and of all objects beyond."""
    if not triangles[0] or any(triangles[1:]):
        return ""
    size = count(triangles[0], "triangle")
    return f"ring 1 (to {radius:g} m) has the whole scene, {size}: smaller radii divide it into several rings"


def _note_endless_objects(names: Sequence[str], triangles: dict[int, int]) -> str:
    """Report objects that extend from the first ring beyond the last one, most triangles first."""
    if not triangles:
        return ""
    labels = {n: "faces without an object" if n < 0 else f"'{names[n]}'" for n in triangles}
    ordered = sorted(sorted(triangles), key=lambda n: -triangles[n])
    phrase = _enumerate_names([f"{labels[n]} ({count(triangles[n], 'triangle')})" for n in ordered])
    if len(triangles) == 1:
        return f"{phrase} reaches from within ring 1 beyond the last ring: it is sent whole with ring 1"
    total = count(sum(triangles.values()), "triangle")
    return f"{phrase} reach from within ring 1 beyond the last ring, {total} together: they are sent whole with ring 1"


def _endless_objects(rings: Rings) -> dict[int, int]:
    """Count the triangles of each object that extends from the first ring beyond the last; −1 stands for no object."""
    core, names = rings.scene._core, rings.scene.object_names
    is_first = np.append(rings.ring == 1, rings.rest == 1)
    if not is_first.any():
        return {}
    parts, last = _core.scene_parts(core), rings.radii[-1]
    x, y, z = np.subtract(rings.center, core.origin).tolist()
    greatest, triangles = np.zeros(len(names) + 1), np.zeros(len(names) + 1, np.int64)
    placed = zip(parts["meshes"], parts["placements"], parts["objects"].tolist(), strict=True)
    for mesh, placement, owner in islice(placed, parts["standing_count"]):
        # Most instances end within the last ring; the farthest point of a box is a corner.
        if owner >= 0 and not (is_first[owner] and _farthest(mesh.bounds(), placement, (x, z)) > last):
            continue
        arrays = _core.mesh_parts(mesh)
        owners = np.where(owner < 0, arrays["objects"], owner)
        is_in_ring_1 = is_first[owners]
        vertices = arrays["positions"]
        if not np.array_equal(placement, np.eye(4)[:3]):
            vertices = vertices @ placement[:, :3].T + placement[:, 3]
        greatest_radii = _core.triangle_radii(vertices, arrays["faces"][is_in_ring_1], (x, y, z))[:, 1]
        np.maximum.at(greatest, owners[is_in_ring_1], greatest_radii)
        np.add.at(triangles, owners[is_in_ring_1], 1)
    return {
        number if number < len(names) else -1: int(triangles[number])
        for number in np.flatnonzero(greatest > last).tolist()
    }


def _farthest(bounds: NDArray[np.float64], placement: NDArray[np.float64], axis: tuple[float, float]) -> float:
    """Return the greatest distance of a placed box's corners from a vertical axis."""
    corners = np.array(list(product(*bounds.T.tolist()))) @ placement[:, :3].T + placement[:, 3]
    return float(np.hypot(corners[:, 0] - axis[0], corners[:, 2] - axis[1]).max())


def _sphere(number: int) -> NDArray[np.float64]:
    """Return unit vectors (number, 3) that cover all directions evenly: a Fibonacci lattice."""
    height = 1.0 - (2.0 * np.arange(number) + 1.0) / number
    azimuth = np.arange(number) * (math.pi * (3.0 - math.sqrt(5.0)))
    radius = np.sqrt(1.0 - height * height)
    return np.column_stack([radius * np.cos(azimuth), height, radius * np.sin(azimuth)])


def _enumerate_names(names: list[str]) -> str:
    """Join names to a phrase; only the first few are listed."""
    more = len(names) - MAX_NAMED
    listed = names if more <= 0 else [*names[:MAX_NAMED], f"{more} more"]
    return listed[0] if len(listed) == 1 else f"{', '.join(listed[:-1])} and {listed[-1]}"
