"""Values of `tear` for pictures with a known tear: widths, directions, shear, curvature, overlap.

Halves of the pictures are pulled apart, slide along each other or overlap.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.report import save_figure, start, subplots, table

Array = NDArray[np.float64]

DEFAULT_VIEW = nf.Camera((3, 2, 1), fov=nf.Fov.symmetric(90), size=(160, 160))
LINE_POSITION = 80.2
"""x and y of the line's middle, pixels; upright and level lines run between pixel centres."""

TEARS = (1.0, 3.0, 10.0, 40.0)
DIRECTIONS = {"upright": 0.0, "slanted": 0.5, "level": np.pi / 2.0}
CASES: tuple[tuple[str, str, float, float], ...] = (
    ("opening", "opening", 0.0, 0.0),
    ("sliding", "sliding", 0.0, 0.0),
    ("opening, shear 0.5", "opening", 0.5, 0.0),
    ("opening, shear 5", "opening", 5.0, 0.0),
    ("sliding, shear 5", "sliding", 5.0, 0.0),
    ("opening, curved", "opening", 0.0, 0.002),
    ("overlap", "overlap", 0.0, 0.0),
)
"""Name, motion of the halves, shear and curvature."""


def pixels(view: nf.Camera = DEFAULT_VIEW) -> Array:
    """Middles of the picture's pixels (H, W, 2)."""
    return np.stack(np.meshgrid(np.arange(view.width) + 0.5, np.arange(view.height) + 0.5), axis=-1)


def picture(truth: Array, view: nf.Camera = DEFAULT_VIEW) -> nf.Frame:
    """Make the frame whose pixels show points at given places (H, W, 2) of the truth."""
    fov = view.fov
    assert isinstance(fov, nf.Fov)
    x = fov.left + (fov.right - fov.left) * truth[..., 0] / view.width
    y = fov.up + (fov.down - fov.up) * truth[..., 1] / view.height
    points = np.stack([x, y, -np.ones_like(x)], axis=-1) * 10.0
    return nf.Frame(view, position=points.astype(np.float32), origin=view.position)


def torn_picture(
    tear: float, direction: float, *, kind: str = "opening", shear: float = 0.0, curvature: float = 0.0
) -> nf.Frame:
    """Make a picture that is torn along a line through its middle, with shear and curvature over all of it.

    `direction` is the angle of the line's normal, radians. `kind` is "opening" for halves with a gap between them,
    "sliding" for halves that slide along each other, "overlap" for halves of which one hides the other. A curvature c
    moves a point x pixels from the line's middle, across the line, to x + c x².
    """
    normal = np.array([np.cos(direction), np.sin(direction)])
    tangent = np.array([-normal[1], normal[0]])
    offset = pixels() - LINE_POSITION
    distances = offset @ normal
    side = np.sign(distances)
    if kind == "sliding":
        truth = offset - (side * tear / 2.0)[..., None] * tangent
    else:
        truth = offset - (side * (tear / 2.0 if kind == "opening" else -tear / 2.0))[..., None] * normal
    if curvature:
        # The inverse of x + c x², for |c x| small.
        x = truth @ normal
        uncurved = 2.0 * x / (1.0 + np.sqrt(np.maximum(1.0 + 4.0 * curvature * x, 1e-3)))
        truth += (uncurved - x)[..., None] * normal
    truth[..., 0] -= shear * truth[..., 1]
    if kind == "opening":
        truth[np.abs(distances) < tear / 2.0] = np.nan
    return picture(truth + LINE_POSITION)


def values_along_line(values: NDArray[np.float32], tear: float, direction: float, *, kind: str = "opening") -> Array:
    """Values of the pixels along the line, away from the picture's edges."""
    offset = pixels() - LINE_POSITION
    half_gap = tear / 2.0 if kind == "opening" else 0.0
    distances = np.abs(offset @ (np.cos(direction), np.sin(direction))) - half_gap
    beside = (np.abs(distances) < 1) & (np.linalg.norm(offset, axis=-1) < 40) & ~np.isnan(values)
    return np.asarray(values[beside], np.float64)


def measure(kind: str, shear: float, curvature: float, tear: float, direction: float) -> float:
    frame = torn_picture(tear, direction, kind=kind, shear=shear, curvature=curvature)
    return float(values_along_line(nf.metrics.tear(frame), tear, direction, kind=kind).mean())


def main() -> None:
    arguments = start(__doc__, "--quick", "--plots")
    directions = dict(list(DIRECTIONS.items())[:1]) if arguments.quick else DIRECTIONS
    readings = {
        name: np.array([[measure(kind, shear, bent, tear, angle) for tear in TEARS] for angle in directions.values()])
        for name, kind, shear, bent in CASES
    }
    rows = [[name, *zip(values.min(axis=0), values.max(axis=0), strict=True)] for name, values in readings.items()]
    header = ["picture", *(f"tear of {tear:g} px {{:.3g}} to {{:.3g}}" for tear in TEARS)]
    print(table(f"What tear reads along the line, {', '.join(directions)}", header, rows))
    if arguments.plots is not None:
        draw(readings, arguments.plots / "tear.png")


def draw(readings: dict[str, Array], path: Path) -> None:
    """Draw the ratio of the measured to the true tear, with the band of ± 10 %."""
    figure, axes = subplots(figsize=(7.4, 3.6))
    axes.axhspan(0.9, 1.1, color="0.92", label="± 10 %")
    for n, (name, values) in enumerate(readings.items()):
        x = np.arange(len(TEARS)) + 0.1 * (n - len(readings) / 2)
        ratios = values / np.array(TEARS)
        axes.vlines(x, ratios.min(axis=0), ratios.max(axis=0), color=f"C{n}")
        axes.plot(np.tile(x, len(ratios)), ratios.ravel(), "o", markersize=4, color=f"C{n}", label=name)
    axes.set(ylim=(-0.05, 1.2), xlabel="tear, pixels", ylabel="read / true")
    axes.set_xticks(range(len(TEARS)), [f"{tear:g}" for tear in TEARS])
    axes.legend(fontsize=8, loc="center left", bbox_to_anchor=(1.0, 0.5))
    axes.grid(alpha=0.3, axis="y")
    save_figure(figure, path)


if __name__ == "__main__":
    main()
