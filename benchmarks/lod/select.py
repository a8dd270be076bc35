"""Run time against error of choosing levels for a million objects, compared with NumPy and the time of reading them."""

from __future__ import annotations

import functools
import os

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.compare import OURS, Case, Work, compare, print_limits
from benchmarks.harness.report import start

Array = NDArray[np.float64]

RIFT_S = nf.RadialLens((0.22, 0.24))
"""Lens of the Rift S in Liebisch (2021)."""

COUNT = 1_000_000
MODELS = 20
"""Numbers of objects and of their models."""
MODEL_INDEX = np.random.default_rng(2).integers(0, MODELS, COUNT)
"""Number of each object's model."""
CAMERA = nf.Camera((0, 0, 0), fov=nf.Fov.symmetric(87, 87 / 90), size=(1440, 1600))
BYTES = 44
"""Bytes of an object: centre, radius, number of its model, level."""


def make_models(least: float) -> list[nf.lod.LodModel]:
    """Make models of eight levels each, similar to measured objects, down to a solid angle."""
    random = np.random.default_rng(0)
    coarseness = np.linspace(0, 1, 7)
    triangles, sigma = np.geomspace(1e5, 1e2, 8).astype(np.int64), (least, nf.lod.reference_solid_angle(CAMERA))
    a, d = 1 - 0.02 * coarseness, 0.6 - 0.5 * coarseness
    models = []
    for _ in range(MODELS):
        c, b = 0.2 * 0.01**coarseness * random.uniform(0.7, 1.4), np.full(7, random.uniform(0.7, 1.3))
        models.append(nf.lod.LodModel(triangles=triangles, curves=nf.lod.Curve4PL(a, b, c, d), sigma=sigma))
    return models


def scenes() -> dict[str, tuple[Array, Array, float]]:
    """Three scenes: all objects in view; the same, but most smaller than measured; objects all around the eye."""
    random = np.random.default_rng(1)
    ahead = random.uniform(1, 60, COUNT)
    x, y = random.uniform(-0.9, 0.9, (2, COUNT)) * ahead
    radii = random.uniform(0.02, 0.6, COUNT)
    return {
        "all in view": (np.stack([x, y, -ahead], axis=1), radii, 1e-4),
        "all in view, smaller than measured": (np.stack([x, y, -ahead], axis=1), radii, 0.01),
        "all around": (random.normal(size=(COUNT, 3)) * 20, radii, 1e-4),
    }


def by_numpy(
    models: list[nf.lod.LodModel], index: NDArray[np.int64], centers: Array, radii: Array, nodes: int
) -> NDArray[np.int32]:
    """Choose levels with the lens inverted from `nodes` samples, or by five steps of the published iteration if 0."""
    assert isinstance(CAMERA.fov, nf.Fov)
    fov, scale, reference = CAMERA.fov, CAMERA.fov.right, nf.lod.reference_solid_angle(CAMERA)
    x, y, ahead = centers[:, 0], centers[:, 1], -centers[:, 2]
    sides = [(x, fov.right), (-x, -fov.left), (y, fov.up), (-y, -fov.down)]
    visible = ahead > -radii
    for across, tangent in sides:
        visible &= (across - tangent * ahead) / np.hypot(1, tangent) <= radii
    level = np.full(len(radii), -1, np.int32)
    in_view = np.flatnonzero(visible)
    distance = np.linalg.norm(centers[in_view], axis=1)
    with np.errstate(invalid="ignore"):
        mu = np.arcsin(np.minimum(radii[in_view] / distance, 1))
        alpha = np.arccos(ahead[in_view] / distance)
        sigma = 4 * np.pi * np.sin(mu / 2) ** 2
        edges = [np.tan(alpha + mu) / scale, np.tan(alpha - mu) / scale]
        if nodes:
            r = np.linspace(0, 4.0, nodes)
            roots = [np.sign(edge) * np.interp(np.abs(edge), RIFT_S.distort(r), r) for edge in edges]
        else:
            roots = [edge.copy() for edge in edges]
            for root, edge in zip(roots, edges, strict=True):
                for _ in range(5):
                    square = root * root
                    root[:] = edge / (1 + square * (RIFT_S.k[0] + RIFT_S.k[1] * square))
        stretch = (np.arctan(scale * roots[0]) - np.arctan(scale * roots[1])) / (2 * mu)
        apparent = np.where(alpha + mu < np.pi / 2, sigma * stretch, sigma)
    required = nf.lod.LodThreshold()(sigma, reference)
    level_in_view = np.zeros(len(in_view), np.int32)
    for number, model in enumerate(models):
        rows = np.flatnonzero(index[in_view] == number)
        size = np.maximum(apparent[rows], model.sigma[0])
        for step, (a, b, c, d) in enumerate(zip(*model.curves, strict=True), 1):
            level_in_view[rows[d + (a - d) / (1 + (size / c) ** b) >= required[rows]]] = step
    level_in_view[apparent > reference] = 0
    level[in_view] = level_in_view
    return level


