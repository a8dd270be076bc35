"""Variants of glTF meshes: a mesh is drawn differently for other skins, morph weights or colours of instances."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from nearfar._base.errors import UnusableError
from nearfar._base.glb import entry
from nearfar._scene.coordinates import is_number
from nearfar._scene.gltf.corners import drawn_primitives

WHITE = (1.0, 1.0, 1.0, 1.0)


@dataclass(frozen=True)
class Variant:
    """Skin, morph weights and colour with which a mesh is drawn."""

    skin: int | None = None
    weights: tuple[float, ...] = ()
    """Weights of the morph targets; empty if all are 0."""
    tint: tuple[float, ...] = WHITE
    """Linear RGBA that multiplies the base colour."""


PLAIN = Variant()


@dataclass(frozen=True)
class Variants:
    """Variants of a document's meshes."""

    by_mesh: Mapping[int, Variant]
    """Variants by mesh index, except plain ones."""
    meshes: Mapping[int, Sequence[int]]
    """Mesh indices of each node with a mesh: one, or one for each of its instances."""

    def is_skinned(self, node: int) -> bool:
        """Whether a skin places a node's mesh; the node's own transform is then ignored (glTF 2.0, 3.7.3.3)."""
        return any(self.by_mesh.get(mesh, PLAIN).skin is not None for mesh in self.meshes.get(node, ()))


NONE = Variants({}, {})
"""No variants: each node draws the mesh that the document states."""


def assign(header: dict[str, Any], nodes: Iterable[int], tints: Mapping[int, Sequence[Sequence[float]]]) -> Variants:
    """Find the variants that the nodes draw, and append a mesh to the document for each further variant of a mesh.

    `tints` are the linear RGBA of instances (N, 4), by node index.
    """
    numbers: dict[tuple[int, Variant], int] = {}
    used: set[int] = set()
    meshes: dict[int, list[int]] = {}
    for number in nodes:
        node = header["nodes"][number]
        if "mesh" not in node:
            continue
        mesh = node["mesh"]
        skin, weights = _skin(header, node), _weights(header, node)
        meshes[number] = []
        for tint in tints.get(number, (WHITE,)):
            key = (mesh, Variant(skin, weights, tuple(tint)))
            if key not in numbers:
                numbers[key] = len(header["meshes"]) if mesh in used else mesh
                if mesh in used:
                    header["meshes"].append(header["meshes"][mesh])
                used.add(mesh)
            meshes[number].append(numbers[key])
    return Variants({mesh: variant for (_, variant), mesh in numbers.items() if variant != PLAIN}, meshes)


def is_jointed(primitive: dict[str, Any]) -> bool:
    """Whether a primitive's vertices refer to joints."""
    return {"JOINTS_0", "WEIGHTS_0"}.issubset(primitive.get("attributes", {}))


def _skin(header: dict[str, Any], node: dict[str, Any]) -> int | None:
    """Index of a node's skin; None without one, and for meshes without joints."""
    if "skin" not in node or not any(map(is_jointed, drawn_primitives(entry(header, "meshes", node["mesh"])))):
        return None
    entry(header, "skins", node["skin"])
    skin: int = node["skin"]
    return skin


def _weights(header: dict[str, Any], node: dict[str, Any]) -> tuple[float, ...]:
    """Default weights of a node's morph targets, its own or else its mesh's; empty if all are 0."""
    mesh = entry(header, "meshes", node["mesh"])
    if not any("targets" in primitive for primitive in drawn_primitives(mesh)):
        return ()
    weights = node.get("weights", mesh.get("weights", []))
    if not isinstance(weights, list) or not all(map(is_number, weights)):
        raise UnusableError(f"expected finite numbers as weights of mesh {node['mesh']}, got others")
    return tuple(map(float, weights)) if any(weights) else ()
