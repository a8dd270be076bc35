"""The published user study: its tasks as pictures, the disparity of both eyes by distance, and its statistics."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import trimesh
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFont
from scipy import stats

import nearfar as nf
from benchmarks.harness.report import save_figure, start, subplots, table
from nearfar.datasets import count_task, sphere_task, tape_task

Array = NDArray[np.float64]
Picture = NDArray[np.uint8]

IPD = 0.064
"""Distance of both eyes, metres."""
RADIUS = 0.4
"""Radius of the ball whose disparity is measured, metres."""
R1, R2, CENTER = 30.0, 50.0, np.array([0.0, 1.7, 0.0])
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
    count = _still_pictures(count_task(5), "count", size, 90.0, 2.0)
    tape = _still_pictures(tape_task(1), "tape", size, 40.0, -1.5)
    for name, answers in (("count", count), ("tape", tape), ("ball", _ball_pictures(size))):
        columns = [_with_caption(picture, f"{TEXT[name]}  {title}") for title, picture in answers.items()]
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


def _methods(scene: nf.Scene, task: Any) -> dict[str, nf.Scene | nf.ReducedScene]:
    settings = nf.MapSettings(face_size=2048, samples=2, channels=("color", "object_id"))
    reduced = nf.reduce(scene, center=task.center, r1=task.r1, r2=task.r2, settings=settings)
    return {"Truth": scene, "Conventional": reduced.with_morph("none"), "Continuous": reduced}


def _frame(source: nf.Scene | nf.ReducedScene, view: nf.Camera, **how: Any) -> nf.Frame:
    if isinstance(source, nf.ReducedScene):
        return source.render(view, samples=8, channels=("color", "object_id"), **how)
    return nf.render(source, view, samples=8, channels=("color", "object_id"), **how)


def _still_pictures(
    scene_and_task: tuple[nf.Scene, Any], name: str, size: tuple[int, int], degrees: float, up: float
) -> dict[str, Picture]:
    scene, task = scene_and_task
    view = _view(task, name, size, degrees, up)
    return {method: _frame(source, view).to_image() for method, source in _methods(scene, task).items()}


def _ball_pictures(size: tuple[int, int]) -> dict[str, Picture]:
    """Pictures that show the ball at several times."""
    scene, task = sphere_task(3)
    view = _view(task, "ball", size, 40.0, 1.0)
    number = scene.object_names.index("ball")
    pictures = {}
    for name, source in _methods(scene, task).items():
        settings: dict[str, Any] = {"conventional_dynamic": "user"} if name == "Conventional" else {}
        combined: Picture | None = None
        for time in np.linspace(0.3, 1.0, BALLS) * task.duration:
            frame = _frame(source, view, at={"ball": task.pose(time)}, **settings)
            picture, mask = frame.to_image(), frame.require("object_id") == number
            combined = picture if combined is None else np.where(mask[..., None], picture, combined)
        assert combined is not None
        pictures[name] = combined
    return pictures


def _with_caption(picture: Picture, text: str) -> Picture:
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


def ball() -> nf.Scene:
    """One ball that can be placed anywhere."""
    scene = nf.Scene.from_trimesh(trimesh.creation.uv_sphere(RADIUS, count=(32, 64)))
    return scene.with_dynamic(scene.object_names)


def disparities(distances: Array, user: Array, width: int) -> tuple[Array, Array, Array]:
    """Disparity in arc minutes of a ball ahead of a user: by calculation, in pictures, and in the true pictures.

    Each eye is its own user U. Pictures are so narrow that a pixel is a fraction of an arc minute.
    """
    scene = ball()
    name = scene.object_names[0]
    reduced = nf.reduce(scene, center=CENTER, r1=R1, r2=R2, face_size=16, samples=1)
    eyes = [user + np.array([side * IPD / 2.0, 0.0, 0.0]) for side in (-1.0, 1.0)]
    rows = []
    for distance in distances:
        position = CENTER + np.array([0.0, 0.0, -distance])
        pose = np.eye(4)
        pose[:3, 3] = position
        morphed = [nf.morph(position[None], user=eye, center=CENTER, r1=R1, r2=R2)[0] for eye in eyes]
        calculated = _angle(morphed[0] - eyes[0]) - _angle(morphed[1] - eyes[1])
        middle = 0.5 * (morphed[0] - eyes[0] + morphed[1] - eyes[1])
        # Wide enough for the ball and for the disparity of the truth.
        fov = nf.Fov.symmetric(2.0 * np.degrees(np.arctan(1.6 * RADIUS / distance) + IPD / distance + 0.002), 1.0)
        disparities_seen = []
        for source, direction in ((reduced, middle), (scene, position - user)):
            angles = []
            for eye in eyes:
                view = nf.Camera.look_at(eye, eye + direction, fov=fov, size=(width, width))
                settings: dict[str, Any] = {"at": {name: pose}, "channels": ("object_id",)}
                if source is reduced:
                    frame = reduced.render(view, method="exact", env=False, **settings)
                else:
                    frame = nf.render(scene, view, **settings)
                angles.append(_middle(frame, view))
            disparities_seen.append(angles[0] - angles[1])
        rows.append([calculated, *disparities_seen])
    arc_minutes = np.degrees(np.array(rows)) * 60.0
    return arc_minutes[:, 0], arc_minutes[:, 1], arc_minutes[:, 2]


def _angle(direction: Array) -> float:
    """Angle to the right of −z, radians."""
    return float(np.arctan2(direction[0], -direction[2]))


def _middle(frame: nf.Frame, view: nf.Camera) -> float:
    """Mean angle of the ball's pixels to the right of −z, radians."""
    directions = view.rays()[1][frame.require("object_id") >= 0]
    return float(np.mean(np.arctan2(directions[:, 0], -directions[:, 2])))


