"""Loading of files compared with trimesh, pygltflib with NumPy, and Open3D: seconds, and growth of memory.

Each reader loads each file in a separate process, with the file in the system's cache. Times are the best of several
loads. Memory is the growth of the process's peak at its first load, as a multiple of the arrays of nearfar's scene:
vertices, faces, normals, texture coordinates, colours, numbers of materials and objects, and textures.
"""

from __future__ import annotations

import gzip
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness import scenes
from benchmarks.harness.process import run_module
from benchmarks.harness.report import folder_or_temporary, start, table
from benchmarks.harness.tokyo import load_arrays
from benchmarks.scene._reader import READERS
from nearfar._base import data, glb
from nearfar._scene import glb as scene_glb
from tests.support.exporters import Case
from tests.support.exporters_run import EXPORTERS
from tests.support.reader_cases import no_exporters

FILES = ("Duck", "FlightHelmet", "garage", "Manhattan core", "Tokyo core", "armadillo", "bunny")
DRAGON = "objects/dragon/dragon_vrip_res2.ply.gz"
PACKED = {"quantised": (), "meshopt": ("-c",)}
"""Settings of gltfpack for variants of a city."""

SECONDS = 900
"""Timeout of a reader, seconds."""
LEAST_SIZE = 20e6
"""Least bytes of a scene for a comparison of memory: for smaller files it depends more on the reader's code."""


Reading = dict[str, float]
"""Seconds of one reader for one file, growth of memory in bytes, and size in bytes of nearfar's arrays, otherwise 0."""


def main() -> None:
    start(__doc__)
    rows = []
    with folder_or_temporary() as folder:
        for name, path in files(folder):
            readings = {reader: _measure(reader, path) for reader in READERS}
            rows.append([name, path.stat().st_size / 1e6, *_row(readings)])
            print(rows[-1], file=sys.stderr, flush=True)
            if path.is_relative_to(folder):
                path.unlink()
    times = (f"{reader}, s {{:.3f}}" for reader in READERS)
    columns = ("trimesh / nearfar {:.1f}", "memory / scene {:.2f}", "trimesh's memory {:.2f}")
    print(table("Loading", ["file", "MB {:.1f}", *times, *columns], rows))


def _row(readings: dict[str, Reading | None]) -> list[object]:
    ours, peer = readings["nearfar"], readings["trimesh"]
    assert ours is not None
    ratio = "–" if peer is None else peer["seconds"] / ours["seconds"]
    memory = ["–" if r is None or ours["size"] < LEAST_SIZE else r["growth"] / ours["size"] for r in (ours, peer)]
    return [*("–" if reading is None else reading["seconds"] for reading in readings.values()), ratio, *memory]


# files ----------------------------------------------------------------------------------------------------------------
def files(folder: Path) -> Iterator[tuple[str, Path]]:
    """Yield names and paths of files, made one after the other."""
    for name in FILES:
        path = scenes.path_of(name)
        if path is None:
            print(f"{name} is not there\n")
        else:
            yield path.name, path
    if (packed := data.find(DRAGON)) is not None:
        unpacked = folder / packed.stem
        unpacked.write_bytes(gzip.decompress(packed.read_bytes()))
        yield unpacked.name, unpacked
    yield from _meshes(folder)
    yield from _cities(folder)
    arrays = load_arrays()
    if arrays is not None:
        yield "whole of Tokyo, one mesh, GLB", _one_mesh(folder / "tokyo.glb", *arrays)


def _meshes(folder: Path) -> Iterator[tuple[str, Path]]:
    """Yield a million triangles as STL, PLY and OBJ."""
    import trimesh

    scene = nf.datasets.city(blocks=5)
    corners = scene.triangles()
    mesh = trimesh.Trimesh(corners.reshape(-1, 3), np.arange(3 * len(corners)).reshape(-1, 3), process=False)
    for kind in ("stl", "ply", "obj"):
        path = folder / f"city.{kind}"
        mesh.export(path)
        yield f"procedural city, {len(corners):,} triangles, {kind.upper()}", path


def _cities(folder: Path) -> Iterator[tuple[str, Path]]:
    """Yield procedural cities as GLB: with instances, without, and packed by other programs."""
    for instanced in (True, False):
        scene = nf.datasets.city(instanced=instanced)
        path = folder / "city.glb"
        path.write_bytes(scene_glb.encode(scene._core, scene.object_names, scene._undrawn))
        kind = "instances" if instanced else "each mesh once"
        yield f"procedural city, {scene.triangle_count:,} triangles, {kind}, GLB", path
    if no_exporters():
        return
    for name, options in PACKED.items():
        EXPORTERS["gltfpack"]([Case("Tokyo", name, "packed.glb", options)], folder)
        yield f"tokyo_core_lod1, {name} by gltfpack", folder / "packed.glb"
    EXPORTERS["glTF-Transform"]([Case("FlightHelmet", "draco", "packed.glb", [["draco", {}]])], folder)
    yield "FlightHelmet, Draco by glTF-Transform", folder / "packed.glb"


def _one_mesh(path: Path, vertices: Any, faces: Any) -> Path:
    writer = glb.Writer()
    numbers = [writer.accessor(writer.view(rows), rows, 0) for rows in (vertices, faces.reshape(-1))]
    primitive = {"attributes": {"POSITION": numbers[0]}, "indices": numbers[1]}
    document: dict[str, Any] = {"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}]}
    document |= {"nodes": [{"mesh": 0, "name": "Tokyo"}], "meshes": [{"primitives": [primitive]}]}
    path.write_bytes(writer.encode(document))
    return path


def _measure(reader: str, path: Path) -> Reading | None:
    """Measure a reader in a separate process; None if it does not read the file."""
    if reader == "pygltflib" and path.suffix not in (".glb", ".gltf"):
        return None
    try:
        return dict(run_module("benchmarks.scene._reader", reader, path, seconds=SECONDS))
    except RuntimeError as error:
        print(f"{reader} does not read {path.name}: {error}\n")
        return None


if __name__ == "__main__":
    main()
