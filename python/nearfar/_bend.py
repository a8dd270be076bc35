"""Bent rays: the morph per pixel, and how far the user may go before the picture folds."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check, progress
from nearfar._morph import KINDS, radii_of


def bend_rays(
    directions: ArrayLike,
    *,
    user: ArrayLike,
    center: ArrayLike,
    r1: float,
    r2: float,
    tolerance: float,
    kind: str = "blend",
) -> NDArray[np.float64]:
    """Find the curves of points that the morph shows in given directions, as polylines.

    A point of the curve is where `morph` shows it in that direction. The curve leaves the user's eye along the
    direction, bends between the radii, and ends at `r2` on the parallel ray from the centre, along which the far
    part is seen. So tracing it through the unmorphed scene draws the morph for every pixel.

    Parameters
    ----------
    directions
        (N, 3), of any length above zero.
    user, center
        The user's eye U and the centre O, metres.
    r1, r2, kind
        As in `morph`; the curves are the same for both kinds.
    tolerance
        Radians, as the user sees it, by which a chord may miss its curve; at least 1e-9, which takes some
        thousand points a ray. Chords are tried at their middle and at those of their halves and quarters.

    Returns
    -------
    NDArray
        (N, K, 3) float64, metres: the points of each polyline, padded with NaN. The last leg goes on along the
        direction. The first point is U for users within `r1`, else where the curve begins. A ray that does not bend is
        one point: straight up, along the line through U and O, and where both are one. Points are shown in their
        direction to 1e-9 radians.

    Raises
    ------
    ValueError
        For directions without a length, radii out of order, a tolerance below its least.
    TypeError
        For values that are not numbers.

    References
    ----------
    The inverse of Eq. 1 of Popescu, Lee, Choi, Fahmy (2022), and of Alg. 1 of CloVR (2024).
    """
    check.choice("kind", kind, KINDS)
    near, far = radii_of(r1, r2, kind)
    rays = np.ascontiguousarray(check.array("directions", directions), np.float64)
    with progress.bar("bending rays") as report:
        points, longest = _core.bend_rays(
            rays,
            user=check.vector("user", user),
            center=check.vector("center", center),
            r1=near,
            r2=far,
            kind=kind,
            tolerance=check.positive("tolerance", tolerance),
            report=report,
        )
    return points.reshape(len(rays), longest, 3)


def fold_margin(user: ArrayLike, *, center: ArrayLike, r1: float, r2: float, kind: str = "blend") -> float:
    """Metres that the user may still walk away from the centre before the picture folds.

    A picture folds where two neighbouring points change sides: where the Jacobian of the morph changes its sign. Up to
    there every direction shows one curve of points, and nothing is seen twice.

    Parameters
    ----------
    user, center
        The user's eye U and the centre O, metres.
    r1, r2, kind
        As in `morph`.

    Returns
    -------
    float
        Horizontal metres at the user's present height, exact to 1e-4 (r2 − r1); negative where the picture folds
        already, and −inf where at this height it folds even on the axis. For "blend" about 0.95 (r2 − r1) at the
        centre's height, and less above and below it; at most (r1 + r2) / 3, where points next to the user fold. For
        "cylinder" r1 − |(U−O)ₕ|.

    Raises
    ------
    ValueError, TypeError
        For arguments out of their domains.

    References
    ----------
    Eq. 1–3 of Popescu, Lee, Choi, Fahmy (2022).
    """
    check.choice("kind", kind, KINDS)
    near, far = check.radii(r1, r2)
    return _core.fold_margin(
        check.vector("user", user), center=check.vector("center", center), r1=near, r2=far, kind=kind
    )