def disparity(quick: bool, plots: Path | None) -> str:
    """Table and plot of the disparity by distance, for a user at the centre and one beside it."""
    distances = np.array([20.0, 45.0] if quick else [5, 10, 20, 29, 32, 35, 38, 41, 44, 47, 49, 49.9, 50.1, 60, 80])
    rows, curves = [], {}
    for text, step in (("at O", (0.0, 0.0, 0.0)), ("8 m aside", (8.0, 0.0, 0.0))):
        curves[text] = disparities(distances, CENTER + np.array(step), 200 if quick else 1200)
    for n, distance in enumerate(distances):
        rows.append([distance, *(curves[text][curve][n] for text in curves for curve in (2, 0, 1))])
    if plots is not None:
        draw_disparity(distances, curves, (R1, R2), plots / "disparity.png")
    names = ("truth", "continuous, calculated", "continuous, in pictures")
    header = ["m from O {:g}", *(f"{text}: {name} {{:.2f}}" for text in curves for name in names)]
    return table(f"Disparity in arc minutes, eyes {IPD * 1000:.0f} mm apart, r₁ = {R1:g}, r₂ = {R2:g} m", header, rows)


def statistics() -> str:
    """Table of the printed answers, and the test statistics that follow from them.

    McNemar's test counts the participants who were right in one condition only: b in the continuous one, c in the
    other. χ² is (b − c)²/(b + c).
    """
    rows = []
    for question, answers, b, c, printed in (
        ("1: wrong number of spheres", "EC 9 %, CC 41 %", 8, 1, "5.44, 0.0196"),
        ("2: right board, by participant", "EC, TC 100 %, CC 15.2 %", 18, 0, "18"),
        ("2: right board, by answer", "the same", 56, 0, "18"),
        ("4: right box", "EC 83.3 %, TC 93.9 %", 7, 0, "7, 0.008"),
    ):
        chi = (b - c) ** 2 / (b + c)
        rows.append([question, answers, (b, c), printed, chi, stats.chi2.sf(chi, 1), stats.binomtest(c, b + c).pvalue])
    header = "question | answers | pairs b, c {}, {} | printed χ², p | χ² {:.2f} | its p {:.2g} | exact p {:.2g}"
    return table("The study's printed answers, and McNemar's test of them", header, rows)


def main() -> None:
    arguments = start(__doc__, "--quick", "--plots")
    print(statistics())
    print(disparity(arguments.quick, arguments.plots))
    if arguments.plots is not None:
        draw_tasks(arguments.plots / "study.jpg", (320, 140) if arguments.quick else (640, 280))


if __name__ == "__main__":
    main()
