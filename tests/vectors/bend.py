"""Vectors of bent rays in exact arithmetic: tracing them through the unmorphed scene shows the morph for each pixel.

With v = O−U, v⊥ = v − (v·d) d, y₁ = |v⊥| and e = v⊥/y₁, the points that the morph shows in the unit direction d are
P(s) = U + s d + y(s) e, with y(s) in [0, y₁] the root of w y/|P−U| + (1−w)(y−y₁)/|P−O| = 0, w = w(ρ(P)).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

from tests.vectors import morph
from tests.vectors.exact import STEP_64, Vector, above, add, document, dot, exact, horizontal, length, rounded, vector

PRECISION = exact.mpf(10) ** -36
"""Greatest width of the interval around a root, as a share of y₁."""
TRIALS = 16
"""Number of positions at which the equation's sign is tested; a second root would change it again."""
POLYLINE = 1e-6
"""Tolerance in radians of the polylines of `nearfar.bend_rays` in the comparison."""


@dataclass(frozen=True)
class Curve:
    """The curve in one direction."""

    user: list[Any]
    center: list[Any]
    radii: tuple[float, float]
    direction: list[Any]
    strength: float = 1.0

    @cached_property
    def across(self) -> list[Any]:
        """The vector v⊥."""
        v = add(self.center, self.user, -1)
        return add(v, self.direction, -dot(v, self.direction))

    @cached_property
    def beside(self) -> Any:
        """The length y₁."""
        return length(self.across)

    def point(self, s: Any, y: Any) -> list[Any]:
        """The point P for s and y."""
        return add(add(self.user, self.direction, s), self.across, y / self.beside if self.beside else 0)

    def residual(self, s: Any, y: Any) -> Any:
        """Left side of the equation for y."""
        p = self.point(s, y)
        by_user, by_center = (length(add(p, x, -1)) for x in (self.user, self.center))
        w = morph.weight(length(horizontal(add(p, self.center, -1))), *self.radii, self.strength)
        return w * y / by_user + (1 - w) * (y - self.beside) / by_center

    def offset(self, s: float) -> Any:
        """The root y(s)."""
        low, high = exact.mpf(0), self.beside
        if high == 0:
            return low
        trials = [high * k / TRIALS for k in range(TRIALS + 1)]
        found = [self.residual(s, y) for y in trials]
        signs = [value > 0 for value in found]
        assert signs == sorted(signs), "one root only: the picture must not fold"
        if found[0] == 0:
            return low
        place = signs.index(True) if signs[-1] else TRIALS
        (low, high), (below, beyond) = trials[place - 1 : place + 1], found[place - 1 : place + 1]
        moved = ""
        while high - low > PRECISION * self.beside:
            # Regula falsi; the Illinois rule halves the value at an end that stays twice, so that both ends converge.
            middle = high - beyond * (high - low) / (beyond - below)
            value = self.residual(s, middle)
            if value > 0:
                high, beyond, below, moved = middle, value, below / (2 if moved == "high" else 1), "high"
            elif value < 0:
                low, below, beyond, moved = middle, value, beyond / (2 if moved == "low" else 1), "low"
            else:
                return middle
        return high

    def slope(self, s: float, y: Any) -> Any:
        """Derivative of the equation's left side by y: change of the shown direction, divided by the blend's length."""
        step = exact.mpf(10) ** -20
        return (self.residual(s, y + step) - self.residual(s, y - step)) / (2 * step)


CENTER = (3.25, 1.75, -2.5)


def case(
    region: str,
    direction: Vector,
    s: list[float],
    *,
    user: Vector,
    radii: tuple[float, float] = (30.0, 50.0),
    strength: float = 1.0,
) -> dict[str, Any]:
    """A case of the file, for a user relative to the centre and distances s along the direction."""
    u = [a + b for a, b in zip(CENTER, user, strict=True)]
    d = vector(direction)
    size = length(d)
    curve = Curve(vector(u), vector(CENTER), radii, [x / size for x in d], strength)
    offsets = [curve.offset(x) for x in s]
    for x, y in zip(s, offsets, strict=True):
        _check(curve, x, y)
    slope = length(horizontal(curve.direction))
    end = rounded(add(curve.center, curve.direction, radii[1] / slope)) if slope and radii[1] and curve.beside else None
    return {
        "region": region,
        "user": u,
        "center": list(CENTER),
        "r1": radii[0],
        "r2": radii[1],
        "strength": strength,
        "direction": list(direction),
        "tolerance": _tolerance(curve, s, offsets),
        "s": s,
        "y": rounded(offsets),
        "points": [rounded(curve.point(x, y)) for x, y in zip(s, offsets, strict=True)],
        "end": end,
    }


def _check(curve: Curve, s: float, y: Any) -> None:
    """Check that the morph shows a point of the curve in the curve's direction."""
    if s > 0:
        shown = morph.displayed_point(
            "blend", curve.point(s, y), curve.user, curve.center, *curve.radii, curve.strength
        )
        seen = add(shown.point, curve.user, -1)
        assert length(add(seen, curve.direction, -length(seen))) < exact.mpf(10) ** -30 * length(seen)


TOLERANCE = {
    "float64": "Metres. Rounding of w, 4 steps (2^-53) of the coordinates over r2-r1, and 16 of the equation's other "
    "terms, over the slope of the equation; besides 8 steps of the coordinates.",
    "polyline": "Metres. nearfar.bend_rays(tolerance=1e-6) returns points of the curve at distances of its own choice; "
    "between them a chord's direction may miss by 1e-6 radians, which over the slope of the equation is this distance. "
    "Added to float64's.",
}


