"""Near–far reduction of a tree and of its world: time, pictures for a user beside the centre, and the maps."""

from __future__ import annotations

import numpy as np

import nearfar as nf
from benchmarks.harness.pictures import similarity
from benchmarks.harness.report import folder_or_temporary, start, table
from benchmarks.harness.timing import timed
from benchmarks.orthoview._worlds import tokyo

R1, R2, FACE_SIZE, SIZE = 30.0, 50.0, 512, (640, 480)


def main() -> None:
    options = start(__doc__, "--tiles", "--trees")
    world, rows = tokyo(options.tiles), []
    with folder_or_temporary(options.trees) as folder:
        tree = nf.orthoview.open(world.build(folder))
        for number, camera in enumerate(world.from_ground()):
            for name, source in (("world", world.scene), ("tree", tree)):
                rows.append(_row(f"{number}, {name}", source, world.scene, camera))
    header = "place, source | reduction, s {:.2f} | PSNR, dB {:.1f} | SSIM {:.3f} | triangles {:,}"
    print(table("Near–far reduction", header + " | map, MB {:.1f}", rows))


def _row(name: str, source: nf.Scene | nf.orthoview.OrthoTree, scene: nf.Scene, camera: nf.Camera) -> list[object]:
    reduced, time = timed(nf.reduce, source, center=camera.position, r1=R1, r2=R2, face_size=FACE_SIZE)
    ahead = np.add(camera.position, 50.0 * camera.rays()[1][camera.height // 2, camera.width // 2])
    user = nf.Camera.look_at(np.add(camera.position, [3.0, 0.0, 2.0]), ahead, fov=camera.fov, size=SIZE)
    truth, picture = nf.render(scene, user, samples=4), reduced.render(user, samples=4)
    return [name, time.wall, *similarity(truth, picture), reduced.stats["drawn"], reduced.stats["map_bytes"] / 1e6]


if __name__ == "__main__":
    main()
