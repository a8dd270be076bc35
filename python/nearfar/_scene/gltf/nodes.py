"""Nodes of glTF files: checks that they form trees, composes their transforms, and places meshes and instances."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from itertools import islice
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base.errors import UnusableError
from nearfar._base.glb import entry
from nearfar._scene.budget import Budget
from nearfar._scene.content import Nodes
from nearfar._scene.gltf.buffers import Buffers
from nearfar._scene.gltf.variants import NONE, Variants
from nearfar._scene.names import distinct
from nearfar._scene.srgb import to_linear, to_srgb

INSTANCING = "EXT_mesh_gpu_instancing"
VISIBILITY = "KHR_node_visibility"

_TINT = "_COLOR_0"
"""Attribute of instances with linear RGB or RGBA, as three.js writes it."""

_MAX_TINTS = 256
"""Greatest number of distinct colours of a file's instances."""

_ROUNDING_STEPS = (255, 31, 15, 7, 5, 3)
"""Steps per channel to which colours of instances are rounded, tried in this order; 3 steps leave 4⁴ colours."""

_INSTANCE_DEFAULTS = {"TRANSLATION": (0.0, 0.0, 0.0), "ROTATION": (0.0, 0.0, 0.0, 1.0), "SCALE": (1.0, 1.0, 1.0)}
"""Defaults of the parts of a transform."""

INSTANCE_BYTES = 512
"""Bytes of memory per instance: several copies of its transform, its name and its row in the scene."""

Floats = NDArray[np.float64]


def check_trees(header: dict[str, Any]) -> None:
    """Reject nodes with two parents, and roots with a parent, because nodes form trees (glTF 2.0, 3.5.2).

    Other loops cannot be reached from a scene, so they are not drawn.
    """
    parents: dict[int, int] = {}
    nodes = header.get("nodes", [])
    for number, node in enumerate(nodes):
        for child in node.get("children", ()):
            if type(child) is not int or not 0 <= child < len(nodes):
                raise IndexError(f"node {child} of {len(nodes)}")
            if child == number:
                raise UnusableError(f"its node {number} is a child of itself")
            if child in parents:
                raise UnusableError(f"its node {child} is a child of node {parents[child]} and again of node {number}")
            parents[child] = number
    for number, scene in enumerate(header.get("scenes", [])):
        child = next((root for root in scene.get("nodes", []) if root in parents), None)
        if child is not None:
            raise UnusableError(f"its scene {number} lists node {child}, which is a child of node {parents[child]}")


def place_nodes(
    header: dict[str, Any],
    shapes: Mapping[int, Sequence[str]],
    instances: Mapping[int, Floats],
    variants: Variants = NONE,
) -> Nodes:
    """Return the placed shapes in the file's order, children before their parents.

    `shapes` are the names of each mesh's shapes, by mesh index. `instances` are the transforms instance→node (N, 4, 4)
    of nodes that place their mesh many times, by node index; each instance is an object. The `variants` state which
    meshes nodes draw.
    """
    nodes = header.get("nodes", [])
    order, parents = _traverse(header)
    world = _world_transforms(_local_transforms([nodes[number] for number in order]), parents)
    world[[variants.is_skinned(number) for number in order]] = np.eye(4)
    names = _object_names(nodes, instances)
    objects: list[str] = []
    shape_names: list[str] = []
    rows: list[int] = []
    # For each node with instances: its first row, its index, and the number of shapes of each instance.
    spans: list[tuple[int, int, list[int]]] = []
    for row, number in reversed([*enumerate(order)]):
        if "mesh" not in nodes[number]:
            continue
        entry(header, "meshes", nodes[number]["mesh"])
        mesh_shapes = [shapes.get(mesh, ())[::-1] for mesh in variants.meshes.get(number, (nodes[number]["mesh"],))]
        if len(mesh_shapes) == 1:
            mesh_shapes *= len(names[number])
        if number in instances:
            spans.append((len(rows), number, [*map(len, mesh_shapes)]))
        objects += [name for name, group in zip(names[number], mesh_shapes, strict=True) for _ in group]
        shape_names += [shape for group in mesh_shapes for shape in group]
        rows += [row] * sum(map(len, mesh_shapes))
    transforms = world[rows]
    for start, number, widths in spans:
        local = np.repeat(instances[number], widths, axis=0)
        transforms[start : start + len(local)] = transforms[start : start + len(local)] @ local
    return Nodes(objects, transforms, shape_names)


def _object_names(nodes: list[dict[str, Any]], instances: Mapping[int, Floats]) -> list[list[str]]:
    """Names of the objects that each node places: the node's name or index, made distinct."""
    counts = [len(instances[number]) if number in instances else 1 for number in range(len(nodes))]
    names = [str(node.get("name") or number) for number, node in enumerate(nodes)]
    all_names = iter(distinct([name for name, count in zip(names, counts, strict=True) for _ in range(count)]))
    return [list(islice(all_names, count)) for count in counts]


