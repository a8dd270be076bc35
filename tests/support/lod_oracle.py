"""Slow selection of levels by the published formulas: one object at a time in 40 digits, or all by NumPy."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import mpmath
import numpy as np
from mpmath import mpf
from numpy.typing import NDArray

import nearfar as nf

Array = NDArray[np.float64]


def curves(rows: Sequence[Sequence[float]]) -> nf.lod.Curve4PL:
    """Make curves of parameters; NaN for those that could not be fitted."""
    a, b, c, d = np.array(rows, np.float64).reshape(-1, 4).T
    status = np.where(np.isnan(a), "unfittable", np.where(a == d, "flat", "fitted"))
    return nf.lod.Curve4PL(a, b, c, d, 0 * a, status, np.full(len(a), ""))


def model(
    rows: Sequence[Sequence[float]], sigma: tuple[float, float] = (1e-4, 0.18), pixel: float | None = None
) -> nf.lod.LodModel:
    """A model of these curves."""
    count = len(rows) + 1
    return nf.lod.LodModel(
        triangles=np.geomspace(1e5, 1e2, count).astype(np.int64),
        curves=curves(rows),
        center=np.zeros(3),
        radius=1.0,
        sigma=sigma,
        errors=np.zeros(count),
        pixel=pixel,
    )


def usual(count: int = 7, seed: int | None = None) -> nf.lod.LodModel:
    """Typical curves, coarser ones below finer ones; with a seed they vary and cross."""
    random = np.random.default_rng(seed)
    share = np.linspace(0, 1, count) if count > 1 else np.zeros(count)
    rows = np.stack([1 - 0.03 * share, np.ones(count), 0.3 * 0.005**share, 0.6 - 0.5 * share], axis=1)
    if seed is not None:
        rows *= random.uniform(0.85, 1.15, rows.shape) * np.array([1, 1, 2, 1])
        rows[:, 0] = np.minimum(rows[:, 0], 1)
    return model(rows.tolist())


def rotation(camera: nf.Camera) -> Array:
    """Rotation matrix whose columns are the camera's axes in world coordinates."""
    x, y, z, w = camera.orientation
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )


def score(row: Sequence[float], x: Any) -> Any:
    """y = d + (a − d)/(1 + (x/c)^b)."""
    a, b, c, d = (mpf(float(value)) for value in row)
    return d + (a - d) / (1 + (x / c) ** b)


def line(threshold: str, k: float, d: float, reference: float, sigma: Any) -> Any:
    """Threshold f(σ) of the three kinds."""
    if threshold == "literal":
        return k * sigma + d
    return d + (k * (sigma - mpf(0.209)) if threshold == "anchored" else k * (sigma / reference - 1))


def size(
    center: Array, radius: float, camera: nf.Camera, lens: nf.RadialLens | None, tan_omega: float, kind: str = "axis"
) -> tuple[Any, Any, Any]:
    """Exact σ, σ′ and μ by 40 digits; the lens's inverse by bisection. σ′ is of the kind "axis", "area" or "panel"."""
    position = [mpf(float(c)) - mpf(float(e)) for c, e in zip(center, camera.position, strict=True)]
    distance = mpmath.sqrt(sum(v * v for v in position))
    if distance <= radius:
        return 4 * mpmath.pi, 4 * mpmath.pi, mpmath.pi
    mu = mpmath.asin(mpf(radius) / distance)
    sigma = 2 * mpmath.pi * (1 - mpmath.cos(mu))
    ahead = -sum(mpf(float(a)) * v for a, v in zip(rotation(camera)[:, 2], position, strict=True))
    alpha = mpmath.acos(ahead / distance)
    coefficients = () if lens is None else lens.k

    def value(r: Any) -> Any:
        return r + sum(mpf(c) * r ** (2 * n + 3) for n, c in enumerate(coefficients))

    def displayed_tangent(angle: Any) -> Any:
        x = mpmath.tan(angle) / tan_omega
        low, high = mpf(0), min(mpf(math.inf if lens is None else lens.r_max), abs(x) * 8 + 1)
        if value(high) < abs(x):
            return None
        for _ in range(90):
            middle = (low + high) / 2
            low, high = (middle, high) if value(middle) < abs(x) else (low, middle)
        return mpmath.atan(tan_omega * low) * mpmath.sign(x)

    if kind == "panel":
        assert isinstance(camera.fov, nf.Fov)
        left, right, down, up = (abs(side) for side in camera.fov._sides)
        corner = mpmath.hypot(max(left, right), max(down, up))
        tangent = min(mpmath.tan(alpha), corner) if alpha < mpmath.pi / 2 else corner
        angle = displayed_tangent(mpmath.atan(tangent))
        if angle is None:
            return sigma, mpf(math.inf), mu
        r, inner = tangent / tan_omega, mpmath.tan(angle) / tan_omega
        share = inner / r if r else mpf(1)
        return sigma, sigma * share / mpmath.diff(value, inner) * mpmath.hypot(1, tangent) ** 3, mu
    if not any(coefficients) or mu == 0 or alpha + mu >= mpmath.pi / 2:
        return sigma, sigma, mu
    far, near = displayed_tangent(alpha + mu), displayed_tangent(alpha - mu)
    if far is None or near is None:
        return sigma, sigma, mu
    around = mpmath.sin(displayed_tangent(alpha)) / mpmath.sin(alpha) if kind == "area" and alpha else mpf(1)
    return sigma, sigma * (far - near) / (2 * mu) * around, mu


