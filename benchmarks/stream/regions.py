"""Bytes shared by the regions of one bundle, and the time and memory of an export with several centres."""

from __future__ import annotations

import nearfar as nf
from benchmarks.harness.report import folder_or_temporary, start, table
from benchmarks.harness.timing import resident, timed
from benchmarks.stream._near import large_city
from nearfar.stream._manifest import geometry_files, names_of
from nearfar.stream._radii import PUBLISHED

EYE_HEIGHT = 1.7
DISTANCES = (5.0, 10.0, 20.0, 80.0)
"""Metres between two centres along the street."""


def files_of(region: nf.stream.Bundle) -> tuple[set[str], set[str]]:
    """Files of a region's geometry with its parts, and files of its maps."""
    maps = (ring["map"].get(kind) for ring in region._rings for kind in ("color", "range"))
    return set[str]().union(*map(geometry_files, region._rings)), set[str]().union(*map(names_of, maps))


def size(bundle: nf.stream.Bundle, names: set[str]) -> int:
    return sum(bundle._manifest["files"][name]["bytes"] for name in names)


def row(scene: nf.Scene, centers: list[tuple[float, float, float]], face_size: int) -> list[float]:
    """Bytes of the first region, and bytes added by the last one."""
    with folder_or_temporary() as folder:
        path = folder / "bundle"
        bundle, spent = timed(nf.stream.export, scene, path, center=centers, radii=PUBLISHED, face_size=face_size)
        manifest = (path / "manifest.json").stat().st_size
    regions = [files_of(bundle.region(number)) for number in range(len(centers))]
    before = [set().union(*(region[kind] for region in regions[:-1])) for kind in (0, 1)]
    last = [size(bundle, regions[-1][kind]) / 1e3 for kind in (0, 1)]
    new = [size(bundle, regions[-1][kind] - before[kind]) / 1e3 for kind in (0, 1)]
    totals = bundle.nbytes / 1e6, manifest / 1e3, spent.wall, resident("VmHWM") / 2**30
    return [len(centers), len(bundle.files), *last, *new, *totals]


def main() -> None:
    quick = start(__doc__, "--quick").quick
    scene = large_city(quick)
    face_size = 256 if quick else 1024
    (x, _, z), _ = nf.datasets.street_view()
    print(f"{scene.triangle_count:,} triangles")
    rows: list[list[object]] = [["–", *row(scene, [(x, EYE_HEIGHT, z)], face_size)]]
    for distance, count in [*((distance, 2) for distance in DISTANCES), (DISTANCES[0], 9)]:
        centers = [(x, EYE_HEIGHT, z - distance * number) for number in range(count)]
        rows.append([distance, *row(scene, centers, face_size)])
    header = "metres between centres {:g} | centres | files | last: geometry, kB {:,.0f} | maps {:,.0f}"
    header += " | new of the last: geometry {:,.0f} | maps {:,.0f}"
    header += " | all, MB {:.2f} | manifest, kB {:.0f} | seconds {:.1f} | peak so far, GB {:.2f}"
    print(table("regions", header, rows))


if __name__ == "__main__":
    main()
