"""Unit vectors from surface points to the viewer, for view-dependent shading: computed, and as shader text."""

from __future__ import annotations

from importlib import resources

import numpy as np
from numpy.typing import NDArray

from nearfar._base import check

LANGUAGES = ("wgsl", "glsl")
"""Names of shading languages."""


def view_vector_shader(language: str = "wgsl") -> str:
    """Return the text of a function `view_vector`, the version of `HybridRig.view_vectors` in "wgsl" or "glsl".

    The text has only the function, without a version; its comment explains the arguments. ValueError and TypeError for
    other languages. Source: Fink et al. (2019).
    """
    name = f"view_vector.{check.choice('language', language, LANGUAGES)}"
    return resources.files("nearfar.stereo").joinpath(name).read_text(encoding="utf-8")


def view_vectors(
    points: NDArray[np.float64],
    eye: NDArray[np.float64],
    center: NDArray[np.float64],
    forward: NDArray[np.float64],
    *,
    plane: float,
    setback: float,
    blend: float,
) -> NDArray[np.float64]:
    """Unit vectors (N, 3) from points to the viewer; NaN for a point at the viewer."""
    to_eye, to_center = eye - points, center - points
    depths = -(to_center @ forward) - setback
    with np.errstate(invalid="ignore", over="ignore"):
        eye_weight = np.clip((plane - depths) / blend, 0.0, 1.0)[:, None]
        units = [v / np.linalg.norm(v, axis=1, keepdims=True) for v in (to_eye, to_center)]
        # If only one viewer counts, the other one may be at the point.
        weights = (eye_weight, 1.0 - eye_weight)
        parts = [np.where(weight > 0.0, weight * unit, 0.0) for weight, unit in zip(weights, units, strict=True)]
        mixed = parts[0] + parts[1]
        return np.asarray(mixed / np.linalg.norm(mixed, axis=1, keepdims=True))
