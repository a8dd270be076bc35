"""Vectors of points that the near–far blend and the cylinder morph show, in exact arithmetic.

With w = s clamp((r₂−ρ)/(r₂−r₁), 0, 1), s the strength, d_U = (P−U)/|P−U| and d_O = (P−O)/|P−O|: d is
w d_U + (1−w) d_O, normalised.
Blend: Q = U + t d with t = w|P−U| + (1−w)|P−O|. Cylinder: Q is where the ray (U, d) leaves the cylinder of radius ρ(P)
about the axis through O; where ρ ≤ |(U−O)ₕ|, dₕ = 0 or the quadratic has no real root, t is the blend's.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from tests.vectors.exact import (
    STEP_32,
    STEP_64,
    Vector,
    above,
    add,
    dot,
    exact,
    horizontal,
    length,
    rounded,
    single,
    step_32,
    vector,
)


@dataclass(frozen=True)
class Shown:
    """A morphed point and the quantities of its computation."""

    point: list[Any]
    weight: Any
    """The weight w."""
    distance: Any
    """The distance |Q−U|."""
    opposed: bool
    """Whether the blend of both directions has no length, so that the user's direction was taken."""
    blend: Any
    """Length of w d_U + (1−w) d_O; 1 where no blend is needed."""
    leaves: Any
    """For points shown where a ray leaves their cylinder: its |dₕ| (ρ − |(U−O)ₕ|) / ρ; else 1."""


def weight(rho: Any, r1: float, r2: float, strength: float = 1.0) -> Any:
    """w at a distance from the axis; 0 where there is no near geometry."""
    if r2 == 0:
        return exact.mpf(0)
    return strength * min(max((r2 - rho) / (exact.mpf(r2) - r1), exact.mpf(0)), exact.mpf(1))


def leave_cylinder(start: Vector, direction: Vector, rho: Any) -> Any:
    """Distance from a place inside the cylinder of radius ρ to where a ray leaves it, or None."""
    a, b = dot(horizontal(direction), direction), dot(horizontal(direction), start)
    c = dot(horizontal(start), start) - rho**2
    if c >= 0 or a == 0 or b * b - a * c < 0:
        return None
    return (-b + exact.sqrt(b * b - a * c)) / a


def displayed_point(
    kind: str, point: Vector, user: Vector, center: Vector, r1: float, r2: float, strength: float = 1.0
) -> Shown:
    """Q of P, for U, O, r₁, r₂ and the strength."""
    p, u, o = vector(point), vector(user), vector(center)
    from_user, from_center, offset = add(p, u, -1), add(p, o, -1), add(u, o, -1)
    rho = length(horizontal(from_center))
    w = weight(rho, r1, r2, strength)
    if w == 1:
        return Shown(p, w, length(from_user), False, exact.mpf(1), exact.mpf(1))
    by_user, by_center = length(from_user), length(from_center)
    # A point at the eye, or at the centre, has no direction from there.
    d_user = [x / by_user for x in from_user] if by_user else vector((0, 0, 0))
    d_center = [x / by_center for x in from_center] if by_center else vector((0, 0, 0))
    mixed = add([w * x for x in d_user], d_center, 1 - w)
    size = length(mixed)
    opposed = size < exact.mpf(10) ** -40
    direction = d_user if opposed else [x / size for x in mixed]
    t, leaves = w * by_user + (1 - w) * by_center, exact.mpf(1)
    if kind == "cylinder" and (exit_at := leave_cylinder(offset, direction, rho)) is not None:
        t = exit_at
        leaves = length(horizontal(direction)) * (rho - length(horizontal(offset))) / rho
    return Shown(add(u, direction, t), w, t, opposed, exact.mpf(1) if opposed else size, leaves)


CENTER = (3.25, 1.75, -2.5)
NEAR = (4.1, 0.3, -3.7)
"""U − O of a user inside both cylinders, with more digits than float32 holds."""


