"""Loads scenes from files, and explains in one sentence why a file cannot be read."""

from __future__ import annotations

import errno
import io
import os
import re
import zipfile
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from nearfar._base import background, remote
from nearfar._base.errors import UnusableError
from nearfar._scene import load_off, load_ply, load_trimesh, load_wavefront, quiet
from nearfar._scene.budget import Budget, read_file, resolver as budget_resolver
from nearfar._scene.city import read as cities
from nearfar._scene.content import Content, assemble
from nearfar._scene.gltf.document import read as read_gltf
from nearfar._scene.materials import Materials
from nearfar._scene.options import LoadOptions
from nearfar._scene.reasons import explained
from nearfar._scene.report import count
from nearfar._scene.tileset import tileset as tiles


def load(path: str | os.PathLike[str], options: LoadOptions, *, moves: bool = False) -> dict[str, Any]:
    """Load a file and return the arguments of `Scene`; with `moves`, all objects are dynamic."""
    source = str(path) if remote.is_url(path) else remote.local(path)
    if isinstance(source, Path) and source.is_dir():
        raise IsADirectoryError(errno.EISDIR, _folder_message(source), os.fspath(source))
    tiles.check_options(source, options)
    cities.check_options(source, options)
    return background.run(lambda: _load(source, options, moves), alone=True)


def _load(path: str | Path, options: LoadOptions, moves: bool) -> dict[str, Any]:
    label, budget = os.fspath(path), Budget(options.max_bytes)
    if isinstance(path, str):
        with quiet.silence(), explained(label.partition("?")[0], passed=OSError):
            return assemble(tiles.read(path, options, budget), options, budget=budget, moves=moves)
    with explained(label, passed=OSError):
        data = read_file(path, budget)  # a missing file and missing permissions raise OSError
    with quiet.silence() as messages, explained(label):
        content = _read(path, data, options, budget)
        content.notes += [message for message in dict.fromkeys(messages) if message not in content.notes]
        return assemble(content, options, budget=budget, moves=moves)


def _folder_message(path: Path) -> str:
    if (path / "reduced.json").is_file():
        return "expected a file, got the folder of a reduced scene, which ReducedScene.load reads"
    files = sorted(item.name for item in path.iterdir() if item.suffix.lower() in _SCENE_SUFFIXES)
    return "expected a file, got a folder" + (f", which holds {', '.join(files[:3])}" if files else "")


def _read(path: Path, data: bytes, options: LoadOptions, budget: Budget) -> Content:
    import trimesh

    label, kind, name = os.fspath(path), path.suffix.lower().lstrip("."), path.stem
    if kind == "gz":
        kind, name = Path(name).suffix.lower().lstrip("."), Path(name).stem
        data = budget.unpacked(data)
    if kind in _ARCHIVES:
        raise UnusableError("it is an archive, which may hold several models: unpack it and load one of them")
    # Every tileset has these two entries; a text search is faster than parsing.
    may_be_tileset = kind == "json" and b'"root"' in data and b'"asset"' in data
    if kind in tiles.KINDS or (may_be_tileset and tiles.is_tileset(data)):
        return tiles.read(path, options, budget)
    if kind == "json" or kind in cities.KINDS:
        tiles.check_unused(options)
        return cities.read(label, kind, data, options, budget)
    if kind in _CONVERSION_ADVICE and kind not in trimesh.available_formats():
        raise UnusableError(f"nearfar does not read .{kind}: {_CONVERSION_ADVICE[kind]}")
    if kind not in trimesh.available_formats() or kind in _NOT_SCENES:
        endings = {*trimesh.available_formats(), *tiles.KINDS, *cities.KINDS} - _NOT_SCENES - _ARCHIVES - {"stl_ascii"}
        readable = [name for name in endings if "." not in name]
        ending = "".join(path.suffixes[-2:]) or path.name
        raise UnusableError(f"the kind of file '{ending}' is not known; nearfar reads {', '.join(sorted(readable))}")
    if not data:
        raise UnusableError("it is empty")
    budget.count_members(data)
    if kind == "3mf" and data.startswith(b"PK"):
        _check_3mf_instances(data, budget)
    resolver, materials = budget_resolver(path, budget), Materials(budget)
    if kind in ("glb", "gltf"):
        return read_gltf(label, data, kind, resolver, materials, budget)
    if kind == "obj":
        content = load_wavefront.read(label, data, resolver, materials, budget)
    elif kind == "ply":
        content = load_ply.read(label, data, resolver, materials)
    elif kind == "off":
        content = load_off.read(label, data)
    else:
        content = load_trimesh.read(label, load_trimesh.parse(data, kind, resolver), materials)
        if kind in ("dae", "zae"):
            content.notes += wrap_notes(data)
    content.used.insert(0, _FORMAT_NAMES.get(kind, kind.upper()))
    if len(content.nodes.objects) == 1 and content.nodes.objects[0] in (path.name, "geometry_0", "geometry"):
        content.nodes = replace(content.nodes, objects=[name])
    return content


_NOT_REPEATED = re.compile(rb"<([\w.-]+:)?wrap_[st]\s*>\s*(MIRROR|CLAMP|BORDER|NONE)\b")
"""Entry of a COLLADA sampler that does not repeat the image along an axis."""


def wrap_notes(data: bytes) -> list[str]:
    """Note on samplers of a COLLADA document, or of one in an archive, that trimesh does not pass on."""
    documents = [data]
    if data.startswith(b"PK"):
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            documents = [archive.read(name) for name in archive.namelist() if name.lower().endswith(".dae")]
    # Texts between two tags, every other of which is the content of an element.
    samplers = (text for document in documents for text in document.split(b"sampler2D")[1::2])
    number = sum(_NOT_REPEATED.search(sampler) is not None for sampler in samplers)
    return [f"{count(number, 'texture')} with clamped or mirrored sides repeated"] if number else []


