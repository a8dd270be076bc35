"""Encodes a scene as a GLB that other programs can show, and decodes it to the same bits in every array.

A static mesh with many objects is a node with a child for each object; an instance is a node with a mesh.
`extras` store data that glTF does not define: the number of static instances, the order of a mesh's faces before they
were sorted by object and material, and whether the faces are reversed, because glTF, unlike nearfar, reverses the faces
of mirrored meshes. In glTF v of texture coordinates points down; where 1 − v is inexact, `_V` stores nearfar's v.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import check, glb
from nearfar._base.version import __version__
from nearfar._scene import glb_surfaces
from nearfar._scene.glb_surfaces import ImageEncoder, SurfaceWriter
from nearfar._scene.materials import colors_of
from nearfar._scene.names import Names
from nearfar._scene.srgb import to_linear
from nearfar._scene.undrawn import GltfMaterial

_IDENTITY = np.eye(4)[:3]
_NO_OBJECT = -1
_UPRIGHT = "upright"
"""Extra of files whose images have row 0 on top and whose texture coordinates point down, as in glTF."""
_EXACT_V = "_V"
_MIRRORED = "turned"
"""Extra of nodes whose mesh has reversed faces."""


EXTRAS_KEY = "nearfar"
"""Key of the extras of a file's scene that store nearfar's settings."""


def encode(
    core: _core.Scene,
    names: tuple[str, ...],
    undrawn: Mapping[int, GltfMaterial],
    extras: Mapping[str, Any] | None = None,
) -> bytes:
    """Encode all content of a scene as a GLB; the scene's origin becomes the root node's translation.

    `extras` are stored in the extras of the file's scene.
    """
    return Encoder(core, names, undrawn).encode(extras)


class Encoder:
    """Writes instances of a scene as glTF nodes, with their meshes, materials and textures."""

    def __init__(
        self,
        core: _core.Scene,
        names: Sequence[str],
        undrawn: Mapping[int, GltfMaterial],
        encode_image: ImageEncoder = glb_surfaces.png,
    ) -> None:
        self._parts = _core.scene_parts(core)
        self._ids = core.mesh_ids().tolist()
        self._names = names
        self._writer = glb.Writer()
        self._meshes: list[dict[str, Any]] = []
        self.nodes: list[dict[str, Any]] = []
        """Nodes added so far."""
        self._surfaces = SurfaceWriter(self._writer, self._parts, undrawn, encode_image)
        self._written: dict[tuple[int, bool, bool], _GltfMeshes] = {}

    def encode(self, extras: Mapping[str, Any] | None = None) -> bytes:
        """Encode the whole scene; `extras` are stored in the extras of the file's scene."""
        numbers = [number for number, mesh in enumerate(self._parts["meshes"]) if mesh.face_count]
        children = [self.place(number) for number in numbers]
        static_count = sum(number < self._parts["standing_count"] for number in numbers)
        root: dict[str, Any] = {"name": "nearfar", "extras": {"standing": static_count}}
        if any(self._parts["origin"]):
            root["translation"] = list(self._parts["origin"])
        if children:
            root["children"] = children
        self.nodes.append(root)
        roots = [len(self.nodes) - 1]
        return self.finish(
            roots, **({} if extras is None else {"scenes": [{"nodes": roots, "extras": {EXTRAS_KEY: dict(extras)}}]})
        )

    def finish(self, roots: list[int], **fields: Any) -> bytes:
        """Encode a file whose scene has the given root nodes; `fields` are added to its document."""
        scene = {"nodes": roots} if roots else {}
        surfaces = self._surfaces.fields()
        used = sorted({*surfaces["extensionsUsed"], *fields.get("extensionsUsed", ())})
        return self._writer.encode(
            {
                "asset": {"version": "2.0", "generator": f"nearfar {__version__}", "extras": {_UPRIGHT: True}},
                "scene": 0,
                "scenes": [scene],
                "nodes": self.nodes,
                "meshes": self._meshes,
                **surfaces,
                **fields,
                "extensionsUsed": used,
            }
        )

    def place(self, number: int) -> int:
        """Add the nodes of an instance with faces; return the number of the parent node."""
        mesh, placement = self._parts["meshes"][number], self._parts["placements"][number]
        object_number = int(self._parts["objects"][number])
        has_object = object_number != _NO_OBJECT
        # glTF reverses the faces of a mesh whose placement mirrors it.
        is_mirrored = bool(np.linalg.det(placement[:, :3]) < 0)
        key = (self._ids[number], has_object, is_mirrored)
        if key not in self._written:
            self._written[key] = self._mesh(mesh.flip_faces() if is_mirrored else mesh, is_one_object=has_object)
        written = self._written[key]
        extras: dict[str, Any] = {} if written.order is None else {"order": written.order}
        if is_mirrored:
            extras[_MIRRORED] = True
        node: dict[str, Any] = {"extras": extras} if extras else {}
        if has_object:
            node |= {"name": self._names[object_number], "mesh": written.meshes[0]}
        else:
            node["children"] = [
                self._add({"name": self._names[owner]} if owner >= 0 else {}, mesh)
                for owner, mesh in zip(written.objects, written.meshes, strict=True)
            ]
        if not np.array_equal(placement, _IDENTITY):
            node["matrix"] = np.vstack([placement, [0, 0, 0, 1]]).T.ravel().tolist()
        return self._add(node)

    def _add(self, node: dict[str, Any], mesh: int | None = None) -> int:
        self.nodes.append(node if mesh is None else node | {"mesh": mesh})
        return len(self.nodes) - 1

    def _mesh(self, mesh: _core.Mesh, *, is_one_object: bool) -> _GltfMeshes:
        """Write one glTF mesh if the mesh is one object, else one for each object; they share no vertices."""
        parts = _core.mesh_parts(mesh)
        owner = np.zeros_like(parts["objects"]) if is_one_object else parts["objects"]
        order = np.lexsort((parts["materials"], owner))
        owner, material, faces = owner[order], parts["materials"][order], parts["faces"][order]
        group = np.cumsum(np.diff(owner, prepend=owner[:1]) != 0)
        # Each object stores each vertex that it uses once, by ascending number.
        total = len(parts["positions"])
        keys, corners = np.unique((group[:, None] * total + faces).ravel(), return_inverse=True)
        first = np.searchsorted(keys // total, np.arange(group[-1] + 2))
        local = corners.reshape(-1, 3) - first[group][:, None]
        streams = _Streams(self._writer, parts, keys % total, first)
        kind = np.uint16 if np.diff(first).max() < 2**16 else np.uint32
        indices = local.astype(kind).ravel()
        view = self._writer.view(indices, "faces")
        begins = np.flatnonzero(np.diff(owner, prepend=-2) | np.diff(material, prepend=-2))
        written = _GltfMeshes()
        for start, end in zip(begins.tolist(), [*begins[1:].tolist(), len(faces)], strict=True):
            if not written.objects or owner[start] != written.objects[-1]:
                written.objects.append(int(owner[start]))
                written.meshes.append(len(self._meshes))
                self._meshes.append({"primitives": []})
                attributes = streams.accessors_of_group(len(written.objects) - 1)
            primitive = {
                "attributes": attributes,
                "indices": self._writer.accessor(view, indices[3 * start : 3 * end], 3 * start),
            }
            if material[start] >= 0:
                primitive["material"] = self._surfaces.number(int(material[start]))
            self._meshes[-1]["primitives"].append(primitive)
        if (np.diff(order) < 0).any():
            values = order.astype(np.uint32)
            written.order = self._writer.accessor(self._writer.view(values), values, 0)
        return written


@dataclass
class _GltfMeshes:
    """Object numbers of a mesh, index of the glTF mesh for each, and index of the accessor with the face order."""

    objects: list[int] = field(default_factory=list)
    meshes: list[int] = field(default_factory=list)
    order: int | None = None


class _Streams:
    """Vertex attributes in the order of the groups (objects) that use them."""

    def __init__(
        self, writer: glb.Writer, parts: dict[str, Any], rows: NDArray[np.int64], first: NDArray[np.int64]
    ) -> None:
        self._writer, self._first = writer, first.tolist()
        values: dict[str, NDArray[Any]] = {"POSITION": parts["positions"][rows]}
        if parts["uvs"] is not None:
            values |= _flip_v(parts["uvs"][rows])
        if parts["colors"] is not None:
            values["COLOR_0"] = _linear(parts["colors"][rows])
        if parts["normals"] is not None:
            values["NORMAL"] = parts["normals"][rows]
        self._arrays = {name: (array, writer.view(array, "vertices")) for name, array in values.items()}
        self._extents = [ufunc.reduceat(values["POSITION"], first[:-1]) for ufunc in (np.minimum, np.maximum)]

    def accessors_of_group(self, group: int) -> dict[str, int]:
        """Return the accessors of a group's attributes by name."""
        start, end = self._first[group], self._first[group + 1]
        accessors = {}
        for name, (array, view) in self._arrays.items():
            if name == "NORMAL" and not array[start:end].any():
                continue  # only other objects of the mesh have normals
            extent = [corner[group] for corner in self._extents] if name == "POSITION" else None
            normalized = name == "COLOR_0"
            accessors[name] = self._writer.accessor(view, array[start:end], start, normalized=normalized, extent=extent)
        return accessors


class Decoder:
    """Reads files that `Encoder` wrote; other bytes may raise any exception.

    Objects are numbered as in `names`, or in the order of the nodes if it is None.
    """

    def __init__(self, data: bytes, names: Names | None) -> None:
        self._reader = glb.Reader(data)
        self.document = self._reader.document
        """The file's JSON document."""
        self.names = Names(self._node_names()) if names is None else names
        self._upright = bool(self.document["asset"].get("extras", {}).get(_UPRIGHT))
        self._meshes: dict[tuple[Any, ...], _core.Mesh] = {}

    def decode(self) -> _core.Scene:
        root = self._root
        children = self._nodes(root)
        placements = np.array([placement_of(node) for node in children]).reshape(-1, 3, 4)
        if not np.isfinite(placements).all():
            raise ValueError("expected finite matrices")
        objects = [self._object(node) if "mesh" in node else _NO_OBJECT for node in children]
        core = _core.Scene(
            {
                "origin": check.vector("translation", root.get("translation", (0.0, 0.0, 0.0))),
                "meshes": [self.mesh(node) for node in children],
                "placements": placements,
                "objects": np.array(objects, np.int32),
                "standing_count": root["extras"]["standing"],
                **self.surfaces,
            }
        )
        if core.triangle_count and not np.abs(core.bounds()).max() <= check.FARTHEST:
            raise ValueError(f"expected positions up to {check.FARTHEST:g} m")
        return core

    @property
    def surfaces(self) -> dict[str, Any]:
        """Materials and textures as arguments of `_core.Scene`."""
        return self._surfaces[0]

    @property
    def undrawn(self) -> dict[int, GltfMaterial]:
        """Undrawn properties of materials, by tag."""
        return self._surfaces[1]

    @cached_property
    def _surfaces(self) -> tuple[dict[str, Any], dict[int, GltfMaterial]]:
        return glb_surfaces.read(self._reader, upright=self._upright)

    def _node_names(self) -> tuple[str, ...]:
        """Unique names of the instances and of the objects in them, in the order of the nodes."""
        parts = [part for child in self._nodes(self._root) for part in (child, *self._nodes(child))]
        return tuple(dict.fromkeys(str(part["name"]) for part in parts if "name" in part))

    @property
    def _root(self) -> dict[str, Any]:
        return glb.entry(self.document, "nodes", self.document["scenes"][0]["nodes"][0])

    def _nodes(self, parent: dict[str, Any]) -> list[dict[str, Any]]:
        return [glb.entry(self.document, "nodes", number) for number in parent.get("children", [])]

    def _object(self, node: dict[str, Any]) -> int:
        return self.names.number("name", node["name"]) if "name" in node else _NO_OBJECT

    def mesh(self, node: dict[str, Any]) -> _core.Mesh:
        """Return the mesh of an instance; instances of one mesh get the same object."""
        children = [(child["mesh"], self._object(child)) for child in self._nodes(node)]
        pieces = [(node["mesh"], _NO_OBJECT)] if "mesh" in node else children
        extras = node.get("extras", {})
        order, is_mirrored = extras.get("order"), bool(extras.get(_MIRRORED))
        key = (order, is_mirrored, *pieces)
        if key not in self._meshes:
            mesh = self._concatenate_primitives(pieces, order)
            self._meshes[key] = mesh.flip_faces() if is_mirrored else mesh
        return self._meshes[key]

    def _concatenate_primitives(self, pieces: list[tuple[int, int]], order: int | None) -> _core.Mesh:
        streams: dict[str, list[NDArray[Any]]] = {}
        faces, objects, materials, vertex_count = [], [], [], 0
        for number, owner in pieces:
            primitives = glb.entry(self.document, "meshes", number)["primitives"]
            attributes = {name: self._reader.array(a) for name, a in primitives[0]["attributes"].items()}
            flat = np.zeros((len(attributes["POSITION"]), 3), np.float32)
            for name, values in ({"NORMAL": flat} | attributes).items():
                streams.setdefault(name, []).append(values)
            for primitive in primitives:
                corners = self._reader.array(primitive["indices"]).astype(np.uint32).reshape(-1, 3)
                if corners.size and int(corners.max()) >= len(streams["POSITION"][-1]):
                    raise ValueError("expected faces of vertices that exist")
                faces.append(corners + np.uint32(vertex_count))
                objects.append(np.full(len(corners), owner, np.int32))
                materials.append(np.full(len(corners), primitive.get("material", -1), np.int32))
            vertex_count += len(streams["POSITION"][-1])
        rank = slice(None) if order is None else _ranks(self._reader.array(order))
        joined = {name: np.concatenate(arrays) for name, arrays in streams.items()}
        colors = joined.get("COLOR_0")
        return _core.Mesh(
            joined["POSITION"],
            np.ascontiguousarray(np.concatenate(faces)[rank]),
            uvs=_restore_v(joined) if self._upright else joined.get("TEXCOORD_0"),
            colors=None if colors is None else colors_of(colors, vertex_count, linear=True),
            normals=joined["NORMAL"] if joined["NORMAL"].any() else None,
            objects=np.ascontiguousarray(np.concatenate(objects)[rank]),
            materials=np.ascontiguousarray(np.concatenate(materials)[rank]),
        )


def placement_of(node: dict[str, Any]) -> NDArray[np.float64]:
    """Exact placement (3, 4) of a node."""
    matrix: NDArray[np.float64] = np.array(node.get("matrix", np.eye(4).ravel()), np.float64).reshape(4, 4)
    return matrix.T[:3]


def _ranks(order: NDArray[Any]) -> NDArray[np.int64]:
    """Rank of each face in the sorted order: the inverse permutation."""
    ranks = np.empty(len(order), np.int64)
    ranks[order] = np.arange(len(order))
    return ranks


def _flip_v(uvs: NDArray[np.float32]) -> dict[str, NDArray[np.float32]]:
    """Attributes from which `_restore_v` restores texture coordinates bit by bit."""
    flipped = np.column_stack([uvs[:, 0], np.float32(1) - uvs[:, 1]])
    attributes = {"TEXCOORD_0": flipped}
    restored_v = np.float32(1) - flipped[:, 1]
    if not np.array_equal(restored_v.view(np.uint32), np.ascontiguousarray(uvs[:, 1]).view(np.uint32)):
        attributes[_EXACT_V] = np.ascontiguousarray(uvs[:, 1:])
    return attributes


def _restore_v(attributes: dict[str, NDArray[Any]]) -> NDArray[np.float32] | None:
    if "TEXCOORD_0" not in attributes:
        return None
    flipped = attributes["TEXCOORD_0"]
    v = np.float32(1) - flipped[:, 1]
    return np.column_stack([flipped[:, 0], attributes[_EXACT_V].reshape(-1) if _EXACT_V in attributes else v])


def _linear(colors: NDArray[np.uint8]) -> NDArray[np.uint16]:
    """Convert sRGB to 16-bit linear colours for glTF, losslessly: 8-bit values differ by at least 20 16-bit steps."""
    table = np.rint(to_linear(np.arange(256) / 255) * 65535).astype(np.uint16)
    linear_colors = table[colors]
    linear_colors[:, 3] = colors[:, 3].astype(np.uint16) * 257
    return linear_colors