def ring(places: tuple[float, ...], heights: tuple[float, ...]) -> list[Vector]:
    """P − O of all combinations of x, z, x, z, … with heights, rotated by quarters from one to the next."""
    found: list[Vector] = []
    for n, (k, y) in enumerate(itertools.product(range(0, len(places), 2), heights)):
        x, z = places[k], places[k + 1]
        turned = ((x, z), (-z, x), (-x, -z), (z, -x))[n % 4]
        found.append((turned[0], y, turned[1]))
    return found


def case(
    region: str, points: Sequence[Vector], *, kind: str, radii: tuple[float, float], user: Vector = NEAR, **options: Any
) -> dict[str, Any]:
    """A case of the file; points and user relative to the centre."""
    o: Vector = options.get("center", CENTER)
    u = [a + b for a, b in zip(o, user, strict=True)]
    places = [[single(a + b) for a, b in zip(o, p, strict=True)] for p in points]
    strength = options.get("strength", 1.0)
    found = [displayed_point(kind, p, u, o, *radii, strength) for p in places]
    return {
        "region": region,
        "user": u,
        "center": list(o),
        "r1": radii[0],
        "r2": radii[1],
        "strength": strength,
        "tolerance": _tolerance(kind, found, places, u, o, radii, options.get("wgsl", True)),
        "points": places,
        "shown": [rounded(f.point) for f in found],
        "weight": [rounded(f.weight) for f in found],
        "distance": [rounded(f.distance) for f in found],
        "opposed": [f.opposed for f in found],
    }


TOLERANCE = {
    "float64": "Metres. 16 roundings (2^-53) of the greatest length; w loses r2/(r2-r1), a short blend of directions "
    "its length, and an exit from a cylinder |d_h| (rho-|(U-O)_h|)/rho.",
    "float32": "Metres. Half a step of the result, and for the blend 2^-24 (6 + 3 r2/(r2-r1)) |U-O|: the bound that "
    "nearfar.morph states. The cylinder morph is computed in float64 and rounded once.",
    "wgsl": "Metres. A step of the result and 2^-24 (16 + 8 r2/(r2-r1)) |U-O|, the bound that nearfar.gpu.morph "
    "states; for exits from a cylinder, users beyond r1/2 and short blends 32 roundings of the lengths, with the "
    "losses of float64. Absent where rounding to float32 decides which formula holds.",
    "weight": "Of w in float64: 4 roundings of the greatest coordinate over r2-r1.",
}


def _tolerance(
    kind: str,
    found: list[Shown],
    places: Sequence[Vector],
    user: Vector,
    center: Vector,
    radii: tuple[float, float],
    wgsl: bool,
) -> dict[str, float]:
    r1, r2 = radii
    offset = length(add(vector(user), vector(center), -1))
    steepness = r2 / (r2 - r1) if r2 else 0.0
    if all(f.weight == 1 for f in found):
        return {"float64": 0.0, "float32": 0.0, "wgsl": 0.0, "weight": 0.0}
    largest = max(max(map(abs, [*f.point, *p, *user, *center])) for f, p in zip(found, places, strict=True))
    result = max(max(map(abs, f.point)) for f in found)
    lengths = max(largest + f.distance for f in found)
    loss = (1 + steepness) * max((largest + f.distance) / (f.blend * f.leaves) for f in found) / lengths
    double = 16 * STEP_64 * lengths * loss
    bounds = {"float64": above(double), "weight": above(4 * STEP_64 * largest / (r2 - r1)) if r2 else 0.0}
    single_shift = STEP_32 * (6 + 3 * steepness) * offset if kind == "blend" else 0.0
    bounds["float32"] = above(step_32(result) / 2 + single_shift + double)
    plain = kind == "blend" and offset <= r1 / 2 and min(f.blend for f in found) > 0.5
    from_center = max(length(add(vector(p), vector(center), -1)) for p in places)
    roundings = (16 + 8 * steepness) * offset if plain else 32 * loss * (from_center + offset)
    if wgsl:
        bounds["wgsl"] = above(step_32(result) + STEP_32 * roundings + double)
    return bounds
