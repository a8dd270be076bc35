"""Loading of files compared with trimesh, pygltflib with NumPy, and Open3D: seconds, and growth of memory.

Each reader loads each file in a separate process, with the file in the system's cache. Times are the best of several.
Memory is the growth of the process's peak at its first load; it is given as a multiple of nearfar's scene: its
vertices, faces, normals, texture coordinates, colours, numbers of materials and objects, and textures.
"""

from __future__ import annotations

import gzip
import json
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness.timing import machine, table
from benchmarks.harness.tokyo import whole
from benchmarks.scene._reader import READERS
from nearfar._base import data, glb
from nearfar._scene import glb as scene_glb
from tests.support.exporters import Case
from tests.support.exporters_run import EXPORTERS
from tests.support.reader_cases import no_exporters

FILES = (
    "objects/gltf/Duck.glb",
    "objects/gltf/FlightHelmet/FlightHelmet.gltf",
    "interior/garage/garage.gltf",
    "city/manhattan_deckgl/manhattan_core.glb",
    "city/tokyo23/tokyo_core_lod1.glb",
    "objects/armadillo.obj",
    "objects/bun_zipper.ply",
    "objects/dragon/dragon_vrip_res2.ply.gz",
)
PACKED = {"quantised": (), "meshopt": ("-c",)}
"""Settings of gltfpack for variants of a city."""

SECONDS = 900
"""Timeout of a reader, seconds."""
SMALL = 20e6
"""Bytes of a scene below which the growth of memory depends more on the reader's code than on the file."""


@dataclass(frozen=True)
class Reading:
    """One reader's result for one file."""

    seconds: float
    growth: int
    """Growth of memory, bytes."""
    size: int
    """Bytes of the arrays; 0 for other readers than nearfar."""


def main() -> None:
    print(machine(), "\n")
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for name, path in files(Path(folder)):
            found = {reader: _measured(reader, path) for reader in READERS}
            rows.append([name, f"{path.stat().st_size / 1e6:.1f}", *_row(found)])
            print(" | ".join(rows[-1]), file=sys.stderr, flush=True)
            if path.is_relative_to(folder):
                path.unlink()
    header = [
        "file",
        "MB",
        "nearfar, s",
        "trimesh, s",
        "pygltflib, s",
        "Open3D, s",
        "trimesh / nearfar",
        "memory / scene",
    ]
    print(table("Loading", [*header, "trimesh's memory"], rows))


def _row(found: dict[str, Reading | None]) -> list[str]:
    ours, peer = found["nearfar"], found["trimesh"]
    assert ours is not None
    ratio = "–" if peer is None else f"{peer.seconds / ours.seconds:.1f}"
    memory = ["–" if r is None or ours.size < SMALL else f"{r.growth / ours.size:.2f}" for r in (ours, peer)]
    return [*("–" if reading is None else f"{reading.seconds:.3f}" for reading in found.values()), ratio, *memory]


# files ----------------------------------------------------------------------------------------------------------------
def files(folder: Path) -> Iterator[tuple[str, Path]]:
    """Yield names and paths of files, made one after the other."""
    for name in FILES:
        path = data.find(name)
        if path is None:
            print(f"{name} is not there\n")
        elif path.suffix == ".gz":
            unpacked = folder / path.stem
            unpacked.write_bytes(gzip.decompress(path.read_bytes()))
            yield unpacked.name, unpacked
        else:
            yield path.name, path
    yield from _meshes(folder)
    yield from _cities(folder)
    arrays = whole()
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
    tokyo = "Tokyo"
    for name, options in PACKED.items():
        EXPORTERS["gltfpack"]([Case(tokyo, name, "packed.glb", options)], folder)
        yield f"tokyo_core_lod1, {name} by gltfpack", folder / "packed.glb"
    EXPORTERS["glTF-Transform"]([Case("FlightHelmet", "draco", "packed.glb", [["draco", {}]])], folder)
    yield "FlightHelmet, Draco by glTF-Transform", folder / "packed.glb"


def _one_mesh(path: Path, vertices: Any, faces: Any) -> Path:
    writer = glb.Writer()
    corners = faces.reshape(-1)
    numbers = [writer.accessor(writer.view(rows), rows, 0) for rows in (vertices, corners)]
    primitive = {"attributes": {"POSITION": numbers[0]}, "indices": numbers[1]}
    path.write_bytes(
        writer.encode(
            {
                "asset": {"version": "2.0"},
                "scenes": [{"nodes": [0]}],
                "nodes": [{"mesh": 0, "name": "Tokyo"}],
                "meshes": [{"primitives": [primitive]}],
            }
        )
    )
    return path


def _measured(reader: str, path: Path) -> Reading | None:
    """Measure a reader in a separate process; None if it does not read the file."""
    if reader == "pygltflib" and path.suffix not in (".glb", ".gltf"):
        return None
    command = [sys.executable, "-m", "benchmarks.scene._reader", reader, str(path)]
    process = subprocess.run(command, capture_output=True, text=True, timeout=SECONDS, check=False)
    if process.returncode:
        reason = process.stderr.strip().splitlines()[-1:] or [f"status {process.returncode}"]
        print(f"{reader} does not read {path.name}: {reason[0]}\n")
        return None
    return Reading(**json.loads(process.stdout.splitlines()[-1]))


if __name__ == "__main__":
    main()
