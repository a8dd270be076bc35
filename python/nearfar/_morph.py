"""The morph that joins near geometry, seen from the user's eye, to an environment seen from the centre."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check

KINDS = ("blend", "cylinder")


def morph(
    points: ArrayLike,
    *,
    user: ArrayLike,
    center: ArrayLike,
    r1: float,
    r2: float,
    kind: str = "blend",
    out: NDArray[Any] | None = None,
) -> NDArray[Any]:
    """Show points where a continuous near–far partition shows them.

    With ρ the distance from the vertical axis through the centre, points at ρ ≤ `r1` stay, bit for bit; those
    beyond `r2` are shown in the direction in which the centre sees them; in between both are blended,
    so that the picture has no seam at either radius.

    Parameters
    ----------
    points
        (N, 3), metres. float32 and float64 are kept, other numbers become float64. A point with NaN gives NaN.
    user
        The user's eye U, metres, in the points' frame.
    center
        The centre O, on the axis of both cylinders.
    r1, r2
        Radii in metres, 0 ≤ r1 < r2. For "cylinder", r1 is the radius of the near subregion (0.7 of r2 as published)
        and r2 that of the cylinder; both 0 stand for no near geometry at all.
    kind
        "blend": at the blend of the distances from user and centre; beyond r2 points are U + P − O, rounded once.
        "cylinder": where the blended direction leaves the vertical cylinder on which the point lies, or as "blend"
        where it doesn't (the user stands outside that cylinder, or looks straight up).
    out
        Where to write: a C-contiguous array of the shape and type of the result that shares no memory with `points`.
        Frame after frame it saves the system's clearing of new memory, a third of the time for large arrays.

    Returns
    -------
    NDArray
        (N, 3) in the type of `points`. For float32 "blend" a coordinate is off by half a float32 step of the result and
        2⁻²⁴ (6 + 3 r2/(r2−r1)) |U−O| at most. Where user and centre see a point in opposite directions, which only
        happens once the user has left the near cylinder, the blend has no direction and the user's is taken.

    Raises
    ------
    ValueError
        For other shapes and kinds, radii out of order, a user or centre that is not finite, and an `out` that does not
        fit.
    TypeError
        For values that are not numbers.

    References
    ----------
    Popescu, Lee, Choi, Fahmy (2022), Eq. 1–3; CloVR (2024), Alg. 1, with the brackets that its w lacks.
    """
    check.choice("kind", kind, KINDS)
    near, far = radii_of(r1, r2, kind)
    given = check.array("points", points)
    shown = np.empty_like(given) if out is None else check.output("out", out, given)
    _core.morph(
        given,
        shown,
        user=check.vector("user", user),
        center=check.vector("center", center),
        r1=near,
        r2=far,
        kind=kind,
    )
    return shown


def radii_of(r1: float, r2: float, kind: str) -> tuple[float, float]:
    """Radii as floats; both may be 0 for "cylinder"."""
    if kind == "cylinder" and check.number("r1", r1) == 0.0 == check.number("r2", r2):
        return 0.0, 0.0
    return check.radii(r1, r2)