def choose_level(
    model: nf.lod.LodModel,
    center: Array,
    radius: float,
    camera: nf.Camera,
    *,
    lens: nf.RadialLens | None = None,
    k: float = 0.27,
    d: float = 0.9,
    threshold: str = "anchored",
    fovea: tuple[float, float] | None = None,
    gaze: Array | None = None,
    kind: str = "axis",
    limit: str = "seen",
) -> tuple[int, float]:
    """Level of an object regardless of visibility, and how close the decision was."""
    with mpmath.workdps(40):
        fov = camera.fov
        assert isinstance(fov, nf.Fov)
        tan_omega = max(abs(fov.left), abs(fov.right))
        reference = 2 * mpmath.pi * (1 - mpmath.cos(mpmath.asin(mpf(tan_omega) / 4)))
        sigma, seen, mu = size(center, radius, camera, lens, tan_omega, kind)
        if fovea is not None and mu < mpmath.pi:
            slope, least_angle = fovea
            look = -rotation(camera)[:, 2] if gaze is None else gaze
            way = center - np.array(camera.position)
            cosine = float(way @ look / np.linalg.norm(way) / np.linalg.norm(look))
            away = max(0.0, math.degrees(math.acos(max(-1.0, min(1.0, cosine))) - float(mu)))
            pitch = max((fov.right - fov.left) / camera.width, (fov.up - fov.down) / camera.height)
            best = max(least_angle, math.degrees(math.atan(pitch)))
            seen = seen * min(1.0, best / (slope * away + least_angle)) ** 2
        least, greatest = model.sigma
        read: Any = seen * pixel_area(model, camera, lens if kind == "panel" else None, tan_omega)
        limited: Any = seen if limit == "seen" else sigma
        near = min(abs(float(limited / reference - 1)), abs(float(read / greatest - 1)))
        if len(model) == 1 or limited > reference or read > greatest or mu == mpmath.pi:
            return 0, near
        wanted = line(threshold, k, d, reference, sigma)
        level = 0
        for number in range(1, len(model)):
            row = [float(values[number - 1]) for values in model.curves]
            if not any(math.isnan(value) for value in row):
                # The least score at this size and all smaller ones: curves only fall or only rise.
                reached = min(score(row, max(read, mpf(least))), score(row, mpf(least)))
                near = min(near, abs(float(reached - wanted)))
                level = number if reached >= wanted else level
        return level, near


def pixel_area(model: nf.lod.LodModel, camera: nf.Camera, panel: nf.RadialLens | None, tan_omega: float) -> float:
    """Area of the model's pixels as a multiple of the camera's, or of a panel's behind a lens, if there is one."""
    if model.pixel is None:
        return 1.0
    assert isinstance(camera.fov, nf.Fov)
    sides = np.array(camera.fov._sides)
    if panel is not None:
        radii = panel.undistort(sides / tan_omega, outside="nan")
        # Beyond the fold nothing is shown.
        sides = tan_omega * np.where(np.isnan(radii), np.sign(sides) * panel.r_max, radii)
    left, right, down, up = sides
    return float(model.pixel**2 * camera.width / (right - left) * camera.height / (up - down))


def distance_to_view(points: Array, fov: nf.Fov) -> Array:
    """Nothing is shown beyond the fold."""
    from scipy.optimize import nnls

    corners = [(x, y, -1.0) for x in (fov.left, fov.right) for y in (fov.down, fov.up)]
    rays = np.array(corners).T
    return np.array([nnls(rays, point)[1] for point in points])


def random_spheres(count: int, seed: int, camera: nf.Camera, spread: float = 1.1) -> tuple[Array, Array]:
    """Spheres of very different sizes in front of an eye, some outside of its view."""
    random = np.random.default_rng(seed)
    x, y = random.uniform(-spread, spread, (2, count))
    ahead = np.exp(random.uniform(-1, 4, count))
    own = np.stack([x * ahead, y * ahead, -ahead], axis=1)
    radii = ahead * np.exp(random.uniform(-7, -0.5, count))
    return own @ rotation(camera).T + camera.position, radii
