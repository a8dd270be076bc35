"""Times of loading and deriving scenes: tokyo_core_lod1 against trimesh, whole Tokyo against a copy of its arrays."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import trimesh
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.timing import best, machine, table
from benchmarks.harness.tokyo import with_buildings
from nearfar._base import data

FILES = ("city/tokyo23/tokyo_core_lod1.glb", "objects/gltf/FlightHelmet/FlightHelmet.gltf", "objects/armadillo.obj")


def main() -> None:
    print(machine(), "\n")
    loading()
    changing()
    if (city := with_buildings()) is not None:
        whole_city(*city)


def loading() -> None:
    """Time in seconds from the file to a drawable scene; trimesh's scene still has 12,408 meshes."""
    rows = []
    for name in FILES:
        path = data.find(name)
        if path is None:
            print(f"{name} is not there\n")
            continue
        ours = best(partial(nf.Scene.load, path), repeat=3)
        peer = best(partial(trimesh.load_scene, path, process=False), repeat=3)
        rows.append([name, f"{ours.wall:.3f}", f"{peer.wall:.3f}", f"{ours.wall / peer.wall:.2f}"])
    print(table("Loading, seconds", ["file", "nearfar", "trimesh.load_scene", "ratio"], rows))


def changing() -> None:
    """Time in milliseconds of deriving a scene from another one."""
    path = data.find(FILES[0])
    if path is None:
        return
    scene = nf.Scene.load(path)
    names = scene.object_names
    moving = scene.with_dynamic(names[:10])
    poses = {name: np.eye(4) for name in names[:10]}
    mask = np.arange(scene.triangle_count) % 2 == 0
    jobs = {
        "with_dynamic, 10 objects": lambda: scene.with_dynamic(names[:10]),
        "at, 10 objects": lambda: moving.at(poses),
        "subset, half of the objects": lambda: scene.subset(objects=names[::2]),
        "subset, half of the triangles": lambda: scene.subset(triangles=mask),
        "bounds": lambda: scene._core.bounds(),
        "triangles()": scene.triangles,
    }
    rows = [[label, f"{best(job).wall * 1e3:.3f}"] for label, job in jobs.items()]
    print(table("tokyo_core_lod1, 232,986 triangles: milliseconds", ["step", "ms"], rows))


def whole_city(*arrays: NDArray[Any]) -> None:
    """Time and memory for 29.8 M triangles, compared with a copy."""
    size = sum(array.nbytes for array in arrays)
    Path("/proc/self/clear_refs").write_text("5")
    before = _kilobytes("VmRSS")
    nf.Scene.from_arrays(*arrays)
    extra = (_kilobytes("VmHWM") - before) * 1024
    ours = best(lambda: nf.Scene.from_arrays(*arrays), repeat=3)
    copying = best(lambda: [array.copy() for array in arrays], repeat=3)
    wide = (arrays[0].astype(np.float64), arrays[1].astype(np.int64), arrays[2])
    converted = best(lambda: nf.Scene.from_arrays(*wide), repeat=1)
    rows = [
        ["from_arrays", f"{ours.wall:.2f}", f"{ours.wall / copying.wall:.2f}", f"{1 + extra / size:.2f}"],
        ["from_arrays of float64 and int64", f"{converted.wall:.2f}", f"{converted.wall / copying.wall:.2f}", ""],
        ["copying the arrays", f"{copying.wall:.2f}", "1", "2"],
    ]
    title = f"Whole of Tokyo, {len(arrays[1]):,} triangles, {size / 1e6:.0f} MB"
    print(table(title, ["step", "seconds", "ratio to copying", "peak memory / arrays"], rows))


def _kilobytes(key: str) -> int:
    lines = Path("/proc/self/status").read_text(encoding="ascii").splitlines()
    return int(next(line for line in lines if line.startswith(key)).split()[1])


if __name__ == "__main__":
    main()
