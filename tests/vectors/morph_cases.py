"""Cases of both morphs, by the regions of their formulas."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from tests.vectors.exact import Vector, document
from tests.vectors.morph import TOLERANCE, case, ring

PAPER = (30.0, 50.0)
FAR = (1000000.53, 1.7, -700000.28)
"""A centre that float32 numbers approximate to centimetres."""
GROWING = (8.0, 5.0, 20.5, 24.0, -32.25, 9.5, 24.0, 32.0, 60.0, -11.0)
"""(x, z) within r₁, between the radii and beyond them."""
BETWEEN = (20.5, 24.0, -32.25, 9.5, 24.0, 32.0, 47.5, -14.0, 30.125, 1.5)
"""(x, z) with ρ between 30 and 50."""


def blend() -> list[dict[str, Any]]:
    """Cases of the near–far blend, by the regions of its formula."""

    def blend_case(
        region: str, points: Sequence[Vector], radii: tuple[float, float] = PAPER, **options: Any
    ) -> dict[str, Any]:
        return case(region, points, kind="blend", radii=radii, **options)

    inside = [(0.0, 0.0, 0.0), (0.0, -1.5, 0.0), (0.0, 400.0, 0.0), (2.0, 0.25, -29.0), *ring((7.0, -24.0), (3.5,))]
    on_r1 = [(18.0, 4.0, -24.0), (-30.0, 0.0, 0.0), (0.0, 400.0, 30.0), (-24.0, -1.0, -18.0)]
    on_r2 = [(30.0, 4.0, 40.0), (-50.0, 0.0, 0.0), (0.0, 400.0, -50.0), (14.0, -1.5, -48.0)]
    beside = [
        (30.0009765625, 2.0, 0.0),
        (0.0, 2.0, -30.0009765625),
        (49.9990234375, -1.0, 0.0),
        (0.0, 9.0, 49.9990234375),
    ]
    return [
        blend_case("inside r1, w = 1: points keep their bits", inside),
        blend_case("on r1, w = 1", on_r1),
        blend_case("between the radii, 0 < w < 1", ring(BETWEEN, (-1.5, 0.0, 12.5))),
        blend_case("between the radii, high above the user", ring(BETWEEN, (400.0,))),
        blend_case("within a millimetre of a radius", beside),
        blend_case("on r2, w = 0: Q = U + P - O", on_r2),
        blend_case("beyond r2, w = 0", ring((60.0, -11.0, 1234.5, 777.25, -3.0, 9000.5), (-2.0, 55.0))),
        blend_case("U = O: nothing moves", ring(BETWEEN, (3.0,)), user=(0.0, 0.0, 0.0)),
        blend_case("U above O: both on the axis", [(0.0, 9.0, 0.0), *ring(BETWEEN, (3.0, 8.0))], user=(0.0, 5.3, 0.0)),
        blend_case(
            "a narrow zone", ring((49.25, 3.0, 49.5, -2.0, 5.0, 49.625), (2.0,)), (49.0, 50.0), user=(6.7, 0.9, 2.3)
        ),
        blend_case(
            "a narrow zone: on r2 and beyond it",
            [(14.0, 2.0, -48.0), (0.0, -1.0, 50.0), (-70.0, 3.0, 9.5)],
            (49.0, 50.0),
            user=(6.7, 0.9, 2.3),
        ),
        blend_case("r1 = 0", ring((12.0, 5.0, -1.0, 0.5, 44.0, 9.0), (-1.0, 6.0)), (0.0, 50.0), user=(0.4, 0.1, -0.3)),
        blend_case("opposed directions: the user's is taken", [(40.0, 0.0, 0.0)], user=(80.0, 0.0, 0.0)),
        blend_case("opposed directions across all axes", [(24.0, 3.0, 32.0)], user=(48.0, 6.0, 64.0)),
        blend_case(
            "nearly opposed directions", [(40.0, 0.5, 0.0), (40.5, 0.0, 0.25), (39.0, -2.0, 1.0)], user=(80.0, 0.0, 0.0)
        ),
        blend_case("P = U between the radii: the centre's direction", [(40.0, 0.0, 0.0)], user=(40.0, 0.0, 0.0)),
        blend_case(
            "U beyond r1",
            [*ring(BETWEEN, (0.0, 6.0)), (33.0, 1.0, 2.0), (37.0, 4.0, -1.0)],
            user=(34.7, 1.9, 1.1),
        ),
        blend_case("U beyond r2", [*ring(BETWEEN, (0.0, 6.0)), (61.0, 1.0, 2.0)], user=(-3.3, 2.9, 71.7)),
        blend_case(
            "far from the origin of the coordinates",
            [(31.0, 2.0, -20.0), (-40.5, 3.0, 9.0), (9.0, 0.0, 44.0), (100.0, 5.0, -7.0), (3.0, 8.0, 5.0)],
            center=FAR,
        ),
        blend_case(
            "far from the origin, a narrow zone: w needs the centre's last digits",
            [(30.0, 2.0, -29.0), (-30.5, 3.0, 29.0), (29.0, -1.0, 31.0), (-28.5, 4.0, -31.0)],
            (40.0, 44.0),
            center=FAR,
            user=(12.1, 0.9, -13.3),
        ),
        *(blend_case(f"strength {s}", ring(GROWING, (-1.5, 2.0, 40.0)), strength=s) for s in (0.0, 0.25, 0.625)),
        blend_case(
            "strength 1/2, between U and O: opposed directions", [(2.0, 0.0, 0.0)], user=(8.0, 0.0, 0.0), strength=0.5
        ),
    ]


def cylinder() -> list[dict[str, Any]]:
    """Cases of the cylinder morph, by the regions of its formula."""

    def blend_case(
        region: str, points: Sequence[Vector], radii: tuple[float, float] = (35.0, 50.0), **options: Any
    ) -> dict[str, Any]:
        return case(region, points, kind="cylinder", radii=radii, **options)

    between = (30.5, 24.0, -36.25, 9.5, 27.0, 36.0, 47.5, -14.0, 40.125, 1.5)
    beyond = (60.0, -11.0, 48.0, 90.0, -1234.5, 777.25)
    inner = (36.0, 2.0, 20.0, -31.0, -36.5, 9.0)
    return [
        blend_case(
            "inside Rn, w = 1: points keep their bits",
            [(0.0, 400.0, 0.0), (21.0, 3.0, -28.0), *ring((9.0, 4.0), (0.0,))],
        ),
        blend_case("between the radii, 0 < w < 1: Q keeps rho", ring(between, (-1.5, 0.0, 12.5))),
        blend_case("between the radii, high above the user", ring(between, (400.0,))),
        blend_case("on R, w = 0", [(30.0, 4.0, 40.0), (-50.0, 0.0, 0.0), (14.0, -1.5, -48.0)]),
        blend_case("beyond R, w = 0: Q keeps rho", ring(beyond, (-2.0, 55.0))),
        blend_case("U = O: nothing moves", ring(between, (3.0,)), user=(0.0, 0.0, 0.0)),
        blend_case("U above O: d_h (U-O)_h = 0", ring(between, (3.0, 8.0)), user=(0.0, 5.3, 0.0)),
        blend_case("no near geometry, R = 0: w = 0", ring(between, (-2.0, 30.0)), (0.0, 0.0)),
        blend_case(
            "R = 0, P on the axis or nearer to it than U: the blend's t",
            [(0.0, 7.0, 0.0), (0.0, -3.0, 0.0), (0.25, 1.0, -0.5), (-3.0, 2.0, 3.5)],
            (0.0, 0.0),
        ),
        blend_case("R = 0, U and P on the axis", [(0.0, 7.0, 0.0), (0.0, -3.0, 0.0)], (0.0, 0.0), user=(0.0, 2.2, 0.0)),
        blend_case(
            "U outside the point's cylinder, real roots: the blend's t",
            ring(inner, (0.0, 5.0)),
            user=(39.7, 2.6, -1.3),
        ),
        blend_case(
            "U outside the point's cylinder, negative discriminant: the blend's t",
            [(0.0, 1.0, 36.0), (2.0, -1.0, -37.0), (-1.0, 8.0, 38.5)],
            user=(47.3, 0.7, 0.2),
        ),
        blend_case(
            "rho = |(U-O)_h|: the blend's t", [(24.0, 2.0, 32.0), (0.0, 1.0, -40.0)], user=(40.0, 0.5, 0.0), wgsl=False
        ),
        blend_case(
            "U between the radii, inside the point's cylinder",
            ring((46.0, 8.0, -30.0, 37.0), (1.0,)),
            user=(33.3, 1.2, 8.4),
        ),
        blend_case(
            "U beyond R, inside the point's cylinder",
            ring((90.0, 8.0, -60.0, 75.5), (1.0, 20.0)),
            user=(51.3, 1.2, 8.4),
        ),
        blend_case("opposed directions: the user's is taken", [(42.5, 0.0, 0.0)], user=(85.0, 0.0, 0.0)),
        blend_case(
            "far from the origin of the coordinates",
            [(31.0, 2.0, -20.0), (-40.5, 3.0, 9.0), (9.0, 0.0, 44.0), (100.0, 5.0, -7.0)],
            center=FAR,
        ),
        blend_case(
            "far from the origin, a narrow zone: w needs the centre's last digits",
            [(30.0, 2.0, -29.0), (-30.5, 3.0, 29.0), (29.0, -1.0, 31.0), (-28.5, 4.0, -31.0)],
            (41.0, 43.5),
            center=FAR,
            user=(9.1, 0.9, -8.3),
        ),
        *(blend_case(f"strength {s}", ring(GROWING, (-1.5, 2.0, 40.0)), strength=s) for s in (0.0, 0.25, 0.625)),
    ]


UNITS = "metres; right-handed, y up; w from 0 to 1. Points are float32 numbers, users and centres float64."


def files() -> dict[str, str]:
    """Texts of the files by name."""
    return {
        "blend.json": document(
            holds="Points that the near-far blend morph shows, their weight w, and their distance from the user.",
            units=UNITS,
            source="Popescu, Lee, Choi, Fahmy (2022), Eq. 1-3; opposed directions take the user's.",
            tolerance=TOLERANCE,
            cases=blend(),
        ),
        "cylinder.json": document(
            holds="Points that the cylinder morph shows, their weight w, and their distance from the user.",
            units=UNITS,
            source="CloVR (2024), Alg. 1, with the brackets that its printed w = (R-rho)/(R-Rn) lacks. r1 is Rn.",
            tolerance=TOLERANCE,
            cases=cylinder(),
        ),
    }