_INSTANCE_BYTES = 1 << 14
"""Bytes that an instance counts against the budget. This also limits the time: trimesh compares all pairs of names."""

_MAX_INSTANCES = 1 << 62
"""Cap of instance counts, far above any budget: each level of components may double a count."""


def _check_3mf_instances(data: bytes, budget: Budget) -> None:
    """Count the instances of a 3MF's model before trimesh expands them; UnusableError for cyclic components."""
    from lxml import etree
    from trimesh.exchange.common import XML_PARSER_OPTIONS

    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        names = [name for name in archive.namelist() if "3d/3dmodel.model" in name.lower()]
        if not names:
            return
        tags = [f"{{*}}{name}" for name in ("object", "component", "item")]
        components: dict[str, list[str]] = {}
        items: list[str] = []
        object_id = ""
        with archive.open(names[0]) as model:
            for event, element in etree.iterparse(model, events=("start", "end"), tag=tags, **XML_PARSER_OPTIONS):
                kind = etree.QName(element).localname
                if event == "end":
                    if kind == "object":
                        object_id = ""
                        element.clear()
                elif kind == "object":
                    object_id = element.get("id", "")
                    components.setdefault(object_id, [])
                elif kind == "component":
                    components.setdefault(object_id, []).append(element.get("objectid", ""))
                else:
                    items.append(element.get("objectid", ""))
    budget.count_unpacked(_INSTANCE_BYTES * sum(_instances(components, items)))


def _instances(components: Mapping[str, Sequence[str]], items: Sequence[str]) -> list[int]:
    """Number of objects in each build item: its own object and all nested components."""
    counts: dict[str, int] = {}
    open_objects = set[str]()
    for item in items:
        pending = [item]
        while pending:
            object_id = pending[-1]
            children = components.get(object_id, ())
            uncounted = [part for part in children if part not in counts]
            if object_id in counts or not uncounted:
                counts.setdefault(object_id, min(_MAX_INSTANCES, 1 + sum(counts[part] for part in children)))
                open_objects.discard(object_id)
                pending.pop()
            elif object_id in open_objects and not open_objects.isdisjoint(uncounted):
                raise UnusableError(f"its object {object_id} is a component of itself")
            else:
                open_objects.add(object_id)
                pending += dict.fromkeys(uncounted)
    return [counts[item] for item in items]


_SCENE_SUFFIXES = {".glb", ".gltf", ".obj", ".ply", ".stl", ".off", ".3mf", ".dae"}
"""Suffixes of scene files. If a path is a folder, the error message lists its files with these suffixes."""

_FORMAT_NAMES = {"obj": "Wavefront OBJ", "dae": "COLLADA", "step": "STEP", "stp": "STEP"}
"""Names of formats that differ from their suffix."""

_ARCHIVES = {"zip", "tar", "tgz", "bz2", "7z", "rar"}

_CONVERSION_ADVICE = {
    **dict.fromkeys(
        ("npy", "npz"), "pass its arrays to nearfar.Scene.from_arrays: vertices of shape (N, 3), faces of shape (M, 3)"
    ),
    "blend": "export it from Blender as glTF (.glb)",
    "fbx": "import it into Blender and export it as glTF (.glb), or convert it with FBX2glTF or Assimp",
    "3ds": "import it into Blender 4.2 or newer and export it as glTF (.glb), or convert it with Assimp",
    "max": "export it from Autodesk 3ds Max as glTF or OBJ",
    **dict.fromkeys(("ma", "mb"), "export it from Autodesk Maya as OBJ or FBX, and FBX from Blender as glTF (.glb)"),
    "c4d": "export it from Cinema 4D as glTF (.glb)",
    "skp": "export it from SketchUp as glTF (.glb), COLLADA (.dae) or OBJ",
    "ifc": "convert it to glTF (.glb) with IfcConvert or the Python package ifcopenshell, or with Bonsai for Blender",
    "rvt": "export it from Autodesk Revit as IFC, and convert that to glTF (.glb) with IfcConvert",
    "dwg": "export it from AutoCAD as OBJ or STL, or open it in FreeCAD",
    "3dm": "export it from Rhino as glTF (.glb) or OBJ",
    "dae": "install the Python package pycollada, which reads it, or export it from Blender as glTF (.glb)",
    **dict.fromkeys(
        ("usd", "usda", "usdc", "usdz", "abc", "x3d"), "import it into Blender and export it as glTF (.glb)"
    ),
    **dict.fromkeys(
        ("step", "stp"),
        "install the Python package cascadio, which reads it, or export it from FreeCAD as glTF (.glb)",
    ),
    **dict.fromkeys(("iges", "igs"), "export it from FreeCAD as glTF (.glb) or OBJ"),
    **dict.fromkeys(("gml", "citygml"), "convert it with citygml-tools to CityJSON (.city.json)"),
    **dict.fromkeys(("wrl", "vrml"), "import it into Blender or MeshLab and export it as glTF (.glb) or PLY"),
    **dict.fromkeys(
        ("las", "laz", "e57"), "it contains points without triangles; make a mesh of them with CloudCompare or Open3D"
    ),
}
"""Advice for formats that nearfar does not read, or only with an optional package."""

_NOT_SCENES = {"dxf", "svg", "json", "dict", "dict64", "binvox"}
"""Formats that trimesh reads but that are not scenes: drawings, voxels and trimesh's own dumps."""
