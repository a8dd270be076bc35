"""Plans the regions of a walk: a grid of centres for a path or an area, their heights and their radii."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import SupportsFloat, Unpack, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check
from nearfar._base.settings import gather, split
from nearfar._impostor.settings import ImpostorSettings
from nearfar._partition.load_curve import load_curve
from nearfar._reduce.baking import MapKeywords, MapSettings
from nearfar._reduce.choose_radii import Radii, RadiusKeywords, RadiusSettings, choose_radii, complete_settings
from nearfar._reduce.drawing import MORPHS, MorphKind
from nearfar._reduce.reduce import FAR_PARTS, FarPart, check_unmorphed
from nearfar._reduce.walk.folds import height_differences, walkable_distance
from nearfar._reduce.walk.grid import Grid, grids
from nearfar._reduce.walk.regions import Regions, check_hysteresis, check_keep, spacing_for
from nearfar._scene.scene import Scene, core_of
from nearfar._trace.rays import surface_heights

Floats = NDArray[np.float64]

MAX_REGIONS = 100_000
"""Approximate maximum number of regions of a walk."""

MAX_CORNERS = 1000
"""Maximum number of corners of an area."""

_RINGS = ((6, 0.5), (12, 0.95))
"""Rings of vertical rays around a centre: their number, and their distance as a share of the cell's radius."""


class RegionOptions(RadiusKeywords, MapKeywords, total=False):
    """Keywords of `regions`."""

    height: float | None
    error_px: float
    centers: int
    missing: float
    triangles: int | None
    bytes: int | None
    visible: bool


def regions(
    scene: Scene,
    path: ArrayLike | None = None,
    *,
    area: ArrayLike | None = None,
    hysteresis: SupportsFloat = 1.0,
    far: FarPart = "map",
    morph: MorphKind = "blend",
    keep: int = 3,
    radii: RadiusSettings | None = None,
    settings: MapSettings | ImpostorSettings | None = None,
    **keywords: Unpack[RegionOptions],
) -> Regions:
    """Divide a walk into regions, each with a centre from which it is reduced, so that no picture folds on the way.

    The centres lie on a hexagonal grid with the spacing √3 (R − b), so that every place is within R − b of one; R is
    `reach` and b `hysteresis`. Only cells that the path visits or that overlap the area get a centre. The grid is tried
    in several directions, and the one with the fewest cells is used. Nothing is baked yet. Returns the centre and radii
    of each region, and its reduced scene on demand. ValueError for neither or both of `path` and `area`; a reach that
    is not less than r2; a path or area that leaves the scene's bounds; pictures that would fold within `reach`, because
    r2 is too small or the path climbs too much within a region; or more than about a hundred thousand regions.
    TypeError for values of other types. Source: the hexagonal grid is the thinnest covering of the plane by equal discs
    (Kershner 1939).

    Parameters
    ----------
    scene
        The scene; its triangles count for a `budget`.
    path
        (N, 3) world positions of the eye, metres; the user walks straight from each to the next.
    area
        Instead of a path: (N, 2) x and z of the corners of a polygon on the ground, metres; two corners stand for a
        rectangle. Vertical rays find the ground, so below a roof a path is needed instead.
    hysteresis
        Least distance b in metres that a user walks between two changes of region, 0 ≤ b < R.
    far
        As in `reduce`. With "impostors" no picture folds, at any height, and changes of regions are hardly seen.
    morph
        As in `reduce`, for maps. "cylinder" suits users who stay at the height of the centre.
    keep
        Number of reduced scenes to cache, at least 3: the present, the previous and the next one.
    radii
        Requirements on the radii, as `RadiusSettings`; all regions have the same radii. `reach` is the greatest
        distance R of a user from the centre of their region, less than r2. A `budget` is met around every centre. With
        a path, which has the eye's heights, `eye_height` only affects the shear of the ground.
    settings
        Size, samples, channels and backend of the maps, as `MapSettings`; or `ImpostorSettings`, whose `reach` is that
        of the radii, or more where the path climbs.
    keywords
        Fields of `radii` and `settings`, which they replace: `r2`, `budget`, `reach`, `eye_height`, `shear`,
        `face_size`, and `samples`, `channels`, `range_dtype`, `backend` of maps, or `height`, `error_px`, `centers`,
        `missing`, `triangles`, `bytes`, `visible` of impostors.
    """
    core_of(scene)
    if (path is None) == (area is None):
        raise ValueError(f"path: expected either path or area, got {'neither' if path is None else 'both'}")
    other_keywords, radius_keywords = split(RadiusSettings, keywords)
    has_impostors = check.choice("far", far, FAR_PARTS) == "impostors"
    baking: MapSettings | ImpostorSettings
    if has_impostors:
        check_unmorphed(morph=(morph, "blend"))
        baking = gather(ImpostorSettings, cast("ImpostorSettings | None", settings), other_keywords)
    else:
        baking = gather(MapSettings, cast("MapSettings | None", settings), other_keywords)
    radius_settings = complete_settings(gather(RadiusSettings, radii, radius_keywords, argument="radii"))
    reach = _check_length("reach", radius_settings.reach)
    eye_height = _check_length("eye_height", radius_settings.eye_height)
    min_walk = check_hysteresis(hysteresis, reach)
    check.choice("morph", morph, MORPHS)
    check_keep(keep)
    if radius_settings.r2 is not None and reach >= radius_settings.r2:
        raise ValueError(
            f"reach: expected less than r2 = {radius_settings.r2:g} m, where the map begins, got {reach:g}"
        )
    spacing = spacing_for(reach, min_walk)
    if path is not None:
        eyes = _check_path(scene, path)
        centers = _centers_on_path(eyes, spacing)
    else:
        centers = _centers_on_ground(scene, _check_corners(scene, area), spacing, eye_height)
    common_radii = _common_radii(scene, centers, radius_settings)
    heights = np.zeros(len(centers))
    if path is not None and np.ptp(eyes[:, 1]) > 0.0:
        heights = height_differences(eyes, centers, reach)
    if isinstance(baking, ImpostorSettings):
        radius = math.hypot(reach, float(heights.max()))
        if radius >= common_radii.r2:
            raise ValueError(
                f"path: expected eyes within r2 = {common_radii.r2:.4g} m of the centres, got a path that climbs "
                f"{heights.max():.3g} m within a region"
            )
        baking = replace(baking, reach=radius)
    elif heights.any():
        _check_heights(centers, heights, common_radii, morph)
    return Regions(scene, centers, radii=common_radii, hysteresis=min_walk, morph=morph, baking=baking, keep=keep)


