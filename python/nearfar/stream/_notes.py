"""Findings on centres and rings that are probably mistakes: valid input, but its bundle shows little."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import islice, pairwise, product

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._scene.report import count
from nearfar._scene.units import extent_note
from nearfar._trace.rays import cast_rays, is_hit_from_behind
from nearfar.stream._assign import Rings

RAYS = 256
"""Rays in all directions from a centre."""

SEEN = 0.25
"""Share of the rays that must hit back faces for the centre to count as inside a solid."""

MAX_NAMED = 3
"""Greatest number of objects or rings that a sentence names."""


def findings_of(rings: Rings) -> list[str]:
    """Describe why the bundle of a scene's rings may show little: units, centre, empty rings, endless objects."""
    scene, center, reach = rings.scene, np.array(rings.center), rings.radii[-1]
    note = extent_note(scene.bounds)
    found = [
        _outside(scene.bounds, center, reach) if scene.triangle_count else "",
        _note_enclosed_center(rings),
        _empty(rings.radii, [row["triangles"] for row in rings.summary()]),
        _endless({_object_label(scene.object_names, n): size for n, size in sorted(_endless_objects(rings).items())}),
    ]
    return [note] * bool(note) + [sentence for sentence in found if sentence]


def _outside(bounds: NDArray[np.float64], center: NDArray[np.float64], reach: float) -> str:
    """Report a centre beside or below the scene, or farther above it than the last radius."""
    low, high = bounds
    away = np.maximum(np.maximum(low - center, center - high), 0.0)
    distance = math.hypot(*away)
    is_beside = bool(away[[0, 2]].any())
    if not distance or (not is_beside and 0.0 < center[1] - high[1] <= reach):
        return ""
    where = "outside the bounds of the scene"
    if not is_beside:
        where = "below the scene's lowest point" if center[1] < low[1] else "above the scene's highest point"
    shown = f"{distance:.3g}" if distance < 1000.0 else f"{distance:,.0f}"
    return f"the centre lies {shown} m {where}"


def _note_enclosed_center(rings: Rings) -> str:
    """Report a centre within a solid, such as a wall, or under the ground, where rays hit back faces."""
    reach, directions = rings.radii[-1], _sphere(RAYS)
    hits = cast_rays(rings.scene, rings.center, directions, t_max=reach)
    stays = hits.object_id < 0
    stays |= ~np.isin(hits.object_id, rings.scene._core.moving_objects())
    seen = np.where(stays, hits.triangle_index, -1)
    behind = is_hit_from_behind(rings.scene, seen, directions)
    if behind.sum() < max(SEEN * RAYS, 0.5 * (seen >= 0).sum()):
        return ""
    owners = hits.object_id[behind & (hits.object_id >= 0)]
    name = f"'{rings.scene.object_names[np.bincount(owners).argmax()]}'" if len(owners) else "something"
    below = directions[:, 1] < 0.0
    where = "inside" if (behind & below).sum() > 0.5 * below.sum() else "under"
    return (
        f"the centre seems to lie {where} {name}: {behind.sum()} of {RAYS} rays from it hit backs of surfaces within "
        f"{reach:g} m"
    )


def _empty(radii: tuple[float, ...], triangles: list[int]) -> str:
    """Report rings without geometry, given the triangles of each ring."""
    bounds = list(pairwise((0.0, *radii)))
    empty = [number for number, _ in enumerate(radii, 1) if not triangles[number - 1]]
    if len(empty) == len(radii):
        return f"all rings are empty: no static object lies within {radii[-1]:g} m of the centre's vertical axis"
    if not empty:
        return ""
    named = [f"ring {number} ({bounds[number - 1][0]:g} to {bounds[number - 1][1]:g} m)" for number in empty]
    verb = "is" if len(named) == 1 else "are"
    return f"{_enumerate_names(named)} {verb} empty: no object begins there, so that the map before stays"


def _endless(found: dict[str, int]) -> str:
    """Report objects that reach from within the first ring beyond the last one, by the triangles that ring 1 sends."""
    if not found:
        return ""
    total = sum(found.values())
    named = [f"{label} ({count(size, 'triangle')})" for label, size in sorted(found.items(), key=lambda item: -item[1])]
    verb, them, noun = ("is", "it", "reaches") if len(named) == 1 else ("are", "they", "reach")
    whole = "" if len(named) == 1 else f", {count(total, 'triangle')} together"
    names = _enumerate_names(named)
    return f"{names} {noun} from within ring 1 beyond the last ring{whole}: {them} {verb} sent whole with ring 1"


def _endless_objects(rings: Rings) -> dict[int, int]:
    """Count triangles of each object that reaches from within the first radius beyond the last; −1 for no object."""
    core, names = rings.scene._core, rings.scene.object_names
    chosen = np.append(rings.ring == 1, rings.rest == 1)
    if not chosen.any():
        return {}
    parts, last = _core.scene_parts(core), rings.radii[-1]
    x, y, z = np.subtract(rings.center, core.origin).tolist()
    greatest, triangles = np.zeros(len(names) + 1), np.zeros(len(names) + 1, np.int64)
    placed = zip(parts["meshes"], parts["placements"], parts["objects"].tolist(), strict=True)
    for mesh, placement, owner in islice(placed, parts["standing_count"]):
        # Most instances end within the last ring; the farthest point of a box is a corner.
        if owner >= 0 and not (chosen[owner] and _farthest(mesh.bounds(), placement, (x, z)) > last):
            continue
        arrays = _core.mesh_parts(mesh)
        owners = np.where(owner < 0, arrays["objects"], owner)
        used = chosen[owners]
        vertices = arrays["positions"]
        if not np.array_equal(placement, np.eye(4)[:3]):
            vertices = vertices @ placement[:, :3].T + placement[:, 3]
        far = _core.triangle_radii(vertices, arrays["faces"][used], (x, y, z))[:, 1]
        np.maximum.at(greatest, owners[used], far)
        np.add.at(triangles, owners[used], 1)
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
    turn = np.arange(number) * (math.pi * (3.0 - math.sqrt(5.0)))
    flat = np.sqrt(1.0 - height * height)
    return np.column_stack([flat * np.cos(turn), height, flat * np.sin(turn)])


def _object_label(names: Sequence[str], number: int) -> str:
    return "faces without an object" if number < 0 else f"'{names[number]}'"


def _enumerate_names(names: list[str]) -> str:
    """Join names to a phrase; only the first few are listed."""
    more = len(names) - MAX_NAMED
    shown = names if more <= 0 else [*names[:MAX_NAMED], f"{more} more"]
    return shown[0] if len(shown) == 1 else f"{', '.join(shown[:-1])} and {shown[-1]}"
