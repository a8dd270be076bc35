"""Seconds and memory of the stages of an export, in a separate process; prints them as JSON."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness.process import run_module
from benchmarks.harness.report import folder_or_temporary
from benchmarks.harness.timing import Result, resident, timed
from benchmarks.stream._near import Place, places, whole_textures
from nearfar import _core
from nearfar.stream import _store
from nearfar.stream._encode import Geometry, encode_maps, scale_of
from nearfar.stream._notes import findings_of
from nearfar.stream._radii import PUBLISHED
from nearfar.stream._store import Files

FACE_SIZE = 1024


def measure_in_process(place: int, *, instanced: bool, samples: int, quick: bool) -> dict[str, Any]:
    """Run this file for a place in a new process."""
    return dict(run_module("benchmarks.stream._stages", *map(int, (place, instanced, samples, quick))))


def stages(place: Place, *, instanced: bool, samples: int, folder: Path) -> dict[str, Any]:
    """Run an export, step by step like `nf.stream.export`; and one map alone, for comparison."""
    wall, cpu = dict[str, float](), dict[str, float]()

    def watch(name: str, job: Callable[[], Result]) -> Result:
        result, spent = timed(job)
        wall[name], cpu[name] = spent.wall, spent.cpu
        return result

    before = resident()
    scene = watch("make the scene", lambda: place.make(instanced=instanced))
    loaded = resident()
    watch("search tree", lambda: nf.cast_rays(scene, np.array([place.center]), np.array([[0.0, -1.0, 0.0]])))
    ready = resident()
    rings = watch("assign", lambda: nf.stream.assign(scene, center=place.center, radii=PUBLISHED))
    watch("findings", lambda: findings_of(rings))
    maps = watch("bake", lambda: nf.stream.bake_maps(rings, face_size=FACE_SIZE, samples=samples))
    files = Files()
    watch("encode maps", lambda: list(encode_maps(maps, files, quality=90, scale=scale_of(maps, 2.0**-11))))

    def geometry() -> None:
        encoder = Geometry(rings, files, whole_textures(scene, 90), nf.stream.ExportSettings())
        list(encoder.groups("ring")), encoder.moving()

    watch("encode geometry", geometry)
    watch("write", lambda: _store.write(folder / "bundle", {**files.content, _store.MANIFEST: b"{}"}))
    peak = resident("VmHWM")
    settings: dict[str, Any] = {"center": rings.center, "size": FACE_SIZE, "samples": samples}
    settings |= {"range": True, "object_id": False}
    bake = partial(_core.bake_rings, rings.scene._core, settings, count=0, report=lambda *_: None)
    # Map 0 as a separate map, with colour and range.
    watch("one map", lambda: bake(rings=rings.codes()))
    return {
        "wall": wall,
        "cpu": cpu,
        "rays": maps.rays / (6 * FACE_SIZE**2 * (samples + (samples > 1))),
        "triangles": scene.triangle_count,
        "arrays": arrays(scene),
        "loaded": loaded - before,
        "with tree": ready - before,
        "peak": peak - before,
    }


def arrays(scene: nf.Scene) -> int:
    """Bytes of a scene's arrays; meshes of equal counts and bounds count as one shared by several placements."""
    parts = _core.scene_parts(scene._core)
    meshes = {(mesh.vertex_count, mesh.face_count, str(mesh.bounds())): mesh for mesh in parts["meshes"]}
    flat = [*parts.values(), *parts["textures"]]
    flat += [value for mesh in meshes.values() for value in _core.mesh_parts(mesh).values()]
    return sum(value.nbytes for value in flat if isinstance(value, np.ndarray))


WORK = ("search tree", "assign", "findings", "bake", "encode maps", "encode geometry", "write")
"""Stages of an export of a scene that was just loaded."""


def row(name: str, stages: dict[str, Any], export_seconds: float) -> list[object]:
    """CPU seconds of the stages, their sum in CPU and wall seconds, and rays and CPU of all maps relative to one."""
    wall, cpu = stages["wall"], stages["cpu"]
    sums = (sum(spent[stage] for stage in WORK) for spent in (cpu, wall))
    return [name, *(cpu[stage] for stage in WORK), *sums, export_seconds, stages["rays"], cpu["bake"] / cpu["one map"]]


def memory_row(name: str, stages: dict[str, Any]) -> list[object]:
    """GB, and the peak as a multiple of the scene with its search tree."""
    sizes = [stages[key] / 1e9 for key in ("arrays", "loaded", "with tree", "peak")]
    return [name, stages["triangles"], *sizes, sizes[3] / sizes[2]]


def main() -> None:
    place, instanced, samples, quick = map(int, sys.argv[1:])
    with folder_or_temporary() as folder:
        figures = stages(places(bool(quick))[place], instanced=bool(instanced), samples=samples, folder=folder)
    print(json.dumps(figures))


if __name__ == "__main__":
    main()