def _check_length(name: str, length: float) -> float:
    """Return a length in metres; ValueError if it is too large for grids."""
    if length > check.FARTHEST:
        raise ValueError(f"{name}: expected up to {check.FARTHEST:g} m, got {length:g}")
    return length


def _check_path(scene: Scene, path: ArrayLike) -> Floats:
    """Return the positions (N, 3) of a path; ValueError if any lies outside the scene."""
    eyes: Floats = check.array("path", path, dtype=np.float64, finite=True)
    if not len(eyes):
        raise ValueError("path: expected at least one position, got none")
    _check_within("path", scene, eyes[:, [0, 2]])
    if np.abs(eyes[:, 1]).max() > check.FARTHEST:
        raise ValueError(f"path: expected heights up to {check.FARTHEST:g} m, got {np.abs(eyes[:, 1]).max():g}")
    return eyes


def _check_corners(scene: Scene, area: ArrayLike | None) -> Floats:
    """Return the corners (N, 2) of an area, N ≥ 3; ValueError if any lies outside the scene."""
    assert area is not None
    corners: Floats = check.array("area", area, columns=2, dtype=np.float64, finite=True)
    if not 2 <= len(corners) <= MAX_CORNERS:
        raise ValueError(f"area: expected 2 to {MAX_CORNERS} corners, got {len(corners)}")
    _check_within("area", scene, corners)
    if len(corners) == 2:
        (x0, z0), (x1, z1) = corners
        corners = np.array([[x0, z0], [x1, z0], [x1, z1], [x0, z1]])
    return corners


def _check_within(name: str, scene: Scene, points: Floats) -> None:
    """Raise ValueError for places (N, 2) beyond the scene's bounds."""
    low, high = scene.bounds[:, [0, 2]]
    outside_points = np.flatnonzero(((points < low) | (points > high)).any(axis=1))
    if len(outside_points):
        x, z = points[outside_points[0]]
        raise ValueError(
            f"{name}: expected places within the scene, which has x from {low[0]:.6g} to {high[0]:.6g} and z from "
            f"{low[1]:.6g} to {high[1]:.6g} m, got {len(outside_points)} outside, the first x = {x:.6g}, z = {z:.6g}"
        )


