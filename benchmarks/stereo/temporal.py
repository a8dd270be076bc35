"""Temporal anti-aliasing: error against 64 samples for still and moving heads and for single frames; frame time.

python -m benchmarks.stereo.temporal [--quick]
"""

from __future__ import annotations

import argparse
import time
from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness.timing import machine, table

HEAD = (0.0, 1.7, 0.0)
STEPS = {"still": 0.0, "1 cm": 0.01, "3 cm": 0.03}
"""Sideways movement of the head between pictures, metres; 1 cm is 0.9 m/s at 90 Hz."""
COUNT = 32


def error(frame: nf.StereoFrame, truth: nf.StereoFrame) -> float:
    """Root mean square error of both eyes, sRGB codes."""
    pairs = [(getattr(frame, eye).to_image(), getattr(truth, eye).to_image()) for eye in ("left", "right")]
    return float(np.mean([nf.metrics.rmse(a, b) for a, b in pairs]))


def measure(name: str, scene: nf.Scene, size: tuple[int, int]) -> str:
    """Table of one scene."""
    rig = nf.stereo.HybridRig.of(nf.hmd.QUEST_2, mono_plane=8.0, size=size)
    settings: dict[str, Any] = {"backend": "cpu", "channels": ("color",)}
    rows = []
    for motion, step in STEPS.items():
        smooth, seconds = nf.stereo.TemporalAntialiasing(), float("inf")
        for number in range(COUNT):
            position = np.add(HEAD, (step * number, 0.0, 0.0))
            started = time.perf_counter()
            frame = smooth.render(rig, scene, position, **settings)
            seconds = min(seconds, time.perf_counter() - started)
        truth = rig.render(scene, position, samples=64, **settings)
        row = [motion, f"{error(frame, truth):.2f}", f"{seconds:.3f}"]
        for samples in (1, 4, 8):
            started = time.perf_counter()
            once = rig.render(scene, position, samples=samples, **settings)
            row += [f"{error(once, truth):.2f}", f"{time.perf_counter() - started:.3f}"]
        rows.append(row)
    single = (f"{samples} samples{unit}" for samples in (1, 4, 8) for unit in ("", ", s"))
    header = ["head", "temporal, RMSE in codes", "s", *single]
    return table(f"Temporal anti-aliasing, {name}, {size[0]} × {size[1]} pixels an eye", header, rows)


def main() -> None:
    """Print the tables."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="small pictures")
    arguments = parser.parse_args()
    print(machine(), end="\n\n")
    size = (120, 126) if arguments.quick else (600, 630)
    for name, scene in (("beams", nf.datasets.beams()), ("city", nf.datasets.city())):
        print(measure(name, scene, size), flush=True)


if __name__ == "__main__":
    main()
