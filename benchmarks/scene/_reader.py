"""One reader of the benchmark `files` in a separate process: python -m benchmarks.scene._reader READER FILE."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness.report import folder_or_temporary
from benchmarks.harness.timing import ahead_of_others, forget_peak, resident, timed
from nearfar import _core
from nearfar._scene.gltf.buffers import COMPONENTS, WIDTHS

MAX_SECONDS = 3.0
"""A load starts only if the previous ones took less than this together, seconds."""


def _trimesh(path: Path) -> Any:
    """Load by trimesh, with the images of base colours, which it decodes on access."""
    import trimesh

    loaded = trimesh.load_scene(path, process=False)
    materials = [getattr(mesh.visual, "material", None) for mesh in loaded.geometry.values()]
    images = [getattr(material, "baseColorTexture", getattr(material, "image", None)) for material in materials]
    for image in {id(image): image for image in images if image is not None}.values():
        np.asarray(image.convert("RGBA"))
    return loaded


def _pygltflib(path: Path) -> Any:
    """Load the arrays of all primitives as views of the file's bytes, without transforms, materials and images."""
    from pygltflib import GLTF2

    document = GLTF2().load(str(path))
    blob = document.binary_blob()
    blobs = [document.get_data_from_buffer_uri(buffer.uri) if buffer.uri else blob for buffer in document.buffers]

    def array(number: int) -> Any:
        accessor = document.accessors[number]
        view = document.bufferViews[accessor.bufferView]
        kind, width = np.dtype(COMPONENTS[accessor.componentType]), WIDTHS[accessor.type]
        start = (view.byteOffset or 0) + (accessor.byteOffset or 0)
        step = view.byteStride or kind.itemsize * width
        return np.ndarray((accessor.count, width), kind, blobs[view.buffer], start, (step, kind.itemsize))

    return [
        [array(number) for number in (*vars(primitive.attributes).values(), primitive.indices) if number is not None]
        for mesh in document.meshes
        for primitive in mesh.primitives
    ]


def _open3d(path: Path) -> Any:
    import open3d

    open3d.utility.set_verbosity_level(open3d.utility.VerbosityLevel.Error)
    if path.suffix in (".glb", ".gltf"):
        model = open3d.io.read_triangle_model(str(path))
        if not model.meshes:
            raise ValueError("nothing was read")
        return model
    return open3d.io.read_triangle_mesh(str(path))


READERS: dict[str, Callable[[Path], Any]] = {
    "nearfar": nf.Scene.load, "trimesh": _trimesh, "pygltflib": _pygltflib, "Open3D": _open3d,
}  # fmt: skip


def child(reader: str, path: Path) -> None:
    """Load a file several times and print the times and memory."""
    read = READERS[reader]
    _warm(read, path.suffix)
    forget_peak()
    before = resident()
    seconds: list[float] = []
    loaded = None
    with ahead_of_others():
        while not seconds or (len(seconds) < 5 and sum(seconds) < MAX_SECONDS):
            loaded = None
            loaded, spent = timed(read, path)
            seconds.append(spent.wall)
            if len(seconds) == 1:
                growth = resident("VmHWM") - before
    print(json.dumps({"seconds": min(seconds), "growth": growth, "size": scene_size(loaded)}))


def _warm(read: Callable[[Path], Any], suffix: str) -> None:
    """Load a triangle, so that modules are imported before memory is measured."""
    import trimesh

    with folder_or_temporary() as folder:
        path = folder / f"triangle{suffix}"
        mesh = trimesh.Trimesh(np.eye(3), [[0, 1, 2]], process=False)
        written = mesh.export(None if suffix == ".gltf" else path, file_type=suffix[1:])
        if suffix == ".gltf":
            for name, content in written.items():
                (folder / name.replace("model.gltf", path.name)).write_bytes(content)
        read(path)


def scene_size(scene: Any) -> int:
    """Bytes of the arrays of a scene of nearfar, and 0 for others."""
    if not isinstance(scene, nf.Scene):
        return 0
    parts = _core.scene_parts(scene._core)
    meshes = {id(mesh): mesh for mesh in parts["meshes"]}.values()
    arrays = [array for mesh in meshes for array in _core.mesh_parts(mesh).values()]
    return sum(array.nbytes for array in [*arrays, *parts["textures"]] if isinstance(array, np.ndarray))


if __name__ == "__main__":
    child(sys.argv[1], Path(sys.argv[2]))
