"""Temporal anti-aliasing: error against 64 samples for still and moving heads and for single frames; frame time."""

from __future__ import annotations

from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness.report import start, table
from benchmarks.harness.timing import timed

HEAD = (0.0, 1.7, 0.0)
STEPS = {"still": 0.0, "1 cm": 0.01, "3 cm": 0.03}
"""Sideways movement of the head between pictures, metres; 1 cm is 0.9 m/s at 90 Hz."""
COUNT = 32


def error(frame: nf.StereoFrame, truth: nf.StereoFrame) -> float:
    """Root mean square error of both eyes, sRGB codes."""
    pairs = [(getattr(frame, eye).to_image(), getattr(truth, eye).to_image()) for eye in ("left", "right")]
    return float(np.mean([nf.metrics.rmse(a, b) for a, b in pairs]))


def measure(name: str, scene: nf.Scene, size: tuple[int, int]) -> str:
    rig = nf.stereo.HybridRig.of(nf.hmd.QUEST_2, mono_plane=8.0, size=size)
    settings: dict[str, Any] = {"backend": "cpu", "channels": ("color",)}
    rows = []
    for motion, step in STEPS.items():
        smooth, positions = nf.stereo.TemporalAntialiasing(), [np.add(HEAD, (step * n, 0.0, 0.0)) for n in range(COUNT)]
        frames = [timed(smooth.render, rig, scene, position, **settings) for position in positions]
        truth = rig.render(scene, positions[-1], samples=64, **settings)
        row: list[object] = [motion, error(frames[-1][0], truth), min(time.wall for _, time in frames)]
        for samples in (1, 4, 8):
            once, time = timed(rig.render, scene, positions[-1], samples=samples, **settings)
            row += [error(once, truth), time.wall]
        rows.append(row)
    header = "head | temporal, RMSE in codes {:.2f} | s {:.3f}"
    header += "".join(f" | {samples} samples {{:.2f}} | {samples} samples, s {{:.3f}}" for samples in (1, 4, 8))
    return table(f"Temporal anti-aliasing, {name}, {size[0]} × {size[1]} pixels an eye", header, rows)


def main() -> None:
    size = (120, 126) if start(__doc__, "--quick").quick else (600, 630)
    for name, scene in (("beams", nf.datasets.beams()), ("city", nf.datasets.city())):
        print(measure(name, scene, size), flush=True)


if __name__ == "__main__":
    main()
