"""Spheres about points: the smallest one, and cheaper ones that are larger; how much of the sight they take."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check, progress

METHODS = ("exact", "ritter", "average", "minmax", "best")


def bounding_sphere(points: ArrayLike, *, method: str = "exact") -> tuple[NDArray[np.float64], float]:
    """Sphere about points.

    Parameters
    ----------
    points
        (N, 3), at least one, in any unit. float32 and float64 are read as they are, other numbers become float64;
        everything is computed in float64.
    method
        "exact": the smallest sphere. "average": about the mean of the points. "minmax": about the middle of their box.
        "best": the smaller of these two. "ritter": about two far points, widened to each one that lies outside.

    Returns
    -------
    (NDArray, float)
        Centre (3,) float64 and radius, in the points' unit. No point lies outside by more than 4 units in the last
        place of the radius. For "exact" the radius is within 1e-12 of the least there is, as a share, and what rounding
        the centre to float64 costs: 1e-16 of the points' distance from zero. The same bits for any number of threads.

    Raises
    ------
    ValueError
        For no points, other shapes, coordinates that are not finite.
    TypeError
        For values that are not numbers.

    References
    ----------
    Gärtner (1999): the farthest point is added until none lies outside. Ritter (1990). "best" is that of
    Liebisch (2021).
    """
    check.choice("method", method, METHODS)
    *center, radius = _core.bounding_sphere(check.array("points", points), method=method)
    return np.array(center), radius


def bounding_spheres(
    points: ArrayLike, offsets: ArrayLike, *, method: str = "exact"
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Spheres about groups of points, such as the objects of a scene.

    Parameters
    ----------
    points, method
        As in `bounding_sphere`.
    offsets
        (K + 1,) whole numbers that rise: group k is `points[offsets[k]:offsets[k + 1]]`, with at least one point.

    Returns
    -------
    (NDArray, NDArray)
        Centres (K, 3) and radii (K,), float64, as `bounding_sphere` of each group.

    Raises
    ------
    ValueError, TypeError
        As in `bounding_sphere`, and for offsets that do not rise or lead beyond the points.
    """
    check.choice("method", method, METHODS)
    numbers = check.array("offsets", offsets, columns=None, dtype=np.int64)
    if numbers.ndim != 1 or not len(numbers):
        raise ValueError(f"offsets: expected shape (K + 1,), got {numbers.shape}")
    with progress.bar("bounding") as report:
        rows = _core.bounding_spheres(check.array("points", points), numbers, method=method, report=report)
    found = np.array(rows, np.float64).reshape(-1, 4)
    return found[:, :3].copy(), found[:, 3].copy()


def solid_angle(centers: ArrayLike, radii: ArrayLike, *, eye: ArrayLike) -> NDArray[np.float64]:
    """Solid angles that spheres take of the sight from an eye.

    Parameters
    ----------
    centers
        (N, 3), metres.
    radii
        (N,) or one, metres, at least 0.
    eye
        Three numbers, metres.

    Returns
    -------
    NDArray
        (N,) float64, steradians: σ = 2π (1 − cos μ) with μ = asin(radius / distance), to a few units in the last place
        however small the sphere is, over cos μ: beside the surface σ hangs on the last digits of the distance. 4π where
        the eye is in the sphere or on it.

    Raises
    ------
    ValueError, TypeError
        For other shapes, numbers that are not finite, and radii below 0.

    References
    ----------
    Liebisch (2021), Sec. 4.3.
    """
    return _core.solid_angles(*check.spheres(centers, radii), check.vector("eye", eye))
