"""Effect of metal, gloss and patterns on the SSIM of a level, and whether a factor by material can correct for it.

Objects are those of the data folder and three procedural ones. With `--quick`, or without the data folder, only the
procedural ones are used: enough to test the tables, but too few for conclusions.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from benchmarks.harness.report import start, table
from benchmarks.harness.timing import timed
from benchmarks.lod import _appearance, _correction
from benchmarks.lod._appearance import Plan
from benchmarks.lod._correction import Samples, Validity
from benchmarks.lod._material import NEUTRAL, Shape

Array = NDArray[np.float64]


def objects(*, quick: bool) -> dict[str, Shape]:
    shapes = {name: make() for name, make in _appearance.PROCEDURAL.items()}
    if not quick:
        scanned = {name: _appearance.scanned(name) for name in _appearance.SCANNED}
        shapes |= {name: shape for name, shape in scanned.items() if shape}
    return shapes


def run(plan: Plan, shapes: Mapping[str, Shape]) -> dict[str, Array]:
    return {name: _appearance.scores(shape, plan) for name, shape in shapes.items()}


def table_of_factors(samples: Samples) -> str:
    """Table of each material: the factor's mean over objects, and the spread of single samples about it."""
    rows: list[list[object]] = []
    for number, material in enumerate(samples.materials):
        logs = samples.logarithm[samples.material == number]
        if material != NEUTRAL:
            low, middle, high = np.exp(np.percentile(logs, [10, 50, 90]))
            rows.append([material.label, np.exp(logs.mean()), middle, (low, high)])
    header = "1 − SSIM relative to the neutral material | mean {:.2f} | median {:.2f} | 8 in 10 {:.2f} to {:.2f}"
    return table(f"{len(samples.dissimilarity):,} samples of {len(samples.objects)} objects", header, rows)


def table_of_coefficients(samples: Samples) -> str:
    coefficients = zip(_correction.NAMES, *_correction.intervals(samples), strict=True)
    rows = [[name, value, (low, high)] for name, value, low, high in coefficients]
    header = " | coefficient {:+.3f} | 95 %, objects left out in turn {:+.3f} to {:+.3f}"
    return table("Logarithm of the factor", header, rows)


def validities(samples: Samples) -> dict[tuple[str, str], Validity]:
    """Validity by kind of material and model, for objects left out of the model's fit."""
    predictions = {name: _correction.cross_validate(samples, name) for name in _correction.MODELS}
    results = {}
    for kind in _correction.KINDS:
        inside = samples.is_kind(kind)
        for name, predicted in predictions.items() if inside.any() else ():
            results[kind, name] = _correction.validity(samples.where(inside), predicted[inside])
    return results


def table_of_validity(samples: Samples) -> str:
    """Table of each model on objects left out of its fit, by kind of material."""
    rows = [[f"{kind}: {name}", one.log, one.ssim, one.explained] for (kind, name), one in validities(samples).items()]
    header = " | RMS error of log factor {:.3f} | RMS error of SSIM {:.4f} | explained {:.2f}"
    return table("Objects left out of the fit, one by one", header, rows)


def verdict(samples: Samples) -> str:
    """State in words whether the coefficients improve predictions for objects left out of their fit."""
    results, lines = validities(samples), []
    for kind in [kind for kind in _correction.KINDS if (kind, "coefficients") in results]:
        none, ours, best = (results[kind, name] for name in _correction.MODELS)
        usable = "yes" if ours.ssim < none.ssim and ours.log < none.log else "no"
        lines.append(
            f"- {kind}: {usable}. SSIM is off by {ours.ssim:.4f} with the factor and {none.ssim:.4f} without, "
            f"{best.ssim:.4f} with a number for each material.\n"
        )
    return "For objects left out of the fit, does a factor improve predictions?\n\n" + "".join(lines)


def main() -> None:
    options = start(__doc__, "--quick")
    plan, shapes = _appearance.QUICK if options.quick else Plan(), objects(quick=options.quick)
    scores, time = timed(run, plan, shapes)
    samples = _correction.collect(scores, plan.materials)
    print(f"{len(shapes)} objects, {len(plan.materials)} materials: {time.wall:.0f} s\n")
    for make_table in (table_of_factors, table_of_coefficients, table_of_validity, verdict):
        print(make_table(samples))


if __name__ == "__main__":
    main()
