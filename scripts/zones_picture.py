"""Draw the figure of the README that defines O, U, r₁, r₂ and the three zones: `python scripts/zones_picture.py`.

Top view above, the weight w as a function of ρ below. The displayed positions come from `nearfar.morph`, so that the
figure shows the implemented method.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np
from numpy.typing import NDArray

import nearfar as nf

PATH = Path(__file__).resolve().parent.parent / "docs" / "zones.svg"

R1, R2, EDGE = 30.0, 50.0, 76.0
"""Radii that bound the near and the intermediate zone, and half the width of the picture, metres."""

CENTER, USER = np.array([0.0, 0.0, 0.0]), np.array([0.0, 0.0, 14.0])
"""O and U in world metres: x to the right, z towards the bottom of the picture."""

POINTS = {
    "near": np.array([-12.0, 0.0, -18.0]),
    "intermediate": np.array([-37.0, 0.0, -17.0]),
    "far": np.array([64.0, 0.0, -12.0]),
}
"""One scene point P in each zone, world metres."""

FILL = {"near": "#d9efdc", "intermediate": "#fdeac8", "far": "#dbe8f7"}
INK = {"near": "#1b7a35", "intermediate": "#b25e00", "far": "#1f5fa8"}
GREY = "#555555"

Array = NDArray[np.float64]


def main() -> None:
    """Draw both panels and write them as SVG with its text as outlines, the same on every machine."""
    mpl.use("svg")
    mpl.rcParams.update({"svg.hashsalt": "zones", "font.size": 13, "mathtext.fontset": "dejavusans"})
    from matplotlib import pyplot as plt

    figure, (top, weight) = plt.subplots(
        2, 1, figsize=(7.4, 8.3), height_ratios=(5.2, 1.5), layout="constrained", facecolor="white"
    )
    draw_zones(top)
    draw_points(top)
    draw_weight(weight)
    figure.savefig(PATH, metadata={"Date": None})
    plt.close(figure)


def draw_zones(axes: Any) -> None:
    """Fill the zones, and draw both circles about O with their radii."""
    from matplotlib.patches import Circle

    axes.set(xlim=(-EDGE, EDGE), ylim=(60, -60), aspect="equal", facecolor=FILL["far"])
    axes.set(xticks=[], yticks=[])
    axes.set_title("Top view: two circles about the vertical axis through O", fontsize=13)
    for radius, zone in ((R2, "intermediate"), (R1, "near")):
        axes.add_patch(Circle((0, 0), radius, facecolor=FILL[zone], edgecolor=GREY, linewidth=1.2))
    for radius, angle, name in ((R1, 74, "$r_1$"), (R2, 47, "$r_2$")):
        end = radius * np.array([np.cos(np.radians(angle)), -np.sin(np.radians(angle))])
        axes.annotate("", end, (0, 0), arrowprops={"arrowstyle": "-|>", "color": GREY, "shrinkA": 3, "shrinkB": 0})
        axes.text(*(end - 0.25 * R1 * end / radius + (2.0, 2.5)), name, color=GREY, fontsize=16)
    for y, zone in ((26.5, "near"), (42.5, "intermediate"), (57.5, "far")):
        axes.text(0, y, f"{zone} zone", color=INK[zone], ha="center", weight="bold")
    left, right = {"x": -EDGE + 2, "ha": "left"}, {"x": EDGE - 2, "ha": "right"}
    axes.text(y=-58, s="O  centre: the map\nis baked from here", va="top", **left)
    axes.text(y=-58, s="U  the user's eye", va="top", **right)
    axes.text(y=57.5, s="P  scene point", **left)
    axes.text(y=57.5, s="Q  where U sees P", **right)


def draw_points(axes: Any) -> None:
    """Draw O, U, and for each P its displayed place Q, with the sight lines that lead there."""
    displayed = {name: shown_at(point) for name, point in POINTS.items()}
    for name, point in POINTS.items():
        line(axes, USER, displayed[name], INK[name], "-")
        if name != "near":
            line(axes, CENTER, point, INK[name], (0, (4, 3)))
            axes.plot(*plan(point), "o", color=INK[name], markersize=7, markerfacecolor="white", zorder=5)
            axes.annotate(
                "",
                plan(displayed[name]),
                plan(point),
                arrowprops={"arrowstyle": "-|>", "color": INK[name], "shrinkA": 5, "shrinkB": 4, "linewidth": 1.5},
            )
        axes.plot(*plan(displayed[name]), "o", color=INK[name], markersize=8, zorder=6)
    draw_labels(axes, displayed)
    for place, name, offset in ((CENTER, "O", (2.2, 6.5)), (USER, "U", (2.5, 3.5))):
        axes.plot(
            *plan(place),
            "+" if name == "O" else "D",
            color="black",
            markersize=13 if name == "O" else 7,
            markeredgewidth=2,
            zorder=7,
        )
        axes.text(*(plan(place) + offset), name, fontsize=15, weight="bold")


def draw_labels(axes: Any, shown: dict[str, Array]) -> None:
    """Label P and Q in each zone."""
    labels: list[tuple[str, Array, tuple[float, float], str, str]] = [
        ("near", shown["near"], (3.0, -1.0), "P = Q", "left"),
        ("intermediate", POINTS["intermediate"], (0.0, -4.0), "P", "center"),
        ("intermediate", shown["intermediate"], (0.5, 7.0), "Q", "center"),
        ("far", POINTS["far"], (0.0, -4.0), "P", "center"),
        ("far", shown["far"], (0.0, 7.5), "Q", "center"),
    ]
    for zone, place, offset, text, side in labels:
        axes.text(*(plan(place) + offset), text, color=INK[zone], ha=side)


def draw_weight(axes: Any) -> None:
    """Draw w over the distance ρ from the axis through O."""
    rho = np.array([0.0, R1, R2, EDGE])
    for low, high, zone in ((0, R1, "near"), (R1, R2, "intermediate"), (R2, EDGE, "far")):
        axes.axvspan(low, high, color=FILL[zone])
    axes.plot(rho, np.clip((R2 - rho) / (R2 - R1), 0, 1), color="black", linewidth=2)
    axes.set(xlim=(0, EDGE), ylim=(-0.1, 1.75), yticks=[0, 1], xticks=[0, R1, R2])
    axes.set_xticklabels(["0", f"$r_1$ = {R1:g} m", f"$r_2$ = {R2:g} m"])
    axes.set_xlabel("ρ, horizontal distance of a point from the axis through O")
    axes.set_ylabel("w, weight of U's view", fontsize=11)
    labels = (
        (R1 / 2, "near", "geometry\nas seen from U"),
        ((R1 + R2) / 2, "intermediate", "morphed\ngeometry"),
        ((R2 + EDGE) / 2, "far", "map\nas seen from O"),
    )
    for place, zone, text in labels:
        axes.text(place, 1.66, text, color=INK[zone], ha="center", va="top")


def shown_at(point: Array) -> Array:
    """Position at which the morph shows a point to the user."""
    return np.asarray(nf.morph(point[None], user=USER, center=CENTER, r1=R1, r2=R2)[0])


def plan(point: Array) -> Array:
    """Coordinates x and z of a point."""
    return point[[0, 2]]


def line(axes: Any, start: Array, end: Array, color: str, style: Any) -> None:
    """Draw a sight line."""
    axes.plot(*np.stack([plan(start), plan(end)]).T, color=color, linestyle=style, linewidth=1.5, zorder=4)


if __name__ == "__main__":
    main()
