"""Tessellation: splits triangles until morphing their vertices approximates morphing every point of them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeVar, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import background, check, progress
from nearfar._camera.camera import Camera
from nearfar._scene.scene import Scene

if TYPE_CHECKING:
    import trimesh

Mesh = TypeVar("Mesh", "Scene", "trimesh.Trimesh")


def tessellate(
    mesh: Mesh,
    *,
    center: ArrayLike,
    r1: float,
    r2: float,
    user_region: ArrayLike,
    tolerance_px: float,
    camera: Camera,
    kind: str = "blend",
    radius: float | None = None,
    strength: float = 1.0,
) -> Mesh:
    """Split triangles until a vertex shader that morphs corners shows every point where `morph` does.

    The error is proven to be bounded: for every user position in the region and every point of the surface, the picture
    differs from the exact morph by at most the tolerance. For kind "cylinder" this holds at every stage of its growth.
    Whether an edge is split depends on that edge alone, so neighbours stay joined, within a mesh and between meshes and
    objects. Triangles within r1, and those of a blend beyond r2, stay unchanged, bit for bit. So do moving objects,
    whose poses change: `ReducedScene.render` splits them in each frame.

    The result is the same for any number of threads. A trimesh keeps its vertices and gets new ones at the end.
    ValueError for radii out of order, regions beyond 0.6 r1, for "cylinder" half of r1 (no bound is known there),
    tolerances that need triangles smaller than (r2 − r1)/4096 or than the coordinates' digits, `radius` or `strength`
    for a "blend", and cameras with parallel rays; TypeError for meshes of another type; MemoryError if the result does
    not fit into memory. Source: Popescu, Lee, Choi, Fahmy (2022) morph vertices; the error bound is derived in this
    project.

    Parameters
    ----------
    mesh
        A `Scene`, or a `trimesh.Trimesh` in its own frame, y up. Attributes are interpolated at new vertices: texture
        coordinates and numbers linearly, a scene's vertex colours in linear light, and normals to unit length. Whole
        numbers are taken from the nearest corner. Instances of a mesh that need no split still share it.
    center
        The centre O, metres.
    r1, r2
        Radii in metres, 0 < r1 < r2.
    user_region
        Possible positions of users' eyes: a radius in metres about the centre, or a box (2, 3) of least and greatest
        corner in the frame of `center`. A box stands for the ball about the centre that encloses it. The radius is at
        most 0.6 r1, for "cylinder" half of the least r1.
    tolerance_px
        Greatest error in pixels, above 0.
    camera
        A perspective view or cube face with the users' resolution; its position and direction do not matter. The
        tolerance is measured in its finest pixels, at the image's corners.
    kind
        Kind of the morph, "blend" or "cylinder".
    radius
        For "cylinder": the least radius of a morph that grows to r2, in metres, above 0 and up to r2, the default; r1
        shrinks in proportion. The result serves all radii between.
    strength
        For "cylinder": the least strength, 0 to 1. Below 1 the result serves all strengths. Then points within r1 move,
        too; next to the axis, within 2.6 times the region's radius, no bound is known, and edges are not split below a
        64th of r2.
    """
    origin, radii = check.vector("center", center), check.radii(r1, r2)
    settings: dict[str, Any] = {
        "center": origin,
        "radii": radii,
        "grown": _grown(kind, radii[1], radius, strength),
        "reach": _reach(user_region, origin),
        "tolerance": check.positive("tolerance_px", tolerance_px) * _pixel_angle(camera),
    }
    if isinstance(mesh, Scene):
        with progress.bar("tessellating") as report:
            core, _counts = _core.tessellate_scene(mesh._core, settings, report=report)
        return mesh._derived(core, mesh._load_placements)
    return _tessellate_trimesh(mesh, settings)


def _grown(kind: str, r2: float, radius: float | None, strength: float) -> tuple[float, bool] | None:
    """Return the least radius of a growing morph, and whether its strength is always 1; None for a blend."""
    check.choice("kind", kind, ("blend", "cylinder"))
    least_strength = check.in_range("strength", strength, 0.0, 1.0)
    least_radius = r2 if radius is None else check.in_range("radius", check.positive("radius", radius), 0.0, r2)
    if kind == "cylinder":
        return least_radius, least_strength == 1.0
    if radius is not None or least_strength < 1.0:
        name = "strength" if radius is None else "radius"
        raise ValueError(f"{name}: expected none for kind 'blend', whose radii and strength are fixed")
    return None


def _pixel_angle(camera: Camera) -> float:
    check.instance("camera", camera, Camera)
    if camera._core.is_parallel:
        raise ValueError("camera: expected a perspective view or a cube face, got parallel rays")
    return camera._core.least_pixel_angle


def _reach(region: ArrayLike, center: tuple[float, float, float]) -> float:
    """Return the greatest distance of a user from the centre, metres."""
    if check.plain("user_region", region).ndim == 0:
        reach = check.number("user_region", cast("float", region))
        if reach < 0.0:
            raise ValueError(f"user_region: expected a radius of at least 0, got {reach}")
        return reach
    box = check.array("user_region", region, columns=None, dtype=np.float64, finite=True)
    if box.shape != (2, 3) or (box[0] > box[1]).any():
        got = box.tolist() if box.shape == (2, 3) else f"shape {box.shape}"
        raise ValueError(f"user_region: expected a radius or a box (2, 3) of least and greatest corner, got {got}")
    return float(np.linalg.norm(np.abs(box - np.array(center)).max(axis=0)))


def _tessellate_trimesh(mesh: trimesh.Trimesh, settings: dict[str, Any]) -> trimesh.Trimesh:
    trimesh = background.module("trimesh")
    from nearfar._scene.load_trimesh import source_normals

    check.instance("mesh", mesh, trimesh.Trimesh, "a Scene or a trimesh.Trimesh")
    vertices = check.array("mesh.vertices", mesh.vertices.view(np.ndarray), dtype=np.float64, finite=True)
    faces = check.array("mesh.faces", mesh.faces.view(np.ndarray), dtype=np.uint32)
    if faces.size and int(faces.max()) >= len(vertices):
        raise ValueError(f"mesh.faces: expected vertex numbers below {len(vertices)}, got {faces.max()}")
    with progress.bar("tessellating") as report:
        split = _core.tessellate_arrays(vertices, faces, settings, report=report)
    corners, weights, sources = faces[split["point_faces"]], split["weights"], split["sources"]
    normals = source_normals(mesh)
    return trimesh.Trimesh(
        vertices=np.concatenate([vertices, split["points"]]),
        faces=split["faces"],
        process=False,
        vertex_normals=None if normals is None else _interpolate_normals(normals, corners, weights),
        visual=_visual(mesh, corners, weights, sources),
        metadata=dict(mesh.metadata),
        vertex_attributes={
            name: _interpolate(np.asarray(values), corners, weights) for name, values in mesh.vertex_attributes.items()
        },
        face_attributes={name: np.asarray(values)[sources] for name, values in mesh.face_attributes.items()},
    )


def _visual(mesh: trimesh.Trimesh, corners: NDArray[Any], weights: NDArray[Any], sources: NDArray[Any]) -> Any:
    import trimesh

    visual = mesh.visual
    if visual.kind == "texture":
        uv = None if visual.uv is None else _interpolate(np.asarray(visual.uv), corners, weights)
        owner = None if visual.face_materials is None else np.asarray(visual.face_materials)[sources]
        return trimesh.visual.TextureVisuals(uv=uv, material=visual.material, face_materials=owner)
    if visual.kind == "vertex":
        colors = np.asarray(visual.vertex_colors)
        mixed = np.einsum("nk,nkc->nc", weights, colors[corners].astype(np.float64))
        return trimesh.visual.ColorVisuals(vertex_colors=np.concatenate([colors, np.rint(mixed).astype(colors.dtype)]))
    if visual.kind == "face":
        return trimesh.visual.ColorVisuals(face_colors=np.asarray(visual.face_colors)[sources])
    return None


def _interpolate_normals(normals: NDArray[Any], corners: NDArray[Any], weights: NDArray[Any]) -> NDArray[Any]:
    """Return normals of old vertices, then unit normals of new ones; zero where the corners' normals cancel out."""
    mixed = _interpolate(normals, corners, weights)[len(normals) :]
    length = np.linalg.norm(mixed, axis=1, keepdims=True)
    return np.concatenate([normals, np.divide(mixed, length, out=np.zeros_like(mixed), where=length > 0)])


def _interpolate(values: NDArray[Any], corners: NDArray[Any], weights: NDArray[Any]) -> NDArray[Any]:
    """Return the values of the old vertices, followed by the values of the new ones."""
    if values.dtype.kind != "f":
        nearest = corners[np.arange(len(corners)), weights.argmax(axis=1)] if len(corners) else corners[:, 0]
        return np.concatenate([values, values[nearest]])
    mixed = np.einsum("nk,nk...->n...", weights, values[corners].astype(np.float64))
    return np.concatenate([values, mixed.astype(values.dtype)])
