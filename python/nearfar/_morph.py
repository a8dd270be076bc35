"""The morph: moves points so that near geometry, seen by the user, joins the environment map, seen from the centre."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check

KINDS = ("blend", "cylinder")
"""Names of morphs: "blend" of Popescu et al. (2022) and "cylinder" of CloVR (2024)."""


def morph(
    points: ArrayLike,
    *,
    user: ArrayLike,
    center: ArrayLike,
    r1: float,
    r2: float,
    kind: str = "blend",
    strength: float = 1.0,
    out: NDArray[Any] | None = None,
) -> NDArray[Any]:
    """Move points to where the continuous near–far method shows them.

    Let ρ be a point's horizontal distance from the vertical axis through the centre O. Points with ρ ≤ `r1` stay where
    they are, bit for bit. Points with ρ > `r2` are shown in the direction in which O sees them. Between the radii the
    two positions are blended, so that the picture has no seam at either radius.

    ValueError for wrong shapes, unknown kinds, radii or strengths out of range, a user or centre that is not finite,
    and an `out` of another shape, type or layout than the result, or in the memory of `points`; TypeError for values
    that are not numbers. Sources: Popescu, Lee, Choi, Fahmy (2022), Eq. 1–3, for "blend"; CloVR (2024), Alg. 1, for
    "cylinder", with the brackets that are missing in its formula of the weight w.

    Parameters
    ----------
    points
        Points P (N, 3), metres. float32 and float64 are kept, other numbers become float64. A point with NaN gives NaN.
    user
        The user's eye U, metres, in the points' frame.
    center
        The centre O, metres, on the axis of both cylinders.
    r1, r2
        Radii in metres, 0 ≤ r1 < r2. For "cylinder", r1 is the radius of the near subregion (0.7 r2 in the paper) and
        r2 the radius of the cylinder; there both may be 0, which means that no geometry is near.
    kind
        "blend": the distance at which the point is shown is a blend of its distances from U and O; beyond r2 it is
        shown at U + P − O, rounded once. "cylinder": the point is shown where the blended direction leaves the vertical
        cylinder on which the point lies; if it does not leave it (U is outside the cylinder or looks straight up), as
        with "blend".
    strength
        Factor of the weight of the user's view, 0 to 1. Below 1 points with ρ ≤ `r1` move too; with 0 all points are
        shown in the direction in which O sees them, as with both radii 0.
    out
        Array for the result: C-contiguous, of the result's shape and type, sharing no memory with `points`. Reusing it
        for every frame saves a third of the time for large arrays, because the system need not clear new memory.

    Returns
    -------
    NDArray
        Morphed points Q (N, 3) in the type of `points`. For float32 "blend" the error of a coordinate is at most half a
        float32 step of the result plus 2⁻²⁴ (6 + 3 r2/(r2−r1)) |U−O|. If U and O see a point in opposite directions
        with equal weights, the blend has no direction, and U's direction is taken. That happens only with U outside the
        near cylinder or, for points between U and O, with a strength of ½.
    """
    arguments = kernel_arguments(user, center, r1, r2, kind, strength)
    source = check.array("points", points)
    morphed = np.empty_like(source) if out is None else check.output("out", out, source)
    _core.morph(source, morphed, arguments)
    return morphed


def kernel_arguments(
    user: ArrayLike, center: ArrayLike, r1: float, r2: float, kind: str, strength: float = 1.0
) -> dict[str, Any]:
    """Check user, centre, radii, kind and strength of a morph, and return them as kernel arguments.

    Both radii may be 0 for "cylinder".
    """
    check.choice("kind", kind, KINDS)
    empty = kind == "cylinder" and check.number("r1", r1) == 0.0 == check.number("r2", r2)
    inner, outer = (0.0, 0.0) if empty else check.radii(r1, r2)
    eye, middle = check.vector("user", user), check.vector("center", center)
    factor = check.in_range("strength", strength, 0.0, 1.0)
    return {"user": eye, "center": middle, "r1": inner, "r2": outer, "kind": kind, "strength": factor}
