"""Near–far reduction: checks the arguments and runs the stages."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Unpack

from numpy.typing import ArrayLike

from nearfar._base import check
from nearfar._base.settings import gather
from nearfar._partition.partition import UNITS, Unit
from nearfar._reduce import default_radii, stages
from nearfar._reduce.baking import MapKeywords, MapSettings
from nearfar._reduce.drawing import BOUNDARIES, Boundary, MorphKind, check_morph
from nearfar._reduce.reduced_scene import ReducedScene
from nearfar._reduce.stages import NearFarSource
from nearfar._scene.scene import Scene, core_of


def reduce(
    scene: Scene | NearFarSource,
    *,
    center: ArrayLike | None = None,
    r1: float | None = None,
    r2: float | None = None,
    morph: MorphKind = "blend",
    boundary: Boundary = "r2",
    unit: Unit = "triangle",
    settings: MapSettings | None = None,
    **keywords: Unpack[MapKeywords],
) -> ReducedScene:
    """Reduce a scene: near triangles stay geometry, far ones are baked into a cube map, and a morph joins the two.

    The result has no map if nothing lies beyond the near part. ValueError and TypeError for arguments out of range,
    float16 if the map's range exceeds 65,504 m, or a world without geometry within r2; DeviceError as in `render`.
    Source: Popescu, Lee, Choi, Fahmy (2022): Eq. 1–3 and figure 1; "cylinder" is Alg. 1 of CloVR (2024).

    Parameters
    ----------
    scene
        The scene, or a world that provides its own near part and map, such as an `OrthoTree` with geometry: leaves
        within r2 become the near part, and the map is drawn from views. Such a world needs a centre and both radii, the
        unit "triangle", only the channels "color" and "range", and the CPU.
    center
        World position O in metres that the map is baked from: an eye's height above the ground, in the middle of the
        users' area. None chooses an open place near the middle of the scene, or a place in front of a scene that is a
        single object. The command `nearfar reduce` has fixed views for built-in scenes instead.
    r1, r2
        Radii in metres about the vertical axis through O, 0 ≤ r1 < r2. Inside r1 nothing is moved; beyond r2 only the
        map is visible; between the radii the morph interpolates. None chooses a radius as `nearfar reduce` does: r2
        from the distances of the surroundings, r1 by the shear of the ground (`choose_radii`). The result's `reason`
        states the chosen values and why.
    morph
        "blend" (Popescu et al. 2022) and "cylinder" (CloVR 2024, points keep their distance from the axis) are
        continuous. "none" is the conventional method, whose picture breaks at the end of the near part.
    boundary
        For "none", the radius at which the near part ends and the map begins: "r2", or "r1" as in figure 1 of the
        paper. The continuous methods need "r2".
    unit
        "triangle": triangles within r2 are geometry, and pictures are split at r2. "object", as in CloVR: objects that
        reach inside r2 are geometry as a whole, and count as dynamic. Their parts beyond r2 are drawn in the direction
        in which the centre sees them, if nothing in the map is nearer; so the map has range.
    settings
        Size, samples, channels and backend of the map, as `MapSettings`.
    keywords
        Fields of `settings`, which they replace: `face_size`, `samples`, `channels`, `range_dtype`, `backend`.
    """
    check.choice("unit", unit, UNITS)
    check_morph(morph, check.choice("boundary", boundary, BOUNDARIES))
    reasons: Mapping[str, str] = {}
    if isinstance(scene, NearFarSource):
        kind = type(scene).__name__
        if unit != "triangle":
            raise ValueError(f"unit: expected triangle for {kind}, got {unit}")
        for name, value in (("center", center), ("r1", r1), ("r2", r2)):
            if value is None:
                raise ValueError(f"{name}: expected metres for {kind}, got None, which is chosen for a Scene only")
    else:
        core_of(scene)
    baking = gather(MapSettings, settings, keywords)
    if isinstance(scene, Scene) and (center is None or r1 is None or r2 is None):
        center, r1, r2, reasons = default_radii.complete(scene, center, r1, r2)
    arguments: dict[str, Any] = {"center": center, "r1": r1, "r2": r2, "boundary": boundary, "baking": baking}
    parts, is_whole = stages.parts(scene, unit=unit, **arguments), isinstance(scene, Scene)
    reduced = ReducedScene(**parts, morph=morph, boundary=boundary, baking=baking, is_whole=is_whole)
    return reduced._replace(_reasons=reasons)
