"""Time and size of saved reduced scenes, compared with trimesh's GLB of the same near part."""

from __future__ import annotations

import argparse
import tempfile
from functools import partial
from pathlib import Path

import numpy as np

import nearfar as nf
from benchmarks.harness.timing import best, machine, table
from nearfar._base import data


def scenes(quick: bool) -> list[tuple[str, nf.Scene]]:
    result = [("city", nf.datasets.city(blocks=2 if quick else 4))]
    for name, file in [
        ("tokyo_core_lod1", "city/tokyo23/tokyo_core_lod1.glb"),
        ("FlightHelmet", "objects/gltf/FlightHelmet/FlightHelmet.gltf"),
        ("garage", "interior/garage/garage.gltf"),
    ]:
        if path := data.find(file):
            result.append((name, nf.Scene.load(path)))
    return result


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="small scenes")
    quick = parser.parse_args().quick
    import trimesh

    rows = []
    for name, scene in scenes(quick):
        middle = scene.bounds.mean(axis=0)
        reach = float(np.ptp(scene.bounds, axis=0)[[0, 2]].max())
        reduced = nf.reduce(scene, center=middle, r1=reach / 8, r2=reach / 4, face_size=256, samples=1)
        with tempfile.TemporaryDirectory() as folder:
            saved = Path(folder) / "saved"
            save = best(partial(reduced.save, saved), repeat=3)
            load = best(partial(nf.ReducedScene.load, saved), repeat=3)
            near, far = ((saved / file).stat().st_size / 1e6 for file in ("near.glb", "far.exr"))
            read = best(partial(trimesh.load_scene, saved / "near.glb"), repeat=1)
            peer = trimesh.load_scene(saved / "near.glb")
            write = best(partial(peer.export, file_type="glb"), repeat=1)
            size = len(peer.export(file_type="glb")) / 1e6
        stats = reduced.stats
        rows.append(
            [
                name,
                f"{stats['drawn']:,}",
                *(f"{seconds:.2f}" for seconds in (save.wall, load.wall, read.wall, write.wall)),
                f"{near:.1f}",
                f"{size:.1f}",
                f"{far:.1f}",
            ]
        )
    columns = ["scene", "triangles", "save s", "load s", "trimesh reads near.glb s", "trimesh writes it s"]
    print(machine())
    print(table("Saved reduced scenes", [*columns, "near.glb MB", "trimesh's MB", "far.exr MB"], rows))


if __name__ == "__main__":
    main()
