"""Loads scenes from files, and explains in one sentence why a file cannot be read."""

from __future__ import annotations

import errno
import gzip
import os
import re
import zipfile
import zlib
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any

from nearfar._base import background, check
from nearfar._base.errors import SceneError, UnusableError
from nearfar._scene import load_trimesh, load_wavefront, quiet, threemf
from nearfar._scene.assembly import Assembled
from nearfar._scene.budget import Budget, read_file, resolver as budget_resolver
from nearfar._scene.content import UP, Content, assemble
from nearfar._scene.gltf.document import read as read_gltf
from nearfar._scene.materials import Materials


def load(
    path: str | os.PathLike[str],
    *,
    up: str = "y",
    on_invalid: str = "raise",
    scale: float | None = None,
    max_bytes: int | None = None,
    moves: bool = False,
) -> Assembled:
    """Load a file; `nearfar.Scene.load` documents the arguments. With `moves` all objects are dynamic."""
    check.choice("up", up, UP)
    check.choice("on_invalid", on_invalid, ("raise", "drop"))
    if scale is not None:
        check.positive("scale", scale)
    path = check.path("path", path)
    if path.is_dir():
        raise IsADirectoryError(errno.EISDIR, _folder(path), os.fspath(path))
    most = None if max_bytes is None else check.integer("max_bytes", max_bytes, 1, 1 << 62)
    how: dict[str, Any] = {"up": up, "on_invalid": on_invalid, "scale": scale, "moves": moves}
    return background.run(lambda: _load(path, Budget(most), **how), alone=True)


def _load(path: Path, budget: Budget, **how: Any) -> Assembled:
    label = os.fspath(path)
    with _explained(label, passed=OSError):
        data = read_file(path, budget)  # a missing file and missing permissions raise OSError
    with quiet.silence() as messages, _explained(label):
        content = _read(label, path, data, budget)
        content.notes += [message for message in dict.fromkeys(messages) if message not in content.notes]
        return assemble(content, budget=budget, **how)


def _folder(path: Path) -> str:
    if (path / "reduced.json").is_file():
        return "expected a file, got the folder of a reduced scene, which ReducedScene.load reads"
    files = sorted(item.name for item in path.iterdir() if item.suffix.lower() in _COMMON)
    return "expected a file, got a folder" + (f", which holds {', '.join(files[:3])}" if files else "")


def _read(label: str, path: Path, data: bytes, budget: Budget) -> Content:
    import trimesh

    kind = path.suffix.lower().lstrip(".")
    name = path.stem
    if kind == "gz":
        kind, name = Path(name).suffix.lower().lstrip("."), Path(name).stem
        data = budget.unpacked(data)
    if kind in _ARCHIVES:
        raise UnusableError("it is an archive, which may hold several models: unpack it and load one of them")
    if kind == "json":
        raise UnusableError(_JSON)
    if kind in _READERS and kind not in trimesh.available_formats():
        raise UnusableError(f"nearfar does not read .{kind}: {_READERS[kind]}")
    if kind not in trimesh.available_formats() or kind in _NOT_SCENES:
        raise UnusableError(f"the kind of file '{''.join(path.suffixes[-2:]) or path.name}' is not known")
    if not data:
        raise UnusableError("it is empty")
    budget.take_members(data)
    if kind == "3mf" and data.startswith(b"PK"):
        threemf.check_instances(data, budget)
    resolver, materials = budget_resolver(path, budget), Materials(budget)
    if kind in ("glb", "gltf"):
        return read_gltf(label, data, kind, resolver, materials, budget)
    if kind == "obj":
        content = load_wavefront.read(label, data, resolver, materials, budget)
    else:
        content = load_trimesh.read(label, load_trimesh.parsed(data, kind, resolver), materials)
    if len(content.nodes.objects) == 1 and content.nodes.objects[0] in (path.name, "geometry_0", "geometry"):
        content.nodes = replace(content.nodes, objects=[name])
    return content


_COMMON = {".glb", ".gltf", ".obj", ".ply", ".stl", ".off", ".3mf", ".dae"}
"""Suffixes of files that a folder is likely to be given for."""

_ARCHIVES = {"zip", "tar", "tgz", "bz2", "7z", "rar"}

