"""Draws the tasks of the published user study in both conditions, and the disparity of both eyes by distance."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFont

import nearfar as nf
from benchmarks.harness.report import save_figure, subplots
from nearfar.datasets import count_task, sphere_task, tape_task

Array = NDArray[np.float64]
Picture = NDArray[np.uint8]

BALLS = 12
"""Number of places at which the flying ball is shown in one picture."""
USER = {"count": (6.0, 0.0, 0.0), "tape": (5.0, 0.0, 0.0), "ball": (5.0, 0.0, 0.0)}
"""Position of the user relative to the centre, metres."""
TEXT = {
    "count": "How many spheres are there?",
    "tape": "To which board does the tape lead?",
    "ball": "On which box does the ball land?",
}


def draw_tasks(path: Path, size: tuple[int, int]) -> None:
    """Draw the truth, the conventional and the continuous picture of each task, one row per task."""
    rows = []
    for name, answers in (("count", _count(size)), ("tape", _tape(size)), ("ball", _ball(size))):
        columns = [_captioned(picture, f"{TEXT[name]}  {title}") for title, picture in answers.items()]
        gap = np.full((columns[0].shape[0], 6, 3), 255, np.uint8)
        rows.append(np.concatenate([columns[0], gap, columns[1], gap, columns[2]], axis=1))
    Image.fromarray(np.concatenate(rows)).save(path, quality=88, optimize=True)


def _view(task: Any, name: str, size: tuple[int, int], degrees: float, up: float) -> nf.Camera:
    eye = np.add(task.center, USER[name])
    # Users turn towards the middle of the objects.
    direction = np.subtract(task.target, eye)
    return nf.Camera.look_at(
        eye, np.add(eye, (direction[0], up, direction[2])), fov=nf.Fov.symmetric(degrees, size[0] / size[1]), size=size
    )


def _light(scene: nf.Scene, task: Any) -> nf.ReducedScene:
    return nf.reduce(
        scene, center=task.center, r1=task.r1, r2=task.r2, face_size=2048, samples=2, channels=("color", "object_id")
    )


def _methods(scene: nf.Scene, task: Any) -> dict[str, nf.Scene | nf.ReducedScene]:
    reduced = _light(scene, task)
    return {"Truth": scene, "Conventional": reduced.with_morph("none"), "Continuous": reduced}


def _frame(source: nf.Scene | nf.ReducedScene, view: nf.Camera, **how: Any) -> nf.Frame:
    if isinstance(source, nf.ReducedScene):
        return source.render(view, samples=8, channels=("color", "object_id"), **how)
    return nf.render(source, view, samples=8, channels=("color", "object_id"), **how)


def _count(size: tuple[int, int]) -> dict[str, Picture]:
    scene, task = count_task(5)
    view = _view(task, "count", size, 90.0, 2.0)
    methods = _methods(scene, task)
    return {f"{name}": _frame(source, view).to_image() for name, source in methods.items()}


def _tape(size: tuple[int, int]) -> dict[str, Picture]:
    scene, task = tape_task(1)
    view = _view(task, "tape", size, 40.0, -1.5)
    return {name: _frame(source, view).to_image() for name, source in _methods(scene, task).items()}


def _ball(size: tuple[int, int]) -> dict[str, Picture]:
    """Pictures in which the ball is shown at several times."""
    scene, task = sphere_task(3)
    view = _view(task, "ball", size, 40.0, 1.0)
    number = scene.object_names.index("ball")
    pictures = {}
    for name, source in _methods(scene, task).items():
        how: dict[str, Any] = {"conventional_dynamic": "user"} if name == "Conventional" else {}
        combined: Picture | None = None
        for time in np.linspace(0.3, 1.0, BALLS) * task.duration:
            frame = _frame(source, view, at={"ball": task.pose(time)}, **how)
            picture, mask = frame.to_image(), frame.require("object_id") == number
            combined = picture if combined is None else np.where(mask[..., None], picture, combined)
        assert combined is not None
        pictures[name] = combined
    return pictures


def _captioned(picture: Picture, text: str) -> Picture:
    """A picture under a line of text."""
    height = max(14, picture.shape[1] // 32)
    line = Image.new("RGB", (picture.shape[1], round(1.6 * height)), "white")
    ImageDraw.Draw(line).text((4, 0.2 * height), text, "black", ImageFont.load_default(height))
    return np.concatenate([np.asarray(line), picture[..., :3]])


def draw_disparity(
    distances: Array, curves: Mapping[str, tuple[Array, Array, Array]], radii: tuple[float, float], path: Path
) -> None:
    """Draw the disparity of the truth, of the continuous method by calculation, and in pictures."""
    figure, grid = subplots(1, len(curves), figsize=(10, 3.8), sharey=True, squeeze=False)
    for axes, (title, (calculated, in_pictures, truth)) in zip(grid[0], curves.items(), strict=True):
        axes.plot(distances, truth, color="0.5", label="truth")
        axes.plot(distances, calculated, color="#c8102e", label="continuous, calculated")
        axes.plot(distances, in_pictures, "o", color="#c8102e", fillstyle="none", label="continuous, in pictures")
        for radius, text in zip(radii, ("$r_1$", "$r_2$"), strict=True):
            axes.axvline(radius, color="0.8", linewidth=0.8, zorder=0)
            axes.annotate(text, (radius, 0.95), xytext=(3, 0), xycoords=("data", "axes fraction"),
                          textcoords="offset points")  # fmt: skip
        axes.set(xlabel="m from the centre", title=f"user {title}")
        axes.grid(visible=True, alpha=0.3)
    grid[0][0].set(ylabel="disparity, arc minutes")
    grid[0][0].legend()
    save_figure(figure, path)
