"""Time and size of the geometry's files against plain arrays, zlib, and gltfpack if it is on the path."""

from __future__ import annotations

import tempfile
import time
import zlib
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.timing import best, machine, table
from benchmarks.stream._near import STEP, gltfpack
from nearfar import _core
from nearfar._base import data

RADII = (20.0, 60.0, 200.0)


def exporter(scene: nf.Scene, groups: NDArray[np.uint16], textures: int, *, compressed: bool) -> _core.Export:
    """Export with URIs of images, which are never read."""
    return _core.Export(
        scene._core,
        groups,
        len(RADII) + 2,
        names=list(scene.object_names),
        images=[f"{number}.webp" for number in range(textures)],
        step=STEP,
        compressed=compressed,
    )


def encode(
    scene: nf.Scene, groups: NDArray[np.uint16], textures: int, *, compressed: bool
) -> tuple[list[bytes], dict[str, Any]]:
    """Encode all files, with shared meshes in separate buffers; return them and the sums of their statistics."""
    export = exporter(scene, groups, textures, compressed=compressed)
    shared = export.shared()
    uris: list[str | None] = [f"{number}.bin" for number in range(len(shared))]
    files = [export.glb(group, uris=uris) for group in range(len(RADII) + 2)]
    parts = [statistics for *_, statistics in shared] + [statistics for _, statistics in files]
    sums = {name: sum(part[name] for part in parts) for name in ("raw_bytes", "triangles", "vertices", "dropped")}
    sums |= {f"{kind} bytes": sum(part["bytes"][kind] for part in parts) for kind in parts[0]["bytes"]}
    sums["position_error"] = max(part["position_error"] for part in parts)
    return [mesh for mesh, *_ in shared] + [glb for glb, _ in files], sums


def packed(glb: bytes) -> tuple[float, int] | None:
    """Seconds and bytes of gltfpack's compression of a file with the same step of positions."""
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "given.glb").write_bytes(glb)
        start = time.perf_counter()
        made = gltfpack(Path(folder), "given.glb", "-c", "-vpf")
        return None if made is None else (time.perf_counter() - start, made.stat().st_size)


def sizes(name: str, scene: nf.Scene) -> str:
    """Table of times and sizes for one scene."""
    groups = nf.stream.assign(scene, center=np.mean(scene.bounds, axis=0), radii=RADII).codes()
    textures = len(_core.scene_parts(scene._core)["textures"])
    files, sums = encode(scene, groups, textures, compressed=True)
    plain, _ = encode(scene, groups, textures, compressed=False)
    raw, triangles = sums["raw_bytes"], sums["triangles"]
    rows = []
    for label, compressed, made in (("plain", False, plain), ("meshopt", True, files)):
        timing = best(partial(encode, scene, groups, textures, compressed=compressed), repeat=5)
        size = sum(map(len, made))
        rows.append([label, *_row(timing.wall, timing.cpu, raw, size, triangles)])
    deflated = best(lambda: [zlib.compress(file) for file in plain], repeat=1)
    size = sum(len(zlib.compress(file)) for file in plain)
    rows.append(["plain, then zlib", *_row(deflated.wall, deflated.cpu, raw, size, triangles)])
    size = sum(len(zlib.compress(file)) for file in files)
    rows.append(["meshopt, then zlib", "", "", "", f"{size / 1e6:.2f}", f"{size / triangles:.2f}"])
    peer = packed(_one_file(scene))
    if peer is not None:
        rows.append(["gltfpack -c -vpf, one file", *_row(peer[0], peer[0], raw, peer[1], triangles)])
    kinds = ", ".join(f"{kind} {sums[kind] / triangles:.2f}" for kind in sums if kind.endswith(" bytes"))
    note = (
        f"{triangles:,} triangles and {sums['vertices']:,} vertices stored, {scene.triangle_count:,} in the scene, "
        f"{sums['dropped']:,} without area; error {sums['position_error'] * 1e3:.2f} mm. Bytes a triangle: {kinds}.\n"
    )
    header = ["", "wall ms", "CPU ms", "raw MB/s a core", "MB", "bytes a triangle"]
    return table(name, header, rows) + "\n" + note


def _row(wall: float, cpu: float, raw: float, size: int, triangles: int) -> list[str]:
    speed = raw / cpu / 1e6
    return [f"{wall * 1e3:.0f}", f"{cpu * 1e3:.0f}", f"{speed:.0f}", f"{size / 1e6:.2f}", f"{size / triangles:.2f}"]


def _one_file(scene: nf.Scene) -> bytes:
    """The whole scene as one plain file without images."""
    textures = len(_core.scene_parts(scene._core)["textures"])
    groups = np.zeros(len(scene.object_names) + 1, np.uint16)
    export = _core.Export(scene._core, groups, 1, names=[], images=[None] * textures, step=STEP, compressed=False)
    return export.glb(0, uris=[None] * len(export.shared()))[0]


def main() -> None:
    print(machine())
    city = nf.datasets.city(blocks=3, detail=2)
    print(sizes("City of 3 × 3 blocks", city))
    corners = city.triangles().reshape(-1, 3) + np.asarray(city.origin, np.float32)
    print(sizes("The same city as one mesh", nf.Scene.from_arrays(corners, np.arange(len(corners)).reshape(-1, 3))))
    for name, path in (
        ("FlightHelmet", "objects/gltf/FlightHelmet/FlightHelmet.gltf"),
        ("Tokyo core", "city/tokyo23/tokyo_core_lod1.glb"),
    ):
        file = data.find(path)
        if file is not None:
            print(sizes(name, nf.Scene.load(file)))


if __name__ == "__main__":
    main()