def budget_by_numpy(
    models: list[nf.lod.LodModel], index: NDArray[np.int64], sizes: Array, budget: int
) -> tuple[NDArray[np.int64], float]:
    """Levels and mean score under a budget: all steps between neighbouring levels, sorted, without convex hulls."""
    count, steps = len(index), len(models[0]) - 1
    scores, added = np.ones((count, steps + 1)), np.zeros((count, steps), np.int64)
    coarsest = 0
    for number, model in enumerate(models):
        rows = np.flatnonzero(index == number)
        size = np.clip(sizes[rows], *model.sigma)
        for level, (a, b, c, d) in enumerate(zip(*model.curves, strict=True), 1):
            scores[rows, level] = d + (a - d) / (1 + (size / c) ** b)
        added[rows] = -np.diff(model.triangles)
        coarsest += len(rows) * int(model.triangles[-1])
    slopes = -np.diff(scores, axis=1) / added
    # A step comes after the coarser ones of its object.
    slopes = np.minimum.accumulate(slopes[:, ::-1], axis=1)[:, ::-1]
    order = np.argsort(-slopes, axis=None, kind="stable")
    taken = order[np.cumsum(added.ravel()[order]) <= budget - coarsest]
    levels = steps - np.bincount(taken // steps, minlength=count)
    return levels, float(scores[np.arange(count), levels].mean())


def budget_table(title: str, centers: Array, radii: Array, least: float) -> str:
    """Table of budgets of 2 and 20 times the coarsest levels; notes compare the mean scores with NumPy's."""
    models, index = make_models(least), MODEL_INDEX
    select = functools.partial(nf.lod.select, models, index, centers, radii, camera=CAMERA, lens=RIFT_S, cull=False)
    sizes = nf.corrected_solid_angle(centers, radii, camera=CAMERA, lens=RIFT_S)
    coarsest = int(np.array([model.triangles[-1] for model in models])[index].sum())
    cases = [Case(f"{OURS}, threshold", select)]
    notes = []
    for factor in (2, 20):
        ours = functools.partial(select, budget=factor * coarsest)
        first_frame = ours()
        if (spent := first_frame.spent) is None:
            raise RuntimeError("expected a budget that is spent")
        by_sorting = functools.partial(budget_by_numpy, models, index, sizes, factor * coarsest)
        next_frame = functools.partial(ours, previous=first_frame.level, price=spent.price, hysteresis=0.1)
        cases.append(Case(f"{OURS}, {factor} x the coarsest levels", ours))
        cases.append(Case(f"{OURS}, {factor} x, the frame after", next_frame))
        cases.append(Case(f"NumPy, sorted steps, {factor} x", by_sorting))
        notes.append(f"{factor} x: {spent}, NumPy's mean score {by_sorting()[1]:.6f}")
    text = compare(f"Budgets for 10⁶ objects, {title}", cases, work=Work(bytes=BYTES * COUNT), repeat=3)
    return "\n".join([text, *notes, ""])


def table(title: str, centers: Array, radii: Array, least: float) -> str:
    """Table whose errors are the share of objects with a level other than that of the exact inverse."""
    models, index = make_models(least), MODEL_INDEX
    select = functools.partial(nf.lod.select, models, index, centers, radii, camera=CAMERA, lens=RIFT_S)
    expected = select(inverse="newton")

    def error(levels: NDArray[np.int32] | nf.lod.Selection) -> float:
        return float(np.mean(levels != expected))

    cases = [
        Case(f"{OURS}, lut", select, error),
        Case(f"{OURS}, newton", functools.partial(select, inverse="newton"), error),
        Case(f"{OURS}, depth", functools.partial(select, mode="depth")),
        Case(f"{OURS}, panel", functools.partial(select, mode="panel")),
        Case(f"{OURS}, fovea", functools.partial(select, mode="fovea")),
        Case(f"{OURS}, two eyes", functools.partial(select, camera=[CAMERA, CAMERA]), error),
        Case("NumPy, interp over 4,096", lambda: by_numpy(models, index, centers, radii, 4096), error),
        Case("NumPy, 5 fixed-point steps", lambda: by_numpy(models, index, centers, radii, 0), error),
        Case("memory read (NumPy's max)", lambda: (centers.max(), radii.max(), index.max())),
    ]
    text = compare(f"Levels of 10⁶ objects, {title}", cases, work=Work(bytes=BYTES * COUNT), repeat=5)
    by_table, exact = (select(inverse=inverse, full=True) for inverse in ("lut", "newton"))
    is_computed = ~np.isnan(exact.sigma_seen)
    error_of_size = np.abs(by_table.sigma_seen[is_computed] / exact.sigma_seen[is_computed] - 1).max()
    in_view = 1 - by_table.counts["culled"] / COUNT
    small = np.mean(by_table.sigma_seen[is_computed] <= least)
    decided = by_table.counts["table"] / by_table.counts["asked"]
    return (
        f"{text}\n{in_view:.1%} in view; of the objects whose size is computed, {small:.1%} are smaller than measured; "
        f"for {decided:.1%} the look-up table suffices\nerror of σ′ at most {error_of_size:.1e}; {by_table.counts}\n"
    )


def main() -> None:
    start(__doc__)
    print_limits()
    print(f"{os.environ.get('NEARFAR_NUM_THREADS', 'all')} threads; a millisecond is a nanosecond an object")
    for title, scene in scenes().items():
        print(table(title, *scene), flush=True)
        print(budget_table(title, *scene), flush=True)


if __name__ == "__main__":
    main()