def _traverse(header: dict[str, Any]) -> tuple[list[int], list[int]]:
    """Indices of the scene's visible nodes and their parents' rows, as `_descendants` orders them."""
    roots = entry(header, "scenes", header.get("scene", 0)).get("nodes", []) if "scenes" in header else []
    for root in roots:
        entry(header, "nodes", root)
    # Duplicate roots are visited once.
    return _descendants(header.get("nodes", []), [*dict.fromkeys(roots)], skips_hidden=True)


def visible(header: dict[str, Any]) -> list[int]:
    """Indices of the scene's nodes that are neither hidden nor below a hidden one."""
    return _traverse(header)[0]


def is_hidden(node: dict[str, Any]) -> bool:
    """Whether a node and its children are not drawn (KHR_node_visibility)."""
    return node.get("extensions", {}).get(VISIBILITY, {}).get("visible", True) is False


def rest_transforms(header: dict[str, Any]) -> Floats:
    """Transforms node→scene (N, 4, 4) of all nodes, hidden or not; NaN for nodes in loops."""
    nodes = header.get("nodes", [])
    children = {child for node in nodes for child in node.get("children", ())}
    roots = [number for number in range(len(nodes)) if number not in children]
    order, parents = _descendants(nodes, roots, skips_hidden=False)
    transforms = np.full((len(nodes), 4, 4), np.nan)
    transforms[order] = _world_transforms(_local_transforms([nodes[number] for number in order]), parents)
    return transforms


def _descendants(
    nodes: list[dict[str, Any]], roots: Sequence[int], *, skips_hidden: bool
) -> tuple[list[int], list[int]]:
    """Indices of nodes, parents before children, last child first; and the rows of their parents, −1 for none.

    No node is visited twice, because nodes form trees.
    """
    order: list[int] = []
    parents: list[int] = []
    pending = [(root, -1) for root in roots]
    while pending:
        number, parent = pending.pop()
        if skips_hidden and is_hidden(nodes[number]):
            continue
        pending += [(child, len(order)) for child in nodes[number].get("children", ())]
        order.append(number)
        parents.append(parent)
    return order, parents


def _local_transforms(nodes: list[dict[str, Any]]) -> Floats:
    """Transforms node→parent (N, 4, 4): a matrix, or translation · rotation · scale (glTF 2.0, 3.5.3)."""
    matrix = _values_or_default(nodes, "matrix", np.eye(4).ravel()).reshape(len(nodes), 4, 4).transpose(0, 2, 1).copy()
    parts = compose_transforms(
        _values_or_default(nodes, "translation", np.zeros(3)),
        _rotations(_values_or_default(nodes, "rotation", np.array([0.0, 0.0, 0.0, 1.0]))),
        _values_or_default(nodes, "scale", np.ones(3)),
    )
    has_parts = np.array([not _PARTS.isdisjoint(node) for node in nodes], bool)
    has_matrix = np.array(["matrix" in node for node in nodes], bool)
    both, only_parts = has_parts & has_matrix, has_parts & ~has_matrix
    matrix[both] = matrix[both] @ parts[both]
    matrix[only_parts] = parts[only_parts]
    return matrix


def compose_transforms(translations: Floats, rotations: Floats, scales: Floats) -> Floats:
    """Transforms (N, 4, 4) that scale (N, 3), then rotate by matrices (N, 3, 3), then translate (N, 3)."""
    matrices = np.tile(np.eye(4), (len(translations), 1, 1))
    matrices[:, :3, :3] = rotations * scales[:, None, :]
    matrices[:, :3, 3] = translations
    return matrices


_PARTS = {"translation", "rotation", "scale"}


def _values_or_default(nodes: list[dict[str, Any]], key: str, default: Floats) -> Floats:
    """Values (N, K) that nodes state, else the default."""
    rows_with_key = [row for row, node in enumerate(nodes) if key in node]
    values = np.tile(default, (len(nodes), 1))
    if rows_with_key:
        try:
            listed_values = np.array([nodes[row][key] for row in rows_with_key], np.float64)
        except (ValueError, TypeError, OverflowError):
            listed_values = np.zeros(0)
        if listed_values.shape != (len(rows_with_key), len(default)):
            raise UnusableError(f"expected {len(default)} numbers as {key} of each node, got others")
        values[rows_with_key] = listed_values
    return values


def _rotations(quaternions: Floats) -> Floats:
    """Rotation matrices (N, 3, 3) of quaternions (x, y, z, w) of any length; the identity for length 0."""
    length = np.einsum("ij,ij->i", quaternions, quaternions)
    is_none = length < np.finfo(np.float64).eps * 4
    scaled = quaternions * np.sqrt(2.0 / np.where(is_none, 1.0, length))[:, None]
    x, y, z, w = scaled.T
    rows = [
        [1.0 - y * y - z * z, x * y - z * w, x * z + y * w],
        [x * y + z * w, 1.0 - x * x - z * z, y * z - x * w],
        [x * z - y * w, y * z + x * w, 1.0 - x * x - y * y],
    ]
    matrices = np.moveaxis(np.array(rows), 2, 0)
    matrices[is_none] = np.eye(3)
    return matrices


