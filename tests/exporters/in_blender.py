"""Exports each job of a JSON file from Blender: blender -b --python in_blender.py -- JOBS.

A job is {"from": PATH, "to": PATH, "settings": {…}}; the settings are those of Blender's own export operator.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

import bpy
import numpy as np

# Debian's NumPy 1.24 lacks the names that Blender 3.4's glTF add-on uses.
setattr(np, "bool", bool)  # noqa: B010


def main() -> None:
    for job in json.loads(Path(sys.argv[sys.argv.index("--") + 1]).read_text()):
        bpy.ops.wm.read_factory_settings(use_empty=True)
        _read(Path(job["from"]))
        _write(Path(job["to"]), job["settings"])


def _read(path: Path) -> None:
    readers = {
        ".glb": bpy.ops.import_scene.gltf,
        ".gltf": bpy.ops.import_scene.gltf,
        ".obj": bpy.ops.wm.obj_import,
        ".ply": bpy.ops.import_mesh.ply,
    }
    readers[path.suffix](filepath=str(path))


def _write(path: Path, settings: dict[str, Any]) -> None:
    bpy.ops.object.select_all(action="SELECT")
    if path.suffix in (".glb", ".gltf"):
        kind = "GLB" if path.suffix == ".glb" else "GLTF_SEPARATE"
        bpy.ops.export_scene.gltf(filepath=str(path), export_format=kind, **settings)
    elif path.suffix == ".obj":
        bpy.ops.wm.obj_export(filepath=str(path), **settings)
    elif path.suffix == ".ply":
        bpy.ops.export_mesh.ply(filepath=str(path), **settings)
    else:
        bpy.ops.export_mesh.stl(filepath=str(path), **settings)


main()
