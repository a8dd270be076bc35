"""Relighting: the splats of one cut shaded by three lights, against ray-traced truth in the same lights.

Views contain normals, and colours without light. A client that has drawn normals, colours and distances can
thus shade its picture by any light without further data. By day it uses the formula of `nf.render`; at night it adds
lamps that cast no shadows.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import KDTree

import nearfar as nf
from benchmarks.harness.pictures import Picture, average, similarity
from benchmarks.harness.report import folder_or_temporary, start, table
from benchmarks.harness.timing import timed
from benchmarks.orthoview import _sheets
from benchmarks.orthoview._worlds import World
from nearfar.orthoview._gaussians import SUN

BLOCKS, SIDE, CELL = 8, 640.0, 80.0
"""Blocks and side of the city, and side of leaves; metres."""
DIRECTIONS = 13
"""Number of directions that `directions="auto"` chooses for streets along the axes."""
EYE, TARGET = (330.0, 120.0, 420.0), (0.0, 0.0, 40.0)
SIZE = (420, 315)
GRID = 3
"""Samples along each axis of a pixel."""
CHANNELS = ("albedo", "shading_normal", "position")
LAMP_HEAD = (0.0, 6.9, 1.85)
"""Position of a lamp's light relative to its foot, metres."""
LAMPS, MAX_LAMP_DISTANCE = 12, 60.0
"""Number of nearest lamps that light a point, and their maximum distance in metres."""

Floats = NDArray[np.float32]


@dataclass(frozen=True)
class Light:
    """Light of a world: a sky of two colours, a sun, and lamps in the scene."""

    name: str
    sky: tuple[tuple[float, float, float], tuple[float, float, float]]
    """Light on surfaces that face away from the brightest sky, and towards it; linear RGB."""
    sun: tuple[float, float, float]
    toward: tuple[float, float, float]
    """Direction of the sun."""
    background: tuple[tuple[float, float, float], ...]
    """Colours at the nadir, the horizon and the zenith."""
    lamp: tuple[float, float, float] = (0.0, 0.0, 0.0)
    """Colour of a lamp's light at a distance of 1 m."""


BRIGHTEST = (-0.206_284_3, 0.928_279_1, 0.309_426_4)
"""Direction of the brightest sky."""
LIGHTS = (
    Light(
        "day",
        ((0.130, 0.135, 0.150), (0.380, 0.420, 0.480)),
        (0.60, 0.56, 0.50),
        SUN,
        ((0.24, 0.25, 0.26), (0.66, 0.74, 0.82), (0.16, 0.34, 0.66)),
    ),
    Light(
        "evening",
        ((0.060, 0.055, 0.075), (0.170, 0.160, 0.210)),
        (0.95, 0.50, 0.20),
        (-0.929, 0.279, 0.242),
        ((0.12, 0.10, 0.12), (0.86, 0.50, 0.30), (0.16, 0.20, 0.42)),
    ),
    Light(
        "night",
        ((0.006, 0.008, 0.014), (0.018, 0.024, 0.044)),
        (0.012, 0.014, 0.020),
        (0.371, 0.743, -0.557),
        ((0.004, 0.004, 0.006), (0.030, 0.034, 0.052), (0.006, 0.009, 0.022)),
        (22.0, 14.5, 7.0),
    ),
)