def _centers_on_path(eyes: Floats, spacing: float) -> Floats:
    """Return centres (K, 3) in the path's order, midway between the path's extreme heights in each cell."""
    ground_points = eyes[:, [0, 2]]
    _check_region_count(float(np.hypot(*np.diff(ground_points, axis=0).T).sum()) / spacing)
    candidates = [(grid, *grid.cells_of_path(eyes)) for grid in grids(ground_points, spacing)]
    grid, cells, cell_heights = min(candidates, key=lambda choice: len(choice[1]))
    points, (low, high, _) = grid.centers(cells), cell_heights.T
    return np.column_stack([points[:, 0], 0.5 * (low + high), points[:, 1]])


def _centers_on_ground(scene: Scene, corners: Floats, spacing: float, eye_height: float) -> Floats:
    """Centres (K, 3) of the cells of an area, `eye_height` metres above the ground."""
    extent = np.ptp(corners, axis=0) / spacing + 1.0
    _check_region_count(float(extent.prod()))
    candidates: list[tuple[Grid, NDArray[np.int64]]] = [
        (grid, grid.cells_of_area(corners)) for grid in grids(np.concatenate([corners, corners[:1]]), spacing)
    ]
    grid, cells = min(candidates, key=lambda choice: len(choice[1]))
    points = grid.centers(cells)
    ground = ground_heights(scene, points, spacing / math.sqrt(3.0))
    return np.column_stack([points[:, 0], ground + eye_height, points[:, 1]])


def _check_region_count(count: float) -> None:
    if not count <= MAX_REGIONS:
        raise ValueError(
            f"reach: expected reach − hysteresis large enough for at most {MAX_REGIONS:,} regions, got values that "
            f"need about {count:.2g}"
        )


def _common_radii(scene: Scene, centers: Floats, settings: RadiusSettings) -> Radii:
    """Choose radii for all centres; a `budget` is met at the centre with the densest surroundings, hence at all."""
    densest_center = centers[0]
    if (budget := settings.budget) is not None:
        densest_center = min(centers, key=lambda center: float(load_curve(scene, center=center).radius(budget)))
    radii = choose_radii(scene, densest_center, settings=settings)
    if settings.reach >= radii.r2:
        raise ValueError(
            f"reach: expected less than r2, which is {radii.r2:.4g} m for this budget, got {settings.reach:g}"
        )
    return radii


def _check_heights(centers: Floats, heights: Floats, radii: Radii, morph: str) -> None:
    """Raise ValueError if the path climbs so much within a region that its picture would fold."""
    steepest = int(np.argmax(heights))
    if walkable_distance(morph, radii.r1, radii.r2, float(heights[steepest])) < radii.reach:
        x, y, z = centers[steepest]
        raise ValueError(
            f"path: expected eyes near the height of the centre, got a path that is {heights[steepest]:.3g} m above or "
            f"below the centre at ({x:.4g}, {y:.4g}, {z:.4g}) within {radii.reach:g} m of it, where the picture would "
            "fold; use a smaller reach or a larger r2"
        )


def ground_heights(scene: Scene, centers: Floats, radius: float) -> Floats:
    """Find the ground height (K,) in metres at the centres (K, 2) as x, z of cells with a radius.

    The ground is the surface hit from above, unless it rises more steeply than 45° from surfaces that other rays hit in
    the cell. Then the centre is on a roof, a tree or a car, and the lowest of those surfaces is used. City models often
    have no ground: if a ray in the cell misses, the lowest surface hit from below is used, such as the bottom of a
    house; if all rays miss, the lowest height of the scene.
    """
    offsets = [np.zeros((1, 2))]
    for count, fraction in _RINGS:
        angles = np.arange(count) * (2.0 * np.pi / count)
        offsets.append(fraction * radius * np.column_stack([np.cos(angles), np.sin(angles)]))
    points = (centers[:, None] + np.concatenate(offsets)).reshape(-1, 2)
    shape = (len(centers), -1)
    top, bottom = (surface_heights(scene, points, from_above=is_top).reshape(shape) for is_top in (True, False))
    lowest = np.min(bottom, axis=1, initial=np.inf, where=np.isfinite(bottom))
    lowest = np.where(np.isfinite(lowest), lowest, scene.bounds[0, 1])
    misses = ~np.isfinite(top)
    heights = np.where(misses, lowest[:, None], top)
    distances = np.hypot(*np.concatenate(offsets).T)
    is_ground = ~misses[:, 0] & (heights[:, :1] - heights <= distances + 1e-3).all(axis=1)
    return np.where(is_ground, heights[:, 0], np.where(misses.any(axis=1), lowest, heights.min(axis=1)))
