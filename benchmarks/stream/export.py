"""Time and size of the geometry's files against plain arrays, zlib, and gltfpack if it is on the path."""

from __future__ import annotations

import zlib
from functools import partial
from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness import scenes
from benchmarks.harness.report import folder_or_temporary, start, table
from benchmarks.harness.timing import Timing, best, timed
from benchmarks.stream._near import encode_groups, gltfpack, one_file

RADII = (20.0, 60.0, 200.0)


def sums_of(statistics: list[dict[str, Any]]) -> dict[str, Any]:
    """Sums of the statistics of files, and their greatest error."""
    sums = {name: sum(part[name] for part in statistics) for name in ("raw_bytes", "triangles", "vertices", "dropped")}
    sums |= {f"{kind} bytes": sum(part["bytes"][kind] for part in statistics) for kind in statistics[0]["bytes"]}
    return sums | {"position_error": max(part["position_error"] for part in statistics)}


def time_gltfpack(glb: bytes) -> tuple[Timing, int] | None:
    """Time and bytes of gltfpack's compression of a file whose positions are quantised to the same step as ours."""
    with folder_or_temporary() as folder:
        (folder / "given.glb").write_bytes(glb)
        output, spent = timed(gltfpack, folder, "given.glb", "-c", "-vpf")
        return None if output is None else (Timing(spent.wall, spent.wall), output.stat().st_size)


def sizes(name: str, scene: nf.Scene) -> str:
    groups = nf.stream.assign(scene, center=np.mean(scene.bounds, axis=0), radii=RADII).codes()
    encode = partial(encode_groups, scene, groups, range(len(RADII) + 2))
    (files, statistics), (plain, _) = encode(compressed=True), encode(compressed=False)
    sums = sums_of(statistics)
    raw, triangles = sums["raw_bytes"], sums["triangles"]

    def row(label: str, time: Timing | None, size: int) -> list[object]:
        times = [None] * 3 if time is None else [time.ms, time.cpu_ms, raw / time.cpu / 1e6]
        return [label, *times, size / 1e6, size / triangles]

    rows = [
        row(label, best(partial(encode, compressed=compressed), repeat=5), sum(map(len, made)))
        for label, compressed, made in (("plain", False, plain), ("meshopt", True, files))
    ]
    deflated = best(lambda: [zlib.compress(file) for file in plain], repeat=1)
    squeezed = (sum(len(zlib.compress(file)) for file in made) for made in (plain, files))
    rows += [row("plain, then zlib", deflated, next(squeezed)), row("meshopt, then zlib", None, next(squeezed))]
    if (peer := time_gltfpack(one_file(scene))) is not None:
        rows.append(row("gltfpack -c -vpf, one file", *peer))
    kinds = ", ".join(f"{kind} {sums[kind] / triangles:.2f}" for kind in sums if kind.endswith(" bytes"))
    note = (
        f"{triangles:,} triangles and {sums['vertices']:,} vertices stored, {scene.triangle_count:,} in the scene, "
        f"{sums['dropped']:,} without area; error {sums['position_error'] * 1e3:.2f} mm. Bytes a triangle: {kinds}.\n"
    )
    header = " | wall ms {:.0f} | CPU ms {:.0f} | raw MB/s a core {:.0f} | MB {:.2f} | bytes a triangle {:.2f}"
    return f"{table(name, header, rows)}\n{note}"


def main() -> None:
    start(__doc__)
    city = nf.datasets.city(blocks=3, detail=2)
    print(sizes("City of 3 × 3 blocks", city))
    corners = city.triangles().reshape(-1, 3) + np.asarray(city.origin, np.float32)
    print(sizes("The same city as one mesh", nf.Scene.from_arrays(corners, np.arange(len(corners)).reshape(-1, 3))))
    for name, scene in scenes.present("FlightHelmet", "Tokyo core"):
        print(sizes(name, scene))


if __name__ == "__main__":
    main()
