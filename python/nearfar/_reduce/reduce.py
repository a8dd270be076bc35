"""Near–far reduction: checks the arguments and runs the stages."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal, Unpack, get_args, overload

from numpy.typing import ArrayLike

from nearfar._base import check
from nearfar._base.settings import gather
from nearfar._impostor.settings import ImpostorKeywords, ImpostorSettings
from nearfar._partition.load_curve import load_curve
from nearfar._partition.partition import UNITS, Unit
from nearfar._reduce import default_radii, stages
from nearfar._reduce.baking import MapKeywords, MapSettings
from nearfar._reduce.drawing import BOUNDARIES, Boundary, MorphKind, check_morph
from nearfar._reduce.impostors import Impostors, reduce_to_impostors
from nearfar._reduce.reduced_scene import ReducedScene
from nearfar._reduce.stages import NearFarSource
from nearfar._scene.scene import Scene, core_of

FarPart = Literal["map", "impostors"]
"""Kind of the far part: a map of the centre with a morph, or quads baked from several centres."""

FAR_PARTS: tuple[FarPart, ...] = get_args(FarPart)

_NEAR_SHARE = 0.75
"""Greatest share of a budget of triangles that the near part takes if r2 is chosen."""


@overload
def reduce(
    scene: Scene | NearFarSource,
    *,
    center: ArrayLike | None = None,
    r1: float | None = None,
    r2: float | None = None,
    far: Literal["map"] = "map",
    morph: MorphKind = "blend",
    boundary: Boundary = "r2",
    unit: Unit = "triangle",
    settings: MapSettings | None = None,
    **keywords: Unpack[MapKeywords],
) -> ReducedScene: ...
@overload
def reduce(
    scene: Scene,
    *,
    center: ArrayLike | None = None,
    r2: float | None = None,
    far: Literal["impostors"],
    settings: ImpostorSettings | None = None,
    **keywords: Unpack[ImpostorKeywords],
) -> Impostors: ...
def reduce(
    scene: Scene | NearFarSource,
    *,
    center: ArrayLike | None = None,
    r1: float | None = None,
    r2: float | None = None,
    far: FarPart = "map",
    morph: MorphKind = "blend",
    boundary: Boundary = "r2",
    unit: Unit = "triangle",
    settings: Any = None,
    **keywords: Any,
) -> ReducedScene | Impostors:
    """Reduce a scene: near triangles stay geometry, and far ones are baked, into a cube map or as textured quads.

    With `far="map"`, the published method, a morph joins near geometry and map. The quads of `far="impostors"` keep
    their parallax within a region, without a morph, and all near triangles that users can see are drawn whole. The
    result has no far part if nothing lies beyond the near part. ValueError and TypeError for arguments out of range,
    float16 if the map's range exceeds 65,504 m, or a world without geometry within r2; DeviceError as in `render`.
    Source of the map and the morph: Popescu, Lee, Choi, Fahmy (2022): Eq. 1–3 and figure 1; "cylinder" is Alg. 1 of
    CloVR (2024). Related to the quads: Seurat (Lall et al. 2018), layered meshes (Broxton et al. 2020), QUASAR (Lu et
    al. 2025).

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
    far
        "map": a `ReducedScene`. "impostors": an `Impostors`, of a Scene only. These take `center`, `r2` and `settings`;
        `center` is the middle of a sphere of users, and r2 must exceed its radius `reach`. Dynamic objects stay
        geometry at any distance, and so do triangles that reach inside r2, and all far triangles that users see if they
        are fewer than those of quads and take fewer bytes.
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
        Size, samples, channels and backend of the map, as `MapSettings`; or region, error and budgets of impostors, as
        `ImpostorSettings`.
    keywords
        Fields of `settings`, which they replace: `face_size`, `samples`, `channels`, `range_dtype`, `backend`; or for
        impostors `reach`, `height`, `error_px`, `face_size`, `centers`, `missing`, `triangles`, `bytes`, `visible`.
    """
    check.choice("unit", unit, UNITS)
    if check.choice("far", far, FAR_PARTS) == "impostors":
        check_unmorphed(r1=(r1, None), morph=(morph, "blend"), boundary=(boundary, "r2"), unit=(unit, "triangle"))
        return _impostors(
            check.instance("scene", scene, Scene), center, r2, gather(ImpostorSettings, settings, keywords)
        )
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


def check_unmorphed(**arguments: tuple[object, object]) -> None:
    """Raise ValueError unless each argument, a value and its default by name, has its default."""
    for name, (value, default) in arguments.items():
        if not (value is default or (isinstance(value, str) and value == default)):
            raise ValueError(f"{name}: expected none with far='impostors', got {value}, which far='map' takes")


def _impostors(scene: Scene, center: ArrayLike | None, r2: float | None, settings: ImpostorSettings) -> Impostors:
    if center is not None and r2 is not None:
        place = check.vector("center", center)
        return reduce_to_impostors(scene, place, check.positive("r2", r2), settings)
    middle, _, radius, found = default_radii.complete(scene, center, None, r2)
    reasons = {name: reason for name, reason in found.items() if name != "r1"}
    if r2 is None and settings.triangles is not None:
        curve = load_curve(scene, center=middle)
        most = int(_NEAR_SHARE * settings.triangles)
        if scene.triangle_count > settings.triangles and curve.count(radius) > most >= curve.count(0.0):
            radius = float(f"{curve.radius(most):.3g}")
            reasons["r2"] = f"r2 = {radius:g} m leaves at most {most:,} of {settings.triangles:,} triangles near"
    return reduce_to_impostors(scene, middle, radius, settings, reasons)
