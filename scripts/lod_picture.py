"""Makes the picture of levels of detail in docs/: the levels, their score curves, and the triangles drawn by mode.

The object is Khronos' FlightHelmet (CC0), the headset a Rift S as Liebisch (2021) describes it.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np
import trimesh

import nearfar as nf
from nearfar._base import data

RATIOS = (0.5, 0.25, 0.12, 0.06, 0.03)
SIZE, LENS = nf.hmd.RIFT_S.render_size, nf.RadialLens((0.22, 0.24))
FOV = nf.Fov.symmetric(87, np.tan(np.radians(87 / 2)) / np.tan(np.radians(90 / 2)))
COUNT, BALL, ACROSS = 500, 10.0, 1.0
FRAMES = 360
COLORS: dict[Any, str] = {"depth": "#555555", "depth+eccentricity": "#e08a1e", "fovea": "#c8102e"}


def draw_lod(path: Path) -> None:
    """Draw the levels in the upper row, their curves and the triangles by mode in the lower row."""
    mpl.use("agg")
    from matplotlib import pyplot as plt

    helmet = nf.Scene.load(data.require("objects/gltf/FlightHelmet/FlightHelmet.gltf"))
    levels = nf.lod.simplify(helmet, RATIOS, method="meshopt", normals="smooth", name="FlightHelmet")
    model = nf.lod.measure(levels, fov=FOV, size=SIZE)
    figure = plt.figure(figsize=(13.3, 7.6), layout="constrained")
    upper, lower = figure.subfigures(2, 1, height_ratios=(1, 1.3))
    _draw_levels(model, upper.subplots(1, len(model)))
    curves, turn = lower.subplots(1, 2)
    _draw_curves(model, curves)
    _draw_turn(model, turn)
    figure.savefig(path, dpi=90)
    plt.close(figure)


def _draw_levels(model: nf.lod.LodModel, axes: Any) -> None:
    """Draw all levels from one side, with the maximum size at which each is good enough."""
    switch = nf.lod.switches(model, view=FOV)
    direction = np.array([0.55, 0.3, 1.0])
    eye = model.center + 3.2 * model.radius * direction / np.linalg.norm(direction)
    camera = nf.Camera.look_at(eye, model.center, fov=nf.Fov.symmetric(37), size=(360, 360))
    coarser = np.append(np.minimum.accumulate(switch.distance[::-1])[-2::-1], np.inf)
    starts = [f"from {distance * ACROSS / 2:.1f} m on" for distance in switch.distance]
    titles = np.where(switch.distance < coarser, starts, "unused")
    titles[0] = "the object"
    for axis, level, text in zip(axes, model.levels or (), titles, strict=True):
        axis.imshow(nf.render(level.scene, camera, samples=16, channels=("color",)).to_image())
        axis.set_title(f"{level.triangle_count:,} triangles, {text}", fontsize=10)
        axis.axis("off")


def _draw_curves(model: nf.lod.LodModel, axis: Any) -> None:
    """Draw the score curves with the sufficient score."""
    model.plot(axis)
    sigma = np.geomspace(*model.sigma, 200)
    axis.plot(sigma, nf.lod.LodThreshold()(sigma, nf.lod.reference_solid_angle(FOV)), "k--", label="threshold f(σ)")
    axis.legend(title="triangles")
    views = model.measured["views"]
    axis.set(title=f"SSIM of {views} views, 25th percentile", xlabel="solid angle, sr")
    axis.grid(alpha=0.3)


def _draw_turn(model: nf.lod.LodModel, axis: Any) -> None:
    """Draw the triangles of randomly placed objects in the view of an eye in their middle."""
    random = np.random.default_rng(0)
    directions = random.normal(size=(COUNT, 3))
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    places = BALL * directions * random.random((COUNT, 1)) ** (1 / 3)
    sizes = np.full(COUNT, ACROSS / 2)
    frames = np.array([trimesh.transformations.random_rotation_matrix(random.random(3)) for _ in range(COUNT)])
    frames[:, :3, :3] *= ACROSS / 2 / model.radius
    frames[:, :3, 3] = places - frames[:, :3, :3] @ model.center
    scene = nf.lod.place([model], np.zeros(COUNT, np.int64), frames)
    objects = scene.leveled
    if objects is None:
        raise RuntimeError("expected objects with levels")
    drawn: dict[str, list[int]] = {"level 0 of all": [], **{mode: [] for mode in COLORS}}
    yaws = np.linspace(0, 360, FRAMES, endpoint=False)
    for yaw in np.radians(yaws):
        camera = nf.Camera((0, 0, 0), (0, np.sin(yaw / 2), 0, np.cos(yaw / 2)), fov=FOV, size=SIZE)
        levels = np.zeros(COUNT, np.int32)
        for mode in COLORS:
            levels = nf.lod.select(
                [model], objects.model_index, objects.centers, sizes, camera=camera, lens=LENS, mode=mode
            ).level
            drawn[mode].append(int(model.triangles[levels[levels >= 0]].sum()))
        drawn["level 0 of all"].append(int(model.triangles[0] * np.count_nonzero(levels >= 0)))
    for name, counts in drawn.items():
        label = f"{name}: {np.mean(counts):,.0f}"
        axis.semilogy(yaws, counts, color=COLORS.get(name, "#1f5fa8"), label=label)
        print(f"{label} triangles in view on average")
    axis.set(
        title=f"{COUNT} of these, {ACROSS:g} m across, in a ball of {BALL:g} m about the eye",
        xlabel="yaw, degrees",
        ylabel="triangles in view",
    )
    axis.legend(title="levels by: mean of the turn", loc="upper center", bbox_to_anchor=(0.5, 0.8), ncols=2)
    axis.grid(alpha=0.3)
