"""Geometry as files: the same triangles within the bound, and documents that follow glTF's rules."""

from __future__ import annotations

import io
import json
import struct
from typing import Any

import numpy as np
import pytest
import trimesh
from numpy.typing import NDArray
from scipy.spatial import cKDTree

import nearfar as nf
from nearfar import _core
from nearfar._scene.glb import _linear

STEP = 2.0**-10
RADII = (20.0, 60.0)
COMPONENTS = {5120: np.int8, 5123: np.uint16, 5125: np.uint32, 5126: np.float32}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}


def texture_count(scene: nf.Scene) -> int:
    return len(_core.scene_parts(scene._core)["textures"])


def exporter(scene: nf.Scene, *, compressed: bool, kind: str | None = "png", step: float = STEP) -> _core.Export:
    """Export with the rings about the middle of the scene as groups, and with images of a kind."""
    rings = nf.stream.assign(scene, center=np.mean(scene.bounds, axis=0), radii=RADII)
    images = [None if kind is None else f"{number}.{kind}" for number in range(texture_count(scene))]
    return _core.Export(
        scene._core,
        rings.codes(),
        rings.count + 2,
        names=list(scene.object_names),
        images=images,
        encoding={"step": step, "compressed": compressed},
    )


def files(export: _core.Export) -> list[tuple[bytes, dict[str, Any]]]:
    """All groups' files, including their shared meshes."""
    return [export.glb(group, uris=[None] * len(export.shared())) for group in range(len(RADII) + 2)]


def contents(glb: bytes) -> tuple[dict[str, Any], bytes]:
    """Document and chunk of a GLB."""
    magic, version, length, size, kind = struct.unpack_from("<4sIII4s", glb)
    assert (magic, version, length, kind) == (b"glTF", 2, len(glb), b"JSON")
    assert size % 4 == 0
    chunk = b""
    if 20 + size < length:
        rest, binary = struct.unpack_from("<I4s", glb, 20 + size)
        chunk = glb[28 + size :]
        assert (rest, binary) == (len(chunk), b"BIN\0")
    return json.loads(glb[20 : 20 + size]), chunk


def world_triangles(glb: bytes) -> NDArray[np.float64]:
    """(F, 3, 3) triangles in the world as trimesh reads them."""
    loaded = trimesh.load_scene(io.BytesIO(glb), file_type="glb", process=False)
    triangles = [np.empty((0, 3, 3))]
    for node in loaded.graph.nodes_geometry:
        matrix, name = loaded.graph[node]
        corners = loaded.geometry[name].triangles
        triangles.append(corners @ matrix[:3, :3].T + matrix[:3, 3])
    return np.concatenate(triangles)


def least_distances(triangles: NDArray[np.float64], others: NDArray[np.float64]) -> NDArray[np.float64]:
    """For each triangle the least difference of a coordinate to one of the others with a close centroid."""
    _, near = cKDTree(others.mean(axis=1)).query(triangles.mean(axis=1), k=min(16, len(others)))
    near = near.reshape(len(triangles), -1)
    turned = [np.abs(triangles[:, None] - np.roll(others, turn, axis=1)[near]).max(axis=(2, 3)) for turn in range(3)]
    found: NDArray[np.float64] = np.min(turned, axis=(0, 2))
    return found


@pytest.fixture(scope="module")
def city() -> nf.Scene:
    return nf.datasets.city(blocks=1, detail=1)


def test_trimesh_reads_the_scenes_triangles_from_plain_files() -> None:
    city = nf.datasets.city(blocks=1, detail=0)
    pairs = files(exporter(city, compressed=False, kind=None))
    found = np.concatenate([world_triangles(glb) for glb, _ in pairs])
    statistics = [statistics for _, statistics in pairs]
    assert len(found) == sum(one["drawn"] for one in statistics)
    # The ground extends to 9.3 km, where the grid is coarser.
    assert max(one["position_error"] for one in statistics) == STEP
    expected = city.triangles().astype(np.float64) + city.origin
    edges = np.diff(expected, axis=1)
    area = np.linalg.norm(np.cross(edges[:, 0], edges[:, 1]), axis=1)
    # A face can lose its area only if it is thinner than two steps of its grid.
    solid = expected[area > 4 * STEP * np.linalg.norm(edges, axis=2).max(axis=1)]
    assert len(solid) > 0.9 * len(expected)
    for some, all_ in ((found, expected), (solid, found)):
        differences, reach = least_distances(some, all_), np.abs(some).max(axis=(1, 2))
        # Corners of placed meshes are rounded to float32 as well: half a step within 512 m and within 16 km.
        assert differences[reach < 512].max() <= STEP / 2 + 2.0**-15
        assert differences.max() <= STEP + 2.0**-11


