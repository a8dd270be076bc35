"""Seconds and memory of the stages of an export, in a separate process; prints them as JSON.

python -m benchmarks.stream._stages PLACE INSTANCED SAMPLES QUICK
"""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
import psutil

import nearfar as nf
from benchmarks.stream._near import Place, places, whole_textures
from nearfar import _core
from nearfar.stream import _store
from nearfar.stream._encode import Files, Geometry, encode_maps, scale_of
from nearfar.stream._notes import findings_of
from nearfar.stream._radii import PUBLISHED

Result = TypeVar("Result")
FACE_SIZE = 1024


def measured(place: int, *, instanced: bool, samples: int, quick: bool) -> dict[str, Any]:
    """Run this file for a place in a new process."""
    numbers = [str(int(value)) for value in (place, instanced, samples, quick)]
    command = [sys.executable, "-m", "benchmarks.stream._stages", *numbers]
    found: dict[str, Any] = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
    return found


class Watch:
    """Wall and CPU seconds of named jobs."""

    def __init__(self) -> None:
        self.wall: dict[str, float] = {}
        self.cpu: dict[str, float] = {}

    def __call__(self, name: str, job: Callable[[], Result]) -> Result:
        wall, cpu = time.perf_counter(), time.process_time()
        result = job()
        self.wall[name], self.cpu[name] = time.perf_counter() - wall, time.process_time() - cpu
        return result


def stages(place: Place, *, instanced: bool, samples: int, folder: Path) -> dict[str, Any]:
    """Run an export, step by step like `nf.stream.export`; and one map alone, for comparison."""
    watch = Watch()
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
    peak = most_resident()
    watch("one map", lambda: one_map(rings, samples))
    return {
        "wall": watch.wall,
        "cpu": watch.cpu,
        "rays": maps.rays / (6 * FACE_SIZE**2 * (samples + (samples > 1))),
        "triangles": scene.triangle_count,
        "arrays": arrays(scene),
        "loaded": loaded - before,
        "with tree": ready - before,
        "peak": peak - before,
    }


def one_map(rings: nf.stream.Rings, samples: int) -> None:
    """Bake map 0 as a separate map, with colour and range."""
    settings: dict[str, Any] = {"center": rings.center, "size": FACE_SIZE, "samples": samples, "rings": rings.codes()}
    _core.bake_rings(rings.scene._core, **settings, range=True, object_id=False, count=0, report=lambda *_: None)


def resident() -> int:
    """Resident memory of this process, bytes."""
    return int(psutil.Process().memory_info().rss)


def most_resident() -> int:
    """Peak memory of this process, bytes; `getrusage` would include its parent's, too."""
    status = Path("/proc/self/status").read_text()
    return 1024 * int(next(line.split()[1] for line in status.splitlines() if line.startswith("VmHWM")))


def arrays(scene: nf.Scene) -> int:
    """Bytes of a scene's arrays; meshes of equal counts and bounds count as one shared by several placements."""
    parts = _core.scene_parts(scene._core)
    meshes = {(mesh.vertex_count, mesh.face_count, str(mesh.bounds())): mesh for mesh in parts["meshes"]}
    flat = [*parts.values(), *parts["textures"]]
    flat += [value for mesh in meshes.values() for value in _core.mesh_parts(mesh).values()]
    return sum(value.nbytes for value in flat if isinstance(value, np.ndarray))


WORK = ("search tree", "assign", "findings", "bake", "encode maps", "encode geometry", "write")
"""Stages of an export of a scene that was just loaded."""


def row(name: str, found: dict[str, Any], whole: float) -> list[str]:
    """CPU seconds of the stages, their sum in CPU and wall seconds, and rays and CPU of all maps relative to one."""
    wall, cpu = found["wall"], found["cpu"]
    return [
        name,
        *(f"{cpu[stage]:.2f}" for stage in WORK),
        f"{sum(cpu[stage] for stage in WORK):.1f}",
        f"{sum(wall[stage] for stage in WORK):.1f}",
        f"{whole:.1f}",
        f"{found['rays']:.2f}",
        f"{cpu['bake'] / cpu['one map']:.2f}",
    ]


def memory_row(name: str, found: dict[str, Any]) -> list[str]:
    """GB, and the peak as a multiple of the scene with its search tree."""
    sizes = [found[key] / 1e9 for key in ("arrays", "loaded", "with tree", "peak")]
    return [name, f"{found['triangles']:,}", *(f"{size:.2f}" for size in sizes), f"{sizes[3] / sizes[2]:.2f}"]


def main() -> None:
    place, instanced, samples, quick = map(int, sys.argv[1:])
    with tempfile.TemporaryDirectory() as folder:
        chosen = places(bool(quick))[place]
        found = stages(chosen, instanced=bool(instanced), samples=samples, folder=Path(folder))
    print(json.dumps(found))


if __name__ == "__main__":
    main()
