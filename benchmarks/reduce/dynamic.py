"""A car that drives from near to far: its position in each method's picture, its jumps, and its occlusion."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.report import save_figure, start, subplots, table
from nearfar._reduce.drawing import MorphKind

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

R1, R2 = 30.0, 50.0
CENTER, USER = np.array([0.0, 1.7, -4.0]), np.array([5.0, 1.7, -2.0])
CAR, MIDDLE = "car_0", np.array([0.0, 0.75, 0.0, 1.0])
SPEED, RATE, END = 50.0 / 3.6, 30.0, 80.0
"""Speed in metres per second, pictures per second, and the car's greatest distance from the centre, metres."""
METHODS = ("truth", "conventional", "continuous")
TURNS = {"left": "along the park", "right": "behind the corner house"}


def drive(turn: str, rate: float = RATE) -> Array:
    """Poses (N, 4, 4), one per picture: ahead along the avenue and around the next corner."""
    lane, side, radius = 1.7, (-1.0 if turn == "left" else 1.0), (6.0 if turn == "left" else 5.0)
    # The street's middle is at z = -66, and traffic keeps to the right.
    street = -66.0 + side * 1.6
    straight, arc = CENTER[2] - 15.0 - (street + radius), 0.5 * np.pi * radius
    metres = np.arange(0.0, 200.0, SPEED / rate)
    turned = np.clip((metres - straight) / radius, 0.0, 0.5 * np.pi)
    after_turn = np.maximum(metres - straight - arc, 0.0)
    x = lane + side * (radius * (1.0 - np.cos(turned)) + after_turn)
    z = CENTER[2] - 15.0 - np.minimum(metres, straight) - radius * np.sin(turned)
    # Cars are modelled with their front towards +z.
    heading = np.pi - side * turned
    poses = np.tile(np.eye(4), (len(metres), 1, 1))
    poses[:, 0, 0], poses[:, 0, 2] = np.cos(heading), np.sin(heading)
    poses[:, 2, 0], poses[:, 2, 2] = -np.sin(heading), np.cos(heading)
    poses[:, 0, 3], poses[:, 2, 3] = x, z
    return poses[distances(poses) < END]


def distances(poses: Array) -> Array:
    """Distances in metres from the axis to the car's middle."""
    return np.asarray(np.hypot(poses[:, 0, 3] - CENTER[0], poses[:, 2, 3] - CENTER[2]), np.float64)


