"""Bytes shared by the regions of one bundle, and the time and memory of an export with several centres.

python -m benchmarks.stream.regions [--quick]
"""

from __future__ import annotations

import argparse
import resource
import tempfile
import time
from pathlib import Path

import nearfar as nf
from benchmarks.harness.timing import machine, table
from nearfar.stream._manifest import names_of
from nearfar.stream._radii import PUBLISHED

EYE_HEIGHT = 1.7
DISTANCES = (5.0, 10.0, 20.0, 80.0)
"""Metres between two centres along the street."""


def files_of(region: nf.stream.Bundle) -> tuple[set[str], set[str]]:
    """Files of a region's geometry with its parts, and files of its maps."""
    geometry: set[str] = set()
    maps: set[str] = set()
    for ring in region._rings:
        geometry |= {*names_of(ring["geometry"]), *ring["parts"]}
        maps |= {*names_of(ring["map"]["color"]), *names_of(ring["map"].get("range"))}
    return geometry, maps


def size(bundle: nf.stream.Bundle, names: set[str]) -> int:
    return sum(bundle._manifest["files"][name]["bytes"] for name in names)


def row(scene: nf.Scene, centers: list[tuple[float, float, float]], face_size: int) -> list[str]:
    """Bytes of the first region, and bytes added by the last one."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "bundle"
        start = time.perf_counter()
        bundle = nf.stream.export(scene, path, center=centers, radii=PUBLISHED, face_size=face_size)
        seconds = time.perf_counter() - start
        manifest = (path / "manifest.json").stat().st_size
    regions = [files_of(bundle.region(number)) for number in range(len(centers))]
    before = [set().union(*(region[kind] for region in regions[:-1])) for kind in (0, 1)]
    last = [size(bundle, regions[-1][kind]) for kind in (0, 1)]
    new = [size(bundle, regions[-1][kind] - before[kind]) for kind in (0, 1)]
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2**20
    counts = [str(len(centers)), str(len(bundle.files)), *(f"{value / 1e3:,.0f}" for value in (*last, *new))]
    return [*counts, f"{bundle.nbytes / 1e6:.2f}", f"{manifest / 1e3:.0f}", f"{seconds:.1f}", f"{peak:.2f}"]


def main() -> None:
    parse = argparse.ArgumentParser(description=__doc__)
    parse.add_argument("--quick", action="store_true", help="a smaller city and smaller maps")
    quick = parse.parse_args().quick
    scene = nf.datasets.city(blocks=3, detail=1) if quick else nf.datasets.city(blocks=9, detail=3)
    face_size = 256 if quick else 1024
    (x, _, z), _ = nf.datasets.street_view()
    print(machine())
    print(f"{scene.triangle_count:,} triangles")
    rows = [["–", *row(scene, [(x, EYE_HEIGHT, z)], face_size)]]
    for distance in DISTANCES:
        centers = [(x, EYE_HEIGHT, z), (x, EYE_HEIGHT, z - distance)]
        rows.append([f"{distance:g}", *row(scene, centers, face_size)])
    many = [(x, EYE_HEIGHT, z - DISTANCES[0] * number) for number in range(9)]
    rows.append([f"{DISTANCES[0]:g}", *row(scene, many, face_size)])
    header = ["metres apart", "centres", "files", "last: geometry, kB", "maps", "new of it: geometry", "maps"]
    print(table("regions", [*header, "all, MB", "manifest, kB", "seconds", "peak so far, GB"], rows))


if __name__ == "__main__":
    main()