def _tolerance(curve: Curve, s: list[float], offsets: list[Any]) -> dict[str, float]:
    r1, r2 = curve.radii
    y1 = curve.beside
    largest = max(map(abs, [*curve.user, *curve.center])) + max(s) + y1
    double, chord = 8 * STEP_64 * largest, exact.mpf(0)
    for x, y in zip(s, offsets, strict=True):
        # Where the curve is one of the two straight rays, y is 0 or y₁ up to the rounding of coordinates.
        if 0 < y < y1:
            slope = curve.slope(x, y)
            by_user, by_center = (length(add(curve.point(x, y), place, -1)) for place in (curve.user, curve.center))
            terms = y / by_user + (y1 - y) / by_center
            of_w = 4 * STEP_64 * largest / (r2 - r1)
            double = max(double, 8 * STEP_64 * largest + (of_w + 16 * STEP_64) * terms / slope)
            # The residual is the sine of the angular error times the length of the blend, which is at most 1.
            chord = max(chord, POLYLINE / slope)
    return {"float64": above(double), "polyline": above(chord + double)}


def cases() -> list[dict[str, Any]]:
    """Cases by the regions of the curve."""
    along = [1.0, 20.0, 29.0, 31.0, 34.5, 38.0, 42.5, 47.0, 52.0, 60.0, 500.0]
    near = (4.1, 0.3, -3.7)
    return [
        case("to the right of the centre", (1.0, 0.0, 0.0), along, user=near),
        case("to the left", (-1.0, 0.0, 0.0), along, user=near),
        case("ahead", (0.0, 0.0, -1.0), along, user=near),
        case("behind", (0.0, 0.0, 1.0), along, user=near),
        case("off all axes, of odd length", (0.3, -0.1, 0.7), along, user=near),
        case("away from the centre's side, short", (-2e-3, 5e-4, -1e-3), along, user=(-6.0, 1.2, 5.5)),
        case("steep", (0.2, 1.0, -0.1), [30.0, 100.0, 140.0, 170.0, 200.0, 260.0], user=near),
        case("steep, downwards", (0.1, -1.0, 0.2), [30.0, 100.0, 140.0, 170.0, 200.0, 260.0], user=near),
        case("U below O", (1.0, 0.1, 0.5), along, user=(0.0, -6.4, 0.0)),
        case(
            "a narrow zone", (-0.6, 0.0, 0.8), [40.0, 46.0, 48.5, 49.5, 51.0], user=(0.3, 0.1, 0.2), radii=(48.0, 50.0)
        ),
        case(
            "U beyond r1", (0.6, 0.1, 0.8), [2.0, 20.0, 60.0, 90.0, 120.0], user=(14.2, 0.9, 3.3), radii=(10.0, 100.0)
        ),
        case(
            "U beyond r1, through the near cylinder",
            (-1.0, 0.02, 0.1),
            [1.0, 4.0, 6.0, 15.0, 21.0, 30.0, 60.0, 90.0, 120.0],
            user=(14.2, 0.9, 1.3),
            radii=(10.0, 100.0),
        ),
        case("U = O: no bend", (0.3, -0.1, 0.7), along, user=(0.0, 0.0, 0.0)),
        case("along the line through U and O: no bend", (1.0, 0.0, 0.0), along, user=(5.0, 0.0, 0.0)),
        case("straight up: no bend inside r1", (0.0, 1.0, 0.0), along, user=near),
        case("strength 3/4: from U", (0.3, -0.1, 0.7), [0.05, *along], user=near, strength=0.75),
        case("strength 3/4, ahead", (0.0, 0.0, -1.0), [0.05, *along], user=near, strength=0.75),
        case("strength 1/4: from the centre", (0.3, -0.1, 0.7), [5.0, *along[1:]], user=near, strength=0.25),
        case("strength 1/4, the centre behind U", (1.0, 0.0, 0.2), [-2.5, 0.5, *along], user=near, strength=0.25),
        case("strength 1/4, straight up", (0.0, 1.0, 0.0), along, user=near, strength=0.25),
        case("no near geometry, R = 0: the centre's ray", (0.3, -0.1, 0.7), along[1:], user=near, radii=(0.0, 0.0)),
    ]


def margins() -> list[dict[str, Any]]:
    """Fold margins of the cylinder kind, Rₙ − |(U−O)ₕ|."""
    found = []
    for user, r1 in (((3.0, 9.0, 4.0), 30.0), ((-4.1, 0.3, 3.7), 7.25), ((24.0, -2.0, 32.0), 35.0)):
        u = [a + b for a, b in zip(CENTER, user, strict=True)]
        margin = r1 - length(horizontal(add(vector(u), vector(CENTER), -1)))
        tolerance = {"float64": above(8 * STEP_64 * 50)}
        found.append(
            {"user": u, "center": list(CENTER), "r1": r1, "r2": 50.0, "tolerance": tolerance, "margin": rounded(margin)}
        )
    return found


def files() -> dict[str, str]:
    """Texts of the files by name."""
    text = document(
        holds="Points P(s) of the curve that the morph of either kind shows in one direction, with their offsets y(s) "
        "across it, and the point at which the curve leaves r2; null where it does not bend or never does. r1 = r2 = 0 "
        "is of the cylinder kind only. Besides, fold margins of the cylinder kind.",
        units="metres; right-handed, y up; s along the unit direction, and directions of any length.",
        source="The inverse of Popescu, Lee, Choi, Fahmy (2022), Eq. 1: the root of w y/|P-U| + (1-w)(y-y1)/|P-O|.",
        tolerance=TOLERANCE,
        cases=cases(),
        cylinder_margins=margins(),
    )
    return {"bend.json": text}
