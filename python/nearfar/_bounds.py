"""Bounding spheres of points, smallest and approximate, and the solid angles of spheres."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check, progress

METHODS = ("exact", "ritter", "average", "minmax", "best")
"""Names of the methods that `bounding_sphere` describes."""


def bounding_sphere(points: ArrayLike, *, method: str = "exact") -> tuple[NDArray[np.float64], float]:
    """Compute a sphere that encloses points.

    ValueError for no points, other shapes, coordinates that are not finite; TypeError for values that are not numbers.
    Sources: "exact": Gärtner (1999), which adds the farthest point until none lies outside; "ritter": Ritter (1990);
    "best": Liebisch (2021).

    Parameters
    ----------
    points
        (N, 3), at least one, in any unit. float32 and float64 are read without conversion, other numbers become
        float64; everything is computed in float64.
    method
        "exact": the smallest sphere. "average": centred at the mean of the points. "minmax": centred at the middle of
        their box. "best": the smaller of "average" and "minmax". "ritter": starts with two distant points and grows to
        include each point that lies outside.

    Returns
    -------
    (NDArray, float)
        Centre (3,) float64 and radius, in the points' unit. No point lies outside by more than 4 units in the last
        place of the radius. For "exact" the radius exceeds the smallest possible one by at most a share of 1e-12, plus
        the error of rounding the centre to float64: 1e-16 of the points' distance from zero. The bits are the same for
        any number of threads.
    """
    check.choice("method", method, METHODS)
    *center, radius = _core.bounding_sphere(check.array("points", points), method=method)
    return np.array(center), radius


def bounding_spheres(
    points: ArrayLike, offsets: ArrayLike, *, method: str = "exact"
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Compute a sphere for each group of points, such as the objects of a scene.

    Returns centres (K, 3) and radii (K,), float64, as `bounding_sphere` computes them for each group. Errors as in
    `bounding_sphere`, and for offsets that do not ascend or exceed the number of points.

    Parameters
    ----------
    points, method
        As in `bounding_sphere`.
    offsets
        (K + 1,) ascending whole numbers: group k is `points[offsets[k]:offsets[k + 1]]`, with at least one point.
    """
    check.choice("method", method, METHODS)
    numbers = check.array("offsets", offsets, columns=None, dtype=np.int64)
    if numbers.ndim != 1 or not len(numbers):
        raise ValueError(f"offsets: expected shape (K + 1,), got {numbers.shape}")
    with progress.bar("bounding") as report:
        rows = _core.bounding_spheres(check.array("points", points), numbers, method=method, report=report)
    spheres = np.array(rows, np.float64).reshape(-1, 4)
    return spheres[:, :3].copy(), spheres[:, 3].copy()


def solid_angle(centers: ArrayLike, radii: ArrayLike, *, eye: ArrayLike) -> NDArray[np.float64]:
    """Compute the solid angles of spheres seen from an eye.

    ValueError and TypeError for other shapes, numbers that are not finite, and radii below 0. Source: Liebisch (2021),
    Sec. 4.3.

    Parameters
    ----------
    centers
        Centres (N, 3), metres.
    radii
        Radii (N,), or one for all spheres, metres, at least 0.
    eye
        Position (3,), metres.

    Returns
    -------
    NDArray
        (N,) float64, steradians: σ = 2π (1 − cos μ), where μ = asin(radius / distance). The relative error is a few
        units in the last place divided by cos μ, however small the sphere is: near the surface cos μ is small, and σ
        depends on the last digits of the distance. σ is 4π if the eye is inside the sphere or on it.
    """
    return _core.solid_angles(*check.spheres(centers, radii), check.vector("eye", eye))
