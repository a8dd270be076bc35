"""Plots of scores by material, and of the factor fitted to them."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Mapping
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from benchmarks.harness.report import save_figure, subplots
from benchmarks.lod import _appearance, _correction
from benchmarks.lod._appearance import Plan
from benchmarks.lod._correction import Samples
from benchmarks.lod._material import NEUTRAL, Material, Shape, look, shade

Array = NDArray[np.float64]

Kind = Callable[[Material], bool]

SWEEPS: tuple[tuple[str, str, Kind], ...] = (
    ("metallic", "roughness 0.5", lambda one: one.contrast == 0 and one.roughness == 0.5),
    ("frequency", "solid, contrast 0.5", lambda one: _pattern(one, mapped=False) and one.contrast == 0.5),
    ("frequency", "mapped, contrast 0.5", lambda one: _pattern(one, mapped=True) and one.contrast == 0.5),
    ("roughness", "not metallic", lambda one: one.contrast == 0 and one.metallic == 0),
    ("contrast", "solid, 8 cycles", lambda one: _pattern(one, mapped=False) and one.frequency in (0, 8)),
    ("contrast", "mapped, 8 cycles", lambda one: _pattern(one, mapped=True) and one.frequency in (0, 8)),
)
"""Sweeps: the varied property, the fixed ones, and whether a material belongs to the sweep."""

LABELS = {"frequency": "frequency, cycles across the object"}
COLORS = ("#c8102e", "#1f5fa8", "#2e8b57", "#b8860b", "#6a3d9a", "#555555", "#e377c2", "#17becf", "#8c564b")


def draw_materials(shapes: Mapping[str, Shape], plan: Plan, path: Path) -> None:
    """Draw each object in some materials, and its coarsest level beside it, at the middle size."""
    other_materials = [material for material in plan.materials if material != NEUTRAL]
    materials = [NEUTRAL, *other_materials[3 :: max(1, len(other_materials) // 6)]]
    camera = list(_appearance.cameras(plan.sizes[len(plan.sizes) // 2], plan.steps))[plan.steps + 1]
    rows, size = 2 * len(shapes), (1.5 * len(materials), 1.55 * 2 * len(shapes))
    figure, axes = subplots(rows, len(materials), figsize=size, squeeze=False)
    for number, (name, shape) in enumerate(shapes.items()):
        base, *_, coarsest = _appearance.simplified(shape, plan.ratios)
        for row, level in ((2 * number, base), (2 * number + 1, coarsest)):
            for axis, picture in zip(axes[row], shade(look(level, camera), materials), strict=True):
                axis.imshow(picture, cmap="gray", vmin=0, vmax=255)
                axis.set(xticks=[], yticks=[])
            axes[row, 0].set_ylabel(f"{name}\n{len(level.faces):,}", fontsize=7)
    for axis, material in zip(axes[0], materials, strict=True):
        axis.set_title(material.label.replace(", ", "\n"), fontsize=6)
    save_figure(figure, path, dpi=90)


def draw_scores(scores: Mapping[str, Array], plan: Plan, path: Path) -> None:
    """Draw mean SSIM of all objects by each property, a line for each level and size."""
    mean = np.mean(list(scores.values()), axis=0)
    figure, axes = subplots(2, 3, figsize=(13, 8.5), sharey=True)
    for axis, (name, fixed, chosen) in zip(axes.flat, SWEEPS, strict=True):
        numbers = [n for n, material in enumerate(plan.materials) if chosen(material)]
        numbers.sort(key=lambda n: getattr(plan.materials[n], name))
        values = [getattr(plan.materials[n], name) for n in numbers]
        for level, size in itertools.product(range(len(plan.ratios)), range(len(plan.sizes))):
            label = f"{plan.ratios[level]:.4g} of the triangles, size {plan.sizes[size]:.3g}"
            style = ("-", "--", ":", "-.")[size % 4]
            axis.plot(values, mean[level, size, numbers], style, color=COLORS[level], marker="o", ms=4, label=label)
        axis.set(xlabel=LABELS.get(name, name), title=fixed)
        axis.grid(visible=True, alpha=0.3)
        if name == "frequency":
            axis.set_xscale("log", base=2)
            axis.set_xticks(values, [f"{value:g}" for value in values])
    figure.supylabel("SSIM, 25th percentile of views, mean of objects")
    figure.legend(*axes[0, 0].get_legend_handles_labels(), loc="outside lower center", ncols=3, fontsize=8)
    save_figure(figure, path)


def draw_factors(samples: Samples, path: Path) -> None:
    """Draw each object's mean factor by material with the fitted one, and factors predicted for objects left out."""
    from matplotlib.ticker import NullLocator

    figure, grid = subplots(2, 2, figsize=(14, 8.5), width_ratios=(1.6, 1))
    axes = {"means": grid[0, 0], "finish": grid[0, 1], "pattern": grid[1, 1]}
    grid[1, 0].remove()
    axes["means"].set_subplotspec(grid[0, 0].get_gridspec()[:, 0])
    materials = [n for n, material in enumerate(samples.materials) if material != NEUTRAL]
    coefficients = _correction.fit(samples)
    fitted = [_correction.factor(coefficients, samples.materials[n]) for n in materials]
    axes["means"].plot(fitted, range(len(materials)), "kx", ms=9, zorder=3, label="coefficients")
    predicted = np.exp(_correction.cross_validated(samples, "coefficients"))
    measured = np.exp(samples.logarithm)
    finish = samples.is_kind("finish")
    pattern = samples.is_kind("solid pattern") | samples.is_kind("mapped pattern")
    for number, name in enumerate(samples.objects):
        color, inside = COLORS[number % len(COLORS)], samples.object == number
        if not inside.any():
            continue
        means = [np.exp(samples.logarithm[inside & (samples.material == n)].mean()) for n in materials]
        axes["means"].plot(means, range(len(materials)), "o", color=color, ms=5, alpha=0.8, label=name)
        for panel, kind in (("finish", finish), ("pattern", pattern)):
            rows = inside & kind
            axes[panel].plot(predicted[rows], measured[rows], ".", color=color, ms=4, alpha=0.5)
    axes["means"].set_yticks(range(len(materials)), [_short(samples.materials[n]) for n in materials], fontsize=8)
    axes["means"].invert_yaxis()
    axes["means"].axvline(1.0, color="black", linewidth=0.8)
    axes["means"].set(xscale="log", xlabel="1 − SSIM, times that of the dull material; each object's mean")
    axes["means"].legend(fontsize=8)
    low, high = min(measured.min(), predicted.min()), max(measured.max(), predicted.max())
    for panel in ("finish", "pattern"):
        axes[panel].plot([low, high], [low, high], color="black", linewidth=0.8)
        axes[panel].set(
            xscale="log", yscale="log", xlabel="predicted without the object", ylabel="measured", title=panel
        )
    ticks = [tick for tick in (0.1, 0.2, 0.5, 1, 2, 5, 10) if low / 1.5 < tick < high * 1.5]
    sides = [side for panel in ("finish", "pattern") for side in (axes[panel].xaxis, axes[panel].yaxis)]
    for each in (axes["means"].xaxis, *sides):
        each.set_ticks(ticks, [f"{tick:g}" for tick in ticks])
        each.set_minor_locator(NullLocator())
    for panel in axes.values():
        panel.grid(visible=True, alpha=0.3)
    save_figure(figure, path)


def _pattern(material: Material, *, mapped: bool) -> bool:
    """Whether a material is dull, with a pattern of this kind or none."""
    return material.dull and (material.mapped == mapped or not material.contrast)


def _short(material: Material) -> str:
    if not material.contrast:
        return f"m {material.metallic:g}, r {material.roughness:g}"
    pattern = f"{material.frequency:g} {'mapped' if material.mapped else 'solid'}, c {material.contrast:g}"
    return pattern if material.dull else f"m {material.metallic:g}, r {material.roughness:g}, {pattern}"
