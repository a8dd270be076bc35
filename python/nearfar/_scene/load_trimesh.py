"""Trimesh's own objects as a source."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from nearfar._scene.materials import BaseColor, Materials, colors_of, to_linear
from nearfar._scene.report import count
from nearfar._scene.source import Node, Shape, Source, world_transforms

if TYPE_CHECKING:
    import trimesh

_LINEAR_COLORS = ("glb", "gltf")
"""Formats whose vertex colours trimesh passes on as they are: linear."""


_NEAR = 1e-6
"""By how much normals that trimesh works out may differ from those that it worked out before."""


def read(label: str, loaded: trimesh.Trimesh | trimesh.Scene, *, fresh: bool = False) -> Source:
    """Read a mesh or a scene; names of nodes become objects. A fresh one is as a file made it, nothing worked out."""
    import trimesh

    if isinstance(loaded, trimesh.Trimesh):
        loaded = trimesh.Scene({"object": loaded})
    if not isinstance(loaded, trimesh.Scene):
        raise TypeError(f"expected a trimesh.Trimesh or trimesh.Scene, got {type(loaded).__name__}")
    materials = Materials()
    meshes = {name: mesh for name, mesh in loaded.geometry.items() if isinstance(mesh, trimesh.Trimesh)}
    shapes = {name: _shape(mesh, materials, fresh=fresh) for name, mesh in meshes.items()}
    other = len(loaded.geometry) - len(shapes)
    notes = [f"{count(other, 'geometry', 'geometries')} without triangles ignored"] if other else []
    return Source(label, shapes, _nodes(loaded, shapes), notes)


def _nodes(scene: trimesh.Scene, shapes: dict[str, Shape]) -> list[Node]:
    """Placed shapes. Trimesh's own look-up of a transform walks a path for each node; one pass over all is enough."""
    forest = scene.graph.transforms
    children = forest.children
    edges: list[tuple[Any, Any, Any]] = []
    pending = [scene.graph.base_frame]
    seen = set(pending)
    while pending:
        parent = pending.pop()
        for child in children.get(parent, ()):
            if child not in seen:
                seen.add(child)
                edges.append((parent, child, forest.edge_data[(parent, child)].get("matrix")))
                pending.append(child)
    world = world_transforms(edges, scene.graph.base_frame)
    placed = ((name, data.get("geometry")) for name, data in forest.node_data.items())
    return [Node(str(name), world[name], shape) for name, shape in placed if shape in shapes and name in world]


def given_normals(mesh: trimesh.Trimesh, *, fresh: bool = False) -> NDArray[np.float64] | None:
    """Vertex normals that a mesh was given; none where it has none, or those that trimesh works out from the faces.

    Both lie in one place, so that only a comparison tells them apart; a fresh mesh has none of the second kind.
    """
    from trimesh.geometry import weighted_vertex_normals

    known = mesh._cache["vertex_normals"]
    if known is None or np.shape(known) != mesh.vertices.shape:
        return None
    given: NDArray[np.float64] = np.asarray(known, np.float64)
    if fresh:
        return given
    own = weighted_vertex_normals(
        vertex_count=len(mesh.vertices), faces=mesh.faces, face_normals=mesh.face_normals, face_angles=mesh.face_angles
    )
    return None if np.allclose(given, own, rtol=0.0, atol=_NEAR) else given


def _shape(mesh: trimesh.Trimesh, materials: Materials, *, fresh: bool) -> Shape:
    shape = Shape(mesh.vertices.view(np.ndarray), mesh.faces.view(np.ndarray))
    shape.normals = given_normals(mesh, fresh=fresh)
    visual = mesh.visual
    linear = getattr(getattr(mesh, "source", None), "file_type", None) in _LINEAR_COLORS
    if visual.kind == "texture":
        shape.materials = materials.of(visual.material)
        if visual.uv is not None and len(visual.uv) == len(shape.vertices):
            shape.uvs = visual.uv
        if visual.face_materials is not None and len(shape.materials) > 1:
            shape.face_material = np.asarray(visual.face_materials, np.int64)
        colors = visual.vertex_attributes.get("color", None)
        if colors is not None:
            shape.colors = colors_of(np.asarray(colors), len(shape.vertices), linear=linear)
    elif visual.kind == "vertex":
        shape.colors = colors_of(np.asarray(visual.vertex_colors), len(shape.vertices), linear=linear)
    elif visual.kind == "face":
        _color_faces(shape, np.asarray(visual.face_colors))
    return shape


def _color_faces(shape: Shape, colors: np.ndarray) -> None:
    """Colours of faces become materials, so that neighbours need not stop sharing vertices."""
    distinct, shape.face_material = np.unique(colors, axis=0, return_inverse=True)
    for red, green, blue, alpha in np.column_stack([to_linear(distinct[:, :3] / 255), distinct[:, 3] / 255]).tolist():
        shape.materials.append(BaseColor((red, green, blue, alpha)))