def main() -> None:
    options = start(__doc__, "--trees", "--out")
    city, half_side = nf.datasets.city(blocks=BLOCKS), SIDE / 2
    world = World("city", city.query, (-half_side, -4.0, -half_side), SIDE, 110.0, CELL)
    heads = lamps(city)
    fov = nf.Fov.symmetric(50, SIZE[0] / SIZE[1])
    camera = nf.Camera.look_at(EYE, TARGET, fov=fov, size=(GRID * SIZE[0], GRID * SIZE[1]))
    with folder_or_temporary(options.trees) as folder:
        tree = nf.orthoview.open(world.build(folder, DIRECTIONS))
        truth = nf.render(world.scene, camera, clip=nf.Clip(box=tree.bounds), channels=("color", *CHANNELS))
        # A pixel of a view is as wide as a pixel of the picture, not as one of its samples.
        views = tree.render(camera, error_px=GRID, channels=("color", *CHANNELS))
        read_bytes = tree._viewer.views.cache.read_bytes
        rows, pictures = [], []
        for light in LIGHTS:
            reference = shade(truth, light, heads)
            picture, timing = timed(shade, views, light, heads)
            psnr, ssim = similarity(reference, picture)
            rows.append([light.name, psnr, ssim, tree._viewer.views.cache.read_bytes - read_bytes, timing.ms])
            pictures.append((reference, picture, f"{light.name}\n{psnr:.1f} dB, SSIM {ssim:.3f}"))
        day, _ = similarity(clipped_average(truth.require("color")), shade(truth, LIGHTS[0], heads))
        print(f"{read_bytes / 1e6:.1f} MB of views are read once; {dict(views.stats)}")
        print(f"PSNR of the truth shaded here by day against the picture of nf.render: {day:.1f} dB\n")
    print(table("Relighting", "light | PSNR, dB {:.1f} | SSIM {:.3f} | bytes read | shading, ms {:.0f}", rows))
    if options.out is not None:
        panels = [(f"truth, {light.name}", pictures[n][0]) for n, light in enumerate(LIGHTS)]
        panels += [(f"orthoviews, {title}", picture) for _, picture, title in pictures]
        _sheets.save_panels(panels, len(LIGHTS), options.out / "orthoview_lights.jpg")


def lamps(city: nf.Scene) -> NDArray[np.float64]:
    """World positions (N, 3) of the lights of the city's lamps."""
    names = [name for name in city.object_names if name.startswith("lamp_post")]
    poses = city.with_dynamic(names).poses
    return np.array([poses[name][:3, :3] @ LAMP_HEAD + poses[name][:3, 3] for name in names])


def shade(frame: nf.Frame, light: Light, heads: NDArray[np.float64]) -> NDArray[np.uint8]:
    """Shade a frame's surfaces by a light, sRGB, one pixel for GRID × GRID samples."""
    _, rays = frame.camera.rays()
    linear = background(rays.astype(np.float32), light)
    normal, position = frame.require("shading_normal"), frame.require("position") + np.array(frame.origin)
    is_surface = np.isfinite(normal).all(axis=-1)
    n, points = normal[is_surface], position[is_surface]
    darkest, brightest = np.array(light.sky, np.float32)
    sky_weight = 0.5 + 0.5 * (n @ np.array(BRIGHTEST, np.float32))[:, None]
    bright = darkest + (brightest - darkest) * sky_weight
    bright += np.array(light.sun, np.float32) * np.maximum(n @ np.array(light.toward, np.float32), 0)[:, None]
    if any(light.lamp):
        bright += np.array(light.lamp, np.float32) * from_lamps(points, n, heads)[:, None]
    linear[is_surface] = frame.require("albedo")[is_surface] * bright
    return clipped_average(linear)


def from_lamps(points: NDArray[np.float64], normals: Floats, heads: NDArray[np.float64]) -> Floats:
    """Light of the nearest lamps, which decreases with the square of the distance."""
    distance, lamp = KDTree(heads).query(points, LAMPS, distance_upper_bound=MAX_LAMP_DISTANCE)
    total = np.zeros(len(points), np.float32)
    for distances, number in zip(distance.T, lamp.T, strict=True):
        lit = np.isfinite(distances)
        ray = (heads[number[lit]] - points[lit]) / distances[lit, None]
        total[lit] += np.maximum((ray * normals[lit]).sum(axis=1), 0) / (1 + distances[lit] ** 2)
    return total


def background(rays: Floats, light: Light) -> Floats:
    """Sky along rays (H, W, 3), as in `nf.render`."""
    nadir, horizon, zenith = np.array(light.background, np.float32)
    end = np.where(rays[..., 1:2] < 0, nadir, zenith)
    return np.asarray(horizon + (end - horizon) * np.sqrt(np.abs(rays[..., 1:2])))


def clipped_average(linear: Floats) -> Picture:
    """Clip samples to 1 and average those of each pixel, as sRGB."""
    return average(np.minimum(linear, 1), GRID)


if __name__ == "__main__":
    main()
