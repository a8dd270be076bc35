"""Draws the plots and picture rows of the benchmarks."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

import nearfar as nf

Points = Sequence[tuple[float, float, float]]
"""Position on the axis, PSNR in decibels and SSIM."""


def draw_torn(truth: nf.Frame, frames: Mapping[str, nf.Frame], title: str, path: Path) -> None:
    """Draw the truth and each method's picture, and below them their discontinuity on one scale."""
    plt = _pyplot()
    figure, axes = plt.subplots(2, 1 + len(frames), figsize=(4.4 * (1 + len(frames)), 5.4), layout="constrained")
    axes[0, 0].imshow(truth.to_image())
    axes[0, 0].set_title("truth")
    axes[1, 0].remove()
    shown: Any = None
    for column, (name, frame) in enumerate(frames.items(), start=1):
        axes[0, column].imshow(frame.to_image())
        axes[0, column].set_title(name)
        torn = np.abs(nf.metrics.discontinuity(frame))
        shown = axes[1, column].imshow(np.clip(torn, 0.0, 4.0), cmap="inferno", vmin=0.0, vmax=4.0)
        axes[1, column].set_title(f"its discontinuity, mean {np.nanmean(torn):.2f}")
    figure.colorbar(shown, ax=axes[1, :].tolist()[1:], shrink=0.8, label="|δ|")
    for axis in axes.flat:
        axis.set(xticks=[], yticks=[])
    figure.suptitle(title)
    figure.savefig(path, dpi=90)
    plt.close(figure)


def draw_errors(by_size: Points, by_distance: Points, title: str, path: Path) -> None:
    """Draw the error of maps by size and the error of parallax by distance side by side, on one scale."""
    plt = _pyplot()
    figure, axes = plt.subplots(1, 2, figsize=(8.0, 3.6), sharey=True, layout="constrained")
    for axis, points, label in (
        (axes[0], by_size, "texels across a face of the map"),
        (axes[1], by_distance, "metres from the centre"),
    ):
        at, psnr, _ = zip(*points, strict=True)
        axis.plot(at, psnr, marker="o")
        axis.set_xscale("log", base=2)
        axis.set_xticks(at, [f"{value:g}" for value in at])
        axis.minorticks_off()
        axis.set_xlabel(label)
        axis.grid(visible=True, alpha=0.3)
    axes[0].set(ylabel="PSNR, dB", title="the map, against no map")
    axes[1].set_title("parallax, against the truth")
    figure.suptitle(title)
    figure.savefig(path, dpi=100)
    plt.close(figure)


def _pyplot() -> Any:
    import matplotlib as mpl

    mpl.use("agg")
    from matplotlib import pyplot

    return pyplot


def draw_lens(lens: nf.RadialLens, frame: nf.Frame, path: Path) -> None:
    """Draw errors of inverses, sizes seen through the lens, and a picture corrected with its mesh."""
    plt = _pyplot()
    figure, axes = plt.subplots(1, 3, figsize=(15, 4.6), layout="constrained", width_ratios=(1.2, 1, 1))
    _draw_inverses(lens, axes[0])
    _draw_sizes(lens, axes[1])
    picture, fov = frame.to_image(), frame.camera.fov
    assert isinstance(fov, nf.Fov)
    height, width = picture.shape[:2]
    mesh = lens.warp_mesh(frame, tolerance_px=0.5)
    axes[2].imshow(lens.warp(picture, True, fov=fov), extent=(-1, 1, -1, 1), aspect=height / width)
    axes[2].triplot(*mesh.positions.T, mesh.faces, color="white", linewidth=0.35, alpha=0.7)
    cells = len(mesh.faces) // 2
    axes[2].set(xticks=[], yticks=[], title=f"warped for it; a mesh of {cells} cells: {mesh.error_px:.2f} px")
    figure.savefig(path, dpi=90)
    plt.close(figure)


def _draw_inverses(lens: nf.RadialLens, axis: Any) -> None:
    """Draw the residual between a radius and the image of its root."""
    r = np.linspace(0.01, 1.6, 800)
    shown = lens.distort(r)
    inverses: tuple[tuple[str, Any, int, str], ...] = (
        ("published iteration, 5 steps (OpenCV's default)", "fixed_point", 5, "#999999"),
        ("published iteration, 50 steps", "fixed_point", 50, "#555555"),
        ("look-up table", "lut", 0, "#e08a1e"),
        ("Newton (0)", "newton", 0, "#c8102e"),
    )
    for label, method, steps, color in inverses:
        residual = np.abs(lens.distort(lens.undistort(shown, method=method, iterations=steps)) - shown)
        axis.semilogy(r, np.maximum(residual, 1e-17), label=label, color=color)
    axis.axvline(1.0, linestyle=":", color="black")
    axis.set(xlabel="r (the screen's edge is 1)", ylabel="residual |f(r̂) − f(r)|", title="inverses of a strong lens")
    axis.set_ylim(5e-18, 1e6)
    axis.legend(fontsize=8, loc="upper left")
    axis.grid(alpha=0.3)


def _draw_sizes(lens: nf.RadialLens, axis: Any) -> None:
    """Draw sizes of small spheres seen through the lens."""
    camera = nf.Camera((0, 0, 0), fov=nf.Fov.symmetric(87), size=(1000, 1000))
    angles = np.radians(np.linspace(0, 50, 200))
    centers = np.column_stack([np.sin(angles), np.zeros_like(angles), -np.cos(angles)]) * 10
    plain = nf.solid_angle(centers, 0.05, eye=camera.position)
    for exact, label, color in (
        (False, "as published: along the radius only", "#555555"),
        (True, "its area", "#c8102e"),
    ):
        corrected = nf.corrected_solid_angle(centers, 0.05, camera=camera, lens=lens, exact=exact)
        axis.plot(np.degrees(angles), corrected / plain, label=label, color=color)
    axis.set(xlabel="degrees from the axis", ylabel="solid angle seen / solid angle", title="sizes through the lens")
    axis.legend(fontsize=8)
    axis.grid(alpha=0.3)
