"""Pictures of SPZ files by Spark, in headless Chromium."""

from __future__ import annotations

import base64
import math
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from tests.support.reader_cases import answer_of

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Look:
    """A camera that both programs accept."""

    eye: tuple[float, float, float]
    target: tuple[float, float, float]
    angle: float
    """Vertical, degrees."""
    size: tuple[int, int]

    @property
    def camera(self) -> nf.Camera:
        """For nearfar."""
        aspect = self.size[0] / self.size[1]
        across = 2 * math.degrees(math.atan(math.tan(math.radians(self.angle) / 2) * aspect))
        return nf.Camera.look_at(self.eye, self.target, fov=nf.Fov.symmetric(across, aspect), size=self.size)

    def to_json(self, files: Sequence[int]) -> dict[str, Any]:
        """For the page, with the numbers of the files to show."""
        own = {"eye": self.eye, "target": self.target, "angle": self.angle, "size": self.size}
        return own | {"near": 0.5, "far": 1e5, "files": list(files)}


def spark(
    files: Sequence[tuple[Path, Any]], views: Sequence[tuple[Look, Sequence[int]]], first: int = 0
) -> tuple[list[dict[str, Any]], list[Array]]:
    """Files that Spark loads, and pictures (H, W, 4) that it draws: sRGB times alpha, and alpha, in 0..1.

    Parameters
    ----------
    files
        SPZ files of one folder, and the world positions that they are relative to.
    views
        Cameras, and the numbers of the files that they show.
    first
        Number of splats of each file whose values are returned.
    """
    (folder,) = {path.parent for path, _ in files}
    described = [{"url": f"/bundles/a/{path.name}", "position": list(map(float, place))} for path, place in files]
    job = {"files": described, "views": [look.to_json(shown) for look, shown in views], "first": first}
    with tempfile.TemporaryDirectory() as profile:
        answer = answer_of("splats.mjs", job, Path(profile), {"a": folder})
    pictures = []
    for (look, _), text in zip(views, answer["pictures"], strict=True):
        width, height = look.size
        codes = np.frombuffer(base64.b64decode(text), np.uint8).reshape(height, width, 4)[::-1]
        pictures.append(codes / 255.0)
    return answer["files"], pictures
