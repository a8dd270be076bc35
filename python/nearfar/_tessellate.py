"""Triangles split until morphing their vertices is as good as morphing every point, for every user of a region."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeVar, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check, progress
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
) -> Mesh:
    """Split triangles until a vertex shader that morphs corners shows every point where `morph` does.

    The error has a bound, not an estimate: for kind "blend", every user of the region and every point of the surface,
    the picture is within the tolerance of the exact morph. Edges are split by what they are alone, so neighbours stay
    joined, within a mesh and between meshes and objects. What lies within r1 or beyond r2 stays as it is, bit for bit,
    and so do objects that move: poses take them elsewhere, and `ReducedScene.render` splits them for each frame.

    Parameters
    ----------
    mesh
        A `Scene`, or a `trimesh.Trimesh` in its own frame, y up. Attributes are interpolated at new vertices: texture
        coordinates and numbers linearly, a scene's vertex colours in linear light, normals to unit length, and whole
        numbers taken from the nearest corner. Meshes that are placed several times are shared as far as their copies
        need no split.
    center
        The centre O, metres.
    r1, r2
        Radii in metres, 0 < r1 < r2.
    user_region
        Where users' eyes can be: a radius in metres about the centre, or a box (2, 3) of least and greatest corner in
        the frame of `center`. A box counts as the ball about the centre that holds it, at most 0.6 r1.
    tolerance_px
        Greatest error in pixels.
    camera
        A perspective view or cube face with the users' resolution. Its finest pixel counts, at the image's corner;
        where it stands and looks doesn't.

    Returns
    -------
    Scene or trimesh.Trimesh
        The same for any number of threads. A trimesh keeps its vertices and gets new ones at the end.

    Raises
    ------
    ValueError
        For radii out of order, regions that leave 0.6 r1, where no bound is known, tolerances that triangles of
        (r2 − r1)/4096 do not reach, and parallel rays.
    TypeError
        For meshes of another type.
    MemoryError
        Where the result does not fit.

    References
    ----------
    Popescu, Lee, Choi, Fahmy (2022) morph vertices; the bound of what that misses is ours.
    """
    middle = check.vector("center", center)
    near, far = check.radii(r1, r2)
    settings: dict[str, Any] = {
        "center": middle,
        "r1": near,
        "r2": far,
        "reach": _reach(user_region, middle),
        "tolerance": check.positive("tolerance_px", tolerance_px) * _pixel_angle(camera),
    }
    if isinstance(mesh, Scene):
        with progress.bar("tessellating") as report:
            core, _counts = _core.tessellate_scene(mesh._core, **settings, report=report)
        return mesh._derived(core, mesh._rest)
    return _tessellate_trimesh(mesh, settings)


def _pixel_angle(camera: Camera) -> float:
    if not isinstance(camera, Camera):
        raise TypeError(f"camera: expected a Camera, got {type(camera).__name__}")
    if camera._core.is_parallel:
        raise ValueError("camera: expected a perspective view or a cube face, got parallel rays")
    return camera._core.least_pixel_angle


def _reach(region: ArrayLike, center: tuple[float, float, float]) -> float:
    """Greatest distance of a user from the centre."""
    if np.ndim(region) == 0:
        reach = check.number("user_region", cast("float", region))
        if reach < 0.0:
            raise ValueError(f"user_region: expected a radius of at least 0, got {reach}")
        return reach
    box = check.array("user_region", region, columns=None, dtype=np.float64, finite=True)
    if box.shape != (2, 3) or (box[0] > box[1]).any():
        raise ValueError(
            f"user_region: expected a radius or a box (2, 3) of least and greatest corner, got {np.asarray(region)}"
        )
    return float(np.linalg.norm(np.abs(box - np.array(center)).max(axis=0)))


def _tessellate_trimesh(mesh: trimesh.Trimesh, settings: dict[str, Any]) -> trimesh.Trimesh:
    import trimesh

    from nearfar._scene.load_trimesh import given_normals

    if not isinstance(mesh, trimesh.Trimesh):
        raise TypeError(f"mesh: expected a Scene or a trimesh.Trimesh, got {type(mesh).__name__}")
    vertices = check.array("mesh.vertices", mesh.vertices.view(np.ndarray), dtype=np.float64, finite=True)
    faces = check.array("mesh.faces", mesh.faces.view(np.ndarray), dtype=np.uint32)
    if faces.size and int(faces.max()) >= len(vertices):
        raise ValueError(f"mesh.faces: expected vertex numbers below {len(vertices)}, got {faces.max()}")
    with progress.bar("tessellating") as report:
        made = _core.tessellate_arrays(vertices, faces, **settings, report=report)
    corners, weights, sources = faces[made["point_faces"]], made["weights"], made["sources"]
    normals = given_normals(mesh)
    return trimesh.Trimesh(
        vertices=np.concatenate([vertices, made["points"]]),
        faces=made["faces"],
        process=False,
        vertex_normals=None if normals is None else _extended_normals(normals, corners, weights),
        visual=_visual(mesh, corners, weights, sources),
        metadata=dict(mesh.metadata),
        vertex_attributes={
            name: _extended(np.asarray(values), corners, weights) for name, values in mesh.vertex_attributes.items()
        },
        face_attributes={name: np.asarray(values)[sources] for name, values in mesh.face_attributes.items()},
    )


def _visual(mesh: trimesh.Trimesh, corners: NDArray[Any], weights: NDArray[Any], sources: NDArray[Any]) -> Any:
    import trimesh

    visual = mesh.visual
    if visual.kind == "texture":
        uv = None if visual.uv is None else _extended(np.asarray(visual.uv), corners, weights)
        owner = None if visual.face_materials is None else np.asarray(visual.face_materials)[sources]
        return trimesh.visual.TextureVisuals(uv=uv, material=visual.material, face_materials=owner)
    if visual.kind == "vertex":
        colors = np.asarray(visual.vertex_colors)
        mixed = np.einsum("nk,nkc->nc", weights, colors[corners].astype(np.float64))
        return trimesh.visual.ColorVisuals(vertex_colors=np.concatenate([colors, np.rint(mixed).astype(colors.dtype)]))
    if visual.kind == "face":
        return trimesh.visual.ColorVisuals(face_colors=np.asarray(visual.face_colors)[sources])
    return None


def _extended_normals(normals: NDArray[Any], corners: NDArray[Any], weights: NDArray[Any]) -> NDArray[Any]:
    """Normals of the vertices and, of unit length, of the new ones behind them; zero where they cancel out."""
    mixed = _extended(normals, corners, weights)[len(normals) :]
    length = np.linalg.norm(mixed, axis=1, keepdims=True)
    return np.concatenate([normals, np.divide(mixed, length, out=np.zeros_like(mixed), where=length > 0)])


def _extended(values: NDArray[Any], corners: NDArray[Any], weights: NDArray[Any]) -> NDArray[Any]:
    """Values of the vertices and of the new ones behind them."""
    if values.dtype.kind != "f":
        nearest = corners[np.arange(len(corners)), weights.argmax(axis=1)] if len(corners) else corners[:, 0]
        return np.concatenate([values, values[nearest]])
    mixed = np.einsum("nk,nk...->n...", weights, values[corners].astype(np.float64))
    return np.concatenate([values, mixed.astype(values.dtype)])