def camera(width: int) -> nf.Camera:
    """A view from the user's position towards the car's way."""
    size = (width, width * 9 // 16)
    return nf.Camera.look_at(USER, USER + [-22.0, -1.0, -64.0], fov=nf.Fov.symmetric(90, 16 / 9), size=size)  # noqa: RUF005


def project_car(view: nf.Camera, poses: Array, method: str) -> Array:
    """Positions (N, 2) in pixels at which a method shows the car's middle."""
    middles = (poses @ MIDDLE)[:, :3]
    if method == "conventional":
        middles = np.where((distances(poses) <= R2)[:, None], middles, middles + USER - CENTER)
    elif method == "continuous":
        middles = nf.morph(middles, user=USER, center=CENTER, r1=R1, r2=R2)
    return view.project(middles)[:, :2]


def lone_car(scene: nf.Scene, view: nf.Camera, poses: Array, method: str) -> list[Mask]:
    """Masks of the car's pixels in each picture, without any other object."""
    alone, number = scene.subset(objects=[CAR]), scene.object_names.index(CAR)
    if method == "truth":
        frames = (nf.render(alone.at({CAR: pose}), view, channels=("object_id",)) for pose in poses)
    else:
        kind: MorphKind = "none" if method == "conventional" else "blend"
        reduced = nf.reduce(alone, center=CENTER, r1=R1, r2=R2, morph=kind)
        settings: dict[str, Any] = {"method": "exact", "env": False, "channels": ("object_id",)}
        frames = (reduced.render(view, at={CAR: pose}, **settings) for pose in poses)
    return [frame.require("object_id") == number for frame in frames]


def centroids(masks: Iterable[Mask]) -> Array:
    return np.array([[np.nonzero(mask)[axis].mean() + 0.5 for axis in (1, 0)] for mask in masks])


def is_torn(mask: Mask) -> bool:
    """Whether there are empty columns between the car's pixels."""
    columns = np.flatnonzero(mask.any(axis=0))
    return bool((np.diff(columns) > 1).any())


def steps(path: Array) -> Array:
    """Steps between consecutive pictures, pixels (N − 1,)."""
    return np.asarray(np.linalg.norm(np.diff(path, axis=0), axis=1))


def changes(path: Array) -> Array:
    """Differences between consecutive steps, pixels (N − 2,), which are visible as jumps."""
    return np.asarray(np.linalg.norm(np.diff(path, n=2, axis=0), axis=1))


def jumps(scene: nf.Scene, view: nf.Camera, rate: float) -> tuple[str, dict[str, Array]]:
    """Table of steps and jumps of every method, and the paths."""
    poses = drive("left", rate)
    metres, rows, paths = distances(poses), [], {}
    for method in METHODS:
        paths[method] = project_car(view, poses, method)
        masks = lone_car(scene, view, poses, method)
        jump, pixels = changes(paths[method]), changes(centroids(masks))
        numbers = steps(paths[method]).max(), jump.max(), metres[1 + int(jump.argmax())], np.median(jump), pixels.max()
        rows.append([method, *numbers, sum(map(is_torn, masks))])
    header = (
        "method | greatest step, px {:.1f} | greatest jump, px {:.2f} | at, m from O {:.1f} | median jump, px {:.2f}"
    )
    header += " | greatest jump of the middle of its pixels, px {:.2f} | pictures with the car in two pieces"
    title = (
        f"The middle of a car at {SPEED * 3.6:.0f} km/h, {rate:.0f} pictures a second, {len(poses)} pictures of "
        f"{view.width} × {view.height}, user {np.linalg.norm(USER - CENTER):.1f} m from O"
    )
    return table(title, header, rows), paths


def hiding(reduced: nf.ReducedScene, view: nf.Camera, turn: str, stride: int) -> str:
    """Table of the car's visible pixels among all other objects: both methods, and the ideal picture without a map."""
    poses = drive(turn)[::stride]
    metres, number = distances(poses), reduced.scene.object_names.index(CAR)
    methods: list[dict[str, Any]] = [{"method": "exact"}, {"method": "vertex"}, {"method": "exact", "env": False}]
    counts = []
    for pose in poses:
        frames = (reduced.render(view, at={CAR: pose}, channels=("object_id",), **settings) for settings in methods)
        exact, vertex, ideal = (frame.require("object_id") == number for frame in frames)
        counts.append([exact.sum(), (vertex ^ exact).sum(), (exact ^ ideal).sum(), (vertex ^ ideal).sum()])
    numbers, rows = np.array(counts), []
    for low, high in ((0.0, R1), (R1, R2), (R2, 65.0), (65.0, END)):
        counts_in_range = numbers[(metres >= low) & (metres < high)]
        if len(counts_in_range):
            total = counts_in_range.sum(axis=0)
            differences = ((n, 100.0 * n / max(total[0], 1)) for n in total[1:])
            rows.append([(max(low, metres.min()), high), len(counts_in_range), total[0], *differences])
    pairs = ("vertex ≠ exact", "exact ≠ exact without a map", "vertex ≠ exact without a map")
    names = (f"{pair} {{:,}} ({{:.2f}} %)" for pair in pairs)
    header = ["m from O {:.0f}–{:.0f}", "pictures", "car's pixels (exact) {:,}", *names]
    assert reduced.env is not None
    return table(f"Pixels of the car {TURNS[turn]}, map of 6 × {reduced.env.face_size}²", header, rows)


def draw(paths: dict[str, Array], metres: Array, rate: float, path: Path) -> None:
    """Draw the car's path in the image, and its speed in pixels per picture by distance."""
    figure, (left, right) = subplots(1, 2, figsize=(12, 4))
    for (name, positions), style in zip(paths.items(), (":", "-", "--"), strict=True):
        # The line is interrupted at jumps, because the car is nowhere in between.
        lengths = steps(positions)
        line = np.insert(positions, np.flatnonzero(lengths > 5.0 * np.median(lengths)) + 1, np.nan, axis=0)
        left.plot(*line.T, style, label=name)
        right.plot(metres[1:], lengths, style, label=name)
        for radius, marker in ((R1, "o"), (R2, "s")):
            left.plot(*positions[np.argmax(metres > radius)], marker, color="0.3", markersize=6, fillstyle="none")
    for position, text in (
        (paths["truth"][0], f"{metres[0]:.0f} m"),
        (paths["continuous"][-1] + [0.0, 1.5], f"{metres[-1]:.0f} m"),
    ):
        left.annotate(text, position, xytext=(9, 0), textcoords="offset points", va="center")
    left.set(xlabel="x, px", ylabel="y, px", title="The car's middle in the image; circles at $r_1$, squares at $r_2$")
    left.invert_yaxis()
    for radius, text in ((R1, "$r_1$"), (R2, "$r_2$")):
        right.axvline(radius, color="0.7", linewidth=0.8)
        placement: dict[str, Any] = {"xycoords": ("data", "axes fraction"), "textcoords": "offset points"}
        right.annotate(text, (radius, 0.94), xytext=(3, 0), **placement)
    right.set(
        yscale="log", xlabel="m from the centre", ylabel="px", title=f"Pixels a picture, {rate:.0f} pictures a second"
    )
    for axes in (left, right):
        axes.grid(True, which="both", alpha=0.3)
        axes.legend()
    save_figure(figure, path)


def city(blocks: int, detail: int) -> nf.Scene:
    """City with a single moving car, because others would obstruct it."""
    scene = nf.datasets.city(blocks=blocks, detail=detail)
    other_cars = {f"car_{k}" for k in range(8)} - {CAR}
    return scene.subset(objects=[name for name in scene.object_names if name not in other_cars])


def main() -> None:
    arguments = start(__doc__, "--quick", plot=(Path("out/bench/car_path.png"), "where to draw the car's way"))
    scene = city(4, 1) if arguments.quick else city(12, 2)
    rate, view = (RATE / 3.0 if arguments.quick else RATE), camera(960)
    text, paths = jumps(scene, view, rate)
    print(text)
    draw(paths, distances(drive("left", rate)), rate, arguments.plot)
    channels = ("color", "object_id")
    size = 256 if arguments.quick else 1024
    reduced = nf.reduce(scene, center=CENTER, r1=R1, r2=R2, face_size=size, samples=1, channels=channels)
    for turn in TURNS:
        print(hiding(reduced, view, turn, 8 if arguments.quick else 1))


if __name__ == "__main__":
    main()