def _world_transforms(local: Floats, parents: list[int]) -> Floats:
    """Multiply transforms along trees, one generation at a time; parents come before their children."""
    depths: list[int] = []
    for parent in parents:
        depths.append(depths[parent] + 1 if parent >= 0 else 0)
    order = np.argsort(depths, kind="stable")
    world, parent_rows = local.copy(), np.array(parents, np.int64)
    for rows in np.split(order, np.flatnonzero(np.diff(np.array(depths, np.int64)[order])) + 1)[1:]:
        world[rows] = world[parent_rows[rows]] @ local[rows]
    return world


def instance_transforms(header: dict[str, Any], buffers: Buffers, budget: Budget) -> dict[int, Floats]:
    """Transforms instance→node (N, 4, 4), by the index of each node with instances."""
    return {
        number: _transforms_of_node(header, number, node["extensions"][INSTANCING]["attributes"], buffers, budget)
        for number, node in enumerate(header.get("nodes", []))
        if "mesh" in node and INSTANCING in node.get("extensions", {})
    }


def instance_tints(
    header: dict[str, Any], buffers: Buffers, nodes_with_instances: Iterable[int]
) -> tuple[dict[int, list[list[float]]], list[str]]:
    """Return the linear RGBA (N, 4) of instances with colours, by node index, and notes.

    Each colour needs its own mesh, so colours are rounded to at most `_MAX_TINTS`.
    """
    tints: dict[int, Floats] = {}
    for number in nodes_with_instances:
        attributes = header["nodes"][number]["extensions"][INSTANCING]["attributes"]
        if _TINT in attributes:
            rows = buffers.fractions(attributes[_TINT], buffers.raw(attributes[_TINT])).astype(np.float64)
            if rows.shape[1] not in (3, 4):
                raise UnusableError(f"expected 3 or 4 numbers in each row of {_TINT}, got {rows.shape[1]}")
            rgba = np.ones((len(rows), 4))
            rgba[:, : rows.shape[1]] = np.clip(np.nan_to_num(rows), 0, 1)
            tints[number] = rgba
    if not tints:
        return {}, []
    rounded, steps = _few_colors(np.concatenate(list(tints.values())))
    parts = np.split(rounded, np.cumsum([len(rgba) for rgba in tints.values()])[:-1])
    notes = [f"colours of instances rounded to {steps + 1} values in each channel"] if steps else []
    return {number: rgba.tolist() for number, rgba in zip(tints, parts, strict=True)}, notes


def _few_colors(rgba: Floats) -> tuple[Floats, int]:
    """Round linear RGBA (N, 4) to at most `_MAX_TINTS` colours, as finely as possible; also the steps, 0 if exact."""
    if len(np.unique(rgba, axis=0)) <= _MAX_TINTS:
        return rgba, 0
    encoded = np.column_stack([to_srgb(rgba[:, :3]), rgba[:, 3]])
    for steps in _ROUNDING_STEPS:
        rounded = np.rint(encoded * steps) / steps
        if len(np.unique(rounded, axis=0)) <= _MAX_TINTS:
            break
    return np.column_stack([to_linear(rounded[:, :3]), rounded[:, 3]]), steps


def _transforms_of_node(
    header: dict[str, Any], number: int, attributes: dict[str, Any], buffers: Buffers, budget: Budget
) -> Floats:
    counts = {name: int(entry(header, "accessors", accessor)["count"]) for name, accessor in attributes.items()}
    if len(set(counts.values())) != 1:
        listed = ", ".join(f"{count} of {name}" for name, count in counts.items()) or "none"
        raise UnusableError(f"expected equally many rows of all attributes of node {number}'s instances, got {listed}")
    (count,) = set(counts.values())
    # Many nodes may use the same arrays. A mesh of several primitives is placed once for each of them.
    primitives = entry(header, "meshes", header["nodes"][number]["mesh"])["primitives"]
    budget.count_arrays(max(0, count) * len(primitives) * INSTANCE_BYTES)
    translations, quaternions, scales = (_instance_rows(n, count, attributes, buffers) for n in _INSTANCE_DEFAULTS)
    return compose_transforms(translations, _rotations(quaternions), scales)


def _instance_rows(name: str, count: int, attributes: dict[str, Any], buffers: Buffers) -> Floats:
    """Rows (N, K) of one part of the transforms."""
    default = np.array(_INSTANCE_DEFAULTS[name])
    if name not in attributes:
        return np.tile(default, (count, 1))
    rows = buffers.fractions(attributes[name], buffers.raw(attributes[name])).astype(np.float64)
    if rows.shape[1] != len(default):
        raise UnusableError(f"expected {len(default)} numbers in each row of {name}, got {rows.shape[1]}")
    return rows
