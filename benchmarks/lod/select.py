"""Run time against error of choosing levels for a million objects, compared with NumPy and the time of reading them."""

from __future__ import annotations

import functools
import os
from typing import Any

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
CAMERA = nf.Camera((0, 0, 0), fov=nf.Fov.symmetric(87, 87 / 90), size=(1440, 1600))
BYTES = 44
"""Bytes of an object: centre, radius, number of its model, level."""


def models(least: float) -> list[nf.lod.LodModel]:
    """Make models of eight levels each, similar to measured objects, down to a solid angle."""
    random = np.random.default_rng(0)
    share = np.linspace(0, 1, 7)
    made = []
    for _ in range(MODELS):
        a, d = 1 - 0.02 * share, 0.6 - 0.5 * share
        c, b = 0.2 * 0.01**share * random.uniform(0.7, 1.4), np.full(7, random.uniform(0.7, 1.3))
        curves = nf.lod.Curve4PL(a, b, c, d, 0 * a, np.full(7, "fitted"), np.full(7, ""))
        triangles = np.geomspace(1e5, 1e2, 8).astype(np.int64)
        sigma = (least, nf.lod.reference_solid_angle(CAMERA))
        sphere: dict[str, Any] = {"center": np.zeros(3), "radius": 1.0, "errors": np.zeros(8)}
        made.append(nf.lod.LodModel(triangles=triangles, curves=curves, sigma=sigma, **sphere))
    return made


def scenes() -> dict[str, tuple[Array, Array, float]]:
    """Objects that are all in view, of measured sizes and mostly of smaller ones, and all around the eye."""
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
    made: list[nf.lod.LodModel], index: NDArray[np.int64], centers: Array, radii: Array, nodes: int
) -> NDArray[np.int32]:
    """Choose levels straightforwardly, with an inverse by interpolation (or five steps of the published one)."""
    assert isinstance(CAMERA.fov, nf.Fov)
    fov, scale, reference = CAMERA.fov, CAMERA.fov.right, nf.lod.reference_solid_angle(CAMERA)
    x, y, ahead = centers[:, 0], centers[:, 1], -centers[:, 2]
    sides = [(x, fov.right), (-x, -fov.left), (y, fov.up), (-y, -fov.down)]
    visible = ahead > -radii
    for across, tangent in sides:
        visible &= (across - tangent * ahead) / np.hypot(1, tangent) <= radii
    level = np.full(len(radii), -1, np.int32)
    mine = np.flatnonzero(visible)
    distance = np.linalg.norm(centers[mine], axis=1)
    with np.errstate(invalid="ignore"):
        mu = np.arcsin(np.minimum(radii[mine] / distance, 1))
        alpha = np.arccos(ahead[mine] / distance)
        sigma = 4 * np.pi * np.sin(mu / 2) ** 2
        edges = [np.tan(alpha + mu) / scale, np.tan(alpha - mu) / scale]
        if nodes:
            end = 4.0
            r = np.linspace(0, end, nodes)
            roots = [np.sign(edge) * np.interp(np.abs(edge), RIFT_S.distort(r), r) for edge in edges]
        else:
            roots = [edge.copy() for edge in edges]
            for root, edge in zip(roots, edges, strict=True):
                for _ in range(5):
                    square = root * root
                    root[:] = edge / (1 + square * (RIFT_S.k[0] + RIFT_S.k[1] * square))
        stretch = (np.arctan(scale * roots[0]) - np.arctan(scale * roots[1])) / (2 * mu)
        seen = np.where(alpha + mu < np.pi / 2, sigma * stretch, sigma)
    wanted = nf.lod.LodThreshold()(sigma, reference)
    chosen = np.zeros(len(mine), np.int32)
    for number, one in enumerate(made):
        these = np.flatnonzero(index[mine] == number)
        size = np.maximum(seen[these], one.sigma[0])
        for step, (a, b, c, d) in enumerate(zip(*one.curves, strict=True), 1):
            chosen[these[d + (a - d) / (1 + (size / c) ** b) >= wanted[these]]] = step
    chosen[seen > reference] = 0
    level[mine] = chosen
    return level


