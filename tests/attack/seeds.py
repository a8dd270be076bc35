"""Small files of every kind that the package reads, from which cases are made."""

from __future__ import annotations

import functools
import io
import json
import tempfile
import zipfile
from collections.abc import Callable
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
import trimesh
from PIL import Image

import nearfar as nf
from nearfar._base import data as data_files
from tests.support import bundle_cases, city_cases, draco_cases, ktx2_cases, meshopt_cases
from tests.support.gltf_cases import encode
from tests.support.lod_cases import SMALL, levels
from tests.support.reduce_cases import CENTER, street

Files = dict[str, bytes]
"""Files by name; the first one is loaded, and the others lie beside it."""

MAX_BYTES = 1 << 16
"""Maximum bytes of files of the data folder."""

SUFFIXES = ("glb", "gltf", "obj", "ply", "stl", "off", "3mf", "city.json", "geojson", "parquet")


def image(kind: str = "PNG") -> bytes:
    noise = np.random.default_rng(0).integers(0, 255, (16, 16, 4 if kind == "PNG" else 3), np.uint8)
    target = io.BytesIO()
    Image.fromarray(noise).save(target, format=kind)
    return target.getvalue()


def _textured() -> trimesh.Trimesh:
    box = trimesh.creation.box()
    material = trimesh.visual.material.PBRMaterial(
        baseColorTexture=Image.open(io.BytesIO(image())), alphaMode="MASK", baseColorFactor=[255, 200, 100, 255]
    )
    uv = np.random.default_rng(1).uniform(0, 1, (8, 2))
    visual = trimesh.visual.TextureVisuals(uv=uv, material=material)
    return trimesh.Trimesh(box.vertices, box.faces, visual=visual, process=False)


def _colored() -> trimesh.Trimesh:
    box = trimesh.creation.box()
    box.visual.vertex_colors = np.random.default_rng(2).integers(0, 255, (8, 4), np.uint8)
    return box


def _scene() -> trimesh.Scene:
    """Two placements of a textured box and one with colours, in a tree of nodes."""
    scene = trimesh.Scene()
    scene.add_geometry(_textured(), node_name="a", geom_name="box")
    scene.graph.update(frame_to="b", frame_from="a", matrix=np.diag([2.0, 2, 2, 1]), geometry="box")
    scene.add_geometry(_colored(), node_name="c", geom_name="colored")
    return scene


def _gltf() -> Files:
    exported = {name: bytes(content) for name, content in _scene().export(file_type="gltf").items()}
    return {"a.gltf": exported.pop("model.gltf"), **exported}


def _sparse() -> bytes:
    """A GLB with a sparse accessor, a strip of triangles, normals, texture coordinates and two scenes."""
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], np.float32)
    arrays = {
        "position": corners.tobytes(),
        "normal": np.tile(np.array([0, 0, 1], np.float32), (4, 1)).tobytes(),
        "uv": corners[:, :2].tobytes(),
        "index": np.array([0, 1, 2, 3], np.uint16).tobytes(),
        "moved": np.array([3], np.uint16).tobytes() + b"\0\0",
        "to": np.array([[1, 1, 1]], np.float32).tobytes(),
        "image": image(),
    }
    views, binary = [], b""
    for content in arrays.values():
        views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": len(content)})
        binary += content + b"\0" * (-len(content) % 4)
    sparse = {"count": 1, "indices": {"bufferView": 4, "componentType": 5123}, "values": {"bufferView": 5}}
    primitive = {"attributes": {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2}, "indices": 3, "mode": 5, "material": 0}
    document = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}, {"nodes": [1]}],
        "nodes": [
            {"name": "root", "children": [1], "rotation": [0, 0, 0, 1], "scale": [2, 2, 2]},
            {"name": "leaf", "mesh": 0, "translation": [1, 2, 3]},
        ],
        "meshes": [{"primitives": [primitive]}],
        "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}, "doubleSided": True}],
        "textures": [{"source": 0, "sampler": 0}],
        "samplers": [{"wrapS": 33071}],
        "images": [{"bufferView": 6, "mimeType": "image/png"}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "sparse": sparse},
            {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC3"},
            {"bufferView": 2, "componentType": 5126, "count": 4, "type": "VEC2"},
            {"bufferView": 3, "componentType": 5123, "count": 4, "type": "SCALAR"},
        ],
        "bufferViews": views,
        "buffers": [{"byteLength": len(binary)}],
    }
    return encode(document, binary)


