"""Measures of one picture against the truth, and their means."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Mapping
from dataclasses import dataclass, fields
from importlib.util import find_spec
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from nearfar.metrics import _tear

EPSILON = 4.0
"""Radius of the neighbourhoods in which tears are measured, samples."""


@dataclass(frozen=True)
class Measures:
    """Quality of a picture; NaN for what was not measured."""

    psnr: float
    ssim: float
    flip: float
    jod: float
    tear: float
    """Mean over the seam of near and far part, in samples."""
    missing: float
    """Share of the samples that show the sky in place of a surface."""


def has_flip() -> bool:
    return find_spec("flip_evaluator") is not None


def has_jod() -> bool:
    return find_spec("pycvvdp") is not None


def pixels_per_degree(camera: nf.Camera) -> float:
    """Pixels per degree in the middle of a picture."""
    fov = camera.fov
    return float(np.radians(camera.width / (fov.right - fov.left)))  # type: ignore[union-attr]


def measure(truth: nf.Frame, test: nf.Frame, samples: tuple[nf.Frame, nf.Frame], is_far: NDArray[np.bool_]) -> Measures:
    """Compare pictures; `samples` are those of the truth and of the test, with positions."""
    density = pixels_per_degree(truth.camera)
    shown, hidden = (np.isfinite(frame.require("position")[..., 0]) for frame in samples)
    return Measures(
        psnr=nf.psnr(truth, test),
        ssim=float(nf.ssim(truth, test)),
        flip=float(nf.metrics.flip(truth, test, pixels_per_degree=density)) if has_flip() else np.nan,
        jod=np.nan,
        tear=seam_tear(samples[1], is_far),
        missing=float((shown & ~hidden).mean()),
    )


def jods(pictures: Mapping[str, nf.Frame], folder: Path) -> dict[str, float]:
    """Compute the JOD of pictures by name against the one called "truth"; empty without cvvdp.

    Another process does it, because PyTorch and flip-evaluator crash in one.
    """
    if not has_jod():
        return {}
    names = [name for name in pictures if name != "truth"]
    stack = np.stack([pictures[name].to_image() for name in ("truth", *names)])
    path = folder / "pictures.npy"
    np.save(path, stack)
    density = pixels_per_degree(pictures["truth"].camera)
    command = [sys.executable, "-m", "benchmarks.impostor.methods.jod", str(path), str(density)]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    return dict(zip(names, json.loads(done.stdout), strict=True))


def seam_tear(samples: nf.Frame, is_far: NDArray[np.bool_]) -> float:
    """Mean tear where near and far part meet on one surface; NaN if they meet nowhere."""
    edge = _meets(is_far)
    torn, is_two_sided = _tear._tears(samples, samples.camera, EPSILON, side=is_far, mask=edge)
    counted = edge & is_two_sided & np.isfinite(torn)
    return float(torn[counted].mean()) if counted.sum() >= 20 else np.nan


def _meets(side: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Whether a sample has a neighbour on the other side."""
    edge = np.zeros_like(side)
    for axis in (0, 1):
        step = np.diff(side, axis=axis)
        pad = [(0, 0), (0, 0)]
        pad[axis] = (0, 1)
        edge |= np.pad(step, pad)
        pad[axis] = (1, 0)
        edge |= np.pad(step, pad)
    return edge


def mean(rows: list[Measures]) -> Measures:
    """Average measures over pictures, without those that are NaN."""
    values = {}
    for entry in fields(Measures):
        known = [value for value in (getattr(row, entry.name) for row in rows) if np.isfinite(value)]
        values[entry.name] = float(np.mean(known)) if known else np.nan
    return Measures(**values)
