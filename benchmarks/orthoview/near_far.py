"""Near–far reduction of a tree and of its world: time, pictures for a user beside the centre, and the maps.

python -m benchmarks.orthoview.near_far --tiles FOLDER --trees FOLDER
"""

from __future__ import annotations

import argparse
import tempfile
import time
from pathlib import Path

import numpy as np

import nearfar as nf
from benchmarks.harness.timing import machine, table
from benchmarks.orthoview._worlds import tokyo

R1, R2, FACE, SIZE = 30.0, 50.0, 512, (640, 480)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--tiles", help="folder of tiles of the whole of Tokyo, which nf.write_tiles wrote")
    parser.add_argument("--trees", type=Path, help="folder for the tree; by default one that is removed")
    given = parser.parse_args()
    world = tokyo(given.tiles)
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        tree = nf.orthoview.open(world.build(given.trees or Path(folder)))
        for number, camera in enumerate(world.from_ground()):
            for name, source in (("world", world.scene), ("tree", tree)):
                rows.append(_row(f"{number}, {name}", source, world.scene, camera))
    print(machine(), "\n")
    names = ["reduced in, s", "PSNR to the truth, dB", "SSIM", "triangles", "map, MB"]
    print(table("Near–far reduction", ["place, source", *names], rows))


def _row(name: str, source: nf.Scene | nf.orthoview.OrthoTree, scene: nf.Scene, camera: nf.Camera) -> list[str]:
    began = time.perf_counter()
    reduced = nf.reduce(source, center=camera.position, r1=R1, r2=R2, face_size=FACE)
    seconds = time.perf_counter() - began
    user = nf.Camera.look_at(np.add(camera.position, [3.0, 0.0, 2.0]), _ahead(camera), fov=camera.fov, size=SIZE)
    truth, made = nf.render(scene, user, samples=4), reduced.render(user, samples=4)
    facts = reduced.stats
    return [
        name,
        f"{seconds:.2f}",
        f"{nf.psnr(truth, made):.1f}",
        f"{float(nf.ssim(truth, made)):.3f}",
        f"{facts['drawn']:,}",
        f"{facts['map_bytes'] / 1e6:.1f}",
    ]


def _ahead(camera: nf.Camera) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
    height, width = camera.size[1], camera.size[0]
    origins, rays = camera.rays()
    ahead: np.ndarray[tuple[int], np.dtype[np.float64]] = origins[0, 0] + 50.0 * rays[height // 2, width // 2]
    return ahead


if __name__ == "__main__":
    main()
