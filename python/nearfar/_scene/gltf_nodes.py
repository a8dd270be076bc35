"""The nodes of glTF files: trees without loops, and the places of the meshes that they hold."""

from __future__ import annotations

from collections.abc import Container
from typing import Any

from nearfar._base.errors import UnusableError
from nearfar._scene.source import Node, world_transforms


def check_trees(header: dict[str, Any]) -> None:
    """Refuse nodes that are not trees (glTF 2.0, 3.5.2): with two parents, or with one although a scene lists them.

    No scene reaches a loop of other nodes, and what none reaches is not drawn.
    """
    parents: dict[int, int] = {}
    for number, node in enumerate(header.get("nodes", [])):
        for child in node.get("children", []):
            if child == number:
                raise UnusableError(f"its node {number} is a child of itself")
            if child in parents:
                raise UnusableError(f"its node {child} is a child of node {parents[child]} and again of node {number}")
            parents[child] = number
    for number, scene in enumerate(header.get("scenes", [])):
        below = next((root for root in scene.get("nodes", []) if root in parents), None)
        if below is not None:
            raise UnusableError(f"its scene {number} lists node {below}, which is a child of node {parents[below]}")


def free_nodes(header: dict[str, Any], skipped: Container[int]) -> bool:
    """Remove cameras and the skipped meshes from nodes; returns whether there were any.

    Trimesh drops a node with a camera, or with a mesh of which it skips all primitives, and loses the transforms of its
    children.
    """
    changed = False
    for node in header.get("nodes", []):
        if "camera" in node or ("mesh" in node and node["mesh"] in skipped):
            changed = True
            node.pop("camera", None)
            if node.get("mesh") in skipped:
                del node["mesh"]
    return changed


def placed(parts: dict[str, Any], header: dict[str, Any], shapes: Container[str]) -> list[Node]:
    """Placed shapes in the file's order; trimesh's traversal reverses it."""
    named = {str(node.get("name", index)) for index, node in enumerate(header.get("nodes", []))}
    edges = [(edge["frame_from"], edge["frame_to"], edge.get("matrix")) for edge in parts["graph"]]
    world = world_transforms(edges, parts["base_frame"])
    nodes = []
    for edge in reversed(parts["graph"]):
        if edge.get("geometry") in shapes:
            frame, above = edge["frame_to"], edge["frame_from"]
            # Trimesh gives each primitive of a node its own frame, named after the node with a random suffix.
            is_primitive = frame not in named and frame.startswith(f"{above}_") and len(frame) == len(above) + 7
            nodes.append(Node(above if is_primitive else frame, world[frame], edge["geometry"]))
    return nodes
