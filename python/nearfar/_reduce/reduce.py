"""Near–far reduction: checks the arguments and runs the stages; it computes nothing itself."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, DTypeLike

from nearfar._base import check
from nearfar._partition.partition import UNITS
from nearfar._reduce import stages
from nearfar._reduce.baking import Baking
from nearfar._reduce.drawing import check_morph
from nearfar._reduce.reduced_scene import ReducedScene
from nearfar._reduce.stages import Divided
from nearfar._scene.scene import Scene, core_of


def reduce(
    scene: Scene | Divided,
    *,
    center: ArrayLike,
    r1: float,
    r2: float,
    face_size: int = 1024,
    morph: str = "blend",
    boundary: str = "r2",
    unit: str = "triangle",
    channels: Iterable[str] = ("color",),
    samples: int = 4,
    range_dtype: DTypeLike = np.float32,
    backend: str | None = None,
) -> ReducedScene:
    """Reduce a scene: near triangles stay geometry, far ones are baked into a cube map, and a morph joins the two.

    Parameters
    ----------
    scene
        The scene, or a world that provides its own near part and map, such as an `OrthoTree` with geometry: leaves
        within r2 become the near part, and the map is drawn from views. That needs the unit "triangle", the channels
        "color" and "range", and the CPU.
    center
        World position O in metres that the map is baked from: an eye's height above the ground, in the middle of the
        users' area.
    r1, r2
        Radii in metres about the vertical axis through O, 0 ≤ r1 < r2. Inside r1 nothing is moved; beyond r2 only the
        map is visible; between the radii the morph interpolates.
    face_size
        Number of texels across each of the map's six faces, 1 to 16,384.
    morph
        "blend" (Popescu et al. 2022) and "cylinder" (CloVR 2024, points keep their distance from the axis) are
        continuous. "none" is the conventional method, whose picture breaks at the end of the near part.
    boundary
        For "none", the radius at which the near part ends and the map begins: "r2", or "r1" as in figure 1 of the
        paper. The continuous methods need "r2".
    unit
        "triangle": triangles within r2 are geometry, and pictures are split at r2. "object", as in CloVR: objects that
        reach inside r2 are geometry as a whole, also beyond r2, where they are drawn in the direction in which the
        centre sees them if nothing in the map is nearer; so the map has range. These objects are dynamic then.
    channels
        Channels of the map: "color" always, "range" and "object_id" if named. Scenes with moving objects always get
        range, because it decides which of them far buildings hide.
    samples
        Number of colour samples of each texel, 1 to 1024.
    range_dtype
        Type of the map's range: float32, or float16, which halves memory and file and has an error of at most 2⁻¹¹ of
        the range.
    backend
        Backend that bakes the map: "cpu", "gpu", "auto" or None, as in `render`.

    Returns
    -------
    ReducedScene
        The reduced scene, without a map if nothing lies beyond the near part.

    Raises
    ------
    ValueError, TypeError
        Arguments out of range, float16 if the map's range exceeds 65,504 m, or a world without geometry within r2.
    DeviceError
        As in `render`.

    References
    ----------
    Popescu, Lee, Choi, Fahmy (2022): Eq. 1–3 and figure 1. "cylinder" is Alg. 1 of CloVR (2024).
    """
    if not isinstance(scene, Divided):
        core_of(scene)
    check.choice("unit", unit, UNITS)
    check_morph(morph, check.choice("boundary", boundary, ("r1", "r2")))
    baking = Baking.check_settings(face_size, samples, channels, backend, range_dtype)
    zones: dict[str, Any] = {"center": center, "r1": r1, "r2": r2, "unit": unit}
    if isinstance(scene, Divided):
        if unit != "triangle":
            raise ValueError(f"unit: expected triangle for {type(scene).__name__}, got {unit}")
        if backend not in (None, "cpu"):
            raise ValueError(f"backend: expected cpu for {type(scene).__name__}, got {backend}")
        parts = stages.divided(
            scene,
            center=center,
            r1=r1,
            r2=r2,
            boundary=boundary,
            size=baking.face_size,
            samples=baking.samples,
            channels=baking.channels,
            half=baking.half,
        )
        return ReducedScene(**parts, morph=morph, boundary=boundary, baking=baking, is_whole=False)
    parts = stages.parts(scene, **zones, boundary=boundary, **baking.arguments(scene))
    return ReducedScene(**parts, morph=morph, boundary=boundary, baking=baking)