_READERS = {
    "blend": "export it from Blender as glTF (.glb)",
    "fbx": "import it into Blender and export it as glTF (.glb), or convert it with FBX2glTF or Assimp",
    "3ds": "import it into Blender 4.2 or newer and export it as glTF (.glb), or convert it with Assimp",
    "max": "export it from Autodesk 3ds Max as glTF or OBJ",
    "ma": "export it from Autodesk Maya as OBJ or FBX, and FBX from Blender as glTF (.glb)",
    "mb": "export it from Autodesk Maya as OBJ or FBX, and FBX from Blender as glTF (.glb)",
    "c4d": "export it from Cinema 4D as glTF (.glb)",
    "skp": "export it from SketchUp as glTF (.glb), COLLADA (.dae) or OBJ",
    "ifc": "convert it to glTF (.glb) with IfcConvert or the Python package ifcopenshell, or with Bonsai for Blender",
    "rvt": "export it from Autodesk Revit as IFC, and convert that to glTF (.glb) with IfcConvert",
    "dwg": "export it from AutoCAD as OBJ or STL, or open it in FreeCAD",
    "3dm": "export it from Rhino as glTF (.glb) or OBJ",
    "dae": "install the Python package pycollada, with which it is read, or export it from Blender as glTF (.glb)",
    "usd": "import it into Blender and export it as glTF (.glb)",
    "usda": "import it into Blender and export it as glTF (.glb)",
    "usdc": "import it into Blender and export it as glTF (.glb)",
    "usdz": "import it into Blender and export it as glTF (.glb)",
    "abc": "import it into Blender and export it as glTF (.glb)",
    "x3d": "import it into Blender and export it as glTF (.glb)",
    "wrl": "import it into Blender or MeshLab and export it as glTF (.glb) or PLY",
    "step": "install the Python package cascadio, with which it is read, or export it from FreeCAD as glTF (.glb)",
    "stp": "install the Python package cascadio, with which it is read, or export it from FreeCAD as glTF (.glb)",
    "iges": "export it from FreeCAD as glTF (.glb) or OBJ",
    "igs": "export it from FreeCAD as glTF (.glb) or OBJ",
    "gml": "convert it with citygml-tools to CityJSON, and that with cjio to glTF (.glb)",
    "b3dm": "it is a tile of 3D Tiles: 3d-tiles-tools (b3dmToGlb) takes the glTF (.glb) out of it",
    "i3dm": "it is a tile of 3D Tiles: 3d-tiles-tools (i3dmToGlb) takes the glTF (.glb) out of it",
    "cmpt": "it is a tile of 3D Tiles: 3d-tiles-tools (cmptToGlb) takes the glTF (.glb) out of it",
    "citygml": "convert it with citygml-tools to CityJSON, and that with cjio to glTF (.glb)",
    "vrml": "import it into Blender or MeshLab and export it as glTF (.glb) or PLY",
    "geojson": "it holds outlines without heights; extrude them in Blender or QGIS and export glTF (.glb)",
    "las": "it holds points without triangles; CloudCompare or Open3D makes a mesh of them",
    "laz": "it holds points without triangles; CloudCompare or Open3D makes a mesh of them",
    "e57": "it holds points without triangles; CloudCompare or Open3D makes a mesh of them",
}
"""Known formats that are not read, and the program or package that reads them."""

_JSON = "nearfar reads no scenes in .json: cjio converts CityJSON, and 3d-tiles-tools a tileset's tiles, to glTF (.glb)"

_NOT_SCENES = {"dxf", "svg", "json", "dict", "dict64", "binvox"}
"""Formats that trimesh reads but that are not scenes: drawings, voxels and trimesh's own dumps."""


@contextmanager
def _explained(label: str, *, passed: type[Exception] = SceneError) -> Iterator[None]:
    """Convert a reader's exception to a SceneError that names the file and gives the reason in one sentence."""
    try:
        yield
    except (SceneError, passed):
        raise
    except Exception as error:
        raise SceneError(f"{label}: {check.one_line(_sentence(error), _LONGEST)}") from error


def _sentence(error: Exception) -> str:
    match error:
        case UnusableError():
            return str(error)
        case ModuleNotFoundError(name=name) if name in _DETECTORS:
            return "it is damaged, or its text is in an unknown encoding"
        case ModuleNotFoundError():
            return f"reading it needs the Python package '{error.name}', which is not installed"
        case gzip.BadGzipFile() | EOFError() | zlib.error():
            return f"its compressed data is damaged ({error})"
        case OSError():
            return f"a file that it refers to cannot be read: {Path(str(error.filename or error)).name}"
        case UnicodeDecodeError():
            return f"its text is not in a known encoding ({error.reason} at byte {error.start})"
        case MemoryError():
            return "it claims more data than fits into memory"
        case RecursionError():
            return "its parts are nested too deeply"
        case KeyError():
            return f"it lacks an entry that it needs: {error.args[0] if error.args else 'unknown'}"
        case AssertionError():
            return "lengths or offsets in it contradict each other" + (f" ({error})" if str(error) else "")
        case IndexError():
            return "it refers to something that it does not hold"
        case zipfile.BadZipFile():
            return f"its archive is damaged ({_first_line(error)})"
        case ValueError() | RuntimeError():  # raised by trimesh for unknown versions and formats
            return _reader_sentence(_first_line(error))
        case AttributeError() | TypeError():
            return "an entry of it has another type than it should"
        case _:
            return "it is not well-formed"


def _reader_sentence(reason: str) -> str:
    """Sentence for a reason that a reader gives; those of Python and NumPy speak of code, not of the file."""
    for pattern, sentence in _REASONS:
        if match := pattern.search(reason):
            reason = sentence.format(*(group for group in match.groups() if group))
            break
    return f"it cannot be read: {reason or 'no reason given'}"


def _first_line(error: Exception) -> str:
    return next(iter(str(error).splitlines()), "")


_LONGEST = 300
"""Greatest number of characters of a reason, which may repeat what stands in the file."""

_DETECTORS = ("chardet", "charset_normalizer")
"""Packages with which trimesh would guess the encoding of a text that is not UTF-8."""

_REASONS = (
    (
        re.compile(r"could not convert string to \w+: (.+)|invalid literal for [^:]*: (.+)"),
        "{} stands where a number belongs",
    ),
    (
        re.compile(r"reshape array|array element|to unpack|unmatched data|operands could not|inhomogeneous|dimensions"),
        "a row of it has too few or too many numbers",
    ),
    (re.compile(r"negative seek|buffer is smaller|buffer size|beyond the end"), "it is cut off"),
    (re.compile(r"no field of name (\w+)"), "it lacks an entry that it needs: {}"),
)
"""Reasons of Python and NumPy, and what they say of a file."""
