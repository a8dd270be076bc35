"""Converts meshes and scenes of trimesh."""

from __future__ import annotations

import io
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base import background, check
from nearfar._scene.content import Content, Nodes, Shape
from nearfar._scene.materials import Materials, colors_of
from nearfar._scene.report import count

if TYPE_CHECKING:
    import trimesh

_LINEAR_COLORS = ("glb", "gltf")
"""Formats with linear vertex colours, which trimesh does not convert."""

_NEAR = 1e-6
"""Tolerance when a normal is compared with the one that trimesh computes."""


def parse(data: bytes, kind: str, resolver: Any) -> Any:
    """Parse a file with trimesh; `kind` is its suffix without the dot."""
    import trimesh

    return trimesh.load_scene(io.BytesIO(data), file_type=kind, resolver=resolver, process=False)


def read(label: str, loaded: trimesh.Trimesh | trimesh.Scene, materials: Materials | None = None) -> Content:
    """Convert a mesh or a scene, whose nodes become objects; `materials` is None for one that the caller made."""
    trimesh = background.module("trimesh")
    if isinstance(loaded, trimesh.Trimesh):
        loaded = trimesh.Scene({"object": loaded})
    if not isinstance(loaded, trimesh.Scene):
        raise TypeError(f"loaded: expected a trimesh.Trimesh or trimesh.Scene, got {type(loaded).__name__}")
    fresh, materials = materials is not None, materials or Materials()
    meshes = {name: mesh for name, mesh in loaded.geometry.items() if isinstance(mesh, trimesh.Trimesh)}
    shapes = {name: _shape(mesh, materials, fresh=fresh) for name, mesh in meshes.items()}
    other_count = len(loaded.geometry) - len(shapes)
    notes = [f"{count(other_count, 'geometry', 'geometries')} without triangles ignored"] if other_count else []
    notes += [
        f"texture coordinates of mesh {check.shortened(name)} ignored: {len(mesh.visual.uv):,} rows for "
        f"{len(mesh.vertices):,} vertices"
        for name, mesh in meshes.items()
        if getattr(mesh.visual, "uv", None) is not None and len(mesh.visual.uv) != len(mesh.vertices)
    ]
    units = [str(mesh.units or "") for mesh in meshes.values()]
    return Content(label, shapes, _nodes(loaded, shapes), notes, units=units)


def _nodes(scene: trimesh.Scene, shapes: dict[str, Shape]) -> Nodes:
    """Placed shapes, found in one pass over the graph, because trimesh's look-up walks a path for each node."""
    forest = scene.graph.transforms
    children = forest.children
    world: dict[Any, NDArray[np.float64]] = {scene.graph.base_frame: np.eye(4)}
    pending = [scene.graph.base_frame]
    while pending:
        parent = pending.pop()
        for child in children.get(parent, ()):
            if child not in world:
                matrix = forest.edge_data[(parent, child)].get("matrix")
                world[child] = world[parent] if matrix is None else world[parent] @ matrix
                pending.append(child)
    data = ((name, data.get("geometry")) for name, data in forest.node_data.items())
    return Nodes.from_rows(
        [(str(name), world[name], shape) for name, shape in data if shape in shapes and name in world]
    )


def source_normals(mesh: trimesh.Trimesh, *, fresh: bool = False) -> NDArray[np.float64] | None:
    """Vertex normals (V, 3) that the source of a mesh states; None without.

    Trimesh stores stated and computed normals in one place, so stated ones are those that differ from computed ones. A
    `fresh` mesh was just loaded and has no computed normals.
    """
    from trimesh.geometry import weighted_vertex_normals

    # Trimesh's look-up would hash the arrays to detect changes.
    stored = mesh._cache.cache.get("vertex_normals") if fresh else mesh._cache["vertex_normals"]
    if stored is None or np.shape(stored) != mesh.vertices.shape:
        return None
    normals: NDArray[np.float64] = np.asarray(stored, np.float64)
    if fresh:
        return normals
    computed = weighted_vertex_normals(
        vertex_count=len(mesh.vertices), faces=mesh.faces, face_normals=mesh.face_normals, face_angles=mesh.face_angles
    )
    return None if np.allclose(normals, computed, rtol=0.0, atol=_NEAR) else normals


def _kind_of_fresh(visual: Any) -> str | None:
    """Return `visual.kind` of an unmodified mesh without hashing its arrays."""
    if not hasattr(visual, "_data"):
        return visual.kind  # type: ignore[no-any-return]
    stored = visual._data.data
    return next((kind for kind in ("vertex", "face") if np.size(stored.get(f"{kind}_colors", ()))), None)


def _shape(mesh: trimesh.Trimesh, materials: Materials, *, fresh: bool) -> Shape:
    shape = Shape(mesh.vertices.view(np.ndarray), mesh.faces.view(np.ndarray))
    shape.normals = source_normals(mesh, fresh=fresh)
    visual, kind = mesh.visual, _kind_of_fresh(mesh.visual) if fresh else mesh.visual.kind
    linear = getattr(getattr(mesh, "source", None), "file_type", None) in _LINEAR_COLORS
    if kind == "texture":
        shape.materials = materials.base_colors(visual.material)
        if visual.uv is not None and len(visual.uv) == len(shape.vertices):
            shape.uvs = visual.uv
        if visual.face_materials is not None and len(shape.materials) > 1:
            shape.face_material = np.asarray(visual.face_materials, np.int64)
        if (colors := visual.vertex_attributes.get("color")) is not None:
            shape.colors = colors_of(np.asarray(colors), len(shape.vertices), linear=linear)
    elif kind == "vertex":
        shape.colors = colors_of(np.asarray(visual.vertex_colors), len(shape.vertices), linear=linear)
    elif kind == "face":
        shape.color_faces(np.asarray(visual.face_colors))
    return shape