@pytest.mark.parametrize(("compressed", "kind"), [(False, "webp"), (True, "png")])
def test_documents_follow_the_rules_of_gltf(city: nf.Scene, compressed: bool, kind: str) -> None:
    required = set()
    room = nf.datasets.room()
    assert texture_count(room) > 0
    exports = [exporter(scene, compressed=compressed, kind=kind) for scene in (city, room)]
    for glb, statistics in [file for export in exports for file in files(export)]:
        document, chunk = contents(glb)
        assert sum(statistics["bytes"].values()) == len(glb)
        required |= set(document.get("extensionsRequired", ()))
        assert document.get("extensionsUsed") == document.get("extensionsRequired")
        for view in document.get("bufferViews", ()):
            _check_view(document, view, chunk)
        for accessor in document.get("accessors", ()):
            view = document["bufferViews"][accessor["bufferView"]]
            width = WIDTHS[accessor["type"]] * np.dtype(COMPONENTS[accessor["componentType"]]).itemsize
            assert view["byteLength"] == accessor["count"] * view.get("byteStride", width)
        for mesh in document.get("meshes", ()):
            for primitive in mesh["primitives"]:
                _check_primitive(document, primitive, None if compressed else chunk)
        materials = document.get("materials", [])
        assert all(material["doubleSided"] for material in materials)
        used = {p["material"] for mesh in document.get("meshes", ()) for p in mesh["primitives"]}
        assert used == set(range(len(materials)))
    expected = {"EXT_meshopt_compression", "EXT_mesh_gpu_instancing"} if compressed else set()
    assert required - {"KHR_mesh_quantization"} == expected | ({"EXT_texture_webp"} if kind == "webp" else set())


def _check_view(document: dict[str, Any], view: dict[str, Any], chunk: bytes) -> None:
    buffers = document["buffers"]
    for place in (view, view.get("extensions", {}).get("EXT_meshopt_compression", view)):
        assert place["byteOffset"] % 4 == 0
        assert place["byteOffset"] + place["byteLength"] <= buffers[place["buffer"]]["byteLength"]
    if place is not view:
        assert buffers[view["buffer"]]["extensions"]["EXT_meshopt_compression"]["fallback"]
        first = chunk[place["byteOffset"]]
        assert first == (0xE1 if place["mode"] == "TRIANGLES" else 0xA0), "codec versions 1 and 0"
    assert buffers[0]["byteLength"] == len(chunk)


def _check_primitive(document: dict[str, Any], primitive: dict[str, Any], chunk: bytes | None) -> None:
    position = document["accessors"][primitive["attributes"]["POSITION"]]
    assert np.all(np.array(position["min"]) <= position["max"])
    if chunk is None:
        return
    corners = _array(document, primitive["indices"], chunk)
    assert corners.size % 3 == 0
    assert corners.max() == position["count"] - 1
    places = _array(document, primitive["attributes"]["POSITION"], chunk)
    assert places.min(axis=0).tolist() == position["min"]
    assert places.max(axis=0).tolist() == position["max"]
    if "NORMAL" in primitive["attributes"]:
        lengths = np.linalg.norm(_array(document, primitive["attributes"]["NORMAL"], chunk), axis=1)
        assert np.abs(lengths - 1).max() < 1e-6


def _array(document: dict[str, Any], number: int, chunk: bytes) -> NDArray[Any]:
    accessor = document["accessors"][number]
    view = document["bufferViews"][accessor["bufferView"]]
    kind = np.dtype(COMPONENTS[accessor["componentType"]])
    width = WIDTHS[accessor["type"]]
    values = np.frombuffer(chunk, kind, accessor["count"] * width, view["byteOffset"])
    return values.reshape(-1, width)


def test_shared_meshes_are_buffers_that_files_refer_to(city: nf.Scene) -> None:
    export = exporter(city, compressed=True)
    shared = export.shared()
    assert len(shared) > 1
    uris: list[str | None] = [f"{number}.bin" for number in range(len(shared))]
    for group, (whole, inside) in enumerate(files(export)):
        glb, outside = export.glb(group, uris=uris)
        document, _ = contents(glb)
        named = {buffer["uri"]: buffer["byteLength"] for buffer in document.get("buffers", ()) if "uri" in buffer}
        assert named == {f"{i}.bin": len(mesh) for i, (mesh, groups, _) in enumerate(shared) if group in groups}
        assert outside["drawn"] == inside["drawn"]
        stored = [statistics["triangles"] for _, groups, statistics in shared if group in groups]
        assert outside["triangles"] + sum(stored) == inside["triangles"]
        assert len(glb) <= len(whole)


def test_moving_objects_are_named_nodes_of_their_group(city: nf.Scene) -> None:
    name = city.object_names[0]
    scene = city.with_dynamic([name])
    glb, _ = files(exporter(scene, compressed=True))[0]
    document, _ = contents(glb)
    moving = [scene.object_names[number] for number in scene._core.moving_objects()]
    assert name in moving
    assert [node["name"] for node in document["nodes"] if "mesh" in node] == moving


def test_colors_equal_the_uncompressed_writer() -> None:
    corners = np.zeros((256, 3), np.float32)
    corners[:, 0], corners[::2, 1] = np.arange(256), 1
    colors = np.repeat(np.arange(256, dtype=np.uint8)[:, None], 4, axis=1)
    faces = np.arange(254)[:, None] + np.arange(3)
    builder = nf.SceneBuilder()
    builder.instance(builder.mesh(corners, faces, colors=colors), name="strip")
    scene = builder.build()
    glb = next(glb for glb, statistics in files(exporter(scene, compressed=False)) if statistics["triangles"])
    document, chunk = contents(glb)
    attributes = document["meshes"][0]["primitives"][0]["attributes"]
    places = _array(document, attributes["POSITION"], chunk)[:, 0].astype(int)
    assert np.array_equal(_array(document, attributes["COLOR_0"], chunk), _linear(colors)[places])


def test_arguments_that_do_not_fit_are_refused(city: nf.Scene) -> None:
    export = exporter(city, compressed=True)
    with pytest.raises(ValueError, match="uris"):
        export.glb(0, uris=[])
    with pytest.raises(ValueError, match="group"):
        export.glb(9, uris=[None] * len(export.shared()))
    with pytest.raises(ValueError, match="step"):
        exporter(city, compressed=True, step=0.0)