def _compressed() -> bytes:
    """A GLB with meshoptimizer compression: a mesh and the transforms of its instances."""
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], np.float32)
    quaternions = np.array([[0, 0, 0, 0x7FF], [0, 0, 2047, 0x7FF], [0, 0, 0, 0x7FC]], np.int16)
    streams = [
        meshopt_cases.attributes(corners),
        meshopt_cases.triangles(np.array([[0, 1, 2], [2, 1, 3]], np.uint16)),
        meshopt_cases.attributes(np.tile(np.array([0, 0, 127, 0], np.int8), (4, 1)), filter="OCTAHEDRAL", type="VEC3"),
        meshopt_cases.attributes(2 * corners[:3]),
        meshopt_cases.attributes(quaternions, filter="QUATERNION", normalized=True),
    ]
    primitive = {"attributes": {"POSITION": 0, "NORMAL": 2}, "indices": 1}
    places = {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": 3, "ROTATION": 4}}}
    nodes = [{"mesh": 0, "extensions": places}]
    return meshopt_cases.glb(streams, meshes=[{"primitives": [primitive]}], nodes=nodes)


def _packed() -> bytes:
    """A GLB with a KTX 2 texture with a transform, a second set of coordinates, blending, and Draco if installed."""
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], np.float32)
    faces = np.array([[0, 1, 2], [2, 1, 3]], np.uint32)
    moved = {"KHR_texture_transform": {"offset": [0.5, 0], "rotation": 0.5, "scale": [2, 3], "texCoord": 1}}
    base = {"baseColorTexture": {"index": 0, "extensions": moved}}
    material = {"pbrMetallicRoughness": base, "normalTexture": {"index": 0, "texCoord": 1}, "alphaMode": "BLEND"}
    noise = np.random.default_rng(0).integers(0, 256, (8, 8, 4), np.uint8)
    picture = ktx2_cases.ktx2(noise, 43, packed=True)
    arrays = {"POSITION": corners, "TEXCOORD_0": corners[:, :2].copy(), "TEXCOORD_1": corners[:, 1:].copy()}
    if find_spec("DracoPy") is None:
        return ktx2_cases.glb(picture, materials=[material])
    attributes = {name: rows for name, rows in arrays.items() if name != "POSITION"}
    stream, numbers = draco_cases.compress(corners, faces, attributes)
    document, binary = draco_cases.document(stream, numbers, arrays, faces)
    binary += bytes(-len(binary) % 4)
    document["bufferViews"].append({"buffer": 0, "byteOffset": len(binary), "byteLength": len(picture)})
    document["images"] = [{"bufferView": 1, "mimeType": "image/ktx2"}]
    document["textures"] = [{"extensions": {ktx2_cases.EXTENSION: {"source": 0}}}]
    document["materials"] = [material]
    return encode(document, binary + picture)


_MTL = b"newmtl one\nKd 0.8 0.1 0.1\nd 0.5\nmap_Kd a.png\nmap_d -s 1 1 1 a.jpg\nnewmtl two\nKd 1 1 1\nTr 0.5\n"
_OBJ = b"""mtllib a.mtl
o first
v 0 0 0
v 1 0 0 0.5 0.5 0.5
v 0 1 0
v 1 1 0
vt 0 0
vt 1 0
vt 0 1
vn 0 0 1
usemtl one
g left right
s 1
f 1/1/1 2/2/1 3/3/1
f -1//-1 -2//1 -3//1
usemtl two
o second
f 1 2 4 3
l 1 2
p 1
"""


@functools.cache
def scene_files() -> dict[str, list[Files]]:
    """Return generated seed scene files by suffix."""
    colored, textured = _colored(), _textured()
    archive = _scene().export(file_type="3mf")
    return {
        "glb": [
            {"a.glb": _scene().export(file_type="glb")},
            {"a.glb": _sparse()},
            {"a.glb": _compressed()},
            {"a.glb": _packed()},
        ],
        "gltf": [_gltf()],
        "obj": [
            {"a.obj": _OBJ, "a.mtl": _MTL, "a.png": image(), "a.jpg": image("JPEG")},
            {"a.obj": textured.export(file_type="obj").encode()},
        ],
        "ply": [
            {"a.ply": colored.export(file_type="ply")},
            {"a.ply": colored.export(file_type="ply", encoding="ascii")},
        ],
        "stl": [{"a.stl": colored.export(file_type="stl")}, {"a.stl": colored.export(file_type="stl_ascii").encode()}],
        "off": [{"a.off": colored.export(file_type="off").encode()}],
        "3mf": [{"a.3mf": archive if isinstance(archive, bytes) else bytes(archive)}],
        "city.json": [{"a.city.json": json.dumps(city_cases.everything()).encode()}],
        "geojson": [{"a.geojson": json.dumps(_footprints()).encode()}],
        "parquet": [_parquet()],
    }


