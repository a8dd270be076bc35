"""Creates levels of an object by simplification."""

from __future__ import annotations

import os
from collections.abc import Iterable
from dataclasses import replace
from typing import TYPE_CHECKING, Literal, get_args

import numpy as np

from nearfar._base import check, progress
from nearfar._scene.scene import Scene
from nearfar.lod._levels import Level, Levels
from nearfar.lod._simplify.deviation import deviation
from nearfar.lod._simplify.meshopt import MeshoptSimplifier
from nearfar.lod._simplify.quadrics import QuadricSimplifier
from nearfar.lod._simplify.surface import Base, Normals, Surface

if TYPE_CHECKING:
    import trimesh

RATIOS = (1.0, 0.7, 0.5, 0.35, 0.25, 0.18, 0.12, 0.08, 0.05, 0.03, 0.02)
"""Default shares of the base's triangles."""

Method = Literal["fast", "meshopt"]

_NOTE_TOLERANCE = 0.01
"""A level gets a note if its triangle count misses the requested one by more than this share and by more than 2."""


def simplify(
    mesh: Scene | trimesh.Trimesh | trimesh.Scene | str | os.PathLike[str],
    ratios: Iterable[float] = RATIOS,
    *,
    method: Method = "fast",
    normals: Normals = "keep",
    name: str | None = None,
) -> Levels:
    """Make levels of detail of an object: the same surface with decreasing triangle counts, with its textures.

    ValueError for no triangles, ratios out of range, or unknown methods; TypeError for values that are not meshes;
    SceneError for unusable meshes, such as those with vertices that are not finite; ModuleNotFoundError for "fast"
    without the package fast-simplification, which the extra ``lod`` installs. Sources: Garland, Heckbert (1997),
    Surface simplification using quadric error metrics; open borders and seams are kept by perpendicular planes as
    there. Aspert, Santa-Cruz, Ebrahimi (2002), MESH, for the distances.

    Parameters
    ----------
    mesh
        A scene, a trimesh mesh or scene, or a file for `Scene.load`. All of it counts as one object: parts are placed
        and simplified together, and keep their materials, textures, texture coordinates and vertex colours.
    ratios
        Shares of the base's triangles, above 0 and at most 1, in any order. The base itself is always level 0. A level
        without fewer triangles than its predecessor is left out, and the predecessor's note names the ratio.
    method
        "fast": quadrics by fast-simplification, which moves vertices to minimise the error. Attributes are looked up on
        the base within each chart, so that seams are preserved. Vertices at one place stay joined, so no cracks appear.
        "meshopt": meshoptimizer's simplifier, which keeps a subset of the vertices with their attributes, and includes
        attributes in the error. If it cannot reach the triangle count otherwise, it gives up seams of normals and
        colours, and then unconnected parts, small ones first. Small closed parts may disappear before that, as with
        "fast".
    normals
        "keep": the normals of the base, if it has any. "smooth": new normals for the base, weighted by the corners'
        angles; edges at which faces meet at more than 60° stay hard. "flat": no normals, so that faces are shaded flat.
    name
        Name of the object; by default the scene's, if that has one object, else the file's, else ``object``.

    Returns
    -------
    Levels
        Levels with their greatest and mean distance from the base, in both directions, measured from all vertices and
        20,000 points of each surface. `Level.note` names ratios that could not be reached. The result does not depend
        on the number of threads.
    """
    shares = read_ratios(ratios)
    check.choice("method", method, get_args(Method))
    check.choice("normals", normals, get_args(Normals))
    base = Base(mesh, name)
    base.with_normals(normals)
    simplifier = (QuadricSimplifier if method == "fast" else MeshoptSimplifier)(base.surface, base.places)
    levels, missing = [Level(scene=base.scene)], []
    with progress.bar("simplifying") as report:
        for number, share in enumerate(shares):
            report(number, len(shares))
            target = max(1, round(share * levels[0].triangle_count))
            level = _level(base, simplifier.level(target), share, target)
            if level is not None and level.triangle_count < levels[-1].triangle_count:
                levels.append(level)
            else:
                missing.append(f"{100.0 * share:.3g}")
        report(len(shares), len(shares))
    if missing:
        text = f"the simplifier found no level with {', '.join(missing)} % of the triangles"
        levels[-1] = replace(levels[-1], note="; ".join(filter(None, [levels[-1].note, text])))
    return Levels(levels, name=base.name, frame=base.frame)


def read_ratios(ratios: Iterable[float]) -> list[float]:
    """Return the shares below 1, descending, without duplicates; ValueError for numbers that are not shares."""
    if isinstance(ratios, np.ndarray):
        ratios = check.array("ratios", ratios, columns=None, dtype=np.float64).ravel().tolist()
    numbers = check.iterable("ratios", ratios, "numbers above 0 and at most 1")
    shares = [check.number(f"ratios[{number}]", ratio) for number, ratio in enumerate(numbers)]
    for number, share in enumerate(shares):
        if not 0 < share <= 1:
            raise ValueError(f"ratios[{number}]: expected a number above 0 and at most 1, got {share}")
    return sorted({share for share in shares if share < 1}, reverse=True)


def _level(base: Base, surface: Surface, share: float, target: int) -> Level | None:
    """Measure a level; None if nothing is left of the surface."""
    count = len(surface.faces)
    if not count:
        return None
    is_near = abs(count - target) <= max(target * _NOTE_TOLERANCE, 2)
    note = "" if is_near else f"{count:,} triangles instead of {target:,}"
    scene = base.scene_of(surface)
    error, mean = deviation((base.scene, base.surface), (scene, surface))
    return Level(scene=scene, ratio=share, error=error, mean_error=mean, note=note)