def budget_by_numpy(
    made: list[nf.lod.LodModel], index: NDArray[np.int64], sizes: Array, budget: int
) -> tuple[NDArray[np.int64], float]:
    """Levels and mean score under a budget: all steps between neighbouring levels, sorted, without convex hulls."""
    count, steps = len(index), len(made[0]) - 1
    scores, added = np.ones((count, steps + 1)), np.zeros((count, steps), np.int64)
    first = 0
    for number, one in enumerate(made):
        mine = np.flatnonzero(index == number)
        size = np.clip(sizes[mine], *one.sigma)
        for level, (a, b, c, d) in enumerate(zip(*one.curves, strict=True), 1):
            scores[mine, level] = d + (a - d) / (1 + (size / c) ** b)
        added[mine] = -np.diff(one.triangles)
        first += len(mine) * int(one.triangles[-1])
    slopes = -np.diff(scores, axis=1) / added
    # A step comes after the coarser ones of its object.
    slopes = np.minimum.accumulate(slopes[:, ::-1], axis=1)[:, ::-1]
    order = np.argsort(-slopes, axis=None, kind="stable")
    taken = order[np.cumsum(added.ravel()[order]) <= budget - first]
    levels = steps - np.bincount(taken // steps, minlength=count)
    return levels, float(scores[np.arange(count), levels].mean())


def budget_table(title: str, centers: Array, radii: Array, least: float) -> str:
    """Table of budgets of 2 and 20 times the coarsest levels; errors are the mean score below that of the kernel."""
    made = models(least)
    index = np.random.default_rng(2).integers(0, MODELS, COUNT)
    select = functools.partial(nf.lod.select, made, index, centers, radii, camera=CAMERA, lens=RIFT_S, cull=False)
    sizes = nf.corrected_solid_angle(centers, radii, camera=CAMERA, lens=RIFT_S)
    coarsest = int(np.array([one.triangles[-1] for one in made])[index].sum())
    cases = [Case(f"{OURS}, threshold", select)]
    notes = []
    for factor in (2, 20):
        ours = functools.partial(select, budget=factor * coarsest)
        before = ours()
        if (spent := before.spent) is None:
            raise RuntimeError("expected a budget that is spent")
        theirs = functools.partial(budget_by_numpy, made, index, sizes, factor * coarsest)
        again = functools.partial(ours, previous=before.level, price=spent.price, hysteresis=0.1)
        cases.append(Case(f"{OURS}, {factor} x the coarsest levels", ours))
        cases.append(Case(f"{OURS}, {factor} x, the frame after", again))
        cases.append(Case(f"NumPy, sorted steps, {factor} x", theirs))
        notes.append(f"{factor} x: {spent}, NumPy's mean score {theirs()[1]:.6f}")
    text = compare(f"Budgets for 10⁶ objects, {title}", cases, work=Work(bytes=BYTES * COUNT), repeat=3)
    return "\n".join([text, *notes, ""])


def table(title: str, centers: Array, radii: Array, least: float) -> str:
    """Table whose errors are the share of objects with a level other than that of the exact inverse."""
    made = models(least)
    index = np.random.default_rng(2).integers(0, MODELS, COUNT)
    select = functools.partial(nf.lod.select, made, index, centers, radii, camera=CAMERA, lens=RIFT_S)
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
        Case("NumPy, interp over 4,096", lambda: by_numpy(made, index, centers, radii, 4096), error),
        Case("NumPy, 5 fixed-point steps", lambda: by_numpy(made, index, centers, radii, 0), error),
        Case("reading (NumPy's max)", lambda: (centers.max(), radii.max(), index.max())),
    ]
    text = compare(f"Levels of 10⁶ objects, {title}", cases, work=Work(bytes=BYTES * COUNT), repeat=5)
    by_table, exact = (
        nf.lod.select(made, index, centers, radii, camera=CAMERA, lens=RIFT_S, inverse=inverse, full=True)
        for inverse in ("lut", "newton")
    )
    asked = ~np.isnan(exact.sigma_seen)
    off = np.abs(by_table.sigma_seen[asked] / exact.sigma_seen[asked] - 1).max()
    share = 1 - by_table.counts["culled"] / COUNT
    small = np.mean(by_table.sigma_seen[asked] <= least)
    decided = by_table.counts["table"] / by_table.counts["asked"]
    return (
        f"{text}\n{share:.1%} in view; of those asked for {small:.1%} are smaller than measured, and tables decide "
        f"{decided:.1%}\nσ′ off by {off:.1e} of itself at most; {by_table.counts}\n"
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