def _footprints() -> dict[str, Any]:
    rings = [city_cases.square(0, 0, 5), city_cases.square(1, 1, 2)]
    return city_cases.collection(city_cases.feature(rings, height=3), city_cases.feature(rings[:1], levels="2"))


def _parquet() -> Files:
    row = city_cases.polygon_bytes([city_cases.square(0, 0, 5)])
    with tempfile.TemporaryDirectory() as folder:
        path = city_cases.parquet(Path(folder) / "a.parquet", [row, None, row], height=[1.5, 2.0, None])
        return {"a.parquet": path.read_bytes()}


@functools.cache
def all_scene_files() -> dict[str, list[Files]]:
    """Return these and small files of the data folder, including malformed ones, if it exists."""
    found = {suffix: list(files) for suffix, files in scene_files().items()}
    root = data_files.root()
    for path in sorted(root.rglob("*")) if root else []:
        suffix = path.suffix.lower().lstrip(".")
        if suffix in found and path.is_file() and path.stat().st_size <= MAX_BYTES:
            beside = {}
            if suffix in ("gltf", "obj"):
                near = [item for item in sorted(path.parent.iterdir()) if item.is_file() and item != path]
                beside = {item.name: item.read_bytes() for item in near[:8] if item.stat().st_size <= MAX_BYTES}
            found[suffix].append({f"a.{suffix}": path.read_bytes(), **beside})
    return found


def members(archive: bytes) -> Files:
    """Return the members of a ZIP archive."""
    with zipfile.ZipFile(io.BytesIO(archive)) as opened:
        return {name: opened.read(name) for name in opened.namelist()}


def packed(files: Files) -> bytes:
    """Return a ZIP archive of members."""
    target = io.BytesIO()
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            archive.writestr(name, content)
    return target.getvalue()


CHANNELS = ("color", "range", "object_id", "face_id", "position", "normal")


def saved_objects(*, other: bool = False) -> dict[str, tuple[Any, Callable[[Any, Path], None]]]:
    """Return objects that have files, or different ones of the same kinds, and how each is saved at a path."""
    side = 16 if other else 8
    zones: dict[str, Any] = {"center": CENTER, "r1": 30, "r2": 50, "channels": CHANNELS[:3], "backend": "cpu"}
    camera = nf.Camera.look_at(CENTER, np.add(CENTER, (1.0, 0, 0)), fov=nf.Fov.symmetric(90), size=(side, side))
    reduced = nf.reduce(street(dynamic=True), **zones, face_size=side, samples=1)
    frame = nf.render(street(), camera, channels=CHANNELS, backend="cpu")
    model = nf.lod.measure(levels(*((7, 5, 4) if other else (6, 4))), **SMALL)
    view = nf.Camera((0, 0, 0), fov=nf.Fov.symmetric(90), size=(640, 480))
    return {
        "reduced": (reduced, lambda it, path: it.save(path)),
        "bundle": (
            bundle_cases.village(height=2.0 if other else 3.0),
            lambda it, path: nf.stream.export(it, path, **bundle_cases.SETTINGS, quality=None),
        ),
        "envmap.exr": (reduced.env, lambda it, path: it.save(path)),
        "frame.exr": (frame, lambda it, path: it.save(path)),
        "lod.json": (model, lambda it, path: it.save(path)),
        "lod.glb": (model, lambda it, path: it.export(path, view=view, k=0.5, d=1.0, all_levels=True)),
        "hmd.json": (nf.hmd.VIVE if other else nf.hmd.INDEX, lambda it, path: it.save(path)),
        "hmdq.json": (nf.hmd.VIVE, lambda it, path: it.save(path, format="hmdq")),
        "flat.png": (reduced.env, lambda it, path: it.save_equirectangular(path)),
        "frame.png": (frame, lambda it, path: it.save(path)),
    }


@functools.cache
def saved_files() -> dict[str, Files]:
    """Return seeds of the package's own files; of folders the files within."""
    found: dict[str, Files] = {}
    with tempfile.TemporaryDirectory() as folder:
        for name, (what, save) in saved_objects().items():
            path = Path(folder) / name
            save(what, path)
            found[name] = bundle_cases.content(path) if path.is_dir() else {path.name: path.read_bytes()}
    return found
