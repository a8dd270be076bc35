"""Occlusion-free ray bending, which inverts the morph for each pixel, and the distance at which the picture folds."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check, progress
from nearfar._morph import KINDS, kernel_arguments


def bend_rays(
    directions: ArrayLike,
    *,
    user: ArrayLike,
    center: ArrayLike,
    r1: float,
    r2: float,
    tolerance: float,
    kind: str = "blend",
    strength: float = 1.0,
) -> NDArray[np.float64]:
    """Compute bent rays: for each direction the curve of all points that the morph shows there, as a polyline.

    `morph` moves every point of the curve onto the straight ray from the user's eye in that direction. The curve leaves
    the eye in the given direction, bends between the radii, and ends at `r2` on the parallel ray from the centre, along
    which the far part is seen. Tracing these curves through the unmorphed scene renders the morphed picture pixel by
    pixel.

    ValueError for directions of length 0, radii or strengths out of range, and a tolerance below 1e-9; TypeError for
    values that are not numbers. Source: the inverse of Eq. 1 of Popescu, Lee, Choi, Fahmy (2022), and of Alg. 1 of
    CloVR (2024).

    Parameters
    ----------
    directions
        (N, 3), of any length above zero.
    user, center
        The user's eye U and the centre O, metres.
    r1, r2, kind, strength
        As in `morph`; the curves are the same for both kinds.
    tolerance
        Greatest angle in radians, seen from U, between a chord of the polyline and its curve; at least 1e-9, which
        needs about a thousand points for each ray. A chord is tested beside its start, at its middle and at the
        middles of its halves and quarters, with a `strength` below 1 also beside its end and at finer divisions.

    Returns
    -------
    NDArray
        (N, K, 3) float64, metres: the points of each polyline, padded with NaN. The last segment continues along the
        direction to infinity. The first point is U if U is within `r1`; else it is the start of the curve, which is O
        if the weight of U's view is below ½ there. A ray that does not bend has one point: a ray straight up, a
        ray along the line through U and O, and every ray if U = O. `morph` shows each point in its direction to 1e-9
        radians.
    """
    arguments, angle = kernel_arguments(user, center, r1, r2, kind, strength), check.positive("tolerance", tolerance)
    rays = np.ascontiguousarray(check.array("directions", directions), np.float64)
    with progress.bar("bending rays") as report:
        points, max_points = _core.bend_rays(rays, arguments, tolerance=angle, report=report)
    return points.reshape(len(rays), max_points, 3)


def fold_margin(
    user: ArrayLike, *, center: ArrayLike, r1: float, r2: float, kind: str = "blend", strength: float = 1.0
) -> float:
    """Compute the distance that the user may still walk away from the centre before the picture folds.

    A picture folds where the Jacobian of the morph changes its sign, so that neighbouring points change sides. In a
    picture without folds each direction shows a single curve, and no point is seen twice. ValueError and TypeError for
    kinds, radii, strengths and positions that `morph` rejects. Source: Eq. 1–3 of Popescu, Lee, Choi, Fahmy (2022).

    Parameters
    ----------
    user, center
        The user's eye U and the centre O, metres.
    r1, r2, kind, strength
        As in `morph`; here the radii are above 0.

    Returns
    -------
    float
        Horizontal distance in metres at the user's present height, exact to 1e-4 (r2 − r1). Negative if the picture
        folds already; −inf if at this height it folds even on the axis; infinite for strength s = 0. For "blend" about
        0.95 (r2 − r1)/s at the centre's height and less above and below it, but for s > ½ at most the greater of r1 and
        (2 r2 − (r2 − r1)/s)/3, where points next to the user fold. For "cylinder" r1 − |(U−O)ₕ|, where ₕ denotes the
        horizontal part, as long as s > (r2 − r1)/r1.
    """
    check.choice("kind", kind, KINDS)
    check.radii(r1, r2)  # unlike the morph, "cylinder" needs r2 > 0 here
    return _core.fold_margin(kernel_arguments(user, center, r1, r2, kind, strength))
