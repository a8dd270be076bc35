"""Time and size of saved reduced scenes, compared with trimesh's GLB of the same near part."""

from __future__ import annotations

from functools import partial

import numpy as np

import nearfar as nf
from benchmarks.harness import scenes
from benchmarks.harness.report import folder_or_temporary, start, table
from benchmarks.harness.timing import best


def main() -> None:
    quick = start(__doc__, "--quick").quick
    import trimesh

    rows = []
    cities = [("city", nf.datasets.city(blocks=2 if quick else 4))]
    for name, scene in [*cities, *scenes.present("Tokyo core", "FlightHelmet", "garage")]:
        reach = float(np.ptp(scene.bounds, axis=0)[[0, 2]].max())
        middle = scene.bounds.mean(axis=0)
        reduced = nf.reduce(scene, center=middle, r1=reach / 8, r2=reach / 4, face_size=256, samples=1)
        with folder_or_temporary() as folder:
            saved = folder / "saved"
            save = best(partial(reduced.save, saved), repeat=3)
            load = best(partial(nf.ReducedScene.load, saved), repeat=3)
            near, far = ((saved / file).stat().st_size / 1e6 for file in ("near.glb", "far.exr"))
            read = best(partial(trimesh.load_scene, saved / "near.glb"), repeat=1)
            peer = trimesh.load_scene(saved / "near.glb")
            write = best(partial(peer.export, file_type="glb"), repeat=1)
            size = len(peer.export(file_type="glb")) / 1e6
        times = (timing.wall for timing in (save, load, read, write))
        rows.append([name, reduced.stats["drawn"], *times, near, size, far])
    header = "scene | triangles {:,} | save s {:.2f} | load s {:.2f} | trimesh reads near.glb s {:.2f}"
    header += " | trimesh writes it s {:.2f} | near.glb MB {:.1f} | trimesh's MB {:.1f} | far.exr MB {:.1f}"
    print(table("Saved reduced scenes", header, rows))


if __name__ == "__main__":
    main()
